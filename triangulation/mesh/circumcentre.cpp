#include "triangulation/mesh/circumcentre.h"

#include <algorithm>
#include <array>

#include "kernel/predicates.h"

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

}  // namespace epsnet
