#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/base/text.h"
#include "certify/claims/bound/document.h"
#include "certify/claims/isometries/fields.h"
#include "certify/verdict/report.h"

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
struct Fields<BoundSymmetry> {
  static auto members(auto& symmetry) {
    return std::tuple(member("centre", symmetry.centre), member("isometries", symmetry.isometries),
                      member("paths", symmetry.paths), member("pair", symmetry.pair));
  }
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
                   member("symmetry", document.symmetry).optional(), member("cells", List{document.cells})));
  }
};

// The claim of a bound file: whether the diameter, the radius, or the radius of the largest embedded disk lies between
// the bounds (docs/proof.md, section 15).

struct Claim;

/// What is wrong with the structure of a bound file, with its place; nullopt if it can be evaluated: the net has one
/// vertex and no collars, the value is 0 < lo ≤ hi, triangulations come after those they are made from, a symmetry has
/// a centre in the disk, isometries, at least three, whose words lead where they should, and no base beside it, and the
/// cells of every triangle are one whole subdivision. O(size).
[[nodiscard]] Problem structure_problem(const BoundDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const BoundDocument& document);

/// The names of its own rules, in order:
///
/// * `lower`: at the net's vertex the function is at least the lower bound;
/// * `upper`, for a radius instead of `lower`: at the net's vertex the eccentricity is at most the upper bound;
/// * `triangulations`: every flip is of an edge between two different triangles;
/// * `isometries`, with a symmetry: its rows are isometries;
/// * `domain`, with a symmetry: there are points as far from the centre as from its images under isometries i and i +
///   1, for each i, and they lie counterclockwise around it;
/// * `cells`: at the three corners of each cell the convex function that bounds it is at most the upper bound;
/// * `cells`, for a radius: at one point of each cell the eccentricity exceeds the lower bound by so much that it is at
///   least the lower bound in the whole cell.
///
/// O(cells · triangles) time.
[[nodiscard]] RuleNames own_rules(const BoundDocument& document);

[[nodiscard]] Claim claim_of(const BoundDocument& document);

}  // namespace epsnet::certify
