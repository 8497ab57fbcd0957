#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/net/document.h"
#include "netgen/base/options.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/collars.h"
#include "triangulation/mesh/triangulation.h"

/// Triangulations from which nets are made: of the tiles of a surface, of points, and of the document of a net; and
/// such documents.
namespace epsnet {

/// The start of a refinement.
struct DelaunayStart {
  Triangulation triangulation;
  std::uint64_t flips;        ///< How many edges were flipped.
  std::uint32_t removed = 0;  ///< How many vertices of the surface were removed.
};

/// Returns the Delaunay triangulation of the vertices that Triangulation's constructor makes.
[[nodiscard]] DelaunayStart delaunay_start(const Surface& surface, const std::optional<BasePoint>& base);

/// Returns the Delaunay triangulation whose one vertex is a point of the surface, exactly, wherever it is in the disk
/// of its tile; by default the surface's first vertex, or the centre of a regular surface. Throws SurfaceError if it is
/// no point of the surface, LimitError, NetError.
[[nodiscard]] DelaunayStart delaunay_start_of_point(const Surface& surface, const std::optional<BasePoint>& point);

/// Returns the Delaunay triangulation of these points, at least one, as vertices 0, 1, 2, …, each the origin of a chart
/// of its own. Throws SurfaceError for what is no point of the surface, ClosePointsError for two points that are not
/// farther apart than twice `apart`.
[[nodiscard]] DelaunayStart delaunay_start_of_points(const Surface& surface, const std::vector<BasePoint>& points,
                                                     const Threshold& apart);

/// Removes vertices of a Delaunay triangulation until the rest is an ε-packing, which Algorithm IV.4.1 may start from.
/// Edges between different vertices that are not longer than ε are contracted. If that would turn a triangle over, the
/// start of the edge is first moved towards its end, and edges are flipped. (As two vertices approach each other, the
/// Delaunay triangulation tends to that with one of them, and the contraction becomes possible.) `apart` is ε/2.
/// Returns the number of vertices removed. O(n) for each of them, for n triangles. Throws NetError if the moves do not
/// end.
std::uint32_t reduce_to_packing(Triangulation& triangulation, const Threshold& apart);

/// Handles the collars of all cores no longer than ε whose l_ε-collars contain vertices of an ε-packing. Removes these
/// vertices, and then those closer than ε to others (thesis, remark after Algorithm III.10). The vertices inserted for
/// collars do not move. Returns the number of vertices removed.
std::uint32_t clear_collars(Triangulation& triangulation, const Threshold& apart, Collars& collars);

/// Removes vertices as reduce_to_packing does until only vertex 0 is left, in its place.
std::uint32_t reduce_to_vertex_0(Triangulation& triangulation);

/// Returns the number of a triangulation's dart in a net file.
[[nodiscard]] constexpr std::uint32_t document_dart(Dart d) { return 3 * triangle_of(d).number() + corner_of(d); }
/// Returns the triangulation's dart with a number of a net file.
[[nodiscard]] constexpr Dart triangulation_dart(std::uint32_t d) { return make_dart(TriangleId(d / 3), d % 3); }

/// Returns a triangulation as the plain data of a net file, without unused charts and labels. O(size).
[[nodiscard]] certify::NetDocument net_document(const Triangulation& triangulation, const Length& epsilon);

/// Returns the triangulation that a net file describes. Charts, labels, vertices and triangles are those of the file;
/// nothing is flipped or recomputed. So for a document that net_document made, net_document returns it again. A
/// triangulation has no epsilon and no collars; those of the document are left out. Does not check whether the vertices
/// are a net.
///
/// Throws SurfaceError if the document's surface is invalid, TriangulationError if charts, labels, vertices or
/// triangles are inconsistent, LimitError. O(size) plus the time of `Surface` and of evaluating the labels.
[[nodiscard]] Triangulation triangulation_of(const certify::NetDocument& net);

}  // namespace epsnet
