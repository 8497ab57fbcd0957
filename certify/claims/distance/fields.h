#pragma once

#include <tuple>

#include "certify/base/fields.h"
#include "certify/claims/distance/document.h"

namespace epsnet::certify {

template <>
struct Fields<DistanceDocument::Point> {
  static constexpr const char* kExpected = "[t, x, y], a tile and two rationals";
  static auto elements(auto& point) { return std::tie(point.tile, point.z.x, point.z.y); }
};

template <>
struct Fields<DistanceDocument> {
  static constexpr ClaimKind kKind{"distance", "epsnet-distance", "a distance",
                                   "A distance file claims to list the shortest paths between two points.", 14};
  static constexpr const char* kName = "distance file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("net", document.net), member("point", document.point), member("distance", document.distance),
                   member("paths", document.paths), member("equal", document.equal)));
  }
};

}  // namespace epsnet::certify
