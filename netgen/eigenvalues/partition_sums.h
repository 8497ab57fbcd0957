#pragma once

#include <complex>
#include <vector>

/// The partition of unity of eigenfunctions (docs/eigenvalues.md), where a file is made. What `certify` proves of it is
/// its own affair.
namespace epsnet {

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

}  // namespace epsnet
