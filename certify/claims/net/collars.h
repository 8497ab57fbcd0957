#pragma once

#include <optional>

#include "certify/net/labels.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

struct CollarsOutcome {
  RuleReport report;
  std::uint64_t max_precision = 0;        ///< Bits.
  std::optional<Interval> shortest_core;  ///< Of those collars that hold; absent without any.
};

/// Rule `collars` of a pseudo net: ε ≤ ln √2; collars share no triangle and no vertex; each is an annulus of two
/// triangles around a closed geodesic that is no longer than ε and has the length that the file says; its two vertices
/// lie on the two sides of that geodesic, in the ε-thick part and near enough to cover what the annulus has of it
/// (docs/proof.md, section 10, clauses (a) to (g)).
///
/// Combinatorics exactly, lengths by balls of more and more bits. Needs rules `surface`, `map` and `gluing`. O(n).
[[nodiscard]] CollarsOutcome check_collars(const NetDocument& document, const LabelEvaluator& evaluator,
                                           const LabelParts& parts, long max_precision);

}  // namespace epsnet::certify
