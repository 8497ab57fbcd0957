#pragma once

#include "certify/base/fault.h"
#include "certify/claims/geodesics/document.h"
#include "certify/verdict/report.h"

/// The checker of geodesics files. It decides whether a list of closed geodesics is what the file claims
/// (docs/proof.md, section 11).
namespace epsnet::certify {

/// Returns the names of the rules in the order of evaluation: those of the net, then those of `check_geodesics` that
/// the claim needs.
[[nodiscard]] RuleNames rules_of(const GeodesicsDocument& document);

/// Checks the net first, with its seven rules. If the net is not verified, returns the net's certificate. Otherwise
/// checks the rules
///
/// * `geodesics`: every element is a closed geodesic whose length lies in its enclosure and is at most `up_to`;
/// * `distinct`: no two are the same up to orientation, and none is a power of another;
/// * `simple`: they are simple or not, as claimed; those of a thick-thin decomposition are pairwise disjoint;
/// * `equal`: the lengths of a cluster are exactly equal if the file claims so;
/// * `complete`: none is missing (a systole: none is shorter);
/// * `pieces`: the surface cut along them has the claimed pieces.
///
/// A systole needs only `geodesics`, `simple` and `complete`; only a thick-thin decomposition needs `pieces`. Like
/// `check`, returns a certificate for a document of any content; the number of threads does not change it. Time is
/// proportional to the number of lifted triangles visited, about e^L for geodesics of length up to L.
[[nodiscard]] Certificate check_geodesics(const GeodesicsDocument& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
