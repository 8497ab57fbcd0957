#pragma once

#include <tuple>

#include "certify/base/fields.h"
#include "certify/claims/geodesics/fields.h"
#include "certify/claims/isometries/document.h"

namespace epsnet::certify {

template <>
struct Fields<IsometriesDocument::Isometry> {
  static auto members(auto& isometry) {
    return std::tuple(member("preserves_orientation", isometry.preserves_orientation),
                      member("images", isometry.images));
  }
};

template <>
struct Fields<IsometriesDocument> {
  static constexpr ClaimKind kKind{"isometries", "epsnet-isometries", "isometries",
                                   "An isometries file claims how many isometries a surface has, and lists some\n"
                                   "that generate all.",
                                   18};
  static constexpr const char* kName = "isometries file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(format_and_version(kKind.format), spectrum_members(document),
                          std::tuple(member("order", document.order), member("isometries", document.isometries),
                                     member("paths", document.paths), member("pair", document.pair),
                                     member("cocycle", document.cocycle)));
  }
};

}  // namespace epsnet::certify
