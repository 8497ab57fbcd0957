#include "epsnet/triangulation/triangulation.h"

#include <algorithm>
#include <deque>
#include <stdexcept>

namespace epsnet {
namespace {

constexpr LabelId kLargestLabel = (1u << 24) - 1;
constexpr std::uint32_t kMostTriangles = 1u << 30;

}  // namespace

Triangulation::Triangulation(const Surface& surface) : atlas_(surface) {
  // The corners of a class, in the order in which they follow each other around it, and the word from the first one's
  // tile to each.
  const std::uint32_t n = surface.side_count();
  std::vector<Word> words(n);
  points_.resize(surface.vertex_class_count());
  charts_.resize(surface.vertex_class_count());
  std::vector<bool> placed(surface.vertex_class_count(), false);
  std::uint32_t first_side = 0;
  for (std::uint32_t tile = 0; tile < surface.tiles().size(); ++tile) {
    const auto sides = static_cast<std::uint32_t>(surface.tiles()[tile].size());
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t v = surface.vertex_class(first_side + k);
      if (placed[v]) {
        continue;
      }
      placed[v] = true;
      charts_[v] = atlas_.add_chart({tile, surface.tiles()[tile][k]});
      // Side s, crossed, leads to the corner at the end of its partner: the start of the side after that one.
      std::vector<std::uint32_t> cycle;
      std::uint32_t corner = first_side + k;
      do {
        cycle.push_back(corner);
        const std::uint32_t partner = surface.partner(corner);
        const std::uint32_t its_tile = surface.tile_of_side(partner);
        const std::uint32_t its_first = surface.side_number(its_tile, 0);
        const auto its_sides = static_cast<std::uint32_t>(surface.tiles()[its_tile].size());
        corner = its_first + (partner - its_first + 1) % its_sides;
      } while (corner != cycle.front());
      // To corner i of the cycle leads the first part of it, or the rest of it backwards: the shorter one.
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        const auto here = cycle.begin() + static_cast<std::ptrdiff_t>(i);
        words[cycle[i]] = 2 * i <= cycle.size() ? concatenated(surface, {}, Word(cycle.begin(), here))
                                                : reversed(surface, concatenated(surface, {}, Word(here, cycle.end())));
      }
    }
    first_side += sides;
  }

  // Each tile is halved again and again by diagonals: a triangle (i, m, j) under the chord from i to j, then the chords
  // (i, m) and (m, j).
  std::vector<Dart> dart_of_side(n);
  for (std::uint32_t tile = 0; tile < surface.tiles().size(); ++tile) {
    const std::uint32_t base = surface.side_number(tile, 0);
    const auto sides = static_cast<std::uint32_t>(surface.tiles()[tile].size());
    const auto corner = [&](std::uint32_t k, std::uint32_t reference) -> Corner {
      const std::uint32_t v = surface.vertex_class(base + k);
      const std::uint32_t r = surface.vertex_class(base + reference);
      Word path = concatenated(surface, words[base + k], reversed(surface, words[base + reference]));
      return {v, k == reference ? kIdentity : atlas_.label(charts_[v], charts_[r], std::move(path))};
    };
    struct Chord {
      std::uint32_t i, j;
      std::optional<Dart> above;  // The dart from i to j of the triangle on its other side.
    };
    std::vector<Chord> chords{{0, sides - 1, std::nullopt}};
    while (!chords.empty()) {
      const Chord chord = chords.back();
      chords.pop_back();
      if (chord.j == chord.i + 1) {
        dart_of_side[base + chord.i] = *chord.above;
        continue;
      }
      const std::uint32_t m = (chord.i + chord.j) / 2;
      const std::uint32_t t = add_triangle();
      set(t, corner(chord.i, chord.i), corner(m, chord.i), corner(chord.j, chord.i), nullptr);
      if (chord.above) {
        link(make_dart(t, 2), *chord.above, nullptr);
      } else {
        dart_of_side[base + chord.j] = make_dart(t, 2);  // The side from the last corner to the first.
      }
      chords.push_back({chord.i, m, make_dart(t, 0)});
      chords.push_back({m, chord.j, make_dart(t, 1)});
    }
  }
  for (std::uint32_t s = 0; s < n; ++s) {
    triangles_[triangle_of(dart_of_side[s])].opposite[corner_of(dart_of_side[s])] = dart_of_side[surface.partner(s)];
  }
}

