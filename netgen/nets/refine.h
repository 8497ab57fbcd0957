#pragma once

#include "netgen/nets/collars.h"
#include "netgen/nets/net_options.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// The least number of vertices that a net of the surface may have (thesis Theorem III.2). Throws NetError if it is
/// more than 2²⁹, the limit of `refine`.
double require_possible(const Surface& surface, const Length& epsilon);

/// Refines a Delaunay triangulation whose vertices are an ε-packing until they are an ε-net (thesis Algorithm IV.4.1
/// with a list of IV.4.7).
///
/// Every inserted point is proved to be at least ε from the others, every triangle left to have circumradius at most ε,
/// before the certifier sees them. With `collars` until they are a pseudo ε-net (Algorithm III.10): collars of
/// cores no longer than ε are emptied, and the triangles in them left as they are. Throws NetError where that cannot be
/// done. Returns what it did; `initial_flips`, `collars` and what concerns the result as a document are left to others.
NetStatistics refine(Triangulation& triangulation, const Length& epsilon, const NetOptions& options,
                     Collars* collars = nullptr);

}  // namespace epsnet
