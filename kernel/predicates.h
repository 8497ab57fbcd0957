#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "kernel/numbers.h"
#include "kernel/plane.h"

/// One stage of a staged predicate: a sign that is proved, or "unsure".
///
/// Every function takes points whose Euclidean distance from the true points is at most `error`, 0 for exact points.
/// Requires: the true points lie in the open unit disk. A function returns a sign only if it is the sign for the true
/// points. It returns "unsure" if any input is NaN or `error` is infinite. docs/error-bounds.md derives the constants;
/// tests/kernel/predicates_test.cpp compares every stage with exact arithmetic, and fails if the constants are a
/// hundred times smaller.
namespace epsnet {

/// The result of one stage: the sign −1, 0 or 1, or "unsure".
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
/// Added to every bound of the binary64 stage. Products that underflow lose their relative accuracy; this absolute term
/// exceeds the loss.
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
  using std::abs;
  // One comparison that is nearly always true, and the sign without a branch.
  if (abs(value) > bound) {
    return {value > T(0) ? 1 : -1, true};
  }
  return {0, false};
}
/// For 1 − |z|²: whether |z| ≤ 0.75, or z is no number or infinite, of which every stage is unsure.
template <class T>
[[nodiscard]] bool is_near_origin(const T& height) {
  return T(0.4375) <= height || height - height != 0;
}
template <class T>
[[nodiscard]] T in_circle_bound(const T& uu, const T& vv, const T& ww) {
  return T(16) * unit_roundoff<T>() * (uu * vv + vv * ww + ww * uu) + underflow_bound<T>();
}
}  // namespace detail

/// in_circle_stage from the parts of the determinant: with u = a − d, v = b − d, w = c − d, rounded once, the squared
/// lengths of u, v, w and the cross products (v, w), (w, u), (u, v).
template <class T>
[[nodiscard]] StageSign in_circle_stage_around(const std::array<T, 3>& norms, const std::array<T, 3>& crosses,
                                               const T& error) {
  using std::sqrt;
  const auto& [uu, vv, ww] = norms;
  const T det = uu * crosses[0] + vv * crosses[1] + ww * crosses[2];
  T bound = detail::in_circle_bound<T>(uu, vv, ww);
  if (error != 0) {
    const T m = sqrt(std::max({uu, vv, ww}));
    if (!(T(16) * error <= m)) {
      return {};
    }
    bound += T(40) * error * m * m * m;
  }
  return detail::sign_beyond(det, bound);
}

/// 1, 0 or −1 if d lies inside, on or outside the circle through a, b, c (counterclockwise). Hyperbolic circles are
/// Euclidean ones of the Poincaré disk, so this is the sign of the Euclidean determinant, with d as origin.
///
/// Error bound: 16u(αβ + βγ + γα) + 40 e M³ with α, β, γ the squared distances of a, b, c from d, M² the largest of
/// them, e = `error` (docs/error-bounds.md, E1).
template <class T>
[[nodiscard]] StageSign in_circle_stage(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                        const Complex<T>& d, const T& error) {
  const Complex<T> u = a - d;
  const Complex<T> v = b - d;
  const Complex<T> w = c - d;
  return in_circle_stage_around<T>({norm(u), norm(v), norm(w)}, {cross(v, w), cross(w, u), cross(u, v)}, error);
}

/// The sign of orientation_determinant(a, b, c): 1 if c lies strictly to the left of the geodesic from a to b.
///
/// Error bound: 80u|b − a|₁|c − a|₁ + 40 e(|b − a|₁ + |c − a|₁) + 128 e², |·|₁ the sum of the absolute coordinates,
/// which unlike the Euclidean length does not underflow for close points (docs/error-bounds.md, E2).
template <class T>
[[nodiscard]] StageSign orientation_stage(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                          const T& error) {
  using std::abs;
  const Complex<T> ab = b - a;
  const Complex<T> ac = c - a;
  const T u = abs(ab.x) + abs(ab.y);
  const T v = abs(ac.x) + abs(ac.y);
  T bound = T(80) * unit_roundoff<T>() * (u * v) + detail::underflow_bound<T>();
  if (error != 0) {
    if (!(T(16) * error <= T(1))) {
      return {};
    }
    bound += error * (T(40) * (u + v) + T(128) * error);
  }
  return detail::sign_beyond(orientation_determinant(a, b, c), bound);
}

