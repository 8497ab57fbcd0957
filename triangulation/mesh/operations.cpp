#include "triangulation/mesh/operations.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/plane.h"
#include "triangulation/mesh/insertion.h"
#include "triangulation/mesh/triangulation.h"

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

namespace {

/// The corners of a triangle with `vertex` replaced, wherever it is one; the replacement is given in the chart of
/// `vertex`.
std::array<Corner, 3> corners_with(Triangulation& triangulation, TriangleId t, VertexId vertex, Corner replacement) {
  std::array<Corner, 3> corners{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Corner c = triangulation.corner(t, i);
    corners[i] = c.vertex == vertex ? triangulation.moved(c.label, replacement) : c;
  }
  return corners;
}

/// Replaces the vertex of a star in all of its triangles but two; false, with nothing changed, if one of them would not
/// be counterclockwise.
bool replace_vertex(Triangulation& triangulation, const std::vector<Dart>& star, Corner replacement,
                    const std::array<std::optional<TriangleId>, 2>& except) {
  const VertexId v = triangulation.corner(star.front()).vertex;
  std::vector<std::pair<TriangleId, std::array<Corner, 3>>> changes;
  for (const Dart d : star) {
    const TriangleId t = triangle_of(d);
    if (t == except[0] || t == except[1]) {
      continue;
    }
    const std::array<Corner, 3> corners = corners_with(triangulation, t, v, replacement);
    if (triangulation.orientation(corners[0], corners[1], corners[2]) <= 0) {
      return false;
    }
    changes.emplace_back(t, corners);
  }
  const Editor editor(triangulation);
  for (const auto& [t, corners] : changes) {
    editor.set(t, corners[0], corners[1], corners[2]);
  }
  return true;
}

/// The last vertex takes the number of the one removed.
void remove_vertex(Triangulation& triangulation, VertexId v) {
  const Editor editor(triangulation);
  const VertexId last(triangulation.vertex_count() - 1);
  if (v != last) {
    editor.points()[v] = editor.points()[last];
    editor.charts()[v] = editor.charts()[last];
    for (Triangle& triangle : editor.triangles()) {
      std::replace(triangle.vertex.begin(), triangle.vertex.end(), last, v);
    }
  }
  editor.pop_vertex();
}

/// The last triangle takes the number of the one removed.
void remove_triangle(Triangulation& triangulation, TriangleId t) {
  ById<TriangleId, Triangle>& triangles = Editor(triangulation).triangles();
  const TriangleId last(triangulation.triangle_count() - 1);
  if (t != last) {
    triangles[t] = triangles[last];
    for (std::uint32_t i = 0; i < 3; ++i) {
      // Two of its edges may be glued to each other.
      Dart& o = triangles[t].opposite[i];
      if (triangle_of(o) == last) {
        o = make_dart(t, corner_of(o));
      }
      triangles[triangle_of(o)].opposite[corner_of(o)] = make_dart(t, i);
    }
  }
  triangles.pop_back();
}

/// Glues what lies beside the two triangles at the edge of d, which vanish: the two other sides of each fall together.
/// An edge of one may be an edge of the other: then the way from outer dart to outer dart leads through both.
void close_edge(Triangulation& triangulation, Dart d) {
  const Dart e = triangulation.opposite(d);
  const std::array<Dart, 4> inner{next_dart(d), previous_dart(d), next_dart(e), previous_dart(e)};
  const auto position_of = [&](Dart x) {
    return static_cast<std::size_t>(std::find(inner.begin(), inner.end(), x) - inner.begin());
  };
  std::vector<std::array<Dart, 2>> links;
  for (std::size_t k = 0; k < 4; ++k) {
    const Dart outer = triangulation.opposite(inner[k]);
    if (position_of(outer) == 4) {
      std::size_t mate = k ^ 1;
      while (position_of(triangulation.opposite(inner[mate])) != 4) {
        mate = position_of(triangulation.opposite(inner[mate])) ^ 1;
      }
      links.push_back({outer, triangulation.opposite(inner[mate])});
    }
  }
  const Editor editor(triangulation);
  for (const auto& [x, y] : links) {
    editor.link(x, y);
  }
}

/// Moves the start vertex of d along d into its end. Nothing leads to the vertex and to the two triangles at d any
/// more, but they are still there. Returns a dart that leaves the merged vertex; nothing, with nothing changed, if some
/// triangle would not stay counterclockwise.
std::optional<Dart> merge(Triangulation& triangulation, Dart d) {
  const Dart e = triangulation.opposite(d);
  const std::array<TriangleId, 2> vanishing{triangle_of(d), triangle_of(e)};
  const VertexId v = triangulation.corner(d).vertex;
  const VertexId w = triangulation.corner(e).vertex;
  const std::vector<Dart> around = triangulation.star(d);
  const auto survivor = std::find_if(around.begin(), around.end(), [&](Dart x) {
    return triangle_of(x) != vanishing[0] && triangle_of(x) != vanishing[1];
  });
  if (v == w || vanishing[0] == vanishing[1] || survivor == around.end() ||
      !replace_vertex(triangulation, around, {w, triangulation.label_along(d)}, {vanishing[0], vanishing[1]})) {
    return std::nullopt;
  }
  close_edge(triangulation, d);
  return *survivor;
}

/// The numbers of what stays, counted in order.
template <class I>
ById<I, I> numbers_without(const ById<I, bool>& removed) {
  ById<I, I> result(removed.size());
  I next(0);
  for (const I i : removed.ids()) {
    result[i] = next;
    if (!removed[i]) ++next;
  }
  return result;
}

template <class I, class T>
void erase(ById<I, T>& values, const ById<I, bool>& removed) {
  I end(0);
  for (const I i : removed.ids()) {
    if (removed[i]) continue;
    values[end] = values[i];
    ++end;
  }
  values.resize(end.number());
}

}  // namespace

