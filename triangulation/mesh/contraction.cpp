#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"

namespace epsnet {
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

}  // namespace epsnet
