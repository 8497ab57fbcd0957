#include "triangulation/surface/exact_points.h"

#include <cassert>

namespace epsnet {

ScaledPoint scaled(const Complex<Rational>& z) {
  const Integer x_denominator = denominator(z.x);
  const Integer y_denominator = denominator(z.y);
  // Often they are equal, and then no gcd is needed.
  if (x_denominator == y_denominator) return {{numerator(z.x), numerator(z.y)}, x_denominator};
  const Integer m = lcm(x_denominator, y_denominator);
  return {{numerator(z.x) * (m / x_denominator), numerator(z.y) * (m / y_denominator)}, m};
}

Integer disk_gap(const ScaledPoint& z) { return z.m * z.m - norm(z.n); }

Complex<Integer> scaled_difference(const ScaledPoint& p, const ScaledPoint& q) { return q.m * p.n - p.m * q.n; }

GaussianFraction seen_from(const ScaledPoint& p, const ScaledPoint& z) {
  return {scaled_difference(z, p), Complex<Integer>{p.m * z.m, 0} - conj(p.n) * z.n};
}

KleinVector klein(const ScaledPoint& z) {
  const Integer twice = 2 * z.m;
  return {twice * z.n.x, twice * z.n.y, z.m * z.m + norm(z.n)};
}

int orientation(const KleinVector& p, const KleinVector& q, const KleinVector& r) {
  return sign(lorentz_product(lorentz_cross(p, q), r));
}

bool lexicographically_less(const KleinVector& p, const KleinVector& q) {
  const int x = sign(Integer(p.x * q.t - q.x * p.t));
  return x != 0 ? x < 0 : p.y * q.t < q.y * p.t;
}

Isometry<Rational> integral_crossing(const ScaledPoint& p, const ScaledPoint& q, const ScaledPoint& p2,
                                     const ScaledPoint& q2) {
  // With p and p2 moved to 0 the segments end in u/v and u2/v2 with the same modulus, so the rotation that remains has
  // the argument of `turn` = ū v u2 v̄2. Its half angle is that of |turn| + turn, and |turn| = |u|²|v2|² is an integer.
  const auto [u, v] = seen_from(p, q);
  const auto [u2, v2] = seen_from(p2, q2);
  assert(norm(u) != 0 && norm(u) * norm(v2) == norm(u2) * norm(v));
  const Complex<Integer> turn = (conj(u) * v) * (u2 * conj(v2));
  Complex<Integer> half{norm(u) * norm(v2) + turn.x, turn.y};
  // A half turn: z ↦ −z is (i z)/(−i).
  if (half == Complex<Integer>{0, 0}) half = {0, 1};
  // Only its direction counts; smaller numbers are faster from here on.
  const Integer excess = gcd(half.x, half.y);
  half.x /= excess;
  half.y /= excess;
  Complex<Integer> a = (p2.m * p.m) * half - (p2.n * conj(p.n)) * conj(half);
  Complex<Integer> b = p.m * (p2.n * conj(half)) - p2.m * (p.n * half);
  const Integer content = gcd(gcd(a.x, a.y), gcd(b.x, b.y));
  for (Integer* coefficient : {&a.x, &a.y, &b.x, &b.y}) *coefficient /= content;
  return {convert<Rational>(a), convert<Rational>(b)};
}

}  // namespace epsnet
