#include <algorithm>
#include <cassert>
#include <optional>
#include <string>
#include <vector>

#include "kernel/plane.h"
#include "triangulation/surface/points.h"

namespace epsnet {
namespace {

void require_tile(const Surface& surface, TileId tile) {
  const std::size_t tiles = surface.tiles().size();
  if (tile.number() < tiles) return;
  throw SurfaceError("the point is in tile " + to_string(tile) + ", the surface has " + std::to_string(tiles) +
                     (tiles == 1 ? " tile" : " tiles"));
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

/// The sign says on which side of a side of its tile a point lies: positive is inside, 0 on the line.
auto side_of(const Surface& surface, const BasePoint& point, SideId s) {
  const Tile& tile = surface.tile(point.tile);
  const std::uint32_t k = surface.place_in_tile(s);
  return orientation_determinant(tile[k], tile[(k + 1) % tile.size()], point.z);
}

/// The first side of its tile that the point lies beyond.
std::optional<SideId> side_before(const Surface& surface, const BasePoint& point) {
  for (const SideId s : surface.sides_of(point.tile)) {
    if (side_of(surface, point, s) < 0) return s;
  }
  return std::nullopt;
}

BasePoint across(const Surface& surface, const BasePoint& point, SideId s) {
  return {surface.tile_of_side(surface.partner(s)), surface.crossing(s)(point.z)};
}

}  // namespace

void require_inside(const Surface& surface, const BasePoint& base) {
  require_tile(surface, base.tile);
  if (const auto side = side_not_left_of(surface.tile(base.tile), base.z)) {
    throw SurfaceError("the base point is not strictly inside of tile " + to_string(base.tile) + ": not left of side " +
                       std::to_string(*side));
  }
}

BasePoint centre_of_tile(const Surface& surface, TileId tile) {
  if (surface.is_regular()) {
    return {tile, {0, 0}};
  }
  require_tile(surface, tile);
  const Tile& vertices = surface.tile(tile);
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

void require_on_surface(const Surface& surface, const BasePoint& point) {
  require_tile(surface, point.tile);
  if (norm(point.z) >= 1) throw SurfaceError("the point is not inside of the unit disk");
}

BasePoint in_its_tile(const Surface& surface, const BasePoint& point) {
  require_on_surface(surface, point);
  if (surface.is_regular()) return point;
  // A walk along a line would need more care; this one leads nearer to the tile's inside with each step.
  constexpr int kMostTiles = 10'000;
  BasePoint here = point;
  for (int tiles = 0; tiles < kMostTiles; ++tiles) {
    const std::optional<SideId> beyond = side_before(surface, here);
    if (!beyond) return here;
    here = across(surface, here, *beyond);
  }
  throw SurfaceError("the point is more than " + std::to_string(kMostTiles) + " tiles away from tile " +
                     to_string(point.tile));
}

bool is_same_point(const Surface& surface, const BasePoint& p, const BasePoint& q) {
  const auto equal = [](const BasePoint& a, const BasePoint& b) { return a.tile == b.tile && a.z == b.z; };
  const BasePoint goal = in_its_tile(surface, q);
  // All places that p has in closed tiles: several if it is on a side or a corner.
  std::vector<BasePoint> places{in_its_tile(surface, p)};
  for (std::size_t i = 0; i < places.size() && !surface.is_regular(); ++i) {
    for (const SideId s : surface.sides_of(places[i].tile)) {
      if (side_of(surface, places[i], s) != 0) continue;
      const BasePoint place = across(surface, places[i], s);
      if (std::none_of(places.begin(), places.end(), [&](const BasePoint& known) { return equal(place, known); })) {
        places.push_back(place);
      }
    }
  }
  return std::any_of(places.begin(), places.end(), [&](const BasePoint& place) { return equal(place, goal); });
}

}  // namespace epsnet
