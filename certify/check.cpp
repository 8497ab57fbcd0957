#include "certify/check.h"

#include "certify/base/binary64.h"
#include "certify/claims.h"
#include "certify/claims/net/claim.h"

namespace epsnet::certify {

RuleNames rules_of(const AnyClaim& document) {
  return with_net_rules(document.net(), document.visit([](const auto& one) { return own_rules(one); }));
}

Certificate check(const AnyClaim& document, const CheckOptions& options) {
  const RoundingToNearest rounding;
  if (options.progress) options.progress("structure", 0);
  return document.visit([&](const auto& one) {
    if (const auto problem = structure_problem(one)) return malformed(*problem);
    return verify(claim_of(one), least_bytes(one), options);
  });
}

}  // namespace epsnet::certify
