#pragma once

#include "triangulation/surface/surface.h"

namespace epsnet {

/// A lower bound of the lengths of closed geodesics, from one tile: no geodesic of the surface is shorter than the
/// smallest of its tiles' bounds (docs/error-bounds.md). Near the length of a short geodesic that crosses the tile; at
/// least 10⁻⁹⁰, which also stands for less.
///
/// Quadratic in the number of sides.
[[nodiscard]] double curve_bound(const Tile& tile);

}  // namespace epsnet
