#include "triangulation/triangulation.h"

#include <algorithm>

namespace epsnet {
namespace {

constexpr std::uint32_t kMostTriangles = 1u << 30;

void require_tile(const Surface& surface, std::uint32_t tile) {
  if (tile >= surface.tiles().size()) {
    throw SurfaceError("the base point is in tile " + std::to_string(tile) + ", the surface has " +
                       std::to_string(surface.tiles().size()) + " tiles");
  }
}

/// The first side that the point is not strictly left of.
std::optional<std::size_t> side_not_left_of(const Tile& tile, const Complex<Rational>& z) {
  for (std::size_t k = 0; k < tile.size(); ++k) {
    if (norm(z) >= 1 || orientation_determinant(tile[k], tile[(k + 1) % tile.size()], z) <= 0) {
      return k;
    }
  }
  return std::nullopt;
}

void require_inside(const Surface& surface, const BasePoint& base) {
  require_tile(surface, base.tile);
  if (const auto side = side_not_left_of(surface.tiles()[base.tile], base.z)) {
    throw SurfaceError("the base point is not strictly inside of tile " + std::to_string(base.tile) +
                       ": not left of side " + std::to_string(*side));
  }
}

}  // namespace

Triangulation::Triangulation(const Surface& surface, const std::optional<BasePoint>& base) : atlas_(surface) {
  if (base) {
    require_inside(surface, *base);
  }
  if (surface.is_regular() && (!base || base->z == Complex<Rational>{})) {
    cut_regular();
  } else {
    cut_tiles(base);
  }
}

BasePoint centre_of_tile(const Surface& surface, std::uint32_t tile) {
  if (surface.is_regular()) {
    return {tile, {0, 0}};
  }
  require_tile(surface, tile);
  const Tile& vertices = surface.tiles()[tile];
  Complex<Mp1024> sum;
  for (const Complex<Rational>& vertex : vertices) sum = sum + to_klein(convert<Mp1024>(vertex));
  const Complex<Mp1024> centre = from_klein(Mp1024(Mp1024(1) / vertices.size()) * sum);
  // As few bits as are enough.
  for (int bits = 8;; bits *= 2) {
    const Mp1024 scale = ldexp(Mp1024(1), bits);
    const Complex<Rational> z{Rational(Mp1024(round(Mp1024(centre.x * scale)) / scale)),
                              Rational(Mp1024(round(Mp1024(centre.y * scale)) / scale))};
    if (!side_not_left_of(vertices, z) || bits > 1024) {
      return {tile, z};
    }
  }
}

void Triangulation::cut_tiles(const std::optional<BasePoint>& base) {
  const Surface& surface = atlas_.surface();
  const std::uint32_t first_class = base ? 1 : 0;  // The number of vertex class 0 as a vertex.
  if (base) {
    add_vertex({{0, 0}, atlas_.add_chart({base->tile, base->z})});
  }
  const std::vector<Word> words = add_vertex_classes(first_class);
  std::vector<Dart> dart_of_side;
  for (std::uint32_t tile = 0; tile < surface.tiles().size(); ++tile) {
    const std::uint32_t first = surface.side_number(tile, 0);
    // The corners lifted to one chart: the base point's, or that of the tile's first corner.
    const bool has_base = base && base->tile == tile;
    const std::uint32_t reference = has_base ? charts_[0] : charts_[first_class + surface.vertex_class(first)];
    const Word to_reference = has_base ? Word{} : reversed(surface, words[first]);
    std::vector<Corner> corners;
    for (std::uint32_t side = first; side < first + surface.tiles()[tile].size(); ++side) {
      const std::uint32_t v = first_class + surface.vertex_class(side);
      corners.push_back({v, atlas_.label(charts_[v], reference, concatenated(surface, words[side], to_reference))});
    }
    const std::vector<Dart> darts = has_base ? cut_around({0, kIdentity}, corners) : cut_by_halves(corners);
    dart_of_side.insert(dart_of_side.end(), darts.begin(), darts.end());
  }
  glue_sides(dart_of_side);
}

std::vector<Word> Triangulation::add_vertex_classes(std::uint32_t first_class) {
  const Surface& surface = atlas_.surface();
  std::vector<Word> words(surface.side_count());
  points_.resize(first_class + surface.vertex_class_count());
  charts_.resize(points_.size());
  std::vector<bool> placed(surface.vertex_class_count(), false);
  for (std::uint32_t corner = 0; corner < words.size(); ++corner) {
    const std::uint32_t v = surface.vertex_class(corner);
    if (placed[v]) {
      continue;
    }
    placed[v] = true;
    const std::uint32_t tile = surface.tile_of_side(corner);
    charts_[first_class + v] = atlas_.add_chart({tile, surface.tiles()[tile][corner - surface.side_number(tile, 0)]});
    const Word cycle = surface.corner_cycle(corner);
    // To corner i of the cycle leads the first part of it, or the rest of it backwards: the shorter one.
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const auto here = cycle.begin() + static_cast<std::ptrdiff_t>(i);
      words[cycle[i]] = 2 * i <= cycle.size() ? concatenated(surface, {}, Word(cycle.begin(), here))
                                              : reversed(surface, concatenated(surface, {}, Word(here, cycle.end())));
    }
  }
  return words;
}

