#include "triangulation/mesh/triangulation.h"

#include <algorithm>
#include <cassert>
#include <mpfr.h>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "triangulation/mesh/operations.h"

namespace epsnet {
namespace {

template <class T>
std::array<T, 2> enclosure(const Rational& x) {
  std::array<T, 2> ends;
  for (const std::size_t end : {0u, 1u}) {
    // Every operation is monotonous, and rounded in the same direction.
    const mpfr_rnd_t direction = end == 0 ? MPFR_RNDD : MPFR_RNDU;
    mpfr_t value;
    // With bits to spare, so that the two ends are neighbours whatever x is (the near-origin stages need that).
    mpfr_init2(value, kMantissaBits<T> + 64);
    mpfr_set_q(value, x.backend().data(), direction);
    mpfr_sinh(value, value, direction);
    mpfr_sqr(value, value, direction);
    if constexpr (std::is_same_v<T, double>) {
      ends[end] = mpfr_get_d(value, direction);
    } else {
      mpfr_set(ends[end].backend().data(), value, direction);
    }
    mpfr_clear(value);
  }
  return ends;
}

template <class T>
const std::array<T, 2>& computed_once(std::optional<std::array<T, 2>>& ends, const Rational& x) {
  if (!ends) {
    ends = enclosure<T>(x);
  }
  return *ends;
}

}  // namespace

Threshold::Threshold(Rational x) : x_(std::move(x)), ends_(enclosure<double>(x_)) { assert(x_ > 0); }

template <>
const std::array<double, 2>& Threshold::at<double>() const {
  return ends_;
}
template <>
const std::array<Mp256, 2>& Threshold::at<Mp256>() const {
  return computed_once(at_256_, x_);
}
template <>
const std::array<Mp1024, 2>& Threshold::at<Mp1024>() const {
  return computed_once(at_1024_, x_);
}
template <>
const std::array<Mp4096, 2>& Threshold::at<Mp4096>() const {
  return computed_once(at_4096_, x_);
}

void Triangulation::reserve(std::size_t vertices) {
  mesh_.points.reserve(vertices);
  mesh_.charts.reserve(vertices);
  mesh_.triangles.reserve(2 * vertices);
}

std::vector<Dart> Triangulation::star(Dart d) const {
  std::vector<Dart> darts;
  Dart e = d;
  do {
    darts.push_back(e);
    e = next_dart(opposite(e));
  } while (e != d);
  return darts;
}

LiftedPoint Triangulation::lifted_point(const BasePoint& point, TriangleId t) {
  const ChartId chart = atlas_.add_chart({point.tile, point.z});
  const ChartId there = chart_of(t);
  return {chart,
          {0, 0},
          atlas_.label(chart, there, path_between_tiles(surface(), point.tile, atlas_.charts()[there].tile))};
}

LabelId Triangulation::label_along(Dart d) {
  return atlas_.product(atlas_.inverse(corner(d).label), corner(next_dart(d)).label);
}

LabelId Triangulation::transition(Dart d) {
  const Triangle& t = triangle(triangle_of(d));
  const Dart e = t.opposite[corner_of(d)];
  const Triangle& other = triangle(triangle_of(e));
  if (t.all_identity() && other.all_identity()) {
    return kIdentity;
  }
  return lift_across(t.label(corner_of(d)), t.label(next(corner_of(d))), e);
}

template <class T, std::size_t N, class Stage>
StageSign Triangulation::multiprecision_stage(const std::array<Corner, N>& corners, const Stage& stage) {
  std::array<Complex<T>, N> points;
  for (std::size_t i = 0; i < N; ++i) {
    points[i] = atlas_.lift<T>(corners[i].label, mesh_.points[corners[i].vertex]);
  }
  return stage(points, Atlas::lift_error<T>());
}

template <std::size_t N, class Stage>
int Triangulation::staged(const std::array<Corner, N>& corners, const Stage& stage) {
  std::array<Complex<double>, N> points;
  double error = 0;
  for (std::size_t i = 0; i < N; ++i) {
    const Lift l = lift(corners[i]);
    points[i] = l.z;
    error = std::max(error, l.error);
  }
  StageSign result = stage(points, error);
  if (!result.certain) {
    ++multiprecision_;
    result = multiprecision_stage<Mp256>(corners, stage);
  }
  if (!result.certain) {
    result = multiprecision_stage<Mp1024>(corners, stage);
  }
  if (!result.certain) {
    result = multiprecision_stage<Mp4096>(corners, stage);
  }
  return result.sign;
}

int Triangulation::in_circle(Corner a, Corner b, Corner c, Corner d) {
  return staged(std::array{a, b, c, d}, []<class T>(const std::array<Complex<T>, 4>& p, const T& error) {
    return in_circle_stage<T>(p[0], p[1], p[2], p[3], error);
  });
}

int Triangulation::orientation(Corner a, Corner b, Corner c) {
  return staged(std::array{a, b, c}, []<class T>(const std::array<Complex<T>, 3>& p, const T& error) {
    return orientation_stage<T>(p[0], p[1], p[2], error);
  });
}

int Triangulation::compare_circumradius_staged(TriangleId t, const Threshold& s) {
  return staged(std::array{corner(t, 0), corner(t, 1), corner(t, 2)},
                [&s]<class T>(const std::array<Complex<T>, 3>& p, const T& error) {
                  const auto& [low, high] = s.at<T>();
                  return circumradius_stage<T>(p[0], p[1], p[2], low, high, error);
                });
}

int Triangulation::compare_distance_staged(Corner a, Corner b, const Threshold& s) {
  return staged(std::array{a, b}, [&s]<class T>(const std::array<Complex<T>, 2>& p, const T& error) {
    const auto& [low, high] = s.at<T>();
    return distance_stage<T>(p[0], p[1], low, high, error);
  });
}

bool Triangulation::is_delaunay(Dart d) {
  const TriangleId t = triangle_of(d);
  const Dart e = opposite(d);
  const LabelId across = transition(d);
  return in_circle(corner(t, 0), corner(t, 1), corner(t, 2),
                   moved(across, corner(triangle_of(e), previous(corner_of(e))))) <= 0;
}

// The triangulation that a surface starts with: its tiles cut into triangles.

namespace {

/// The triangles of the tiles of a surface, for a triangulation that has none.
class Cutting {
 public:
  explicit Cutting(Triangulation& triangulation)
      : triangulation_(triangulation),
        surface_(triangulation.surface()),
        atlas_(Editor(triangulation).atlas()),
        editor_(triangulation) {}

