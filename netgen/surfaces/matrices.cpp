#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <span>
#include <sstream>
#include <type_traits>
#include <utility>

#include "certify/base/text.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/dirichlet_search.h"
#include "netgen/surfaces/exact_isometries.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/number_field.h"
#include "netgen/surfaces/relations.h"
#include "netgen/surfaces/triangle_group.h"

/// The surface that matrices generate: the Dirichlet domain of a point is found with rounded numbers, and then examined
/// exactly.
namespace epsnet {
namespace {

using certify::ExactIsometry;
using ElementId = MatrixProducts::Id;
using Kind = MatricesError::Kind;
using Numeric = Isometry<Mp256>;

/// Points to try, near the centre of the disk. At a point with symmetries more than three lifts of the domain meet at a
/// vertex.
std::vector<Complex<Rational>> base_points() {
  const auto point = [](int x, int m, int y, int n) { return Complex<Rational>{Rational(x, m), Rational(y, n)}; };
  return {point(1, 37, 1, 53), point(-3, 71, 2, 43), point(5, 61, -4, 47), point(-7, 83, -6, 59), point(11, 97, 3, 31)};
}

Isometry<Mp1024> finely_rounded(const ExactIsometry& f) {
  const auto number = [](const mpz_class& x) { return Mp1024(from_gmp(mpq_class(x))); };
  return normalized(Isometry<Mp1024>{{number(f.a.re), number(f.a.im)}, {number(f.b.re), number(f.b.im)}});
}

Isometry<Mp1024> finely_rounded(const certify::Isometry<certify::FieldNumber>& f) {
  return rounded_isometry<Mp1024>(f);
}

template <class Number>
Numeric numeric(const certify::Isometry<Number>& f) {
  return convert<Mp256>(finely_rounded(f));
}

std::string decimal(const Mp256& x) { return certify::shortest(static_cast<double>(x)); }

/// A product as text: "abA" for up to 26 generators, else "1 2 -1".
std::string word_name(const std::vector<std::int32_t>& letters, std::size_t generators) {
  constexpr std::size_t kLetters = 26;
  std::string result;
  for (const std::int32_t letter : letters) {
    if (generators <= kLetters) {
      result += static_cast<char>((letter > 0 ? 'a' : 'A') + std::abs(letter) - 1);
    } else {
      result += (result.empty() ? "" : " ") + std::to_string(letter);
    }
  }
  return result;
}

/// The order of an elliptic element, if it is not too large: infinite ones have none.
template <class Number>
std::optional<int> order_of_elliptic(const certify::Isometry<Number>& f) {
  constexpr int kGreatest = 400;
  const Numeric value = numeric(f);
  Numeric power = value;
  certify::Isometry<Number> exact_power = f;
  for (int n = 2; n <= kGreatest; ++n) {
    power = normalized(value * power);
    if (sqrt(norm(power.b)) > 1e-40 || abs(power.a.y) > 1e-40) continue;
    // Near the identity: now exactly.
    for (int i = 1; i < n; ++i) exact_power = certify::compose(f, exact_power);
    return certify::is_identity(exact_power) ? std::optional(n) : std::nullopt;
  }
  return std::nullopt;
}

/// What is known about a group: its elements are looked at as they are found.
template <class Number>
class Examiner {
 public:
  /// Rounded, if the numbers are not exact: what differs from 0 by less than the tolerance is then not decided.
  Examiner(const MatrixProducts& products, ExactProducts<Number>& exactly, bool exact, double tolerance)
      : products_(products), exactly_(exactly), exact_(exact), tolerance_(tolerance) {}

  /// Throws MatricesError if an element shows that the group is none of a closed surface.
  void operator()(ElementId x) const {
    const auto value = convert<Mp256>(products_.value(x));
    const Mp256 half_trace = abs(value.a.x);
    if (exact_ ? half_trace < 1 + 1e-9 : half_trace <= 1 + slack(x)) exact_ ? elliptic(x) : maybe_elliptic(x);
    if (half_trace < kJorgensen) jorgensen(x);
  }

  [[nodiscard]] std::string name(ElementId x) const {
    constexpr std::size_t kMostLetters = 200;
    if (const auto letters = products_.letters(x, kMostLetters)) {
      return "the element " + word_name(*letters, products_.generators());
    }
    return "an element, a product of more than " + std::to_string(kMostLetters) + " generators,";
  }

  /// Throws for an element that fixes a point of the plane or of the circle.
  [[noreturn]] void fixes(ElementId x, Kind kind, const std::string& what) const {
    if (exact_) elliptic(x);
    throw MatricesError(kind, name(x) + " " + what + by_digits());
  }

