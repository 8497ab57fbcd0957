#pragma once

#include <gmpxx.h>
#include <string>
#include <string_view>
#include <vector>

#include "netgen/surfaces/triangle_group.h"

/// The real numbers of the ring of a triangle group, as texts.
namespace epsnet {

/// A number of the ring, divided by an integer: exactly, and rounded.
struct RingNumber {
  certify::RegularNumber numerator;
  mpz_class denominator;
  TriangleGroup::Number rounded;
};

/// Reads a real number of the ring: sums, differences and products of integers, fractions, sqrt(x), cos(a*pi/b),
/// sin(a*pi/b) and s, with parentheses and division by rational numbers, as in "(1+sqrt(2))/2-s*cos(pi/8)". Throws
/// SurfaceError, which says what is wrong, or which number is not in the ring.
[[nodiscard]] RingNumber parse_ring_number(std::string_view text, const TriangleGroup& group);

/// Texts of real numbers that parse_ring_number reads, up to a common positive integer factor. Requires: the degrees
/// of the numbers are less than half of the order.
[[nodiscard]] std::vector<std::string> field_texts(const std::vector<certify::RegularNumber>& numbers);

}  // namespace epsnet
