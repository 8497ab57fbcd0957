#pragma once

#include "certify/check.h"
#include "certify/document/distance_document.h"

/// The checker of distance files: decides whether a distance between two points lies in an interval and whether the
/// geodesics that are listed are all that are so short (docs/proof.md, section 14).
namespace epsnet::certify {

/// The rules by name, in the order in which they are asked: those of the net, then those below.
[[nodiscard]] RuleNames rules_of(const DistanceDocument& document);

/// Checks the net first, with its seven rules; its certificate is the answer unless it is verified. Then come the rules
///
/// * `paths`: the lengths lie in the enclosure, and no two paths are the same;
/// * `equal`: if they are said to be of equal length, they are, exactly;
/// * `nearest`: no geodesic between the two points that is not longer than the enclosure's upper end is missing.
///
/// As for `check`, a document of whatever content gives a certificate, which does not depend on the number of threads.
/// Nothing is searched: the time is that of the net, and proportional to paths times triangles, however long paths are.
[[nodiscard]] Certificate check_distance(const DistanceDocument& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
