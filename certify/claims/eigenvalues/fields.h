#pragma once

#include <tuple>

#include "certify/base/fields.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/claims/geodesics/fields.h"

namespace epsnet::certify {

template <>
struct Fields<EigenvaluesDocument::Window> {
  static auto members(auto& window) {
    return std::tuple(member("in", window.in), member("least", window.least), member("most", window.most),
                      member("smallest", window.smallest), member("greatest", window.greatest));
  }
};

template <>
struct Fields<EigenvaluesDocument::AtMost> {
  static auto members(auto& row) {
    return std::tuple(member("in", row.in), member("count", row.count), member("coefficients", row.coefficients));
  }
};

template <>
struct Fields<EigenvaluesDocument::AtLeast> {
  static auto members(auto& row) {
    return std::tuple(member("in", row.in), member("within", row.within), member("count", row.count),
                      member("coefficients", row.coefficients));
  }
};

template <>
struct Fields<EigenvaluesDocument::Eigenfunction> {
  static auto members(auto& row) {
    return std::tuple(member("in", row.in), member("lambda", row.lambda), member("radius", row.radius),
                      member("coefficients", row.coefficients));
  }
};

template <>
struct Fields<EigenvaluesDocument> {
  static constexpr ClaimKind kKind{"eigenvalues", "epsnet-eigenvalues", "eigenvalues",
                                   "An eigenvalues file claims how many eigenvalues of the Laplacian lie in which\n"
                                   "intervals, and that there is no other one up to a bound.",
                                   17};
  static constexpr const char* kName = "eigenvalues file";
  static constexpr const char* kPrefix = "";
  static auto members(auto& document) {
    return std::tuple_cat(
        format_and_version(kKind.format), spectrum_members(document),
        std::tuple(member("order", document.order), member("degree", document.degree),
                   member("eigenvalues_up_to", document.eigenvalues_up_to), member("windows", document.windows),
                   member("at_most", document.at_most), member("at_least", document.at_least),
                   member("eigenfunctions", document.eigenfunctions)));
  }
};

}  // namespace epsnet::certify
