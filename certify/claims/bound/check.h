#pragma once

#include "certify/claims/bound/structure.h"
#include "certify/claims/net/claim.h"

/// The claim of a bound file: whether the diameter, the radius, or the radius of the largest embedded disk lies between
/// the bounds (docs/proof.md, section 15).
namespace epsnet::certify {

/// The names of its own rules, in order:
///
/// * `lower`: at the net's vertex the function is at least the lower bound;
/// * `upper`, for a radius instead of `lower`: at the net's vertex the eccentricity is at most the upper bound;
/// * `triangulations`: every flip is of an edge between two different triangles;
/// * `cells`: at the three corners of each cell the convex function that bounds it is at most the upper bound;
/// * `cells`, for a radius: at one point of each cell the eccentricity exceeds the lower bound by so much that it is at
///   least the lower bound in the whole cell.
///
/// O(cells · triangles) time.
[[nodiscard]] RuleNames own_rules(const BoundDocument& document);

[[nodiscard]] Claim claim_of(const BoundDocument& document);

}  // namespace epsnet::certify
