#include "certify/net/surface_check.h"

#include <algorithm>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
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
MaybeObjection convexity_problem(const ExactTile& tile, std::size_t t) {
  const std::size_t n = tile.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (gap(tile[k]) <= 0) return named("vertex", k) + " of " + named("tile", t) + " is not inside the unit disk";
  }
  const std::string tile_name = named("tile", t) + " is not strictly convex and counterclockwise: ";
  std::vector<HyperboloidVector<mpz_class>> v;
  v.reserve(n);
  for (const ExactPoint& vertex : tile) v.push_back(hyperboloid_vector(vertex));
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

/// Everything about one surface, laid out by side number.
class SurfaceChecker {
 public:
  SurfaceChecker(const SurfaceDocument& surface, unsigned threads, const Budget& budget)
      : sides_(surface), threads_(threads), budget_(budget) {
    for (const SurfaceDocument::Tile& tile : surface.tiles) tiles_.push_back(exact_tile(tile, budget));
  }

  SurfaceOutcome check() {
    MaybeObjection problem = first_problem(tiles_.size(), threads_, [&](std::size_t t) {
      spend_on_corners(t);
      return convexity_problem(tiles_[t], t);
    });
    if (!problem) problem = connection_problem(sides_);
    if (!problem) problem = genus_problem();
    if (!problem) problem = length_problem();
    if (!problem) problem = vertex_problem();
    if (problem) return {{"surface", problem->verdict, problem->text}};
    return {{"surface", Verdict::verified,
             "a closed hyperbolic surface of genus " + std::to_string(genus_) + ": " +
                 counted(tiles_.size(), "convex tile", "convex tiles") + ", " +
                 std::to_string(sides_.partner.size() / 2) + " pairs of sides of exactly equal length, " +
                 counted(vertices_.size(), "vertex cycle that closes up", "vertex cycles that close up") +
                 " exactly with total angle 2*pi"},
            genus_,
            RationalCrossings(std::move(crossings_))};
  }

 private:
  const ExactPoint& start(std::size_t side) const { return tiles_[sides_.tile[side]][sides_.corner[side]]; }
  const ExactPoint& end(std::size_t side) const { return start(sides_.next[side]); }

  /// Three determinants of three vectors, and a crossing and an angle, for each corner: numbers of some four times the
  /// bits of a vertex, and two greatest common divisors.
  void spend_on_corners(std::size_t t) const {
    for (const ExactPoint& vertex : tiles_[t]) budget_.spend(100 * product_work(4 * bits(vertex)));
  }

  MaybeObjection length_problem() {
    crossings_.resize(sides_.partner.size());
    return first_problem(sides_.partner.size(), threads_, [&](std::size_t s) -> MaybeObjection {
      const std::size_t other = sides_.partner[s];
      if (other < s) return std::nullopt;
      const Fraction own = length(start(s), end(s));
      const Fraction glued = length(start(other), end(other));
      if (own.numerator * glued.denominator != glued.numerator * own.denominator) {
        return named("side", sides_, s) + " is glued to " + named("side", sides_, other) +
               ", which is not of equal length";
      }
      crossings_[s] = crossing(start(s), end(s), start(other), end(other));
      crossings_[other] = inverse(crossings_[s]);
      return std::nullopt;
    });
  }

  [[nodiscard]] MaybeObjection vertex_problem() const {
    return first_problem(vertices_.size(), threads_, [&](std::size_t i) { return problem_around(vertices_[i]); });
  }

