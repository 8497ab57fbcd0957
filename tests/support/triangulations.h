#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <optional>
#include <rapidcheck.h>
#include <string>
#include <utility>
#include <vector>

#include "netgen/exchange/domain_format.h"
#include "netgen/exchange/exchange.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/octagon.h"
#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"

/// Surfaces, points and canonical forms for the tests of atlas, triangulation and nets.
namespace epsnet::test {

struct NamedSurface {
  std::string name;
  Surface surface;
};

/// Returns surfaces of genus 2 to 8 with short and long systoles, which are made once.
inline const std::deque<NamedSurface>& gallery() {
  static const std::deque<NamedSurface> surfaces = [] {
    std::deque<NamedSurface> result;
    for (const std::int32_t seed : {1, 123, 321}) {
      result.push_back({"octagon " + std::to_string(seed), random_octagon(seed)});
    }
    for (const char* name : {"g2-small", "g2-theta", "g2-thin-1e-4", "g3-rnd0", "g4-treeloops", "g5-rnd0", "g8-rnd0"}) {
      result.push_back(
          {name, import_surface_file(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-" + name + ".txt")});
    }
    return result;
  }();
  return surfaces;
}

/// Returns the gallery and surfaces of several tiles with several vertices, one of which has a short cuff.
inline const std::deque<NamedSurface>& tiled_gallery() {
  static const std::deque<NamedSurface> surfaces = [] {
    std::deque<NamedSurface> result = gallery();
    FenchelNielsen coordinates = random_coordinates(PantsGraph::random(3, 5), 5);
    result.push_back({"Fenchel-Nielsen, genus 3", fenchel_nielsen_surface(coordinates)});
    coordinates.lengths[2] = Rational(1, 1'000'000);
    result.push_back({"Fenchel-Nielsen, short cuff", fenchel_nielsen_surface(coordinates)});
    return result;
  }();
  return surfaces;
}

/// Returns a random index below n.
template <class Index>
[[nodiscard]] Index any_index(Index n) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Index>(0, n));
}

/// Returns a random surface of the gallery.
inline const NamedSurface& any_surface() {
  const auto i = any_index(gallery().size());
  RC_TAG(gallery()[i].name);
  return gallery()[i];
}

inline const NamedSurface& any_tiled_surface() {
  const auto i = any_index(tiled_gallery().size());
  RC_TAG(tiled_gallery()[i].name);
  return tiled_gallery()[i];
}

/// Returns a random number in [0, 1) of 30 bits.
inline double any_share() { return std::ldexp(static_cast<double>(any_index<std::uint32_t>(1u << 30)), -30); }

/// Gives a cuff another length and keeps its twist, as a share of the length.
inline void set_cuff_length(FenchelNielsen& coordinates, std::size_t edge, const Rational& length) {
  coordinates.twists[edge] *= length / coordinates.lengths[edge];
  coordinates.lengths[edge] = length;
}

/// Returns coordinates on a random graph: the lengths of the cuffs are logarithmically uniform in [shortest, longest),
/// the twists are random.
inline FenchelNielsen any_coordinates(std::uint32_t genus, double shortest, double longest) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(genus, any_index(1000u)), any_index(1000u));
  for (std::size_t edge = 0; edge < coordinates.lengths.size(); ++edge) {
    set_cuff_length(coordinates, edge, Rational(shortest * std::pow(longest / shortest, any_share())));
  }
  return coordinates;
}

/// Returns a random path of at most `longest` crossings that starts in a tile; it may go back across the same side.
inline Word any_word(const Surface& surface, std::uint32_t tile, std::size_t longest) {
  Word word;
  const std::size_t length = any_index<std::size_t>(longest + 1);
  while (word.size() < length) {
    const auto sides = static_cast<std::uint32_t>(surface.tiles()[tile].size());
    word.push_back(surface.side_number(tile, any_index(sides)));
    tile = surface.tile_of_side(surface.partner(word.back()));
  }
  return word;
}

/// Returns the tile in which a path ends.
inline std::uint32_t end_tile(const Surface& surface, std::uint32_t tile, const Word& word) {
  return word.empty() ? tile : surface.tile_of_side(surface.partner(word.back()));
}

