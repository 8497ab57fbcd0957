#pragma once

#include "certify/claims/geodesics/structure.h"
#include "certify/claims/net/claim.h"

/// The claim of a geodesics file: whether a list of closed geodesics is what the file says (docs/proof.md, section 11).
namespace epsnet::certify {

/// The names of its own rules, in order:
///
/// * `geodesics`: every element is a closed geodesic whose length lies in its enclosure and is at most `up_to`;
/// * `distinct`: no two are the same up to orientation, and none is a power of another;
/// * `simple`: they are simple or not, as claimed; those of a thick-thin decomposition are pairwise disjoint;
/// * `equal`: the lengths of a cluster are exactly equal if the file claims so;
/// * `complete`: none is missing (a systole: none is shorter);
/// * `pieces`: the surface cut along them has the claimed pieces.
///
/// A systole needs only `geodesics`, `simple` and `complete`; only a thick-thin decomposition needs `pieces`. Time is
/// proportional to the number of lifted triangles visited, about e^L for geodesics of length up to L.
[[nodiscard]] RuleNames own_rules(const GeodesicsDocument& document);

[[nodiscard]] Claim claim_of(const GeodesicsDocument& document);

}  // namespace epsnet::certify
