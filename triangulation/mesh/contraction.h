#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "triangulation/mesh/operations.h"

/// What makes a start of tiles smaller and rounder: contractions of edges, moves of vertices, Dehn twists.
namespace epsnet {

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
