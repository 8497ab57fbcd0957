#include "certify/check.h"

#include <variant>

#include "certify/base/binary64.h"
#include "certify/claims/bound/check.h"
#include "certify/claims/distance/check.h"
#include "certify/claims/geodesics/check.h"
#include "certify/claims/net/claim.h"

namespace epsnet::certify {
namespace {

const NetDocument& net_of_one(const NetDocument& document) { return document; }
template <class Document>
const NetDocument& net_of_one(const Document& document) {
  return document.net;
}

}  // namespace

template <class Document>
RuleNames rules_of(const Document& document) {
  return with_net_rules(net_of_one(document), own_rules(document));
}

template <class Document>
Certificate check(const Document& document, const CheckOptions& options) {
  const RoundingToNearest rounding;
  if (options.progress) options.progress("structure", 0);
  if (const auto problem = structure_problem(document)) return malformed(*problem);
  return verify(claim_of(document), least_bytes(document), options);
}

template RuleNames rules_of(const NetDocument& document);
template RuleNames rules_of(const GeodesicsDocument& document);
template RuleNames rules_of(const DistanceDocument& document);
template RuleNames rules_of(const BoundDocument& document);

template Certificate check(const NetDocument& document, const CheckOptions& options);
template Certificate check(const GeodesicsDocument& document, const CheckOptions& options);
template Certificate check(const DistanceDocument& document, const CheckOptions& options);
template Certificate check(const BoundDocument& document, const CheckOptions& options);

Certificate check_claim(const ClaimDocument& document, const CheckOptions& options) {
  return std::visit([&](const auto& one) { return check(one, options); }, document);
}

const NetDocument& net_of(const ClaimDocument& document) {
  return std::visit([](const auto& one) -> const NetDocument& { return net_of_one(one); }, document);
}

}  // namespace epsnet::certify