  /// Around every vertex the crossings multiply to the identity, exactly, and the angles to one full turn.
  [[nodiscard]] MaybeObjection problem_around(std::uint32_t first) const {
    std::vector<const ExactIsometry*> path;
    const Precision scope(kAnglePrecision);
    Ball sum;
    std::uint32_t s = first;
    do {
      path.push_back(&crossings_[s]);
      sum += interior_angle(start(s), end(s), start(sides_.previous[s]));
      s = sides_.next_around(s);
    } while (s != first);
    // A tree of products; each of its levels has all the bits.
    std::size_t path_bits = 0;
    for (const ExactIsometry* f : path) path_bits += bits(*f);
    budget_.spend(8 * product_work(path_bits), std::bit_width(path.size()));
    if (!is_identity(compose_path(path))) {
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
  const Budget& budget_;
  std::vector<ExactTile> tiles_;
  std::vector<ExactIsometry> crossings_;
  std::vector<std::uint32_t> vertices_;  ///< One side that leaves it for each vertex of the surface.
  std::uint64_t genus_ = 0;
};

/// (2x, 2y, 1 + |z|²) in balls, a positive multiple of the point of the hyperboloid.
BallVector ball_vector(const ExactPoint& z) {
  const HyperboloidVector<mpz_class> v = hyperboloid_vector(z);
  return {Ball::rounded(v.x), Ball::rounded(v.y), Ball::rounded(v.t)};
}

/// The mean of the tile's vertices in the Klein model, in balls.
std::array<Ball, 2> klein_mean(const ExactTile& tile) {
  std::array<Ball, 2> sum;
  for (const ExactPoint& vertex : tile) {
    const BallVector v = ball_vector(vertex);
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
ExactPoint approximate_centre(const ExactTile& tile, slong precision) {
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
Ball sinh_distance(const ExactPoint& z, const ExactPoint& p, const ExactPoint& q, slong precision) {
  const BallVector normal = cross_product(ball_vector(p), ball_vector(q), precision);
  Ball determinant;
  dot(determinant, normal, ball_vector(z), precision);
  return determinant / (sqrt(lorentz_product(normal, normal, precision)) * Ball::rounded(gap(z)));
}

/// The disk about a point that touches the first of the tile's sides; nothing unless the point is certainly inside.
std::optional<InscribedDisk> disk_about(ExactPoint centre, const ExactTile& tile, slong precision) {
  if (gap(centre) <= 0) return std::nullopt;
  InscribedDisk disk{std::move(centre), {}};
  for (std::size_t k = 0; k < tile.size(); ++k) {
    const Ball distance = sinh_distance(disk.centre, tile[k], tile[(k + 1) % tile.size()], precision);
    if (certainly_positive(distance) != Tri::yes) return std::nullopt;
    disk.sinh_radius = k == 0 ? distance : min(disk.sinh_radius, distance);
  }
  return disk;
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
    return regular_tile(surface) ? RegularSurfaceChecker(surface, budget).check()
                                 : SurfaceChecker(surface, threads, budget).check();
  } catch (const BudgetSpent& spent) {
    return {{"surface", Verdict::undecided, spent.what()}};
  }
}

std::optional<InscribedDisk> inscribed_disk(const SurfaceDocument::Tile& tile, long cap, const Budget& budget) {
  const ExactTile exact = exact_tile(tile, budget);
  std::optional<InscribedDisk> disk;
  const auto attempt = [&](slong precision) {
    budget.spend(80 * ball_work(static_cast<std::uint64_t>(precision)), exact.size());
    for (const ExactPoint& vertex : exact) budget.spend(4 * product_work(bits(vertex)));
    disk = disk_about(approximate_centre(exact, precision), exact, precision);
    return disk.has_value();
  };
  with_rising_precision(std::max(2 * cap, kFirstDiskPrecision), attempt, kFirstDiskPrecision);
  return disk;
}

std::optional<InscribedDisk> inscribed_disk(const SurfaceDocument& surface, std::uint32_t tile, long cap,
                                            const Budget& budget) {
  const auto regular = regular_tile(surface);
  if (!regular) return inscribed_disk(surface.tiles[tile], cap, budget);
  // The inscribed circle.
  return InscribedDisk{{{0, 0}, 1}, sinh_of_apothem(*regular, kApothemPrecision)};
}

}  // namespace epsnet::certify