std::optional<Dart> contract(Triangulation& triangulation, Dart d) {
  const VertexId v = triangulation.corner(d).vertex;
  const auto [first, last] = std::minmax({triangle_of(d), triangle_of(triangulation.opposite(d))});
  const std::optional<Dart> survivor = merge(triangulation, d);
  if (!survivor) return std::nullopt;
  Dart left = *survivor;  // Leaves v, that is now w.
  for (const TriangleId t : {last, first}) {
    if (triangle_of(left).number() == triangulation.triangle_count() - 1) {
      left = make_dart(t, corner_of(left));
    }
    remove_triangle(triangulation, t);
  }
  remove_vertex(triangulation, v);
  return left;
}

std::uint32_t contract_all(Triangulation& triangulation, const std::function<bool(Dart)>& contracts) {
  ById<VertexId, bool> vertex_goes(triangulation.vertex_count());
  ById<TriangleId, bool> triangle_goes(triangulation.triangle_count());
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3 && !triangle_goes[t]; ++i) {
      const Dart d = make_dart(t, i);
      const VertexId v = triangulation.corner(d).vertex;
      const TriangleId across = triangle_of(triangulation.opposite(d));
      if (v != triangulation.corner(next_dart(d)).vertex && contracts(d) && merge(triangulation, d)) {
        vertex_goes[v] = true;
        triangle_goes[t] = true;
        triangle_goes[across] = true;
      }
    }
  }
  const ById<VertexId, VertexId> vertex_number = numbers_without(vertex_goes);
  const ById<TriangleId, TriangleId> triangle_number = numbers_without(triangle_goes);
  const Editor editor(triangulation);
  erase(editor.points(), vertex_goes);
  erase(editor.charts(), vertex_goes);
  erase(editor.triangles(), triangle_goes);
  for (Triangle& triangle : editor.triangles()) {
    for (VertexId& v : triangle.vertex) v = vertex_number[v];
    for (Dart& d : triangle.opposite) d = make_dart(triangle_number[triangle_of(d)], corner_of(d));
  }
  return static_cast<std::uint32_t>(vertex_goes.size()) - triangulation.vertex_count();
}

bool move_vertex(Triangulation& triangulation, Dart d, const LiftedPoint& point) {
  const std::vector<Dart> around = triangulation.star(d);
  const VertexId v = triangulation.corner(d).vertex;
  const Editor editor(triangulation);
  const VertexId u = editor.add_vertex({point.z, point.chart});
  const bool moved = replace_vertex(triangulation, around, {u, point.label}, {});
  if (moved) {
    // v becomes what u is.
    for (const Dart x : around) {
      std::array<VertexId, 3>& vertices = editor.triangles()[triangle_of(x)].vertex;
      std::replace(vertices.begin(), vertices.end(), u, v);
    }
    editor.points()[v] = point.z;
    editor.charts()[v] = point.chart;
  }
  editor.pop_vertex();
  return moved;
}

// Dehn twists: the turns of edges around a short closed curve, undone all at once.

