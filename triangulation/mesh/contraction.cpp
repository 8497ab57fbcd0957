#include "triangulation/mesh/contraction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/plane.h"
#include "triangulation/mesh/editor.h"

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
