#pragma once

#include <optional>
#include <vector>

#include "triangulation/surface/surface.h"

/// The automorphisms of a map of regular tiles, by combinatorics alone. They are isometries of its surface: tiles are
/// congruent, and a tile is determined by one of its sides.
namespace epsnet {

/// An isometry of a surface that takes tiles to tiles.
struct MapAutomorphism {
  bool preserves_orientation;
  ById<SideId, SideId> image;  ///< By side.
};

/// Returns automorphisms that generate all; none for a surface without regular tiles. O(sides) for each one, and for
/// each side where side 0 is not taken, as far as the map looks the same from there.
[[nodiscard]] std::vector<MapAutomorphism> map_automorphisms(const Surface& surface);

/// The image of a path.
[[nodiscard]] Word image_of(const MapAutomorphism& automorphism, const Word& word);
/// The image of a tile.
[[nodiscard]] TileId image_of(const Surface& surface, const MapAutomorphism& automorphism, TileId tile);

}  // namespace epsnet
