#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/base/error.h"
#include "certify/net/document.h"

namespace epsnet::certify {

// Darts of a document: dart 3t + i is the edge of triangle t from corner i to corner i + 1 (modulo 3). Fault, if what
// is asked about is not there.

[[nodiscard]] inline std::uint32_t next_dart(std::uint32_t dart) { return dart % 3 == 2 ? dart - 2 : dart + 1; }
[[nodiscard]] inline std::uint32_t previous_dart(std::uint32_t dart) { return dart % 3 == 0 ? dart + 2 : dart - 1; }

[[nodiscard]] inline const NetDocument::Triangle& triangle_at(const NetDocument& document, std::uint32_t triangle) {
  return looked_up(document.triangles, triangle, "there is no triangle");
}

[[nodiscard]] inline std::uint32_t opposite(const NetDocument& document, std::uint32_t dart) {
  return triangle_at(document, dart / 3).opposite[dart % 3];
}

/// The vertex that the dart leaves.
[[nodiscard]] inline std::uint32_t start(const NetDocument& document, std::uint32_t dart) {
  return triangle_at(document, dart / 3).vertex[dart % 3];
}

/// The label number at the corner where the dart starts: from its vertex's chart to its triangle's. Corner 0 has 0.
[[nodiscard]] inline std::uint32_t corner_label(const NetDocument& document, std::uint32_t dart) {
  const NetDocument::Triangle& triangle = triangle_at(document, dart / 3);
  return dart % 3 == 0 ? 0 : triangle.label[dart % 3 - 1];
}

/// The chart in which the corners of the triangle are measured.
[[nodiscard]] inline std::uint32_t chart_of_triangle(const NetDocument& document, std::uint32_t triangle) {
  return looked_up(document.vertices, triangle_at(document, triangle).vertex[0], "there is no vertex").chart;
}

/// The chart of a collar's first vertex, from which its core leads back to it.
[[nodiscard]] inline std::uint32_t chart_of_core(const NetDocument& document, const NetDocument::Collar& collar) {
  return looked_up(document.vertices, collar.vertices[0], "there is no vertex").chart;
}

/// Whether the tiles are polygons over a number field.
[[nodiscard]] inline bool is_over_field(const SurfaceDocument& surface) { return !surface.field.polynomial.empty(); }

[[nodiscard]] inline std::size_t number_of_tiles(const SurfaceDocument& surface) {
  if (is_over_field(surface)) return surface.field.polygons.size();
  if (surface.map_tile.p != 0) return 2 * surface.gluing.size() / surface.map_tile.p;
  return surface.regular_genus == 0 ? surface.tiles.size() : 1;
}

/// What all tiles are, unless they are listed.
[[nodiscard]] inline std::optional<RegularTile> regular_tile(const SurfaceDocument& surface) {
  if (surface.map_tile.p != 0) return surface.map_tile;
  if (surface.regular_genus == 0) return std::nullopt;
  return RegularTile{4 * surface.regular_genus, 4 * surface.regular_genus};
}

/// The sides of all tiles, numbered in the order of the file (docs/format.md, "Side numbers"), and how they are glued.
///
/// Needs indices in range and every side glued once (structure_problem). O(number of sides).
struct SurfaceSides {
  explicit SurfaceSides(const SurfaceDocument& surface) {
    if (const auto regular = regular_tile(surface)) {
      for (std::size_t t = 0; t < number_of_tiles(surface); ++t) add_tile(regular->p);
    }
    for (const SurfaceDocument::Tile& polygon : surface.tiles) add_tile(static_cast<std::uint32_t>(polygon.size()));
    for (const auto& polygon : surface.field.polygons) add_tile(static_cast<std::uint32_t>(polygon.size()));
    for (const auto& [t, k, other_t, other_k] : surface.gluing) glue(first[t] + k, first[other_t] + other_k);
    for (std::uint32_t k = 0; k < 2 * surface.regular_genus; ++k) glue(k, k + 2 * surface.regular_genus);
    previous.resize(tile.size());
    for (std::uint32_t s = 0; s < tile.size(); ++s) previous[next[s]] = s;
  }

  /// The next side around a vertex of the surface, clockwise: across the side that leaves it, then the side that
  /// leaves it there.
  [[nodiscard]] std::uint32_t next_around(std::size_t side) const { return next[partner[side]]; }

  /// The vertices of the surface, each by its first side that leaves it, in order. O(number of sides).
  [[nodiscard]] std::vector<std::uint32_t> vertices() const {
    std::vector<bool> visited(partner.size());
    std::vector<std::uint32_t> result;
    for (std::uint32_t s = 0; s < visited.size(); ++s) {
      if (visited[s]) continue;
      result.push_back(s);
      for (std::uint32_t around = s; !visited[around]; around = next_around(around)) visited[around] = true;
    }
    return result;
  }

  std::vector<std::uint32_t> first;     ///< The first side of a tile.
  std::vector<std::uint32_t> tile;      ///< The tile of a side.
  std::vector<std::uint32_t> corner;    ///< The vertex of the tile where the side starts.
  std::vector<std::uint32_t> partner;   ///< The side it is glued to.
  std::vector<std::uint32_t> next;      ///< The next side of its tile, counterclockwise.
  std::vector<std::uint32_t> previous;  ///< The previous one.

 private:
  void add_tile(std::uint32_t size) {
    const auto start = static_cast<std::uint32_t>(tile.size());
    const auto number = static_cast<std::uint32_t>(first.size());
    first.push_back(start);
    for (std::uint32_t k = 0; k < size; ++k) {
      tile.push_back(number);
      corner.push_back(k);
      partner.push_back(0);
      next.push_back(start + (k + 1) % size);
    }
  }

  void glue(std::uint32_t side, std::uint32_t other) {
    partner[side] = other;
    partner[other] = side;
  }
};

}  // namespace epsnet::certify