/// A random triangle or vertex.
inline TriangleId any_triangle(const Triangulation& triangulation) {
  return TriangleId(any_index(triangulation.triangle_count()));
}
inline VertexId any_vertex(const Triangulation& triangulation) {
  return VertexId(any_index(triangulation.vertex_count()));
}

/// A triangle or an edge on the surface: vertices and the isometries between their charts.
using Signature = std::array<std::uint32_t, 5>;

/// Returns the label from the chart of corner j of a triangle to the chart of its corner i, as a label of the atlas
/// of `reference`, which has the same charts.
inline LabelId between_corners(Triangulation& triangulation, TriangleId t, std::uint32_t i, std::uint32_t j,
                               Triangulation& reference) {
  const Triangle& triangle = triangulation.triangle(t);
  const LabelId label = triangulation.product(triangulation.inverse(triangle.label(i)), triangle.label(j));
  if (&reference == &triangulation || label == kIdentity) return label;
  const LabelTable::Entry& entry = triangulation.atlas().labels()[label];
  return Editor(reference).atlas().label(entry.from, entry.to, entry.word);
}

/// Returns all triangles in a form that does not depend on their slots and first corners: two triangulations with the
/// same vertices are the same if and only if these lists are equal.
inline std::vector<Signature> triangles_of(Triangulation& triangulation, Triangulation& reference) {
  std::vector<Signature> result;
  for (const TriangleId t : triangulation.triangles()) {
    Signature least;
    least.fill(~0u);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto& v = triangulation.triangle(t).vertex;
      least = std::min(least, {v[i].number(), v[next(i)].number(), v[previous(i)].number(),  //
                               between_corners(triangulation, t, i, next(i), reference),
                               between_corners(triangulation, t, i, previous(i), reference)});
    }
    result.push_back(least);
  }
  std::sort(result.begin(), result.end());
  return result;
}
inline std::vector<Signature> triangles_of(Triangulation& triangulation) {
  return triangles_of(triangulation, triangulation);
}

/// Returns the corner across an edge, in the chart of the edge's triangle.
inline Corner corner_across(Triangulation& triangulation, Dart d) {
  const Dart e = triangulation.opposite(d);
  return triangulation.moved(triangulation.transition(d), triangulation.corner(previous_dart(e)));
}

/// Returns 1 if the edge is not Delaunay, 0 if the two triangles have the same circumcircle, and −1 if the edge is in
/// every Delaunay triangulation.
inline int delaunay_sign(Triangulation& triangulation, Dart d) {
  const TriangleId t = triangle_of(d);
  return triangulation.in_circle(triangulation.corner(t, 0), triangulation.corner(t, 1), triangulation.corner(t, 2),
                                 corner_across(triangulation, d));
}

/// Returns the edges of a Delaunay triangulation that are not ties, in both directions: the edges of the Delaunay
/// tessellation, which is unique.
inline std::vector<Signature> tessellation_of(Triangulation& triangulation, Triangulation& reference) {
  std::vector<Signature> result;
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (delaunay_sign(triangulation, make_dart(t, i)) < 0) {
        const auto& v = triangulation.triangle(t).vertex;
        result.push_back(
            {v[i].number(), v[next(i)].number(), between_corners(triangulation, t, i, next(i), reference), 0, 0});
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}
inline std::vector<Signature> tessellation_of(Triangulation& triangulation) {
  return tessellation_of(triangulation, triangulation);
}

/// Returns the first edge that is not Delaunay; nullopt if there is none.
inline std::optional<Dart> not_delaunay(Triangulation& triangulation) {
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (!triangulation.is_delaunay(make_dart(t, i))) {
        return make_dart(t, i);
      }
    }
  }
  return std::nullopt;
}

/// Whether the two triangles beside an edge make a strictly convex quadrilateral, so that it can be flipped.
inline bool flippable(Triangulation& triangulation, Dart d) {
  const Corner a = triangulation.corner(d);
  const Corner b = triangulation.corner(next_dart(d));
  const Corner c = triangulation.corner(previous_dart(d));
  const Corner f = corner_across(triangulation, d);
  return triangulation.orientation(c, a, f) > 0 && triangulation.orientation(f, b, c) > 0;
}

inline Dart any_dart(const Triangulation& triangulation) {
  const auto i = any_index<std::uint32_t>(3 * triangulation.triangle_count());
  return make_dart(TriangleId(i / 3), i % 3);
}