  [[nodiscard]] std::string by_digits() const { return exact_ ? "" : ", as far as the decimals tell"; }

 private:
  using Element = certify::Isometry<Number>;
  static constexpr double kJorgensen = 1.118;  // |tr² − 4| < 1.

  void elliptic(ElementId x) const {
    const Element f = exactly_(x);
    // Of tr² − 4 times the determinant, divided by 4: |b|² − (Im a)².
    const decltype(norm(f.a)) twice_im = twice_imaginary(f.a);
    const int sign = certify::sign(mpz_class(4) * norm(f.b) - twice_im * twice_im);
    if (sign > 0 || certify::is_identity(f)) return;
    if (sign == 0) {
      throw MatricesError(Kind::not_compact, "not cocompact: " + name(x) + " is parabolic (its trace is ±2)");
    }
    if (const auto order = order_of_elliptic(f)) {
      throw MatricesError(Kind::torsion,
                          "the group has torsion: " + name(x) + " is elliptic, of order " + std::to_string(*order));
    }
    throw MatricesError(Kind::not_discrete, "not discrete: " + name(x) +
                                                " is elliptic, of infinite order (its trace is ±" +
                                                decimal(Mp256(2 * abs(numeric(f).a.x))) + ")");
  }

  /// How far a trace may be from that which is meant.
  [[nodiscard]] double slack(ElementId x) const { return std::max(tolerance_, 2 * products_.error(x)); }

  void maybe_elliptic(ElementId x) const {
    // Short elements are as near to parabolic ones as their error is.
    constexpr double kFine = 1e-6;
    const Mp256 half_trace = abs(convert<Mp256>(products_.value(x)).a.x);
    if (products_.error(x) > kFine) throw CoarseNumbers{x, products_.error(x)};
    if (half_trace < 1 - slack(x)) {
      throw MatricesError(Kind::torsion, name(x) + " is elliptic, with the trace ±" + decimal(2 * half_trace) +
                                             ": the group has torsion or is not discrete");
    }
    throw MatricesError(Kind::not_compact, name(x) + " is parabolic, as far as the decimals tell: its trace is ±" +
                                               decimal(2 * half_trace));
  }

  /// T. Jørgensen (On discrete groups of Möbius transformations, Amer. J. Math. 98, 1976): if |tr² f − 4| +
  /// |tr [f, g] − 2| < 1, then f and g do not generate a discrete group, unless it is elementary. Two hyperbolic
  /// elements without a common fixed point, tr [f, g] ≠ 2, generate no elementary one.
  void jorgensen(ElementId x) const {
    const Numeric f = convert<Mp256>(products_.value(x));
    for (ElementId y = 1; y <= static_cast<ElementId>(products_.generators()); ++y) {
      const Numeric g = convert<Mp256>(products_.value(y));
      const Mp256 commutator = 2 * (f * g * inverse(f) * inverse(g)).a.x;
      const Mp256 sum = abs(Mp256(4 * f.a.x * f.a.x - 4)) + abs(Mp256(commutator - 2));
      const double unknown = exact_ ? tolerance_ : std::max(tolerance_, commutator_error(x, y));
      if (abs(g.a.x) <= 1 || sum >= 1 - unknown || abs(Mp256(commutator - 2)) <= unknown) continue;
      if (exact_ && !violates_exactly(exactly_(x), exactly_(y))) continue;
      throw MatricesError(Kind::not_discrete, "not discrete: " + name(x) + " and generator " + std::to_string(y) +
                                                  " violate Jorgensen's inequality" + by_digits());
    }
  }

  /// About the error of the trace of a commutator.
  [[nodiscard]] double commutator_error(ElementId x, ElementId y) const {
    const auto size = [&](ElementId z) {
      return static_cast<double>(2 * sqrt(Mp256(norm(convert<Mp256>(products_.value(z)).a))));
    };
    return 8 * size(x) * size(y) * (products_.error(x) * size(y) + size(x) * products_.error(y));
  }

  /// In numbers that are multiplied by the determinants d and e of f and g: tr² f > 4, tr² g > 4, tr [f, g] ≠ 2, and
  /// tr² f − 4 + |tr [f, g] − 2| < 1. The determinant of the commutator is d²e².
  static bool violates_exactly(const Element& f, const Element& g) {
    using certify::sign;
    using Real = decltype(norm(f.a));  // GMP's sums and products are not numbers by themselves.
    const Element commutator =
        certify::compose(certify::compose(f, g), certify::compose(certify::inverse(f), certify::inverse(g)));
    const auto beyond_4 = [](const Element& h) -> Real {
      return twice_real(h.a) * twice_real(h.a) - mpz_class(4) * certify::determinant(h);
    };
    const Real both = certify::determinant(f) * certify::determinant(g);
    const Real beyond_2 = twice_real(commutator.a) - mpz_class(2) * both;
    const int side = sign(beyond_2);
    return sign(beyond_4(f)) > 0 && sign(beyond_4(g)) > 0 && side != 0 &&
           sign(beyond_4(f) * certify::determinant(g) + mpz_class(side) * beyond_2 - both) < 0;
  }

