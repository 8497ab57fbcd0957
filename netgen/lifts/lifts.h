#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "netgen/lifts/net_geometry.h"

/// Lifts of the triangles of a net to the Poincaré disk.
namespace epsnet {

/// One lift to the Poincaré disk of every triangle of a net. Their union is connected, with one vertex at the centre.
struct Lifts {
  /// A triangle in the disk.
  struct LiftedTriangle {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> placement;  ///< By corner: index in `placements`.
    std::array<Complex<double>, 3> corner;
  };
  std::vector<LiftedTriangle> lifted;       ///< In the order of lifting.
  std::vector<std::uint32_t> place;         ///< By triangle: its index in `lifted`.
  std::vector<PreciseIsometry> placements;  ///< From the chart of a corner's vertex to the disk.
};

/// Lifts all triangles. The directions at the centre are those of the centre's chart, so drawings of different nets of
/// one surface match if they start with the same vertex. Each lift is as accurate as its labels: products along the way
/// are taken with 256 bits and rounded once. Throws NetGeometryError if the triangles are not connected, if a corner is
/// not in the disk, or if there is no such vertex. O(n log n) by weight, else O(n).
[[nodiscard]] Lifts lift_triangles(const NetGeometry& geometry, DrawOrder order, std::uint32_t centre = 0);

/// Returns for each dart whether it is on the boundary of the drawing. An edge has one lift in the drawing if its two
/// triangles are neighbours there, and otherwise two, both on the boundary.
[[nodiscard]] std::vector<bool> boundary_darts(const NetGeometry& geometry, const Lifts& lifts);

/// A lift of one triangle, to 256 bits.
struct Placement {
  std::uint32_t triangle;
  Isometry<Mp256> isometry;  ///< From the chart of its corner 0 to the disk.
};

/// Returns the translation, from the chart of a vertex to the disk, that takes the vertex to 0. Throws NetGeometryError
/// if there is no such vertex.
[[nodiscard]] Isometry<Mp256> to_centre(const NetGeometry& geometry, std::uint32_t vertex);

/// Returns a lift of a triangle at a vertex; `frame` takes the chart of the vertex to the disk. Throws NetGeometryError
/// if the vertex is not a corner of any triangle. O(triangles).
[[nodiscard]] Placement placement_at(const NetGeometry& geometry, std::uint32_t vertex, const Isometry<Mp256>& frame);

/// Returns the lifted triangle across the side from corner `side` to the next corner.
[[nodiscard]] Placement neighbour(const NetGeometry& geometry, const Placement& placement, std::uint32_t side);

}  // namespace epsnet
