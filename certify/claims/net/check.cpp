#include "certify/claims/net/check.h"

#include "certify/claims/net/claim.h"
#include "certify/net/structure.h"

namespace epsnet::certify {
namespace {

Claim claim_of(const NetDocument& document) {
  const char* const text =
      document.collars ? "a pseudo epsilon-net: an epsilon-net of the epsilon-thick part" : "an epsilon-net";
  return {document, text, rules_of(document), {}};
}

}  // namespace

RuleNames rules_of(const NetDocument& document) {
  if (!document.collars) return {"surface", "map", "gluing", "orientation", "delaunay", "covering", "packing"};
  return {"surface", "map", "gluing", "collars", "orientation", "delaunay", "covering", "packing", "thick"};
}

RuleNames with_net_rules(const NetDocument& net, const RuleNames& own) {
  RuleNames rules = rules_of(net);
  rules.insert(rules.end(), own.begin(), own.end());
  return rules;
}

Certificate check(const NetDocument& document, const CheckOptions& options) {
  return verify(document, options, claim_of);
}

}  // namespace epsnet::certify
