#include <algorithm>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/net/structure.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/isometry.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

/// Bits for sums of angles: 2⁻⁶⁴ for each of at most 2³² angles is far less than the quarter turn that matters.
constexpr slong kAnglePrecision = 128;

/// Bits for the radius of a regular polygon's inscribed circle, which is only compared with what is 0 or twice as
/// large.
constexpr slong kApothemPrecision = 128;

/// Bits of the first attempt to find an inscribed disk.
constexpr slong kFirstDiskPrecision = 128;

/// Why the surface is none, or why that is not known.
struct Objection {
  // NOLINTNEXTLINE(google-explicit-constructor): most objections are words alone.
  Objection(std::string words, Verdict so = Verdict::refuted) : text(std::move(words)), verdict(so) {}
  std::string text;
  Verdict verdict;
};
using MaybeObjection = std::optional<Objection>;
using ExactTile = std::vector<ExactPoint>;

ExactTile exact_tile(const SurfaceDocument::Tile& tile, const Budget& budget) {
  ExactTile result;
  for (const RationalPoint& vertex : tile) {
    budget.spend(exact_point_work(vertex));
    result.push_back(exact_point(vertex));
  }
  return result;
}

/// The first problem among problem(0), …, problem(count − 1), which do not depend on each other.
template <class Find>
MaybeObjection first_problem(std::size_t count, unsigned threads, const Find& problem) {
  std::vector<MaybeObjection> problems(count);
  for_each_parallel(count, threads, [&](unsigned, std::size_t i) { problems[i] = problem(i); });
  const auto found =
      std::find_if(problems.begin(), problems.end(), [](const MaybeObjection& p) { return p.has_value(); });
  return found != problems.end() ? std::move(*found) : std::nullopt;
}

std::string named(const char* what, std::size_t index) { return std::string(what) + " " + std::to_string(index); }

/// "vertex 1 of tile 0": a side, or the vertex that it leaves.
std::string named(const char* what, const SurfaceSides& sides, std::size_t side) {
  return named(what, sides.corner[side]) + " of " + named("tile", sides.tile[side]);
}

MaybeObjection connection_problem(const SurfaceSides& sides) {
  const auto missing = first_unreached(sides.first.size(), [&](std::uint32_t t, const auto& visit) {
    std::uint32_t s = sides.first[t];
    do {
      visit(sides.tile[sides.partner[s]]);
      s = sides.next[s];
    } while (s != sides.first[t]);
  });
  if (!missing) return std::nullopt;
  return "the surface is not connected: no path of glued sides leads from tile 0 to " + named("tile", *missing);
}

std::int64_t euler_characteristic(const SurfaceSides& sides, std::size_t vertices) {
  return static_cast<std::int64_t>(vertices + sides.first.size()) - static_cast<std::int64_t>(sides.partner.size() / 2);
}

/// The tile is a strictly convex polygon of the disk, counterclockwise.
///
/// Seen from vertex 0, the others turn strictly counterclockwise and stay within a half-turn from vertex 1 on: then the
/// polygon is simple. With a left turn at every vertex a simple polygon is strictly convex. (Left turns alone would let
/// pass polygons that wind twice.) Signs of determinants in the hyperboloid model, so lines are hyperbolic lines.
template <class Real>
MaybeObjection convexity_problem(const std::vector<HyperboloidVector<Real>>& v, std::size_t t) {
  const std::size_t n = v.size();
  const std::string tile_name = named("tile", t) + " is not strictly convex and counterclockwise: ";
  for (std::size_t k = 0; k < n; ++k) {
    if (orientation(v[k], v[(k + 1) % n], v[(k + 2) % n]) <= 0) {
      return tile_name + "no left turn at its vertex " + std::to_string((k + 1) % n);
    }
  }
  for (std::size_t k = 2; k < n; ++k) {
    if (orientation(v[0], v[1], v[k]) <= 0) return tile_name + named("vertex", k) + " is right of side 0";
    if (k + 1 < n && orientation(v[0], v[k], v[k + 1]) <= 0) {
      return tile_name + named("vertex", k + 1) + " does not follow " + named("vertex", k) + " around vertex 0";
    }
  }
  return std::nullopt;
}

