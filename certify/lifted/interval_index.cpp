#include "certify/lifted/interval_index.h"

#include <algorithm>
#include <cmath>

#include "certify/base/lookup.h"
#include "certify/numbers/ball.h"

namespace epsnet::certify {

void IntervalIndex::insert(Interval x, std::uint32_t item) {
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

std::vector<std::uint32_t> IntervalIndex::near(Interval x) const {
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