std::uint32_t Triangulation::add_triangle() {
  if (triangles_.size() >= kMostTriangles) {
    throw std::runtime_error("more than 2^30 triangles");
  }
  triangles_.push_back({});
  return static_cast<std::uint32_t>(triangles_.size() - 1);
}

std::uint32_t Triangulation::add_vertex(const Vertex& v) {
  points_.push_back(v.z);
  charts_.push_back(v.chart);
  return vertex_count() - 1;
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
      throw std::runtime_error("more than 2^24 labels");
    }
    labels = (std::uint64_t{l1} << 40) | (std::uint64_t{l2} << 16);
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
  return atlas_.product(t.label(corner_of(d)), atlas_.inverse(other.label(next(corner_of(e)))));
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
  const Lift a = lift(corner(t, 0));
  const Lift b = lift(corner(t, 1));
  const Lift c = lift(corner(t, 2));
  // The lifts must be well inside of the disk, and the angle at a neither 0 nor π; circumcentre itself sees horocycles.
  if (norm(b.z) > 0.95 || norm(c.z) > 0.95) {
    return std::nullopt;
  }
  const Complex<double> u = b.z - a.z;
  const Complex<double> v = c.z - a.z;
  const double sine = cross(u, v);
  if (!(sine * sine > 1e-6 * (norm(u) * norm(v)))) {
    return std::nullopt;
  }
  return epsnet::circumcentre(a.z, b.z, c.z);
}

std::optional<Complex<Mp256>> Triangulation::circumcentre_precise(std::uint32_t t) {
  std::array<Complex<Mp256>, 3> p;
  for (std::uint32_t i = 0; i < 3; ++i) {
    p[i] = atlas_.lift<Mp256>(triangles_[t].label(i), points_[triangles_[t].vertex[i]]);
  }
  return epsnet::circumcentre(p[0], p[1], p[2]);
}

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
      const Dart f = flip(d, journal);
      ++flips;
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

void Triangulation::split_face(std::uint32_t t, std::uint32_t vertex, LabelId label, Journal* journal) {
  cavity_ = {t};
  boundary_.clear();
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Dart d = make_dart(t, i);
    boundary_.push_back({d, opposite(d), corner(t, i), corner(t, next(i))});
  }
  fill_cavity({vertex, label}, journal);
}

void Triangulation::split_edge(Dart d, std::uint32_t vertex, LabelId label, Journal* journal) {
  const Dart e = opposite(d);
  const LabelId across = transition(d);
  cavity_ = {triangle_of(d), triangle_of(e)};
  boundary_.clear();
  for (const Dart side : {next_dart(d), previous_dart(d)}) {
    boundary_.push_back({side, opposite(side), corner(triangle_of(side), corner_of(side)),
                         corner(triangle_of(side), next(corner_of(side)))});
  }
  for (const Dart side : {next_dart(e), previous_dart(e)}) {
    boundary_.push_back({side, opposite(side), moved(across, corner(triangle_of(side), corner_of(side))),
                         moved(across, corner(triangle_of(side), next(corner_of(side))))});
  }
  fill_cavity({vertex, label}, journal);
}

