#include "netgen/surfaces/relations.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <list>
#include <optional>
#include <utility>

#include "netgen/base/gmp.h"
#include "netgen/surfaces/group.h"
#include "triangulation/surface/atlas.h"

/// The fundamental polygon of group.h, and relations of its side pairings.
namespace epsnet {
namespace {

/// A tree of the tiles, with tile 0 as its root.
struct Tree {
  ById<TileId, Word> path;  ///< The path from tile 0 to a tile.
  std::list<SideId> rim;    ///< The sides that the tree does not cross, counterclockwise around all tiles.

  explicit Tree(const Surface& surface) : path(surface.tiles().size()) {
    ById<TileId, bool> reached(path.size());
    reached[TileId(0)] = true;
    for (const SideId s : surface.sides_of(TileId(0))) rim.push_back(s);
    // Breadth first: the sides added in one round are visited in the next.
    for (bool grown = true; grown;) {
      grown = false;
      for (auto place = rim.begin(); place != rim.end();) {
        const SideId entry = surface.partner(*place);
        const TileId tile = surface.tile_of_side(entry);
        if (reached[tile]) {
          ++place;
          continue;
        }
        reached[tile] = grown = true;
        path[tile] = path[surface.tile_of_side(*place)];
        path[tile].push_back(*place);
        for (SideId s = surface.next_side(entry); s != entry; s = surface.next_side(s)) rim.insert(place, s);
        place = rim.erase(place);
      }
    }
  }
};

/// The point at the end of a path, in the coordinates where it starts, rounded to 256 bits.
Complex<Rational> rounded_from(const Surface& surface, const Word& path, const Complex<Rational>& z) {
  if (path.empty()) return z;
  Complex<Mp1024> result = convert<Mp1024>(z);
  for (auto side = path.rbegin(); side != path.rend(); ++side) {
    result = surface.crossing_as<Mp1024>(surface.partner(*side))(result);
  }
  return {Rational(Mp256(result.x)), Rational(Mp256(result.y))};
}

/// Removes pairs of neighbouring sides that are glued to each other.
std::vector<SideId> without_folds(const Surface& surface, const std::list<SideId>& rim) {
  std::vector<SideId> sides;
  for (const SideId s : rim) {
    if (!sides.empty() && surface.partner(sides.back()) == s) {
      sides.pop_back();
    } else {
      sides.push_back(s);
    }
  }
  std::size_t first = 0;
  while (sides.size() - first > 2 && surface.partner(sides[first]) == sides.back()) {
    ++first;
    sides.pop_back();
  }
  sides.erase(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(first));
  return sides;
}

PolygonSides polygon_sides(const Surface& surface, const Tree& tree) {
  PolygonSides result;
  result.side = without_folds(surface, tree.rim);
  const auto count = static_cast<std::uint32_t>(result.side.size());
  ById<SideId, std::uint32_t> place(surface.side_count());
  for (std::uint32_t k = 0; k < count; ++k) place[result.side[k]] = k;
  for (const SideId s : result.side) result.partner.push_back(place[surface.partner(s)]);
  std::vector<bool> visited(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    if (visited[k]) continue;
    std::vector<std::uint32_t>& relation = result.relations.emplace_back();
    for (std::uint32_t s = k; !visited[s]; s = (result.partner[s] + 1) % count) {
      visited[s] = true;
      relation.push_back(s);
    }
  }
  return result;
}

}  // namespace

PolygonSides polygon_sides(const Surface& surface) { return polygon_sides(surface, Tree(surface)); }

ById<TileId, Word> polygon_paths(const Surface& surface) { return Tree(surface).path; }

FundamentalPolygon fundamental_polygon(const Surface& surface) {
  const Tree tree(surface);
  PolygonSides polygon = polygon_sides(surface, tree);
  FundamentalPolygon result;
  std::optional<TileId> tile;
  Isometry<Rational> to_root;
  for (std::size_t k = 0; k < polygon.side.size(); ++k) {
    const SideId s = polygon.side[k];
    const TileId here = surface.tile_of_side(s);
    const SideId there = surface.partner(s);
    const Word& way = tree.path[surface.tile_of_side(there)];
    // The path leads from tile 0 to the tile beyond, back across the side, and back to tile 0.
    Word word = way;
    word.push_back(there);
    const Word home = reversed(surface, tree.path[here]);
    word.insert(word.end(), home.begin(), home.end());
    result.sides.push_back({std::move(word), polygon.partner[k], s});
    const Complex<Rational>& corner = surface.tile(here)[surface.place_in_tile(s)];
    if (!surface.is_rational()) {
      result.vertices.push_back(rounded_from(surface, tree.path[here], corner));
      continue;
    }
    if (tile != here) {
      to_root = inverse(exact_isometry(surface, tree.path[here]));
      tile = here;
    }
    result.vertices.push_back(to_root(corner));
  }
  result.relations = std::move(polygon.relations);
  return result;
}

namespace {

/// The cyclic word from just behind a place to just before it.
SidesOfPolygon rest(const SidesOfPolygon& word, std::size_t place) {
  SidesOfPolygon result(word.begin() + static_cast<std::ptrdiff_t>(place) + 1, word.end());
  result.insert(result.end(), word.begin(), word.begin() + static_cast<std::ptrdiff_t>(place));
  return result;
}

std::size_t place_of(const SidesOfPolygon& word, std::uint32_t letter) {
  return static_cast<std::size_t>(std::find(word.begin(), word.end(), letter) - word.begin());
}

}  // namespace

SidesOfPolygon inverse_of(const PolygonSides& polygon, SidesOfPolygon word) {
  std::reverse(word.begin(), word.end());
  for (std::uint32_t& k : word) k = polygon.partner[k];
  return word;
}

OneRelator::OneRelator(const PolygonSides& polygon) {
  std::vector<SidesOfPolygon> relations = polygon.relations;
  std::vector<std::size_t> relation_of(polygon.side.size());
  for (std::size_t r = 0; r < relations.size(); ++r) {
    for (const std::uint32_t k : relations[r]) relation_of[k] = r;
  }
  for (std::uint32_t k = 0; k < polygon.side.size(); ++k) {
    const std::size_t r = relation_of[k];
    const std::size_t other = relation_of[polygon.partner[k]];
    if (r == other) continue;
    // k P = 1 in one and k⁻¹ Q = 1 in the other: k = P⁻¹, and P Q = 1 is left.
    SidesOfPolygon merged = rest(relations[r], place_of(relations[r], k));
    expressed.push_back({k, inverse_of(polygon, merged)});
    const SidesOfPolygon q = rest(relations[other], place_of(relations[other], polygon.partner[k]));
    merged.insert(merged.end(), q.begin(), q.end());
    relations[other].clear();
    for (const std::uint32_t letter : merged) relation_of[letter] = r;
    relations[r] = std::move(merged);
    relation_of[k] = relation_of[polygon.partner[k]] = r;
  }
  relation = *std::find_if(relations.begin(), relations.end(), [](const auto& word) { return !word.empty(); });
}

namespace {

using certify::ExactIsometry;
using certify::Gaussian;
using Numeric = Isometry<Mp256>;

/// ½ tr of f ∘ g, of pairs that need not have a positive determinant.
mpz_class half_trace(const ExactIsometry& f, const ExactIsometry& g) {
  return f.a.re * g.a.re - f.a.im * g.a.im + f.b.re * g.b.re + f.b.im * g.b.im;
}

ExactIsometry scaled(const mpz_class& factor, const ExactIsometry& f) { return {factor * f.a, factor * f.b}; }

ExactIsometry difference(const ExactIsometry& f, const ExactIsometry& g) { return {f.a - g.a, f.b - g.b}; }

ExactIsometry rounded_to(const Numeric& f, unsigned bits) {
  const auto integer = [&](const Mp256& x) {
    const Mp256 scaled_x = round(boost::multiprecision::ldexp(x, static_cast<int>(bits)));
    mpz_class result;
    mpfr_get_z(result.get_mpz_t(), scaled_x.backend().data(), MPFR_RNDN);
    return result;
  };
  return {{integer(f.a.x), integer(f.a.y)}, {integer(f.b.x), integer(f.b.y)}};
}

/// The relation as x u x⁻¹ v, and u and v as u₁ y u₂ and v₁ y⁻¹ v₂.
struct Split {
  SurfaceRelation u1, u2, v1, v2;
  std::int32_t x = 0;
  std::int32_t y = 0;
};

Split split(const SurfaceRelation& relation) {
  Split result;
  result.x = relation.front();
  const auto back = std::find(relation.begin(), relation.end(), -result.x);
  // A vertex of its own would be between x and x⁻¹ if every letter there occurred twice there.
  const auto other = std::find_if(relation.begin() + 1, back, [&](std::int32_t letter) {
    return std::find(back, relation.end(), -letter) != relation.end();
  });
  result.y = *other;
  const auto inverse_of_y = std::find(back, relation.end(), -result.y);
  result.u1.assign(relation.begin() + 1, other);
  result.u2.assign(other + 1, back);
  result.v1.assign(back + 1, inverse_of_y);
  result.v2.assign(inverse_of_y + 1, relation.end());
  return result;
}

template <class Element>
Element letter_value(const std::vector<Element>& generators, std::int32_t letter) {
  using certify::inverse;
  const Element& f = generators[static_cast<std::size_t>(std::abs(letter)) - 1];
  return letter > 0 ? f : inverse(f);
}

/// The product of letters, the first one on the left.
ExactIsometry product(const std::vector<ExactIsometry>& generators, const SurfaceRelation& letters) {
  ExactIsometry result = certify::exact_identity();
  for (const std::int32_t letter : letters) result = certify::compose(result, letter_value(generators, letter));
  return result;
}

Numeric product(const std::vector<Numeric>& generators, const SurfaceRelation& letters) {
  Numeric result{{Mp256(1), Mp256(0)}, {Mp256(0), Mp256(0)}};
  for (const std::int32_t letter : letters) result = result * letter_value(generators, letter);
  return result;
}

void set_letter(std::vector<ExactIsometry>& generators, std::int32_t letter, ExactIsometry f) {
  certify::reduce(f);
  generators[static_cast<std::size_t>(std::abs(letter)) - 1] = letter > 0 ? f : certify::inverse(f);
}

/// The pair nearest to y, up to scale, with L(y) = 0 for the linear form ½ tr(y ∘ form).
ExactIsometry projected(const ExactIsometry& y, const ExactIsometry& form) {
  const ExactIsometry normal{{form.a.re, -form.a.im}, form.b};
  const mpz_class square = certify::norm(normal.a) + certify::norm(normal.b);
  return difference(scaled(square, y), scaled(half_trace(y, form), normal));
}

/// Solves a symmetric or any other regular system by elimination with pivots. rows: coefficients, then the right side.
std::vector<Mp256> solve(std::vector<std::vector<Mp256>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (abs(rows[i][k]) > abs(rows[pivot][k])) pivot = i;
    }
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      if (rows[i][k] == 0) continue;
      const Mp256 factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::vector<Mp256> result(n);
  for (std::size_t k = n; k-- > 0;) {
    Mp256 rest = rows[k][n];
    for (std::size_t j = k + 1; j < n; ++j) rest -= rows[k][j] * result[j];
    result[k] = rest / rows[k][k];
  }
  return result;
}

/// The product of two vectors of the same length.
Mp256 scalar_product(const std::vector<Mp256>& v, const std::vector<Mp256>& w) {
  Mp256 sum(0);
  for (std::size_t i = 0; i < v.size(); ++i) sum += v[i] * w[i];
  return sum;
}

/// An isometry near 1: number `direction` of three.
Numeric nudge(std::size_t direction, const Mp256& size) {
  const Mp256 zero(0);
  const Complex<Mp256> a{Mp256(1), direction == 0 ? size : zero};
  return normalized(Numeric{a, {direction == 1 ? size : zero, direction == 2 ? size : zero}});
}

}  // namespace

