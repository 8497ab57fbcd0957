#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/numbers/ball.h"

/// Arithmetic of intervals with binary64 ends, in a hundredth of the time that balls take: every end is moved outward
/// by more than the error of rounding to nearest (RoundingToNearest). An interval contains the values of the operation
/// at all points of its arguments. An end may be infinite or NaN, which says nothing; comparisons with it are
/// `unknown`. The functions have the names that they have for balls.
namespace epsnet::certify {

[[nodiscard]] constexpr Interval everything() {
  return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

[[nodiscard]] inline bool is_finite(Interval x) { return std::isfinite(x.lower) && std::isfinite(x.upper); }

[[nodiscard]] inline Interval operator-(Interval x) { return {-x.upper, -x.lower}; }
[[nodiscard]] inline Interval operator+(Interval x, Interval y) {
  return {below(x.lower + y.lower), above(x.upper + y.upper)};
}
[[nodiscard]] inline Interval operator-(Interval x, Interval y) { return x + -y; }
[[nodiscard]] inline Interval operator*(Interval x, Interval y) {
  if (!is_finite(x) || !is_finite(y)) return everything();
  const auto [least, most] = std::minmax({x.lower * y.lower, x.lower * y.upper, x.upper * y.lower, x.upper * y.upper});
  return {below(least), above(most)};
}
/// Everything unless y > 0 is certain.
[[nodiscard]] inline Interval operator/(Interval x, Interval y) {
  if (!is_finite(x) || !is_finite(y) || y.lower <= 0) return everything();
  return {below(x.lower / (x.lower < 0 ? y.lower : y.upper)), above(x.upper / (x.upper < 0 ? y.upper : y.lower))};
}
[[nodiscard]] inline Interval operator+(double n, Interval x) { return Interval{n, n} + x; }
[[nodiscard]] inline Interval operator*(double n, Interval x) { return Interval{n, n} * x; }

[[nodiscard]] inline Interval sqr(Interval x) {
  if (!is_finite(x)) return everything();
  const double least = x.lower > 0 ? x.lower : x.upper < 0 ? x.upper : 0;
  const double most = std::max(-x.lower, x.upper);
  return {std::max(below(least * least), 0.0), above(most * most)};
}
/// Everything unless x ≥ 0 is certain.
[[nodiscard]] inline Interval sqrt(Interval x) {
  if (!is_finite(x) || x.lower < 0) return everything();
  return {below(std::sqrt(x.lower)), above(std::sqrt(x.upper))};
}
/// By balls.
[[nodiscard]] inline Interval atan(Interval x) {
  if (!is_finite(x)) return everything();
  const Precision scope(64);
  return {lower_end(atan(Ball::exactly(x.lower))), upper_end(atan(Ball::exactly(x.upper)))};
}

[[nodiscard]] inline Tri certainly_less(Interval x, Interval y) {
  if (x.upper < y.lower) return Tri::yes;
  return x.lower >= y.upper ? Tri::no : Tri::unknown;
}
[[nodiscard]] inline Tri certainly_positive(Interval x) {
  if (x.lower > 0) return Tri::yes;
  return x.upper <= 0 ? Tri::no : Tri::unknown;
}

}  // namespace epsnet::certify
