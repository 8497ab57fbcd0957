#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "triangulation/mesh/threshold.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// How one sweep moves vertices (`relax`).
struct RelaxationSweep {
  unsigned exponent;  ///< n: a circumcentre weighs as the area of its triangle times (sinh R)²ⁿ.
  double step;        ///< The share of the way to the weighted mean that is gone.
  double momentum;    ///< The share of the last sweep's move that is made again.
};

/// Moves the vertices of a Delaunay triangulation so that its circumradii become more equal: each sweep moves every
/// vertex towards a mean of the circumcentres around it, in which large circles weigh most, and flips edges until the
/// triangulation is Delaunay again. A step much larger than 2/exponent is too large to come to rest.
///
/// Where a triangle would turn over, its vertices stay for that sweep, and so do vertices of triangles whose
/// circumcircles binary64 does not see. `kept` never moves. `size` is sinh²R of a typical triangle, lest weights
/// overflow. Only + − × ÷ √, so the same on every machine. O(n) for each sweep. Returns the number of flips.
///
/// With exponent 0, step 1 and no momentum: the smoothing of optimal Delaunay triangulations (Chen, Xu, 2004).
std::uint64_t relax(Triangulation& triangulation, const Threshold& size, std::span<const RelaxationSweep> sweeps,
                    std::optional<std::uint32_t> kept = std::nullopt);

}  // namespace epsnet
