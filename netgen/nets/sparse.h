#pragma once

#include "netgen/nets/certified_net.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Turns a Delaunay triangulation into that of an ε-net with few points (docs/design.md, "Sparse nets"): refines it for
/// a larger ε, relaxes it (`relax`), removes vertices that are too close and inserts circumcentres of triangles that
/// are too large. It ends with `refine`, so everything that `refine` proves holds here as well.
///
/// If the result has more than 1.5 times the lower bound for the number of points, the ordinary refinement (`refine`)
/// is made as well, and is the result if it has no more points. A vertex 0 that is the base point (`options.base`)
/// stays in its place; the other vertices are renumbered. Throws as `refine` does. Returns the statistics; `removed`
/// counts all vertices removed on the way.
NetStatistics refine_sparsely(Triangulation& triangulation, const Length& epsilon, const NetOptions& options);

}  // namespace epsnet
