#include "triangulation/mesh/editor.h"

#include <string>
#include <utility>

#include "triangulation/mesh/operations.h"

namespace epsnet {

void Editor::require_room(std::size_t count, std::size_t triangles) {
  if (count + triangles > kMostTriangles) {
    throw LimitError("2^30 triangles or more");
  }
}

void Editor::set(TriangleId t, Corner c0, Corner c1, Corner c2) const {
  record(t);
  std::uint64_t labels = 0;
  if ((c0.label | c1.label | c2.label) != kIdentity) {
    const LabelId back = triangulation_.inverse(c0.label);
    const LabelId l1 = triangulation_.product(back, c1.label);
    const LabelId l2 = triangulation_.product(back, c2.label);
    if (l1 > kLargestLabel || l2 > kLargestLabel) {
      throw LimitError("more than 2^24 labels");
    }
    labels = Triangle::packed(l1, l2);
  }
  Triangle& triangle = triangles()[t];
  triangle.vertex = {c0.vertex, c1.vertex, c2.vertex};
  triangle.labels_and_mark = labels;
}

Journal open_journal(const Triangulation& triangulation) {
  return {triangulation.vertex_count(), triangulation.triangle_count(), {}};
}

void undo(Triangulation& triangulation, const Journal& journal) {
  const Editor editor(triangulation);
  for (auto it = journal.overwritten.rbegin(); it != journal.overwritten.rend(); ++it) {
    editor.triangles()[it->first] = it->second;
  }
  editor.triangles().resize(journal.triangles);
  editor.points().resize(journal.vertices);
  editor.charts().resize(journal.vertices);
}

namespace {

[[noreturn]] void refuse(const std::string& what) { throw TriangulationError(what); }

void check_vertex(const Atlas& atlas, VertexId id, const Vertex& vertex) {
  if (vertex.chart.number() >= atlas.charts().count()) {
    refuse("vertex " + to_string(id) + " is in chart " + to_string(vertex.chart) + ", there are " +
           std::to_string(atlas.charts().count()));
  }
  if (!(norm(vertex.z) <= kChartRadius * kChartRadius)) {
    refuse("vertex " + to_string(id) + " is far from the origin of its chart");
  }
}

void check_triangle(const Atlas& atlas, std::size_t vertices, TriangleId id, const Triangle& triangle) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::string place = "triangle " + to_string(id) + ", corner " + std::to_string(i);
    if (triangle.vertex[i].number() >= vertices) {
      refuse(place + " is vertex " + to_string(triangle.vertex[i]) + ", there are " + std::to_string(vertices));
    }
    if (triangle.label(i) >= atlas.labels().count()) {
      refuse(place + " has label " + std::to_string(triangle.label(i)) + ", there are " +
             std::to_string(atlas.labels().count()));
    }
  }
}

}  // namespace

Triangulation assembled(Atlas atlas, std::span<const Vertex> vertices, std::span<const Triangle> triangles) {
  Triangulation result = Editor::without_triangles(std::move(atlas));
  const Editor editor(result);
  editor.require_room(triangles.size());
  for (const Vertex& vertex : vertices) {
    check_vertex(result.atlas(), VertexId(result.vertex_count()), vertex);
    (void)editor.add_vertex(vertex);
  }
  for (const Triangle& triangle : triangles) {
    const TriangleId t = editor.add_triangle();
    check_triangle(result.atlas(), vertices.size(), t, triangle);
    editor.triangles()[t] = triangle;
  }
  if (const std::string what = problem(result); !what.empty()) refuse(what);
  return result;
}

}  // namespace epsnet
