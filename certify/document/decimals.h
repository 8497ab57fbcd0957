#pragma once

#include <string>

/// Bounds as decimals: what is read is a bound of the same number.
///
/// The decimal nearest to a binary64 may be on the wrong side of it, as 37.69911184307752 is of the binary64 below 12π.
/// These never are. They are laid out as by std::to_chars, all of them are JSON numbers, and different binary64 numbers
/// have different decimals in the same order. ±0 and what is not finite are as std::to_chars has them: "0", "-0",
/// "inf", "-inf", "nan". Constant time.
namespace epsnet::certify {

/// The decimal that is at most x (at least x) and reads back as x, to nearest and ties to even: one of the fewest
/// significant digits, and of these the nearest to x. It has at most 18.
[[nodiscard]] std::string decimal_below(double x);
[[nodiscard]] std::string decimal_above(double x);

/// The greatest decimal at most x (the least at least x) with no more than this many significant digits.
/// Requires: digits ≥ 1.
[[nodiscard]] std::string decimal_below(double x, unsigned digits);
[[nodiscard]] std::string decimal_above(double x, unsigned digits);

}  // namespace epsnet::certify
