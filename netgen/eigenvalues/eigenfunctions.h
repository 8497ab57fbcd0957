#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "certify/claims/eigenvalues/document.h"

/// Functions around the vertices of a net, as a file of eigenvalues has them (docs/eigenvalues.md), rounded.
namespace epsnet {

// The partition of unity, where a file is made. What `certify` proves of it is its own affair.

/// About the sums of |Δψ_q| and of |∇ψ_q| over all q, where they are greatest.
struct PartitionSums {
  double laplacians = 0;
  double gradients = 0;
};

/// Within ε of the centre of a disk, where the functions of these lifts, of which one is the centre itself, count
/// within R of them: what can be proved by squares with a twentieth of that disk for sides, but for some percent.
/// Infinite where they do not cover the disk. Time: some 300 points, times the number of lifts.
[[nodiscard]] PartitionSums partition_sums(const std::vector<std::complex<double>>& lifts, double epsilon,
                                           double radius);

/// An eigenfunction of a file, to be drawn. All numbers are rounded.
class EigenfunctionValues {
 public:
  /// Function `function` of row `row` of `document.eigenfunctions`; the document must outlive it. Throws
  /// std::out_of_range if there is none.
  EigenfunctionValues(const certify::EigenvaluesDocument& document, std::size_t row, std::size_t function);

  /// The value at a point of the disk with the net's vertex in its centre: the disk of the vertex's chart, moved by z ↦
  /// (z − v)/(1 − v̄z). Good within the row's `radius` of the vertex. O(number of coefficients of the vertex).
  [[nodiscard]] double at(std::size_t vertex, std::complex<double> z) const;

 private:
  double lambda_;
  const std::vector<double>& coefficients_;
  std::size_t each_;  ///< Coefficients of each vertex.
};

}  // namespace epsnet
