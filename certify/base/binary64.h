#pragma once

#include <cfenv>
#include <cfloat>
#include <limits>

/// What is taken for granted of binary64 arithmetic, when this is compiled and when it runs (docs/proof.md, section
/// 16).
namespace epsnet::certify {

static_assert(std::numeric_limits<double>::is_iec559, "double is not the binary64 of IEEE 754");
static_assert(FLT_EVAL_METHOD == 0, "expressions of binary64 are not rounded to binary64 at every step");
#ifdef __FAST_MATH__
#error "with -ffast-math, what is computed is not what is written"
#endif

/// Whether this thread rounds to nearest, ties to even, and underflows gradually. Asked of the arithmetic itself:
/// std::fegetround does not know of every switch of a processor. A few operations.
[[nodiscard]] bool rounds_to_nearest();

/// Rounding to nearest for this thread, and for threads that it starts, as long as this object lives; then the
/// floating-point environment is again what it was. All bounds for rounding errors rely on it.
class RoundingToNearest {
 public:
  /// Throws Fault if the processor does not do it.
  RoundingToNearest();
  ~RoundingToNearest();
  RoundingToNearest(const RoundingToNearest&) = delete;
  RoundingToNearest& operator=(const RoundingToNearest&) = delete;

 private:
  std::fenv_t before_{};
};

}  // namespace epsnet::certify
