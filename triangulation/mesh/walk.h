#pragma once

#include <cstdint>

#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Where a point is (thesis IV.4.3).
struct Location {
  /// Inside of a triangle, on an edge, on a vertex; or not found within the steps allowed.
  enum class Type { face, edge, vertex, not_found };
  Type type;
  Dart dart;            ///< A dart of the containing triangle: any for `face`, along the edge, or from the vertex.
  LabelId transition;   ///< From that triangle's chart to the chart in which the point was given.
  std::uint32_t steps;  ///< Triangles entered after the first one.
};

/// The walk that finds the triangle containing a point (thesis Chapter II, IV.4.3).
enum class Walk {
  visibility,  ///< Crosses any edge behind which the point lies; ends in a Delaunay triangulation (Theorem II.1).
  straight,    ///< Follows the geodesic from a corner; ends in every triangulation.
};

/// No limit to the steps of a walk.
inline constexpr std::uint32_t kAnySteps = ~0u;

/// Returns where vertex p lies. The label of p lifts it to the chart of triangle `start`.
[[nodiscard]] Location locate(Triangulation& triangulation, std::uint32_t start, Corner p, Walk walk,
                              std::uint32_t most_steps = kAnySteps);
/// Like `locate`, for a point that is not a vertex. Its label leads to the chart of `start`.
[[nodiscard]] Location locate(Triangulation& triangulation, std::uint32_t start, const Atlas::Place& point, Walk walk,
                              std::uint32_t most_steps = kAnySteps);

/// `locate` by the visibility walk (thesis Theorem II.1): requires a Delaunay triangulation.
[[nodiscard]] Location locate_visibility(Triangulation& triangulation, std::uint32_t start, Corner p,
                                         std::uint32_t most_steps = kAnySteps);
/// `locate` by the straight walk from corner 0 of `start` (thesis Chapter II).
[[nodiscard]] Location locate_straight(Triangulation& triangulation, std::uint32_t start, Corner p,
                                       std::uint32_t most_steps = kAnySteps);

}  // namespace epsnet
