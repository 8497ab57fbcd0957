#pragma once

#include <cstdint>
#include <vector>

#include "certify/net/document.h"
#include "certify/net/numbering.h"

namespace epsnet::certify {

/// A word of the same element: before it a path that goes far away, around a corner of the tile that it reaches, and
/// back the same way. It does not cancel as a word, and balls follow it only with more bits than the path is long.
inline std::vector<std::uint32_t> with_far_relator(const SurfaceDocument& surface, std::uint32_t tile,
                                                   const std::vector<std::uint32_t>& word, std::size_t length = 150) {
  const SurfaceSides sides(surface);
  std::vector<std::uint32_t> path;
  for (std::size_t k = 0; k < length; ++k) {
    // Any side but the one that leads back.
    std::uint32_t side = sides.first[tile] + static_cast<std::uint32_t>(k % 3);
    if (!path.empty() && sides.partner[path.back()] == side) side = sides.next[side];
    path.push_back(side);
    tile = sides.tile[sides.partner[side]];
  }
  std::vector<std::uint32_t> result = path;
  std::uint32_t start = sides.first[tile];
  while (start == sides.partner[path.back()]) start = sides.next[start];
  std::uint32_t side = start;
  do {
    result.push_back(side);
    side = sides.next_around(side);
  } while (side != start);
  for (auto back = path.rbegin(); back != path.rend(); ++back) result.push_back(sides.partner[*back]);
  result.insert(result.end(), word.begin(), word.end());
  return result;
}

}  // namespace epsnet::certify
