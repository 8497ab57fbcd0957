#pragma once

#include <optional>

#include "netgen/eigenvalues/trace_matrices.h"

namespace epsnet {

/// A matrix, factored by elimination with row exchanges.
class Solver {
 public:
  /// Nothing if a pivot is 0.
  [[nodiscard]] static std::optional<Solver> of(RealMatrix matrix);
  [[nodiscard]] RealVector solve(const RealVector& right) const;

 private:
  explicit Solver(RealMatrix matrix) : factors_(std::move(matrix)), rows_(factors_.size()) {}

  RealMatrix factors_;
  std::vector<std::size_t> rows_;
};

[[nodiscard]] Real dot(const RealVector& x, const RealVector& y);

}  // namespace epsnet
