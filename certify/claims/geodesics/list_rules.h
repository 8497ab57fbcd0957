#pragma once

#include <span>
#include <string>

#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/document.h"
#include "certify/claims/geodesics/least_sequence.h"
#include "certify/verdict/report.h"

/// What is known of each geodesic of a list, and what follows for the rules `distinct` and `simple` (docs/proof.md,
/// section 11).
namespace epsnet::certify {

/// "geodesic i".
[[nodiscard]] std::string geodesic_name(std::size_t i);

/// Rule `distinct`: whether one of the geodesics is another one or a power of it.
[[nodiscard]] RuleReport distinct_report(const SequenceTable& table);

/// Rule `simple`: each is simple or not, as the document says, and crosses no other if they are said to be `disjoint`.
[[nodiscard]] RuleReport simple_report(std::span<const GeodesicsDocument::ClosedGeodesic> geodesics,
                                       std::span<const Meetings> meetings, bool disjoint, slong precision);

}  // namespace epsnet::certify
