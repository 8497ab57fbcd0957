#pragma once

#include <cfenv>
#include <cfloat>
#include <limits>
#include <string>

/// What is asked of binary64, intervals of its numbers, and bounds as decimals: the decimal of a bound is still a bound
/// of the same number.
///
/// The decimal nearest to a binary64 may be on its wrong side: 37.69911184307752 is above 12π, and the binary64 that it
/// stands for is below. The decimals made here are always on the requested side. Their layout is that of std::to_chars;
/// all finite ones are JSON numbers. Different binary64 numbers have different decimals, in the same order. ±0,
/// infinities and NaN are printed as by std::to_chars: "0", "-0", "inf", "-inf", "nan". Constant time.
namespace epsnet::certify {

// What is taken for granted of binary64 arithmetic, when this is compiled and when it runs (docs/proof.md, section 16).

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
  /// Restores the floating-point environment.
  ~RoundingToNearest();
  RoundingToNearest(const RoundingToNearest&) = delete;
  RoundingToNearest& operator=(const RoundingToNearest&) = delete;

 private:
  std::fenv_t before_{};
};

/// A closed interval with binary64 ends.
struct Interval {
  double lower;
  double upper;
  bool operator==(const Interval&) const = default;
};

/// Returns "[lower, upper]": decimals that enclose the interval and read back as its ends.
[[nodiscard]] std::string to_string(Interval x);

/// The decimal that is at most x and reads back as x, to nearest and ties to even: one of the fewest significant
/// digits, and of these the nearest to x. It has at most 18.
[[nodiscard]] std::string decimal_below(double x);
/// The same of decimals that are at least x.
[[nodiscard]] std::string decimal_above(double x);

/// The greatest decimal at most x with no more than this many significant digits. Requires: digits ≥ 1.
[[nodiscard]] std::string decimal_below(double x, unsigned digits);
/// The least decimal at least x, likewise.
[[nodiscard]] std::string decimal_above(double x, unsigned digits);

}  // namespace epsnet::certify
