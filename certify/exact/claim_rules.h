#pragma once

#include <vector>

#include "certify/exact/document.h"
#include "certify/exact/net_rules.h"

/// The rules of claims about a net, to be asked after those of the net, which are verified then. Each
/// function throws Malformed if the structure of the document is broken; the net's rules and the document must live as
/// long as what it returns.
namespace epsnet::exact {

/// Section 11.1 of docs/proof.md: a systole or a spectrum.
template <class R>
[[nodiscard]] std::vector<Rule> geodesic_rules(const GeodesicsDocument& document, NetRules<R>& net);
/// Section 14.
template <class R>
[[nodiscard]] std::vector<Rule> distance_rules(const DistanceDocument& document, NetRules<R>& net);
/// Section 15.
template <class R>
[[nodiscard]] std::vector<Rule> bound_rules(const BoundDocument& document, NetRules<R>& net);

}  // namespace epsnet::exact
