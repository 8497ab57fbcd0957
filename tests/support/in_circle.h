#pragma once

#include "kernel/numbers.h"

namespace epsnet::test {

/// Positive, zero or negative if d lies inside, on or outside the circle through a, b, c (counterclockwise as points of
/// the plane): the Euclidean determinant, with d as origin.
template <class T>
[[nodiscard]] T in_circle_determinant(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                      const Complex<T>& d) {
  const Complex<T> u = a - d;
  const Complex<T> v = b - d;
  const Complex<T> w = c - d;
  return norm(u) * cross(v, w) + norm(v) * cross(w, u) + norm(w) * cross(u, v);
}

}  // namespace epsnet::test
