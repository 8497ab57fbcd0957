#pragma once

#include <array>

#include "certify/base/tile.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/exact.h"

/// Isometries of the Poincaré disk in ball arithmetic.
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

/// z ↦ (a z + b)/(b̄ z + ā), |a|² − |b|² = 1.
struct BallIsometry {
  ComplexBall a;
  ComplexBall b;
};

[[nodiscard]] BallIsometry identity_isometry();
/// f ∘ g; the products are rounded to `precision` bits.
[[nodiscard]] BallIsometry compose(const BallIsometry& f, const BallIsometry& g, slong precision);
[[nodiscard]] BallIsometry inverse(const BallIsometry& f);
/// The exact isometry, scaled to determinant 1, to about `precision` bits.
[[nodiscard]] BallIsometry to_balls(const ExactIsometry& f, slong precision);
/// The work of that, for an isometry of so many bits: its determinant is exact.
[[nodiscard]] constexpr std::uint64_t to_balls_work(std::uint64_t exact_bits, std::uint64_t precision) {
  return 2 * product_work(exact_bits) + 32 * ball_work(precision);
}
/// The crossing of side k of a regular tile to side l of another: (−iη^{l − k} cosh ρ, iη^{l + k} sinh ρ), η =
/// e^{iπ/p}, ρ the distance of the centre from the sides, cosh ρ = cos(π/q)/sin(π/p); l + p stands for l if l < k.
/// Requires: a hyperbolic tile; k, l < p.
[[nodiscard]] BallIsometry regular_crossing(RegularTile tile, std::uint32_t k, std::uint32_t l, slong precision);
/// sinh ρ.
[[nodiscard]] Ball sinh_of_apothem(RegularTile tile, slong precision);
/// |f(0)|²/(1 − |f(0)|²) = |b|² = sinh²(d/2), d the distance of 0 and f(0).
void half_displacement_squared(arb_ptr result, const BallIsometry& f, slong precision);

}  // namespace epsnet::certify
