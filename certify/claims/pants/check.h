#pragma once

#include <cstdint>

#include "certify/base/text.h"
#include "certify/claims/pants/document.h"
#include "certify/verdict/report.h"

/// The claim of a pants file: how closed geodesics cut a surface into pairs of pants (docs/proof.md, section 19).
namespace epsnet::certify {

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
