#include "triangulation/mesh/insertion.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "kernel/predicates.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

std::optional<Complex<double>> circumcentre_fast(const Mesh& mesh, const Atlas& atlas, TriangleId t) {
  const Triangle& triangle = mesh.triangles[t];
  const auto lifted = [&](std::uint32_t i) {
    const Complex<double>& z = mesh.points[triangle.vertex[i]];
    return triangle.label(i) == kIdentity ? z : atlas.isometry(triangle.label(i))(z);
  };
  const Complex<double> a = mesh.points[triangle.vertex[0]];
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

LiftedPoint in_nearest_chart(const Mesh& mesh, const Atlas& atlas, TriangleId t, const Complex<double>& z) {
  const Triangle& triangle = mesh.triangles[t];
  LiftedPoint nearest{mesh.charts[triangle.vertex[0]], z, kIdentity};
  for (const std::uint32_t i : {1u, 2u}) {
    const LabelId label = triangle.label(i);
    if (label == kIdentity) continue;
    const Complex<double> w = inverse(atlas.isometry(label))(z);
    if (norm(w) < norm(nearest.z)) nearest = {mesh.charts[triangle.vertex[i]], w, label};
  }
  return nearest;
}

template <class T>
std::optional<Complex<Mp1024>> circumcentre_precise(Triangulation& triangulation, TriangleId t) {
  std::array<Complex<T>, 3> p;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Corner c = triangulation.corner(t, i);
    p[i] = triangulation.lift_in<T>(c);
  }
  const auto centre = circumcentre(p[0], p[1], p[2]);
  return centre ? std::optional(convert<Mp1024>(*centre)) : std::nullopt;
}
template std::optional<Complex<Mp1024>> circumcentre_precise<Mp256>(Triangulation&, TriangleId);
template std::optional<Complex<Mp1024>> circumcentre_precise<Mp1024>(Triangulation&, TriangleId);

void Cavity::take_face(const Triangulation& triangulation, TriangleId t) {
  triangles_.assign(1, t);
  boundary_.clear();
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Dart d = make_dart(t, i);
    boundary_.push_back({d, triangulation.opposite(d), triangulation.corner(t, i), triangulation.corner(t, next(i))});
  }
}

void Cavity::take_edge(Triangulation& triangulation, Dart d) {
  const Dart e = triangulation.opposite(d);
  const LabelId across = triangulation.transition(d);
  triangles_.clear();
  triangles_.push_back(triangle_of(d));
  triangles_.push_back(triangle_of(e));
  boundary_.clear();
  for (const Dart side : {next_dart(d), previous_dart(d)}) {
    boundary_.push_back(
        {side, triangulation.opposite(side), triangulation.corner(side), triangulation.corner(next_dart(side))});
  }
  for (const Dart side : {next_dart(e), previous_dart(e)}) {
    boundary_.push_back({side, triangulation.opposite(side), triangulation.moved(across, triangulation.corner(side)),
                         triangulation.moved(across, triangulation.corner(next_dart(side)))});
  }
}

bool Cavity::find(Triangulation& triangulation, TriangleId t, Corner p) {
  assert(may_be_in_circle(triangulation, t, p));
  triangles_.clear();
  boundary_.clear();
  pending_.clear();
  triangles_.push_back(t);
  const auto in_cavity = [this](TriangleId s) {
    return std::find(triangles_.begin(), triangles_.end(), s) != triangles_.end();
  };
  // Depth first, edges counterclockwise, so that the boundary comes in its cyclic order.
  for (const std::uint32_t i : {2u, 1u, 0u}) {
    const Dart d = make_dart(t, i);
    pending_.push_back({d, triangulation.opposite(d), triangulation.corner(t, i), triangulation.corner(t, next(i))});
  }
  while (!pending_.empty()) {
    const Edge edge = pending_.back();
    pending_.pop_back();
    const TriangleId s = triangle_of(edge.outer);
    const std::uint32_t j = corner_of(edge.outer);
    const LabelId lift_of_s = triangulation.lift_across(edge.from.label, edge.to.label, edge.outer);
    const Corner apex = triangulation.moved(lift_of_s, triangulation.corner(s, previous(j)));
    if (triangulation.in_circle(edge.to, edge.from, apex, p) > 0) {
      if (in_cavity(s)) {
        return false;
      }
      triangles_.push_back(s);
      const Dart last = make_dart(s, previous(j));
      const Dart first = make_dart(s, next(j));
      pending_.push_back({last, triangulation.opposite(last), apex, edge.to});
      pending_.push_back({first, triangulation.opposite(first), edge.from, apex});
    } else {
      boundary_.push_back(edge);
    }
  }
  // A triangle beside the cavity of which another lift is in it: the insertion would meet itself.
  return std::none_of(boundary_.begin(), boundary_.end(),
                      [&](const Edge& b) { return in_cavity(triangle_of(b.outer)); });
}

