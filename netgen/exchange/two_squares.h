#pragma once

#include <optional>
#include <vector>

#include "triangulation/surface/exact_points.h"

namespace epsnet {

/// Whether an integer is a sum of two squares; if it is not known, neither member is set.
struct TwoSquares {
  std::optional<Complex<Integer>> root;  ///< x + iy with x² + y² = n.
  /// Proves that there is none: a divisor that is 3 modulo 4, either a prime of odd multiplicity or the unfactored rest
  /// of n.
  std::optional<Integer> obstacle;
};

/// Writes n > 0 as a sum of two squares, that is, as the norm of a Gaussian integer.
///
/// Primes below 2¹⁶ are divided out; a greatest common divisor with a hint splits off a Gaussian factor without
/// factoring its norm. The rest is a square, a prime of at most 4,096 bits, or too hard; if it is too hard, neither
/// member of the result is set. So only an obstacle proves that there is no such sum (Fermat). Deterministic; quadratic
/// time in the number of digits for each hint, cubic for a prime. Numbers of more than 20,000 bits are too hard.
[[nodiscard]] TwoSquares two_squares(const Integer& n, const std::vector<Complex<Integer>>& hints);

}  // namespace epsnet