  const MatrixProducts& products_;
  ExactProducts<Number>& exactly_;
  bool exact_;
  double tolerance_;
};

/// The domain's sides, as darts of the triangulation that is dual to it: dart i leads from the base point p to fᵢp, and
/// on its left is the triangle p, fᵢp, fᵢ₊₁p.
struct Darts {
  std::vector<std::uint32_t> partner;

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(partner.size()); }
  [[nodiscard]] std::uint32_t after(std::uint32_t i) const { return (i + 1) % count(); }
  /// The next dart around the triangle on the left: fᵢ f_next(i) = fᵢ₊₁.
  [[nodiscard]] std::uint32_t next(std::uint32_t i) const { return (partner[i] + count() - 1) % count(); }
};

/// A polygon of all triangles, without the edges inside of it.
struct DartPolygon {
  std::vector<std::uint32_t> rim;  ///< Its sides, counterclockwise: their elements have the product 1.
  std::vector<std::uint32_t>
      inside;  ///< f = f_next(p) f_next(next(p)) for the partner p, from the last one to the first.

  explicit DartPolygon(const Darts& darts) {
    std::vector<bool> placed(darts.count());
    const auto place = [&](std::uint32_t i) {
      for (const std::uint32_t dart : {i, darts.next(i), darts.next(darts.next(i))}) placed[dart] = true;
    };
    std::list<std::uint32_t> sides{0, darts.next(0), darts.next(darts.next(0))};
    place(0);
    for (bool grown = true; grown;) {
      grown = false;
      for (auto side = sides.begin(); side != sides.end();) {
        const std::uint32_t other = darts.partner[*side];
        if (placed[other]) {
          ++side;
          continue;
        }
        grown = true;
        place(other);
        inside.push_back(*side);
        sides.insert(side, darts.next(other));
        sides.insert(side, darts.next(darts.next(other)));
        side = sides.erase(side);
      }
    }
    rim.assign(sides.begin(), sides.end());
  }
};

/// The elements of all darts, from those of the rim.
template <class Element, class Product, class Inverse>
std::vector<Element> all_darts(const Darts& darts, const DartPolygon& polygon, std::vector<Element> elements,
                               const Product& product, const Inverse& inverse_of_element) {
  for (auto dart = polygon.inside.rbegin(); dart != polygon.inside.rend(); ++dart) {
    const std::uint32_t other = darts.partner[*dart];
    elements[*dart] = product(elements[darts.next(other)], elements[darts.next(darts.next(other))]);
    elements[other] = inverse_of_element(elements[*dart]);
  }
  return elements;
}

/// Triangles whose sides are darts.
struct Tiling {
  std::vector<std::uint32_t> first;  ///< By triangle, its first dart.
  std::vector<std::uint32_t> side;   ///< By dart, the number of the side of the surface.

  explicit Tiling(const Darts& darts) : side(darts.count()) {
    std::vector<bool> seen(darts.count());
    for (std::uint32_t i = 0; i < darts.count(); ++i) {
      if (seen[i]) continue;
      std::uint32_t dart = i;
      for (std::uint32_t k = 0; k < 3; ++k) {
        seen[dart] = true;
        side[dart] = static_cast<std::uint32_t>(3 * first.size()) + k;
        dart = darts.next(dart);
      }
      first.push_back(i);
    }
  }
};

std::vector<Gluing> gluing_of(const Darts& darts, const Tiling& tiling) {
  std::vector<Gluing> gluing;
  for (std::uint32_t i = 0; i < darts.count(); ++i) {
    const std::uint32_t s = tiling.side[i];
    const std::uint32_t t = tiling.side[darts.partner[i]];
    if (i < darts.partner[i]) gluing.push_back({s / 3, s % 3, t / 3, t % 3});
  }
  return gluing;
}

/// Groups of rational matrices, and their surfaces.
struct RationalGroups {
  using Number = certify::Gaussian;

  [[nodiscard]] static Surface surface(const Darts& darts, const Tiling& tiling,
                                       const std::vector<ExactIsometry>& elements, const Complex<Rational>& base) {
    std::vector<Tile> tiles;
    for (const std::uint32_t i : tiling.first) {
      tiles.push_back({base, image(elements[i], base), image(elements[darts.after(i)], base)});
    }
    return {std::move(tiles), gluing_of(darts, tiling)};
  }
  [[nodiscard]] static ExactIsometry isometry(const Surface& surface, const Word& word) {
    return integral(exact_isometry(surface, word));
  }
};

/// Groups of matrices over a number field. All tiles have the coordinates of the matrices.
struct FieldGroups {
  using Number = certify::FieldNumber;
  using Element = certify::Isometry<Number>;

