#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "netgen/nets/certified_net.h"
#include "netgen/nets/collars.h"
#include "netgen/nets/variants.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

// The thesis' bounds for all nets of a surface, in floating point: nothing here is proved.

/// (g − 1)/sinh²(ε/2): no ε-covering of a surface of genus g has fewer points (thesis Theorem III.2).
[[nodiscard]] double least_vertices(std::uint32_t genus, double epsilon);

/// 16 (g − 1)/ε²: no ε-packing of a surface of genus g whose systole is at least ε has more points (thesis Theorem
/// III.1).
[[nodiscard]] double most_vertices(std::uint32_t genus, double epsilon);

/// Returns a lower bound, rounded down, for the systole of a surface. Requires: the surface has an ε-net whose Delaunay
/// triangulation has no loop shorter than `shortest_loop` (infinity if it has no loops).
///
/// If a geodesic from a vertex p to itself is shorter than l_ε, sinh(l_ε/2) = √2 sinh(ε/2), the shortest one is an edge
/// (thesis Lemma III.8). So each of them, for all p, has length at least m = min(l_ε, shortest_loop). A closed geodesic
/// of length σ comes within ε of a vertex p; the geodesic from p to p that follows it has the length ℓ with
/// sinh(ℓ/2) = sinh(σ/2) cosh d(p, σ) ≤ sinh(σ/2) cosh ε (Theorem I.24). Hence sinh(σ/2) ≥ sinh(m/2)/cosh ε. For nets
/// without loops and ε < arsinh 1 this is more than ε, the bound of Lemma III.15. It is a little less than l_ε, the
/// bound of III.5.5 for ε < ln √2. We do not claim the latter, since a systole between ε and l_ε need not have a vertex
/// in its l_ε-collar.
[[nodiscard]] double systole_lower_bound(double epsilon, double shortest_loop);

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
