#pragma once

#include "certify/base/fault.h"
#include "certify/claims/distance/document.h"
#include "certify/verdict/report.h"

/// The checker of distance files. It decides whether the distance of two points lies in an interval, and whether the
/// list contains all geodesics between them of length up to the upper end (docs/proof.md, section 14).
namespace epsnet::certify {

/// Returns the names of the rules in the order of evaluation: those of the net, then those of `check_distance`.
[[nodiscard]] RuleNames rules_of(const DistanceDocument& document);

/// Checks the net first, with its seven rules. If the net is not verified, returns the net's certificate. Otherwise
/// checks the rules
///
/// * `paths`: the lengths lie in the enclosure, and no two paths are the same;
/// * `equal`: if they are claimed to have equal lengths, the lengths are exactly equal;
/// * `nearest`: every geodesic between the two points is listed if it is not longer than the enclosure's upper end.
///
/// Like `check`, returns a certificate for a document of any content; the number of threads does not change it. There
/// is no search: the time is that of checking the net plus O(paths · triangles), however long the paths are.
[[nodiscard]] Certificate check_distance(const DistanceDocument& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