/// |p−q|²/((1−|p|²)(1−|q|²)) as numerator and denominator: sinh² of half the distance.
struct Fraction {
  mpz_class numerator;
  mpz_class denominator;
};

Fraction length(const ExactPoint& p, const ExactPoint& q) { return {norm(q.m * p.n - p.m * q.n), gap(p) * gap(q)}; }

/// The interior angle at v between the directions of `next` (first) and `previous` (second), counterclockwise.
Ball interior_angle(const ExactPoint& v, const ExactPoint& next, const ExactPoint& previous) {
  // Take v to 0; the angle is that of the quotient of the two images, a positive multiple of which is in Z[i].
  const ExactIsometry to_origin = inverse(translation_to(v));
  const MovedPoint<Gaussian> from = moved(to_origin, next);
  const MovedPoint<Gaussian> to = moved(to_origin, previous);
  const Gaussian quotient = to.n * from.d * conjugate(to.d * from.n);
  return atan2(Ball::rounded(quotient.im), Ball::rounded(quotient.re));
}

/// What is particular to tiles with rational vertices.
class RationalTiles {
 public:
  RationalTiles(const SurfaceDocument& surface, const SurfaceSides& sides, const Budget& budget)
      : sides_(sides), budget_(budget), crossings_(sides.partner.size()) {
    for (const SurfaceDocument::Tile& tile : surface.tiles) tiles_.push_back(exact_tile(tile, budget));
  }

  /// Three determinants of three vectors, and a crossing and an angle, for each corner: numbers of some four times the
  /// bits of a vertex, and two greatest common divisors.
  void spend_on_corners(std::size_t t) const {
    for (const ExactPoint& vertex : tiles_[t]) budget_.spend(100 * product_work(4 * bits(vertex)));
  }
  [[nodiscard]] bool is_point(std::size_t t, std::size_t k) const { return gap(tiles_[t][k]) > 0; }
  static constexpr const char* kNoPoint = "not inside the unit disk";
  [[nodiscard]] std::vector<HyperboloidVector<mpz_class>> vectors(std::size_t t) const {
    std::vector<HyperboloidVector<mpz_class>> result;
    result.reserve(tiles_[t].size());
    for (const ExactPoint& vertex : tiles_[t]) result.push_back(hyperboloid_vector(vertex));
    return result;
  }
  /// Makes the crossings of two sides that are glued; false if they are not of equal length.
  bool cross(std::size_t s, std::size_t other) {
    const Fraction own = length(start(s), end(s));
    const Fraction glued = length(start(other), end(other));
    if (own.numerator * glued.denominator != glued.numerator * own.denominator) return false;
    crossings_[s] = crossing(start(s), end(s), start(other), end(other));
    crossings_[other] = inverse(crossings_[s]);
    return true;
  }
  static constexpr const char* kNoCrossing = "which is not of equal length";
  /// Whether the product of crossings, the first one first, is the identity.
  [[nodiscard]] bool closes_up(const std::vector<std::uint32_t>& path) const {
    std::vector<const ExactIsometry*> factors;
    // A tree of products; each of its levels has all the bits.
    std::size_t path_bits = 0;
    for (const std::uint32_t s : path) {
      factors.push_back(&crossings_[s]);
      path_bits += bits(crossings_[s]);
    }
    budget_.spend(8 * product_work(path_bits), static_cast<std::uint64_t>(std::bit_width(path.size())));
    return is_identity(compose_path(factors));
  }
  [[nodiscard]] Ball angle(std::size_t s) const { return interior_angle(start(s), end(s), start(sides_.previous[s])); }
  [[nodiscard]] Crossings crossings() { return RationalCrossings(std::move(crossings_)); }

 private:
  [[nodiscard]] const ExactPoint& start(std::size_t side) const {
    return tiles_[sides_.tile[side]][sides_.corner[side]];
  }
  [[nodiscard]] const ExactPoint& end(std::size_t side) const { return start(sides_.next[side]); }

