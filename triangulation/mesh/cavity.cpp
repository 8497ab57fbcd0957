#include "triangulation/mesh/cavity.h"

#include <algorithm>
#include <cassert>

#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/plausible.h"

namespace epsnet {

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

}  // namespace epsnet
