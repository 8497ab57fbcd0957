#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "certify/numbers/ball.h"

namespace epsnet::certify {

/// More than what underflows of a product.
inline constexpr double kUnderflow = 0x1p-900;

/// A number within `radius` of high + low, two numbers of binary64, |low| ≤ 2⁻⁵³ |high|: some hundred bits, in a fifth
/// of the time that balls take. Nothing is known of a number whose members are not finite. docs/proof.md, Lemma 14.1,
/// bounds the errors; it asks for rounding to nearest (RoundingToNearest).
struct DoubleDouble {
  double high = 0;
  double low = 0;
  double radius = 0;

  [[nodiscard]] DoubleDouble operator-() const { return {-high, -low, radius}; }
};

/// A number that encloses the ball.
[[nodiscard]] DoubleDouble to_double_double(const Ball& x);

[[nodiscard]] inline bool is_finite(const DoubleDouble& x) { return std::isfinite(x.high) && std::isfinite(x.radius); }

/// 1 or −1 if the number certainly has this sign; else 0, which says nothing.
[[nodiscard]] inline int certain_sign(const DoubleDouble& x) {
  // |low| is at most half of |high|.
  if (!(std::fabs(x.high) > 2 * x.radius)) return 0;
  return x.high > 0 ? 1 : -1;
}

/// An interval around a number that is finite.
[[nodiscard]] inline Interval fast_interval(const DoubleDouble& x) {
  // |low| is less than the units by which each end is moved once more.
  return {below(below(x.high) - x.radius), above(above(x.high) + x.radius)};
}

/// x₀y₀ + x₁y₁ + …, of up to three products.
template <std::size_t N>
[[nodiscard]] DoubleDouble sum_of_products(const std::array<DoubleDouble, N>& x, const std::array<DoubleDouble, N>& y) {
  static_assert(N <= 3, "the bounds for errors are those of three products");
  double sum = 0;        // Of the products of the high parts, rounded,
  double rest = 0;       // and what is to be added to it.
  double size = 0;       // Of the absolute values of these products.
  double inherited = 0;  // The error of the factors.
  for (std::size_t i = 0; i < N; ++i) {
    // T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18, 1971.
    const auto split = [](double a) {
      const double scaled = 0x1.0000002p+27 * a;
      const double upper = scaled - (scaled - a);
      return std::array{upper, a - upper};
    };
    const double product = x[i].high * y[i].high;
    const auto [a, b] = split(x[i].high);
    const auto [c, d] = split(y[i].high);
    const double error = ((a * c - product) + a * d + b * c) + b * d;
    rest += error + (x[i].high * y[i].low + x[i].low * y[i].high);
    // D. E. Knuth, The Art of Computer Programming 2, 4.2.2, Theorem B.
    const double before = sum;
    sum += product;
    const double part = sum - before;
    rest += (before - (sum - part)) + (product - part);
    size += std::fabs(product);
    inherited += std::fabs(x[i].high) * y[i].radius + std::fabs(y[i].high) * x[i].radius + x[i].radius * y[i].radius;
  }
  const double high = sum + rest;
  const double part = high - sum;
  const double low = (sum - (high - part)) + (rest - part);
  return {high, low, (0x1p-98 * size + inherited) * (1 + 0x1p-40) + kUnderflow};
}

}  // namespace epsnet::certify
