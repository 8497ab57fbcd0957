#pragma once

#include <cstdint>
#include <vector>

#include "triangulation/mesh/journal.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Replaces the edge of d by the other diagonal of the two triangles beside it, and returns a dart of the new edge. The
/// two triangles may share more edges. Requires their lifts side by side to make a strictly convex quadrilateral; an
/// edge that is not Delaunay does (thesis Theorem I.31).
Dart flip(Triangulation& triangulation, Dart d, Journal* journal = nullptr);

/// Flips until every edge is locally Delaunay (thesis Theorem I.32), starting from the given darts, which it consumes;
/// returns the number of flips. Many flips around one short closed curve are made at once, and count as one. Throws
/// LimitError.
std::uint64_t restore_delaunay(Triangulation& triangulation, std::vector<Dart>& pending, Journal* journal = nullptr);

/// The same from all edges.
std::uint64_t make_delaunay(Triangulation& triangulation);

}  // namespace epsnet