std::vector<Dart> Triangulation::cut_around(Corner centre, const std::vector<Corner>& corners) {
  const std::uint32_t first = triangle_count();
  std::vector<Dart> darts;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::uint32_t t = add_triangle();
    set(t, centre, corners[k], corners[(k + 1) % corners.size()], nullptr);
    darts.push_back(make_dart(t, 1));
  }
  for (std::uint32_t t = first; t < triangle_count(); ++t) {
    link(make_dart(t, 2), make_dart(t + 1 < triangle_count() ? t + 1 : first, 0), nullptr);
  }
  return darts;
}

template <class SetCorners>
std::vector<Dart> Triangulation::cut_by_halves(std::uint32_t n, const SetCorners& set_corners) {
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
    const std::uint32_t t = add_triangle();
    set_corners(t, chord.i, m, chord.j);
    if (chord.above) {
      link(make_dart(t, 2), *chord.above, nullptr);
    } else {
      darts[n - 1] = make_dart(t, 2);  // The side from the last corner to the first.
    }
    chords.push_back({chord.i, m, make_dart(t, 0)});
    chords.push_back({m, chord.j, make_dart(t, 1)});
  }
  return darts;
}

std::vector<Dart> Triangulation::cut_by_halves(const std::vector<Corner>& corners) {
  return cut_by_halves(static_cast<std::uint32_t>(corners.size()),
                       [&](std::uint32_t t, std::uint32_t i, std::uint32_t m, std::uint32_t j) {
                         set(t, corners[i], corners[m], corners[j], nullptr);
                       });
}

void Triangulation::glue_sides(const std::vector<Dart>& dart_of_side) {
  for (std::uint32_t s = 0; s < dart_of_side.size(); ++s) {
    const Dart d = dart_of_side[s];
    triangles_[triangle_of(d)].opposite[corner_of(d)] = dart_of_side[surface().partner(s)];
  }
}

void Triangulation::cut_regular() {
  // The centres of the copies of the tile around a corner make a polygon, dual to the tile: one vertex on the surface.
  // Its corners are cocircular, so it may be cut in any way.
  const Surface& surface = atlas_.surface();
  const std::uint32_t n = surface.side_count();
  add_vertex({{0, 0}, atlas_.add_chart({0, {0, 0}})});
  const Word cycle = surface.corner_cycle(0);
  // Corner i of the polygon, counterclockwise, is copy n − i of the tile, and copy k + 1 is behind side cycle[k] of
  // copy k. The path from corner j to corner i < j is the shorter one of the two around the tile's corner.
  const auto label = [&](std::uint32_t i, std::uint32_t j) {
    const auto from = cycle.begin() + (n - j);
    const auto to = cycle.begin() + (n - i);
    Word word(from, to);
    if (2 * (j - i) > n) {
      word.assign(to, cycle.end());
      word.insert(word.end(), cycle.begin(), from);
      word = reversed(surface, word);
    }
    return atlas_.label(0, 0, std::move(word));
  };
  const std::vector<Dart> darts =
      cut_by_halves(n, [&](std::uint32_t t, std::uint32_t i, std::uint32_t m, std::uint32_t j) {
        set(t, {0, kIdentity}, {0, label(i, m)}, {0, label(i, j)}, nullptr);
      });
  // Its side from corner i to i + 1 crosses a side of the tile.
  std::vector<Dart> dart_of_side(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    dart_of_side[cycle[n - i - 1]] = darts[i];
  }
  glue_sides(dart_of_side);
}

