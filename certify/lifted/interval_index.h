#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

#include "certify/base/lookup.h"
#include "certify/numbers/ball.h"

namespace epsnet::certify {

/// Items by intervals that enclose a number each has. Items whose numbers may be equal are found together: the
/// intervals of two equal numbers have a point in common, so no pair of equal numbers is missed, however wide the
/// intervals are.
///
/// Fault, if the ends of an interval are in the wrong order.
class IntervalIndex {
 public:
  /// O(log n).
  void insert(Interval x, std::uint32_t item);

  /// Every item whose interval meets x, in ascending order, and perhaps some whose interval is as near to x as it is
  /// wide. O(k log k + c log n) for k of them and intervals whose widths have c different exponents.
  [[nodiscard]] std::vector<std::uint32_t> near(Interval x) const;

 private:
  /// By an exponent e of the width, which is less than 2^e: the lower ends. So an upper end is less than 2^e higher,
  /// and one wide interval does not slow down the search among narrow ones.
  std::map<int, std::multimap<double, std::uint32_t>> by_width_;
  std::vector<std::uint32_t> unbounded_;  ///< Items about whose numbers binary64 says nothing.
};

inline void IntervalIndex::insert(Interval x, std::uint32_t item) {
  ensure(!(x.lower > x.upper), "an interval with its ends exchanged");
  const double width = above(x.upper - x.lower);
  // NaN and infinity are no widths.
  if (!std::isfinite(width)) {
    unbounded_.push_back(item);
    return;
  }
  int exponent = 0;
  (void)std::frexp(width, &exponent);
  by_width_[exponent].emplace(x.lower, item);
}

inline std::vector<std::uint32_t> IntervalIndex::near(Interval x) const {
  ensure(!(x.lower > x.upper), "an interval with its ends exchanged");
  std::vector<std::uint32_t> found = unbounded_;
  for (const auto& [exponent, items] : by_width_) {
    const auto last = items.upper_bound(x.upper);
    for (auto item = items.lower_bound(below(x.lower - std::ldexp(1.0, exponent))); item != last; ++item) {
      found.push_back(item->second);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace epsnet::certify
