#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "netgen/base/options.h"
#include "triangulation/surface/surface.h"

/// Eigenvalues of the Laplacian of a surface from its length spectrum. docs/eigenvalues.md says how and why.
namespace epsnet {

/// Options of the search for eigenvalues.
struct EigenvaluesOptions {
  /// L: closed geodesics up to this length are used, 10 by default. The time is proportional to e^L; each unit of L
  /// narrows what the trace formula proves by about a factor of 5. With `width` or `seconds` the greatest L, 16 or 30
  /// by default: smaller ones, from 8 on, are tried first.
  std::optional<Length> up_to = {};
  std::uint32_t count = 0;  ///< Stop behind the window that completes so many eigenvalues; 0: where windows end.
  /// Until the first `count` eigenvalues, or the first one, are counted, each in an interval that is narrower.
  std::optional<double> width = {};
  /// Until about so many seconds are used, with as many again as the last search for a check. The L that is reached,
  /// and so the result, depends on the machine.
  std::optional<double> seconds = {};
  /// Whether the first eigenvalues are enclosed to some nine digits by approximate eigenfunctions, which also make gaps
  /// between eigenvalues provable that the trace formula alone does not show. Some seconds; proportional to the number
  /// of vertices. Not if the net has more than 150.
  bool eigenfunctions = true;
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};  ///< Called occasionally, if given.
};

/// Returns intervals, each with a number of eigenvalues, and coefficients that prove them, from 0 up to where they
/// cannot be told apart any more. The results are not proved yet; certify::check proves them. Deterministic, but for
/// `seconds`.
///
/// Throws NetError if the spectrum cannot be found, nothing can be said as L is less than about 1, or `width` is not
/// reached; LimitError if the surface is beyond the numbers of the generator, or its closed geodesics are so short that
/// they have more than 10⁶ multiples of length at most L; std::invalid_argument if L is more than 30, or `width` or
/// `seconds` is not positive.
[[nodiscard]] certify::EigenvaluesDocument eigenvalues(const Surface& surface, const EigenvaluesOptions& options = {});

/// Returns about the L that is needed to count the eigenvalues of the first window; nullopt if they are counted. An
/// estimate from the window's upper end, π(g − 1)r + 3 or a little more than the document's L.
[[nodiscard]] std::optional<double> length_to_count_first(const certify::EigenvaluesDocument& document);

/// Returns I(λ) for each λ, the best bound for the number of eigenvalues at λ that the test functions of the document
/// give, but for those that its eigenfunctions show: the least Σ f̂² over all others with f̂(λ) = 1. Rounded. Throws
/// LimitError, as above. Requires: 0 ≤ λ ≤ ¼ + 9/δ², and the document is one of the surface.
[[nodiscard]] std::vector<double> eigenvalue_bounds(const Surface& surface,
                                                    const certify::EigenvaluesDocument& document,
                                                    const std::vector<double>& lambdas);

}  // namespace epsnet
