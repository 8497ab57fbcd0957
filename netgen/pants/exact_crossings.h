#pragma once

#include "certify/net/crossings.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// The crossings of a surface's sides.
[[nodiscard]] certify::Crossings crossings_of(const Surface& surface);

}  // namespace epsnet