  const SurfaceSides& sides_;
  const Budget& budget_;
  std::vector<ExactTile> tiles_;
  std::vector<ExactIsometry> crossings_;
};

using FieldVector = HyperboloidVector<FieldNumber>;

/// What is particular to tiles over a number field (docs/proof/regular-surfaces.md, section 9.1).
class FieldTiles {
 public:
  FieldTiles(const SurfaceDocument& surface, const SurfaceSides& sides, const Budget& budget)
      : surface_(surface),
        sides_(sides),
        field_(std::make_unique<const NumberField>(surface.field.polynomial, surface.field.root, budget)),
        crossings_(sides.partner.size()) {
    for (const SurfaceDocument::Field::Polygon& polygon : surface.field.polygons) {
      for (const auto& [x, y, t] : polygon) vertices_.push_back({number(x), number(y), number(t)});
    }
    for (std::size_t i = 0; i < surface.gluing.size(); ++i) {
      const auto& row = surface.gluing[i];
      const auto& [a, a_im, b, b_im] = surface.field.crossings[i];
      const std::uint32_t s = sides.first[row.tile] + row.side;
      crossings_[s] = {complex_number(a, a_im), complex_number(b, b_im)};
      crossings_[sides.partner[s]] = inverse(crossings_[s]);
    }
  }

  void spend_on_corners(std::size_t /*t*/) const {}  // Numbers do.
  /// T > 0, and the vector is inside of the light cone.
  [[nodiscard]] bool is_point(std::size_t t, std::size_t k) const {
    const FieldVector& v = vertices_[sides_.first[t] + k];
    return sign(v.t) > 0 && sign(product(v, v)) < 0;
  }
  static constexpr const char* kNoPoint = "not inside the light cone";
  [[nodiscard]] std::vector<FieldVector> vectors(std::size_t t) const {
    const auto first = vertices_.begin() + sides_.first[t];
    return {first, first + static_cast<std::ptrdiff_t>(surface_.field.polygons[t].size())};
  }
  /// Whether the crossing of a side is an isometry that takes it to the other one.
  [[nodiscard]] bool cross(std::size_t s, std::size_t other) const {
    const Isometry<FieldNumber>& f = crossings_[s];
    return sign(determinant(f)) > 0 && are_parallel(moved(f, start(s)), end(other)) &&
           are_parallel(moved(f, end(s)), start(other));
  }
  static constexpr const char* kNoCrossing = "to which the crossing does not take it";
  [[nodiscard]] bool closes_up(const std::vector<std::uint32_t>& path) const {
    return is_identity(compose_range(0, path.size(), [&](std::size_t i) { return crossings_[path[i]]; }));
  }
  /// The argument of N⟨n, p⟩ + ⟨v, n⟩⟨v, p⟩ + i√N det(v, n, p), N = −⟨v, v⟩.
  [[nodiscard]] Ball angle(std::size_t s) const {
    const FieldVector& v = start(s);
    const FieldVector& n = end(s);
    const FieldVector& p = start(sides_.previous[s]);
    const FieldNumber minus_square = mpz_class(-1) * product(v, v);
    const FieldNumber real = minus_square * product(n, p) + product(v, n) * product(v, p);
    return atan2(sqrt(real_ball(minus_square)) * real_ball(determinant(v, n, p)), real_ball(real));
  }
  [[nodiscard]] Crossings crossings() { return FieldCrossings(std::move(field_), std::move(crossings_)); }

