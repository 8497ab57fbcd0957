#pragma once

#include <epsnet/certify/document.h>

#include <cstdint>
#include <vector>

namespace epsnet::certify {

/// The sides of all tiles, numbered in the order of the file (docs/format.md, "Side numbers"), and how they are glued.
///
/// Needs indices in range and every side glued once (structure_problem). O(number of sides).
struct SurfaceSides {
  explicit SurfaceSides(const Surface& surface) {
    std::vector<std::uint32_t> first;
    for (std::uint32_t t = 0; t < surface.tiles.size(); ++t) {
      first.push_back(static_cast<std::uint32_t>(tile.size()));
      for (std::uint32_t k = 0; k < surface.tiles[t].size(); ++k) {
        tile.push_back(t);
        corner.push_back(k);
      }
    }
    partner.resize(tile.size());
    for (const auto& [t, k, other_t, other_k] : surface.gluing) {
      partner[first[t] + k] = first[other_t] + other_k;
      partner[first[other_t] + other_k] = first[t] + k;
    }
    next.resize(tile.size());
    for (std::uint32_t s = 0; s < tile.size(); ++s) {
      next[s] = corner[s] + 1 == surface.tiles[tile[s]].size() ? first[tile[s]] : s + 1;
    }
    previous.resize(tile.size());
    for (std::uint32_t s = 0; s < tile.size(); ++s) previous[next[s]] = s;
  }

  std::vector<std::uint32_t> tile;      ///< The tile of a side.
  std::vector<std::uint32_t> corner;    ///< The vertex of the tile where the side starts.
  std::vector<std::uint32_t> partner;   ///< The side it is glued to.
  std::vector<std::uint32_t> next;      ///< The next side of its tile, counterclockwise.
  std::vector<std::uint32_t> previous;  ///< The previous one.
};

}  // namespace epsnet::certify
