#pragma once

#include <cstdint>
#include <string>

#include "certify/base/text.h"
#include "certify/claims/geodesics/document.h"
#include "certify/verdict/report.h"

/// The claim of a geodesics file: whether a list of closed geodesics is what the file says (docs/proof.md, section 11).
namespace epsnet::certify {

struct Claim;

/// What a geodesics document must satisfy before any rule makes sense: its net has no structure problem; indices point
/// somewhere; words lead from a tile to itself; enclosures are positive, finite, in order; clusters are the runs that
/// the enclosures make; every side of every geodesic bounds one piece; there is exactly what the claim needs.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] Problem structure_problem(const GeodesicsDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const GeodesicsDocument& document);

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
