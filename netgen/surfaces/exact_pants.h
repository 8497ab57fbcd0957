#pragma once

#include <optional>

#include "kernel/numbers.h"
#include "netgen/surfaces/fenchel_nielsen.h"

/// Surfaces of pairs of pants of which the marks are exact (docs/fenchel-nielsen.md, "Exact lengths and twists").
namespace epsnet {

// Rational numbers with few digits.

/// The number with the smallest denominator in [low, high], 0 < low ≤ high.
[[nodiscard]] Rational simplest_between(Rational low, Rational high);

/// The simplest rational number within a factor 1 ± 2^−bits of x > 0.
[[nodiscard]] Rational simplest_near(const Mp1024& x, int bits);

/// The square root of a number that is not negative, if it is rational.
[[nodiscard]] std::optional<Rational> rational_root(const Rational& x);

/// What such a surface is made of, as texts of NumberFieldReader: c = cosh(length/2) and u =
/// tanh(twist/2)/sinh(length/2) by edge, and √Δ by pair of pants, Δ = c₁² + c₂² + c₃² + 2c₁c₂c₃ − 1.
struct PantsNumbers {
  std::vector<std::string> cosh;
  std::vector<std::string> shift;
  std::vector<std::string> root;
};

/// Returns exact lengths as they are, and for each decimal length a nearby one, within a factor 1 ± 2⁻⁵⁰, of which c is
/// rational, equal ones for equal lengths, so that most √Δ are rational as well; twists that are 0 or half of the
/// length, and exact ones, as they are. Returns nullopt if decimal lengths leave more than three √Δ irrational, or have
/// more digits than are of use. Linear in the genus. Requires: coordinates within their limits.
[[nodiscard]] std::optional<PantsNumbers> pants_numbers(const FenchelNielsen& coordinates);

/// The twist of an edge as a share of its length, from −½ to less than ½.
[[nodiscard]] Rational share_of_twist(const FenchelNielsen& coordinates, std::size_t edge);
/// Whether it is a twist that a reflection may fix.
[[nodiscard]] inline bool is_symmetric_share(const Rational& share) { return share == 0 || share == Rational(-1, 2); }

/// Returns the surface: the tiles are rational if all numbers are, else over the least field that has them. Throws
/// SurfaceError if its degree is more than 64.
[[nodiscard]] Surface surface_of_pants(const FenchelNielsen& coordinates, const PantsNumbers& numbers);

}  // namespace epsnet
