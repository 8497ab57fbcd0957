#pragma once

#include <cstdint>

#include "triangulation/surface.h"

namespace epsnet {

/// A point of a surface: of a tile, in its coordinates.
struct BasePoint {
  std::uint32_t tile;
  Complex<Rational> z;
};

/// A point strictly inside of a tile with few digits: near the mean of its vertices in the Klein model. Throws
/// SurfaceError if there is no such tile.
[[nodiscard]] BasePoint centre_of_tile(const Surface& surface, std::uint32_t tile);

/// Throws SurfaceError if the point is not strictly inside of its tile.
void require_inside(const Surface& surface, const BasePoint& base);

}  // namespace epsnet
