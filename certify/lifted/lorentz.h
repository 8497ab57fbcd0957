#pragma once

#include "certify/numbers/isometry.h"

/// The hyperboloid model in ball arithmetic.
///
/// A point z of the disk is the vector X = (2x, 2y, 1 + |z|²)/(1 − |z|²) with ⟨X, X⟩ = −1, where ⟨u, v⟩ = u₀v₀ + u₁v₁ −
/// u₂v₂; −⟨X, Y⟩ is the cosh of the distance. Linear functionals are kept as rows, so that their value is the plain dot
/// product: the row of ⟨n, ·⟩ is (n₀, n₁, −n₂).
namespace epsnet::certify {

/// The unit vector of the point L(x + iy).
[[nodiscard]] BallVector unit_vector(const BallIsometry& label, double x, double y, slong precision);

/// The matrix of an isometry.
using BallMatrix = std::array<BallVector, 3>;

[[nodiscard]] BallMatrix lorentz_matrix(const BallIsometry& f, slong precision);
[[nodiscard]] BallVector apply(const BallMatrix& m, const BallVector& x, slong precision);

/// The same isometry with Re a > 0; the sign of (a, b) means nothing. Unchanged if balls do not tell: whoever compares
/// Re a afterwards asks for its sign first, or for cosh_half_length.
void choose_sign(BallIsometry& f);

/// cosh(l/2) = |Re a| for the translation length l, whatever the sign of (a, b).
[[nodiscard]] Ball cosh_half_length(const BallIsometry& f);

/// The row of the traceless part of f, (i Im a, b), which is the image of the vector (−Im b, Re b, Im a).
[[nodiscard]] BallVector traceless_row(const BallIsometry& f);

/// The row of the unit normal of the axis of f, positive on the left of the axis directed like the translation. f is
/// hyperbolic with Re a = cosh(l/2), l its translation length. Not finite if balls do not tell Re a > 1.
[[nodiscard]] BallVector axis_row(const BallIsometry& f, slong precision);

}  // namespace epsnet::certify
