#pragma once

#include <array>

#include "certify/numbers/ball.h"

namespace epsnet::certify {

/// Three balls side by side: a vector or a row.
using BallVector = std::array<Ball, 3>;
static_assert(sizeof(BallVector) == 3 * sizeof(arb_struct), "Arb reads a vector from its first entry on");

/// The plain dot product, of a row and a vector.
inline void dot(Ball& result, const BallVector& row, const BallVector& x, slong precision) {
  arb_dot(result.get(), nullptr, 0, row[0].get(), 1, x[0].get(), 1, 3, precision);
}

/// u × v: the row that vanishes on u and v.
[[nodiscard]] BallVector cross_product(const BallVector& u, const BallVector& v, slong precision);

/// u₀v₀ + u₁v₁ − u₂v₂ of two vectors, or of two rows.
[[nodiscard]] Ball lorentz_product(const BallVector& u, const BallVector& v, slong precision);

}  // namespace epsnet::certify
