#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "netgen/base/length.h"
#include "netgen/base/progress.h"
#include "triangulation/surface/surface.h"

/// Eigenvalues of the Laplacian of a surface from its length spectrum. docs/eigenvalues.md says how and why.
namespace epsnet {

/// Options of the search for eigenvalues.
struct EigenvaluesOptions {
  /// L: closed geodesics up to this length are used. The time is proportional to e^L; each unit of L narrows the
  /// intervals of small eigenvalues by about a factor of 5.
  Length up_to{"10"};
  std::uint32_t count = 0;  ///< Stop behind the window that completes so many eigenvalues; 0: where windows end.
  /// Whether eigenvalues that are counted are enclosed to some nine digits by approximate eigenfunctions, which takes
  /// some seconds for each window. Not if the net has more than some 25 vertices (genus 4 and more).
  bool eigenfunctions = true;
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};  ///< Called occasionally, if given.
};

/// Returns intervals, each with a number of eigenvalues, and coefficients that prove them, from 0 up to where they
/// cannot be told apart any more. The results are not proved yet; certify::check proves them. Deterministic.
///
/// Throws NetError if the spectrum cannot be found, or nothing can be said as L is less than about 1; LimitError if the
/// surface is beyond the numbers of the generator, or its closed geodesics are so short that they have more than 10⁶
/// multiples of length at most L; std::invalid_argument if L is more than 30.
[[nodiscard]] certify::EigenvaluesDocument eigenvalues(const Surface& surface, const EigenvaluesOptions& options = {});

/// Returns about the L that is needed to count the eigenvalues of the first window; nullopt if they are counted. An
/// estimate from the window's upper end, π(g − 1)r + 3 or a little more than the document's L.
[[nodiscard]] std::optional<double> length_to_count_first(const certify::EigenvaluesDocument& document);

/// Returns I(λ) for each λ, the best bound for the number of eigenvalues at λ that the test functions of the document
/// give: the least Σ f̂² with f̂(λ) = 1. Rounded. Throws LimitError, as above. Requires: 0 ≤ λ ≤ ¼ + 9/δ², and the
/// document is one of the surface.
[[nodiscard]] std::vector<double> eigenvalue_bounds(const Surface& surface,
                                                    const certify::EigenvaluesDocument& document,
                                                    const std::vector<double>& lambdas);

}  // namespace epsnet
