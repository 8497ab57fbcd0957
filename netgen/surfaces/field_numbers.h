#pragma once

#include <array>
#include <gmpxx.h>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/plane.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/triangle_group.h"

/// The real numbers of the ring of a triangle group, as texts, and matrices of them.
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

/// Texts for 2cos(2π/n) with the order n of a ring, and for its s.
struct RingGenerators {
  std::string cosine;
  std::string s;
};

/// The numbers that generate the real numbers of a ring, as texts that NumberFieldReader reads.
[[nodiscard]] RingGenerators generator_texts(const certify::RegularRing& ring);

/// Real numbers of a ring as polynomials in its generators, texts that NumberFieldReader reads; up to a common positive
/// factor. Requires: as field_texts.
[[nodiscard]] std::vector<std::string> number_texts(const std::vector<certify::RegularNumber>& numbers,
                                                    const RingGenerators& generators);

/// The isometry of the disk of a matrix with these numbers, as its text has them, up to scale. w = (z − i)/(z + i)
/// takes the half-plane to the disk.
template <class T>
[[nodiscard]] Isometry<T> isometry_of_entries(const std::array<T, 4>& e, MatrixModel model) {
  if (model == MatrixModel::su11) return {{e[0], e[1]}, {e[2], e[3]}};
  return {{T(e[0] + e[3]), T(e[1] - e[2])}, {T(e[0] - e[3]), T(-e[1] - e[2])}};
}

/// surface_of_matrices for matrices in the ring of a triangle group: `matrices.tile` is there. Throws likewise.
[[nodiscard]] MatrixSurface surface_of_field_matrices(const MatrixGenerators& matrices);

}  // namespace epsnet
