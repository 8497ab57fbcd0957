#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/numbers/inertia.h"
#include "netgen/eigenvalues/elements.h"

/// Eigenvalues of large sparse matrices, rounded.
namespace epsnet {

/// An order of elimination with little fill, for a matrix of which the lower half is given: nested dissection.
[[nodiscard]] std::vector<std::uint32_t> elimination_order(const Eigen::SparseMatrix<double>& lower_half);

/// The inertia of energy − σ mass, by this order of elimination: a bound for how many eigenvalues of energy·x = μ
/// mass·x, 0 included, are less than σ, and whether `certify` can prove it by this order. If a number is wanted, more
/// is done to prove that it is at most, or at least, so many.
[[nodiscard]] certify::Inertia inertia(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order,
                                       double sigma, certify::Bound bound, unsigned threads,
                                       std::optional<std::uint64_t> wanted = std::nullopt);

/// Eigenvalues in increasing order, and the vectors as columns.
struct DiscreteSpectrum {
  std::vector<double> values;
  Eigen::MatrixXd vectors;
};

/// The first `count` of them, 0 included, or all if there are fewer, by Lanczos's method with a shift below 0, with
/// this order of elimination. Throws NetError if it does not converge.
[[nodiscard]] DiscreteSpectrum first_eigenvalues(const ElementMatrices& matrices,
                                                 const std::vector<std::uint32_t>& order, std::uint32_t count);

}  // namespace epsnet
