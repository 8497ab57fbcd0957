#pragma once

#include "certify/document/document.h"
#include "certify/document/fault.h"
#include "certify/document/report.h"

/// The checker: decides whether a document proves what it claims (docs/proof.md).
namespace epsnet::certify {

/// The rules of a net by name, in the order in which they are asked: seven, nine for a pseudo net.
[[nodiscard]] RuleNames rules_of(const NetDocument& document);

/// Checks everything. A document of whatever content gives a certificate; exceptions mean that the machine failed
/// (std::bad_alloc, std::system_error) or that this program is wrong (Fault): then there is no verdict.
///
/// The verdict: malformed if the structure is broken; else refuted if any evaluated rule is, and the first such rule is
/// named; else undecided if any is, or one was not evaluated; else verified. Rules that cannot change this are left
/// undecided. O(n log n) time, n the size of the document, at fixed precision.
///
/// What needs more work than `max_work` in all is undecided; a rule that was refuted before stays refuted.
[[nodiscard]] Certificate check(const NetDocument& document, const CheckOptions& options = {});

}  // namespace epsnet::certify
