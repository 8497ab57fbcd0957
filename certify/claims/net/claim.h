#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "certify/net/document.h"
#include "certify/net/labels.h"
#include "certify/net/structure.h"
#include "certify/verdict/report.h"
#include "certify/verdict/verification.h"

/// What every claim is made of, and the one way in which it is checked: the rules of the net, then those of its own.
///
/// The folder of a claim has four functions of its document: `structure_problem`, `least_bytes`, `own_rules` and
/// `claim_of`.
namespace epsnet::certify {

/// A claim about a net, or about the surface of one.
struct Claim {
  const NetDocument& net;
  std::string text;  ///< As in Certificate.
  RuleNames rules;   ///< Its own, after those of the net.
  /// Asks its own rules and reports each, in order; called if all rules of the net are verified, with the crossings of
  /// its surface. Empty if there are none. BudgetSpent leaves the rule that it was at undecided.
  std::function<void(Verification&, Crossings)> ask;
};

/// The rules of a net, seven, or nine for a pseudo net; then a claim's own.
[[nodiscard]] RuleNames with_net_rules(const NetDocument& net, const RuleNames& own);

/// The verdict about the claim of a document without structure problem; `least_bytes` is that of the document.
[[nodiscard]] Certificate verify(const Claim& claim, std::uint64_t least_bytes, const CheckOptions& options);

/// The area 4π(g − 1) of a closed hyperbolic surface of genus g ≥ 2, enclosed.
[[nodiscard]] Interval area_of(std::uint64_t genus);

// The claim of a net file, which has no rules but those of its net.

[[nodiscard]] inline RuleNames own_rules(const NetDocument& /*document*/) { return {}; }
[[nodiscard]] Claim claim_of(const NetDocument& document);

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
