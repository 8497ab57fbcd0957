#pragma once

#include "netgen/nets/net_options.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Makes a Delaunay triangulation one of an ε-net with few points (docs/design.md, "Sparse nets"): refines it for a
/// larger ε, relaxes it (`relax`), takes out vertices that are too close and inserts circumcentres of triangles that
/// are too large, and ends with `refine`, so that what that proves holds here as well.
///
/// The ordinary refinement (`refine`) is made as well where the result has more than 1.5 times the least number of
/// points, and taken if it has no more. A vertex 0 that is the base point (`options.base`) stays in its place, the
/// others get other numbers. Throws as `refine`. Returns what it did; `removed` counts all vertices taken out on the
/// way.
NetStatistics refine_sparsely(Triangulation& triangulation, const Length& epsilon, const NetOptions& options);

}  // namespace epsnet
