#include <algorithm>

#include "triangulation/mesh/cavity.h"
#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"

namespace epsnet {
namespace {

std::vector<TriangleId> filled(Cavity& cavity, Triangulation& triangulation, Corner p, Journal* journal) {
  const auto fan = cavity.fill(triangulation, p, journal);
  return {fan.begin(), fan.end()};
}

}  // namespace

VertexId add_vertex(Triangulation& triangulation, const Vertex& v) { return Editor(triangulation).add_vertex(v); }

void pop_vertex(Triangulation& triangulation) { Editor(triangulation).pop_vertex(); }

std::vector<TriangleId> split_face(Triangulation& triangulation, TriangleId t, VertexId vertex, LabelId label,
                                   Journal* journal) {
  Cavity cavity;
  cavity.take_face(triangulation, t);
  return filled(cavity, triangulation, {vertex, label}, journal);
}

std::vector<TriangleId> split_edge(Triangulation& triangulation, Dart d, VertexId vertex, LabelId label,
                                   Journal* journal) {
  Cavity cavity;
  cavity.take_edge(triangulation, d);
  return filled(cavity, triangulation, {vertex, label}, journal);
}

std::optional<std::vector<TriangleId>> insert_in_cavity(Triangulation& triangulation, TriangleId t, VertexId vertex,
                                                        LabelId label, const std::function<bool(Corner)>& accept,
                                                        Journal* journal) {
  Cavity cavity;
  const auto accepted = [&](const Cavity::Edge& e) { return accept(e.from); };
  if (!cavity.find(triangulation, t, {vertex, label}) || !std::ranges::all_of(cavity.boundary(), accepted)) {
    return std::nullopt;
  }
  return filled(cavity, triangulation, {vertex, label}, journal);
}

std::optional<InsertedVertex> insert_by_flips(Triangulation& triangulation, TriangleId start, const LiftedPoint& point,
                                              Walk walk, std::uint32_t most_steps, Journal* journal) {
  const VertexId v = add_vertex(triangulation, {point.z, point.chart});
  const Location location = locate(triangulation, start, Corner{v, point.label}, walk, most_steps);
  if (location.type == Location::Type::vertex || location.type == Location::Type::not_found) {
    pop_vertex(triangulation);
    return std::nullopt;
  }
  const LabelId label = triangulation.product(triangulation.inverse(location.transition), point.label);
  const std::vector<TriangleId> around = location.type == Location::Type::face
                                             ? split_face(triangulation, triangle_of(location.dart), v, label, journal)
                                             : split_edge(triangulation, location.dart, v, label, journal);
  std::vector<Dart> pending(around.size());
  std::transform(around.begin(), around.end(), pending.begin(), [](TriangleId s) { return make_dart(s, 1); });
  const std::uint64_t flips = restore_delaunay(triangulation, pending, journal);
  // Flips leave the new vertex in the triangles that have it.
  const auto& corners = triangulation.triangle(around.front()).vertex;
  const auto i = static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
  return InsertedVertex{v, make_dart(around.front(), i), location.steps, flips};
}

}  // namespace epsnet
