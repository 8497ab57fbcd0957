#pragma once

#include <cstdint>

/// The thesis' bounds for all nets of a surface, in floating point: nothing here is proved.
namespace epsnet {

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

}  // namespace epsnet