/// The sign of sinh²R − s for the hyperbolic circumradius R of a, b, c (R = ∞ where there is none): 1 if R is certainly
/// larger. 0 ≤ `s_low` ≤ s ≤ `s_high`. Unsure for points that binary64 cannot tell from the unit circle.
///
/// Error bound: docs/error-bounds.md, E3.
template <class T>
[[nodiscard]] StageSign circumradius_stage(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                           const T& s_low, const T& s_high, const T& error) {
  using std::sqrt;
  assert(!(s_low < T(0)) && !(s_high < s_low) && !(error < T(0)));
  const T u = unit_roundoff<T>();
  const T ab = norm(a - b);
  const T bc = norm(b - c);
  const T ca = norm(c - a);
  const T aa = T(1) - norm(a);
  const T bb = T(1) - norm(b);
  const T cc = T(1) - norm(c);
  const auto [left, heron, scale] = sinh2_circumradius<T>(ab, bc, ca, aa, bb, cc);
  // Relative errors of the squared chords and of 1 − |z|².
  const T smallest = std::min({aa, bb, cc});
  T chord = T(5) * u;
  T height = T(5) * u;
  if (error != 0) {
    const T shortest = sqrt(std::min({ab, bc, ca}));
    if (!(T(16) * error <= shortest) || !(T(16) * error <= smallest)) {
      return {};
    }
    chord += T(5) * error / shortest;
    height += T(3) * error;
  }
  if (!(T(4) * height <= smallest)) {
    return {};
  }
  height /= smallest;
  const T left_error = left * (T(4) * chord + T(8) * u);
  const T heron_error = scale * (T(6) * (chord + height) + T(16) * u) + detail::underflow_bound<T>();
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

/// circumradius_stage for exact points with |z| ≤ 0.75, without divisions: the path that nearly all triangles take in
/// binary64. 0 < s ≤ `s_high` ≤ s(1 + 100u).
///
/// Error bound: u(32 numerator + 160 s scale) (docs/error-bounds.md, E3').
template <class T>
[[nodiscard]] StageSign circumradius_stage_near_origin(const Sinh2Circumradius<T>& r, const T& s_high) {
  assert(!(s_high <= T(0)));
  const T bound =
      unit_roundoff<T>() * (T(32) * r.numerator + T(160) * (s_high * (r.scale + detail::underflow_bound<T>()))) +
      detail::underflow_bound<T>();
  return detail::sign_beyond(T(r.numerator - s_high * r.denominator), bound);
}
/// The same from the points.
template <class T>
[[nodiscard]] StageSign circumradius_stage_near_origin(const Complex<T>& a, const Complex<T>& b, const Complex<T>& c,
                                                       const T& s_high) {
  assert(detail::is_near_origin<T>(T(1) - norm(a)) && detail::is_near_origin<T>(T(1) - norm(b)) &&
         detail::is_near_origin<T>(T(1) - norm(c)));
  return circumradius_stage_near_origin(sinh2_circumradius(a, b, c), s_high);
}

/// distance_stage for exact points with |z| ≤ 0.75, without divisions. 0 < s ≤ `s_high` ≤ s(1 + 100u).
///
/// Error bound: u(8|p − q|² + 128 s(1 − |p|²)(1 − |q|²)) (docs/error-bounds.md, E4').
template <class T>
[[nodiscard]] StageSign distance_stage_near_origin(const T& chord2, const T& height_p, const T& height_q,
                                                   const T& s_high) {
  assert(detail::is_near_origin(height_p) && detail::is_near_origin(height_q) && !(s_high <= T(0)));
  const T limit = s_high * (height_p * height_q);
  const T bound = unit_roundoff<T>() * (T(8) * chord2 + T(128) * limit) + detail::underflow_bound<T>();
  return detail::sign_beyond(T(chord2 - limit), bound);
}
/// The same from the points.
template <class T>
[[nodiscard]] StageSign distance_stage_near_origin(const Complex<T>& p, const Complex<T>& q, const T& s_high) {
  return distance_stage_near_origin<T>(norm(p - q), T(1) - norm(p), T(1) - norm(q), s_high);
}

/// The sign of sinh²(d/2) − s for the hyperbolic distance d of two points of the disk: 1 if d is certainly larger.
/// 0 ≤ `s_low` ≤ s ≤ `s_high`. Unsure for points that binary64 cannot tell from the unit circle.
///
/// Error bound: docs/error-bounds.md, E4.
template <class T>
[[nodiscard]] StageSign distance_stage(const Complex<T>& p, const Complex<T>& q, const T& s_low, const T& s_high,
                                       const T& error) {
  using std::sqrt;
  assert(!(s_low < T(0)) && !(s_high < s_low) && !(error < T(0)));
  const T u = unit_roundoff<T>();
  const T chord2 = norm(p - q);
  const T pp = T(1) - norm(p);
  const T qq = T(1) - norm(q);
  const T smallest = std::min(pp, qq);
  const T heights = pp * qq;
  T height = T(5) * u;
  T chord_error = chord2 * T(8) * u;
  if (error != 0) {
    if (!(T(16) * error <= smallest)) {
      return {};
    }
    height += T(3) * error;
    chord_error += error * (T(5) * T(sqrt(chord2)) + T(8) * error);
  }
  if (!(T(4) * height <= smallest)) {
    return {};
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
