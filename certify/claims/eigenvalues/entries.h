#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "certify/numbers/ball.h"
#include "certify/numbers/inertia.h"

/// Entries of matrices in binary64, from numbers that are known better (docs/proof.md, section 17). Nothing overflows:
/// numbers of triangles and of files are far from the greatest binary64.
namespace epsnet::certify {

/// A ball as a number of binary64: all its points are at most `error` from `value`.
struct Rounded {
  explicit Rounded(const Ball& x) {
    const Interval in = outer_interval(x);
    value = in.lower / 2 + in.upper / 2;
    error = above(above(in.upper - in.lower));
  }
  double value;
  double error;
};

/// x − σy at place (i, j) or (j, i), σ exact: how far it may be from the number that x and y stand for.
[[nodiscard]] inline MatrixEntry difference_entry(std::uint32_t i, std::uint32_t j, const Rounded& x, double sigma,
                                                  const Rounded& y) {
  const double product = sigma * y.value;
  const double value = x.value - product;
  const double errors = above(x.error + above(sigma * y.error));
  const double rounding = above(above(std::abs(product) + std::abs(value)) * 0x1p-52);
  return {std::max(i, j), std::min(i, j), value, above(errors + rounding)};
}

/// x times a number of absolute value at most 1.
[[nodiscard]] inline MatrixEntry multiple_of(const MatrixEntry& x, const Rounded& factor) {
  const double value = x.value * factor.value;
  const double errors = above(above(std::abs(x.value) * factor.error) + x.error);
  return {x.row, x.column, value, above(errors + above(std::abs(value)) * 0x1p-52)};
}

}  // namespace epsnet::certify
