#pragma once

#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "triangulation/surface.h"

/// Paths across sides as isometries: exactly, and enclosed to any precision.
namespace epsnet {

/// An interval with rational ends that contains a number.
struct EnclosedNumber {
  Rational lower;
  Rational upper;
};

/// Enclosures of an isometry (a, b) of determinant |a|² − |b|² = 1, which is one of the two such pairs, part by part.
struct EnclosedIsometry {
  EnclosedNumber a_re;
  EnclosedNumber a_im;
  EnclosedNumber b_re;
  EnclosedNumber b_im;
};

/// The bits that may be asked of an enclosure.
inline constexpr unsigned kMostEnclosureBits = 1U << 20;

/// The isometry of a word, from the coordinates of the tile where the path starts to those of the tile where it ends:
/// the product of the crossings of its letters, the first one applied first. (a, b) are Gaussian integers without a
/// common integer factor. Throws SurfaceError for a word that is no path, and for `is_regular` surfaces, whose
/// crossings are not rational. Quasi-linear in the number of digits of the result.
[[nodiscard]] Isometry<Rational> exact_isometry(const Surface& surface, const Word& word);

/// The same scaled to determinant 1, in intervals that are at most 2^−bits·|a| wide, by ball arithmetic (Arb): proved,
/// for every surface. Ends are dyadic. Throws SurfaceError for a word that is no path, std::invalid_argument beyond
/// kMostEnclosureBits. Linear in the letters of the word, at fixed precision.
[[nodiscard]] EnclosedIsometry enclosed_isometry(const Surface& surface, const Word& word, unsigned bits);

}  // namespace epsnet