namespace {

/// sinh²(ℓ/2) of a curve of length ¼; longer ones are left to flips.
constexpr double kShort = 0.0157;
/// Fewer turns are left to flips.
constexpr double kManyTurns = 16;
/// Letters that the word of all turns may have.
constexpr double kMostLetters = 100'000;

/// Where the foot of z on the axis lies along it, up to a constant.
template <class T>
T along(const Axis<T>& axis, const Complex<T>& z) {
  return T(log(T(norm(z - axis.from) / norm(z - axis.to)))) / 2;
}

std::string two_digits(double value) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.2g", value);
  return text.data();
}

}  // namespace

bool untwist(Triangulation& triangulation, Dart d, Journal* journal) {
  // The quadrilateral a, f, b, c beside d = (a, b), lifted to the chart of d's triangle. If two opposite sides are
  // glued to each other, by τ, the other two are loops: those of p and τp, and of f and τf. The edges across are
  // (p, τᵏf) for two successive k, the sides and the diagonal; other values of k are other triangulations of the same
  // annulus.
  const Dart e = triangulation.opposite(d);
  const bool next_glued = triangulation.opposite(next_dart(d)) == next_dart(e);
  const bool previous_glued = triangulation.opposite(previous_dart(d)) == previous_dart(e);
  if (!next_glued && !previous_glued) return false;
  Atlas& atlas = Editor(triangulation).atlas();
  const TriangleId t = triangle_of(d);
  const TriangleId s = triangle_of(e);
  const std::uint32_t of_p = next_glued ? corner_of(d) : next(corner_of(d));
  const std::uint32_t of_turned_f = next_glued ? next(corner_of(d)) : corner_of(d);
  const Corner p = triangulation.corner(t, of_p);
  const Corner turned_p = triangulation.corner(t, previous(corner_of(d)));
  const LabelId tau = atlas.product(turned_p.label, atlas.inverse(p.label));
  if (tau == kIdentity) return false;
  const Isometry<double> rounded = atlas.isometry(tau);
  constexpr double kRounding = 16 * kUnitRoundoff;
  if (isometry_discriminant(rounded) - kRounding * (norm(rounded.a) + norm(rounded.b)) > kShort) return false;

  const LabelId across = triangulation.transition(d);
  const Corner f = triangulation.moved(across, triangulation.corner(s, previous(corner_of(e))));
  const Isometry<Mp1024> translation = atlas.isometry_in<Mp1024>(tau);
  const auto axis = epsnet::axis(translation);
  if (!axis) return false;
  const auto position = [&](const Corner& c) {
    return along(*axis, atlas.lift<Mp1024>(c.label, triangulation.vertex(c.vertex).z));
  };
  const auto length = static_cast<double>(displacement_length(translation));
  // The edges across are short if the feet of p and τᵏf, k ≤ turns < k + 1, are as near as they can be.
  const double turns = std::floor(static_cast<double>(Mp1024(position(p) - position(f))) / length);
  if (!(std::fabs(turns) >= kManyTurns)) return false;
  const double letters = std::fabs(turns) * static_cast<double>(atlas.labels()[tau].word.size());
  if (!(letters <= kMostLetters)) {
    throw LimitError("edges of the start turn " + two_digits(std::fabs(turns)) +
                     " times around a closed curve of length " + two_digits(length) + ", across " +
                     two_digits(letters) + " sides, expected at most " + two_digits(kMostLetters) +
                     "; the surface must be cut into other tiles");
  }
  const LabelId twist = atlas.power(turns < 0 ? atlas.inverse(tau) : tau, static_cast<std::uint64_t>(std::fabs(turns)));

  std::array<Corner, 3> own;
  std::array<Corner, 3> others;
  for (std::uint32_t i = 0; i < 3; ++i) {
    own[i] = triangulation.corner(t, i);
    others[i] = triangulation.moved(across, triangulation.corner(s, i));
  }
  const auto turn = [&](Corner& c) { c = triangulation.moved(twist, c); };
  turn(own[of_turned_f]);
  turn(others[previous(corner_of(e))]);
  turn(others[next_glued ? corner_of(e) : next(corner_of(e))]);
  // Labels still fit, and V − E + F is the same: what is left to ask is whether triangles are counterclockwise.
  if (triangulation.orientation(own[0], own[1], own[2]) <= 0 ||
      triangulation.orientation(others[0], others[1], others[2]) <= 0)
    return false;
  const Editor editor(triangulation, journal);
  editor.set(t, own[0], own[1], own[2]);
  editor.set(s, others[0], others[1], others[2]);
  return true;
}

}  // namespace epsnet
