#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "certify/net/document.h"
#include "certify/numbers/exact.h"
#include "certify/numbers/field_number.h"
#include "certify/numbers/isometry.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

/// Isometries in the numbers of certify/numbers: those of words (group.h has them in the kernel's), and products of
/// some generators; and tiles over a number field.
namespace epsnet {

// Surfaces whose tiles have corners over a real number field (docs/format.md, "Surfaces over a number field").

/// The tiles, exactly.
struct FieldTiles {
  certify::SurfaceDocument::Field document;
  certify::NumberField field;
  ById<SideId, certify::Isometry<certify::FieldNumber>> crossing;

  /// Requires: a document as files have it, with an interval that isolates the root; indices of sides that there are.
  FieldTiles(certify::SurfaceDocument::Field tiles, const std::vector<Gluing>& gluing);
  /// α.
  [[nodiscard]] Mp1024 root() const;
  FieldTiles(const FieldTiles&) = delete;
  FieldTiles& operator=(const FieldTiles&) = delete;
};

/// Returns the surface of such tiles. Corners and crossings are examined as numbers of 4,096 bits: that crossings take
/// sides to their partners, and that the tiles around every vertex close up, once around; `certify` proves it. Throws
/// SurfaceError, which says what is wrong. Quasi-linear in the number of digits.
[[nodiscard]] Surface surface_over_field(certify::SurfaceDocument::Field tiles, std::vector<Gluing> gluing);

/// The isometry scaled to determinant 1, rounded to T (Mp1024, Mp4096). Requires: a positive determinant.
template <class T>
[[nodiscard]] Isometry<T> rounded_isometry(const certify::Isometry<certify::FieldNumber>& f);

/// The isometry of a word, as integer_isometry has it. Requires: a surface over a field,
/// which must outlive the numbers.
[[nodiscard]] certify::Isometry<certify::FieldNumber> field_isometry(const Surface& surface, const Word& word);

/// The coefficients of a real number.
[[nodiscard]] std::vector<mpz_class> coefficients_of(const certify::FieldNumber& x);

// Numbers as texts that NumberFieldReader reads.

/// "root(f,r)": α, for a decimal r that is nearer to α than the ends of the interval, beyond which other roots are.
[[nodiscard]] std::string root_text(const FieldTiles& tiles);

/// Real numbers of a field as polynomials in the number of this name, up to a common positive integer factor.
[[nodiscard]] std::vector<std::string> number_texts(const std::vector<certify::FieldNumber>& numbers,
                                                    const std::string& name);

// Isometries of words, exactly.

/// The crossing of a side of a rational tile, in integers.
[[nodiscard]] certify::ExactIsometry integer_crossing(const Surface& surface, SideId side);

/// The isometry of a word on rational tiles, from the coordinates of the tile where the path starts to those of the
/// tile where it ends: the product of the crossings of its letters, the first one applied first. In integers without a
/// common factor. Quasi-linear in the digits of the result.
[[nodiscard]] certify::ExactIsometry integer_isometry(const Surface& surface, const Word& word);

/// 4 cosh² of half of the length of the closed geodesic of a word on rational tiles, exactly: tr² over the determinant.
[[nodiscard]] mpq_class squared_trace(const Surface& surface, const Word& word);

/// The isometry of a word on any surface, scaled to determinant 1, in balls of about so many bits; ball arithmetic
/// loses some more on long words over regular tiles.
[[nodiscard]] certify::BallIsometry ball_isometry(const Surface& surface, const Word& word, slong precision);

/// An exact isometry for the certifier's arithmetic: Gaussian integers without a common integer factor.
[[nodiscard]] certify::ExactIsometry integral(const Isometry<Rational>& f);

/// The image of a rational point.
[[nodiscard]] Complex<Rational> image(const certify::ExactIsometry& f, const Complex<Rational>& z);

/// Whether two pairs are real multiples of each other: the same isometry.
template <class Number>
[[nodiscard]] bool same_isometry(const certify::Isometry<Number>& f, const certify::Isometry<Number>& g) {
  return certify::is_identity(certify::compose(f, certify::inverse(g)));
}

/// Products of some generators: kept as products, and evaluated approximately at once.
class MatrixProducts {
 public:
  using Number = Mp1024;
  /// k + 1 is element k, −(k + 1) its inverse. The first elements are the generators.
  using Id = std::int32_t;
  /// Letters of a relation: k + 1 is generator k, −(k + 1) its inverse.
  using Letters = std::vector<Id>;

