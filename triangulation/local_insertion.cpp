#include "triangulation/local_insertion.h"

#include <algorithm>

#include "kernel/predicates.h"
#include "triangulation/editor.h"

namespace epsnet {
namespace {

enum class Outcome { inserted, labels_met, undecided };

/// insert_locally; without `kLabels` as far as all labels are the identity.
template <bool kLabels>
Outcome insert_locally_with(Triangulation& triangulation, std::uint32_t t, const Complex<double>& p,
                            const Threshold& apart, const Threshold& large, NewTriangles& made) {
  Atlas& atlas = triangulation.atlas();
  // A vertex of the cavity, lifted to t's chart.
  struct Rim {
    Complex<double> z;
    Complex<double> offset;  // From p.
    double offset_norm;
    double height;  // 1 − |z|².
    std::uint32_t vertex;
    LabelId label;
  };
  // A dart of a triangle in conflict, to be crossed; its ends are numbers of rims.
  struct Gate {
    double cross;  // cross(offset of `to`, offset of `from`).
    Dart dart;
    std::uint32_t from;
    std::uint32_t to;
  };
  struct Edge {
    Dart outer;
    std::uint32_t from;
  };
  constexpr std::size_t kMost = NewTriangles::kMost - 2;  // Triangles in conflict.
  std::array<Rim, NewTriangles::kMost> rims;
  std::array<Gate, NewTriangles::kMost> gates;
  std::array<Edge, NewTriangles::kMost> edges;
  std::array<std::uint32_t, kMost> cavity;
  std::uint32_t rim_count = 0;
  std::size_t gate_count = 0;
  std::size_t edge_count = 0;
  std::size_t cavity_count = 0;
  double error = 0;  // Of the lifts.
  const auto add_rim = [&](std::uint32_t vertex, LabelId label, const Complex<double>& z, const Complex<double>& offset,
                           double offset_norm) {
    rims[rim_count] = {z, offset, offset_norm, 1 - norm(z), vertex, label};
    return rim_count++;
  };
  const auto lift_of = [&](std::uint32_t vertex, LabelId label) {
    if (!kLabels || label == kIdentity) {
      return triangulation.point(vertex);
    }
    error = std::max(error, atlas.error(label));
    return atlas.isometry(label)(triangulation.point(vertex));
  };
  // With identity labels alone the cavity is one of the plane: a triangle is met once, as its dual graph is a tree.
  // With labels another lift of a triangle of the cavity may be met.
  const auto in_cavity = [&](std::uint32_t s) {
    return kLabels && std::find(cavity.data(), cavity.data() + cavity_count, s) != cavity.data() + cavity_count;
  };

  if (!kLabels && !triangulation.triangle(t).all_identity()) {
    return Outcome::labels_met;
  }
  cavity[cavity_count++] = t;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto [vertex, label] = triangulation.corner(t, i);
    const Complex<double> z = lift_of(vertex, label);
    const Complex<double> offset = z - p;
    add_rim(vertex, label, z, offset, norm(offset));
  }
  // Depth first, counterclockwise, as in Cavity::find.
  for (const std::uint32_t i : {2u, 1u, 0u}) {
    const std::uint32_t to = next(i);
    gates[gate_count++] = {cross(rims[to].offset, rims[i].offset), make_dart(t, i), i, to};
  }
  while (gate_count > 0) {
    const Gate gate = gates[--gate_count];
    const Dart e = triangulation.opposite(gate.dart);
    const std::uint32_t s = triangle_of(e);
    const std::uint32_t j = corner_of(e);
    const Triangle& outside = triangulation.triangle(s);
    LabelId apex_label = kIdentity;
    if constexpr (kLabels) {
      const LabelId lift_of_s = triangulation.lift_across(rims[gate.from].label, rims[gate.to].label, e);
      apex_label = atlas.product(lift_of_s, outside.label(previous(j)));
    } else if (!outside.all_identity()) {
      return Outcome::labels_met;
    }
    const std::uint32_t apex = outside.vertex[previous(j)];
    const Rim& from = rims[gate.from];
    const Rim& to = rims[gate.to];
    const Complex<double> z = lift_of(apex, apex_label);
    const Complex<double> offset = z - p;
    const double offset_norm = norm(offset);
    const double cross_from = cross(from.offset, offset);
    const double cross_to = cross(offset, to.offset);
    const StageSign sign = in_circle_stage_around<double>({to.offset_norm, from.offset_norm, offset_norm},
                                                          {cross_from, cross_to, gate.cross}, error);
    if (!sign.certain) {
      return Outcome::undecided;
    }
    if (sign.sign > 0) {
      if (cavity_count == kMost || in_cavity(s)) {
        return Outcome::undecided;
      }
      cavity[cavity_count++] = s;
      const std::uint32_t rim = add_rim(apex, apex_label, z, offset, offset_norm);
      gates[gate_count++] = {-cross_to, make_dart(s, previous(j)), rim, gate.to};
      gates[gate_count++] = {-cross_from, make_dart(s, next(j)), gate.from, rim};
    } else {
      edges[edge_count++] = {e, gate.from};
    }
  }
  const double height = 1 - norm(p);
  for (std::size_t i = 0; i < edge_count; ++i) {
    const Rim& rim = rims[i];
    const StageSign sign = kLabels ? distance_stage<double>(rim.z, p, apart.low(), apart.high(), error)
                                   : distance_stage_near_origin(rim.offset_norm, height, rim.height, apart.high());
    if (!sign.certain || sign.sign < 0 || rim.label > kLargestLabel || in_cavity(triangle_of(edges[i].outer))) {
      return Outcome::undecided;
    }
  }

