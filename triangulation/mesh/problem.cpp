#include <cstdint>
#include <string_view>
#include <vector>

#include "triangulation/mesh/operations.h"

namespace epsnet {
namespace {

std::string at(std::string_view what, Dart d) {
  return std::string(what) + " at triangle " + to_string(triangle_of(d)) + ", edge " + std::to_string(corner_of(d));
}

std::string problem_of_dart(Triangulation& triangulation, Dart d) {
  const Dart e = triangulation.opposite(d);
  if (triangle_of(e).number() >= triangulation.triangle_count() || corner_of(e) > 2 || triangulation.opposite(e) != d ||
      e == d) {
    return at("opposite is not an involution without fixed point", d);
  }
  const Atlas& atlas = triangulation.atlas();
  const Corner start = triangulation.corner(d);
  if (triangulation.corner(next_dart(e)).vertex != start.vertex) {
    return at("the vertices on the two sides differ", d);
  }
  const ChartId from = triangulation.vertex(start.vertex).chart;
  const ChartId to = triangulation.chart_of(triangle_of(d));
  if (start.label == kIdentity ? from != to
                               : atlas.labels()[start.label].from != from || atlas.labels()[start.label].to != to) {
    return at("a label leads from or to another chart", d);
  }
  return {};
}

std::string problem_of_triangle(Triangulation& triangulation, TriangleId t) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Dart d = make_dart(t, i);
    const Dart e = triangulation.opposite(d);
    const LabelId across = triangulation.transition(d);
    if (triangulation.corner(d) != triangulation.moved(across, triangulation.corner(next_dart(e))) ||
        triangulation.corner(next_dart(d)) != triangulation.moved(across, triangulation.corner(e))) {
      return at("the lifts on the two sides differ", d);
    }
  }
  const bool counterclockwise =
      triangulation.orientation(triangulation.corner(t, 0), triangulation.corner(t, 1), triangulation.corner(t, 2)) > 0;
  return counterclockwise ? std::string() : at("not counterclockwise", make_dart(t, 0));
}

/// The darts that leave each vertex, `darts_leaving[v]` of them, are one cycle around it.
std::string problem_of_vertices(const Triangulation& triangulation) {
  ById<VertexId, std::uint64_t> darts_leaving(triangulation.vertex_count(), 0);
  ById<VertexId, Dart> some_dart(triangulation.vertex_count());
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const VertexId v = triangulation.triangle(t).vertex[i];
      ++darts_leaving[v];
      some_dart[v] = make_dart(t, i);
    }
  }
  for (const VertexId v : triangulation.vertices()) {
    std::uint64_t turned = 0;
    if (darts_leaving[v] > 0) {
      Dart d = some_dart[v];
      do {
        d = next_dart(triangulation.opposite(d));
        ++turned;
      } while (d != some_dart[v] && turned <= darts_leaving[v]);
    }
    if (turned == 0 || turned != darts_leaving[v]) {
      return "the darts that leave vertex " + to_string(v) + " do not form one cycle";
    }
    if (norm(triangulation.vertex(v).z) > kChartRadius * kChartRadius) {
      return "vertex " + to_string(v) + " is far from the origin of its chart";
    }
  }
  return {};
}

std::string problem_of_counts(const Triangulation& triangulation) {
  const std::int64_t genus = triangulation.surface().genus();
  const std::int64_t triangles = triangulation.triangle_count();
  const std::int64_t euler = std::int64_t{triangulation.vertex_count()} - triangles / 2;
  return triangles % 2 == 0 && euler == 2 - 2 * genus
             ? std::string()
             : "V - E + F is " + std::to_string(euler) + " on a surface of genus " + std::to_string(genus);
}

}  // namespace

std::string problem(Triangulation& triangulation) {
  // Labels are multiplied only after it is known that one leads from where the other leads to.
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (std::string what = problem_of_dart(triangulation, make_dart(t, i)); !what.empty()) return what;
    }
  }
  for (const TriangleId t : triangulation.triangles()) {
    if (std::string what = problem_of_triangle(triangulation, t); !what.empty()) return what;
  }
  if (std::string what = problem_of_vertices(triangulation); !what.empty()) return what;
  return problem_of_counts(triangulation);
}

}  // namespace epsnet
