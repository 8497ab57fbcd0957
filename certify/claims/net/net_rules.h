#pragma once

#include "certify/base/interval.h"
#include "certify/net/crossings.h"
#include "certify/net/document.h"
#include "certify/verdict/verification.h"

namespace epsnet::certify {

/// The area 4π(g − 1) of a closed hyperbolic surface of genus g ≥ 2, enclosed.
[[nodiscard]] Interval area_of(std::uint64_t genus);

/// Asks and reports the rules of a net (rules_of in check.h) one after the other, as far as each can be asked, and
/// counts what there is. Needs a document without structure problem.
///
/// The crossings of the surface, if rule `surface` is verified. BudgetSpent leaves the next rule to be given up.
[[nodiscard]] Crossings ask_net_rules(const NetDocument& document, Verification& run);

}  // namespace epsnet::certify