  certify::SurfaceDocument::Field document;  ///< The field alone.
  const certify::NumberField& field;

  [[nodiscard]] Surface surface(const Darts& darts, const Tiling& tiling, const std::vector<Element>& elements,
                                const Complex<Rational>& base) const {
    certify::SurfaceDocument::Field tiles = document;
    const certify::ExactPoint p = certify::exact_point(to_gmp(base));
    const Element one{certify::field_number(field, certify::Gaussian{1, 0}),
                      certify::field_number(field, certify::Gaussian{0, 0})};
    // The side of dart h leads from the image of p under shift[h], to that of its end.
    std::vector<const Element*> shift(darts.count());
    for (const std::uint32_t i : tiling.first) {
      const std::array<const Element*, 3> corners{&one, &elements[i], &elements[darts.after(i)]};
      auto& tile = tiles.polygons.emplace_back();
      std::uint32_t dart = i;
      for (const Element* corner : corners) {
        const auto v = certify::hyperboloid_vector(certify::moved(*corner, p));
        tile.push_back({coefficients_of(v.x), coefficients_of(v.y), coefficients_of(v.t)});
        shift[dart] = corner;
        dart = darts.next(dart);
      }
    }
    for (std::uint32_t i = 0; i < darts.count(); ++i) {
      if (i > darts.partner[i]) continue;
      // Dart i ends where its partner, moved by the element of i, starts.
      Element crossing = certify::compose(*shift[darts.partner[i]],
                                          certify::compose(certify::inverse(elements[i]), certify::inverse(*shift[i])));
      certify::reduce(crossing);
      const auto part = [&](const certify::Polynomial& x) { return coefficients_of({&field, x}); };
      tiles.crossings.push_back({part(crossing.a.re), part(crossing.a.im), part(crossing.b.re), part(crossing.b.im)});
    }
    return surface_over_field(std::move(tiles), gluing_of(darts, tiling));
  }
  /// In the field of the group, not that of the surface.
  [[nodiscard]] Element isometry(const Surface& surface, const Word& word) const {
    Element f = field_isometry(surface, word);
    f.a.field = &field;
    f.b.field = &field;
    return f;
  }
};

/// A path from tile 0 to its image under the element of dart i: around p to the triangle on the left of the dart, along
/// it, and around fᵢp.
Word path_of_dart(const Darts& darts, const Tiling& tiling, std::uint32_t i) {
  Word result;
  for (std::uint32_t h = 1; h <= i; ++h) result.emplace_back(tiling.side[darts.partner[h]]);
  for (std::uint32_t h = darts.next(i); h > 0; --h) result.emplace_back(tiling.side[h]);
  return result;
}

/// The word of a product of darts, from tile 0 to itself, as in group.h: its path leads back to tile 0.
Word word_of(const Surface& surface, const Darts& darts, const Tiling& tiling,
             const std::vector<std::uint32_t>& factors) {
  Word path;
  for (const std::uint32_t i : factors) path = concatenated(surface, std::move(path), path_of_dart(darts, tiling, i));
  return reversed(surface, path);
}

/// One way to the surface: with the numbers of the text taken for exact, or as rounded ones.
template <class Groups>
class Maker {
 public:
  using Number = typename Groups::Number;
  using Element = certify::Isometry<Number>;

  Maker(const MatrixGenerators& matrices, std::vector<Element> generators, const Groups& groups, bool exact)
      : matrices_(matrices), generators_(std::move(generators)), groups_(groups), exact_(exact) {
    for (const Element& f : generators_) rounded_.push_back(finely_rounded(f));
    for (const Element& f : generators_) targets_.push_back(numeric(f));
    if (!exact) set_digits(matrices.digits.value());
  }

  /// The surface is to be near to these instead; the generators are known to so many digits.
  void approach(std::vector<Numeric> targets, unsigned digits) {
    targets_ = std::move(targets);
    set_digits(digits);
  }

