#pragma once

#include "certify/base/fault.h"
#include "certify/claims/bound/document.h"
#include "certify/verdict/report.h"

/// The checker of bound files. It decides whether the diameter, the radius, or the radius of the largest embedded disk
/// lies between the bounds (docs/proof.md, section 15).
namespace epsnet::certify {

/// Returns the names of the rules in the order of evaluation: those of the net, then those of `check_bound`.
[[nodiscard]] RuleNames rules_of(const BoundDocument& document);

/// Checks the net first, with its seven rules. If the net is not verified, returns the net's certificate. Otherwise
/// checks the rules
///
/// * `lower`: at the net's vertex the function is at least the lower bound;
/// * `upper`, for a radius instead of `lower`: at the net's vertex the eccentricity is at most the upper bound;
/// * `triangulations`: every flip is of an edge between two different triangles;
/// * `cells`: at the three corners of each cell the convex function that bounds it is at most the upper bound;
/// * `cells`, for a radius: at one point of each cell the eccentricity exceeds the lower bound by so much that it is at
///   least the lower bound in the whole cell.
///
/// Like `check`, returns a certificate for a document of any content; the number of threads does not change it.
/// O(cells · triangles) time.
[[nodiscard]] Certificate check_bound(const BoundDocument& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
