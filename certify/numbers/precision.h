#pragma once

#include <algorithm>

#include "certify/numbers/ball.h"

/// How many bits balls have, and when exact arithmetic takes over.
namespace epsnet::certify {

/// Bits that a question is asked with first: they decide nearly all.
inline constexpr long kFirstPrecision = 64;

/// Bits from which on exact arithmetic is tried on what balls leave open. No precision of balls decides an exact tie;
/// but an exact answer takes as much time as many passes with balls, and near ties are decided by a few more bits. A
/// net has as many edges as one likes, and its near ties do not reach 256 bits.
inline constexpr long kExactFromForEdges = 256;

/// Calls attempt(precision) with `first` bits, with twice as many, and so on, the last time with `cap` bits (once, if
/// `cap` is not more than `first`), until it returns true: decided. Returns whether it did. Balls round to as many
/// bits.
template <class Attempt>
bool with_rising_precision(long cap, const Attempt& attempt, long first = kFirstPrecision) {
  for (long precision = std::min(first, cap);; precision = std::min(2 * precision, cap)) {
    const Precision scope(precision);
    if (attempt(precision)) return true;
    if (precision >= cap) return false;
  }
}

}  // namespace epsnet::certify
