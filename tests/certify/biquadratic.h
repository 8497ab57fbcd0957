#pragma once

#include <array>
#include <gmpxx.h>
#include <vector>

/// Numbers that are small, but none of their conjugates are: comparisons that take the degree of a field for less than
/// it is do not tell them from 0.
namespace epsnet::certify::biquadratic {

/// x₀ + x₁√p + x₂√q + x₃√(pq).
using Element = std::array<mpz_class, 4>;

inline Element product(const Element& x, const Element& y, int p, int q) {
  return {x[0] * y[0] + p * x[1] * y[1] + q * x[2] * y[2] + p * q * x[3] * y[3],
          x[0] * y[1] + x[1] * y[0] + q * (x[2] * y[3] + x[3] * y[2]),
          x[0] * y[2] + x[2] * y[0] + p * (x[1] * y[3] + x[3] * y[1]),
          x[0] * y[3] + x[3] * y[0] + x[1] * y[2] + x[2] * y[1]};
}

/// (√2 − 1)⁶(√5 − 2)⁴(√10 − 3)³ in the powers 1, …, n: p = 2, q = 5.
inline std::vector<Element> powers_with_five(int n) {
  std::vector<Element> result;
  for (Element x{1, 0, 0, 0}; n > 0; --n) {
    for (int i = 0; i < 6; ++i) x = product(x, {-1, 1, 0, 0}, 2, 5);
    for (int i = 0; i < 4; ++i) x = product(x, {-2, 0, 1, 0}, 2, 5);
    for (int i = 0; i < 3; ++i) x = product(x, {-3, 0, 0, 1}, 2, 5);
    result.push_back(x);
  }
  return result;
}

/// (√2 − 1)³(2 − √3)²(5 − 2√6) in the powers 1, …, n: p = 2, q = 3.
inline std::vector<Element> powers_with_three(int n) {
  std::vector<Element> result;
  for (Element x{1, 0, 0, 0}; n > 0; --n) {
    for (int i = 0; i < 3; ++i) x = product(x, {-1, 1, 0, 0}, 2, 3);
    for (int i = 0; i < 2; ++i) x = product(x, {2, 0, -1, 0}, 2, 3);
    x = product(x, {5, 0, 0, -2}, 2, 3);
    result.push_back(x);
  }
  return result;
}

}  // namespace epsnet::certify::biquadratic
