#pragma once

#include <cstdint>
#include <vector>

#include "certify/claims/isometries/document.h"
#include "certify/net/surface_sides.h"
#include "certify/numbers/budget.h"

/// How many isometries some generate, by what they do with a function of words (docs/proof.md, Lemma 40).
namespace epsnet::certify {

/// By side: the values of a function of words at single letters, given for those that are less than their partners.
[[nodiscard]] std::vector<std::uint32_t> cocycle_by_side(const SurfaceSides& sides,
                                                         const std::vector<std::uint32_t>& values);

/// A number that the order of the group that the document's isometries generate is not less than; no more than one
/// above the document's `order` are counted. O(order · letters of all images); BudgetSpent, if that is too much work.
///
/// Requires: a document without structure problem, whose isometries are isometries.
[[nodiscard]] std::uint64_t orbit_size(const SurfaceSides& sides, const IsometriesDocument& document,
                                       const Budget& budget);

}  // namespace epsnet::certify
