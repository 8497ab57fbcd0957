#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "triangulation/surface/exact_points.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// Returns two sides of a hyperbolic polygon that meet, other than consecutive sides in their common vertex; nullopt if
/// the polygon is simple.
///
/// Exact: in the Klein model the sides are straight. O(n²) comparisons of machine integers; exact arithmetic only for
/// sides whose bounding boxes meet.
[[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>> crossing_sides(
    std::span<const KleinVector> polygon);

/// A triangulation of a polygon by diagonals: the triangles, counterclockwise and none degenerate, and their gluing.
struct PolygonTriangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Vertices of the polygon.
  std::vector<Gluing> diagonals;                        ///< Triangles glued along the diagonals.
  /// (triangle, side) of every side of the polygon.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> place_of_side;
};

/// Triangulates a simple counterclockwise polygon, straight angles allowed, by ear clipping (Meisters 1975). Exact and
/// deterministic. O(n²).
[[nodiscard]] PolygonTriangulation clip_ears(std::span<const KleinVector> polygon);

}  // namespace epsnet