  void cut_tiles(const std::optional<BasePoint>& base);
  /// The centres of all tiles are the vertices, that of one tile is vertex 0. Requires: a regular surface.
  void cut_around_classes(TileId first_tile);

 private:
  /// Makes the vertex classes vertices, from number `first_class` on, each the origin of a chart of its first corner.
  /// Returns the words from the tiles of these first corners to the tiles of all corners of the class, by corner.
  [[nodiscard]] ById<SideId, Word> add_vertex_classes(std::uint32_t first_class);
  /// Cuts a polygon with these corners into triangles: around a vertex inside of it, or again and again into halves, by
  /// diagonals, so that few triangles have corners far apart. Returns the darts of its sides, from corner k to k + 1.
  [[nodiscard]] std::vector<Dart> cut_around(Corner centre, const std::vector<Corner>& corners);
  [[nodiscard]] std::vector<Dart> cut_by_halves(const std::vector<Corner>& corners);
  /// The same for n corners; `set_corners(t, i, m, j)` sets those of triangle t to the polygon's, i < m < j.
  template <class SetCorners>
  [[nodiscard]] std::vector<Dart> cut_by_halves(std::uint32_t n, const SetCorners& set_corners);
  /// Glues the triangles along the sides of the tiles.
  void glue_sides(const ById<SideId, Dart>& dart_of_side);

