#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "triangulation/mesh/journal.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/mesh/walk.h"

namespace epsnet {

/// Adds a vertex that no triangle has yet; returns its number.
std::uint32_t add_vertex(Triangulation& triangulation, const Vertex& v);
/// Takes back the last add_vertex; no triangle may have the vertex.
void pop_vertex(Triangulation& triangulation);

/// Splits triangle t into three at a vertex in its interior. `label` leads from the vertex's chart to t's chart.
/// Returns the triangles around the vertex: it is their corner 0, dart 1 is opposite to it.
std::vector<std::uint32_t> split_face(Triangulation& triangulation, std::uint32_t t, std::uint32_t vertex,
                                      LabelId label, Journal* journal = nullptr);
/// Splits the edge of d, and the two triangles beside it, at a vertex in its interior. `label` leads from the vertex'
/// chart to the chart of d's triangle. Returns the triangles around the vertex, as split_face.
std::vector<std::uint32_t> split_edge(Triangulation& triangulation, Dart d, std::uint32_t vertex, LabelId label,
                                      Journal* journal = nullptr);

/// Makes `vertex` (added, in no triangle) a vertex of the Delaunay triangulation by Bowyer–Watson, starting at triangle
/// t, which must be in conflict with it. `label` leads from the vertex's chart to t's chart. Returns the triangles
/// around the vertex, as split_face; nothing, with nothing changed, if the cavity meets a lift of itself (few vertices,
/// short loops), or `accept(corners of the link)` says no. Requires a Delaunay triangulation.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> insert_in_cavity(Triangulation& triangulation, std::uint32_t t,
                                                                         std::uint32_t vertex, LabelId label,
                                                                         const std::function<bool(Corner)>& accept,
                                                                         Journal* journal = nullptr);

/// What insert_by_flips did.
struct InsertedVertex {
  std::uint32_t vertex;
  Dart dart;            ///< Leaves the vertex.
  std::uint32_t steps;  ///< Of the walk.
  std::uint64_t flips;
};

/// Makes a point the next vertex of a Delaunay triangulation: walk from triangle `start`, split, flip (thesis IV.4.3 to
/// IV.4.5). The label of the point leads to the chart of `start`. Nothing, with nothing changed, if there is a vertex
/// already or if the walk takes more than `most_steps`. Throws LimitError.
[[nodiscard]] std::optional<InsertedVertex> insert_by_flips(Triangulation& triangulation, std::uint32_t start,
                                                            const Atlas::Place& point, Walk walk,
                                                            std::uint32_t most_steps = kAnySteps,
                                                            Journal* journal = nullptr);

}  // namespace epsnet
