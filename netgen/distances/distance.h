#pragma once

#include <array>
#include <cstdint>

#include "certify/claims/distance/document.h"
#include "triangulation/surface/surface.h"

/// The distance between two points of a surface, with all shortest geodesics. docs/distances.md says how and why.
namespace epsnet {

struct DirichletPolygon;

/// Options of a distance.
struct DistanceOptions {
  /// The largest width of the enclosure (hyperbolic length). The enclosure is as narrow as binary64 numbers allow; it
  /// is an error if it is wider than this.
  double width = 1e-12;
};

/// Returns a vertex of a net of this surface as a point of the tile in which it lies, exactly. Throws NetError if there
/// is no such vertex. On a regular surface, whose crossings are not rational, it has the coordinates of the tile of its
/// chart, and may be beyond a side of that tile.
[[nodiscard]] BasePoint point_of_vertex(const Surface& surface, const certify::NetDocument& net, std::uint32_t vertex);

/// Returns the point of a triangle of a net with these weights. Lift the triangle; the point lies on the ray of the
/// weighted sum of the Lorentz vectors (x, y, t) of its corners, on the hyperboloid x² + y² − t² = −1. (1, 1, 1) is the
/// centroid, (1, 1, 0) the midpoint of side 0. Coordinates in the tile of the triangle's chart are rounded to multiples
/// of 2⁻¹⁰⁰, except that a single positive weight gives that vertex exactly. Throws NetError for the reasons of
/// point_of_vertex, and if a weight is negative or all are 0.
[[nodiscard]] BasePoint point_of_triangle(const Surface& surface, const certify::NetDocument& net,
                                          std::uint32_t triangle, const std::array<Rational, 3>& weights);

/// Returns the distance of p and q, and all geodesics between them of length up to the upper end of the enclosure, as
/// paths from p to q. The points may be anywhere in the disks of their tiles. If they are the same point of the surface
/// (is_same_point), the distance is 0, and `point` is p.
///
/// The result is not proved yet; certify::check proves it. Deterministic. The time is that of the Dirichlet
/// domain of p, however far away q is and however short closed geodesics are. Throws SurfaceError for what is no point
/// of the surface. Throws NetError if the enclosure is wider than `options.width`, or if it has more than 5000 paths,
/// as across a cuff shorter than 10⁻¹⁰. Throws LimitError.
[[nodiscard]] certify::DistanceDocument distance(const Surface& surface, const BasePoint& p, const BasePoint& q,
                                                 const DistanceOptions& options = {});

/// The same; the Dirichlet domain of p is at hand, and the rest takes little time.
[[nodiscard]] certify::DistanceDocument distance(const Surface& surface, const BasePoint& p,
                                                 const DirichletPolygon& domain_of_p, const BasePoint& q,
                                                 const DistanceOptions& options = {});

}  // namespace epsnet