  MatrixSurface make() {
    check_relation();
    for (const Complex<Rational>& base : base_points()) {
      MatrixProducts products(rounded_, base, rounding_);
      ExactProducts<Number> exactly(products, generators_);
      const Examiner<Number> examine(products, exactly, exact_, tolerance_);
      DirichletSearch search(products, tolerance_, examine);
      switch (end_of(search)) {
        case DirichletSearch::End::compact:
          if constexpr (std::is_same_v<Groups, RationalGroups>) {
            if (!exact_) return nearest_surface(products, search, base);
          }
          return exact_surface(exactly, search, base);
        case DirichletSearch::End::cusp:
          if (search.element() != 0) {
            examine.fixes(search.element(), Kind::not_compact,
                          "fixes a vertex of the domain at infinity: not cocompact");
          }
          [[fallthrough]];
        case DirichletSearch::End::free_side:
          throw MatricesError(
              Kind::not_compact,
              "not cocompact: the Dirichlet domain of a point near the centre has infinite area (computed, " +
                  std::string(exact_ ? "with 256 bits)" : "from the decimals)"));
        case DirichletSearch::End::torsion:
          examine.fixes(search.element(), Kind::torsion, "fixes a vertex of the domain: the group has torsion");
        case DirichletSearch::End::limit:
          throw MatricesError(Kind::undecided,
                              "could not decide: no Dirichlet domain was found within the limits; the group may not be "
                              "discrete");
        case DirichletSearch::End::degenerate:
          break;
      }
    }
    throw MatricesError(Kind::undecided,
                        "could not decide: at all points that were tried the Dirichlet domain has a vertex where more "
                        "than three lifts meet, as far as the numbers tell");
  }

 private:
  static constexpr double kTiny = 1e-40;

  /// Exact numbers are not coarse: the search came to nothing.
  [[nodiscard]] DirichletSearch::End end_of(DirichletSearch& search) const {
    try {
      return search.run();
    } catch (const CoarseNumbers&) {
      if (!exact_) throw;
      return DirichletSearch::End::limit;
    }
  }

  void set_digits(unsigned digits) {
    constexpr unsigned kFewest = 4;
    tolerance_ = std::max(std::pow(10.0, -0.5 * std::max(digits, kFewest)), kTiny);
    rounding_ = std::pow(10.0, -static_cast<double>(digits));
  }

  void check_relation() const {
    if (matrices_.relation.empty()) return;
    if (exact_) {
      const auto letter = [&](std::size_t i) {
        const std::int32_t k = matrices_.relation[matrices_.relation.size() - 1 - i];
        const Element& f = generators_[static_cast<std::size_t>(std::abs(k)) - 1];
        return k > 0 ? f : certify::inverse(f);
      };
      std::size_t bits = 0;
      for (std::size_t i = 0; i < matrices_.relation.size(); ++i) bits += certify::bits(letter(i));
      constexpr std::size_t kMostBits = 100'000'000;
      if (bits > kMostBits) {
        throw LimitError("the matrices of the relation have more than " + std::to_string(kMostBits) + " bits together");
      }
      const Element product = certify::compose_range(0, matrices_.relation.size(), letter);
      if (!certify::is_identity(product)) fail_relation(numeric(product));
      return;
    }
    MatrixProducts products(rounded_, {0, 0}, rounding_);
    ElementId product = matrices_.relation[0];
    for (std::size_t i = 1; i < matrices_.relation.size(); ++i)
      product = products.product(product, matrices_.relation[i]);
    const Numeric f = convert<Mp256>(products.value(product));
    const double slack = std::max(tolerance_, 4 * products.error(product));
    if (abs(f.a.y) > slack || sqrt(norm(f.b)) > slack) fail_relation(f);
  }

  [[noreturn]] void fail_relation(const Numeric& product) const {
    const Mp256 off = sqrt(Mp256(norm(product.b) + product.a.y * product.a.y + (product.a.x - 1) * (product.a.x - 1)));
    throw MatricesError(Kind::relation, "the relation " + word_name(matrices_.relation, generators_.size()) +
                                            " does not hold: the product differs from 1 by " + decimal(off));
  }

  /// By generator: a product of darts.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> factors(const DirichletSearch& search) const {
    std::vector<std::vector<std::uint32_t>> result;
    for (ElementId k = 1; k <= static_cast<ElementId>(generators_.size()); ++k) {
      auto some = search.factors(k);
      if (!some) {
        throw MatricesError(Kind::undecided, "could not decide: generator " + std::to_string(k) +
                                                 " is not found as a product of sides of the Dirichlet domain");
      }
      result.push_back(*std::move(some));
    }
    return result;
  }

