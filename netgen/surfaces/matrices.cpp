#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <sstream>
#include <utility>

#include "certify/base/text.h"
#include "netgen/base/gmp.h"
#include "netgen/surfaces/dirichlet_search.h"
#include "netgen/surfaces/exact_isometries.h"
#include "netgen/surfaces/field_numbers.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/relations.h"

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

Numeric rounded(const ExactIsometry& f) {
  const auto number = [](const mpz_class& x) { return Mp256(from_gmp(mpq_class(x))); };
  return normalized(Numeric{{number(f.a.re), number(f.a.im)}, {number(f.b.re), number(f.b.im)}});
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

mpq_class quotient(const mpz_class& n, const mpz_class& d) {
  mpq_class result(n, d);
  result.canonicalize();
  return result;
}

/// The square of the trace of an isometry of determinant 1.
mpq_class squared_trace(const ExactIsometry& f) { return quotient(4 * f.a.re * f.a.re, certify::determinant(f)); }

/// The order of an elliptic element of PGL(2, Q); nothing if it is infinite. Its rotation by 2πk/n has 2 + 2cos(2πk/n)
/// as its squared trace, which is rational for n = 2, 3, 4 and 6 alone.
std::optional<int> order_of_elliptic(const ExactIsometry& f) {
  const mpq_class square = squared_trace(f);
  if (square.get_den() != 1) return std::nullopt;
  constexpr std::array<int, 4> kOrders{2, 3, 4, 6};
  const mpz_class& value = square.get_num();
  if (sgn(value) < 0 || cmp(value, 3) > 0) return std::nullopt;
  return kOrders.at(value.get_ui());
}

/// What is known about a group: its elements are looked at as they are found.
class Examiner {
 public:
  /// Rounded, if the numbers are not exact: what differs from 0 by less than the tolerance is then not decided.
  Examiner(MatrixProducts& products, bool exact, double tolerance)
      : products_(products), exact_(exact), tolerance_(tolerance) {}

  /// Throws MatricesError if an element shows that the group is none of a closed surface.
  void operator()(ElementId x) const {
    const auto value = convert<Mp256>(products_.value(x));
    const Mp256 half_trace = abs(value.a.x);
    if (exact_ ? half_trace < 1 + 1e-9 : half_trace <= 1 + tolerance_) exact_ ? elliptic(x) : maybe_elliptic(x);
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
  static constexpr double kJorgensen = 1.118;  // |tr² − 4| < 1.

  void elliptic(ElementId x) const {
    const ExactIsometry f = products_.exact(x);
    const int sign = sgn(mpz_class(certify::norm(f.b) - f.a.im * f.a.im));
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
                                                decimal(sqrt(Mp256(from_gmp(squared_trace(f))))) + ")");
  }

  void maybe_elliptic(ElementId x) const {
    const Mp256 half_trace = abs(convert<Mp256>(products_.value(x)).a.x);
    if (half_trace < 1 - tolerance_) {
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
      if (abs(g.a.x) <= 1 || sum >= 1 - tolerance_ || abs(Mp256(commutator - 2)) <= tolerance_) continue;
      if (exact_ && !violates_exactly(products_.exact(x), products_.exact(y))) continue;
      throw MatricesError(Kind::not_discrete, "not discrete: " + name(x) + " and generator " + std::to_string(y) +
                                                  " violate Jorgensen's inequality" + by_digits());
    }
  }

  static bool violates_exactly(const ExactIsometry& f, const ExactIsometry& g) {
    const ExactIsometry commutator =
        certify::compose(certify::compose(f, g), certify::compose(certify::inverse(f), certify::inverse(g)));
    const mpq_class beyond = quotient(2 * commutator.a.re, certify::determinant(f) * certify::determinant(g)) - 2;
    return squared_trace(f) > 4 && squared_trace(g) > 4 && beyond != 0 && squared_trace(f) - 4 + abs(beyond) < 1;
  }

  MatrixProducts& products_;
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

Surface surface_of_darts(const Darts& darts, const Tiling& tiling, const std::vector<ExactIsometry>& elements,
                         const Complex<Rational>& base) {
  std::vector<Tile> tiles;
  for (const std::uint32_t i : tiling.first) {
    tiles.push_back({base, image(elements[i], base), image(elements[darts.after(i)], base)});
  }
  std::vector<Gluing> gluing;
  for (std::uint32_t i = 0; i < darts.count(); ++i) {
    const std::uint32_t s = tiling.side[i];
    const std::uint32_t t = tiling.side[darts.partner[i]];
    if (i < darts.partner[i]) gluing.push_back({s / 3, s % 3, t / 3, t % 3});
  }
  return {std::move(tiles), std::move(gluing)};
}

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
class Maker {
 public:
  Maker(const MatrixGenerators& matrices, bool exact) : matrices_(matrices), exact_(exact) {
    if (!exact) {
      constexpr unsigned kFewest = 4;
      tolerance_ = std::pow(10.0, -0.5 * std::max(matrices.digits.value_or(kFewest), kFewest));
      tolerance_ = std::max(tolerance_, kTiny);
    }
    for (const Isometry<Rational>& f : matrices.generators) generators_.push_back(integral(f));
  }

  MatrixSurface make() {
    check_relation();
    for (const Complex<Rational>& base : base_points()) {
      MatrixProducts products(generators_, base);
      const Examiner examine(products, exact_, tolerance_);
      DirichletSearch search(products, tolerance_, examine);
      switch (search.run()) {
        case DirichletSearch::End::compact:
          return exact_ ? exact_surface(products, search, base) : nearest_surface(products, search, base);
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

  void check_relation() const {
    if (matrices_.relation.empty()) return;
    if (exact_) {
      const auto letter = [&](std::size_t i) {
        const std::int32_t k = matrices_.relation[matrices_.relation.size() - 1 - i];
        const ExactIsometry& f = generators_[static_cast<std::size_t>(std::abs(k)) - 1];
        return k > 0 ? f : certify::inverse(f);
      };
      std::size_t bits = 0;
      for (std::size_t i = 0; i < matrices_.relation.size(); ++i) bits += certify::bits(letter(i));
      constexpr std::size_t kMostBits = 100'000'000;
      if (bits > kMostBits) {
        throw LimitError("the matrices of the relation have more than " + std::to_string(kMostBits) + " bits together");
      }
      const ExactIsometry product = certify::compose_range(0, matrices_.relation.size(), letter);
      if (!certify::is_identity(product)) fail_relation(rounded(product));
      return;
    }
    Numeric product{{Mp256(1), Mp256(0)}, {Mp256(0), Mp256(0)}};
    for (const std::int32_t letter : matrices_.relation) {
      const Numeric f = rounded(generators_[static_cast<std::size_t>(std::abs(letter)) - 1]);
      product = product * (letter > 0 ? f : inverse(f));
    }
    product = normalized(product);
    if (abs(product.a.y) > tolerance_ || sqrt(norm(product.b)) > tolerance_) fail_relation(product);
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
  MatrixSurface exact_surface(MatrixProducts& products, const DirichletSearch& search, const Complex<Rational>& base) {
    const Darts darts{search.partner()};
    std::vector<ExactIsometry> elements;
    for (const ElementId id : search.sides()) elements.push_back(products.exact(id));
    for (std::uint32_t i = 0; i < darts.count(); ++i) {
      if (same_isometry(certify::compose(elements[i], elements[darts.next(i)]), elements[darts.after(i)])) continue;
      throw MatricesError(Kind::relation,
                          "a relation of the Dirichlet domain holds to 100 bits, but not exactly: not discrete");
    }
    const Tiling tiling(darts);
    MatrixSurface result{checked(darts, tiling, elements, base), {}};
    for (const auto& some : factors(search)) result.words.push_back(word_of(result.surface, darts, tiling, some));
    for (std::size_t k = 0; k < generators_.size(); ++k) {
      const ExactIsometry found = integral(exact_isometry(result.surface, result.words[k]));
      if (same_isometry(found, generators_[k])) continue;
      throw MatricesError(Kind::undecided,
                          "could not decide: generator " + std::to_string(k + 1) +
                              " agrees with an element of the surface's group to 100 bits, but not exactly");
    }
    result.surface.set_about("surface of " + std::to_string(generators_.size()) + " matrices, exactly");
    return result;
  }

  static Surface checked(const Darts& darts, const Tiling& tiling, const std::vector<ExactIsometry>& elements,
                         const Complex<Rational>& base) {
    try {
      return surface_of_darts(darts, tiling, elements, base);
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
    std::vector<Numeric> targets;
    for (const ExactIsometry& f : generators_) targets.push_back(rounded(f));
    const std::vector<Numeric> nearest = nearest_solution(approximate, relation, targets, values);
    // As many bits as the decimals have, and at least 60.
    constexpr unsigned kMostBits = 240;
    const unsigned first_bits = std::clamp(10 * *matrices_.digits / 3 + 10, 60U, 200U);
    const Mp256 wanted = boost::multiprecision::ldexp(Mp256(1), 10 - static_cast<int>(first_bits));
    for (unsigned bits = first_bits; bits <= kMostBits; bits += 20) {
      const std::vector<ExactIsometry> solution = rational_solution(nearest, relation, bits);
      std::vector<Numeric> rounded_solution;
      for (const ExactIsometry& f : solution) {
        if (certify::determinant(f) <= 0) break;
        rounded_solution.push_back(rounded(f));
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
      for (const Word& word : result.words) found.push_back(rounded(integral(exact_isometry(result.surface, word))));
      const Mp256 distance = difference(found, targets);
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
  bool exact_;
  double tolerance_ = kTiny;
  std::vector<ExactIsometry> generators_;
};

}  // namespace

MatrixSurface surface_of_matrices(const MatrixGenerators& matrices) {
  if (matrices.tile) return surface_of_field_matrices(matrices);
  try {
    return Maker(matrices, true).make();
  } catch (const MatricesError& error) {
    if (!matrices.digits) throw;
  }
  return Maker(matrices, false).make();
}

}  // namespace epsnet
