#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "netgen/lifts/layout.h"
#include "netgen/lifts/net_geometry.h"

/// Lifts of the triangles of a net to the Poincaré disk.
namespace epsnet {

/// One lift of every triangle of a net in the Poincaré disk, connected, with one vertex in the centre.
struct Lifts {
  /// A triangle in the disk.
  struct LiftedTriangle {
    std::uint32_t triangle;
    std::uint32_t placement;  ///< Index in `placements`.
    std::array<Complex<double>, 3> corner;
  };
  std::vector<LiftedTriangle> lifted;        ///< In the order of lifting.
  std::vector<std::uint32_t> place;          ///< By triangle: its index in `lifted`.
  std::vector<Isometry<double>> placements;  ///< From the chart of a triangle's corner 0 to the disk.
};

/// Lifts all triangles. The directions at the centre are those of the centre's chart, so drawings of nets of one
/// surface that start with the same vertex match. Each lift is as accurate as its labels: products along the way are
/// taken with 256 bits and rounded once. Throws NetGeometryError if the triangles are not connected, a corner is not in
/// the disk, or there is no such vertex. O(n log n) by weight, else O(n).
[[nodiscard]] Lifts lift_triangles(const NetGeometry& geometry, DrawOrder order, std::uint32_t centre = 0);

/// By dart: whether it is on the boundary of the drawing. An edge of the surface has one lift there if its two
/// triangles are neighbours, and else two, on the boundary.
[[nodiscard]] std::vector<bool> boundary_darts(const NetGeometry& geometry, const Lifts& lifts);

/// A lift of one triangle, to 256 bits.
struct Placement {
  std::uint32_t triangle;
  Isometry<Mp256> isometry;  ///< From the chart of its corner 0 to the disk.
};

/// The translation that takes a vertex to 0, from its chart. Throws NetGeometryError if there is no such vertex.
[[nodiscard]] Isometry<Mp256> to_centre(const NetGeometry& geometry, std::uint32_t vertex);

/// A lift at a vertex whose chart is taken to the disk by `frame`. Throws NetGeometryError if the vertex is a corner of
/// no triangle. O(triangles).
[[nodiscard]] Placement placement_at(const NetGeometry& geometry, std::uint32_t vertex, const Isometry<Mp256>& frame);

/// The lifted triangle on the other side of the side from corner `side` to the next one.
[[nodiscard]] Placement neighbour(const NetGeometry& geometry, const Placement& placement, std::uint32_t side);

}  // namespace epsnet