  /// Throws MatricesError unless everything holds exactly.
  MatrixSurface exact_surface(ExactProducts<Number>& exactly, const DirichletSearch& search,
                              const Complex<Rational>& base) {
    const Darts darts{search.partner()};
    std::vector<Element> elements;
    for (const ElementId id : search.sides()) elements.push_back(exactly(id));
    for (std::uint32_t i = 0; i < darts.count(); ++i) {
      if (same_isometry(certify::compose(elements[i], elements[darts.next(i)]), elements[darts.after(i)])) continue;
      throw MatricesError(Kind::relation,
                          "a relation of the Dirichlet domain holds to 100 bits, but not exactly: not discrete");
    }
    const Tiling tiling(darts);
    MatrixSurface result{checked(darts, tiling, elements, base), {}};
    for (const auto& some : factors(search)) result.words.push_back(word_of(result.surface, darts, tiling, some));
    for (std::size_t k = 0; k < generators_.size(); ++k) {
      if (same_isometry(groups_.isometry(result.surface, result.words[k]), generators_[k])) continue;
      throw MatricesError(Kind::undecided,
                          "could not decide: generator " + std::to_string(k + 1) +
                              " agrees with an element of the surface's group to 100 bits, but not exactly");
    }
    result.surface.set_about("surface of " + std::to_string(generators_.size()) + " matrices, exactly");
    return result;
  }

  Surface checked(const Darts& darts, const Tiling& tiling, const std::vector<Element>& elements,
                  const Complex<Rational>& base) const {
    try {
      return groups_.surface(darts, tiling, elements, base);
    } catch (const SurfaceError& error) {
      throw MatricesError(Kind::undecided, "could not decide: the triangles found are not a closed surface: " +
                                               std::string(error.what()));
    }
  }

  MatrixSurface nearest_surface(MatrixProducts& products, const DirichletSearch& search,
                                const Complex<Rational>& base) const {
    const Darts darts{search.partner()};
    const DartPolygon polygon(darts);
    const std::vector<std::vector<std::uint32_t>> words = factors(search);
    // Darts are seen from the base point; the solution is looked for in the coordinates of the matrices.
    const auto centre = normalized(Isometry<Mp256>::translation(convert<Mp256>(base)));
    std::vector<std::uint32_t> dart_of_letter;
    std::vector<std::int32_t> letter(darts.count());
    std::vector<Numeric> approximate;
    SurfaceRelation relation;
    for (const std::uint32_t i : polygon.rim) {
      if (letter[i] == 0) {
        dart_of_letter.push_back(i);
        approximate.push_back(normalized(centre * convert<Mp256>(products.value(search.sides()[i])) * inverse(centre)));
        letter[i] = static_cast<std::int32_t>(dart_of_letter.size());
        letter[darts.partner[i]] = -letter[i];
      }
      relation.push_back(letter[i]);
    }
    const auto spread = [&](const auto& generators, const auto& product, const auto& inverse_of_element) {
      std::vector<std::decay_t<decltype(generators[0])>> elements(darts.count());
      for (std::size_t k = 0; k < dart_of_letter.size(); ++k) {
        elements[dart_of_letter[k]] = generators[k];
        elements[darts.partner[dart_of_letter[k]]] = inverse_of_element(generators[k]);
      }
      return all_darts(darts, polygon, std::move(elements), product, inverse_of_element);
    };
    const auto numeric_product = [](const Numeric& f, const Numeric& g) { return f * g; };
    const auto numeric_inverse = [](const Numeric& f) { return inverse(f); };
    const auto values = [&](const std::vector<Numeric>& generators) {
      const std::vector<Numeric> elements = spread(generators, numeric_product, numeric_inverse);
      std::vector<Numeric> result;
      for (const auto& some : words) {
        Numeric product{{Mp256(1), Mp256(0)}, {Mp256(0), Mp256(0)}};
        for (const std::uint32_t i : some) product = product * elements[i];
        result.push_back(normalized(product));
      }
      return result;
    };
    const std::vector<Numeric> nearest = nearest_solution(approximate, relation, targets_, values);
    // As many bits as the decimals have, and at least 60.
    constexpr unsigned kMostBits = 240;
    const unsigned first_bits = std::clamp(10 * matrices_.digits.value() / 3 + 10, 60U, 200U);
    const Mp256 wanted = boost::multiprecision::ldexp(Mp256(1), 10 - static_cast<int>(first_bits));
    for (unsigned bits = first_bits; bits <= kMostBits; bits += 20) {
      const std::vector<ExactIsometry> solution = rational_solution(nearest, relation, bits);
      std::vector<Numeric> rounded_solution;
      for (const ExactIsometry& f : solution) {
        if (certify::determinant(f) <= 0) break;
        rounded_solution.push_back(numeric(f));
      }
      if (rounded_solution.size() < solution.size() || difference(values(rounded_solution), values(nearest)) > wanted) {
        continue;
      }
      const auto exact_product = [](const ExactIsometry& f, const ExactIsometry& g) {
        ExactIsometry product = certify::compose(f, g);
        certify::reduce(product);
        return product;
      };
      const auto exact_inverse = [](const ExactIsometry& f) { return certify::inverse(f); };
      const Tiling tiling(darts);
      MatrixSurface result{checked(darts, tiling, spread(solution, exact_product, exact_inverse), base), {}};
      for (const auto& some : words) result.words.push_back(word_of(result.surface, darts, tiling, some));
      result.is_exact = false;
      std::vector<Numeric> found;
      for (const Word& word : result.words) found.push_back(numeric(integral(exact_isometry(result.surface, word))));
      const Mp256 distance = difference(found, targets_);
      result.distance = static_cast<double>(distance);
      result.surface.set_about("surface nearest to " + std::to_string(generators_.size()) +
                               " rounded matrices: entries differ by at most " + decimal(distance));
      return result;
    }
    throw MatricesError(Kind::undecided,
                        "could not decide: no exact solution of the relations was found near the matrices");
  }

