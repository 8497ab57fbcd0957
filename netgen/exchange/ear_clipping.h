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

/// Two sides of a polygon with hyperbolic sides that meet elsewhere than where consecutive sides do, or nothing if the
/// polygon is simple.
///
/// Exact: in the Klein model the sides are straight. O(n²) comparisons of integers of machine size; exact arithmetic
/// for sides whose boxes meet.
[[nodiscard]] std::optional<std::pair<std::uint32_t, std::uint32_t>> crossing_sides(
    std::span<const KleinVector> polygon);

/// The triangles, counterclockwise and none degenerate, of a triangulation of a polygon by diagonals, and how they fit
/// together.
struct PolygonTriangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Vertices of the polygon.
  std::vector<Gluing> diagonals;                        ///< Triangles glued along the diagonals.
  /// (triangle, side) of every side of the polygon.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> place_of_side;
};

/// Ear clipping (Meisters 1975) of a simple counterclockwise polygon, straight angles allowed. Exact and deterministic.
/// O(n²).
[[nodiscard]] PolygonTriangulation clip_ears(std::span<const KleinVector> polygon);

}  // namespace epsnet