std::vector<ExactIsometry> rational_solution(const std::vector<Numeric>& generators, const SurfaceRelation& relation,
                                             unsigned bits) {
  std::vector<ExactIsometry> result;
  result.reserve(generators.size());
  for (const Numeric& f : generators) result.push_back(rounded_to(f, bits));
  const Split parts = split(relation);
  // Traces of u and v are those of yA and yB⁻¹.
  SurfaceRelation around = parts.u2;
  around.insert(around.end(), parts.u1.begin(), parts.u1.end());
  const ExactIsometry a = product(result, around);
  around = parts.v2;
  around.insert(around.end(), parts.v1.begin(), parts.v1.end());
  const ExactIsometry b = certify::inverse(product(result, around));
  // Each of the other generators occurs twice in both together, so this root is an integer.
  const mpz_class determinant_b = certify::determinant(b);
  const mpz_class root = sqrt(mpz_class(certify::determinant(a) * determinant_b));
  const ExactIsometry y = letter_value(result, parts.y);
  const int sign = sgn(half_trace(y, a)) * sgn(half_trace(y, b));
  set_letter(result, parts.y, projected(y, difference(scaled(determinant_b, a), scaled(sign * root, b))));

  SurfaceRelation letters = parts.u1;
  letters.push_back(parts.y);
  letters.insert(letters.end(), parts.u2.begin(), parts.u2.end());
  ExactIsometry u = product(result, letters);
  letters = parts.v1;
  letters.push_back(-parts.y);
  letters.insert(letters.end(), parts.v2.begin(), parts.v2.end());
  ExactIsometry w = certify::inverse(product(result, letters));
  // With equal traces and determinants wX − Xu⁻ is a solution x for every X, with u⁻ = tr u − u; the given x itself for
  // X = x(u − u⁻)⁻¹, if it is one.
  const mpz_class trace_u = u.a.re;
  const mpz_class trace_w = w.a.re;
  u = scaled(trace_w, u);
  w = scaled(trace_u, w);
  const ExactIsometry traceless{{0, u.a.im}, u.b};
  const ExactIsometry start = certify::compose(letter_value(result, parts.x), traceless);
  set_letter(result, parts.x, difference(certify::compose(w, start), certify::compose(start, certify::inverse(u))));
  return result;
}

