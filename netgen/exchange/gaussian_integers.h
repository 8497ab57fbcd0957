#pragma once

#include <cstddef>
#include <utility>

#include "triangulation/surface/exact_points.h"

/// Sizes of integers, and division of Gaussian integers.
namespace epsnet {

/// How many bits |n| has; 1 for 0.
[[nodiscard]] inline std::size_t bits(const Integer& n) { return n == 0 ? 1 : std::size_t{msb(Integer(abs(n)))} + 1; }

/// The integer nearest to n/d, d > 0.
[[nodiscard]] inline Integer nearest(const Integer& n, const Integer& d) {
  const Integer twice = 2 * n + d;
  const Integer quotient = twice / (2 * d);
  return twice < 0 && quotient * 2 * d != twice ? Integer(quotient - 1) : quotient;
}

/// n/d rounded to a Gaussian integer.
[[nodiscard]] inline Complex<Integer> nearest(const Complex<Integer>& n, const Complex<Integer>& d) {
  const Integer norm_d = norm(d);
  return {nearest(dot(d, n), norm_d), nearest(cross(d, n), norm_d)};
}

/// A greatest common divisor of two Gaussian integers, not both 0. Quadratic time.
[[nodiscard]] inline Complex<Integer> gaussian_gcd(Complex<Integer> a, Complex<Integer> b) {
  while (b != Complex<Integer>{0, 0}) {
    Complex<Integer> rest = a - nearest(a, b) * b;
    a = std::exchange(b, std::move(rest));
  }
  return a;
}

}  // namespace epsnet
