#pragma once

#include <string>

namespace epsnet::certify {

/// A closed interval with binary64 ends.
struct Interval {
  double lower;
  double upper;
  bool operator==(const Interval&) const = default;
};

/// Returns "[lower, upper]": decimals that enclose the interval and read back as its ends (decimals.h).
[[nodiscard]] std::string to_string(Interval x);

}  // namespace epsnet::certify
