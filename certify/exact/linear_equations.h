#pragma once

#include <optional>
#include <vector>

#include "certify/exact/interval.h"

namespace epsnet::exact {

/// The x with Σ_j matrix[i][j] x_j = right[i] for all i, as many as there are unknowns. Nothing unless the matrix
/// certainly has an inverse, by elimination in intervals. O(n³) for n unknowns; throws LeftOut for more than 500.
[[nodiscard]] std::optional<std::vector<Interval>> solution(std::vector<std::vector<Interval>> matrix,
                                                            std::vector<Interval> right);

}  // namespace epsnet::exact