bool Triangulation::find_cavity(std::uint32_t t, Corner p) {
  cavity_.clear();
  boundary_.clear();
  pending_.clear();
  cavity_.push_back(t);
  const auto in_cavity = [this](std::uint32_t s) {
    return std::find(cavity_.begin(), cavity_.end(), s) != cavity_.end();
  };
  // Depth first, edges counterclockwise, so that the boundary comes in its cyclic order.
  for (const std::uint32_t i : {2u, 1u, 0u}) {
    pending_.push_back({make_dart(t, i), kIdentity});
  }
  bool local = p.label == kIdentity;
  const Complex<double> centre = points_[p.vertex];
  while (!pending_.empty()) {
    const auto [d, lift_of_d] = pending_.back();
    pending_.pop_back();
    const Triangle& inside = triangles_[triangle_of(d)];
    const Dart e = inside.opposite[corner_of(d)];
    const std::uint32_t s = triangle_of(e);
    const std::uint32_t j = corner_of(e);
    const Triangle& outside = triangles_[s];
    const bool identities = (lift_of_d | (inside.labels_and_mark >> 16) | (outside.labels_and_mark >> 16)) == 0;
    LabelId lift_of_s = kIdentity;
    StageSign sign;
    if (identities) {
      if (local) {
        sign = in_circle_stage<double>(points_[outside.vertex[0]], points_[outside.vertex[1]],
                                       points_[outside.vertex[2]], centre, 0.0);
      }
    } else {
      lift_of_s = atlas_.product(lift_of_d, transition(d));
    }
    if (!sign.certain) {
      sign.sign =
          in_circle(moved(lift_of_s, corner(s, 0)), moved(lift_of_s, corner(s, 1)), moved(lift_of_s, corner(s, 2)), p);
    }
    if (sign.sign > 0) {
      if (in_cavity(s)) {
        return false;
      }
      cavity_.push_back(s);
      pending_.push_back({make_dart(s, previous(j)), lift_of_s});
      pending_.push_back({make_dart(s, next(j)), lift_of_s});
    } else {
      const std::uint32_t i = corner_of(d);
      boundary_.push_back(
          {d, e, moved(lift_of_d, corner(triangle_of(d), i)), moved(lift_of_d, corner(triangle_of(d), next(i)))});
    }
  }
  // A triangle beside the cavity of which another lift is in it: the insertion would meet itself.
  return std::none_of(boundary_.begin(), boundary_.end(),
                      [&](const BoundaryEdge& b) { return in_cavity(triangle_of(b.outer)); });
}

bool Triangulation::insert_locally(std::uint32_t t, const Complex<double>& p, const Threshold& apart,
                                   const Threshold& large, std::vector<std::uint32_t>& large_triangles) {
  // A vertex of the cavity as p sees it.
  struct Rim {
    Complex<double> offset;  // From p.
    double offset_norm;
    std::uint32_t vertex;
  };
  // A dart of a triangle in conflict, to be crossed; its ends are numbers of rims.
  struct Gate {
    Dart dart;
    std::uint32_t from;
    std::uint32_t to;
  };
  struct Edge {
    Dart outer;
    std::uint32_t from;
  };
  constexpr std::size_t kMost = 24;
  std::array<Rim, 2 * kMost + 3> rims;
  std::array<Gate, kMost + 3> gates;
  std::array<Edge, kMost + 3> edges;
  std::array<std::uint32_t, kMost> cavity;
  std::uint32_t rim_count = 0;
  std::size_t gate_count = 0;
  std::size_t edge_count = 0;
  std::size_t cavity_count = 0;
  const Triangle* const triangles = triangles_.data();
  const Complex<double>* const points = points_.data();
  const auto in_cavity = [&](std::uint32_t s) {
    return std::find(cavity.data(), cavity.data() + cavity_count, s) != cavity.data() + cavity_count;
  };

  if (!triangles[t].all_identity()) {
    return false;
  }
  cavity[cavity_count++] = t;
  for (const std::uint32_t v : triangles[t].vertex) {
    const Complex<double> offset = points[v] - p;
    rims[rim_count++] = {offset, norm(offset), v};
  }
  // Depth first, counterclockwise, as in find_cavity.
  gates[gate_count++] = {make_dart(t, 2), 2, 0};
  gates[gate_count++] = {make_dart(t, 1), 1, 2};
  gates[gate_count++] = {make_dart(t, 0), 0, 1};
  while (gate_count > 0) {
    const Gate gate = gates[--gate_count];
    const Dart e = triangles[triangle_of(gate.dart)].opposite[corner_of(gate.dart)];
    const std::uint32_t s = triangle_of(e);
    const std::uint32_t j = corner_of(e);
    const Triangle& outside = triangles[s];
    if (!outside.all_identity()) {
      return false;
    }
    const std::uint32_t apex = outside.vertex[previous(j)];
    const Rim& from = rims[gate.from];
    const Rim& to = rims[gate.to];
    const Complex<double> offset = points[apex] - p;
    const double offset_norm = norm(offset);
    const StageSign sign =
        in_circle_stage_around(to.offset, from.offset, offset, to.offset_norm, from.offset_norm, offset_norm);
    if (!sign.certain) {
      return false;
    }
    if (sign.sign > 0) {
      if (cavity_count == kMost || in_cavity(s)) {
        return false;
      }
      cavity[cavity_count++] = s;
      rims[rim_count] = {offset, offset_norm, apex};
      gates[gate_count++] = {make_dart(s, previous(j)), rim_count, gate.to};
      gates[gate_count++] = {make_dart(s, next(j)), gate.from, rim_count};
      ++rim_count;
    } else {
      edges[edge_count++] = {e, gate.from};
    }
  }
  const double height = 1 - norm(p);
  std::array<double, kMost + 3> heights;
  for (std::size_t i = 0; i < edge_count; ++i) {
    const Rim& rim = rims[edges[i].from];
    heights[i] = 1 - norm(points[rim.vertex]);
    const StageSign sign = distance_stage_near_origin(rim.offset_norm, height, heights[i], apart.high());
    if (!sign.certain || sign.sign < 0 || in_cavity(triangle_of(edges[i].outer))) {
      return false;
    }
  }

  const std::uint32_t v = add_vertex({p, chart_of(t)});
  std::array<std::uint32_t, kMost + 3> slots;
  for (std::size_t i = 0; i < edge_count; ++i) {
    slots[i] = i < cavity_count ? cavity[i] : add_triangle();
  }
  for (std::size_t i = 0; i < edge_count; ++i) {
    const std::size_t following = i + 1 < edge_count ? i + 1 : 0;
    const std::size_t preceding = i > 0 ? i - 1 : edge_count - 1;
    const Rim& from = rims[edges[i].from];
    const Rim& to = rims[edges[following].from];
    Triangle& made = triangles_[slots[i]];
    made.vertex = {v, from.vertex, to.vertex};
    made.opposite = {make_dart(slots[preceding], 2), edges[i].outer, make_dart(slots[following], 0)};
    made.labels_and_mark = 0;
    triangles_[triangle_of(edges[i].outer)].opposite[corner_of(edges[i].outer)] = make_dart(slots[i], 1);
    const StageSign sign = circumradius_stage_near_origin(
        sinh2_circumradius<double>(from.offset_norm, norm(points_[from.vertex] - points_[to.vertex]), to.offset_norm,
                                   height, heights[i], heights[following]),
        large.high());
    if (sign.certain ? sign.sign > 0 : compare_circumradius(slots[i], large) > 0) {
      made.labels_and_mark = 1;
      large_triangles.push_back(slots[i]);
    }
  }
  new_triangles_.assign(slots.begin(), slots.begin() + static_cast<std::ptrdiff_t>(edge_count));
  return true;
}

