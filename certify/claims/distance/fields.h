#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/base/text.h"
#include "certify/claims/distance/document.h"
#include "certify/verdict/report.h"

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

// The claim of a distance file: whether the distance of two points lies in an interval, and the list contains all
// geodesics between them of length up to the upper end (docs/proof.md, section 14).

struct Claim;

/// What a distance document must satisfy before any rule makes sense: its net has no structure problem, one vertex and
/// no collars; the point is in the disk of a tile; words lead from the tile of the vertex's chart to that tile, and
/// there is at least one; the enclosure is finite, not negative and in order.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] Problem structure_problem(const DistanceDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const DistanceDocument& document);

/// The names of its own rules, in order:
///
/// * `paths`: the lengths lie in the enclosure, and no two paths are the same;
/// * `equal`: if they are claimed to have equal lengths, the lengths are exactly equal;
/// * `nearest`: every geodesic between the two points is listed if it is not longer than the enclosure's upper end.
///
/// There is no search: O(paths · triangles) time, however long the paths are.
[[nodiscard]] RuleNames own_rules(const DistanceDocument& document);

[[nodiscard]] Claim claim_of(const DistanceDocument& document);

}  // namespace epsnet::certify
