#include "certify/base/binary64.h"

#include "certify/base/lookup.h"

namespace epsnet::certify {

bool rounds_to_nearest() {
  // Nothing of this is computed by the compiler.
  volatile double one = 1, more = 0x1.8p-53, half = 0x1p-53, least = 0x1p-1022;
  const bool up = one + more > 1 && -one - more < -1;
  const bool even = one + half == 1 && -one - half == -1 && (one + 2 * half) + half == 1 + 0x1p-51;
  const bool gradual = least / 2 != 0 && (least / 2) * 2 == least;
  return up && even && gradual;
}

RoundingToNearest::RoundingToNearest() {
  ensure(std::fegetenv(&before_) == 0, "the floating-point environment is not told");
  std::fesetenv(FE_DFL_ENV);
  if (rounds_to_nearest()) return;
  std::fesetenv(&before_);
  throw Fault("binary64 numbers are not rounded to nearest");
}

RoundingToNearest::~RoundingToNearest() { std::fesetenv(&before_); }

}  // namespace epsnet::certify