/// Everything that `undo` has to restore.
struct Snapshot {
  std::vector<std::pair<Complex<double>, ChartId>> vertices;
  std::vector<Triangle> triangles;
  bool operator==(const Snapshot&) const = default;
};

inline Snapshot snapshot(const Triangulation& triangulation) {
  Snapshot result;
  for (const VertexId v : triangulation.vertices()) {
    result.vertices.emplace_back(triangulation.vertex(v).z, triangulation.vertex(v).chart);
  }
  for (const TriangleId t : triangulation.triangles()) {
    result.triangles.push_back(triangulation.triangle(t));
  }
  return result;
}

/// Returns a point of the surface near the coordinate z of a triangle's chart, with the label from the point's chart to
/// the triangle's.
inline LiftedPoint point_in(Triangulation& triangulation, TriangleId t, const Complex<Mp256>& z) {
  const ChartId chart = triangulation.chart_of(t);
  if (norm(z) <= Mp256(0.25)) {
    return {chart, convert<double>(z), kIdentity};
  }
  return triangulation.lifted_point(chart, convert<Mp1024>(z), Atlas::Precision::binary64).value();
}

/// Returns the point of a triangle with positive weights w on its corners, by linear interpolation on the hyperboloid.
inline LiftedPoint weighted_point(Triangulation& triangulation, TriangleId t, const std::array<double, 3>& w) {
  Complex<Mp256> sum{};
  Mp256 height(0);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Complex<Mp256> z = triangulation.lift_in<Mp256>(triangulation.corner(t, i));
    // (2z, 1 + |z|²)/(1 − |z|²) is the point of the hyperboloid.
    const Mp256 scale = Mp256(w[i]) / Mp256(Mp256(1) - norm(z));
    sum = sum + scale * (Mp256(2) * z);
    height += scale * (Mp256(1) + norm(z));
  }
  // The inverse is (X, T) ↦ X/(T + √(T² − |X|²)).
  const Mp256 root = sqrt(Mp256(height * height - norm(sum)));
  return point_in(triangulation, t, Mp256(1 / (height + root)) * sum);
}

/// Returns a random point inside a triangle.
inline LiftedPoint any_point(Triangulation& triangulation, TriangleId t) {
  const auto weight = [] { return 0.02 + any_share(); };
  const double a = weight();
  const double b = weight();
  const double c = weight();
  return weighted_point(triangulation, t, {a, b, c});
}

/// Makes a point the next vertex; the straight walk finds its triangle. `point.label` leads from its chart to the chart
/// of triangle t. Returns false, with nothing changed, if there already is a vertex at the point.
inline bool insert_by_flips(Triangulation& triangulation, TriangleId t, const LiftedPoint& point,
                            Journal* journal = nullptr) {
  return epsnet::insert_by_flips(triangulation, t, point, Walk::straight, kAnySteps, journal).has_value();
}

/// Returns the Delaunay triangulation of a surface's own vertices and `points` random points.
inline Triangulation any_delaunay(const Surface& surface, std::uint32_t points) {
  Triangulation triangulation(surface);
  make_delaunay(triangulation);
  for (std::uint32_t i = 0; i < points; ++i) {
    const auto t = any_triangle(triangulation);
    static_cast<void>(insert_by_flips(triangulation, t, any_point(triangulation, t)));
  }
  return triangulation;
}

/// Returns the sum of the triangles' areas, by lifts with 256 bits: 4π(g − 1) if they cover the surface once.
inline double total_area(Triangulation& triangulation) {
  double area = 0;
  for (const TriangleId t : triangulation.triangles()) {
    std::array<Complex<Mp256>, 3> p;
    for (std::uint32_t i = 0; i < 3; ++i) {
      p[i] = triangulation.lift_in<Mp256>(triangulation.corner(t, i));
    }
    const Isometry<Mp256> to_origin = Isometry<Mp256>::translation(-p[0]);
    const Complex<Mp256> u = to_origin(p[1]);
    const Complex<Mp256> v = to_origin(p[2]);
    // The triangle (0, u, v) has the area 2 arg(1 − u v̄).
    area += 2 * std::atan2(static_cast<double>(cross(u, v)), static_cast<double>(Mp256(1) - dot(u, v)));
  }
  return area;
}

inline double area_of(const Surface& surface) { return 4 * std::numbers::pi * (surface.genus() - 1); }

}  // namespace epsnet::test
