#pragma once

#include <array>
#include <cstdint>

#include "certify/document/distance_document.h"
#include "triangulation/base_point.h"
#include "triangulation/surface.h"

/// The distance between two points of a surface, with all shortest geodesics. docs/distances.md says how and why.
namespace epsnet {

/// What is asked of a distance.
struct DistanceOptions {
  /// The enclosure is as narrow as binary64 numbers allow; one that is wider than this (hyperbolic length) is an error.
  double width = 1e-12;
};

/// A vertex of a net of this surface as a point of the tile in which it lies, exactly. Throws NetError if there is no
/// such vertex, and on a regular surface if it is not in the tile of its chart: then its coordinates are not rational.
[[nodiscard]] BasePoint point_of_vertex(const Surface& surface, const certify::NetDocument& net, std::uint32_t vertex);

/// The point of a triangle of a net with these weights: the Lorentz vectors (x, y, t) of its corners on the hyperboloid
/// x² + y² − t² = −1, lifted together, times their weights, add up to a vector on the ray of the point. (1, 1, 1) is
/// the centroid, (1, 1, 0) the midpoint of side 0. Coordinates in the tile of the triangle's chart are rounded to
/// multiples of 2⁻¹⁰⁰, except that one weight alone is that vertex, exactly. Throws NetError as point_of_vertex, and
/// for weights that are negative or all 0.
[[nodiscard]] BasePoint point_of_triangle(const Surface& surface, const certify::NetDocument& net,
                                          std::uint32_t triangle, const std::array<Rational, 3>& weights);

/// The distance between p and q and all geodesics between them that are not longer than the upper end of its enclosure,
/// as paths from p to q; if p is not strictly inside of its tile, from q to p (then `point` is p).
///
/// What is returned is not proved yet; certify::check_distance proves it. Deterministic. The time is that of the
/// Dirichlet domain of p, however far q is and however short closed geodesics are. Throws SurfaceError for a point that
/// is not in its tile and if neither is strictly inside; NetError if the enclosure is wider than asked for, or if there
/// are more than 5000 paths within it, as across a cuff shorter than 10⁻¹⁰; LimitError.
[[nodiscard]] certify::DistanceDocument distance(const Surface& surface, const BasePoint& p, const BasePoint& q,
                                                 const DistanceOptions& options = {});

}  // namespace epsnet
