#pragma once

#include <cmath>

namespace epsnet::certify {

/// A binary64 below (above) x, a unit in the last place or two away: |x| 2⁻⁵² is at least such a unit, and where it
/// underflows the least positive number is one. NaN if x is NaN, and below +∞, above −∞.
[[nodiscard]] inline double below(double x) { return x - (std::fabs(x) * 0x1p-52 + 0x1p-1074); }
[[nodiscard]] inline double above(double x) { return x + (std::fabs(x) * 0x1p-52 + 0x1p-1074); }

}  // namespace epsnet::certify
