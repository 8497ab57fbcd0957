#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "netgen/exchange/text_formats.h"
#include "triangulation/surface/exact_polygons.h"

namespace epsnet {

// Gaussian integers: sizes, division, norms; and fractions of them, which shapes of triangles and cross-ratios are.

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

// Fractions: the shapes of triangles and cross-ratios, exactly. No gcd is computed before the result.

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

/// Whether an integer is a sum of two squares; if it is not known, neither member is set.
struct TwoSquares {
  std::optional<Complex<Integer>> root;  ///< x + iy with x² + y² = n.
  /// Proves that there is none: a divisor that is 3 modulo 4, either a prime of odd multiplicity or the unfactored rest
  /// of n.
  std::optional<Integer> obstacle;
};

/// Writes n > 0 as a sum of two squares, that is, as the norm of a Gaussian integer.
///
/// Primes below 2¹⁶ are divided out; a greatest common divisor with a hint splits off a Gaussian factor without
/// factoring its norm. The rest is a square, a prime of at most 4,096 bits, or too hard; if it is too hard, neither
/// member of the result is set. So only an obstacle proves that there is no such sum (Fermat). Deterministic; quadratic
/// time in the number of digits for each hint, cubic for a prime. Numbers of more than 20,000 bits are too hard.
[[nodiscard]] TwoSquares two_squares(const Integer& n, const std::vector<Complex<Integer>>& hints);

/// Returns an exact lift of one triangle to the unit disk, for a triangulation without an anchor; every other such lift
/// is an image of it under an isometry of the disk.
///
/// Cross-ratios place the triangles in the complex plane up to Möbius maps. The group of the surface then preserves one
/// circle, the boundary of the disk. Two elements without a common fixed point determine it: the Hermitian forms H with
/// g*Hg = |det g|H are the solutions of linear equations. A Möbius map over Q(i) takes it to the unit circle if and
/// only if tanh²(d/2), d the length of any edge, is a sum of two squares of rational numbers; then the edge can lead
/// from 0 to any κ with |κ|² = tanh²(d/2). Streams made from rational points have such a κ, and greatest common
/// divisors in Z[i] find it, since all their cross-ratios contain its factors (docs/exchange-formats.md).
///
/// Requires: the combinatorics that read_triangulation_stream checks. Throws ExchangeError if there is no such circle,
/// if there is no such κ, or if none was found; the message then says what to write into the text.
[[nodiscard]] TriangulationStream::Anchor find_anchor(const TriangulationStream& stream, std::string_view name);

}  // namespace epsnet
