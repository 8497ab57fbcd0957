#pragma once

#include <cstddef>
#include <vector>

#include "certify/exact/claim_documents.h"
#include "certify/exact/loops.h"

/// Functions around the vertices that nearly fit together (docs/proof.md, section 17).
namespace epsnet::exact {

/// By vertex: all other lifts of vertices nearer than ε + R, and perhaps some that are hardly farther. A motion leads
/// from the disk with the lift's vertex in its centre to the one with the vertex in its centre.
struct NearLift {
  Index vertex;
  Motion motion;
};
using NearLifts = std::vector<std::vector<NearLift>>;

/// How much work eigenvalue_error is: values of functions that it takes, and some products of two functions.
[[nodiscard]] std::size_t values_needed(const EigenvaluesDocument::Eigenfunctions& row, const NearLifts& near);

/// δ such that as many eigenvalues as functions, perhaps with 0, lie in [λ − δ, λ + δ] (Lemmas 37.1 to 37.6). Throws
/// TooLarge if none is proved. The rules of the net are verified; `minus_euler` = 2g − 2.
[[nodiscard]] Interval eigenvalue_error(const EigenvaluesDocument::Eigenfunctions& row, const mpq_class& epsilon,
                                        const NearLifts& near, long minus_euler);

}  // namespace epsnet::exact
