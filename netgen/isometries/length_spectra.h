#pragma once

#include <optional>
#include <string>

#include "certify/claims/geodesics/document.h"

namespace epsnet {

/// What tells two surfaces apart, in words: a length ℓ such that one of them certainly has more primitive closed
/// geodesics that are at most as long than the other one. Nothing, if there is none.
///
/// Requires: spectra. The statement follows from them (docs/isometries.md); they are not checked here. O(n log n).
[[nodiscard]] std::optional<std::string> certain_difference(const certify::GeodesicsDocument& first,
                                                            const certify::GeodesicsDocument& second);

}  // namespace epsnet
