#pragma once

#include "certify/exact/claim_documents.h"

namespace epsnet::exact {

/// Section 17.1 of docs/proof.md: the rule `enclosures`. Throws Refutation. Intervals of eigenfunctions are disjoint
/// and in order.
void check_enclosures(const EigenvaluesDocument& document);

}  // namespace epsnet::exact
