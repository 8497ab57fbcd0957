#pragma once

#include <array>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/claims/pants/document.h"

namespace epsnet::certify {

template <>
struct Fields<PantsDocument::Paths> {
  static constexpr const char* kExpected = "two words";
  static auto elements(auto& paths) { return std::tie(paths[0], paths[1]); }
};

template <>
struct Fields<std::array<PantsDocument::End, 2>> {
  static constexpr const char* kExpected = "[[p, k], [q, l]], two cuffs of pairs of pants";
  static auto elements(auto& ends) { return std::tie(ends[0], ends[1]); }
};

template <>
struct Fields<PantsDocument::Cuff> {
  static auto members(auto& cuff) {
    return std::tuple(member("ends", cuff.ends), member("across", cuff.across), member("length", cuff.length),
                      member("twist", cuff.twist), member("exp_half_length", cuff.exp_half_length));
  }
};

template <>
struct Fields<PantsDocument> {
  static constexpr ClaimKind kKind{"pants", "epsnet-pants", "a pants decomposition",
                                   "A pants file claims how closed geodesics cut a surface into pairs of pants, with\n"
                                   "lengths and twists.",
                                   19};
  static constexpr const char* kName = "pants file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("net", document.net), member("pants", document.pants), member("cuffs", document.cuffs)));
  }
};

}  // namespace epsnet::certify
