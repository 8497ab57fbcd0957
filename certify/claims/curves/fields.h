#pragma once

#include <cstdint>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/base/text.h"
#include "certify/claims/curves/document.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

template <>
struct Fields<CurvesDocument::Curve> {
  static auto members(auto& curve) {
    return std::tuple(member("vertex", curve.vertex), member("word", curve.word), member("length", curve.length),
                      member("power", curve.power), member("self_intersections", curve.self_intersections),
                      member("homology", curve.homology));
  }
};

template <>
struct Fields<CurvesDocument::Pair> {
  static auto members(auto& pair) {
    return std::tuple(member("first", pair.first), member("second", pair.second),
                      member("intersections", pair.intersections), member("algebraic", pair.algebraic));
  }
};

template <>
struct Fields<CurvesDocument> {
  static constexpr ClaimKind kKind{"curves", "epsnet-curves", "closed curves",
                                   "A curves file claims how often closed curves cross themselves and each other,\n"
                                   "their classes in homology, and which of them fill the surface.",
                                   21};
  static constexpr const char* kName = "curves file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("net", document.net), member("curves", document.curves), member("pairs", document.pairs),
                   member("basis", List{document.basis}), member("filling", List{document.filling})));
  }
};

// The claim of a curves file: how closed curves of a surface cross, up to free homotopy (docs/proof.md, section 21).

struct Claim;

/// What a curves document must satisfy before any rule makes sense: a net without collars; words that lead from a tile
/// to itself, enclosures of lengths, a power of at least 1, and as many coefficients as the basis has curves; a row for
/// each pair, in order; a basis in which no curve occurs twice; sets of curves in ascending order; no integer above
/// 2⁵³.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] Problem structure_problem(const CurvesDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const CurvesDocument& document);

/// The names of its own rules, in order:
///
/// * `lengths`: none of the curves is null-homotopic, and the length of its geodesic is in its interval;
/// * `powers`: each is the power of a primitive one, as claimed;
/// * `intersections`: with themselves, and of each pair, the geometric and the algebraic number;
/// * `homology`: the basis is one, and the coefficients are those of the classes;
/// * `filling`: each set fills the surface.
///
/// Time: the triangles that the geodesics run through, and the pairs of chords in one triangle.
[[nodiscard]] RuleNames own_rules(const CurvesDocument& document);

[[nodiscard]] Claim claim_of(const CurvesDocument& document);

}  // namespace epsnet::certify
