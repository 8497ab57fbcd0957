#pragma once

#include "certify/numbers/isometry.h"
#include "triangulation/surface/surface.h"

/// The isometries of words in the numbers of certify/numbers (group.h has those of the kernel).
namespace epsnet {

/// The crossing of a side of a rational tile, in integers.
[[nodiscard]] certify::ExactIsometry integer_crossing(const Surface& surface, SideId side);

/// The isometry of a word on rational tiles, from the coordinates of the tile where the path starts to those of the
/// tile where it ends: the product of the crossings of its letters, the first one applied first. In integers without a
/// common factor. Quasi-linear in the digits of the result.
[[nodiscard]] certify::ExactIsometry integer_isometry(const Surface& surface, const Word& word);

/// 4 cosh² of half of the length of the closed geodesic of a word on rational tiles, exactly: tr² over the determinant.
[[nodiscard]] mpq_class squared_trace(const Surface& surface, const Word& word);

/// The isometry of a word on any surface, scaled to determinant 1, in balls of about so many bits; ball arithmetic
/// loses some more on long words over regular tiles.
[[nodiscard]] certify::BallIsometry ball_isometry(const Surface& surface, const Word& word, slong precision);

}  // namespace epsnet
