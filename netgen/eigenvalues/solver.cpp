#include "netgen/eigenvalues/solver.h"

#include <numeric>
#include <utility>

namespace epsnet {

Real dot(const RealVector& x, const RealVector& y) {
  return std::inner_product(x.begin(), x.end(), y.begin(), Real(0));
}

std::optional<Solver> Solver::of(RealMatrix matrix) {
  using boost::multiprecision::abs;
  Solver result(std::move(matrix));
  RealMatrix& a = result.factors_;
  std::iota(result.rows_.begin(), result.rows_.end(), std::size_t{0});
  for (std::size_t k = 0; k < a.size(); ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < a.size(); ++i) {
      if (abs(a[i][k]) > abs(a[pivot][k])) pivot = i;
    }
    if (a[pivot][k] == 0) return std::nullopt;
    std::swap(a[k], a[pivot]);
    std::swap(result.rows_[k], result.rows_[pivot]);
    for (std::size_t i = k + 1; i < a.size(); ++i) {
      a[i][k] /= a[k][k];
      for (std::size_t j = k + 1; j < a.size(); ++j) a[i][j] -= a[i][k] * a[k][j];
    }
  }
  return result;
}

RealVector Solver::solve(const RealVector& right) const {
  const std::size_t size = rows_.size();
  RealVector x(size);
  for (std::size_t i = 0; i < size; ++i) {
    x[i] = right[rows_[i]];
    for (std::size_t j = 0; j < i; ++j) x[i] -= factors_[i][j] * x[j];
  }
  for (std::size_t i = size; i-- > 0;) {
    for (std::size_t j = i + 1; j < size; ++j) x[i] -= factors_[i][j] * x[j];
    x[i] /= factors_[i][i];
  }
  return x;
}

}  // namespace epsnet
