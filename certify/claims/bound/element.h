#pragma once

#include "certify/numbers/ball_vector.h"
#include "certify/numbers/isometry.h"

/// How far an isometry moves a point (docs/proof.md, section 15).
namespace epsnet::certify {

/// An element g at one precision: sinh²(d(p, gp)/2) = square + ⟨normal, p⟩² for unit vectors p, as the normal of the
/// axis has the square sinh²(l/2).
struct Element {
  BallIsometry isometry;
  BallVector normal_row;
  Ball square;
};

/// Contains what is true of every isometry in the ball.
[[nodiscard]] Element element_of(BallIsometry isometry, slong precision);

/// sinh²(d(p, gp)/2), p a unit vector of the hyperboloid.
[[nodiscard]] Ball displacement(const Element& element, const BallVector& p, slong precision);

}  // namespace epsnet::certify
