#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>

#include "certify/base/fields.h"
#include "certify/claims/geodesics/document.h"

namespace epsnet::certify {

template <>
struct Fields<GeodesicsDocument::Claim> {
  static constexpr std::array<std::string_view, 3> kNames{"systole", "spectrum", "thick-thin"};
};

template <>
struct Fields<GeodesicsDocument::ClosedGeodesic> {
  static auto members(auto& geodesic) {
    return std::tuple(member("vertex", geodesic.vertex), member("word", geodesic.word),
                      member("length", geodesic.length), member("simple", geodesic.simple));
  }
};

template <>
struct Fields<GeodesicsDocument::Cluster> {
  static auto members(auto& cluster) {
    return std::tuple(member("first", cluster.first), member("count", cluster.count), member("equal", cluster.equal));
  }
};

template <>
struct Fields<std::pair<std::uint32_t, std::uint32_t>> {
  static constexpr const char* kExpected = "[geodesic, side], two indices";
  static auto elements(auto& boundary) { return std::tie(boundary.first, boundary.second); }
};

template <>
struct Fields<GeodesicsDocument::Piece> {
  static auto members(auto& piece) {
    return std::tuple(member("genus", piece.genus), member("boundaries", piece.boundaries));
  }
};

/// The members of a spectrum in the document of a claim that rests on one.
auto spectrum_members(auto& document) {
  return std::tuple(member("net", document.net), member("up_to", document.up_to).expecting("a decimal in a string"),
                    member("geodesics", document.geodesics), member("clusters", document.clusters));
}

template <>
struct Fields<GeodesicsDocument> {
  static constexpr ClaimKind kKind{"geodesics", "epsnet-geodesics", "closed geodesics",
                                   "A geodesics file claims to list the systole, the spectrum up to a length, or the\n"
                                   "thick-thin decomposition.",
                                   11};
  static constexpr const char* kName = "geodesics file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    using enum GeodesicsDocument::Claim;
    const auto claim = document.claim;
    const char* for_claim = " for this claim";
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(
            member("claim", document.claim), member("net", document.net),
            member("up_to", document.up_to).only_if(claim == spectrum, for_claim).expecting("a decimal in a string"),
            member("geodesics", document.geodesics),
            member("clusters", document.clusters).only_if(claim != systole, for_claim),
            member("pieces", document.pieces).only_if(claim == thick_thin, for_claim)));
  }
};

}  // namespace epsnet::certify
