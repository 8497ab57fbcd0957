#pragma once

#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "triangulation/surface/surface.h"

/// Paths across sides as isometries: exactly, and enclosed to any precision.
namespace epsnet {

/// An interval with rational ends that contains a number.
struct EnclosedNumber {
  Rational lower;
  Rational upper;
};

/// Enclosures of the real and imaginary parts of an isometry (a, b) of determinant |a|² − |b|² = 1. Two such pairs
/// exist, (a, b) and (−a, −b); this is one of them.
struct EnclosedIsometry {
  EnclosedNumber a_re;
  EnclosedNumber a_im;
  EnclosedNumber b_re;
  EnclosedNumber b_im;
};

/// The most bits that a caller may request of an enclosure.
inline constexpr unsigned kMostEnclosureBits = 1U << 20;

/// Returns the isometry of a word, from the coordinates of the tile where the path starts to those of the tile where it
/// ends. It is the product of the crossings of its letters, the first one applied first. (a, b) are Gaussian integers
/// without a common integer factor. Throws SurfaceError if the word is not a path, and for `is_regular` surfaces, whose
/// crossings are not rational. Quasi-linear in the number of digits of the result.
[[nodiscard]] Isometry<Rational> exact_isometry(const Surface& surface, const Word& word);

/// Returns that isometry scaled to determinant 1, in intervals of width at most 2^−bits·|a|. Ball arithmetic (Arb)
/// proves them, for every surface. The ends are dyadic. Throws SurfaceError if the word is not a path,
/// std::invalid_argument beyond kMostEnclosureBits. Linear in the letters of the word, at fixed precision.
[[nodiscard]] EnclosedIsometry enclosed_isometry(const Surface& surface, const Word& word, unsigned bits);

}  // namespace epsnet