 private:
  using Coefficients = SurfaceDocument::FieldNumber;
  [[nodiscard]] FieldNumber number(const Coefficients& x) const { return field_number(*field_, x); }
  [[nodiscard]] FieldNumber complex_number(const Coefficients& re, const Coefficients& im) const {
    return {field_.get(), number(re).re, number(im).re};
  }
  static FieldNumber product(const FieldVector& u, const FieldVector& v) { return u.x * v.x + u.y * v.y - u.t * v.t; }
  /// Lemma 9.4: (X′, Y′, T′), twice as long.
  static FieldVector moved(const Isometry<FieldNumber>& f, const FieldVector& v) {
    const FieldNumber w{v.x.field, v.x.re, v.y.re};
    const FieldNumber ab = f.a * f.b;
    const FieldNumber image = f.a * f.a * w + mpz_class(2) * (ab * v.t) + f.b * f.b * conjugate(w);
    return {twice_real(image), twice_imaginary(image),
            mpz_class(2) * ((norm(f.a) + norm(f.b)) * v.t + twice_real(f.a * conjugate(f.b) * w))};
  }
  /// Of vectors inside the light cone, so that T ≠ 0: whether X/T and Y/T are equal.
  static bool are_parallel(const FieldVector& u, const FieldVector& v) {
    return sign(u.x * v.t - u.t * v.x) == 0 && sign(u.y * v.t - u.t * v.y) == 0;
  }
  [[nodiscard]] const FieldVector& start(std::size_t side) const { return vertices_[side]; }
  [[nodiscard]] const FieldVector& end(std::size_t side) const { return vertices_[sides_.next[side]]; }

  const SurfaceDocument& surface_;
  const SurfaceSides& sides_;
  std::unique_ptr<const NumberField> field_;
  std::vector<FieldVector> vertices_;  ///< By the side that starts there.
  std::vector<Isometry<FieldNumber>> crossings_;
};

/// Everything about one surface whose tiles are listed, laid out by side number.
template <class Tiles>
class SurfaceChecker {
 public:
  SurfaceChecker(const SurfaceDocument& surface, unsigned threads, const Budget& budget)
      : sides_(surface), threads_(threads), tiles_(surface, sides_, budget) {}

  SurfaceOutcome check() {
    MaybeObjection problem = first_problem(sides_.first.size(), threads_, [&](std::size_t t) {
      tiles_.spend_on_corners(t);
      return tile_problem(t);
    });
    if (!problem) problem = connection_problem(sides_);
    if (!problem) problem = genus_problem();
    if (!problem) problem = crossing_problem();
    if (!problem) problem = vertex_problem();
    if (problem) return {{"surface", problem->verdict, problem->text}};
    return {{"surface", Verdict::verified,
             "a closed hyperbolic surface of genus " + std::to_string(genus_) + ": " +
                 counted(sides_.first.size(), "convex tile", "convex tiles") + ", " +
                 std::to_string(sides_.partner.size() / 2) + " pairs of sides of exactly equal length, " +
                 counted(vertices_.size(), "vertex cycle that closes up", "vertex cycles that close up") +
                 " exactly with total angle 2*pi"},
            genus_,
            tiles_.crossings()};
  }

 private:
  [[nodiscard]] MaybeObjection tile_problem(std::size_t t) const {
    const auto vectors = tiles_.vectors(t);
    for (std::size_t k = 0; k < vectors.size(); ++k) {
      if (!tiles_.is_point(t, k)) {
        return named("vertex", k) + " of " + named("tile", t) + " is " + Tiles::kNoPoint;
      }
    }
    return convexity_problem(vectors, t);
  }

  MaybeObjection crossing_problem() {
    return first_problem(sides_.partner.size(), threads_, [&](std::size_t s) -> MaybeObjection {
      const std::size_t other = sides_.partner[s];
      if (other < s || tiles_.cross(s, other)) return std::nullopt;
      return named("side", sides_, s) + " is glued to " + named("side", sides_, other) + ", " + Tiles::kNoCrossing;
    });
  }

  [[nodiscard]] MaybeObjection vertex_problem() const {
    return first_problem(vertices_.size(), threads_, [&](std::size_t i) { return problem_around(vertices_[i]); });
  }

