#include "certify/claims/geodesics/list_rules.h"

#include <algorithm>

namespace epsnet::certify {

std::string geodesic_name(std::size_t i) { return "geodesic " + std::to_string(i); }

RuleReport distinct_report(const SequenceTable& table) {
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    const auto match = table.find_other(i);
    if (!match) continue;
    const std::string power = match->power == 1 ? "" : ", run through " + std::to_string(match->power) + " times";
    return {"distinct", Verdict::refuted,
            geodesic_name(i) + " is " + geodesic_name(match->geodesic) + power + ", up to orientation"};
  }
  return {"distinct", Verdict::verified, "no two are the same and none is a power of another"};
}

RuleReport simple_report(std::span<const GeodesicsDocument::ClosedGeodesic> geodesics,
                         std::span<const Meetings> meetings, bool disjoint, slong precision) {
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    const bool simple = geodesics[i].simple;
    if (meetings[i].itself == (simple ? Tri::yes : Tri::no)) {
      return {"simple", Verdict::refuted, geodesic_name(i) + (simple ? " is not simple" : " is simple")};
    }
    if (meetings[i].another == Tri::yes) return {"simple", Verdict::refuted, geodesic_name(i) + " meets another one"};
  }
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    if (meetings[i].itself != Tri::unknown && meetings[i].another != Tri::unknown) continue;
    return {"simple", Verdict::undecided,
            geodesic_name(i) + ": not decided what it crosses, with " + std::to_string(precision) + " bits"};
  }
  const auto simple =
      std::count_if(geodesics.begin(), geodesics.end(), [](const auto& geodesic) { return geodesic.simple; });
  return {"simple", Verdict::verified,
          std::to_string(simple) + " of " + std::to_string(meetings.size()) + " are simple" +
              (disjoint ? ", and they are pairwise disjoint" : "")};
}

}  // namespace epsnet::certify
