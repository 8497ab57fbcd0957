#pragma once

#include <cstdint>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/base/text.h"
#include "certify/claims/geodesics/fields.h"
#include "certify/claims/isometries/document.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

template <>
struct Fields<IsometryRows::Isometry> {
  static auto members(auto& isometry) {
    return std::tuple(member("preserves_orientation", isometry.preserves_orientation),
                      member("images", isometry.images));
  }
};

template <>
struct Fields<IsometriesDocument> {
  static constexpr ClaimKind kKind{"isometries", "epsnet-isometries", "isometries",
                                   "An isometries file claims how many isometries a surface has, and lists some\n"
                                   "that generate all.",
                                   18};
  static constexpr const char* kName = "isometries file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(format_and_version(kKind.format), spectrum_members(document),
                          std::tuple(member("order", document.order), member("isometries", document.isometries),
                                     member("paths", document.paths), member("pair", document.pair),
                                     member("cocycle", document.cocycle)));
  }
};

// The claim of an isometries file: which isometries a surface has (docs/proof.md, section 18).

struct Claim;

/// What an isometries document must satisfy before any rule makes sense: what a spectrum must (geodesics/check.h); an
/// order of at least 1; a path to each tile, two elements, and for each isometry images of these and of the generators,
/// words that lead where they should; a cocycle.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] Problem structure_problem(const IsometriesDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const IsometriesDocument& document);

/// The names of its own rules, in order: those of the spectrum (geodesics/check.h), and then
///
/// * `isometries`: each of those listed is one, and preserves the orientation or not, as claimed;
/// * `least`: they generate at least `order` isometries;
/// * `most`: there are at most `order`.
///
/// Time: that of the spectrum's rules; the letters of all images, exactly, and `order` times; and for each point where
/// geodesics cross some comparisons with all others.
[[nodiscard]] RuleNames own_rules(const IsometriesDocument& document);

[[nodiscard]] Claim claim_of(const IsometriesDocument& document);

}  // namespace epsnet::certify
