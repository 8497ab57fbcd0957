#include "triangulation/local_insertion.h"

#include <algorithm>

#include "kernel/predicates.h"
#include "triangulation/editor.h"

namespace epsnet {
namespace {

enum class Outcome { inserted, labels_met, undecided };

/// One insert_locally; without `kLabels` as far as all labels are the identity.
///
/// With identity labels alone the cavity is one of the plane: a triangle is met once, as its dual graph is a tree. With
/// labels another lift of a triangle of the cavity may be met.
template <bool kLabels>
class LocalInsertion {
 public:
  LocalInsertion(Triangulation& triangulation, std::uint32_t t, const Complex<double>& p)
      : triangulation_(triangulation), t_(t), p_(p), height_(1 - norm(p)) {}

  [[nodiscard]] Outcome run(const Threshold& apart, const Threshold& large, NewTriangles& made) {
    if (!kLabels && !triangulation_.triangle(t_).all_identity()) {
      return Outcome::labels_met;
    }
    start();
    while (gate_count_ > 0) {
      if (const Outcome outcome = pass_gate(); outcome != Outcome::inserted) {
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
  /// A vertex of the cavity, lifted to t's chart.
  struct Rim {
    Complex<double> z;
    Complex<double> offset;  ///< From p.
    double offset_norm;
    double height;  ///< 1 − |z|².
    std::uint32_t vertex;
    LabelId label;
  };
  /// A dart of a triangle in conflict, to be crossed; its ends are numbers of rims.
  struct Gate {
    double cross;  ///< cross(offset of `to`, offset of `from`).
    Dart dart;
    std::uint32_t from;
    std::uint32_t to;
  };
  /// An edge of the cavity's boundary; its start is the number of a rim.
  struct Edge {
    Dart outer;
    std::uint32_t from;
  };
  static constexpr std::size_t kMost = NewTriangles::kMost - 2;  ///< Triangles in conflict.

  std::uint32_t add_rim(std::uint32_t vertex, LabelId label, const Complex<double>& z, const Complex<double>& offset,
                        double offset_norm) {
    rims_[rim_count_] = {z, offset, offset_norm, 1 - norm(z), vertex, label};
    return rim_count_++;
  }

  [[nodiscard]] Complex<double> lift_of(std::uint32_t vertex, LabelId label) {
    if (!kLabels || label == kIdentity) {
      return triangulation_.point(vertex);
    }
    const Atlas& atlas = triangulation_.atlas();
    error_ = std::max(error_, atlas.error(label));
    return atlas.isometry(label)(triangulation_.point(vertex));
  }

  [[nodiscard]] bool in_cavity(std::uint32_t s) const {
    return kLabels && std::find(cavity_.data(), cavity_.data() + cavity_count_, s) != cavity_.data() + cavity_count_;
  }

  /// The cavity is triangle t, its darts are to be crossed.
  void start() {
    cavity_[cavity_count_++] = t_;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto [vertex, label] = triangulation_.corner(t_, i);
      const Complex<double> z = lift_of(vertex, label);
      const Complex<double> offset = z - p_;
      add_rim(vertex, label, z, offset, norm(offset));
    }
    // Depth first, counterclockwise, as in Cavity::find.
    for (const std::uint32_t i : {2u, 1u, 0u}) {
      const std::uint32_t to = next(i);
      gates_[gate_count_++] = {cross(rims_[to].offset, rims_[i].offset), make_dart(t_, i), i, to};
    }
  }

  /// Looks across the last gate: the triangle there is in conflict, and joins the cavity, or the gate is an edge of the
  /// boundary. `inserted` if that could be told.
  [[nodiscard]] Outcome pass_gate() {
    const Gate gate = gates_[--gate_count_];
    const Dart e = triangulation_.opposite(gate.dart);
    const std::uint32_t s = triangle_of(e);
    const std::uint32_t j = corner_of(e);
    const Triangle& outside = triangulation_.triangle(s);
    LabelId apex_label = kIdentity;
    if constexpr (kLabels) {
      const LabelId lift_of_s = triangulation_.lift_across(rims_[gate.from].label, rims_[gate.to].label, e);
      apex_label = triangulation_.atlas().product(lift_of_s, outside.label(previous(j)));
    } else if (!outside.all_identity()) {
      return Outcome::labels_met;
    }
    const std::uint32_t apex = outside.vertex[previous(j)];
    const Rim& from = rims_[gate.from];
    const Rim& to = rims_[gate.to];
    const Complex<double> z = lift_of(apex, apex_label);
    const Complex<double> offset = z - p_;
    const double offset_norm = norm(offset);
    const double cross_from = cross(from.offset, offset);
    const double cross_to = cross(offset, to.offset);
    const StageSign sign = in_circle_stage_around<double>({to.offset_norm, from.offset_norm, offset_norm},
                                                          {cross_from, cross_to, gate.cross}, error_);
    if (!sign.certain) {
      return Outcome::undecided;
    }
    if (sign.sign > 0) {
      if (cavity_count_ == kMost || in_cavity(s)) {
        return Outcome::undecided;
      }
      cavity_[cavity_count_++] = s;
      const std::uint32_t rim = add_rim(apex, apex_label, z, offset, offset_norm);
      gates_[gate_count_++] = {-cross_to, make_dart(s, previous(j)), rim, gate.to};
      gates_[gate_count_++] = {-cross_from, make_dart(s, next(j)), gate.from, rim};
    } else {
      edges_[edge_count_++] = {e, gate.from};
    }
    return Outcome::inserted;
  }

  /// Whether p is certainly apart from all vertices of the cavity, and the cavity from other lifts of itself.
  [[nodiscard]] bool is_apart(const Threshold& apart) const {
    for (std::size_t i = 0; i < edge_count_; ++i) {
      const Rim& rim = rims_[i];
      const StageSign sign = kLabels ? distance_stage<double>(rim.z, p_, apart.low(), apart.high(), error_)
                                     : distance_stage_near_origin(rim.offset_norm, height_, rim.height, apart.high());
      if (!sign.certain || sign.sign < 0 || rim.label > kLargestLabel || in_cavity(triangle_of(edges_[i].outer))) {
        return false;
      }
    }
    return true;
  }

  /// The new vertex, and the fan from it to the boundary.
  void fill(const Threshold& large, NewTriangles& made) {
    const Editor editor(triangulation_);
    editor.require_room(2);
    const std::uint32_t v = editor.add_vertex({p_, triangulation_.chart_of(t_)});
    for (std::size_t i = 0; i < cavity_count_; ++i) {
      made.slots[i] = cavity_[i];
    }
    made.slots[cavity_count_] = editor.add_triangle();
    made.slots[cavity_count_ + 1] = editor.add_triangle();
    made.count = static_cast<std::uint32_t>(edge_count_);
    made.large_count = 0;
    std::uint32_t preceding = made.slots[edge_count_ - 1];
    for (std::size_t i = 0; i < edge_count_; ++i) {
      const std::uint32_t slot = made.slots[i];
      const std::size_t following = i + 1 < edge_count_ ? i + 1 : 0;
      const Rim& from = rims_[edges_[i].from];
      const Rim& to = rims_[edges_[following].from];
      const Dart outer = edges_[i].outer;
      Triangle& triangle = editor.triangles()[slot];
      triangle.vertex = {v, from.vertex, to.vertex};
      triangle.opposite = {make_dart(preceding, 2), outer, make_dart(made.slots[following], 0)};
      triangle.labels_and_mark = Triangle::packed(from.label, to.label);
      editor.triangles()[triangle_of(outer)].opposite[corner_of(outer)] = make_dart(slot, 1);
      // As many are large as not, so that a branch would be guessed wrongly half of the time.
      const bool is_large = this->is_large(slot, from, to, large);
      triangle.labels_and_mark |= static_cast<std::uint64_t>(is_large);
      made.large_slots[made.large_count] = slot;
      made.large_count += static_cast<std::uint32_t>(is_large);
      preceding = slot;
    }
  }

  /// Whether the triangle of p and two rims, which is in its slot, has a circumradius R with sinh²R > large.
  [[nodiscard]] bool is_large(std::uint32_t slot, const Rim& from, const Rim& to, const Threshold& large) {
    const StageSign sign = kLabels ? circumradius_stage<double>(p_, from.z, to.z, large.low(), large.high(), error_)
                                   : circumradius_stage_near_origin(
                                         sinh2_circumradius<double>(from.offset_norm, norm(from.z - to.z),
                                                                    to.offset_norm, height_, from.height, to.height),
                                         large.high());
    return sign.certain ? sign.sign > 0 : triangulation_.compare_circumradius(slot, large) > 0;
  }

  Triangulation& triangulation_;
  const std::uint32_t t_;
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
  std::array<std::uint32_t, kMost> cavity_;
};

}  // namespace

bool insert_locally(Triangulation& triangulation, std::uint32_t t, const Complex<double>& p, const Threshold& apart,
                    const Threshold& large, NewTriangles& made) {
  Outcome outcome = LocalInsertion<false>(triangulation, t, p).run(apart, large, made);
  if (outcome == Outcome::labels_met) {
    outcome = LocalInsertion<true>(triangulation, t, p).run(apart, large, made);
  }
  return outcome == Outcome::inserted;
}

}  // namespace epsnet
