#pragma once

#include "certify/claims/distance/structure.h"
#include "certify/claims/net/claim.h"

/// The claim of a distance file: whether the distance of two points lies in an interval, and the list contains all
/// geodesics between them of length up to the upper end (docs/proof.md, section 14).
namespace epsnet::certify {

/// The names of its own rules, in order:
///
/// * `paths`: the lengths lie in the enclosure, and no two paths are the same;
/// * `equal`: if they are claimed to have equal lengths, the lengths are exactly equal;
/// * `nearest`: every geodesic between the two points is listed if it is not longer than the enclosure's upper end.
///
/// There is no search: O(paths · triangles) time, however long the paths are.
[[nodiscard]] RuleNames own_rules(const DistanceDocument& document);

[[nodiscard]] Claim claim_of(const DistanceDocument& document);

}  // namespace epsnet::certify
