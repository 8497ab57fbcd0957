#include "certify/exact/interval.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "certify/exact/plane.h"

namespace epsnet::exact {

/// (cosh 2x − 1)/2 = Σ 2^(2i−1) x^(2i)/(2i)!
SquaredSinh squared_sinh(const mpq_class& x) {
  if (x == 0) return {};
  if (x > 1000) throw TooLarge{"a length is greater than 1000"};
  // So many bits that the first term, x², has 256.
  const auto size = static_cast<long>(bits(x.get_den())) - static_cast<long>(bits(x.get_num()));
  const auto k = static_cast<mp_bitcnt_t>(256 + 2 * std::max(size, 0L));
  if (k > 100'000) throw TooLarge{"a length is too small"};
  const mpz_class scale = mpz_class(1) << k;
  const mpz_class low = x.get_num() * x.get_num() * scale / (x.get_den() * x.get_den());
  const mpz_class high = low + 1;
  // Terms t_1 = x² and t_(i+1) = t_i 4x²/((2i + 1)(2i + 2)), rounded down and up; quotients of integers are rounded
  // down.
  mpz_class lower = low, upper = high, t = low, u = high;
  for (unsigned long i = 1;; ++i) {
    const mpz_class divisor = mpz_class((2 * i + 1) * (2 * i + 2)) << k;
    t = t * low * 4 / divisor;
    u = u * high * 4 / divisor + 1;
    lower += t;
    upper += u;
    // From here on each term is less than half of the one before: the rest is less than the last one.
    if (t == 0 && high * 8 < divisor) break;
  }
  return {.lower = lower, .upper = upper + u, .k = k};
}

namespace {

/// A bound from below for the absolute value; 0 if it may be 0 or is unknown.
double least_size(const Interval& x) {
  const double size = std::max(x.lower(), -x.upper());
  return size > 0 ? size : 0;
}

}  // namespace

std::optional<std::vector<Interval>> solution(std::vector<std::vector<Interval>> matrix, std::vector<Interval> right) {
  constexpr std::size_t kMostUnknowns = 500;
  const std::size_t size = matrix.size();
  if (size > kMostUnknowns) throw LeftOut{"equations with so many unknowns"};
  for (std::size_t k = 0; k < size; ++k) {
    const auto pivot =
        std::max_element(matrix.begin() + static_cast<std::ptrdiff_t>(k), matrix.end(),
                         [&](const auto& row, const auto& other) { return least_size(row[k]) < least_size(other[k]); });
    if (least_size((*pivot)[k]) == 0) return std::nullopt;
    std::swap(right[k], right[static_cast<std::size_t>(pivot - matrix.begin())]);
    std::swap(matrix[k], *pivot);
    for (std::size_t i = k + 1; i < size; ++i) {
      const Interval factor = matrix[i][k] / matrix[k][k];
      for (std::size_t j = k + 1; j < size; ++j) matrix[i][j] = matrix[i][j] - factor * matrix[k][j];
      right[i] = right[i] - factor * right[k];
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    for (std::size_t j = k + 1; j < size; ++j) right[k] = right[k] - matrix[k][j] * right[j];
    right[k] = right[k] / matrix[k][k];
  }
  return right;
}

}  // namespace epsnet::exact
