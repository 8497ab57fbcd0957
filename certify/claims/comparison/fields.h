#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/base/text.h"
#include "certify/claims/comparison/document.h"
#include "certify/claims/geodesics/fields.h"
#include "certify/claims/net/fields.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

template <>
struct Fields<ComparisonDocument::Relation> {
  static constexpr std::array<std::string_view, 2> kNames{"isometric", "different"};
};

template <>
struct Fields<ComparisonDocument> {
  static constexpr ClaimKind kKind{"comparison", "epsnet-comparison", "a comparison of two surfaces",
                                   "A comparison file claims that two surfaces are isometric, by an isometry, or\n"
                                   "that they are not.",
                                   20};
  static constexpr const char* kName = "comparison file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    const bool isometric = document.relation == ComparisonDocument::Relation::isometric;
    const bool different = !isometric;
    const char* for_claim = " for this claim";
    auto& isometry = document.isometry;
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("claim", document.relation), member("net", document.net),
                   member("up_to", document.up_to).only_if(different, for_claim).expecting("a decimal in a string"),
                   member("geodesics", document.geodesics).only_if(different, for_claim),
                   member("clusters", document.clusters).only_if(different, for_claim),
                   member("other_net", document.other.net).only_if(isometric, for_claim),
                   member("other_spectrum", document.other).only_if(different, for_claim),
                   member("preserves_orientation", isometry.preserves_orientation).only_if(isometric, for_claim),
                   member("paths", isometry.paths).only_if(isometric, for_claim),
                   member("pair", isometry.pair).only_if(isometric, for_claim),
                   member("images", isometry.images).only_if(isometric, for_claim)));
  }
};

// The claim of a comparison file: whether two surfaces are isometric (docs/proof.md, section 20).

struct Claim;

/// What a comparison document must satisfy before any rule makes sense: what two nets must; if they are isometric, a
/// path to each tile, two elements, and images of these and of the generators, words that lead where they should; if
/// they are different, what two spectra must.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] Problem structure_problem(const ComparisonDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const ComparisonDocument& document);

/// The names of its own rules, in order, after those of the first net: of surfaces that are isometric
///
/// * `other`: the other net is verified;
/// * `isometric`: an isometry of the plane takes the elements to their images, and with them the group of the first
///   surface to that of the other one; it preserves the orientation or not, as claimed;
///
/// and of surfaces that are different those of the first spectrum (geodesics/fields.h), and then
///
/// * `other`: the other spectrum is verified;
/// * `different`: the genera differ; or, for some length, the number of primitive closed geodesics that are not longer;
/// or
///   no isometry takes the points where they cross on the one surface to those on the other one.
///
/// Time: that of the rules of both nets, or both spectra, and the letters of all images, exactly.
[[nodiscard]] RuleNames own_rules(const ComparisonDocument& document);

[[nodiscard]] Claim claim_of(const ComparisonDocument& document);

}  // namespace epsnet::certify
