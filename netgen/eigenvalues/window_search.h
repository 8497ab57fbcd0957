#pragma once

#include <cstdint>

#include "certify/claims/eigenvalues/document.h"
#include "netgen/base/options.h"
#include "netgen/eigenvalues/prover.h"

namespace epsnet {

/// Finds windows with eigenvalues, gaps without, and what proves them, and puts them into the document. Ends when
/// `count` eigenvalues are found, unless this is 0, or where no gap follows any more. False if nothing can be said.
///
/// `document` has a spectrum, the prover's test functions and its known eigenvalues, and no window or statement.
/// Seconds at most: some thousand solutions of linear equations of the test functions' degree, with 77 digits, for each
/// window.
[[nodiscard]] bool find_windows(Prover& prover, std::uint64_t count, const Progress& progress,
                                certify::EigenvaluesDocument& document);

}  // namespace epsnet
