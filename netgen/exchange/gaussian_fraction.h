#pragma once

#include "triangulation/surface/exact_points.h"

/// The shapes of triangles and cross-ratios, exactly. No gcd is computed before the result.
namespace epsnet {

/// The number, in lowest terms.
[[nodiscard]] inline Complex<Rational> value(const GaussianFraction& f) {
  const Integer modulus = norm(f.d);
  return {Rational(dot(f.d, f.n), modulus), Rational(cross(f.d, f.n), modulus)};
}

/// Whether the segments from a to b and from c to d have the same length.
[[nodiscard]] inline bool equally_long(const ScaledPoint& a, const ScaledPoint& b, const ScaledPoint& c,
                                       const ScaledPoint& d) {
  const GaussianFraction first = seen_from(a, b);
  const GaussianFraction second = seen_from(c, d);
  return norm(first.n) * norm(second.d) == norm(second.n) * norm(first.d);
}

/// The quotient of z and y as seen from p: its argument is the angle from y to z.
[[nodiscard]] inline GaussianFraction corner_ratio(const ScaledPoint& p, const ScaledPoint& y, const ScaledPoint& z) {
  const GaussianFraction first = seen_from(p, y);
  const GaussianFraction second = seen_from(p, z);
  return {second.n * first.d, second.d * first.n};
}

/// The cross-ratio [z0, z1, z2, z3] of four points in the same disk: (z3 − z1)(z2 − z0)/((z3 − z0)(z2 − z1)).
[[nodiscard]] inline GaussianFraction cross_ratio(const ScaledPoint& z0, const ScaledPoint& z1, const ScaledPoint& z2,
                                                  const ScaledPoint& z3) {
  return {scaled_difference(z3, z1) * scaled_difference(z2, z0), scaled_difference(z3, z0) * scaled_difference(z2, z1)};
}

/// Returns the cross-ratio of an edge from a to b with c on its left and d on its right, from σ = corner_ratio(a, b, c)
/// and τ = corner_ratio(a, b, d). So the two triangles beside the edge may be in different coordinates.
///
/// With a at 0 it is [0, d, b, c] = (c − d) b/(c (b − d)) = (σ − τ)/(σ (1 − τ)).
[[nodiscard]] inline GaussianFraction cross_ratio_of_corners(const GaussianFraction& sigma,
                                                             const GaussianFraction& tau) {
  return {sigma.n * tau.d - tau.n * sigma.d, sigma.n * (tau.d - tau.n)};
}

/// Returns the point d with [a, d, b, c] = `ratio`; its denominator is 0 if it is the point at infinity.
///
/// d = (c(b − a) − R(c − a)b)/((b − a) − R(c − a)).
[[nodiscard]] inline GaussianFraction fourth_point(const ScaledPoint& a, const ScaledPoint& b, const ScaledPoint& c,
                                                   const ScaledPoint& ratio) {
  const Complex<Integer> left = ratio.m * scaled_difference(b, a);
  const Complex<Integer> right = ratio.n * scaled_difference(c, a);
  return {left * c.n - right * b.n, c.m * left - b.m * right};
}

}  // namespace epsnet
