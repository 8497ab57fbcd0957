#pragma once

#include "triangulation/surface/surface.h"

/// Points of a surface, wherever in the disk of a tile they are given: beyond a side the tile's disk goes on with the
/// neighbours.
namespace epsnet {

/// Throws SurfaceError unless the surface has the tile and the coordinates are in its disk.
void require_on_surface(const Surface& surface, const BasePoint& point);

/// Returns the same point of the surface in a closed tile that contains it: the point as given if its own tile does.
/// Exact. Unless the surface `is_rational`, every point is returned as given. Throws
/// SurfaceError if it is no point of the surface, or more than 10,000 tiles away from its own.
[[nodiscard]] BasePoint in_its_tile(const Surface& surface, const BasePoint& point);

/// Returns whether two points are the same point of the surface, on sides and corners of tiles too. Exact; of a regular
/// surface only equal coordinates are known to be. Throws as in_its_tile.
[[nodiscard]] bool is_same_point(const Surface& surface, const BasePoint& p, const BasePoint& q);

}  // namespace epsnet
