#include "tests/support/triangulations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "certify/file/file.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/mesh/insertion.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet::test {

const std::deque<NamedSurface>& gallery() {
  static const std::deque<NamedSurface> surfaces = [] {
    std::deque<NamedSurface> result;
    for (const std::int32_t seed : {1, 123, 321}) {
      result.push_back({"octagon " + std::to_string(seed), random_octagon(seed)});
    }
    for (const char* name : {"g2-small", "g2-theta", "g2-thin-1e-4", "g3-rnd0", "g4-treeloops", "g5-rnd0", "g8-rnd0"}) {
      const std::string path = std::string(EPSNET_TEST_DATA) + "/polygons/polygon-" + name + ".txt";
      result.push_back({name, import_surface(certify::load(path), path)});
    }
    return result;
  }();
  return surfaces;
}

const std::deque<NamedSurface>& tiled_gallery() {
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

const NamedSurface& any_surface() {
  const auto i = any_index(gallery().size());
  RC_TAG(gallery()[i].name);
  return gallery()[i];
}

const NamedSurface& any_tiled_surface() {
  const auto i = any_index(tiled_gallery().size());
  RC_TAG(tiled_gallery()[i].name);
  return tiled_gallery()[i];
}

double any_share() { return std::ldexp(static_cast<double>(any_index<std::uint32_t>(1u << 30)), -30); }

void set_cuff_length(FenchelNielsen& coordinates, std::size_t edge, const Rational& length) {
  coordinates.twists[edge] *= length / coordinates.lengths[edge];
  coordinates.lengths[edge] = length;
}

FenchelNielsen any_coordinates(std::uint32_t genus, double shortest, double longest) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(genus, any_index(1000u)), any_index(1000u));
  for (std::size_t edge = 0; edge < coordinates.lengths.size(); ++edge) {
    set_cuff_length(coordinates, edge, Rational(shortest * std::pow(longest / shortest, any_share())));
  }
  return coordinates;
}

Word any_word(const Surface& surface, TileId tile, std::size_t longest) {
  Word word;
  const std::size_t length = any_index<std::size_t>(longest + 1);
  while (word.size() < length) {
    const auto sides = static_cast<std::uint32_t>(surface.tile(tile).size());
    word.push_back(surface.side_number(tile, any_index(sides)));
    tile = surface.tile_of_side(surface.partner(word.back()));
  }
  return word;
}

TileId end_tile(const Surface& surface, TileId tile, const Word& word) {
  return word.empty() ? tile : surface.tile_of_side(surface.partner(word.back()));
}

TriangleId any_triangle(const Triangulation& triangulation) {
  return TriangleId(any_index(triangulation.triangle_count()));
}

VertexId any_vertex(const Triangulation& triangulation) { return VertexId(any_index(triangulation.vertex_count())); }

LabelId between_corners(Triangulation& triangulation, TriangleId t, std::uint32_t i, std::uint32_t j,
                        Triangulation& reference) {
  const Triangle& triangle = triangulation.triangle(t);
  const LabelId label = triangulation.product(triangulation.inverse(triangle.label(i)), triangle.label(j));
  if (&reference == &triangulation || label == kIdentity) return label;
  const LabelTable::Entry& entry = triangulation.atlas().labels()[label];
  return Editor(reference).atlas().label(entry.from, entry.to, entry.word);
}

