#pragma once

#include <cstdint>

/// What the thesis says about all nets of a surface, in floating point: nothing here is proved.
namespace epsnet {

/// (g − 1)/sinh²(ε/2): no ε-covering of a surface of genus g has fewer points (thesis Theorem III.2).
[[nodiscard]] double least_vertices(std::uint32_t genus, double epsilon);

/// 16 (g − 1)/ε²: no ε-packing of a surface of genus g whose systole is at least ε has more points (thesis Theorem
/// III.1).
[[nodiscard]] double most_vertices(std::uint32_t genus, double epsilon);

/// A lower bound, rounded down, of the systole of a surface on which an ε-net is known whose Delaunay triangulation has
/// no loop edge shorter than `shortest_loop` (infinity if it has none at all).
///
/// A geodesic loop at a vertex p that is shorter than l_ε, sinh(l_ε/2) = √2 sinh(ε/2), makes p's shortest loop an edge
/// (thesis Lemma III.8). So all loops at vertices have length at least m = min(l_ε, shortest_loop). A closed geodesic
/// of length σ comes within ε of a vertex p; the loop at p that follows it has the length ℓ with sinh(ℓ/2) = sinh(σ/2)
/// cosh d(p, σ) ≤ sinh(σ/2) cosh ε (Theorem I.24). Hence sinh(σ/2) ≥ sinh(m/2)/cosh ε. For nets without loops and ε <
/// arsinh 1 that is more than ε, the bound of Lemma III.15. It is a little less than l_ε, which III.5.5 states for ε <
/// ln √2: a systole between ε and l_ε need not have a vertex in its l_ε-collar, so we do not claim that.
[[nodiscard]] double systole_lower_bound(double epsilon, double shortest_loop);

}  // namespace epsnet
