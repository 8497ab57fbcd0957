#pragma once

#include "certify/check.h"
#include "certify/document/geodesics_document.h"

/// The checker of geodesics files: decides whether a list of closed geodesics is what it is said to be (docs/proof.md,
/// section 11).
namespace epsnet::certify {

/// The rules by name, in the order in which they are asked: those of the net, then those below that the claim needs.
[[nodiscard]] RuleNames rules_of(const GeodesicsDocument& document);

/// Checks the net first, with its seven rules; its certificate is the answer unless it is verified. Then come the rules
///
/// * `geodesics`: every element is a closed geodesic whose length lies in its enclosure and is at most `up_to`;
/// * `distinct`: no two are the same up to orientation, and none is a power of another;
/// * `simple`: they are simple or not, as said; those of a thick-thin decomposition are pairwise disjoint;
/// * `equal`: clusters that are said to consist of equal lengths do, exactly;
/// * `complete`: none is missing (a systole: none is shorter);
/// * `pieces`: the surface cut along them has the pieces said;
///
/// of which a systole needs the first, the third and the fifth, and only a thick-thin decomposition needs the last. As
/// for `check`, a document of whatever content gives a certificate, which does not depend on the number of threads.
/// Time is proportional to the lifted triangles visited, about e^L for geodesics of length up to L.
[[nodiscard]] Certificate check_geodesics(const GeodesicsDocument& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
