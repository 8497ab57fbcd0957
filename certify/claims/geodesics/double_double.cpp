#include "certify/claims/geodesics/double_double.h"

#include <limits>

namespace epsnet::certify {

DoubleDouble to_double_double(const Ball& x) {
  constexpr slong kBits = 4096;  // More than are between the greatest and the least binary64: nothing is rounded.
  const double high = arf_get_d(arb_midref(x.get()), ARF_RND_NEAR);
  const Precision scope(kBits);
  const double low = arf_get_d(arb_midref((x - Ball::exactly(high)).get()), ARF_RND_NEAR);
  const Interval rest = outer_interval(abs(x - Ball::exactly(high) - Ball::exactly(low)));
  if (!std::isfinite(high) || !std::isfinite(low)) return {0, 0, std::numeric_limits<double>::infinity()};
  return {high, low, rest.upper};
}

}  // namespace epsnet::certify
