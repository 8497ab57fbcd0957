#pragma once

#include "certify/numbers/isometry.h"

/// The hyperboloid model in ball arithmetic.
///
/// A point z of the disk is the vector X = (2x, 2y, 1 + |z|²)/(1 − |z|²) with ⟨X, X⟩ = −1, where ⟨u, v⟩ = u₀v₀ + u₁v₁ −
/// u₂v₂; −⟨X, Y⟩ is the cosh of the distance. Linear functionals are kept as rows, so that their value is the plain dot
/// product: the row of ⟨n, ·⟩ is (n₀, n₁, −n₂).
namespace epsnet::certify {

/// Three balls side by side: a vector or a row.
class BallVector {
 public:
  BallVector() {
    for (arb_struct& x : entries_) arb_init(&x);
  }
  BallVector(const BallVector& other) : BallVector() { *this = other; }
  BallVector(BallVector&& other) noexcept : BallVector() { swap(other); }
  BallVector& operator=(const BallVector& other) {
    if (this == &other) return *this;
    for (std::size_t i = 0; i < 3; ++i) arb_set(&entries_[i], &other.entries_[i]);
    return *this;
  }
  BallVector& operator=(BallVector&& other) noexcept {
    swap(other);
    return *this;
  }
  ~BallVector() {
    for (arb_struct& x : entries_) arb_clear(&x);
  }

  [[nodiscard]] arb_ptr operator[](std::size_t i) { return &entries_[i]; }
  [[nodiscard]] arb_srcptr operator[](std::size_t i) const { return &entries_[i]; }

 private:
  void swap(BallVector& other) {
    for (std::size_t i = 0; i < 3; ++i) arb_swap(&entries_[i], &other.entries_[i]);
  }

  arb_struct entries_[3];
};

/// The plain dot product, of a row and a vector.
inline void dot(arb_ptr result, const BallVector& row, const BallVector& x, slong precision) {
  arb_dot(result, nullptr, 0, row[0], 1, x[0], 1, 3, precision);
}

/// ⟨u, v⟩ of two vectors, or of two rows.
void lorentz_product(arb_ptr result, const BallVector& u, const BallVector& v, slong precision);

/// The unit vector of the point L(x + iy).
[[nodiscard]] BallVector unit_vector(const BallIsometry& label, double x, double y, slong precision);

/// The matrix of an isometry.
struct BallMatrix {
  BallVector rows[3];
};

[[nodiscard]] BallMatrix lorentz_matrix(const BallIsometry& f, slong precision);
[[nodiscard]] BallVector apply(const BallMatrix& m, const BallVector& x, slong precision);

/// The same isometry with Re a > 0; the sign of (a, b) means nothing. Unchanged if balls do not tell: whoever compares
/// Re a afterwards asks for its sign first, or for cosh_half_length.
void choose_sign(BallIsometry& f);

/// cosh(l/2) = |Re a| for the translation length l, whatever the sign of (a, b).
[[nodiscard]] Ball cosh_half_length(const BallIsometry& f);

/// The row of the unit normal of the axis of f, positive on the left of the axis directed like the translation. f is
/// hyperbolic with Re a = cosh(l/2), l its translation length. Not finite if balls do not tell Re a > 1.
[[nodiscard]] BallVector axis_row(const BallIsometry& f, slong precision);

}  // namespace epsnet::certify
