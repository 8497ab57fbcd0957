#pragma once

#include <algorithm>
#include <cmath>
#include <gmpxx.h>
#include <limits>

#include "certify/exact/interval.h"
#include "certify/exact/plane.h"

/// Signs that a few digits tell: exact numbers are asked for only where they do not.
namespace epsnet::exact {

/// An interval of numbers of binary64. Ends are moved outward after each operation, by more than any direction of
/// rounding can change them, also if numbers close to 0 are replaced by it. What overflows becomes the whole line.
class RoughInterval {
 public:
  RoughInterval() = default;
  RoughInterval(long n)  // NOLINT(google-explicit-constructor): numbers in formulas.
      : RoughInterval(RoughInterval::around(static_cast<double>(n), static_cast<double>(n))) {}
  /// Numbers between the ends. Requires: no end is wrong by more than a unit in its last place.
  static RoughInterval around(double lower, double upper) {
    RoughInterval result;
    result.lower_ = lower - margin(lower);
    result.upper_ = upper + margin(upper);
    return std::isfinite(result.lower_) && std::isfinite(result.upper_) ? result : everything();
  }
  explicit RoughInterval(const Interval& x) : RoughInterval(around(x.lower(), x.upper())) {}
  explicit RoughInterval(const mpq_class& x) : RoughInterval(Interval(x)) {}

  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return upper_; }

  friend RoughInterval operator+(const RoughInterval& x, const RoughInterval& y) {
    return around(x.lower_ + y.lower_, x.upper_ + y.upper_);
  }
  friend RoughInterval operator-(const RoughInterval& x, const RoughInterval& y) {
    return around(x.lower_ - y.upper_, x.upper_ - y.lower_);
  }
  friend RoughInterval operator-(const RoughInterval& x) {
    RoughInterval result;
    result.lower_ = -x.upper_;
    result.upper_ = -x.lower_;
    return result;
  }
  friend RoughInterval operator*(const RoughInterval& x, const RoughInterval& y) {
    const double products[] = {x.lower_ * y.lower_, x.lower_ * y.upper_, x.upper_ * y.lower_, x.upper_ * y.upper_};
    const double sum = (products[0] + products[1]) + (products[2] + products[3]);
    // One that is not a number would be lost among the others.
    if (std::isnan(sum)) return around(sum, sum);
    return around(std::min({products[0], products[1], products[2], products[3]}),
                  std::max({products[0], products[1], products[2], products[3]}));
  }

  friend RoughInterval operator/(const RoughInterval& x, const RoughInterval& y) {
    if (certain_sign(y) == 0) return everything();
    return x * around(1 / y.upper_, 1 / y.lower_);
  }
  friend RoughInterval square(const RoughInterval& x) {
    RoughInterval result = x * x;
    result.lower_ = std::max(result.lower_, 0.0);
    return result;
  }
  /// Of a number that is known not to be negative.
  friend RoughInterval sqrt(const RoughInterval& x) {
    return around(std::sqrt(std::max(x.lower_, 0.0)), std::sqrt(x.upper_));
  }

  /// 1 or −1 if all numbers of the interval have this sign, else 0.
  friend int certain_sign(const RoughInterval& x) { return (x.lower_ > 0 ? 1 : 0) - (x.upper_ < 0 ? 1 : 0); }

 private:
  static RoughInterval everything() {
    RoughInterval result;
    result.lower_ = -std::numeric_limits<double>::infinity();
    result.upper_ = std::numeric_limits<double>::infinity();
    return result;
  }
  /// An operation in binary64 errs by at most 2⁻⁵² times its result, or by 2⁻¹⁰²² if numbers below that become 0; so
  /// does the sum of the result and the margin.
  static double margin(double end) { return std::abs(end) * 0x1p-50 + 0x1p-1000; }

  double lower_ = 0;
  double upper_ = 0;
};

[[nodiscard]] inline Answer is_less(const RoughInterval& x, const RoughInterval& y) {
  if (x.upper() < y.lower()) return Answer::yes;
  return x.lower() >= y.upper() ? Answer::no : Answer::unknown;
}

/// Whether numerator/denominator < sinh²x, as of exact numbers; the bounds of sinh² are given.
[[nodiscard]] inline Answer is_less(const RoughInterval& numerator, const RoughInterval& denominator,
                                    const RoughInterval& bounds) {
  const int sign = certain_sign(numerator - bounds * denominator);
  return sign < 0 ? Answer::yes : sign > 0 ? Answer::no : Answer::unknown;
}

/// The bounds of sinh², which are finite, as one interval.
[[nodiscard]] inline RoughInterval rough(const SquaredSinh& s) {
  return RoughInterval(Interval(s.lower, s.upper, static_cast<mpfr_exp_t>(s.k)));
}

/// A rational point, with the denominator 1.
[[nodiscard]] inline Point<RoughInterval> rough(const Point<mpz_class>& z) {
  return {{RoughInterval(mpq_class(z.n.re, z.m)), RoughInterval(mpq_class(z.n.im, z.m))}, 1};
}

/// The same isometry, with coefficients of at most 1 or so.
template <class R>
[[nodiscard]] Isometry<RoughInterval> rough(const Isometry<R>& f) {
  const Interval a_re = enclosure(f.a.re);
  const Interval a_im = enclosure(f.a.im);
  const Interval b_re = enclosure(f.b.re);
  const Interval b_im = enclosure(f.b.im);
  const Interval size = sqrt(square(a_re) + square(a_im));
  const auto scaled = [&](const Interval& x) { return RoughInterval(x / size); };
  return {{scaled(a_re), scaled(a_im)}, {scaled(b_re), scaled(b_im)}};
}

/// Up to a positive factor of all three numbers.
[[nodiscard]] inline Point<RoughInterval> image(const Isometry<RoughInterval>& f, const Point<RoughInterval>& z) {
  const Complex<RoughInterval> n = f.a * z.n + z.m * f.b;
  const Complex<RoughInterval> d = conjugate(f.b) * z.n + z.m * conjugate(f.a);
  return {n * conjugate(d), norm(d)};
}

}  // namespace epsnet::exact
