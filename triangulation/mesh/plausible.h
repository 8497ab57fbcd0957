#pragma once

#include <algorithm>

#include "triangulation/mesh/triangulation.h"

/// What binary64 does not see to be false: for assertions, as nothing is evaluated, counted or kept.
namespace epsnet {

/// False if c is certainly to the right of the geodesic from a to b.
[[nodiscard]] inline bool may_be_left(const Triangulation& triangulation, Corner a, Corner b, Corner c) {
  const Triangulation::Lift p = triangulation.lift(a);
  const Triangulation::Lift q = triangulation.lift(b);
  const Triangulation::Lift r = triangulation.lift(c);
  const StageSign sign = orientation_stage<double>(p.z, q.z, r.z, std::max({p.error, q.error, r.error}));
  return !sign.certain || sign.sign > 0;
}

/// False if p is certainly outside of the circle through the corners of a triangle, in whose chart it is.
[[nodiscard]] inline bool may_be_in_circle(const Triangulation& triangulation, TriangleId t, Corner p) {
  const Triangulation::Lift a = triangulation.lift(triangulation.corner(t, 0));
  const Triangulation::Lift b = triangulation.lift(triangulation.corner(t, 1));
  const Triangulation::Lift c = triangulation.lift(triangulation.corner(t, 2));
  const Triangulation::Lift d = triangulation.lift(p);
  const StageSign sign = in_circle_stage<double>(a.z, b.z, c.z, d.z, std::max({a.error, b.error, c.error, d.error}));
  return !sign.certain || sign.sign > 0;
}

}  // namespace epsnet