  /// Values are seen from `base`: in coordinates that the translation from it to 0 has moved. `rounding` is how far the
  /// generators may be from what is meant, relative to their size. Requires: positive determinants; a base in the disk.
  MatrixProducts(const std::vector<Isometry<Number>>& generators, const Complex<Rational>& base, double rounding = 0);

  [[nodiscard]] std::size_t generators() const { return generators_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  /// x ∘ y.
  [[nodiscard]] Id product(Id x, Id y);
  /// Of determinant 1, rounded.
  [[nodiscard]] Isometry<Number> value(Id x) const;
  /// About how far a number of `value` may be from that of the element that is meant.
  [[nodiscard]] double error(Id x) const { return nodes_[index(x)].error; }
  /// The two elements of which x > 0 is the product; nothing for a generator.
  [[nodiscard]] std::optional<std::array<Id, 2>> factors(Id x) const {
    const Node& node = nodes_[index(x)];
    return node.left == 0 ? std::nullopt : std::optional(std::array{node.left, node.right});
  }
  /// The element as a product of generators; nothing if it has more than `most` letters.
  [[nodiscard]] std::optional<Letters> letters(Id x, std::size_t most) const;

 private:
  struct Node {
    Id left;  ///< 0 for a generator.
    Id right;
    Isometry<Number> value;
    double length;
    double error;
  };
  [[nodiscard]] static std::size_t index(Id x) { return static_cast<std::size_t>(x < 0 ? -x : x) - 1; }

  std::size_t generators_;
  std::vector<Node> nodes_;
};

/// The products exactly, in the coordinates of the generators, where that is asked for. `Number` is that of
/// certify/numbers: Gaussian or FieldNumber.
template <class Number>
class ExactProducts {
 public:
  using Id = MatrixProducts::Id;
  using Element = certify::Isometry<Number>;

  /// The products must outlive this.
  ExactProducts(const MatrixProducts& products, const std::vector<Element>& generators) : products_(products) {
    for (const Element& f : generators) known_.emplace(static_cast<Id>(known_.size() + 1), f);
  }

  /// Throws LimitError beyond 2^24 bits.
  [[nodiscard]] Element operator()(Id x) {
    // Factors come before their products.
    std::set<Id> needed;
    for (std::vector<Id> asked{std::abs(x)}; !asked.empty();) {
      const Id next = asked.back();
      asked.pop_back();
      if (known_.contains(next) || !needed.insert(next).second) continue;
      const std::array<Id, 2> factors = products_.factors(next).value();
      asked.insert(asked.end(), {std::abs(factors[0]), std::abs(factors[1])});
    }
    for (const Id product : needed) {
      const std::array<Id, 2> factors = products_.factors(product).value();
      Element f = certify::compose(known(factors[0]), known(factors[1]));
      certify::reduce(f);
      if (certify::bits(f) > kMostBits) {
        throw LimitError("a product of matrices has more than " + std::to_string(kMostBits) + " bits");
      }
      known_.emplace(product, std::move(f));
    }
    return known(x);
  }

 private:
  static constexpr std::size_t kMostBits = std::size_t{1} << 24;

  [[nodiscard]] Element known(Id x) const { return x > 0 ? known_.at(x) : certify::inverse(known_.at(-x)); }

  const MatrixProducts& products_;
  std::map<Id, Element> known_;
};

}  // namespace epsnet