  /// Around every vertex the crossings multiply to the identity, exactly, and the angles to one full turn.
  [[nodiscard]] MaybeObjection problem_around(std::uint32_t first) const {
    std::vector<std::uint32_t> path;
    const Precision scope(kAnglePrecision);
    Ball sum;
    std::uint32_t s = first;
    do {
      path.push_back(s);
      sum += tiles_.angle(s);
      s = sides_.next_around(s);
    } while (s != first);
    if (!tiles_.closes_up(path)) {
      return "the " + std::to_string(path.size()) + " corners around " + named("vertex", sides_, first) +
             " do not close up: the product of the crossings is not the identity";
    }
    // The sum is now a positive multiple of 2π; the ball says which. That it does not would be a fault of ours: its
    // bits are far more than that takes.
    const std::optional<slong> turns = only_integer(sum / twice(pi()));
    if (turns == 1) return std::nullopt;
    const std::string count = turns ? std::to_string(*turns) : "an unknown number of";
    return Objection(
        "the angles around " + named("vertex", sides_, first) + " add up to " + count + " full turns, not to one",
        turns ? Verdict::refuted : Verdict::undecided);
  }

  MaybeObjection genus_problem() {
    vertices_ = sides_.vertices();
    const std::int64_t euler = euler_characteristic(sides_, vertices_.size());
    if (euler == 2 || euler == 0) {
      return std::string("the surface is a ") + (euler == 2 ? "sphere" : "torus") + ", expected genus at least 2";
    }
    // An oriented closed connected surface has even characteristic at most 2; anything else is a fault of ours.
    if (euler > 0 || euler % 2 != 0) return "the Euler characteristic is " + std::to_string(euler);
    genus_ = static_cast<std::uint64_t>(1 - euler / 2);
    return std::nullopt;
  }

  SurfaceSides sides_;
  unsigned threads_;
  Tiles tiles_;
  std::vector<std::uint32_t> vertices_;  ///< One side that leaves it for each vertex of the surface.
  std::uint64_t genus_ = 0;
};

/// Lemma 9.2.
MaybeObjection root_problem(const SurfaceDocument::Field& field, const Budget& budget) {
  const auto& [lower, upper] = field.root;
  std::size_t size = 0;
  for (const mpz_class& coefficient : field.polynomial) size += mpz_sizeinbase(coefficient.get_mpz_t(), 2);
  for (const mpq_class& end : field.root) {
    size += field.polynomial.size() * (mpz_sizeinbase(end.get_num_mpz_t(), 2) + mpz_sizeinbase(end.get_den_mpz_t(), 2));
  }
  budget.spend(8 * product_work(size), field.polynomial.size() * field.polynomial.size());
  const std::size_t changes = count_roots(field.polynomial, lower, upper).changes;
  if (changes == 0) return Objection("the polynomial has no root in the interval");
  if (changes == 1) return std::nullopt;
  return Objection(
      "the polynomial may have more than one root in the interval: a shorter one around a simple root decides",
      Verdict::undecided);
}

SurfaceOutcome check_over_field(const SurfaceDocument& surface, unsigned threads, const Budget& budget) {
  if (const MaybeObjection problem = root_problem(surface.field, budget)) {
    return {{"surface", problem->verdict, problem->text}};
  }
  return SurfaceChecker<FieldTiles>(surface, threads, budget).check();
}

/// (2x, 2y, 1 + |z|²) in balls, a positive multiple of the point of the hyperboloid.
BallVector ball_vector(const ExactPoint& z) {
  const HyperboloidVector<mpz_class> v = hyperboloid_vector(z);
  return {Ball::rounded(v.x), Ball::rounded(v.y), Ball::rounded(v.t)};
}

/// Positive multiples of the corners of a tile as points of the hyperboloid.
using BallTile = std::vector<BallVector>;

/// The mean of the tile's vertices in the Klein model, in balls.
std::array<Ball, 2> klein_mean(const BallTile& tile) {
  std::array<Ball, 2> sum;
  for (const BallVector& v : tile) {
    for (std::size_t i = 0; i < 2; ++i) sum[i] += v[i] / v[2];
  }
  return {sum[0] / tile.size(), sum[1] / tile.size()};
}

/// The integer nearest to 2^precision times the midpoint of x; 0 if x is not finite.
mpz_class scaled_to_integer(const Ball& x, slong precision) {
  Integer integer;
  if (is_finite(x)) arf_get_fmpz(integer.get(), arb_midref(scaled(x, precision).get()), ARF_RND_NEAR);
  return integer.value();
}