  const Editor editor(triangulation);
  editor.require_room(2);
  const std::uint32_t v = editor.add_vertex({p, triangulation.chart_of(t)});
  for (std::size_t i = 0; i < cavity_count; ++i) {
    made.slots[i] = cavity[i];
  }
  made.slots[cavity_count] = editor.add_triangle();
  made.slots[cavity_count + 1] = editor.add_triangle();
  made.count = static_cast<std::uint32_t>(edge_count);
  made.large_count = 0;
  std::uint32_t preceding = made.slots[edge_count - 1];
  for (std::size_t i = 0; i < edge_count; ++i) {
    const std::uint32_t slot = made.slots[i];
    const std::size_t following = i + 1 < edge_count ? i + 1 : 0;
    const Rim& from = rims[edges[i].from];
    const Rim& to = rims[edges[following].from];
    const Dart outer = edges[i].outer;
    Triangle& triangle = editor.triangles()[slot];
    triangle.vertex = {v, from.vertex, to.vertex};
    triangle.opposite = {make_dart(preceding, 2), outer, make_dart(made.slots[following], 0)};
    triangle.labels_and_mark = Triangle::packed(from.label, to.label);
    editor.triangles()[triangle_of(outer)].opposite[corner_of(outer)] = make_dart(slot, 1);
    const StageSign sign = kLabels ? circumradius_stage<double>(p, from.z, to.z, large.low(), large.high(), error)
                                   : circumradius_stage_near_origin(
                                         sinh2_circumradius<double>(from.offset_norm, norm(from.z - to.z),
                                                                    to.offset_norm, height, from.height, to.height),
                                         large.high());
    // As many are large as not, so that a branch would be guessed wrongly half of the time.
    const bool is_large = sign.certain ? sign.sign > 0 : triangulation.compare_circumradius(slot, large) > 0;
    triangle.labels_and_mark |= static_cast<std::uint64_t>(is_large);
    made.large_slots[made.large_count] = slot;
    made.large_count += static_cast<std::uint32_t>(is_large);
    preceding = slot;
  }
  return Outcome::inserted;
}

}  // namespace

bool insert_locally(Triangulation& triangulation, std::uint32_t t, const Complex<double>& p, const Threshold& apart,
                    const Threshold& large, NewTriangles& made) {
  Outcome outcome = insert_locally_with<false>(triangulation, t, p, apart, large, made);
  if (outcome == Outcome::labels_met) {
    outcome = insert_locally_with<true>(triangulation, t, p, apart, large, made);
  }
  return outcome == Outcome::inserted;
}

}  // namespace epsnet
