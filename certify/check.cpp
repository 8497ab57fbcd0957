#include "certify/check.h"

#include <variant>

#include "certify/claims/bound/check.h"
#include "certify/claims/distance/check.h"
#include "certify/claims/geodesics/check.h"
#include "certify/claims/net/check.h"

namespace epsnet::certify {

Certificate check_claim(const ClaimDocument& document, const CheckOptions& options) {
  if (const auto* geodesics = std::get_if<GeodesicsDocument>(&document)) return check_geodesics(*geodesics, options);
  if (const auto* distance = std::get_if<DistanceDocument>(&document)) return check_distance(*distance, options);
  if (const auto* bound = std::get_if<BoundDocument>(&document)) return check_bound(*bound, options);
  return check(std::get<NetDocument>(document), options);
}

const NetDocument& net_of(const ClaimDocument& document) {
  if (const auto* geodesics = std::get_if<GeodesicsDocument>(&document)) return geodesics->net;
  if (const auto* distance = std::get_if<DistanceDocument>(&document)) return distance->net;
  if (const auto* bound = std::get_if<BoundDocument>(&document)) return bound->net;
  return std::get<NetDocument>(document);
}

}  // namespace epsnet::certify
