#pragma once

#include <cstdint>

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
  unsigned threads = 0;     ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};   ///< Called occasionally, if given.
};

/// Returns intervals, each with a number of eigenvalues, and coefficients that prove them, from 0 up to where they
/// cannot be told apart any more. The results are not proved yet; certify::check proves them. Deterministic.
///
/// Throws NetError if the spectrum cannot be found or nothing can be said with this L; LimitError if the surface is
/// beyond the numbers of the generator; std::invalid_argument if L is more than 30.
[[nodiscard]] certify::EigenvaluesDocument eigenvalues(const Surface& surface, const EigenvaluesOptions& options = {});

}  // namespace epsnet
