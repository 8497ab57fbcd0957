#pragma once

#include <complex>
#include <vector>

/// A partition of unity by functions around lifts of vertices (docs/proof.md, Lemma 37.2).
namespace epsnet::certify {

/// Upper bounds for the sums of |Δψ_q| and of |∇ψ_q| over all q.
struct PartitionBounds {
  double laplacians = 0;
  double gradients = 0;
};

/// Within ε of the centre of a disk, where the functions of these lifts, of which one is the centre itself, count
/// within R of them. Infinite where they do not cover the disk. In binary64, with room for its errors. Time: some 1,500
/// cells, times the number of lifts.
///
/// Requires: 0 < ε < R < 2, ε rounded up; the lifts are known to 10⁻¹², and are all that are within ε + R.
[[nodiscard]] PartitionBounds partition_bounds(const std::vector<std::complex<double>>& lifts, double epsilon,
                                               double radius);

}  // namespace epsnet::certify