void Triangulation::fill_cavity(Corner p, Journal* journal) {
  const std::size_t n = boundary_.size();
  // Where boundary edges are glued to each other, the outer dart is the inner dart of another edge; each edge i becomes
  // dart 1 of new triangle i.
  new_triangles_.assign(cavity_.begin(), cavity_.end());
  while (new_triangles_.size() < n) {
    new_triangles_.push_back(add_triangle());
  }
  if (n <= 4) {
    for (BoundaryEdge& b : boundary_) {
      for (std::size_t i = 0; i < n; ++i) {
        if (b.outer == boundary_[i].inner) {
          b.outer = make_dart(new_triangles_[i], 1);
          break;
        }
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    set(new_triangles_[i], p, boundary_[i].from, boundary_[i].to, journal);
  }
  std::uint32_t last = new_triangles_[n - 1];
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t t = new_triangles_[i];
    link(make_dart(t, 1), boundary_[i].outer, journal);
    link(make_dart(t, 0), make_dart(last, 2), journal);
    last = t;
  }
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

Location Triangulation::locate_visibility(std::uint32_t start, Corner p) {
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
    lift_of_t = atlas_.product(lift_of_t, transition(d));
    const Dart e = opposite(d);
    t = triangle_of(e);
    entered = corner_of(e);
    ++steps;
  }
}

Location Triangulation::locate_straight(std::uint32_t start, Corner p) {
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
    } while (orientation(origin, lifted(next_dart(d)), p) < 0);
  } else {
    while (orientation(origin, lifted(previous_dart(d)), p) > 0) {
      d = cross(previous_dart(d));
    }
  }
  d = next_dart(d);
  while (orientation(lifted(d), lifted(next_dart(d)), p) < 0) {
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
