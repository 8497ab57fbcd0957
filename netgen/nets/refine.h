#pragma once

#include <optional>
#include <vector>

#include "netgen/nets/certified_net.h"
#include "netgen/nets/collars.h"
#include "netgen/nets/variants.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Returns the lower bound for the number of vertices of a net of the surface (thesis Theorem III.2). Throws NetError
/// if it is more than 2²⁹, the limit of `refine`.
double require_possible(const Surface& surface, const Length& epsilon);

/// Refines a Delaunay triangulation whose vertices are an ε-packing until they are an ε-net (thesis Algorithm IV.4.1
/// with a list of IV.4.7).
///
/// Even before the certifier checks it, every inserted point is proved to be at least ε away from the others, and every
/// remaining triangle to have a circumradius of at most ε. With `collars` the result is a pseudo ε-net (Algorithm
/// III.10): collars of cores no longer than ε are emptied, and the triangles in them are not refined. Throws NetError
/// if this fails. Returns the statistics, except for `initial_flips`, `collars` and those of the document.
RefinementStatistics refine(Triangulation& triangulation, const Length& epsilon, const NetOptions& options,
                            const Variant& variant = {}, Collars* collars = nullptr);

/// A net as a triangulation, not proved.
struct TriangulatedNet {
  Triangulation triangulation;
  RefinementStatistics statistics;
  std::optional<std::vector<certify::NetDocument::Collar>> collars;  ///< Of a pseudo net.
};

/// Like compute_variant, as a triangulation.
[[nodiscard]] TriangulatedNet triangulated_net(const Surface& surface, const Length& epsilon,
                                               const NetOptions& options = {}, const Variant& variant = {});

}  // namespace epsnet
