#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/net/document.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/isometry.h"

/// Which lifts of the vertices of a net are near each other. Balls round to the precision of the caller.
namespace epsnet::certify {

/// A lift of a vertex, seen from another vertex.
struct NearVertex {
  std::uint32_t vertex;
  /// From the disk with this vertex in its centre to the disk with the other one in its centre. Each is the disk of the
  /// vertex's chart, translated.
  BallIsometry isometry;
  Ball sinh_squared;  ///< sinh²(d/2), d the distance of the two.
};

/// By vertex: all lifts of vertices nearer than `distance`, but itself, and perhaps some that are as far to the balls'
/// precision. Nothing if balls do not tell which of them are the same. BudgetSpent.
///
/// Requires: the rules of the net are verified; `labels` are the values of its labels, number k ≥ 1 at k − 1. Time: the
/// square of the number of lifts at most `distance` + 2ε away, by vertex.
[[nodiscard]] std::optional<std::vector<std::vector<NearVertex>>> near_vertices(const NetDocument& net,
                                                                                const std::vector<BallIsometry>& labels,
                                                                                const Ball& distance,
                                                                                const Budget& budget, unsigned threads);

}  // namespace epsnet::certify
