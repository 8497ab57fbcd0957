#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include "certify/base/fields.h"
#include "certify/base/text.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

template <>
struct Fields<EigenvaluesDocument::Enclosure> {
  static auto members(auto& row) { return std::tuple(member("in", row.in), member("count", row.count)); }
};

template <>
struct Fields<EigenvaluesDocument::AtMost> {
  static auto members(auto& row) {
    return std::tuple(member("below", row.below), member("count", row.count), member("sigma", row.sigma));
  }
};

template <>
struct Fields<EigenvaluesDocument::AtLeast> {
  static auto members(auto& row) { return std::tuple(member("below", row.below), member("count", row.count)); }
};

template <>
struct Fields<EigenvaluesDocument::Eigenfunctions> {
  static auto members(auto& row) {
    return std::tuple(member("in", row.in), member("lambda", row.lambda), member("radius", row.radius),
                      member("functions", row.functions));
  }
};

template <>
struct Fields<EigenvaluesDocument::Direction> {
  static auto members(auto& direction) {
    return std::tuple(member("steps", direction.steps), member("heights", direction.heights));
  }
};

template <>
struct Fields<EigenvaluesDocument::Box> {
  static auto members(auto& box) {
    return std::tuple(member("radius", box.radius).expecting("a decimal in a string"),
                      member("directions", box.directions));
  }
};

template <>
struct Fields<EigenvaluesDocument> {
  static constexpr ClaimKind kKind{"eigenvalues", "epsnet-eigenvalues", "eigenvalues",
                                   "An eigenvalues file claims in which intervals the first eigenvalues of the\n"
                                   "Laplacian lie, with multiplicity, and from where on all others; of functions,\n"
                                   "or of the sections of a flat line bundle, or of all those near one.",
                                   17};
  static constexpr const char* kName = "eigenvalues file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("net", document.net), member("phases", document.phases).optional(),
                   member("box", document.box).optional(), member("eigenvalues", document.eigenvalues),
                   member("next", document.next), member("halvings", document.halvings),
                   member("side_order", List{document.side_order}), member("vertex_order", List{document.vertex_order}),
                   member("at_most", document.at_most), member("at_least", document.at_least),
                   member("eigenfunctions", document.eigenfunctions)));
  }
};

// The claim of an eigenvalues file: where the first eigenvalues of the Laplacian lie (docs/proof.md, section 17).

struct Claim;

/// What an eigenvalues document must satisfy before any rule makes sense: a net without collars; phases, if there are
/// any, for all sides (see phases_problem), and then no eigenfunctions; a box only with phases (see box_problem);
/// orders that are permutations of the sides and vertices of the halved triangles, where they are needed; 0 < `below` ≤
/// `sigma`; intervals 0 ≤ lo ≤ hi; for each eigenfunction 2M + 1 finite coefficients by vertex, M from 1 to 200, not
/// all 0, a radius of more than ε and less than 2, 0 < lower end ≤ λ ≤ upper end, intervals in increasing order and
/// disjoint.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] Problem structure_problem(const EigenvaluesDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const EigenvaluesDocument& document);

/// The names of its own rules, in order:
///
/// * `phases`, if there are any: they are those of a flat line bundle;
/// * `box`, if there is one: its directions are homomorphisms to the integers, and their functions have bounded slopes;
///   refuted only if a direction is no homomorphism;
/// * `most`, `least`: the counts of `at_most` and `at_least`, by the inertia of matrices; never refuted;
/// * `eigenfunctions`: the functions of each row prove as many eigenvalues in its interval; never refuted;
/// * `enclosures`: what is claimed of λ₁, λ₂, … follows from these.
///
/// Time: for each count that of a factorization, about the sum of the squares of the numbers of entries in the columns
/// of the factor; for functions of order M, vertices·M²·10³ each.
[[nodiscard]] RuleNames own_rules(const EigenvaluesDocument& document);

[[nodiscard]] Claim claim_of(const EigenvaluesDocument& document);

}  // namespace epsnet::certify
