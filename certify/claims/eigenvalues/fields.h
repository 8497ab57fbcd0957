#pragma once

#include <tuple>

#include "certify/base/fields.h"
#include "certify/claims/eigenvalues/document.h"

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
struct Fields<EigenvaluesDocument> {
  static constexpr ClaimKind kKind{"eigenvalues", "epsnet-eigenvalues", "eigenvalues",
                                   "An eigenvalues file claims in which intervals the first eigenvalues of the\n"
                                   "Laplacian lie, with multiplicity, and from where on all others.",
                                   17};
  static constexpr const char* kName = "eigenvalues file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version(kKind.format),
        std::tuple(member("net", document.net), member("eigenvalues", document.eigenvalues),
                   member("next", document.next), member("halvings", document.halvings),
                   member("side_order", List{document.side_order}), member("vertex_order", List{document.vertex_order}),
                   member("at_most", document.at_most), member("at_least", document.at_least),
                   member("eigenfunctions", document.eigenfunctions)));
  }
};

}  // namespace epsnet::certify
