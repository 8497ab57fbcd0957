#pragma once

#include <cstdint>

#include "triangulation/surface/surface.h"

namespace epsnet {

/// A point of a surface, in the coordinates of a tile.
struct BasePoint {
  std::uint32_t tile;
  Complex<Rational> z;
};

/// Returns a point with few digits, strictly inside a tile: near the mean of the vertices in the Klein model. Throws
/// SurfaceError if there is no such tile.
[[nodiscard]] BasePoint centre_of_tile(const Surface& surface, std::uint32_t tile);

/// Throws SurfaceError if the point is not strictly inside its tile.
void require_inside(const Surface& surface, const BasePoint& base);

/// Throws SurfaceError unless the point is in its closed tile.
void require_in_tile(const Surface& surface, const BasePoint& point);

/// Returns a shortest word from one tile to another. O(sides).
[[nodiscard]] Word path_between_tiles(const Surface& surface, std::uint32_t from, std::uint32_t to);

}  // namespace epsnet