  /// The largest difference of two entries.
  [[nodiscard]] Mp256 difference(const std::vector<Numeric>& some, const std::vector<Numeric>& others) const {
    Mp256 result(0);
    for (std::size_t k = 0; k < some.size(); ++k) {
      const Numeric& f = some[k];
      const Numeric& g = others[k];
      const Complex<Mp256> a = f.a - g.a;
      const Complex<Mp256> b = f.b - g.b;
      // The entries of the half-plane are sums and differences of those of the disk.
      const std::array<Mp256, 4> parts =
          matrices_.model == MatrixModel::su11
              ? std::array<Mp256, 4>{a.x, a.y, b.x, b.y}
              : std::array<Mp256, 4>{Mp256(a.x + b.x), Mp256(a.x - b.x), Mp256(a.y + b.y), Mp256(a.y - b.y)};
      for (const Mp256& part : parts) result = std::max(result, Mp256(abs(part)));
    }
    return result;
  }

  const MatrixGenerators& matrices_;
  std::vector<Element> generators_;
  std::vector<Isometry<Mp1024>> rounded_;
  std::vector<Numeric> targets_;
  const Groups& groups_;
  bool exact_;
  double tolerance_ = kTiny;
  double rounding_ = 0;  ///< Of numbers of generators, relative to their size.
};

/// Whether the relation has every generator once in each direction, and makes a polygon with these sides a closed
/// surface with one vertex.
bool is_surface_relation(const std::vector<std::int32_t>& relation, std::size_t generators) {
  if (generators % 2 != 0 || relation.size() != 2 * generators) return false;
  const auto sides = static_cast<std::uint32_t>(relation.size());
  std::vector<std::uint32_t> partner(sides, sides);
  for (std::uint32_t i = 0; i < sides; ++i) {
    const auto other = std::find(relation.begin(), relation.end(), -relation[i]);
    if (other == relation.end() || std::count(relation.begin(), relation.end(), relation[i]) != 1) return false;
    partner[i] = static_cast<std::uint32_t>(other - relation.begin());
  }
  std::uint32_t around = 0;
  std::uint32_t corners = 0;
  do {
    around = (partner[around] + 1) % sides;
    ++corners;
  } while (around != 0);
  return corners == sides;
}

/// How far the product of a relation is from 1; not a number, if some number of an element is none.
Mp256 defect(const std::vector<Numeric>& generators, const std::vector<std::int32_t>& relation) {
  Numeric product{{Mp256(1), Mp256(0)}, {Mp256(0), Mp256(0)}};
  for (const std::int32_t letter : relation) {
    const Numeric& f = generators[static_cast<std::size_t>(std::abs(letter)) - 1];
    product = product * (letter > 0 ? f : inverse(f));
  }
  product = normalized(product);
  return abs(product.a.y) + sqrt(norm(product.b));
}

/// The elements nearest to rounded ones of which the relation holds. Throws CoarseNumbers if none are found.
std::vector<Numeric> moved_to_relation(const std::vector<Numeric>& targets, const std::vector<std::int32_t>& relation) {
  constexpr double kFine = 1e-60;
  constexpr double kTooFar = 1e-3;
  constexpr int kMostTrials = 8;
  std::vector<Numeric> solution = targets;
  for (int trial = 0; trial < kMostTrials; ++trial) {
    solution = nearest_solution(solution, relation, targets, [](const auto& elements) { return elements; });
    const Mp256 off = defect(solution, relation);
    if (!boost::multiprecision::isfinite(off)) break;
    if (off < kFine) return solution;
  }
  throw CoarseNumbers{0, kTooFar};
}

