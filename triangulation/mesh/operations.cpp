#include "triangulation/mesh/operations.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "triangulation/mesh/contraction.h"
#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/insertion.h"

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

namespace {

/// Face, edge or vertex, for a point p that no edge of d's triangle has on its other side.
Location classify(Triangulation& triangulation, Dart d, LabelId transition_to_start, Corner p, std::uint32_t steps) {
  const TriangleId t = triangle_of(d);
  std::array<int, 3> signs{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    signs[i] = triangulation.orientation(triangulation.moved(transition_to_start, triangulation.corner(t, i)),
                                         triangulation.moved(transition_to_start, triangulation.corner(t, next(i))), p);
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (signs[i] == 0 && signs[previous(i)] == 0) {
      return {Location::Type::vertex, make_dart(t, i), transition_to_start, steps};
    }
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (signs[i] == 0) {
      return {Location::Type::edge, make_dart(t, i), transition_to_start, steps};
    }
  }
  return {Location::Type::face, make_dart(t, 0), transition_to_start, steps};
}

}  // namespace

Location locate(Triangulation& triangulation, TriangleId start, Corner p, Walk walk, std::uint32_t most_steps) {
  return walk == Walk::visibility ? locate_visibility(triangulation, start, p, most_steps)
                                  : locate_straight(triangulation, start, p, most_steps);
}

Location locate(Triangulation& triangulation, TriangleId start, const LiftedPoint& point, Walk walk,
                std::uint32_t most_steps) {
  const Editor editor(triangulation);
  const VertexId v = editor.add_vertex({point.z, point.chart});
  const Location location = locate(triangulation, start, Corner{v, point.label}, walk, most_steps);
  editor.pop_vertex();
  return location;
}

Location locate_visibility(Triangulation& triangulation, TriangleId start, Corner p, std::uint32_t most_steps) {
  TriangleId t = start;
  LabelId lift_of_t = kIdentity;
  std::uint32_t steps = 0;
  std::uint32_t entered = 3;  // The edge through which t was entered: p is not behind it.
  const auto lifted = [&](std::uint32_t i) { return triangulation.moved(lift_of_t, triangulation.corner(t, i)); };
  for (;;) {
    std::uint32_t exit = 3;
    for (std::uint32_t k = 1; k <= 3 && exit == 3; ++k) {
      const std::uint32_t i = (entered + k) % 3;
      if (i != entered && triangulation.orientation(lifted(i), lifted(next(i)), p) < 0) {
        exit = i;
      }
    }
    if (exit == 3) {
      return classify(triangulation, make_dart(t, 0), lift_of_t, p, steps);
    }
    const Dart d = make_dart(t, exit);
    if (steps == most_steps) {
      return {Location::Type::not_found, d, lift_of_t, steps};
    }
    lift_of_t = triangulation.product(lift_of_t, triangulation.transition(d));
    const Dart e = triangulation.opposite(d);
    t = triangle_of(e);
    entered = corner_of(e);
    ++steps;
  }
}

Location locate_straight(Triangulation& triangulation, TriangleId start, Corner p, std::uint32_t most_steps) {
  std::uint32_t steps = 0;
  Dart d = make_dart(start, 0);  // Leaves the corner the walk starts from, whatever triangle it turns to.
  LabelId lift_of_t = kIdentity;
  const Corner origin = triangulation.corner(start, 0);
  const auto cross = [&](Dart side) {
    lift_of_t = triangulation.product(lift_of_t, triangulation.transition(side));
    ++steps;
    return triangulation.opposite(side);
  };
  const auto lifted = [&](Dart from) { return triangulation.moved(lift_of_t, triangulation.corner(from)); };
  const auto orientation = [&](Corner a, Corner b, Corner c) { return triangulation.orientation(a, b, c); };
  // Turn around the corner, always the same way, until the geodesic to p leaves through the opposite edge.
  if (orientation(origin, lifted(next_dart(d)), p) < 0) {
    do {
      d = next_dart(cross(d));
    } while (steps < most_steps && orientation(origin, lifted(next_dart(d)), p) < 0);
  } else {
    while (steps < most_steps && orientation(origin, lifted(previous_dart(d)), p) > 0) {
      d = cross(previous_dart(d));
    }
  }
  d = next_dart(d);
  while (orientation(lifted(d), lifted(next_dart(d)), p) < 0) {
    if (steps >= most_steps) {
      return {Location::Type::not_found, d, lift_of_t, steps};
    }
    d = cross(d);
    // The geodesic leaves on the left of an apex that lies to its right, and conversely.
    d = orientation(origin, p, lifted(previous_dart(d))) < 0 ? previous_dart(d) : next_dart(d);
  }
  return classify(triangulation, d, lift_of_t, p, steps);
}

