#include "certify/net/structure.h"

#include "certify/claims/distance/check.h"

namespace epsnet::certify {
namespace {

Problem point_problem(const DistanceDocument& document) {
  const auto& [tile, z] = document.point;
  const std::size_t tiles = number_of_tiles(document.net.surface);
  if (tile >= tiles) {
    return "point: tile " + std::to_string(tile) + " does not exist, expected less than " + std::to_string(tiles);
  }
  if (z.x * z.x + z.y * z.y < 1) return std::nullopt;
  return "point: outside of the open unit disk";
}

Problem paths_problem(const DistanceDocument& document) {
  if (document.paths.empty()) return "paths: no element, expected at least one";
  const SurfaceSides sides(document.net.surface);
  const std::uint32_t start = document.net.charts[document.net.vertices[0].chart].tile;
  return first_row_problem("paths", document.paths, [&](const std::vector<std::uint32_t>& path) {
    return word_problem(sides, path, start, document.point.tile, "the point");
  });
}

}  // namespace

Problem structure_problem(const DistanceDocument& document) {
  if (auto problem = one_vertex_problem(document.net)) return problem;
  if (auto problem = point_problem(document)) return problem;
  if (!is_length(document.distance)) return "distance: " + to_string(document.distance) + " is not 0 <= lo <= hi";
  return paths_problem(document);
}

std::uint64_t least_bytes(const DistanceDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + 64 + least_bytes(document.point.z);
  for (const std::vector<std::uint32_t>& path : document.paths) bytes += 3 + least_bytes(path);
  return bytes;
}

}  // namespace epsnet::certify
