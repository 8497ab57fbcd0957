#pragma once

#include "epsnet/netgen/certified_net.h"
#include "epsnet/triangulation/triangulation.h"

namespace epsnet {

/// Refines a Delaunay triangulation whose vertices are an ε-packing until they are an ε-net (thesis Algorithm IV.4.1
/// with the FIFO list of IV.4.7).
///
/// Every inserted point is proved to be at least ε from the others, every triangle left to have circumradius at most ε,
/// before the certifier sees them. Throws NetError where that cannot be done.
void refine(Triangulation& triangulation, const Epsilon& epsilon, const NetOptions& options, NetStatistics& statistics);

}  // namespace epsnet
