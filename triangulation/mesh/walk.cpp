#include <array>

#include "triangulation/mesh/editor.h"
#include "triangulation/mesh/operations.h"

namespace epsnet {
namespace {

/// Face, edge or vertex, for a point p that no edge of d's triangle has on its other side.
Location classify(Triangulation& triangulation, Dart d, LabelId transition_to_start, Corner p, std::uint32_t steps) {
  const TriangleId t = triangle_of(d);
  std::array<int, 3> signs{};
  for (std::uint32_t i = 0; i < 3; ++i) {
    signs[i] = triangulation.orientation(triangulation.moved(transition_to_start, triangulation.corner(t, i)),
                                         triangulation.moved(transition_to_start, triangulation.corner(t, next(i))), p);
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

}  // namespace

Location locate(Triangulation& triangulation, TriangleId start, Corner p, Walk walk, std::uint32_t most_steps) {
  return walk == Walk::visibility ? locate_visibility(triangulation, start, p, most_steps)
                                  : locate_straight(triangulation, start, p, most_steps);
}

Location locate(Triangulation& triangulation, TriangleId start, const LiftedPoint& point, Walk walk,
                std::uint32_t most_steps) {
  const Editor editor(triangulation);
  const VertexId v = editor.add_vertex({point.z, point.chart});
  const Location location = locate(triangulation, start, Corner{v, point.label}, walk, most_steps);
  editor.pop_vertex();
  return location;
}

Location locate_visibility(Triangulation& triangulation, TriangleId start, Corner p, std::uint32_t most_steps) {
  TriangleId t = start;
  LabelId lift_of_t = kIdentity;
  std::uint32_t steps = 0;
  std::uint32_t entered = 3;  // The edge through which t was entered: p is not behind it.
  const auto lifted = [&](std::uint32_t i) { return triangulation.moved(lift_of_t, triangulation.corner(t, i)); };
  for (;;) {
    std::uint32_t exit = 3;
    for (std::uint32_t k = 1; k <= 3 && exit == 3; ++k) {
      const std::uint32_t i = (entered + k) % 3;
      if (i != entered && triangulation.orientation(lifted(i), lifted(next(i)), p) < 0) {
        exit = i;
      }
    }
    if (exit == 3) {
      return classify(triangulation, make_dart(t, 0), lift_of_t, p, steps);
    }
    const Dart d = make_dart(t, exit);
    if (steps == most_steps) {
      return {Location::Type::not_found, d, lift_of_t, steps};
    }
    lift_of_t = triangulation.product(lift_of_t, triangulation.transition(d));
    const Dart e = triangulation.opposite(d);
    t = triangle_of(e);
    entered = corner_of(e);
    ++steps;
  }
}

Location locate_straight(Triangulation& triangulation, TriangleId start, Corner p, std::uint32_t most_steps) {
  std::uint32_t steps = 0;
  Dart d = make_dart(start, 0);  // Leaves the corner the walk starts from, whatever triangle it turns to.
  LabelId lift_of_t = kIdentity;
  const Corner origin = triangulation.corner(start, 0);
  const auto cross = [&](Dart side) {
    lift_of_t = triangulation.product(lift_of_t, triangulation.transition(side));
    ++steps;
    return triangulation.opposite(side);
  };
  const auto lifted = [&](Dart from) { return triangulation.moved(lift_of_t, triangulation.corner(from)); };
  const auto orientation = [&](Corner a, Corner b, Corner c) { return triangulation.orientation(a, b, c); };
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
  return classify(triangulation, d, lift_of_t, p, steps);
}

}  // namespace epsnet
