#pragma once

#include "certify/base/fault.h"
#include "certify/net/document.h"
#include "certify/verdict/report.h"

/// The checker: decides whether a document proves what it claims (docs/proof.md).
namespace epsnet::certify {

/// Returns the names of a net's rules in the order of evaluation: seven, or nine for a pseudo net.
[[nodiscard]] RuleNames rules_of(const NetDocument& document);

/// Returns the rules of a net, then a claim's own.
[[nodiscard]] RuleNames with_net_rules(const NetDocument& net, const RuleNames& own);

/// Checks all rules. Returns a certificate for a document of any content. Throws only if the machine fails
/// (std::bad_alloc, std::system_error) or this program has a bug (Fault); then there is no verdict.
///
/// The verdict is malformed if the structure is broken; else refuted if any evaluated rule is refuted, and the first
/// such rule is named; else undecided if any rule is undecided or was not evaluated; else verified. Rules that cannot
/// change the verdict are left undecided. O(n log n) time, n the size of the document, at fixed precision.
///
/// Once the total work exceeds `max_work`, the remaining rules are undecided. A rule that was refuted before stays
/// refuted.
[[nodiscard]] Certificate check(const NetDocument& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
