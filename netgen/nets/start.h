#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "netgen/nets/collars.h"
#include "netgen/nets/net_options.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// What a refinement starts from.
struct DelaunayStart {
  Triangulation triangulation;
  std::uint64_t flips;        ///< How many edges were flipped.
  std::uint32_t removed = 0;  ///< How many vertices of the surface's own.
};

/// The Delaunay triangulation of the vertices that Triangulation's constructor gives.
[[nodiscard]] DelaunayStart delaunay_start(const Surface& surface, const std::optional<BasePoint>& base);

/// The Delaunay triangulation of these points, one at least, as vertices 0, 1, 2, …, each the origin of a chart of its
/// own. Throws SurfaceError for a point that is not strictly inside of its tile, ClosePointsError for points that are
/// not farther apart than twice `apart`.
[[nodiscard]] DelaunayStart delaunay_start_of_points(const Surface& surface, const std::vector<BasePoint>& points,
                                                     const Threshold& apart);

/// Removes vertices of a Delaunay triangulation until the rest is an ε-packing, the legitimate start of Algorithm
/// IV.4.1: edges between different vertices that are not longer than ε are contracted; where that would turn a triangle
/// over, their start is first moved towards their end, and edges are flipped. (As two vertices come close, the Delaunay
/// triangulation tends to that of one, and the contraction becomes possible.) `apart` is ε/2. Returns the number of
/// vertices removed. O(n) for each, n triangles. Throws NetError if the moves come to no end.
std::uint32_t reduce_to_packing(Triangulation& triangulation, const Threshold& apart);

/// Handles the collars of all cores no longer than ε in whose l_ε-collars vertices of an ε-packing lie, removes these
/// vertices, and what is then closer than ε (thesis, remark after Algorithm III.10). Vertices of collars stay where
/// they are. Returns the number of vertices removed.
std::uint32_t clear_collars(Triangulation& triangulation, const Threshold& apart, Collars& collars);

/// As reduce_to_packing until vertex 0 alone is left, in its place.
std::uint32_t reduce_to_vertex_0(Triangulation& triangulation);

}  // namespace epsnet