void Triangulation::require_room(std::size_t triangles) const {
  if (triangles_.size() + triangles > kMostTriangles) {
    throw LimitError("more than 2^30 triangles");
  }
}

void Triangulation::reserve(std::size_t vertices) {
  points_.reserve(vertices);
  charts_.reserve(vertices);
  triangles_.reserve(2 * vertices);
}

void Triangulation::record(std::uint32_t t, Journal* journal) const {
  if (journal != nullptr && t < journal->triangles) {
    journal->overwritten.emplace_back(t, triangles_[t]);
  }
}

void Triangulation::undo(const Journal& journal) {
  for (auto it = journal.overwritten.rbegin(); it != journal.overwritten.rend(); ++it) {
    triangles_[it->first] = it->second;
  }
  triangles_.resize(journal.triangles);
  points_.resize(journal.vertices);
  charts_.resize(journal.vertices);
}

void Triangulation::link(Dart d, Dart e, Journal* journal) {
  record(triangle_of(e), journal);
  triangles_[triangle_of(d)].opposite[corner_of(d)] = e;
  triangles_[triangle_of(e)].opposite[corner_of(e)] = d;
}

void Triangulation::set(std::uint32_t t, Corner c0, Corner c1, Corner c2, Journal* journal) {
  record(t, journal);
  Triangle& triangle = triangles_[t];
  std::uint64_t labels = 0;
  if ((c0.label | c1.label | c2.label) != kIdentity) {
    const LabelId back = atlas_.inverse(c0.label);
    const LabelId l1 = atlas_.product(back, c1.label);
    const LabelId l2 = atlas_.product(back, c2.label);
    if (l1 > kLargestLabel || l2 > kLargestLabel) {
      throw LimitError("more than 2^24 labels");
    }
    labels = packed(l1, l2);
  }
  triangle.vertex = {c0.vertex, c1.vertex, c2.vertex};
  triangle.labels_and_mark = labels;
}

LabelId Triangulation::transition(Dart d) {
  const Triangle& t = triangles_[triangle_of(d)];
  const Dart e = t.opposite[corner_of(d)];
  const Triangle& other = triangles_[triangle_of(e)];
  if (t.all_identity() && other.all_identity()) {
    return kIdentity;
  }
  return lift_across(t.label(corner_of(d)), t.label(next(corner_of(d))), e);
}

