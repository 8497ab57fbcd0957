#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// The walk that finds the triangle containing a point (thesis Chapter II, IV.4.3).
enum class Walk {
  visibility,  ///< Crosses any edge behind which the point lies; ends in a Delaunay triangulation (Theorem II.1).
  straight,    ///< Follows the geodesic from a corner; ends in every triangulation.
};

// What a triangulation is asked and how it is changed, by level: queries, which change no triangle; high-level
// operations, which keep it sound (and Delaunay where they say so); low-level operations, of which these are made.
//
// A triangulation is sound if `problem` finds nothing. Where an operation records into a journal, `undo` takes it
// back.

// Queries.

/// Empty if the triangulation is sound: opposite is an involution that matches vertices and lifts, triangles are
/// counterclockwise, the triangles at a vertex make one cycle, V − E + F = 2 − 2g. Otherwise what is wrong first. O(n),
/// in exact or staged arithmetic.
[[nodiscard]] std::string problem(Triangulation& triangulation);

/// Where a point is (thesis IV.4.3).
struct Location {
  /// Inside of a triangle, on an edge, on a vertex; or not found within the steps allowed.
  enum class Type { face, edge, vertex, not_found };
  Type type;
  Dart dart;            ///< A dart of the containing triangle: any for `face`, along the edge, or from the vertex.
  LabelId transition;   ///< From that triangle's chart to the chart in which the point was given.
  std::uint32_t steps;  ///< Triangles entered after the first one.
};

/// No limit to the steps of a walk.
inline constexpr std::uint32_t kAnySteps = ~0u;

/// Returns where vertex p lies. The label of p lifts it to the chart of triangle `start`.
[[nodiscard]] Location locate(Triangulation& triangulation, TriangleId start, Corner p, Walk walk,
                              std::uint32_t most_steps = kAnySteps);
/// Like `locate`, for a point that is not a vertex. Its label leads to the chart of `start`.
[[nodiscard]] Location locate(Triangulation& triangulation, TriangleId start, const LiftedPoint& point, Walk walk,
                              std::uint32_t most_steps = kAnySteps);

/// `locate` by the visibility walk (thesis Theorem II.1): requires a Delaunay triangulation.
[[nodiscard]] Location locate_visibility(Triangulation& triangulation, TriangleId start, Corner p,
                                         std::uint32_t most_steps = kAnySteps);
/// `locate` by the straight walk from corner 0 of `start` (thesis Chapter II).
[[nodiscard]] Location locate_straight(Triangulation& triangulation, TriangleId start, Corner p,
                                       std::uint32_t most_steps = kAnySteps);

// High-level operations.

/// Flips until every edge is locally Delaunay (thesis Theorem I.32), starting from the given darts, which it consumes;
/// returns the number of flips. Many flips around one short closed curve are made at once, and count as one. Throws
/// LimitError.
std::uint64_t restore_delaunay(Triangulation& triangulation, std::vector<Dart>& pending, Journal* journal = nullptr);

/// The same from all edges.
std::uint64_t make_delaunay(Triangulation& triangulation);

/// What insert_by_flips did.
struct InsertedVertex {
  VertexId vertex;
  Dart dart;            ///< Leaves the vertex.
  std::uint32_t steps;  ///< Of the walk.
  std::uint64_t flips;
};

/// Makes a point the next vertex of a Delaunay triangulation: walk from triangle `start`, split, flip (thesis IV.4.3 to
/// IV.4.5). The label of the point leads to the chart of `start`. Nothing, with nothing changed, if there is a vertex
/// already or if the walk takes more than `most_steps`. Throws LimitError.
[[nodiscard]] std::optional<InsertedVertex> insert_by_flips(Triangulation& triangulation, TriangleId start,
                                                            const LiftedPoint& point, Walk walk,
                                                            std::uint32_t most_steps = kAnySteps,
                                                            Journal* journal = nullptr);

/// Gives triangles and vertices numbers in the order in which a breadth-first search from a triangle at vertex 0, which
/// keeps its number, meets them: what is near on the surface is near in memory. Nothing else changes. O(n).
void renumber_by_neighbours(Triangulation& triangulation);

// Low-level operations. They keep the triangulation sound but for vertices without triangles, and need not keep it
// Delaunay.

/// Adds a vertex that no triangle has yet; returns its number.
VertexId add_vertex(Triangulation& triangulation, const Vertex& v);
/// Takes back the last add_vertex; no triangle may have the vertex.
void pop_vertex(Triangulation& triangulation);

/// Splits triangle t into three at a vertex in its interior. `label` leads from the vertex's chart to t's chart.
/// Returns the triangles around the vertex: it is their corner 0, dart 1 is opposite to it.
std::vector<TriangleId> split_face(Triangulation& triangulation, TriangleId t, VertexId vertex, LabelId label,
                                   Journal* journal = nullptr);
/// Splits the edge of d, and the two triangles beside it, at a vertex in its interior. `label` leads from the vertex'
/// chart to the chart of d's triangle. Returns the triangles around the vertex, as split_face.
std::vector<TriangleId> split_edge(Triangulation& triangulation, Dart d, VertexId vertex, LabelId label,
                                   Journal* journal = nullptr);

/// Replaces the edge of d by the other diagonal of the two triangles beside it, and returns a dart of the new edge. The
/// two triangles may share more edges. Requires their lifts side by side to make a strictly convex quadrilateral; an
/// edge that is not Delaunay does (thesis Theorem I.31).
Dart flip(Triangulation& triangulation, Dart d, Journal* journal = nullptr);

// What makes a start of tiles smaller and rounder: contractions of edges, moves of vertices, Dehn twists.

/// Contracts every dart for which `contracts`, asked in the order of triangles, says yes, where that can be done, as
/// `contract`; vertices and triangles that are left keep their order. Returns the number of vertices removed. The
/// triangulation need not be Delaunay before or after. O(n) in all, but for the degrees of vertices.
std::uint32_t contract_all(Triangulation& triangulation, const std::function<bool(Dart)>& contracts);

/// Moves the start vertex of d along d into its end, which it becomes; vertices and triangles are renumbered: the last
/// ones take the numbers of those that vanish. Returns a dart that leaves the merged vertex; nothing, with nothing
/// changed, if the two are one vertex or if some triangle would not stay counterclockwise. (What is left is again a
/// triangulation: labels fit, triangles are counterclockwise and V − E + F is the same.) O(n).
[[nodiscard]] std::optional<Dart> contract(Triangulation& triangulation, Dart d);

/// Moves the start vertex of d to a point, which is lifted to that vertex's chart. False, with nothing changed, if
/// some triangle would not stay counterclockwise. O(degree of the vertex).
[[nodiscard]] bool move_vertex(Triangulation& triangulation, Dart d, const LiftedPoint& point);

/// A Dehn twist, where it saves flips: if the two triangles beside d make an annulus around a short closed curve and
/// the edges across turn around it many times more than a Delaunay triangulation lets them, undoes all of these turns,
/// which would take as many flips. False, with nothing changed, elsewhere. The darts stay where they are. Throws
/// LimitError if there are so many turns that the words of labels become too long.
[[nodiscard]] bool untwist(Triangulation& triangulation, Dart d, Journal* journal);

}  // namespace epsnet
