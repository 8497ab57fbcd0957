#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "netgen/isometries/lifted_tiles.h"
#include "netgen/isometries/matches.h"

namespace epsnet {

/// Closed geodesics by the tiles that they cross, to find the one on which the image of another one lies.
///
/// Numbers have 512 bits. What is found is right to 100 of them; a line may not be found, if a point of it is a corner
/// of tiles.
class LinePlaces {
 public:
  /// Requires: the tiles live as long. O(tiles crossed × sides of a tile).
  LinePlaces(const LiftedTiles& tiles, const std::vector<Line>& lines);

  /// Returns the number of the line to which an isometry, from the coordinates of tile 0 to themselves, takes line i;
  /// nothing, if it is not found.
  [[nodiscard]] std::optional<std::uint32_t> image(const Motion<LiftedTiles::Number>& f, std::uint32_t i) const;

 private:
  using Vector = LiftedTiles::Vector;
  /// A line in the coordinates of a tile that it crosses.
  struct Place {
    TileId tile;
    Vector normal;  ///< Of length 1.
    Vector point;   ///< Inside of the tile, or of one of its sides.
  };

  void follow(const Line& line, std::uint32_t number);
  void add(TileId tile, const Vector& normal, std::uint32_t number);
  [[nodiscard]] std::optional<std::uint32_t> find(TileId tile, const Vector& normal) const;

  const LiftedTiles& tiles_;
  ById<TileId, Word> from_tile_0_;
  std::vector<Place> middle_;  ///< By line: of its longest part in a tile.
  struct Known {
    Vector normal;
    std::uint32_t line;
  };
  std::map<TileId, std::multimap<double, Known>> known_;  ///< By tile and |x| of the normal.
};

}  // namespace epsnet
