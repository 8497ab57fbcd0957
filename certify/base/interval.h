#pragma once

#include <string>

/// Intervals, and bounds as decimals: the decimal of a bound is still a bound of the same number.
///
/// The decimal nearest to a binary64 may be on its wrong side: 37.69911184307752 is above 12π, and the binary64 that it
/// stands for is below. The decimals made here are always on the requested side. Their layout is that of std::to_chars;
/// all finite ones are JSON numbers. Different binary64 numbers have different decimals, in the same order. ±0,
/// infinities and NaN are printed as by std::to_chars: "0", "-0", "inf", "-inf", "nan". Constant time.
namespace epsnet::certify {

/// A closed interval with binary64 ends.
struct Interval {
  double lower;
  double upper;
  bool operator==(const Interval&) const = default;
};

/// Returns "[lower, upper]": decimals that enclose the interval and read back as its ends.
[[nodiscard]] std::string to_string(Interval x);

/// The decimal that is at most x and reads back as x, to nearest and ties to even: one of the fewest significant
/// digits, and of these the nearest to x. It has at most 18.
[[nodiscard]] std::string decimal_below(double x);
/// The same of decimals that are at least x.
[[nodiscard]] std::string decimal_above(double x);

/// The greatest decimal at most x with no more than this many significant digits. Requires: digits ≥ 1.
[[nodiscard]] std::string decimal_below(double x, unsigned digits);
/// The least decimal at least x, likewise.
[[nodiscard]] std::string decimal_above(double x, unsigned digits);

}  // namespace epsnet::certify