/// The surface near to decimals. With a relation of the generators these are first moved to where it holds, so that few
/// digits will do.
MatrixSurface surface_near(const MatrixGenerators& matrices, const std::vector<ExactIsometry>& generators) {
  const unsigned digits = matrices.digits.value();
  try {
    if (!is_surface_relation(matrices.relation, generators.size())) {
      return Maker<RationalGroups>(matrices, generators, RationalGroups(), false).make();
    }
    std::vector<Numeric> targets;
    targets.reserve(generators.size());
    for (const ExactIsometry& f : generators) targets.push_back(numeric(f));
    std::vector<ExactIsometry> solution;
    for (const Numeric& f : moved_to_relation(targets, matrices.relation)) {
      solution.push_back(integral(convert<Rational>(f)));
    }
    constexpr unsigned kDigitsOfSolution = 60;
    Maker<RationalGroups> maker(matrices, std::move(solution), RationalGroups(), false);
    maker.approach(std::move(targets), kDigitsOfSolution);
    return maker.make();
  } catch (const CoarseNumbers& coarse) {
    const double missing = std::ceil(std::log10(std::max(coarse.error, 1e-9)) + 4);
    throw MatricesError(Kind::undecided,
                        "could not decide: the entries have " + std::to_string(digits) + " digits; about " +
                            std::to_string(digits + static_cast<unsigned>(std::max(missing, 2.0))) + " are needed" +
                            (coarse.element != 0 ? ", or a relation of the generators" : ""));
  } catch (const MatricesError& error) {
    // Of a surface with short geodesics, or seen from afar, few digits may say anything.
    constexpr unsigned kEnough = 12;
    if (digits >= kEnough || error.kind() == Kind::relation) throw;
    throw MatricesError(Kind::undecided, "could not decide: " + std::string(error.what()) + "; the entries have " +
                                             std::to_string(digits) + " digits; about " + std::to_string(kEnough) +
                                             " are needed to be sure");
  }
}

/// Four numbers of a field without fractions, times a common positive integer.
std::vector<certify::FieldNumber> integral_numbers(std::span<const RationalPolynomial> numbers,
                                                   const certify::NumberField& field) {
  mpz_class denominator = 1;
  for (const RationalPolynomial& x : numbers) denominator = lcm(denominator, denominator_of(x));
  std::vector<certify::FieldNumber> result;
  for (const RationalPolynomial& x : numbers) {
    certify::FieldNumber number{&field, {}};
    fmpq_poly_get_numerator(number.re.get(), x.get());
    result.push_back(mpz_class(denominator / denominator_of(x)) * number);
  }
  return result;
}

/// The surface of matrices whose entries are numbers of a field, which are read from texts.
MatrixSurface surface_over_field_of(const MatrixGenerators& matrices) {
  NumberFieldReader reader;
  for (const auto& entries : matrices.numbers) {
    for (const std::string& entry : entries) {
      try {
        reader.add(entry);
      } catch (const SurfaceError& error) {
        throw MatricesError(Kind::text,
                            "generator " + std::to_string(reader.numbers().size() / 4 + 1) + ": " + error.what());
      }
    }
  }
  const certify::SurfaceDocument::Field document = reader.field();
  const certify::NumberField field(document.polynomial, document.root);
  std::vector<certify::Isometry<certify::FieldNumber>> generators;
  for (std::size_t k = 0; k < matrices.numbers.size(); ++k) {
    const auto e = integral_numbers(std::span(reader.numbers()).subspan(4 * k, 4), field);
    const certify::Gaussian i{0, 1};
    generators.push_back(matrices.model == MatrixModel::su11
                             ? certify::Isometry<certify::FieldNumber>{e[0] + i * e[1], e[2] + i * e[3]}
                             : certify::Isometry<certify::FieldNumber>{e[0] + e[3] + i * (e[1] - e[2]),
                                                                       e[0] - e[3] - i * (e[1] + e[2])});
    if (certify::sign(certify::determinant(generators.back())) > 0) continue;
    throw MatricesError(Kind::text, "generator " + std::to_string(k + 1) +
                                        ": the determinant is not positive, so it is no isometry of the plane that "
                                        "preserves the orientation");
  }
  return Maker<FieldGroups>(matrices, std::move(generators), FieldGroups{document, field}, true).make();
}

}  // namespace

MatrixSurface surface_of_matrices(const MatrixGenerators& matrices) {
  if (matrices.tile) return surface_of_field_matrices(matrices);
  if (!matrices.numbers.empty()) return surface_over_field_of(matrices);
  std::vector<ExactIsometry> generators;
  for (const Isometry<Rational>& f : matrices.generators) generators.push_back(integral(f));
  try {
    return Maker<RationalGroups>(matrices, generators, RationalGroups(), true).make();
  } catch (const MatricesError& error) {
    if (!matrices.digits) throw;
  }
  return surface_near(matrices, generators);
}

}  // namespace epsnet