std::span<const TriangleId> Cavity::fill(Triangulation& triangulation, Corner p, Journal* journal) {
  const Editor editor(triangulation, journal);
  const std::size_t n = boundary_.size();
  assert(std::ranges::all_of(boundary_, [&](const Edge& b) { return may_be_left(triangulation, b.from, b.to, p); }));
  // Where boundary edges are glued to each other, the outer dart is the inner dart of another edge; each edge i becomes
  // dart 1 of new triangle i.
  editor.require_room(n - triangles_.size());
  fan_.assign(triangles_.begin(), triangles_.end());
  while (fan_.size() < n) {
    fan_.push_back(editor.add_triangle());
  }
  if (n <= 4) {
    for (Edge& b : boundary_) {
      for (std::size_t i = 0; i < n; ++i) {
        if (b.outer == boundary_[i].inner) {
          b.outer = make_dart(fan_[i], 1);
          break;
        }
      }
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    editor.set(fan_[i], p, boundary_[i].from, boundary_[i].to);
  }
  TriangleId last = fan_[n - 1];
  for (std::size_t i = 0; i < n; ++i) {
    const TriangleId t = fan_[i];
    editor.link(make_dart(t, 1), boundary_[i].outer);
    editor.link(make_dart(t, 0), make_dart(last, 2));
    last = t;
  }
  return fan_;
}

namespace {

enum class Outcome { inserted, labels_met, undecided };

/// One insert_locally; without `kLabels` as far as all labels are the identity.
///
/// With identity labels alone the cavity is one of the plane: a triangle is met once, as its dual graph is a tree. With
/// labels another lift of a triangle of the cavity may be met.
template <bool kLabels>
class LocalInsertion {
 public:
  LocalInsertion(Mesh& mesh, KnownLabels& labels, TriangleId t, const LiftedPoint& point)
      : mesh_(mesh), labels_(labels), t_(t), point_(point), p_(point.z), height_(1 - norm(point.z)) {
    assert(t.number() < mesh.triangles.size() && norm(point.z) <= kChartRadius * kChartRadius);
  }

  [[nodiscard]] Outcome run(const Threshold& apart, const Threshold& large, NewTriangles& made) {
    if (!kLabels && !(point_.label == kIdentity && mesh_.triangles[t_].all_identity())) {
      return Outcome::labels_met;
    }
    if (!start()) {
      return Outcome::undecided;
    }
    while (gate_count_ > 0) {
      // Member by member: a gate as one load would have to wait for its stores.
      const Gate& last = gates_[--gate_count_];
      if (const Outcome outcome = pass(last.cross, last.outer, last.from, last.to); outcome != Outcome::inserted) {
        return outcome;
      }
    }
    if (!is_apart(apart)) {
      return Outcome::undecided;
    }
    fill(large, made);
    return Outcome::inserted;
  }

 private:
  /// A vertex of the cavity, lifted to the chart of p.
  struct Rim {
    Complex<double> z;
    Complex<double> offset;  ///< From p.
    double offset_norm;
    double height;  ///< 1 − |z|².
    VertexId vertex;
    LabelId label;
  };
  /// An edge of a triangle in conflict, to be crossed: the dart on its other side; its ends are numbers of rims.
  struct Gate {
    double cross;  ///< cross(offset of `to`, offset of `from`).
    Dart outer;
    std::uint32_t from;
    std::uint32_t to;
  };
  /// An edge of the cavity's boundary; its start is the number of a rim.
  struct Edge {
    Dart outer;
    std::uint32_t from;
  };
  static constexpr std::size_t kMost = NewTriangles::kMost - 2;  ///< Triangles in conflict.

  std::uint32_t add_rim(VertexId vertex, LabelId label, const Complex<double>& z, const Complex<double>& offset,
                        double offset_norm) {
    rims_[rim_count_] = {z, offset, offset_norm, 1 - norm(z), vertex, label};
    return rim_count_++;
  }

  [[nodiscard]] Complex<double> lift_of(VertexId vertex, LabelId label) {
    if (!kLabels || label == kIdentity) {
      return mesh_.points[vertex];
    }
    error_ = std::max(error_, labels_.atlas().error(label));
    return labels_.atlas().isometry(label)(mesh_.points[vertex]);
  }

  /// How the triangle of dart e is lifted if the ends of e are (Triangulation::lift_across).
  [[nodiscard]] LabelId lift_across(const Rim& from, const Rim& to, const Triangle& outside, std::uint32_t j) {
    return j == 0 ? to.label : labels_.product(from.label, labels_.inverse(outside.label(next(j))));
  }

  [[nodiscard]] bool in_cavity(TriangleId s) const {
    return kLabels && std::find(cavity_.data(), cavity_.data() + cavity_count_, s) != cavity_.data() + cavity_count_;
  }

  /// The cavity is triangle t, its edges are to be crossed. False if its labels from p's chart are not known.
  [[nodiscard]] bool start() {
    cavity_[cavity_count_++] = t_;
    const Triangle& triangle = mesh_.triangles[t_];
    const LabelId moved = kLabels ? labels_.inverse(point_.label) : kIdentity;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const LabelId label = kLabels ? labels_.product(moved, triangle.label(i)) : kIdentity;
      if (label == kUnknownLabel) {
        return false;
      }
      const Complex<double> z = lift_of(triangle.vertex[i], label);
      const Complex<double> offset = z - p_;
      add_rim(triangle.vertex[i], label, z, offset, norm(offset));
    }
    // Depth first, counterclockwise, as in Cavity::find.
    for (const std::uint32_t i : {2u, 1u, 0u}) {
      const std::uint32_t to = next(i);
      gates_[gate_count_++] = {cross(rims_[to].offset, rims_[i].offset), triangle.opposite[i], i, to};
    }
    return true;
  }

  /// Looks across a gate: the triangle there is in conflict, and joins the cavity, and the first of its other edges is
  /// the next gate; or the gate is an edge of the boundary. `inserted` if that could be told.
  [[nodiscard]] Outcome pass(double gate_cross, Dart outer, std::uint32_t from_rim, std::uint32_t to_rim) {
    const Rim* const from = &rims_[from_rim];
    const Rim* to = &rims_[to_rim];
    for (;;) {
      if (outer == kOutside) {
        return Outcome::undecided;
      }
      const TriangleId s = triangle_of(outer);
      const std::uint32_t j = corner_of(outer);
      const Triangle& outside = mesh_.triangles[s];
      LabelId apex_label = kIdentity;
      if constexpr (kLabels) {
        apex_label = labels_.product(lift_across(*from, *to, outside, j), outside.label(previous(j)));
        if (apex_label == kUnknownLabel) {
          return Outcome::undecided;
        }
      } else if (!outside.all_identity()) {
        return Outcome::labels_met;
      }
      const VertexId apex = outside.vertex[previous(j)];
      const Complex<double> z = lift_of(apex, apex_label);
      const Complex<double> offset = z - p_;
      const double offset_norm = norm(offset);
      const double cross_from = cross(from->offset, offset);
      const double cross_to = cross(offset, to->offset);
      const StageSign sign = in_circle_stage_around<double>({to->offset_norm, from->offset_norm, offset_norm},
                                                            {cross_from, cross_to, gate_cross}, kLabels ? error_ : 0);
      if (!sign.certain) {
        return Outcome::undecided;
      }
      if (sign.sign < 0) {
        edges_[edge_count_++] = {outer, from_rim};
        return Outcome::inserted;
      }
      if (cavity_count_ == kMost || in_cavity(s)) {
        return Outcome::undecided;
      }
      cavity_[cavity_count_++] = s;
      const std::uint32_t rim = add_rim(apex, apex_label, z, offset, offset_norm);
      gates_[gate_count_++] = {-cross_to, outside.opposite[previous(j)], rim, to_rim};
      gate_cross = -cross_from;
      outer = outside.opposite[next(j)];
      to_rim = rim;
      to = &rims_[rim];
    }
  }

  /// Whether p is certainly apart from all vertices of the cavity, and the cavity from other lifts of itself.
  [[nodiscard]] bool is_apart(const Threshold& apart) const {
    for (std::size_t i = 0; i < edge_count_; ++i) {
      const Rim& rim = rims_[i];
      const StageSign sign = kLabels ? distance_stage<double>(rim.z, p_, apart.low(), apart.high(), error_)
                                     : distance_stage_near_origin(rim.offset_norm, height_, rim.height, apart.high());
      if (!sign.certain || sign.sign < 0 ||
          (kLabels && (rim.label > kLargestLabel || in_cavity(triangle_of(edges_[i].outer))))) {
        return false;
      }
    }
    return true;
  }

  /// The new vertex, and the fan from it to the boundary.
  void fill(const Threshold& large, NewTriangles& made) {
    ById<TriangleId, Triangle>& triangles = mesh_.triangles;
    Editor::require_room(triangles.size(), 2);
    const VertexId v = mesh_.points.end_id();
    mesh_.charts.push_back(point_.chart);
    mesh_.points.push_back(p_);
    std::copy_n(cavity_.data(), cavity_count_, made.slots.data());
    for (std::size_t i = cavity_count_; i < edge_count_; ++i) {
      made.slots[i] = triangles.end_id();
      triangles.push_back({});
    }
    made.count = static_cast<std::uint32_t>(edge_count_);
    made.large_count = 0;
    made.unsure_count = 0;
    TriangleId preceding = made.slots[edge_count_ - 1];
    for (std::size_t i = 0; i < edge_count_; ++i) {
      const TriangleId slot = made.slots[i];
      const std::size_t following = i + 1 < edge_count_ ? i + 1 : 0;
      const Rim& from = rims_[edges_[i].from];
      const Rim& to = rims_[edges_[following].from];
      const Dart outer = edges_[i].outer;
      // As many are large as not, so that a branch would be guessed wrongly half of the time.
      const StageSign sign = compare_circumradius(from, to, large);
      const auto is_large = static_cast<std::uint32_t>(sign.sign > 0);
      const auto is_unsure = static_cast<std::uint32_t>(!sign.certain);
      triangles[slot] = {{v, from.vertex, to.vertex},
                         {make_dart(preceding, 2), outer, make_dart(made.slots[following], 0)},
                         Triangle::packed(from.label, to.label) | is_large};
      triangles[triangle_of(outer)].opposite[corner_of(outer)] = make_dart(slot, 1);
      made.large_slots[made.large_count] = slot;
      made.large_count += is_large;
      made.unsure_slots[made.unsure_count] = slot;
      made.unsure_count += is_unsure;
      preceding = slot;
    }
  }

  /// Whether the triangle of p and two rims has a circumradius R with sinh²R > large.
  [[nodiscard]] StageSign compare_circumradius(const Rim& from, const Rim& to, const Threshold& large) const {
    return kLabels ? circumradius_stage<double>(p_, from.z, to.z, large.low(), large.high(), error_)
                   : circumradius_stage_near_origin(
                         sinh2_circumradius<double>(from.offset_norm, norm(from.z - to.z), to.offset_norm, height_,
                                                    from.height, to.height),
                         large.high());
  }

  Mesh& mesh_;
  KnownLabels& labels_;
  const TriangleId t_;
  const LiftedPoint& point_;
  const Complex<double> p_;
  const double height_;  ///< 1 − |p|².
  double error_ = 0;     ///< Of the lifts.
  std::uint32_t rim_count_ = 0;
  std::size_t gate_count_ = 0;
  std::size_t edge_count_ = 0;
  std::size_t cavity_count_ = 0;
  std::array<Rim, NewTriangles::kMost> rims_;
  std::array<Gate, NewTriangles::kMost> gates_;
  std::array<Edge, NewTriangles::kMost> edges_;
  std::array<TriangleId, kMost> cavity_;
};

}  // namespace

bool insert_locally(Mesh& mesh, KnownLabels& labels, TriangleId t, const LiftedPoint& point, const Threshold& apart,
                    const Threshold& large, NewTriangles& made) {
  Outcome outcome = LocalInsertion<false>(mesh, labels, t, point).run(apart, large, made);
  if (outcome == Outcome::labels_met) {
    outcome = LocalInsertion<true>(mesh, labels, t, point).run(apart, large, made);
  }
  return outcome == Outcome::inserted;
}

}  // namespace epsnet
