#pragma once

#include <optional>

#include "kernel/numbers.h"

/// Rational numbers with few digits.
namespace epsnet {

/// The number with the smallest denominator in [low, high], 0 < low ≤ high.
[[nodiscard]] Rational simplest_between(Rational low, Rational high);

/// The simplest rational number within a factor 1 ± 2^−bits of x > 0.
[[nodiscard]] Rational simplest_near(const Mp1024& x, int bits);

/// The square root of a number that is not negative, if it is rational.
[[nodiscard]] std::optional<Rational> rational_root(const Rational& x);

}  // namespace epsnet