/// A point inside the tile near the mean of its vertices in the Klein model, with about `precision` bits. Only a good
/// guess is needed, which the caller tests: midpoints do.
ExactPoint approximate_centre(const BallTile& tile, slong precision) {
  std::array<Ball, 2> k = klein_mean(tile);
  for (Ball& x : k) arb_get_mid_arb(x.get(), x.get());
  // From the Klein model to the Poincaré disk.
  const Ball divisor = sqrt_of_nonnegative(1 - (sqr(k[0]) + sqr(k[1]))) + 1;
  mpz_class scale = 1;
  scale <<= static_cast<mp_bitcnt_t>(precision);
  return {{scaled_to_integer(k[0] / divisor, precision), scaled_to_integer(k[1] / divisor, precision)}, scale};
}

/// sinh of the distance of z from the line through p and q, positive on its left: det(p, q, z)/(|p × q| |z|) with the
/// Lorentz norms |p × q|² = ⟨p,q⟩² − ⟨p,p⟩⟨q,q⟩ and |z|² = −⟨z,z⟩ = (1−|z|²)².
Ball sinh_distance(const ExactPoint& z, const BallVector& p, const BallVector& q, slong precision) {
  const BallVector normal = cross_product(p, q, precision);
  Ball determinant;
  dot(determinant, normal, ball_vector(z), precision);
  return determinant / (sqrt(lorentz_product(normal, normal, precision)) * Ball::rounded(gap(z)));
}

/// The disk about a point that touches the first of the tile's sides; nothing unless the point is certainly inside.
std::optional<InscribedDisk> disk_about(ExactPoint centre, const BallTile& tile, slong precision) {
  if (gap(centre) <= 0) return std::nullopt;
  InscribedDisk disk{std::move(centre), {}};
  for (std::size_t k = 0; k < tile.size(); ++k) {
    const Ball distance = sinh_distance(disk.centre, tile[k], tile[(k + 1) % tile.size()], precision);
    if (certainly_positive(distance) != Tri::yes) return std::nullopt;
    disk.sinh_radius = k == 0 ? distance : min(disk.sinh_radius, distance);
  }
  return disk;
}

/// A disk inside a tile of so many corners, which corner(k) gives in balls and corner_work estimates.
template <class Corner>
std::optional<InscribedDisk> disk_inside(std::size_t corners, const Corner& corner, std::uint64_t corner_work, long cap,
                                         const Budget& budget) {
  std::optional<InscribedDisk> disk;
  const auto attempt = [&](slong precision) {
    budget.spend(80 * ball_work(static_cast<std::uint64_t>(precision)), corners);
    budget.spend(corner_work);
    BallTile tile;
    for (std::size_t k = 0; k < corners; ++k) tile.push_back(corner(k));
    disk = disk_about(approximate_centre(tile, precision), tile, precision);
    return disk.has_value();
  };
  with_rising_precision(std::max(2 * cap, kFirstDiskPrecision), attempt, kFirstDiskPrecision);
  return disk;
}

std::optional<InscribedDisk> inscribed_disk(const SurfaceDocument::Field& field, std::uint32_t tile, long cap,
                                            const Budget& budget) {
  const NumberField numbers(field.polynomial, field.root, budget);
  const SurfaceDocument::Field::Polygon& polygon = field.polygons[tile];
  const auto corner = [&](std::size_t k) -> BallVector {
    const auto ball = [&](std::size_t i) { return real_ball(field_number(numbers, polygon[k][i])); };
    return {ball(0), ball(1), ball(2)};
  };
  return disk_inside(polygon.size(), corner, 0, cap, budget);
}

/// Regular tiles with q corners around every vertex: sides are equal and angles add up, whatever the gluing
/// (docs/proof.md, section 9).
class RegularSurfaceChecker {
 public:
  RegularSurfaceChecker(const SurfaceDocument& surface, const Budget& budget)
      : surface_(surface), sides_(surface), tile_(*regular_tile(surface)), budget_(budget) {}