  Triangulation& triangulation_;
  const Surface& surface_;
  Atlas& atlas_;
  Editor editor_;
};

void Cutting::cut_tiles(const std::optional<BasePoint>& base) {
  const std::uint32_t first_class = base ? 1 : 0;  // The number of vertex class 0 as a vertex.
  if (base) {
    editor_.add_vertex({{0, 0}, atlas_.add_chart({base->tile, base->z})});
  }
  const ById<SideId, Word> words = add_vertex_classes(first_class);
  ById<SideId, Dart> dart_of_side;
  for (const TileId tile : surface_.tile_ids()) {
    const SideId first = surface_.side_number(tile, 0);
    // The corners lifted to one chart: the base point's, or that of the tile's first corner.
    const bool has_base = base && base->tile == tile;
    const ChartId reference =
        editor_.charts()[has_base ? VertexId(0) : VertexId(first_class + surface_.vertex_class(first))];
    const Word to_reference = has_base ? Word{} : reversed(surface_, words[first]);
    std::vector<Corner> corners;
    for (const SideId side : surface_.sides_of(tile)) {
      const VertexId v(first_class + surface_.vertex_class(side));
      corners.push_back(
          {v, atlas_.label(editor_.charts()[v], reference, concatenated(surface_, words[side], to_reference))});
    }
    const std::vector<Dart> darts = has_base ? cut_around({VertexId(0), kIdentity}, corners) : cut_by_halves(corners);
    dart_of_side.insert(dart_of_side.end(), darts.begin(), darts.end());
  }
  glue_sides(dart_of_side);
}

ById<SideId, Word> Cutting::add_vertex_classes(std::uint32_t first_class) {
  ById<SideId, Word> words(surface_.side_count());
  editor_.points().resize(first_class + surface_.vertex_class_count());
  editor_.charts().resize(editor_.points().size());
  std::vector<bool> placed(surface_.vertex_class_count(), false);
  for (const SideId corner : words.ids()) {
    const std::uint32_t v = surface_.vertex_class(corner);
    if (placed[v]) {
      continue;
    }
    placed[v] = true;
    const TileId tile = surface_.tile_of_side(corner);
    editor_.charts()[VertexId(first_class + v)] =
        atlas_.add_chart({tile, surface_.tile(tile)[surface_.place_in_tile(corner)]});
    const Word cycle = surface_.corner_cycle(corner);
    // To corner i of the cycle leads the first part of it, or the rest of it backwards: the shorter one.
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const auto here = cycle.begin() + static_cast<std::ptrdiff_t>(i);
      words[cycle[i]] = 2 * i <= cycle.size() ? concatenated(surface_, {}, Word(cycle.begin(), here))
                                              : reversed(surface_, concatenated(surface_, {}, Word(here, cycle.end())));
    }
  }
  return words;
}

std::vector<Dart> Cutting::cut_around(Corner centre, const std::vector<Corner>& corners) {
  std::vector<Dart> darts;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const TriangleId t = editor_.add_triangle();
    editor_.set(t, centre, corners[k], corners[(k + 1) % corners.size()]);
    darts.push_back(make_dart(t, 1));
  }
  for (std::size_t k = 0; k < darts.size(); ++k) {
    editor_.link(next_dart(darts[k]), previous_dart(darts[(k + 1) % darts.size()]));
  }
  return darts;
}

template <class SetCorners>
std::vector<Dart> Cutting::cut_by_halves(std::uint32_t n, const SetCorners& set_corners) {
  // A triangle (i, m, j) under the chord from i to j, then the chords (i, m) and (m, j).
  struct Chord {
    std::uint32_t i, j;
    std::optional<Dart> above;  // The dart from i to j of the triangle on its other side.
  };
  std::vector<Dart> darts(n);
  std::vector<Chord> chords{{0, n - 1, std::nullopt}};
  while (!chords.empty()) {
    const Chord chord = chords.back();
    chords.pop_back();
    if (chord.j == chord.i + 1) {
      darts[chord.i] = *chord.above;
      continue;
    }
    const std::uint32_t m = (chord.i + chord.j) / 2;
    const TriangleId t = editor_.add_triangle();
    set_corners(t, chord.i, m, chord.j);
    if (chord.above) {
      editor_.link(make_dart(t, 2), *chord.above);
    } else {
      darts[n - 1] = make_dart(t, 2);  // The side from the last corner to the first.
    }
    chords.push_back({chord.i, m, make_dart(t, 0)});
    chords.push_back({m, chord.j, make_dart(t, 1)});
  }
  return darts;
}

