#pragma once

namespace epsnet::certify {

/// A closed interval with binary64 ends.
struct Interval {
  double lower;
  double upper;
  bool operator==(const Interval&) const = default;
};

}  // namespace epsnet::certify
