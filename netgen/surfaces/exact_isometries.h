#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "certify/numbers/exact.h"
#include "certify/numbers/isometry.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

/// Isometries in the numbers of certify/numbers: those of words (group.h has them in the kernel's), and products of
/// some generators.
namespace epsnet {

/// The crossing of a side of a rational tile, in integers.
[[nodiscard]] certify::ExactIsometry integer_crossing(const Surface& surface, SideId side);

/// The isometry of a word on rational tiles, from the coordinates of the tile where the path starts to those of the
/// tile where it ends: the product of the crossings of its letters, the first one applied first. In integers without a
/// common factor. Quasi-linear in the digits of the result.
[[nodiscard]] certify::ExactIsometry integer_isometry(const Surface& surface, const Word& word);

/// The same on any surface, scaled to determinant 1, in balls of about so many bits; ball arithmetic loses some more on
/// long words over regular tiles.
[[nodiscard]] certify::BallIsometry ball_isometry(const Surface& surface, const Word& word, slong precision);

/// An exact isometry for the certifier's arithmetic: Gaussian integers without a common integer factor.
[[nodiscard]] certify::ExactIsometry integral(const Isometry<Rational>& f);

/// The image of a rational point.
[[nodiscard]] Complex<Rational> image(const certify::ExactIsometry& f, const Complex<Rational>& z);

/// Whether two pairs are real multiples of each other: the same isometry.
[[nodiscard]] bool same_isometry(const certify::ExactIsometry& f, const certify::ExactIsometry& g);

/// Products of some generators: kept as products, evaluated approximately at once and exactly where that is asked for.
class MatrixProducts {
 public:
  using Number = Mp1024;
  /// k + 1 is element k, −(k + 1) its inverse. The first elements are the generators.
  using Id = std::int32_t;
  /// Letters of a relation: k + 1 is generator k, −(k + 1) its inverse.
  using Letters = std::vector<Id>;

  /// Values are seen from `base`: in coordinates that the translation from it to 0 has moved. Requires: positive
  /// determinants; a base in the disk.
  MatrixProducts(std::vector<certify::ExactIsometry> generators, const Complex<Rational>& base);

  [[nodiscard]] std::size_t generators() const { return generators_; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  /// x ∘ y.
  [[nodiscard]] Id product(Id x, Id y);
  /// Of determinant 1, rounded.
  [[nodiscard]] Isometry<Number> value(Id x) const;
  /// In the coordinates of the generators. Throws LimitError beyond 2^24 bits.
  [[nodiscard]] certify::ExactIsometry exact(Id x);
  /// The element as a product of generators; nothing if it has more than `most` letters.
  [[nodiscard]] std::optional<Letters> letters(Id x, std::size_t most) const;

 private:
  struct Node {
    Id left;  ///< 0 for a generator.
    Id right;
    Isometry<Number> value;
    double length;
    std::optional<certify::ExactIsometry> exact;
  };
  [[nodiscard]] static std::size_t index(Id x) { return static_cast<std::size_t>(x < 0 ? -x : x) - 1; }
  [[nodiscard]] certify::ExactIsometry known(Id x) const;

  std::size_t generators_;
  std::vector<Node> nodes_;
};

}  // namespace epsnet
