#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"

/// Phases of the sides of a surface, and the flat line bundle that they are (docs/proof.md, section 17.3). Exact.
namespace epsnet::certify {

/// What is wrong with the phases of so many sides; nullopt if there is one for each, written as a decimal without
/// exponent or as a rational of at most 40 characters, of absolute value less than 1, and all are multiples of 1/n for
/// some n ≤ 10¹⁸.
[[nodiscard]] Problem phases_problem(const std::vector<std::string>& phases, std::size_t sides);

/// A number of turns modulo 1, as a multiple of 1/n, n the denominator of a line bundle: less than n.
using Phase = std::uint64_t;

/// A section of it is multiplied by e^{2πiθ} across a side of phase θ.
class LineBundle {
 public:
  /// That of functions: all phases are 0.
  LineBundle() = default;
  /// By side of the surface. Requires: no problem.
  explicit LineBundle(const std::vector<std::string>& phases);

  /// The least n of which all phases are multiples of 1/n.
  [[nodiscard]] std::uint64_t denominator() const { return denominator_; }
  [[nodiscard]] Phase sum(Phase x, Phase y) const { return x < denominator_ - y ? x + y : x - (denominator_ - y); }
  [[nodiscard]] Phase difference(Phase x, Phase y) const { return x < y ? x + (denominator_ - y) : x - y; }
  /// e^{2πiφ}, with parts that are exact if they are 0 or ±1. Balls round to the precision of the caller.
  [[nodiscard]] ComplexBall turn(Phase phase) const;
  /// The sum of those of the sides.
  [[nodiscard]] Phase of(std::span<const std::uint32_t> word) const;

  /// The first pair of sides, or else the first vertex of the surface, at which phases do not add up to an integer;
  /// nullopt if there is none: then that of a word only depends on the element that is its value. O(number of sides).
  [[nodiscard]] Problem problem(const SurfaceSides& sides) const;

 private:
  std::uint64_t denominator_ = 1;
  std::vector<Phase> phases_;  ///< By side; empty: 0.
};

}  // namespace epsnet::certify
