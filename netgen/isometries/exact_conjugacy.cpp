#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "certify/numbers/exact.h"
#include "kernel/plane.h"
#include "netgen/isometries/matches.h"
#include "netgen/surfaces/exact_isometries.h"
#include "netgen/surfaces/number_field.h"
#include "netgen/surfaces/triangle_group.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

/// Products of more bits than that are not computed.
constexpr std::size_t kMostBits = std::size_t{1} << 20;

/// An element (a, b) as the normal of its axis, times 2, and the number 2 Re a. Both are only known up to one factor.
template <class Real>
struct ScaledNormal {
  Real scale;
  LorentzVector<Real> normal;
};

template <class Element>
[[nodiscard]] auto scaled_normal(const Element& f) {
  using Real = decltype(twice_real(f.a));
  return ScaledNormal<Real>{twice_real(f.a),
                            {mpz_class(-1) * twice_imaginary(f.b), twice_real(f.b), twice_imaginary(f.a)}};
}

/// Elements of groups of surfaces of rational tiles.
class RationalElements {
 public:
  using Normal = ScaledNormal<mpz_class>;

  /// Nothing, if its numbers are too large.
  [[nodiscard]] static std::optional<Normal> normal_of(const Surface& surface, const Word& word) {
    std::size_t bits = 0;
    for (const SideId s : word) bits += certify::bits(integer_crossing(surface, s));
    if (bits > kMostBits) return std::nullopt;
    return scaled_normal(integer_isometry(surface, word));
  }
};

/// Elements of groups of surfaces of regular tiles, as elements of the group of the tiling.
class RegularElements {
 public:
  using Normal = ScaledNormal<certify::RegularNumber>;

  explicit RegularElements(RegularTile tile) : group_(tile) {}

  [[nodiscard]] const certify::RegularRing& ring() const { return group_.ring(); }

  [[nodiscard]] std::optional<Normal> normal_of(const Surface& surface, const Word& word) const {
    const std::size_t order = group_.ring().order();
    // A step of a walk adds some four bits to each coefficient.
    if (4 * order * word.size() > kMostBits) return std::nullopt;
    return scaled_normal(group_.element(walk_of(surface, word)));
  }

 private:
  TriangleGroup group_;
};

/// Elements of groups of surfaces over one number field.
class FieldElements {
 public:
  using Normal = ScaledNormal<certify::FieldNumber>;

  [[nodiscard]] static std::optional<Normal> normal_of(const Surface& surface, const Word& word) {
    std::size_t bits = 0;
    for (const SideId s : word) {
      bits += certify::bits(surface.field_tiles()->crossing[s]);
    }
    if (bits > kMostBits) return std::nullopt;
    return scaled_normal(field_isometry(surface, word));
  }
};

/// Whether both are over one field, which is given in one way.
[[nodiscard]] bool have_one_field(const Surface& first, const Surface& second) {
  const auto& tiles = first.field_tiles();
  const auto& others = second.field_tiles();
  return tiles && others && tiles->document.polynomial == others->document.polynomial &&
         tiles->document.root == others->document.root;
}

/// Elements of the group of a surface as texts that NumberFieldReader reads.
class ElementTexts {
 public:
  explicit ElementTexts(const Surface& surface) : surface_(surface) {
    if (surface.is_regular()) {
      regular_.emplace(*surface.regular_tile());
      ring_ = generator_texts(regular_->ring());
    } else if (surface.field_tiles()) {
      root_ = root_text(*surface.field_tiles());
    }
  }

  [[nodiscard]] const Surface& surface() const { return surface_; }

  /// Of the field of all elements.
  [[nodiscard]] std::vector<std::string> generators() const {
    if (regular_) return {ring_.cosine, ring_.s};
    if (!root_.empty()) return {root_};
    return {};
  }

  /// The scale and the three coordinates of the normal of an element, up to a common factor. Nothing, if its numbers
  /// are too large.
  [[nodiscard]] std::optional<std::vector<std::string>> normal_of(const Word& word) const {
    if (regular_) {
      return texts(regular_->normal_of(surface_, word), [&](const auto& x) { return number_texts(x, ring_); });
    }
    if (!root_.empty()) {
      return texts(FieldElements::normal_of(surface_, word), [&](const auto& x) { return number_texts(x, root_); });
    }
    return texts(RationalElements::normal_of(surface_, word), [](const std::vector<mpz_class>& x) {
      std::vector<std::string> result;
      result.reserve(x.size());
      for (const mpz_class& number : x) result.push_back(number.get_str());
      return result;
    });
  }

 private:
  template <class Real, class Texts>
  static std::optional<std::vector<std::string>> texts(const std::optional<ScaledNormal<Real>>& x, const Texts& texts) {
    if (!x) return std::nullopt;
    return texts(std::vector<Real>{x->scale, x->normal.x, x->normal.y, x->normal.t});
  }

  const Surface& surface_;
  std::optional<RegularElements> regular_;
  RingGenerators ring_;
  std::string root_;
};

/// Elements of groups of two surfaces of any kinds, in one number field that has the numbers of both.
class CommonElements {
 public:
  using Normal = ScaledNormal<certify::FieldNumber>;

