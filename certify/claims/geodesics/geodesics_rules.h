#pragma once

#include "certify/claims/geodesics/document.h"
#include "certify/net/label_evaluator.h"
#include "certify/verdict/verification.h"

/// The rules of a list of geodesics, for this claim and for those that rest on such a list.
namespace epsnet::certify {

/// The net with the words of the geodesics as further labels, in order, which no triangle uses.
[[nodiscard]] NetDocument with_geodesics_as_labels(const GeodesicsDocument& document);

/// Asks the document's own rules and reports each. Returns what labels of its net are made of.
[[nodiscard]] LabelParts ask_geodesics_rules(const GeodesicsDocument& document, Verification& run, Crossings crossings);

}  // namespace epsnet::certify
