#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// How one sweep moves vertices (`relax`).
struct RelaxationSweep {
  unsigned exponent;  ///< n: a circumcentre weighs as the area of its triangle times (sinh R)²ⁿ.
  double step;        ///< The share of the way to the weighted mean by which a vertex moves.
  double momentum;    ///< The share of the last sweep's move that is added.
};

/// Moves the vertices of a Delaunay triangulation so that its circumradii become more equal: each sweep moves every
/// vertex towards a mean of the circumcentres around it, in which large circles weigh most, and flips edges until the
/// triangulation is Delaunay again. With a step much larger than 2/exponent the vertices do not come to rest.
///
/// The vertices of a triangle stay for a sweep if it would turn over, or if binary64 cannot compute its circumcircle.
/// `kept` never moves. `size` is sinh²R of a typical triangle, which keeps weights from overflowing. The result is the
/// same on every machine, as only + − × ÷ √ are used. O(n) for each sweep. Returns the number of flips.
///
/// Exponent 0, step 1 and no momentum give the smoothing of optimal Delaunay triangulations (Chen, Xu, 2004).
std::uint64_t relax(Triangulation& triangulation, const Threshold& size, std::span<const RelaxationSweep> sweeps,
                    std::optional<VertexId> kept = std::nullopt);

/// Turns a Delaunay triangulation into that of an ε-net with few points (docs/design.md, "Sparse nets"): refines it for
/// a larger ε, relaxes it (`relax`), removes vertices that are too close and inserts circumcentres of triangles that
/// are too large. It ends with `refine`, so everything that `refine` proves holds here as well.
///
/// If the result has more than 1.5 times the lower bound for the number of points, the ordinary refinement (`refine`)
/// is made as well, and is the result if it has no more points. A vertex 0 that is the base point (`options.base`)
/// stays in its place; the other vertices are renumbered. Throws as `refine` does. Returns the statistics; `removed`
/// counts all vertices removed on the way.
RefinementStatistics refine_sparsely(Triangulation& triangulation, const Length& epsilon, const NetOptions& options,
                                     const Variant& variant);

}  // namespace epsnet
