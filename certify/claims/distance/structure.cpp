#include "certify/claims/distance/structure.h"

#include <cmath>

#include "certify/net/structure.h"
#include "certify/net/surface_sides.h"

namespace epsnet::certify {
namespace {

using Problem = std::optional<std::string>;

Problem net_problem(const NetDocument& net) {
  if (auto problem = structure_problem(net)) return problem;
  if (net.collars) return "net: collars, a pseudo net; expected a net of the whole surface";
  if (net.vertices.size() == 1) return std::nullopt;
  return "net: " + std::to_string(net.vertices.size()) + " vertices, expected one, from which the distance is measured";
}

Problem point_problem(const DistanceDocument& document) {
  const auto& [tile, z] = document.point;
  const std::size_t tiles = number_of_tiles(document.net.surface);
  if (tile >= tiles) {
    return "point: tile " + std::to_string(tile) + " does not exist, expected less than " + std::to_string(tiles);
  }
  if (z.x * z.x + z.y * z.y < 1) return std::nullopt;
  return "point: outside of the open unit disk";
}

Problem distance_problem(Interval distance) {
  if (std::isfinite(distance.upper) && 0 <= distance.lower && distance.lower <= distance.upper) return std::nullopt;
  return "distance: " + to_string(distance) + " is not 0 <= lo <= hi";
}

Problem paths_problem(const DistanceDocument& document) {
  if (document.paths.empty()) return "paths: no element, expected at least one";
  const SurfaceSides sides(document.net.surface);
  const std::uint32_t start = document.net.charts[document.net.vertices[0].chart].tile;
  for (std::size_t i = 0; i < document.paths.size(); ++i) {
    std::uint32_t here = start;
    for (const std::uint32_t side : document.paths[i]) {
      if (side >= sides.partner.size() || sides.tile[side] != here) {
        return at("paths", i) + "the word crosses " + std::to_string(side) + ", which is no side of tile " +
               std::to_string(here);
      }
      here = sides.tile[sides.partner[side]];
    }
    if (here == document.point.tile) continue;
    return at("paths", i) + "the word ends in tile " + std::to_string(here) + ", expected that of the point, " +
           std::to_string(document.point.tile);
  }
  return std::nullopt;
}

}  // namespace

Problem structure_problem(const DistanceDocument& document) {
  if (auto problem = net_problem(document.net)) return problem;
  if (auto problem = point_problem(document)) return problem;
  if (auto problem = distance_problem(document.distance)) return problem;
  return paths_problem(document);
}

}  // namespace epsnet::certify
