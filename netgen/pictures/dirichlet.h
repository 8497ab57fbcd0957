#pragma once

#include <cstdint>
#include <vector>

#include "netgen/lifts/net_geometry.h"

/// The Dirichlet domain of a vertex of a net, for pictures.
namespace epsnet {

/// The Dirichlet domain D = {x : d(x, 0) ≤ d(x, γ0) for all γ in the group}, where 0 is a lift of the base point.
struct DirichletDomain {
  /// Counterclockwise, in the Poincaré disk with the base point at 0 and directions as in the base point's chart.
  std::vector<Complex<double>> vertices;
  /// The area of the polygon. D is contained in it, so it is D to within the difference to 4π(g − 1).
  double area = 0;
  /// The number of copies of tiles that had to be looked at.
  std::uint32_t copies = 0;
};

/// The Dirichlet domain of a vertex of the net: the Voronoi cell of one lift among all lifts of this vertex (not of the
/// others), thesis Definition I.34.
///
/// The area of the result is that of the surface to within 10⁻⁶, nearly always 10⁻¹⁵. Throws NetGeometryError if that
/// is not reached within the copies allowed: the tiles are no surface, or the cell meets a great many copies of them
/// (very thin surfaces).
///
/// Method: the copies of the tiles that meet the cell are visited by increasing distance from 0, and the cell, at first
/// everything, is cut with the bisectors of 0 and γ0 for all γ = M N⁻¹, where M and N are visited copies of the same
/// tile. That is enough: a boundary point x of the cell is as far from 0 as from some γ0, so γ⁻¹x is in the cell, too,
/// and as far from 0; if a copy M of a tile contains x, then the copy γ⁻¹M = N contains γ⁻¹x. So as soon as the copies
/// within distance r are visited, the polygon is the cell within distance r, and copies outside of the cell are never
/// entered. O(c²) for c copies; c is about the number of copies that meet the cell.
[[nodiscard]] DirichletDomain dirichlet_domain(const NetGeometry& geometry, std::uint32_t vertex,
                                               std::uint32_t max_copies = 1000);

}  // namespace epsnet
