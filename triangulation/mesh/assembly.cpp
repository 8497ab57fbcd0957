#include "triangulation/mesh/assembly.h"

#include <string>
#include <utility>

#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"

namespace epsnet {
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
