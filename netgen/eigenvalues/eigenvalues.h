#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// The first eigenvalues of the Laplacian of a surface, counted by a net. docs/eigenvalues.md says how and why.
namespace epsnet {

/// Options of the search for eigenvalues.
struct EigenvaluesOptions {
  std::uint32_t count = 10;  ///< The first so many eigenvalues, and those that cannot be told apart from the last one.
  /// Instead of `count`: how many eigenvalues are less than this number; and these eigenvalues, if `digits` is given.
  std::optional<double> below = {};
  /// About so many significant digits of each eigenvalue, from 1 to 10; 9 by default, and none with `below`. Up to 2,
  /// matrices alone enclose them, which takes much less time than functions.
  std::optional<int> digits = {};
  std::optional<Length> epsilon = {};  ///< Of the net; by default it is chosen, at most 0.6.
  unsigned threads = 0;                ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};              ///< Called occasionally, if given.
};

/// Returns intervals with the first eigenvalues, from λ₁ on, and what proves them. Deterministic.
///
/// Throws NetError if the net cannot be made or the eigenvalues are not found; NotCertifiedError, which is one, if the
/// proof fails; LimitError if the surface is beyond the
/// numbers of the generator, or it takes more than about 10⁷ triangles; std::invalid_argument if an option is out of
/// range.
[[nodiscard]] Certified<certify::EigenvaluesDocument> eigenvalues(const Surface& surface,
                                                                  const EigenvaluesOptions& options = {});

/// The same document without its proof: nothing in it is proved.
namespace unproved {

[[nodiscard]] certify::EigenvaluesDocument eigenvalues(const Surface& surface, const EigenvaluesOptions& options = {});

}  // namespace unproved

}  // namespace epsnet
