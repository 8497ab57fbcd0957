#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/claims/bound/document.h"

namespace epsnet::certify {

template <>
struct Fields<BoundDocument::Claim> {
  static constexpr std::array<std::string_view, 3> kNames{"diameter", "radius", "embedded-disk"};
};

template <>
struct Fields<BoundDocument::Triangulation> {
  static constexpr const char* kExpected = "[k, d, …], a triangulation and darts";
  static auto elements(auto& t) { return std::tuple_cat(std::tie(t.parent), std::tuple(List{t.flips})); }
};

template <>
struct Fields<BoundDocument> {
  static constexpr ClaimKind kKind{"bound", "epsnet-cover", "bounds",
                                   "A bound file claims two bounds for the diameter, the radius, or the radius of\n"
                                   "the largest embedded disk.",
                                   15};
  static constexpr const char* kName = "bound file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("claim", document.claim), member("net", document.net), member("value", document.value),
                   member("triangulations", document.triangulations), member("base", List{document.base}).optional(),
                   member("cells", List{document.cells})));
  }
};

}  // namespace epsnet::certify