  /// Throws SurfaceError, if the field is too large.
  CommonElements(const Surface& first, const Surface& second) : first_(first), second_(second) {
    // The square roots last: the polynomials of the others then have the fewest coefficients.
    const std::vector<std::string> some = first_.generators();
    const std::vector<std::string> others = second_.generators();
    for (std::size_t i = 0; i < std::max(some.size(), others.size()); ++i) {
      if (i < some.size()) reader_.add(some[i]);
      if (i < others.size()) reader_.add(others[i]);
    }
    const certify::SurfaceDocument::Field document = reader_.field();
    field_.emplace(document.polynomial, document.root);
  }

  /// Requires: one of the two surfaces.
  [[nodiscard]] std::optional<Normal> normal_of(const Surface& surface, const Word& word) const {
    const auto texts = (&surface == &first_.surface() ? first_ : second_).normal_of(word);
    if (!texts) return std::nullopt;
    return read(*texts);
  }

 private:
  /// The four numbers, with a common denominator that is left out.
  [[nodiscard]] Normal read(const std::vector<std::string>& texts) const {
    NumberFieldReader reader = reader_;
    const std::size_t before = reader.numbers().size();
    mpz_class denominator = 1;
    for (const std::string& text : texts) {
      reader.add(text);
      denominator = lcm(denominator, denominator_of(reader.numbers().back()));
    }
    const auto number = [&](std::size_t i) {
      certify::Polynomial integral;
      const RationalPolynomial& x = reader.numbers()[before + i];
      fmpq_poly_get_numerator(integral.get(), x.get());
      certify::Integer factor;
      fmpz_set_mpz(factor.get(), mpz_class(denominator / denominator_of(x)).get_mpz_t());
      fmpz_poly_scalar_mul_fmpz(integral.get(), integral.get(), factor.get());
      return certify::FieldNumber{&*field_, integral};
    };
    return {number(0), {number(1), number(2), number(3)}};
  }

  ElementTexts first_;
  ElementTexts second_;
  NumberFieldReader reader_;
  std::optional<certify::NumberField> field_;
};

/// What `use` makes of the elements of both surfaces. Nothing, if their numbers are in a field that is too large.
template <class Use>
[[nodiscard]] std::optional<bool> with_elements(const Surface& first, const Surface& second, const Use& use) {
  if (first.is_rational() && second.is_rational()) return use(RationalElements());
  if (have_one_field(first, second)) return use(FieldElements());
  const auto tile = first.regular_tile();
  try {
    if (tile && tile == second.regular_tile()) return use(RegularElements(*tile));
    return use(CommonElements(first, second));
  } catch (const SurfaceError&) {
    // A ring that is too large.
    return std::nullopt;
  }
}

/// An element and its partner.
template <class Normal>
struct NormalPair {
  Normal from;
  Normal to;
};

/// Whether the products of two normals, with both divided by their scales, are those of their partners.
template <class Normal>
[[nodiscard]] bool same_products(const NormalPair<Normal>& x, const NormalPair<Normal>& y) {
  return certify::sign(lorentz_product(x.from.normal, y.from.normal) * (x.to.scale * y.to.scale) -
                       lorentz_product(x.to.normal, y.to.normal) * (x.from.scale * y.from.scale)) == 0;
}

/// As same_products, for the determinants of three.
template <class Normal>
[[nodiscard]] bool same_determinants(const NormalPair<Normal>& x, const NormalPair<Normal>& y,
                                     const NormalPair<Normal>& z) {
  const auto determinant = [](const Normal& u, const Normal& v, const Normal& w) {
    return lorentz_product(lorentz_cross(u.normal, v.normal), w.normal);
  };
  return certify::sign(determinant(x.from, y.from, z.from) * (x.to.scale * y.to.scale * z.to.scale) -
                       determinant(x.to, y.to, z.to) * (x.from.scale * y.from.scale * z.from.scale)) == 0;
}

}  // namespace

std::optional<bool> are_conjugate(const Surface& first, const Surface& second, std::span<const ElementPair> pairs) {
  return with_elements(first, second, [&]<class Elements>(const Elements& elements) -> std::optional<bool> {
    std::vector<NormalPair<typename Elements::Normal>> normals;
    for (const ElementPair& pair : pairs) {
      auto from = elements.normal_of(first, pair.from);
      auto to = elements.normal_of(second, pair.to);
      if (!from || !to) return std::nullopt;
      normals.push_back({*std::move(from), *std::move(to)});
    }
    const auto& x = normals[0];
    const auto& y = normals[1];
    if (!same_products(x, x) || !same_products(x, y) || !same_products(y, y)) return false;
    for (std::size_t i = 2; i < normals.size(); ++i) {
      const auto& z = normals[i];
      if (!same_products(x, z) || !same_products(y, z) || !same_determinants(x, y, z)) return false;
    }
    return true;
  });
}

std::optional<bool> axes_cross(const Surface& surface, const Word& first, const Word& second) {
  return with_elements(surface, surface, [&](const auto& elements) -> std::optional<bool> {
    const auto u = elements.normal_of(surface, first);
    const auto v = elements.normal_of(surface, second);
    if (!u || !v) return std::nullopt;
    // They do if the vector across both normals is a point, but for its length.
    const auto across = lorentz_cross(u->normal, v->normal);
    return certify::sign(lorentz_product(across, across)) < 0;
  });
}

}  // namespace epsnet
