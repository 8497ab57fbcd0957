#include "triangulation/surface/exact_polygons.h"

#include <cassert>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <utility>

namespace epsnet {

ScaledPoint scaled(const Complex<Rational>& z) {
  const Integer x_denominator = denominator(z.x);
  const Integer y_denominator = denominator(z.y);
  // Often they are equal, and then no gcd is needed.
  if (x_denominator == y_denominator) return {{numerator(z.x), numerator(z.y)}, x_denominator};
  const Integer m = lcm(x_denominator, y_denominator);
  return {{numerator(z.x) * (m / x_denominator), numerator(z.y) * (m / y_denominator)}, m};
}

Integer disk_gap(const ScaledPoint& z) { return z.m * z.m - norm(z.n); }

Complex<Integer> scaled_difference(const ScaledPoint& p, const ScaledPoint& q) { return q.m * p.n - p.m * q.n; }

GaussianFraction seen_from(const ScaledPoint& p, const ScaledPoint& z) {
  return {scaled_difference(z, p), Complex<Integer>{p.m * z.m, 0} - conj(p.n) * z.n};
}

KleinVector klein(const ScaledPoint& z) {
  const Integer twice = 2 * z.m;
  return {twice * z.n.x, twice * z.n.y, z.m * z.m + norm(z.n)};
}

int orientation(const KleinVector& p, const KleinVector& q, const KleinVector& r) {
  return sign(lorentz_product(lorentz_cross(p, q), r));
}

bool lexicographically_less(const KleinVector& p, const KleinVector& q) {
  const int x = sign(Integer(p.x * q.t - q.x * p.t));
  return x != 0 ? x < 0 : p.y * q.t < q.y * p.t;
}

Isometry<Rational> integral_crossing(const ScaledPoint& p, const ScaledPoint& q, const ScaledPoint& p2,
                                     const ScaledPoint& q2) {
  // With p and p2 moved to 0 the segments end in u/v and u2/v2 with the same modulus, so the rotation that remains has
  // the argument of `turn` = ū v u2 v̄2. Its half angle is that of |turn| + turn, and |turn| = |u|²|v2|² is an integer.
  const auto [u, v] = seen_from(p, q);
  const auto [u2, v2] = seen_from(p2, q2);
  assert(norm(u) != 0 && norm(u) * norm(v2) == norm(u2) * norm(v));
  const Complex<Integer> turn = (conj(u) * v) * (u2 * conj(v2));
  Complex<Integer> half{norm(u) * norm(v2) + turn.x, turn.y};
  // A half turn: z ↦ −z is (i z)/(−i).
  if (half == Complex<Integer>{0, 0}) half = {0, 1};
  // Only its direction counts; smaller numbers are faster from here on.
  const Integer excess = gcd(half.x, half.y);
  half.x /= excess;
  half.y /= excess;
  Complex<Integer> a = (p2.m * p.m) * half - (p2.n * conj(p.n)) * conj(half);
  Complex<Integer> b = p.m * (p2.n * conj(half)) - p2.m * (p.n * half);
  const Integer content = gcd(gcd(a.x, a.y), gcd(b.x, b.y));
  for (Integer* coefficient : {&a.x, &a.y, &b.x, &b.y}) *coefficient /= content;
  return {convert<Rational>(a), convert<Rational>(b)};
}

namespace {

constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();
constexpr SideId kNoSide(kUnset);
constexpr double kTurn = 2 * std::numbers::pi;

std::string decimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

/// sinh² of half the distance of p and q, as numerator and denominator.
struct Fraction {
  Integer numerator;
  Integer denominator;
};

Fraction squared_sinh_of_half(const ScaledPoint& p, const ScaledPoint& q) {
  return {norm(scaled_difference(p, q)), disk_gap(p) * disk_gap(q)};
}

double length(const Fraction& fraction) {
  using std::asinh;
  using std::sqrt;
  return static_cast<double>(Mp256(2) * asinh(sqrt(Mp256(fraction.numerator) / Mp256(fraction.denominator))));
}

/// The argument of a Gaussian integer, in [0, 2π), to within 2⁻⁵⁰. The sign of the imaginary part is exact, so angles
/// near 0 and near 2π are told apart whatever the size of the numbers.
double argument(const Complex<Integer>& u) {
  long x_exponent = 0;
  long y_exponent = 0;
  const double x = mpz_get_d_2exp(&x_exponent, u.x.backend().data());
  const double y = mpz_get_d_2exp(&y_exponent, u.y.backend().data());
  // Scaled by the larger exponent; what underflows then is far below the error.
  const long common = u.x == 0 ? y_exponent : u.y == 0 ? x_exponent : std::max(x_exponent, y_exponent);
  const auto shifted = [common](double mantissa, long exponent) {
    return std::ldexp(mantissa, static_cast<int>(std::max(exponent - common, -4000L)));
  };
  const double positive = std::atan2(std::fabs(shifted(y, y_exponent)), shifted(x, x_exponent));
  return u.y < 0 ? kTurn - positive : positive;
}

/// The product, as a balanced tree: quasi-linear in the number of digits. Consumes the factors.
Complex<Integer> product(std::vector<Complex<Integer>>&& factors) {
  while (factors.size() > 1) {
    const std::size_t half = factors.size() / 2;
    for (std::size_t i = 0; i < half; ++i) factors[i] = factors[2 * i] * factors[2 * i + 1];
    if (factors.size() % 2 != 0) {
      factors[half] = std::move(factors.back());
      factors.resize(half + 1);
    } else {
      factors.resize(half);
    }
  }
  return std::move(factors.front());
}

/// A positive multiple of the direction at p in which q lies, as seen after p was moved to 0 by z ↦ (z−p)/(1−p̄z). 0 if
/// and only if p = q.
Complex<Integer> direction(const ScaledPoint& p, const ScaledPoint& q) {
  const GaussianFraction seen = seen_from(p, q);
  return seen.n * conj(seen.d);
}

/// The direction from p to q in the Klein model lies in the upper half of the circle, [0, π).
bool points_up(const KleinVector& p, const KleinVector& q) {
  const int y = sign(Integer(q.y * p.t - p.y * q.t));
  return y != 0 ? y > 0 : q.x * p.t > p.x * q.t;
}

}  // namespace

GluedPolygons::GluedPolygons(const std::vector<Tile>& tiles, const std::vector<Gluing>& gluing) : tiles_(tiles) {
  number_sides();
  pair_sides(gluing);
  check_connected();
  number_vertices();
  const auto euler = static_cast<std::int64_t>(sides_.vertex_class_sizes.size()) -
                     static_cast<std::int64_t>(sides_.side_tile.size() / 2) + static_cast<std::int64_t>(tiles_.size());
  if (euler == 2) throw SurfaceError("the gluing is a sphere (genus 0); a hyperbolic surface has genus at least 2");
  if (euler == 0) throw SurfaceError("the gluing is a torus (genus 1); a hyperbolic surface has genus at least 2");
  genus_ = static_cast<std::uint32_t>((2 - euler) / 2);
}

std::string GluedPolygons::tile_name(TileId t) const {
  return tiles_.size() == 1 ? "the polygon" : "tile " + to_string(t);
}

std::string GluedPolygons::name(const char* element, SideId side) const {
  const std::string own = element + (" " + std::to_string(sides_.place_in_tile(side)));
  return tiles_.size() == 1 ? own : tile_name(sides_.side_tile[side]) + ", " + own;
}

void GluedPolygons::number_sides() {
  if (tiles_.empty()) throw SurfaceError("there is no tile");
  for (const Tile& tile : tiles_) {
    const TileId t = sides_.first_side.end_id();
    if (tile.size() < 3) {
      throw SurfaceError(tile_name(t) + " has " + std::to_string(tile.size()) + " vertices, expected at least 3");
    }
    // Darts and words number sides with 32 bits; one value stands for "none".
    if (tile.size() >= kUnset - sides_.side_tile.size()) throw SurfaceError("there are more than 2^32 - 2 sides");
    sides_.first_side.push_back(sides_.side_tile.end_id());
    sides_.side_tile.insert(sides_.side_tile.end(), tile.size(), t);
  }
}

void GluedPolygons::pair_sides(const std::vector<Gluing>& gluing) {
  sides_.partner.assign(sides_.side_tile.size(), kNoSide);
  const auto number = [&](std::uint32_t tile_number, std::uint32_t side, std::size_t pair) {
    if (tile_number >= tiles_.size()) {
      throw SurfaceError("pair " + std::to_string(pair) + " of the gluing names tile " + std::to_string(tile_number) +
                         ", but there are only " + std::to_string(tiles_.size()));
    }
    const TileId t(tile_number);
    if (side >= tile(t).size()) {
      throw SurfaceError("pair " + std::to_string(pair) + " of the gluing names side " + std::to_string(side) + " of " +
                         tile_name(t) + ", which has only " + std::to_string(tile(t).size()) + " sides");
    }
    return SideId(sides_.first_side[t].number() + side);
  };
  for (std::size_t i = 0; i < gluing.size(); ++i) {
    const SideId s = number(gluing[i].tile, gluing[i].side, i);
    const SideId other = number(gluing[i].other_tile, gluing[i].other_side, i);
    if (s == other) throw SurfaceError(name("side", s) + " is paired with itself");
    for (const SideId used : {s, other}) {
      if (sides_.partner[used] != kNoSide) throw SurfaceError(name("side", used) + " occurs twice in the gluing");
    }
    sides_.partner[s] = other;
    sides_.partner[other] = s;
  }
  for (const SideId s : side_ids()) {
    if (sides_.partner[s] == kNoSide) throw SurfaceError(name("side", s) + " is not paired with any side");
  }
}

void GluedPolygons::check_connected() const {
  ById<TileId, bool> reached(tiles_.size());
  std::vector<TileId> pending{TileId(0)};
  reached[TileId(0)] = true;
  while (!pending.empty()) {
    const TileId t = pending.back();
    pending.pop_back();
    for (const SideId s : sides_of(t)) {
      const TileId neighbour = sides_.side_tile[sides_.partner[s]];
      if (reached[neighbour]) continue;
      reached[neighbour] = true;
      pending.push_back(neighbour);
    }
  }
  for (const TileId t : tile_ids()) {
    if (!reached[t]) {
      throw SurfaceError("the surface is not connected: no path of glued sides leads from tile 0 to " + tile_name(t));
    }
  }
}

void GluedPolygons::number_vertices() {
  sides_.vertex_class.assign(sides_.side_tile.size(), kUnset);
  for (const SideId first : side_ids()) {
    if (sides_.vertex_class[first] != kUnset) continue;
    const auto number = static_cast<std::uint32_t>(sides_.vertex_class_sizes.size());
    sides_.vertex_class_sizes.push_back(0);
    // Side s starts at the vertex; across it the vertex is where the partner ends, which is where the next side starts.
    for (SideId s = first; sides_.vertex_class[s] == kUnset; s = next(sides_.partner[s])) {
      sides_.vertex_class[s] = number;
      ++sides_.vertex_class_sizes[number];
    }
  }
}

void GluedPolygons::check_vertices() {
  point_.reserve(sides_.side_tile.size());
  klein_.reserve(sides_.side_tile.size());
  for (const Tile& tile : tiles_) {
    for (const Complex<Rational>& vertex : tile) {
      point_.push_back(scaled(vertex));
      if (disk_gap(point_.back()) > 0) {
        klein_.push_back(klein(point_.back()));
        continue;
      }
      const SideId corner(point_.size() - 1);
      const double modulus = static_cast<double>(sqrt(Mp256(norm(vertex))));
      throw SurfaceError(name("vertex", corner) + (norm(vertex) == 1 ? " lies on" : " lies outside of") +
                         " the unit circle, expected |z| < 1" +
                         (modulus > 1 ? ", found |z| = " + decimal(modulus) : std::string()));
    }
  }
  corner_.reserve(sides_.side_tile.size());
  for (const SideId s : side_ids()) {
    const Complex<Integer> forward = direction(point_[s], point_[next(s)]);
    if (forward == Complex<Integer>{0, 0}) {
      throw SurfaceError(name("side", s) + " has length 0: its two vertices are the same point");
    }
    corner_.push_back(direction(point_[s], point_[previous(s)]) * conj(forward));
  }
}

double GluedPolygons::angle(SideId corner) const { return argument(corner_[corner]); }

bool GluedPolygons::clockwise(TileId t) const {
  // At the leftmost vertex a simple polygon turns the way it goes around.
  SideId extreme = sides_.first_side[t];
  for (const SideId corner : sides_of(t)) {
    if (lexicographically_less(klein_[corner], klein_[extreme])) extreme = corner;
  }
  return corner_[extreme].y < 0;
}

std::optional<std::string> GluedPolygons::convexity_problem() const {
  for (const TileId t : tile_ids()) {
    if (clockwise(t)) return tile_name(t) + " is clockwise: the vertices must be listed counterclockwise";
    std::uint32_t windings = 0;
    for (const SideId s : sides_of(t)) {
      if (!strictly_convex(s)) {
        return tile_name(t) + " is not strictly convex at its vertex " + std::to_string(sides_.place_in_tile(s)) +
               " (interior angle " + decimal(angle(s)) + ")";
      }
      // With left turns only, the direction of the sides turns through the half circle [0, π) once per winding.
      const SideId n = next(s);
      windings += points_up(klein_[s], klein_[n]) && !points_up(klein_[n], klein_[next(n)]) ? 1 : 0;
    }
    if (windings != 1) {
      return tile_name(t) + " intersects itself: it winds around " + std::to_string(windings) + " times";
    }
  }
  return std::nullopt;
}

void GluedPolygons::check_convex() const {
  if (const auto problem = convexity_problem()) throw SurfaceError(*problem);
}

void GluedPolygons::check_lengths() const {
  for (const SideId s : side_ids()) {
    const SideId other = sides_.partner[s];
    if (other < s) continue;
    const Fraction own = squared_sinh_of_half(point_[s], point_[next(s)]);
    const Fraction glued = squared_sinh_of_half(point_[other], point_[next(other)]);
    if (own.numerator * glued.denominator == glued.numerator * own.denominator) continue;
    const std::string first = decimal(length(own));
    const std::string second = decimal(length(glued));
    std::string message = name("side", s) + " (length " + first + ") and ";
    message += name("side", other) + " (length " + second + ") are paired but differ";
    if (first == second) message += " in later digits";
    throw SurfaceError(message);
  }
}

void GluedPolygons::check_angles() const {
  ById<SideId, bool> visited(sides_.side_tile.size());
  std::vector<Complex<Integer>> factors;
  for (const SideId first : side_ids()) {
    if (visited[first]) continue;
    factors.clear();
    double sum = 0;
    for (SideId s = first; !visited[s]; s = next(sides_.partner[s])) {
      visited[s] = true;
      factors.push_back(corner_[s]);
      sum += angle(s);
    }
    const std::string place = "the " + std::to_string(factors.size()) + " angles around " + name("vertex", first);
    const Complex<Integer> whole = product(std::move(factors));
    // Near 2π the computed sum of less than 2³² angles is within 2⁻¹⁶ of the true one, far less than the half turn that
    // separates multiples of 2π.
    const double turns = std::round(sum / kTurn);
    if (whole.y != 0 || whole.x < 0) {
      const double rest = whole.y < 0 ? -argument(conj(whole)) : argument(whole);
      throw SurfaceError(place + " add up to " + decimal(turns * kTurn + rest) + ", not to 2*pi = 6.283185307" +
                         (turns == 1 ? " (off by " + decimal(rest) + ")" : std::string()));
    }
    if (turns != 1) {
      throw SurfaceError(place + " add up to " + decimal(turns) +
                         " full turns, expected one: the surface has a cone point there");
    }
  }
}

}  // namespace epsnet