template <class T, std::size_t N, class Stage>
StageSign Triangulation::multiprecision_stage(const std::array<Corner, N>& corners, const Stage& stage) {
  std::array<Complex<T>, N> points;
  for (std::size_t i = 0; i < N; ++i) {
    points[i] = atlas_.lift<T>(corners[i].label, points_[corners[i].vertex]);
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

int Triangulation::compare_circumradius_staged(std::uint32_t t, const Threshold& s) {
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

std::optional<Complex<double>> Triangulation::circumcentre_fast(std::uint32_t t) const {
  const Triangle& triangle = triangles_[t];
  const auto lifted = [&](std::uint32_t i) {
    const Complex<double>& z = points_[triangle.vertex[i]];
    return triangle.label(i) == kIdentity ? z : atlas_.isometry(triangle.label(i))(z);
  };
  const Complex<double> a = points_[triangle.vertex[0]];
  const Complex<double> b = lifted(1);
  const Complex<double> c = lifted(2);
  // The angle at a must be neither near 0 nor near π; circumcentre_near_origin itself sees circles that are too large.
  const Complex<double> u = b - a;
  const Complex<double> v = c - a;
  const double sine = cross(u, v);
  if (!(sine * sine > 1e-6 * (norm(u) * norm(v)))) {
    return std::nullopt;
  }
  // The error of a lift turns a short edge, and the circle's diameter with it: the centre would be off by many lengths
  // of that edge, as many turns around a short curve.
  constexpr double kShortestLifted2 = 1e-12;
  if (!triangle.all_identity() && std::min({norm(u), norm(v), norm(b - c)}) < kShortestLifted2) {
    return std::nullopt;
  }
  return circumcentre_near_origin(a, b, c);
}

template <class T>
std::optional<Complex<Mp1024>> Triangulation::circumcentre_precise(std::uint32_t t) {
  std::array<Complex<T>, 3> p;
  for (std::uint32_t i = 0; i < 3; ++i) {
    p[i] = atlas_.lift<T>(triangles_[t].label(i), points_[triangles_[t].vertex[i]]);
  }
  const auto centre = epsnet::circumcentre(p[0], p[1], p[2]);
  return centre ? std::optional(convert<Mp1024>(*centre)) : std::nullopt;
}
template std::optional<Complex<Mp1024>> Triangulation::circumcentre_precise<Mp256>(std::uint32_t);
template std::optional<Complex<Mp1024>> Triangulation::circumcentre_precise<Mp1024>(std::uint32_t);

bool Triangulation::is_delaunay(Dart d) {
  const std::uint32_t t = triangle_of(d);
  const Dart e = opposite(d);
  const LabelId across = transition(d);
  return in_circle(corner(t, 0), corner(t, 1), corner(t, 2),
                   moved(across, corner(triangle_of(e), previous(corner_of(e))))) <= 0;
}

Dart Triangulation::flip(Dart d, Journal* journal) {
  const Dart e = opposite(d);
  const std::uint32_t t = triangle_of(d);
  const std::uint32_t s = triangle_of(e);
  const LabelId across = transition(d);
  const Corner a = corner(t, corner_of(d));
  const Corner b = corner(t, next(corner_of(d)));
  const Corner c = corner(t, previous(corner_of(d)));
  const Corner f = moved(across, corner(s, previous(corner_of(e))));
  // The four outer darts move; where the two triangles share more edges, their opposites move along.
  const std::array<std::pair<Dart, Dart>, 4> moves{{{next_dart(d), make_dart(s, 1)},
                                                    {previous_dart(d), make_dart(t, 0)},
                                                    {next_dart(e), make_dart(t, 1)},
                                                    {previous_dart(e), make_dart(s, 0)}}};
  std::array<Dart, 4> outer{};
  for (std::size_t i = 0; i < 4; ++i) {
    outer[i] = opposite(moves[i].first);
    for (const auto& [from, to] : moves) {
      if (opposite(moves[i].first) == from) {
        outer[i] = to;
      }
    }
  }
  set(t, c, a, f, journal);
  set(s, f, b, c, journal);
  for (std::size_t i = 0; i < 4; ++i) {
    link(moves[i].second, outer[i], journal);
  }
  link(make_dart(t, 2), make_dart(s, 2), journal);
  return make_dart(t, 2);
}

std::uint64_t Triangulation::restore_delaunay(std::vector<Dart>& pending, Journal* journal) {
  std::uint64_t flips = 0;
  while (!pending.empty()) {
    const Dart d = pending.back();
    pending.pop_back();
    if (!is_delaunay(d)) {
      const bool untwisted = untwist(d, journal);
      const Dart f = untwisted ? d : flip(d, journal);
      ++flips;
      if (untwisted) pending.push_back(d);
      for (const Dart side : {next_dart(f), previous_dart(f), next_dart(opposite(f)), previous_dart(opposite(f))}) {
        pending.push_back(side);
      }
    }
  }
  return flips;
}

std::uint64_t Triangulation::make_delaunay() {
  std::vector<Dart> pending;
  for (std::uint32_t t = 0; t < triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (make_dart(t, i) < opposite(make_dart(t, i))) {
        pending.push_back(make_dart(t, i));
      }
    }
  }
  return restore_delaunay(pending);
}

Location Triangulation::classify(Dart d, LabelId transition_to_start, Corner p, std::uint32_t steps) {
  const std::uint32_t t = triangle_of(d);
  std::array<int, 3> signs{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    signs[i] = orientation(moved(transition_to_start, corner(t, i)), moved(transition_to_start, corner(t, next(i))), p);
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

Location Triangulation::locate_visibility(std::uint32_t start, Corner p, std::uint32_t most_steps) {
  std::uint32_t t = start;
  LabelId lift_of_t = kIdentity;
  std::uint32_t steps = 0;
  std::uint32_t entered = 3;  // The edge through which t was entered: p is not behind it.
  for (;;) {
    std::uint32_t exit = 3;
    for (std::uint32_t k = 1; k <= 3 && exit == 3; ++k) {
      const std::uint32_t i = (entered + k) % 3;
      if (i != entered && orientation(moved(lift_of_t, corner(t, i)), moved(lift_of_t, corner(t, next(i))), p) < 0) {
        exit = i;
      }
    }
    if (exit == 3) {
      return classify(make_dart(t, 0), lift_of_t, p, steps);
    }
    const Dart d = make_dart(t, exit);
    if (steps == most_steps) {
      return {Location::Type::not_found, d, lift_of_t, steps};
    }
    lift_of_t = atlas_.product(lift_of_t, transition(d));
    const Dart e = opposite(d);
    t = triangle_of(e);
    entered = corner_of(e);
    ++steps;
  }
}

Location Triangulation::locate_straight(std::uint32_t start, Corner p, std::uint32_t most_steps) {
  std::uint32_t steps = 0;
  Dart d = make_dart(start, 0);  // Leaves the corner the walk starts from, whatever triangle it turns to.
  LabelId lift_of_t = kIdentity;
  const Corner origin = corner(start, 0);
  const auto cross = [&](Dart side) {
    lift_of_t = atlas_.product(lift_of_t, transition(side));
    ++steps;
    return opposite(side);
  };
  const auto lifted = [&](Dart from) { return moved(lift_of_t, corner(triangle_of(from), corner_of(from))); };
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
  return classify(d, lift_of_t, p, steps);
}

std::string Triangulation::problem() {
  std::vector<std::uint64_t> darts_leaving(vertex_count(), 0);
  std::vector<Dart> some_dart(vertex_count(), 0);
  const auto say = [](std::string_view what, Dart d) {
    return std::string(what) + " at triangle " + std::to_string(triangle_of(d)) + ", edge " +
           std::to_string(corner_of(d));
  };
  for (std::uint32_t t = 0; t < triangle_count(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Dart d = make_dart(t, i);
      const Dart e = opposite(d);
      if (triangle_of(e) >= triangle_count() || corner_of(e) > 2 || opposite(e) != d || e == d) {
        return say("opposite is not an involution without fixed point", d);
      }
      const Corner start = corner(t, i);
      const Corner end = corner(t, next(i));
      const LabelId across = transition(d);
      if (start != moved(across, corner(triangle_of(e), next(corner_of(e)))) ||
          end != moved(across, corner(triangle_of(e), corner_of(e)))) {
        return say("the lifts on the two sides differ", d);
      }
      if (start.label != kIdentity
              ? atlas_.from(start.label) != charts_[start.vertex] || atlas_.to(start.label) != chart_of(t)
              : charts_[start.vertex] != chart_of(t)) {
        return say("a label leads from or to another chart", d);
      }
      ++darts_leaving[start.vertex];
      some_dart[start.vertex] = d;
    }
    if (orientation(corner(t, 0), corner(t, 1), corner(t, 2)) <= 0) {
      return say("not counterclockwise", make_dart(t, 0));
    }
  }
  for (std::uint32_t v = 0; v < vertex_count(); ++v) {
    std::uint64_t turned = 0;
    if (darts_leaving[v] > 0) {
      Dart d = some_dart[v];
      do {
        d = next_dart(opposite(d));
        ++turned;
      } while (d != some_dart[v] && turned <= darts_leaving[v]);
    }
    if (turned == 0 || turned != darts_leaving[v]) {
      return "the darts that leave vertex " + std::to_string(v) + " do not form one cycle";
    }
    if (norm(points_[v]) > kChartRadius * kChartRadius) {
      return "vertex " + std::to_string(v) + " is far from the origin of its chart";
    }
  }
  const std::int64_t euler = std::int64_t{vertex_count()} - std::int64_t{triangle_count()} / 2;
  if (triangle_count() % 2 != 0 || euler != 2 - 2 * std::int64_t{surface().genus()}) {
    return "V - E + F is " + std::to_string(euler) + " on a surface of genus " + std::to_string(surface().genus());
  }
  return {};
}

}  // namespace epsnet