  SurfaceOutcome check() {
    if (!tile_.is_hyperbolic())
      return refuted("there is no hyperbolic " + named() + ": 1/p + 1/q is not less than 1/2");
    if (const MaybeObjection problem = connection_problem(sides_)) return refuted(problem->text);
    const std::vector<std::uint32_t> vertices = sides_.vertices();
    for (const std::uint32_t first : vertices) {
      std::uint32_t corners = 0;
      std::uint32_t s = first;
      do {
        ++corners;
        s = sides_.next_around(s);
      } while (s != first);
      if (corners != tile_.q) {
        return refuted(std::to_string(corners) + " corners meet at " + certify::named("vertex", sides_, first) +
                       ", expected q = " + std::to_string(tile_.q));
      }
    }
    const std::int64_t euler = euler_characteristic(sides_, vertices.size());
    // 1/p + 1/q < 1/2 makes it negative; anything else is a fault of ours.
    if (euler >= 0 || euler % 2 != 0) return refuted("the Euler characteristic is " + std::to_string(euler));
    const auto genus = static_cast<std::uint64_t>(1 - euler / 2);
    // Not in the braces below: an exception there makes g++ 12 destroy the report twice.
    RegularCrossings crossings(tile_, sides_.partner, budget_);
    return {{"surface", Verdict::verified, text(genus)}, genus, std::move(crossings)};
  }

 private:
  static SurfaceOutcome refuted(const std::string& text) { return {{"surface", Verdict::refuted, text}}; }

  [[nodiscard]] std::string named() const {
    return "regular " + std::to_string(tile_.p) + "-gon with interior angles 2*pi/" + std::to_string(tile_.q);
  }

  [[nodiscard]] std::string text(std::uint64_t genus) const {
    const std::string surface = "a closed hyperbolic surface of genus " + std::to_string(genus);
    if (surface_.regular_genus == 0) {
      return surface + ": " + std::to_string(sides_.first.size()) + " times the " + named() + ", " +
             std::to_string(tile_.q) + " corners around every vertex";
    }
    return surface + " by theorem: the regular " + std::to_string(4 * genus) + "-gon with interior angles pi/" +
           std::to_string(2 * genus) + ", opposite sides glued" + (genus == 2 ? " (the Bolza surface)" : "");
  }

  const SurfaceDocument& surface_;
  SurfaceSides sides_;
  RegularTile tile_;
  const Budget& budget_;
};

}  // namespace

SurfaceOutcome check_surface(const SurfaceDocument& surface, unsigned threads, const Budget& budget) {
  try {
    if (regular_tile(surface)) return RegularSurfaceChecker(surface, budget).check();
    if (is_over_field(surface)) return check_over_field(surface, threads, budget);
    return SurfaceChecker<RationalTiles>(surface, threads, budget).check();
  } catch (const BudgetSpent& spent) {
    return {{"surface", Verdict::undecided, spent.what()}};
  }
}

BallIsometry base_of(const InscribedDisk& disk, const ExactIsometry& frame, slong precision) {
  return to_balls(compose(inverse(frame), translation_to(disk.centre)), precision);
}

std::optional<InscribedDisk> inscribed_disk(const SurfaceDocument::Tile& tile, long cap, const Budget& budget) {
  const ExactTile exact = exact_tile(tile, budget);
  std::uint64_t work = 0;
  for (const ExactPoint& vertex : exact) work += 4 * product_work(bits(vertex));
  return disk_inside(
      exact.size(), [&](std::size_t k) { return ball_vector(exact[k]); }, work, cap, budget);
}

std::optional<InscribedDisk> inscribed_disk(const SurfaceDocument& surface, std::uint32_t tile, long cap,
                                            const Budget& budget) {
  if (is_over_field(surface)) return inscribed_disk(surface.field, tile, cap, budget);
  const auto regular = regular_tile(surface);
  if (!regular) return inscribed_disk(surface.tiles[tile], cap, budget);
  // The inscribed circle.
  return InscribedDisk{{{0, 0}, 1}, sinh_of_apothem(*regular, kApothemPrecision)};
}

}  // namespace epsnet::certify
