#include <algorithm>
#include <array>

#include "triangulation/triangulation.h"

/// The removal of vertices: contraction of edges, and moves that make them possible.
namespace epsnet {

std::vector<Dart> Triangulation::star(Dart d) const {
  std::vector<Dart> darts;
  Dart e = d;
  do {
    darts.push_back(e);
    e = next_dart(opposite(e));
  } while (e != d);
  return darts;
}

LabelId Triangulation::label_along(Dart d) {
  const std::uint32_t t = triangle_of(d);
  return atlas_.product(atlas_.inverse(corner(t, corner_of(d)).label), corner(t, next(corner_of(d))).label);
}

std::array<Corner, 3> Triangulation::corners_with(std::uint32_t t, std::uint32_t vertex, Corner replacement) {
  std::array<Corner, 3> corners{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Corner c = corner(t, i);
    corners[i] = c.vertex == vertex ? moved(c.label, replacement) : c;
  }
  return corners;
}

bool Triangulation::replace_vertex(const std::vector<Dart>& star, Corner replacement,
                                   const std::array<std::uint32_t, 2>& except) {
  const std::uint32_t v = triangles_[triangle_of(star.front())].vertex[corner_of(star.front())];
  std::vector<std::pair<std::uint32_t, std::array<Corner, 3>>> changes;
  for (const Dart d : star) {
    const std::uint32_t t = triangle_of(d);
    if (t == except[0] || t == except[1]) {
      continue;
    }
    const std::array<Corner, 3> corners = corners_with(t, v, replacement);
    if (orientation(corners[0], corners[1], corners[2]) <= 0) {
      return false;
    }
    changes.emplace_back(t, corners);
  }
  for (const auto& [t, corners] : changes) {
    set(t, corners[0], corners[1], corners[2], nullptr);
  }
  return true;
}

void Triangulation::remove_vertex(std::uint32_t v) {
  const std::uint32_t last = vertex_count() - 1;
  if (v != last) {
    points_[v] = points_[last];
    charts_[v] = charts_[last];
    for (Triangle& triangle : triangles_) {
      std::replace(triangle.vertex.begin(), triangle.vertex.end(), last, v);
    }
  }
  pop_vertex();
}

void Triangulation::remove_triangle(std::uint32_t t) {
  const std::uint32_t last = triangle_count() - 1;
  if (t != last) {
    triangles_[t] = triangles_[last];
    for (std::uint32_t i = 0; i < 3; ++i) {
      // Two of its edges may be glued to each other.
      Dart& o = triangles_[t].opposite[i];
      if (triangle_of(o) == last) {
        o = make_dart(t, corner_of(o));
      }
      triangles_[triangle_of(o)].opposite[corner_of(o)] = make_dart(t, i);
    }
  }
  triangles_.pop_back();
}

std::optional<Dart> Triangulation::contract(Dart d) {
  const Dart e = opposite(d);
  const std::array<std::uint32_t, 2> vanishing{triangle_of(d), triangle_of(e)};
  const std::uint32_t v = triangles_[vanishing[0]].vertex[corner_of(d)];
  const std::uint32_t w = triangles_[vanishing[1]].vertex[corner_of(e)];
  const std::vector<Dart> around = star(d);
  const auto survivor = std::find_if(around.begin(), around.end(), [&](Dart x) {
    return triangle_of(x) != vanishing[0] && triangle_of(x) != vanishing[1];
  });
  if (v == w || vanishing[0] == vanishing[1] || survivor == around.end() ||
      !replace_vertex(around, {w, label_along(d)}, vanishing)) {
    return std::nullopt;
  }
  // The two sides of each vanishing triangle fall together. An edge of one may be an edge of the other: then the way
  // from outer dart to outer dart leads through both.
  const std::array<Dart, 4> inner{next_dart(d), previous_dart(d), next_dart(e), previous_dart(e)};
  const auto place_of = [&](Dart x) {
    return static_cast<std::size_t>(std::find(inner.begin(), inner.end(), x) - inner.begin());
  };
  std::vector<std::array<Dart, 2>> links;
  for (std::size_t k = 0; k < 4; ++k) {
    const Dart outer = opposite(inner[k]);
    if (place_of(outer) == 4) {
      std::size_t mate = k ^ 1;
      while (place_of(opposite(inner[mate])) != 4) {
        mate = place_of(opposite(inner[mate])) ^ 1;
      }
      links.push_back({outer, opposite(inner[mate])});
    }
  }
  for (const auto& [x, y] : links) {
    link(x, y, nullptr);
  }
  Dart left = *survivor;  // Leaves v, that is now w.
  for (const std::uint32_t t : {std::max(vanishing[0], vanishing[1]), std::min(vanishing[0], vanishing[1])}) {
    if (triangle_of(left) == triangle_count() - 1) {
      left = make_dart(t, corner_of(left));
    }
    remove_triangle(t);
  }
  remove_vertex(v);
  return left;
}

bool Triangulation::move_vertex(Dart d, const Atlas::Place& place) {
  const std::vector<Dart> around = star(d);
  const std::uint32_t v = triangles_[triangle_of(d)].vertex[corner_of(d)];
  const std::uint32_t u = add_vertex({place.z, place.chart});
  constexpr std::uint32_t kNone = ~std::uint32_t{0};
  if (!replace_vertex(around, {u, place.label}, {kNone, kNone})) {
    pop_vertex();
    return false;
  }
  remove_vertex(v);  // u takes its number.
  return true;
}

}  // namespace epsnet
