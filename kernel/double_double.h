#pragma once

#include <cmath>

#include "kernel/numbers.h"

namespace epsnet {

/// A number as the unevaluated sum of two binary64 numbers, the second at most half of an ulp of the first: about 106
/// bits, at the price of a dozen binary64 operations each.
///
/// Sums are off by at most 3.1u² of themselves, u = 2⁻⁵³, products by 7u², as long as nothing overflows or underflows
/// (M. Joldeş, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building blocks of double-word
/// arithmetic, ACM Trans. Math. Softw. 44 (2017), Algorithms 6 and 11).
struct DoubleDouble {
  double high = 0;  ///< The number rounded to binary64.
  double low = 0;   ///< The rest.

  /// 0.
  DoubleDouble() = default;
  /// A binary64 number, exactly.
  constexpr explicit DoubleDouble(double value) : high(value) {}
  /// The sum high + low. Requires: `low` is at most half an ulp of `high`.
  constexpr DoubleDouble(double high_part, double low_part) : high(high_part), low(low_part) {}
  /// Rounded twice: off by at most u² of the value.
  explicit DoubleDouble(const Mp256& value)
      : high(static_cast<double>(value)), low(static_cast<double>(value - high)) {}

  /// Rounded to binary64.
  constexpr explicit operator double() const { return high; }
};

namespace double_double_detail {

/// a + b without error, for any a and b.
constexpr DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a + b without error. Requires: |a| ≥ |b|.
constexpr DoubleDouble exact_sum_of_ordered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

}  // namespace double_double_detail

/// −a, exactly.
[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }

/// a + b, off by at most 3.1u² of itself.
[[nodiscard]] constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  using double_double_detail::exact_sum, double_double_detail::exact_sum_of_ordered;
  const DoubleDouble high = exact_sum(a.high, b.high);
  const DoubleDouble low = exact_sum(a.low, b.low);
  const DoubleDouble sum = exact_sum_of_ordered(high.high, high.low + low.high);
  return exact_sum_of_ordered(sum.high, low.low + sum.low);
}

/// a − b, off by at most 3.1u² of itself.
[[nodiscard]] constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

/// a b, off by at most 7u² of itself.
[[nodiscard]] inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const double high = a.high * b.high;
  const double high_error = std::fma(a.high, b.high, -high);
  const double low = std::fma(a.low, b.high, a.high * b.low);
  return double_double_detail::exact_sum_of_ordered(high, high_error + low);
}

}  // namespace epsnet