std::vector<Signature> triangles_of(Triangulation& triangulation, Triangulation& reference) {
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

std::vector<Signature> triangles_of(Triangulation& triangulation) { return triangles_of(triangulation, triangulation); }

Corner corner_across(Triangulation& triangulation, Dart d) {
  const Dart e = triangulation.opposite(d);
  return triangulation.moved(triangulation.transition(d), triangulation.corner(previous_dart(e)));
}

int delaunay_sign(Triangulation& triangulation, Dart d) {
  const TriangleId t = triangle_of(d);
  return triangulation.in_circle(triangulation.corner(t, 0), triangulation.corner(t, 1), triangulation.corner(t, 2),
                                 corner_across(triangulation, d));
}

std::vector<Signature> tessellation_of(Triangulation& triangulation, Triangulation& reference) {
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

std::vector<Signature> tessellation_of(Triangulation& triangulation) {
  return tessellation_of(triangulation, triangulation);
}

std::optional<Dart> not_delaunay(Triangulation& triangulation) {
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (!triangulation.is_delaunay(make_dart(t, i))) {
        return make_dart(t, i);
      }
    }
  }
  return std::nullopt;
}

bool flippable(Triangulation& triangulation, Dart d) {
  const Corner a = triangulation.corner(d);
  const Corner b = triangulation.corner(next_dart(d));
  const Corner c = triangulation.corner(previous_dart(d));
  const Corner f = corner_across(triangulation, d);
  return triangulation.orientation(c, a, f) > 0 && triangulation.orientation(f, b, c) > 0;
}

Dart any_dart(const Triangulation& triangulation) {
  const auto i = any_index<std::uint32_t>(3 * triangulation.triangle_count());
  return make_dart(TriangleId(i / 3), i % 3);
}

Snapshot snapshot(const Triangulation& triangulation) {
  Snapshot result;
  for (const VertexId v : triangulation.vertices()) {
    result.vertices.emplace_back(triangulation.vertex(v).z, triangulation.vertex(v).chart);
  }
  for (const TriangleId t : triangulation.triangles()) {
    result.triangles.push_back(triangulation.triangle(t));
  }
  return result;
}

LiftedPoint point_in(Triangulation& triangulation, TriangleId t, const Complex<Mp256>& z) {
  const ChartId chart = triangulation.chart_of(t);
  if (norm(z) <= Mp256(0.25)) {
    return {chart, convert<double>(z), kIdentity};
  }
  return triangulation.lifted_point(chart, convert<Mp1024>(z), Atlas::Precision::binary64).value();
}

LiftedPoint weighted_point(Triangulation& triangulation, TriangleId t, const std::array<double, 3>& w) {
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

LiftedPoint any_point(Triangulation& triangulation, TriangleId t) {
  const auto weight = [] { return 0.02 + any_share(); };
  const double a = weight();
  const double b = weight();
  const double c = weight();
  return weighted_point(triangulation, t, {a, b, c});
}

bool insert_by_flips(Triangulation& triangulation, TriangleId t, const LiftedPoint& point, Journal* journal) {
  return epsnet::insert_by_flips(triangulation, t, point, Walk::straight, kAnySteps, journal).has_value();
}

std::optional<std::vector<TriangleId>> insert_in_cavity(Triangulation& triangulation, TriangleId t, VertexId vertex,
                                                        LabelId label, const std::function<bool(Corner)>& accept,
                                                        Journal* journal) {
  Cavity cavity;
  const auto accepted = [&](const Cavity::Edge& e) { return accept(e.from); };
  if (!cavity.find(triangulation, t, {vertex, label}) || !std::ranges::all_of(cavity.boundary(), accepted)) {
    return std::nullopt;
  }
  const auto fan = cavity.fill(triangulation, {vertex, label}, journal);
  return std::vector<TriangleId>(fan.begin(), fan.end());
}

Triangulation any_delaunay(const Surface& surface, std::uint32_t points) {
  Triangulation triangulation(surface);
  make_delaunay(triangulation);
  for (std::uint32_t i = 0; i < points; ++i) {
    const auto t = any_triangle(triangulation);
    static_cast<void>(insert_by_flips(triangulation, t, any_point(triangulation, t)));
  }
  return triangulation;
}

double total_area(Triangulation& triangulation) {
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

double area_of(const Surface& surface) { return 4 * std::numbers::pi * (surface.genus() - 1); }

}  // namespace epsnet::test
