#include <algorithm>

#include "triangulation/triangulation.h"

/// The insertion of a vertex into a triangulation: splitting a triangle or an edge, Bowyer–Watson's cavity, and the
/// cavity in binary64.
namespace epsnet {

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
    pending_.push_back({make_dart(t, i), opposite(make_dart(t, i)), corner(t, i), corner(t, next(i))});
  }
  while (!pending_.empty()) {
    const BoundaryEdge edge = pending_.back();
    pending_.pop_back();
    const std::uint32_t s = triangle_of(edge.outer);
    const std::uint32_t j = corner_of(edge.outer);
    const LabelId lift_of_s = lift_across(edge.from.label, edge.to.label, edge.outer);
    const Corner apex = moved(lift_of_s, corner(s, previous(j)));
    if (in_circle(edge.to, edge.from, apex, p) > 0) {
      if (in_cavity(s)) {
        return false;
      }
      cavity_.push_back(s);
      const Dart last = make_dart(s, previous(j));
      const Dart first = make_dart(s, next(j));
      pending_.push_back({last, opposite(last), apex, edge.to});
      pending_.push_back({first, opposite(first), edge.from, apex});
    } else {
      boundary_.push_back(edge);
    }
  }
  // A triangle beside the cavity of which another lift is in it: the insertion would meet itself.
  return std::none_of(boundary_.begin(), boundary_.end(),
                      [&](const BoundaryEdge& b) { return in_cavity(triangle_of(b.outer)); });
}

void Triangulation::fill_cavity(Corner p, Journal* journal) {
  const std::size_t n = boundary_.size();
  // Where boundary edges are glued to each other, the outer dart is the inner dart of another edge; each edge i becomes
  // dart 1 of new triangle i.
  require_room(n - cavity_.size());
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

template <bool kLabels>
Triangulation::Outcome Triangulation::insert_locally_with(std::uint32_t t, const Complex<double>& p,
                                                          const Threshold& apart, const Threshold& large,
                                                          NewTriangles& made) {
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
      return points_[vertex];
    }
    error = std::max(error, atlas_.error(label));
    return atlas_.isometry(label)(points_[vertex]);
  };
  // With identity labels alone the cavity is one of the plane: a triangle is met once, as its dual graph is a tree.
  // With labels another lift of a triangle of the cavity may be met.
  const auto in_cavity = [&](std::uint32_t s) {
    return kLabels && std::find(cavity.data(), cavity.data() + cavity_count, s) != cavity.data() + cavity_count;
  };

  if (!kLabels && !triangles_[t].all_identity()) {
    return Outcome::labels_met;
  }
  cavity[cavity_count++] = t;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto [vertex, label] = corner(t, i);
    const Complex<double> z = lift_of(vertex, label);
    const Complex<double> offset = z - p;
    add_rim(vertex, label, z, offset, norm(offset));
  }
  // Depth first, counterclockwise, as in find_cavity.
  for (const std::uint32_t i : {2u, 1u, 0u}) {
    const std::uint32_t to = next(i);
    gates[gate_count++] = {cross(rims[to].offset, rims[i].offset), make_dart(t, i), i, to};
  }
  while (gate_count > 0) {
    const Gate gate = gates[--gate_count];
    const Dart e = opposite(gate.dart);
    const std::uint32_t s = triangle_of(e);
    const std::uint32_t j = corner_of(e);
    const Triangle& outside = triangles_[s];
    LabelId apex_label = kIdentity;
    if constexpr (kLabels) {
      const LabelId lift_of_s = lift_across(rims[gate.from].label, rims[gate.to].label, e);
      apex_label = atlas_.product(lift_of_s, outside.label(previous(j)));
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

  require_room(2);
  const std::uint32_t v = add_vertex({p, chart_of(t)});
  for (std::size_t i = 0; i < cavity_count; ++i) {
    made.slots[i] = cavity[i];
  }
  made.slots[cavity_count] = add_triangle();
  made.slots[cavity_count + 1] = add_triangle();
  made.count = static_cast<std::uint32_t>(edge_count);
  made.large_count = 0;
  std::uint32_t preceding = made.slots[edge_count - 1];
  for (std::size_t i = 0; i < edge_count; ++i) {
    const std::uint32_t slot = made.slots[i];
    const std::size_t following = i + 1 < edge_count ? i + 1 : 0;
    const Rim& from = rims[edges[i].from];
    const Rim& to = rims[edges[following].from];
    const Dart outer = edges[i].outer;
    Triangle& triangle = triangles_[slot];
    triangle.vertex = {v, from.vertex, to.vertex};
    triangle.opposite = {make_dart(preceding, 2), outer, make_dart(made.slots[following], 0)};
    triangle.labels_and_mark = packed(from.label, to.label);
    triangles_[triangle_of(outer)].opposite[corner_of(outer)] = make_dart(slot, 1);
    const StageSign sign = kLabels ? circumradius_stage<double>(p, from.z, to.z, large.low(), large.high(), error)
                                   : circumradius_stage_near_origin(
                                         sinh2_circumradius<double>(from.offset_norm, norm(from.z - to.z),
                                                                    to.offset_norm, height, from.height, to.height),
                                         large.high());
    // Large or not is a coin that falls either way: counted without a branch.
    const bool is_large = sign.certain ? sign.sign > 0 : compare_circumradius(slot, large) > 0;
    triangle.labels_and_mark |= static_cast<std::uint64_t>(is_large);
    made.large_slots[made.large_count] = slot;
    made.large_count += static_cast<std::uint32_t>(is_large);
    preceding = slot;
  }
  return Outcome::inserted;
}

bool Triangulation::insert_locally(std::uint32_t t, const Complex<double>& p, const Threshold& apart,
                                   const Threshold& large, NewTriangles& made) {
  Outcome outcome = insert_locally_with<false>(t, p, apart, large, made);
  if (outcome == Outcome::labels_met) {
    outcome = insert_locally_with<true>(t, p, apart, large, made);
  }
  return outcome == Outcome::inserted;
}

}  // namespace epsnet
