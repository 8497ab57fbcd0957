#pragma once

#include "epsnet/kernel/plane.h"

/// The shapes of triangles and cross-ratios, which do not depend on the coordinates that a triangle happens to have.
namespace epsnet {

/// z as seen from p: its image under the isometry that takes p to 0.
template <class T>
[[nodiscard]] Complex<T> seen_from(const Complex<T>& p, const Complex<T>& z) {
  return (z - p) / (Complex<T>{T(1), T(0)} - conj(p) * z);
}

/// The quotient of z and y as seen from p: its argument is the angle from y to z.
template <class T>
[[nodiscard]] Complex<T> corner_ratio(const Complex<T>& p, const Complex<T>& y, const Complex<T>& z) {
  return seen_from(p, z) / seen_from(p, y);
}

/// The cross-ratio of an edge from a to b with c on its left and d on its right, from σ = corner_ratio(a, b, c) and
/// τ = corner_ratio(a, b, d), that is, from the triangles beside it in different coordinates.
///
/// With a at 0 it is [0, d, b, c] = (c − d) b/(c (b − d)).
template <class T>
[[nodiscard]] Complex<T> cross_ratio_of_corners(const Complex<T>& sigma, const Complex<T>& tau) {
  return (sigma - tau) / (sigma * (Complex<T>{T(1), T(0)} - tau));
}

}  // namespace epsnet
