#pragma once

#include <array>
#include <cstdint>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/base/text.h"
#include "certify/claims/pants/document.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

template <>
struct Fields<PantsDocument::Paths> {
  static constexpr const char* kExpected = "two words";
  static auto elements(auto& paths) { return std::tie(paths[0], paths[1]); }
};

template <>
struct Fields<std::array<PantsDocument::End, 2>> {
  static constexpr const char* kExpected = "[[p, k], [q, l]], two cuffs of pairs of pants";
  static auto elements(auto& ends) { return std::tie(ends[0], ends[1]); }
};

template <>
struct Fields<PantsDocument::Cuff> {
  static auto members(auto& cuff) {
    return std::tuple(member("ends", cuff.ends), member("across", cuff.across), member("length", cuff.length),
                      member("twist", cuff.twist), member("exp_half_length", cuff.exp_half_length));
  }
};

template <>
struct Fields<PantsDocument> {
  static constexpr ClaimKind kKind{"pants", "epsnet-pants", "a pants decomposition",
                                   "A pants file claims how closed geodesics cut a surface into pairs of pants, with\n"
                                   "lengths and twists.",
                                   19};
  static constexpr const char* kName = "pants file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("net", document.net), member("pants", document.pants), member("cuffs", document.cuffs)));
  }
};

// The claim of a pants file: how closed geodesics cut a surface into pairs of pants (docs/proof.md, section 19).

struct Claim;

/// What a pants document must satisfy before any rule makes sense: a net without collars; closed paths for each pair of
/// pants; cuffs in which each end occurs once, with paths across them, intervals in order, and e^{l/2} > 1 or 0.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] Problem structure_problem(const PantsDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const PantsDocument& document);

/// The names of its own rules, in order:
///
/// * `pants`: the paths are those of 2g − 2 pairs of pants on their left;
/// * `glued`: each cuff is the same closed geodesic from both sides, by the path across it;
/// * `lengths`: each length is in its interval, and is 2 ln R if R = exp_half_length is not 0;
/// * `twists`: each twist is in its interval, modulo the length.
///
/// Time: that of the products of all letters, exactly and in balls.
[[nodiscard]] RuleNames own_rules(const PantsDocument& document);

[[nodiscard]] Claim claim_of(const PantsDocument& document);

}  // namespace epsnet::certify