std::vector<Dart> Cutting::cut_by_halves(const std::vector<Corner>& corners) {
  return cut_by_halves(static_cast<std::uint32_t>(corners.size()),
                       [&](TriangleId t, std::uint32_t i, std::uint32_t m, std::uint32_t j) {
                         editor_.set(t, corners[i], corners[m], corners[j]);
                       });
}

void Cutting::glue_sides(const ById<SideId, Dart>& dart_of_side) {
  for (const SideId s : dart_of_side.ids()) {
    const Dart d = dart_of_side[s];
    editor_.triangles()[triangle_of(d)].opposite[corner_of(d)] = dart_of_side[surface_.partner(s)];
  }
}

void Cutting::cut_around_classes(TileId first_tile) {
  // Vertex 0 is the centre of `first_tile`; that of tile 0 stands in its place.
  const auto exchanged = [&](TileId tile) {
    return tile == first_tile ? TileId(0) : tile == TileId(0) ? first_tile : tile;
  };
  const auto vertex = [&](TileId tile) { return VertexId(exchanged(tile).number()); };
  for (const TileId tile : surface_.tile_ids()) {
    editor_.add_vertex({{0, 0}, atlas_.add_chart({exchanged(tile), {0, 0}})});
  }
  ById<SideId, Dart> dart_of_side(surface_.side_count());
  std::vector<bool> done(surface_.vertex_class_count(), false);
  for (const SideId corner : surface_.side_ids()) {
    if (done[surface_.vertex_class(corner)]) continue;
    done[surface_.vertex_class(corner)] = true;
    // The centres of the tiles around the class make a polygon, dual to it. Its corners are cocircular, so it may be
    // cut in any way. Corner i of the polygon, counterclockwise, is copy n − i of a tile, and copy k + 1 is behind side
    // cycle[k] of copy k.
    const Word cycle = surface_.corner_cycle(corner);
    const auto n = static_cast<std::uint32_t>(cycle.size());
    const auto centre = [&](std::uint32_t i) { return vertex(surface_.tile_of_side(cycle[(n - i) % n])); };
    // The path from corner j to corner i < j is the shorter one of the two around the class.
    const auto lifted = [&](std::uint32_t i, std::uint32_t j) -> Corner {
      const auto from = cycle.begin() + (n - j);
      const auto to = cycle.begin() + (n - i);
      Word word(from, to);
      if (2 * (j - i) > n) {
        word.assign(to, cycle.end());
        word.insert(word.end(), cycle.begin(), from);
        word = reversed(surface_, word);
      }
      return {centre(j), atlas_.label(editor_.charts()[centre(j)], editor_.charts()[centre(i)], std::move(word))};
    };
    const std::vector<Dart> darts =
        cut_by_halves(n, [&](TriangleId t, std::uint32_t i, std::uint32_t m, std::uint32_t j) {
          editor_.set(t, {centre(i), kIdentity}, lifted(i, m), lifted(i, j));
        });
    // Its side from corner i to i + 1 crosses a side of a tile.
    for (std::uint32_t i = 0; i < n; ++i) dart_of_side[cycle[n - i - 1]] = darts[i];
  }
  glue_sides(dart_of_side);
}

}  // namespace

Triangulation::Triangulation(const Surface& surface, const std::optional<BasePoint>& base) : atlas_(surface) {
  if (base) {
    require_inside(surface, *base);
  }
  if (surface.is_regular() && (!base || base->z == Complex<Rational>{})) {
    Cutting(*this).cut_around_classes(base ? base->tile : TileId(0));
  } else {
    Cutting(*this).cut_tiles(base);
  }
}

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
