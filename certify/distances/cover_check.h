#pragma once

#include "certify/check.h"
#include "certify/document/cover_document.h"

/// The checker of cover files: whether the diameter, the radius, or that of the largest embedded disk, lies between the
/// bounds (docs/proof.md, section 15).
namespace epsnet::certify {

/// The rules by name, in the order in which they are asked: those of the net, then those below.
[[nodiscard]] RuleNames rules_of(const CoverDocument& document);

/// Checks the net first, with its seven rules; its certificate is the answer unless it is verified. Then come the rules
///
/// * `lower`: at the net's vertex the function is at least the lower bound; or, for a radius, `upper`: it is at most
/// the
///   upper bound;
/// * `triangulations`: every flip is of an edge between two different triangles;
/// * `cells`: at the three corners of each cell the convex function that bounds it is at most the upper bound; or, for
/// a
///   radius, at a point of each cell the eccentricity is so much more than the lower bound that it is at least that
///   much in all of the cell.
///
/// As for `check`, a document of whatever content gives a certificate, which does not depend on the number of threads.
/// O(cells · triangles) time.
[[nodiscard]] Certificate check_cover(const CoverDocument& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
