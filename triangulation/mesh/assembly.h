#pragma once

#include <span>

#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// The triangulation of these vertices and triangles, whose charts and labels are those of the atlas; nothing is
/// flipped or renumbered. Throws TriangulationError if it is not sound (`problem`). O(n).
[[nodiscard]] Triangulation assembled(Atlas atlas, std::span<const Vertex> vertices,
                                      std::span<const Triangle> triangles);

}  // namespace epsnet
