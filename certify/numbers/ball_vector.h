#pragma once

#include "certify/numbers/ball.h"

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

/// u × v: the row that vanishes on u and v.
[[nodiscard]] BallVector cross_product(const BallVector& u, const BallVector& v, slong precision);

/// u₀v₀ + u₁v₁ − u₂v₂ of two vectors, or of two rows.
void lorentz_product(arb_ptr result, const BallVector& u, const BallVector& v, slong precision);

}  // namespace epsnet::certify
