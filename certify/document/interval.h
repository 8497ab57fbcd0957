#pragma once

#include <string>

namespace epsnet::certify {

/// A closed interval with binary64 ends.
struct Interval {
  double lower;
  double upper;
  bool operator==(const Interval&) const = default;
};

/// Returns "[lower, upper]", each end as the shortest decimal that reads back as the same binary64.
[[nodiscard]] std::string to_string(Interval x);

}  // namespace epsnet::certify