std::vector<Numeric> nearest_solution(std::vector<Numeric> generators, const SurfaceRelation& relation,
                                      const std::vector<Numeric>& targets,
                                      const std::function<std::vector<Numeric>(const std::vector<Numeric>&)>& words) {
  constexpr int kSteps = 4;
  const Mp256 small = boost::multiprecision::ldexp(Mp256(1), -80);
  const auto components = [](const Numeric& f) { return std::array<Mp256, 4>{f.a.x, f.a.y, f.b.x, f.b.y}; };
  // Differences from the targets, of both pairs (a, b) and (−a, −b) the nearer one; then the relation.
  const std::size_t residuals = 4 * targets.size();
  const auto errors = [&](const std::vector<Numeric>& values) {
    std::vector<Mp256> result;
    const std::vector<Numeric> elements = words(values);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const auto found = components(elements[i]);
      const auto given = components(targets[i]);
      Mp256 agreement(0);
      for (std::size_t k = 0; k < found.size(); ++k) agreement += found[k] * given[k];
      for (std::size_t k = 0; k < found.size(); ++k) {
        result.push_back(agreement > 0 ? Mp256(found[k] - given[k]) : Mp256(-found[k] - given[k]));
      }
    }
    const Numeric one = product(values, relation);
    for (const Mp256& part : {one.a.y, one.b.x, one.b.y}) result.push_back(one.a.x > 0 ? part : Mp256(-part));
    return result;
  };
  const std::size_t unknowns = 3 * generators.size();
  for (int step = 0; step < kSteps; ++step) {
    const std::vector<Mp256> now = errors(generators);
    std::vector<std::vector<Mp256>> columns;
    std::vector<std::vector<Mp256>> constraints;
    for (std::size_t j = 0; j < unknowns; ++j) {
      std::vector<Numeric> moved = generators;
      moved[j / 3] = moved[j / 3] * nudge(j % 3, small);
      std::vector<Mp256> column = errors(moved);
      for (std::size_t i = 0; i < column.size(); ++i) column[i] = (column[i] - now[i]) / small;
      constraints.emplace_back(column.begin() + static_cast<std::ptrdiff_t>(residuals), column.end());
      column.resize(residuals);
      columns.push_back(std::move(column));
    }
    // The least squares under linear conditions, by Lagrange's multipliers.
    const std::vector<Mp256> difference(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(residuals));
    std::vector<std::vector<Mp256>> rows(unknowns + 3, std::vector<Mp256>(unknowns + 4));
    for (std::size_t j = 0; j < unknowns; ++j) {
      for (std::size_t k = 0; k < unknowns; ++k) rows[j][k] = scalar_product(columns[j], columns[k]);
      for (std::size_t k = 0; k < 3; ++k) rows[j][unknowns + k] = rows[unknowns + k][j] = constraints[j][k];
      rows[j].back() = -scalar_product(columns[j], difference);
    }
    for (std::size_t k = 0; k < 3; ++k) rows[unknowns + k].back() = -now[residuals + k];
    const std::vector<Mp256> moves = solve(std::move(rows));
    for (std::size_t j = 0; j < unknowns; ++j) {
      Numeric& f = generators[j / 3];
      f = normalized(f * nudge(j % 3, moves[j]));
    }
  }
  return generators;
}

}  // namespace epsnet
