#pragma once

#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Gives triangles and vertices numbers in the order in which a breadth-first search from a triangle at vertex 0, which
/// keeps its number, meets them: what is near on the surface is near in memory. Nothing else changes. O(n).
void renumber_by_neighbours(Triangulation& triangulation);

}  // namespace epsnet
