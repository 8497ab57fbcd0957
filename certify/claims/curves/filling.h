#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/isometries/frames.h"
#include "certify/lifted/lifted_plane.h"

/// What closed geodesics cut a surface into (docs/proof.md, Lemmas 47 and 48).
namespace epsnet::certify {

/// Whether all components of the surface without some closed geodesics are disks. `points` are the crossing points of
/// all of a list, at least one of which `geodesics` names, each once; `euler` is the Euler characteristic of the
/// surface. Nullopt if the precision is too low. O(n log n) for n crossing points, and the square of the number of
/// passages through one point. Throws BudgetSpent.
[[nodiscard]] std::optional<bool> fill(const LiftedPlane& plane, const std::vector<std::vector<CrossingPoint>>& points,
                                       std::span<const std::uint32_t> geodesics, std::int64_t euler);

}  // namespace epsnet::certify
