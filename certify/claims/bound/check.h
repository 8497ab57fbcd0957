#pragma once

#include <cstdint>
#include <string>

#include "certify/base/text.h"
#include "certify/claims/bound/document.h"
#include "certify/verdict/report.h"

/// The claim of a bound file: whether the diameter, the radius, or the radius of the largest embedded disk lies between
/// the bounds (docs/proof.md, section 15).
namespace epsnet::certify {

struct Claim;

/// What is wrong with the structure of a bound file, with its place; nullopt if it can be evaluated: the net has one
/// vertex and no collars, the value is 0 < lo ≤ hi, triangulations come after those they are made from, and the cells
/// of every triangle are one whole subdivision. O(size).
[[nodiscard]] Problem structure_problem(const BoundDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const BoundDocument& document);

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