Dart flip(Triangulation& triangulation, Dart d, Journal* journal) {
  const Editor editor(triangulation, journal);
  const Dart e = triangulation.opposite(d);
  const TriangleId t = triangle_of(d);
  const TriangleId s = triangle_of(e);
  const LabelId across = triangulation.transition(d);
  const Corner a = triangulation.corner(d);
  const Corner b = triangulation.corner(next_dart(d));
  const Corner c = triangulation.corner(previous_dart(d));
  const Corner f = triangulation.moved(across, triangulation.corner(previous_dart(e)));
  assert(may_be_left(triangulation, c, a, f) && may_be_left(triangulation, f, b, c));
  // The four outer darts move; where the two triangles share more edges, their opposites move along.
  const std::array<std::pair<Dart, Dart>, 4> moves{{{next_dart(d), make_dart(s, 1)},
                                                    {previous_dart(d), make_dart(t, 0)},
                                                    {next_dart(e), make_dart(t, 1)},
                                                    {previous_dart(e), make_dart(s, 0)}}};
  std::array<Dart, 4> outer{};
  for (std::size_t i = 0; i < 4; ++i) {
    outer[i] = triangulation.opposite(moves[i].first);
    for (const auto& [from, to] : moves) {
      if (triangulation.opposite(moves[i].first) == from) {
        outer[i] = to;
      }
    }
  }
  editor.set(t, c, a, f);
  editor.set(s, f, b, c);
  for (std::size_t i = 0; i < 4; ++i) {
    editor.link(moves[i].second, outer[i]);
  }
  editor.link(make_dart(t, 2), make_dart(s, 2));
  return make_dart(t, 2);
}

std::uint64_t restore_delaunay(Triangulation& triangulation, std::vector<Dart>& pending, Journal* journal) {
  std::uint64_t flips = 0;
  while (!pending.empty()) {
    const Dart d = pending.back();
    pending.pop_back();
    if (!triangulation.is_delaunay(d)) {
      const bool untwisted = untwist(triangulation, d, journal);
      const Dart f = untwisted ? d : flip(triangulation, d, journal);
      const Dart g = triangulation.opposite(f);
      ++flips;
      if (untwisted) pending.push_back(d);
      for (const Dart side : {next_dart(f), previous_dart(f), next_dart(g), previous_dart(g)}) {
        pending.push_back(side);
      }
    }
  }
  return flips;
}

std::uint64_t make_delaunay(Triangulation& triangulation) {
  std::vector<Dart> pending;
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (const Dart d = make_dart(t, i); d < triangulation.opposite(d)) {
        pending.push_back(d);
      }
    }
  }
  return restore_delaunay(triangulation, pending);
}

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

namespace {

/// Numbers in the order of the first request.
template <class I>
class Order {
 public:
  explicit Order(std::size_t size) : number_(size) { order_.reserve(size); }
  void meet(I i) {
    if (number_[i]) return;
    number_[i] = order_.end_id();
    order_.push_back(i);
  }
  [[nodiscard]] I number(I i) const { return *number_[i]; }
  /// What has been met, in order.
  [[nodiscard]] const ById<I, I>& met() const { return order_; }

  /// The values by their new numbers.
  template <class T>
  [[nodiscard]] ById<I, T> applied(const ById<I, T>& values) const {
    ById<I, T> result;
    result.reserve(values.capacity());
    for (const I i : order_) result.push_back(values[i]);
    return result;
  }

 private:
  ById<I, std::optional<I>> number_;
  ById<I, I> order_;
};

}  // namespace

void renumber_by_neighbours(Triangulation& triangulation) {
  Order<VertexId> vertices(triangulation.vertex_count());
  Order<TriangleId> triangles(triangulation.triangle_count());
  vertices.meet(VertexId(0));
  TriangleId first(0);
  while (std::ranges::count(triangulation.triangle(first).vertex, VertexId(0)) == 0) ++first;
  triangles.meet(first);
  // The surface is connected: all are met.
  for (std::size_t i = 0; i < triangles.met().size(); ++i) {
    const Triangle& triangle = triangulation.triangle(triangles.met()[TriangleId(i)]);
    for (const VertexId v : triangle.vertex) vertices.meet(v);
    for (const Dart d : triangle.opposite) triangles.meet(triangle_of(d));
  }
  const Editor editor(triangulation);
  editor.points() = vertices.applied(editor.points());
  editor.charts() = vertices.applied(editor.charts());
  editor.triangles() = triangles.applied(editor.triangles());
  for (Triangle& triangle : editor.triangles()) {
    for (VertexId& v : triangle.vertex) v = vertices.number(v);
    for (Dart& d : triangle.opposite) d = make_dart(triangles.number(triangle_of(d)), corner_of(d));
  }
}

}  // namespace epsnet
