#pragma once

#include <algorithm>
#include <cmath>

#include "epsnet/kernel/numbers.h"
#include "epsnet/kernel/plane.h"

/// One stage of a staged predicate: a sign that is proved, or "unsure".
///
/// Every function here takes points whose Euclidean distance from the true points is at most `error` (0 where they are
/// exact) and answers a sign only if it is the sign for the true points. docs/error-bounds.md derives the constants;
/// tests/kernel/predicates_test.cpp holds every stage against exact arithmetic.
namespace epsnet {

/// The answer of one stage: the sign −1, 0 or 1, or nothing.
struct StageSign {
  int sign = 0;
  bool certain = false;
};

/// The unit roundoff of a field, 2⁻ᵇ for b mantissa bits.
template <class T>
[[nodiscard]] inline T unit_roundoff() {
  static const T u = [] {
    T value(1);
    for (int i = 0; i < kMantissaBits<T>; ++i) {
      value /= 2;
    }
    return value;
  }();
  return u;
}
template <>
[[nodiscard]] inline double unit_roundoff<double>() {
  return kUnitRoundoff;
}

namespace detail {
/// Added to every bound of the binary64 stage: products that underflow lose their relative accuracy, but nothing this
/// large is lost.
template <class T>
[[nodiscard]] inline T underflow_bound() {
  return T(0);
}
template <>
[[nodiscard]] inline double underflow_bound<double>() {
  return 0x1p-960;
}

template <class T>
[[nodiscard]] StageSign sign_beyond(const T& value, const T& bound) {
  if (value > bound) {
    return {1, true};
  }
  if (value < -bound) {
    return {-1, true};
  }
  return {0, false};
}
}  // namespace detail

/// The sign of in_circle_determinant(a, b, c, d): 1 if d lies strictly inside of the circle through a, b, c
/// (counterclockwise).
///
/// Error bound: 16u(αβ + βγ + γα) + 32 e M³ with α, β, γ the squared distances of a, b, c from d, M² the largest of
/// them, e = `error` (docs/error-bounds.md, E1).
template <class T>
[[nodiscard]] StageSign in_circle_stage(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                        const Complex<T>& d, const T& error) {
  using std::sqrt;
  const Complex<T> u = a - d;
  const Complex<T> v = b - d;
  const Complex<T> w = c - d;
  const T uu = norm(u);
  const T vv = norm(v);
  const T ww = norm(w);
  const T det = uu * cross(v, w) + vv * cross(w, u) + ww * cross(u, v);
  T bound = T(16) * unit_roundoff<T>() * (uu * vv + vv * ww + ww * uu) + detail::underflow_bound<T>();
  if (error > 0) {
    const T m = sqrt(std::max({uu, vv, ww}));
    if (!(T(16) * error <= m)) {
      return {};
    }
    bound += T(32) * error * m * m * m;
  }
  return detail::sign_beyond(det, bound);
}

/// The sign of orientation_determinant(a, b, c): 1 if c lies strictly to the left of the geodesic from a to b.
///
/// Error bound: 128u|b − a||c − a| + 40 e(|b − a| + |c − a|) + 128 e² (docs/error-bounds.md, E2).
template <class T>
[[nodiscard]] StageSign orientation_stage(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                          const T& error) {
  using std::sqrt;
  const T uu = norm(b - a);
  const T vv = norm(c - a);
  T bound = T(128) * unit_roundoff<T>() * T(sqrt(uu * vv)) + detail::underflow_bound<T>();
  if (error > 0) {
    bound += error * (T(40) * (T(sqrt(uu)) + T(sqrt(vv))) + T(128) * error);
  }
  return detail::sign_beyond(orientation_determinant(a, b, c), bound);
}

/// The sign of sinh²R − s for the hyperbolic circumradius R of a, b, c (R = ∞ where there is none): 1 if R is certainly
/// larger. `s_low` ≤ s ≤ `s_high`. All three points in |z| < 1.
///
/// Error bound: docs/error-bounds.md, E3.
template <class T>
[[nodiscard]] StageSign circumradius_stage(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                           const T& s_low, const T& s_high, const T& error) {
  using std::sqrt;
  const T u = unit_roundoff<T>();
  const T ab = norm(a - b);
  const T bc = norm(b - c);
  const T ca = norm(c - a);
  const T aa = T(1) - norm(a);
  const T bb = T(1) - norm(b);
  const T cc = T(1) - norm(c);
  const T x = ab * cc;
  const T y = bc * aa;
  const T z = ca * bb;
  const T sum = x + y;
  const T rest = sum - z;
  const T left = T(4) * ab * bc * ca;
  const T heron = T(4) * x * y - rest * rest;
  const T scale = (sum + z) * (sum + z);
  // Relative errors of the squared chords and of 1 − |z|².
  const T smallest = std::min({aa, bb, cc});
  if (!(smallest > 0)) {
    return {};
  }
  T chord = T(5) * u;
  T height = T(5) * u;
  if (error > 0) {
    const T shortest = sqrt(std::min({ab, bc, ca}));
    if (!(T(16) * error <= shortest) || !(T(16) * error <= smallest)) {
      return {};
    }
    chord += T(5) * error / shortest;
    height += T(3) * error;
  }
  height /= smallest;
  const T left_error = left * (T(4) * chord + T(8) * u);
  const T heron_error = scale * (T(6) * (chord + height) + T(16) * u);
  const T difference_low = left - s_low * heron;
  const T difference_high = left - s_high * heron;
  const T bound = (left_error + s_high * heron_error) * (T(1) + T(8) * u) + T(4) * u * s_high * scale +
                  detail::underflow_bound<T>();
  // s enters with the sign of the denominator; both ends have to agree.
  if (difference_low > bound && difference_high > bound) {
    return {1, true};
  }
  if (difference_low < -bound && difference_high < -bound) {
    return {-1, true};
  }
  return {};
}

/// circumradius_stage for exact binary64 points with |z| ≤ 0.75, without divisions: the path that nearly all triangles
/// take. s ≤ `s_high` ≤ s(1 + 4u).
///
/// Error bound: docs/error-bounds.md, E3'.
[[nodiscard]] inline StageSign circumradius_stage_near_origin(const Complex<double>& a, const Complex<double>& b,
                                                              const Complex<double>& c, double s_high) {
  const Sinh2Circumradius<double> r = sinh2_circumradius(a, b, c);
  const double bound =
      kUnitRoundoff * (32 * r.numerator + 160 * (s_high * r.scale)) + detail::underflow_bound<double>();
  return detail::sign_beyond(r.numerator - s_high * r.denominator, bound);
}

/// distance_stage for exact binary64 points with |z| ≤ 0.75, without divisions. s ≤ `s_high` ≤ s(1 + 4u).
///
/// Error bound: docs/error-bounds.md, E4'.
[[nodiscard]] inline StageSign distance_stage_near_origin(const Complex<double>& p, const Complex<double>& q,
                                                          double s_high) {
  const double chord2 = norm(p - q);
  const double limit = s_high * ((1 - norm(p)) * (1 - norm(q)));
  const double bound = kUnitRoundoff * (8 * chord2 + 48 * limit) + detail::underflow_bound<double>();
  return detail::sign_beyond(chord2 - limit, bound);
}

/// The sign of sinh²(d/2) − s for the hyperbolic distance d of two points of the disk: 1 if d is certainly larger.
/// `s_low` ≤ s ≤ `s_high`.
///
/// Error bound: docs/error-bounds.md, E4.
template <class T>
[[nodiscard]] StageSign distance_stage(const Complex<T>& p, const Complex<T>& q, const T& s_low, const T& s_high,
                                       const T& error) {
  using std::sqrt;
  const T u = unit_roundoff<T>();
  const T chord2 = norm(p - q);
  const T pp = T(1) - norm(p);
  const T qq = T(1) - norm(q);
  const T smallest = std::min(pp, qq);
  if (!(smallest > 0)) {
    return {};
  }
  const T heights = pp * qq;
  T height = T(5) * u;
  T chord_error = chord2 * T(5) * u;
  if (error > 0) {
    if (!(T(16) * error <= smallest)) {
      return {};
    }
    height += T(3) * error;
    chord_error += error * (T(5) * T(sqrt(chord2)) + T(8) * error);
  }
  height /= smallest;
  const T bound = chord_error + s_high * heights * (T(3) * height + T(8) * u) + detail::underflow_bound<T>();
  if (chord2 - s_high * heights > bound) {
    return {1, true};
  }
  if (chord2 - s_low * heights < -bound) {
    return {-1, true};
  }
  return {};
}

}  // namespace epsnet
