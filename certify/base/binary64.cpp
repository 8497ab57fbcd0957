#include "certify/base/binary64.h"

#include "certify/base/lookup.h"

namespace epsnet::certify {

bool rounds_to_nearest() {
  // Nothing of this is computed by the compiler.
  volatile double one = 1, half = 0x1p-53, least = 0x1p-1022;
  // Of two ties the first is rounded down and the second up only by ties to even, of all directions of IEEE 754.
  const bool even = one + half == 1 && (one + 2 * half) + half == 1 + 0x1p-51;
  const bool gradual = (least / 2) * 2 == least;
  return even && gradual;
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
