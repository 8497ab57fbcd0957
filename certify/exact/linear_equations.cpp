#include "certify/exact/linear_equations.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace epsnet::exact {
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
