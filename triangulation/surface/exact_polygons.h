#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

/// Points of the Poincaré disk with rational coordinates, as integers, and glued polygons with such corners: products
/// of integers take no gcd, which would be most of the work.
namespace epsnet {

/// Integers of any size (GMP).
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// A point n/m of the Poincaré disk: a Gaussian integer over a positive integer.
struct ScaledPoint {
  Complex<Integer> n;
  Integer m;
};

[[nodiscard]] ScaledPoint scaled(const Complex<Rational>& z);

/// m² − |n|²: positive if and only if the point lies in the open unit disk.
[[nodiscard]] Integer disk_gap(const ScaledPoint& z);

/// A number of Q(i) as a quotient n/d of Gaussian integers, not in lowest terms.
struct GaussianFraction {
  Complex<Integer> n;
  Complex<Integer> d;
};

/// p − q times both denominators.
[[nodiscard]] Complex<Integer> scaled_difference(const ScaledPoint& p, const ScaledPoint& q);

/// z as seen from p: its image under the isometry that takes p to 0, (z − p)/(1 − p̄z).
[[nodiscard]] GaussianFraction seen_from(const ScaledPoint& p, const ScaledPoint& z);

/// A point as a positive multiple of (Klein coordinates, 1) = (2z/(1+|z|²), 1), which is one of its vector on the
/// hyperboloid. Hyperbolic lines are the planes through 0 of these vectors.
using KleinVector = LorentzVector<Integer>;

[[nodiscard]] KleinVector klein(const ScaledPoint& z);

/// The sign of the turn p, q, r along hyperbolic lines: 1 left, 0 straight (or coincident points), −1 right.
[[nodiscard]] int orientation(const KleinVector& p, const KleinVector& q, const KleinVector& r);

/// Orders points by their Klein coordinates x, then y.
[[nodiscard]] bool lexicographically_less(const KleinVector& p, const KleinVector& q);

/// The isometry that takes p to p2 and q to q2, with Gaussian integers as coefficients that have no common integer
/// factor. Requires d(p, q) = d(p2, q2) > 0.
[[nodiscard]] Isometry<Rational> integral_crossing(const ScaledPoint& p, const ScaledPoint& q, const ScaledPoint& p2,
                                                   const ScaledPoint& q2);

/// Polygons glued side to side, being checked. Every member throws SurfaceError, which names the first element that
/// fails.
///
/// Sides and corners are numbered like in `Surface`. The combinatorics are checked by the constructor; the other
/// conditions one by one, so that convex and non-convex polygons can be told apart in between.
///
/// Invariant: `sides().partner` is an involution without fixed points; the vertex classes are the cycles of "the side
/// after the partner"; the tiles are connected and close up to a surface of genus ≥ 2.
class GluedPolygons {
 public:
  /// Every polygon has at least 3 vertices, every side is glued once and not to itself, the surface is connected and of
  /// genus ≥ 2. O(sides). Keeps a reference to the tiles.
  GluedPolygons(const std::vector<Tile>& tiles, const std::vector<Gluing>& gluing);
  GluedPolygons(std::vector<Tile>&&, const std::vector<Gluing>&) = delete;

  /// All vertices lie in the open unit disk and successive ones differ. Needed by everything below.
  void check_vertices();
  /// All polygons are strictly convex and counterclockwise.
  void check_convex() const;
  /// What is wrong with the first polygon that is not strictly convex and counterclockwise; nullopt if all are.
  [[nodiscard]] std::optional<std::string> convexity_problem() const;
  /// Glued sides have equal lengths.
  void check_lengths() const;
  /// The interior angles around every vertex of the surface add up to 2π. Requires simple, counterclockwise polygons.
  ///
  /// The conditions "the crossings around a vertex multiply to the identity" and "the angles add up to 2π" are nearly
  /// one: the product fixes the vertex by construction, so it is the rotation by the sum of the angles. Each angle is
  /// the argument of a Gaussian integer; their product is a positive number if and only if the sum is a multiple of 2π,
  /// exactly; which multiple, doubles tell. Quasi-linear in the number of digits.
  void check_angles() const;

  /// The polygon goes clockwise. Exact for simple polygons.
  [[nodiscard]] bool clockwise(TileId t) const;

  [[nodiscard]] const ById<SideId, ScaledPoint>& points() const { return point_; }
  [[nodiscard]] const ById<SideId, KleinVector>& klein_points() const { return klein_; }
  [[nodiscard]] const GluedSides& sides() const& { return sides_; }
  [[nodiscard]] GluedSides sides() && { return std::move(sides_); }
  [[nodiscard]] std::uint32_t genus() const { return genus_; }
  [[nodiscard]] SideId next(SideId side) const { return sides_.next(side); }
  [[nodiscard]] SideId previous(SideId side) const { return sides_.previous(side); }

 private:
  void number_sides();
  void pair_sides(const std::vector<Gluing>& gluing);
  void check_connected() const;
  void number_vertices();
  /// "side 3", or "tile 2, side 3" where there are several tiles.
  [[nodiscard]] std::string name(const char* element, SideId side) const;
  [[nodiscard]] std::string tile_name(TileId t) const;
  /// True if the corner turns left; false for straight and reflex ones.
  [[nodiscard]] bool strictly_convex(SideId corner) const { return corner_[corner].y > 0; }
  /// The interior angle, in (0, 2π), to within 2⁻⁵⁰.
  [[nodiscard]] double angle(SideId corner) const;

  [[nodiscard]] const Tile& tile(TileId t) const { return tiles_[t.number()]; }
  [[nodiscard]] Ids<TileId> tile_ids() const { return sides_.first_side.ids(); }
  [[nodiscard]] Ids<SideId> side_ids() const { return sides_.side_tile.ids(); }
  /// The sides of a tile.
  [[nodiscard]] Ids<SideId> sides_of(TileId t) const {
    return Ids<SideId>(sides_.first_side[t], static_cast<std::uint32_t>(tile(t).size()));
  }

  const std::vector<Tile>& tiles_;
  GluedSides sides_;
  std::uint32_t genus_ = 0;
  ById<SideId, ScaledPoint> point_;
  ById<SideId, KleinVector> klein_;
  /// The interior angle at a corner is the argument of this Gaussian integer.
  ById<SideId, Complex<Integer>> corner_;
};

}  // namespace epsnet
