#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "certify/base/fields.h"
#include "certify/base/text.h"
#include "certify/claims/geodesics/document.h"
#include "certify/net/labels.h"
#include "certify/verdict/report.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {

template <>
struct Fields<GeodesicsDocument::Claim> {
  static constexpr const auto& kNames = GeodesicsDocument::kClaimNames;
};

template <>
struct Fields<GeodesicsDocument::ClosedGeodesic> {
  static auto members(auto& geodesic) {
    return std::tuple(member("vertex", geodesic.vertex), member("word", geodesic.word),
                      member("length", geodesic.length), member("simple", geodesic.simple));
  }
};

template <>
struct Fields<GeodesicsDocument::Cluster> {
  static auto members(auto& cluster) {
    return std::tuple(member("first", cluster.first), member("count", cluster.count), member("equal", cluster.equal));
  }
};

template <>
struct Fields<std::pair<std::uint32_t, std::uint32_t>> {
  static constexpr const char* kExpected = "[geodesic, side], two indices";
  static auto elements(auto& boundary) { return std::tie(boundary.first, boundary.second); }
};

template <>
struct Fields<GeodesicsDocument::Piece> {
  static auto members(auto& piece) {
    return std::tuple(member("genus", piece.genus), member("boundaries", piece.boundaries));
  }
};

/// The members of a spectrum in the document of a claim that rests on one.
auto spectrum_members(auto& document) {
  return std::tuple(member("net", document.net), member("up_to", document.up_to).expecting("a decimal in a string"),
                    member("geodesics", document.geodesics), member("clusters", document.clusters));
}

template <>
struct Fields<GeodesicsDocument> {
  static constexpr ClaimKind kKind{"geodesics", "epsnet-geodesics", "closed geodesics",
                                   "A geodesics file claims to list the systole, the spectrum up to a length, or the\n"
                                   "thick-thin decomposition, or that the systole has a local maximum there.",
                                   11};
  static constexpr const char* kName = "geodesics file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    using enum GeodesicsDocument::Claim;
    const auto claim = document.claim;
    const char* for_claim = " for this claim";
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(
            member("claim", document.claim), member("net", document.net),
            member("up_to", document.up_to).only_if(document.has_up_to(), for_claim).expecting("a decimal in a string"),
            member("geodesics", document.geodesics),
            member("clusters", document.clusters).only_if(claim != systole, for_claim),
            member("pieces", document.pieces).only_if(claim == thick_thin, for_claim),
            member("basis", List{document.basis}).only_if(claim == local_maximum, for_claim),
            member("weights", List{document.weights}).only_if(claim == local_maximum, for_claim)));
  }
};

// The claim of a geodesics file: whether a list of closed geodesics is what the file says (docs/proof.md, section 11).

struct Claim;

/// What a geodesics document must satisfy before any rule makes sense: its net has no structure problem; indices point
/// somewhere; words lead from a tile to itself; enclosures are positive, finite, in order; clusters are the runs that
/// the enclosures make; every side of every geodesic bounds one piece; the basis has as many geodesics as there are
/// coordinates of surfaces, and all other shortest ones have a weight; there is exactly what the claim needs.
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
/// * `pieces`: the surface cut along them has the claimed pieces;
/// * `maximal`: the systole is greater than those of all other surfaces nearby.
///
/// A systole needs only `geodesics`, `simple` and `complete`; only a thick-thin decomposition needs `pieces`, and only
/// a local maximum `maximal`. Time is proportional to the number of lifted triangles visited, about e^L for geodesics
/// of length up to L.
[[nodiscard]] RuleNames own_rules(const GeodesicsDocument& document);

[[nodiscard]] Claim claim_of(const GeodesicsDocument& document);

// The rules of a list of geodesics, for this claim and for those that rest on such a list.

/// The net with the words of the geodesics as further labels, in order, which no triangle uses.
[[nodiscard]] NetDocument with_geodesics_as_labels(const GeodesicsDocument& document);

/// Asks the document's own rules and reports each. Returns what labels of its net are made of.
[[nodiscard]] LabelParts ask_geodesics_rules(const GeodesicsDocument& document, Verification& run, Crossings crossings);

}  // namespace epsnet::certify
