#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <rapidcheck.h>
#include <string>
#include <utility>
#include <vector>

#include "netgen/surfaces/fenchel_nielsen.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"

/// Surfaces, points and canonical forms for the tests of atlas, triangulation and nets.
namespace epsnet::test {

struct NamedSurface {
  std::string name;
  Surface surface;
};

/// Returns surfaces of genus 2 to 8 with short and long systoles, which are made once.
const std::deque<NamedSurface>& gallery();

/// Returns the gallery and surfaces of several tiles with several vertices, one of which has a short cuff.
const std::deque<NamedSurface>& tiled_gallery();

/// Returns a random index below n.
template <class Index>
[[nodiscard]] Index any_index(Index n) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Index>(0, n));
}

/// Returns a random surface of the gallery.
const NamedSurface& any_surface();

const NamedSurface& any_tiled_surface();

/// Returns a random number in [0, 1) of 30 bits.
double any_share();

/// Gives a cuff another length and keeps its twist, as a share of the length.
void set_cuff_length(FenchelNielsen& coordinates, std::size_t edge, const Rational& length);

/// Returns coordinates on a random graph: the lengths of the cuffs are logarithmically uniform in [shortest, longest),
/// the twists are random.
FenchelNielsen any_coordinates(std::uint32_t genus, double shortest, double longest);

/// Returns a random path of at most `longest` crossings that starts in a tile; it may go back across the same side.
Word any_word(const Surface& surface, TileId tile, std::size_t longest);

/// Returns the tile in which a path ends.
TileId end_tile(const Surface& surface, TileId tile, const Word& word);

/// A random triangle or vertex.
TriangleId any_triangle(const Triangulation& triangulation);
VertexId any_vertex(const Triangulation& triangulation);

/// A triangle or an edge on the surface: vertices and the isometries between their charts.
using Signature = std::array<std::uint32_t, 5>;

/// Returns the label from the chart of corner j of a triangle to the chart of its corner i, as a label of the atlas
/// of `reference`, which has the same charts.
LabelId between_corners(Triangulation& triangulation, TriangleId t, std::uint32_t i, std::uint32_t j,
                        Triangulation& reference);

/// Returns all triangles in a form that does not depend on their slots and first corners: two triangulations with the
/// same vertices are the same if and only if these lists are equal.
std::vector<Signature> triangles_of(Triangulation& triangulation, Triangulation& reference);
std::vector<Signature> triangles_of(Triangulation& triangulation);

/// Returns the corner across an edge, in the chart of the edge's triangle.
Corner corner_across(Triangulation& triangulation, Dart d);

/// Returns 1 if the edge is not Delaunay, 0 if the two triangles have the same circumcircle, and −1 if the edge is in
/// every Delaunay triangulation.
int delaunay_sign(Triangulation& triangulation, Dart d);

/// Returns the edges of a Delaunay triangulation that are not ties, in both directions: the edges of the Delaunay
/// tessellation, which is unique.
std::vector<Signature> tessellation_of(Triangulation& triangulation, Triangulation& reference);
std::vector<Signature> tessellation_of(Triangulation& triangulation);

/// Returns the first edge that is not Delaunay; nullopt if there is none.
std::optional<Dart> not_delaunay(Triangulation& triangulation);

/// Whether the two triangles beside an edge make a strictly convex quadrilateral, so that it can be flipped.
bool flippable(Triangulation& triangulation, Dart d);

Dart any_dart(const Triangulation& triangulation);

/// Everything that `undo` has to restore.
struct Snapshot {
  std::vector<std::pair<Complex<double>, ChartId>> vertices;
  std::vector<Triangle> triangles;
  bool operator==(const Snapshot&) const = default;
};

Snapshot snapshot(const Triangulation& triangulation);

/// Returns a point of the surface near the coordinate z of a triangle's chart, with the label from the point's chart to
/// the triangle's.
LiftedPoint point_in(Triangulation& triangulation, TriangleId t, const Complex<Mp256>& z);

/// Returns the point of a triangle with positive weights w on its corners, by linear interpolation on the hyperboloid.
LiftedPoint weighted_point(Triangulation& triangulation, TriangleId t, const std::array<double, 3>& w);

/// Returns a random point inside a triangle.
LiftedPoint any_point(Triangulation& triangulation, TriangleId t);

/// Makes a point the next vertex; the straight walk finds its triangle. `point.label` leads from its chart to the chart
/// of triangle t. Returns false, with nothing changed, if there already is a vertex at the point.
bool insert_by_flips(Triangulation& triangulation, TriangleId t, const LiftedPoint& point, Journal* journal = nullptr);

/// Makes `vertex` (added, in no triangle) a vertex of the Delaunay triangulation by Bowyer–Watson, as `Cavity` does in
/// a refinement, starting at triangle t, which must be in conflict with it. `label` leads from the vertex's chart to
/// t's chart. Returns the triangles around the vertex, as split_face; nothing, with nothing changed, if the cavity
/// meets a lift of itself, or `accept(corners of the link)` says no.
std::optional<std::vector<TriangleId>> insert_in_cavity(Triangulation& triangulation, TriangleId t, VertexId vertex,
                                                        LabelId label, const std::function<bool(Corner)>& accept,
                                                        Journal* journal = nullptr);

/// Returns the Delaunay triangulation of a surface's own vertices and `points` random points.
Triangulation any_delaunay(const Surface& surface, std::uint32_t points);

/// Returns the sum of the triangles' areas, by lifts with 256 bits: 4π(g − 1) if they cover the surface once.
double total_area(Triangulation& triangulation);

double area_of(const Surface& surface);

}  // namespace epsnet::test
