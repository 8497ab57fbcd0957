#include <cassert>
#include <optional>
#include <string>
#include <vector>

#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

void require_tile(const Surface& surface, std::uint32_t tile) {
  if (tile >= surface.tiles().size()) {
    throw SurfaceError("the base point is in tile " + std::to_string(tile) + ", the surface has " +
                       std::to_string(surface.tiles().size()) + " tiles");
  }
}

/// The first side that the point is not strictly left of.
std::optional<std::size_t> side_not_left_of(const Tile& tile, const Complex<Rational>& z) {
  for (std::size_t k = 0; k < tile.size(); ++k) {
    if (norm(z) >= 1 || orientation_determinant(tile[k], tile[(k + 1) % tile.size()], z) <= 0) {
      return k;
    }
  }
  return std::nullopt;
}

}  // namespace

void require_inside(const Surface& surface, const BasePoint& base) {
  require_tile(surface, base.tile);
  if (const auto side = side_not_left_of(surface.tiles()[base.tile], base.z)) {
    throw SurfaceError("the base point is not strictly inside of tile " + std::to_string(base.tile) +
                       ": not left of side " + std::to_string(*side));
  }
}

BasePoint centre_of_tile(const Surface& surface, std::uint32_t tile) {
  if (surface.is_regular()) {
    return {tile, {0, 0}};
  }
  require_tile(surface, tile);
  const Tile& vertices = surface.tiles()[tile];
  Complex<Mp1024> sum;
  for (const Complex<Rational>& vertex : vertices) sum = sum + to_klein(convert<Mp1024>(vertex));
  const Complex<Mp1024> centre = from_klein(Mp1024(Mp1024(1) / vertices.size()) * sum);
  // As few bits as are enough.
  for (int bits = 8;; bits *= 2) {
    const Mp1024 scale = ldexp(Mp1024(1), bits);
    const Complex<Rational> z{Rational(Mp1024(round(Mp1024(centre.x * scale)) / scale)),
                              Rational(Mp1024(round(Mp1024(centre.y * scale)) / scale))};
    if (!side_not_left_of(vertices, z) || bits > 1024) {
      return {tile, z};
    }
  }
}

void require_in_tile(const Surface& surface, const BasePoint& point) {
  const std::size_t tiles = surface.tiles().size();
  if (point.tile >= tiles) {
    throw SurfaceError("the point is in tile " + std::to_string(point.tile) + ", the surface has " +
                       std::to_string(tiles) + " tiles");
  }
  const Tile& tile = surface.tiles()[point.tile];
  for (std::size_t k = 0; k < tile.size(); ++k) {
    if (norm(point.z) < 1 && orientation_determinant(tile[k], tile[(k + 1) % tile.size()], point.z) >= 0) continue;
    throw SurfaceError("the point is not in tile " + std::to_string(point.tile) + ": it is on the right of side " +
                       std::to_string(k));
  }
}

}  // namespace epsnet
