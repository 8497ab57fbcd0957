#include "netgen/curves/balance.h"

#include <ClpSimplex.hpp>
#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace epsnet {

using certify::Interval;

std::optional<std::vector<double>> maximize_last(const std::vector<std::vector<double>>& rows,
                                                 const std::vector<double>& at_least,
                                                 const std::vector<double>& at_most, const std::vector<double>& least,
                                                 const std::vector<double>& greatest) {
  ClpSimplex model;
  model.setLogLevel(0);
  const auto count = static_cast<int>(least.size());
  model.resize(0, count);
  for (int j = 0; j < count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    model.setColumnBounds(j, least[at], greatest[at]);
    model.setObjectiveCoefficient(j, j + 1 == count ? -1 : 0);
  }
  std::vector<int> columns(static_cast<std::size_t>(count));
  for (int j = 0; j < count; ++j) columns[static_cast<std::size_t>(j)] = j;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    // What is 0 but for rounding is no pivot.
    constexpr double kNothing = 1e-12;
    std::vector<double> row = rows[i];
    for (double& x : row) {
      if (std::abs(x) < kNothing) x = 0;
    }
    model.addRow(count, columns.data(), row.data(), at_least[i], at_most[i]);
  }
  // Steps near a maximum are small.
  model.setPrimalTolerance(1e-11);
  model.setDualTolerance(1e-11);
  model.primal();
  if (!model.isProvenOptimal()) return std::nullopt;
  return std::vector<double>(model.primalColumnSolution(), model.primalColumnSolution() + count);
}

std::optional<std::vector<double>> balance(std::span<const std::vector<Interval>> gradients) {
  const std::size_t count = gradients.size();
  const std::size_t dimension = gradients[0].size();
  std::vector<std::vector<double>> rows(dimension + 1, std::vector<double>(count + 1, 0));
  std::vector<double> values(dimension + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < dimension; ++j) rows[j][i] = middle_of(gradients[i][j]);
    rows[dimension][i] = 1;
  }
  values[dimension] = 1;
  constexpr double kInfinite = std::numeric_limits<double>::max();
  std::vector<double> at_most = values;
  for (std::size_t i = 0; i < count; ++i) {
    auto& row = rows.emplace_back(count + 1, 0);
    row[i] = 1;
    row[count] = -1;
    values.push_back(0);
    at_most.push_back(kInfinite);
  }
  auto found =
      maximize_last(rows, values, at_most, std::vector<double>(count + 1, 0), std::vector<double>(count + 1, 1));
  constexpr double kLeastWeight = 1e-7;  // Less may be rounding.
  if (!found || found->back() < kLeastWeight) return std::nullopt;
  found->pop_back();
  return found;
}

std::vector<std::size_t> independent(std::span<const std::vector<Interval>> gradients) {
  // Of the greatest pivot; less is rounding.
  constexpr double kLeastPivot = 1e-9;
  using Index = Eigen::Index;
  const auto dimension = static_cast<Index>(gradients[0].size());
  Eigen::MatrixXd columns(dimension, static_cast<Index>(gradients.size()));
  for (std::size_t i = 0; i < gradients.size(); ++i) {
    for (Index j = 0; j < dimension; ++j)
      columns(j, static_cast<Index>(i)) = middle_of(gradients[i][static_cast<std::size_t>(j)]);
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(columns.rows(), columns.cols());
  decomposition.setThreshold(kLeastPivot);
  decomposition.compute(columns);
  std::vector<std::size_t> result;
  for (Index k = 0; k < decomposition.rank(); ++k)
    result.push_back(static_cast<std::size_t>(decomposition.colsPermutation().indices()[k]));
  return result;
}

}  // namespace epsnet
