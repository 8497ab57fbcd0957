#include "certify/claims/net/check.h"

#include "certify/claims/least_bytes.h"
#include "certify/claims/net/verify.h"
#include "certify/net/structure.h"

namespace epsnet::certify {
namespace {

NetClaim claim_of(const NetDocument& document) {
  const char* const text =
      document.collars ? "a pseudo epsilon-net: an epsilon-net of the epsilon-thick part" : "an epsilon-net";
  return {document, text, rules_of(document), {}};
}

}  // namespace

RuleNames rules_of(const NetDocument& document) {
  if (!document.collars) return {"surface", "map", "gluing", "orientation", "delaunay", "covering", "packing"};
  return {"surface", "map", "gluing", "collars", "orientation", "delaunay", "covering", "packing", "thick"};
}

Certificate check(const NetDocument& document, const CheckOptions& options) {
  return verify(document, options, claim_of);
}

}  // namespace epsnet::certify
