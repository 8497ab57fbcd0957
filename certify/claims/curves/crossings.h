#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/isometries/frames.h"
#include "certify/lifted/lifted_plane.h"

/// What the crossing points of closed geodesics say: how often they cross, and what they cut a surface into
/// (docs/proof.md, Lemmas 46 to 48).
namespace epsnet::certify {

/// How often closed geodesics cross each other, and themselves.
struct CrossingNumbers {
  /// By two geodesics: how often the second one passes through a point of the first one. By one and itself: twice as
  /// often as it crosses itself.
  std::vector<std::vector<std::uint64_t>> points;
  /// How often the second one crosses the first one from its right to its left, less how often the other way.
  std::vector<std::vector<std::int64_t>> signs;
};

/// `points` are the crossing points of all geodesics of a list. The square of their number, and their points. Throws
/// BudgetSpent.
[[nodiscard]] CrossingNumbers crossing_numbers(const LiftedPlane& plane,
                                               const std::vector<std::vector<CrossingPoint>>& points);

/// Whether all components of the surface without some closed geodesics are disks. `points` are the crossing points of
/// all of a list, at least one of which `geodesics` names, each once; `euler` is the Euler characteristic of the
/// surface. Nullopt if the precision is too low. O(n log n) for n crossing points, and the square of the number of
/// passages through one point. Throws BudgetSpent.
[[nodiscard]] std::optional<bool> fill(const LiftedPlane& plane, const std::vector<std::vector<CrossingPoint>>& points,
                                       std::span<const std::uint32_t> geodesics, std::int64_t euler);

}  // namespace epsnet::certify
