#include <algorithm>
#include <list>
#include <optional>

#include "netgen/surfaces/group.h"
#include "triangulation/surface/atlas.h"

namespace epsnet {
namespace {

/// A tree of the tiles, with tile 0 as its root.
struct Tree {
  ById<TileId, Word> path;  ///< The path from tile 0 to a tile.
  std::list<SideId> rim;    ///< The sides that the tree does not cross, counterclockwise around all tiles.

  explicit Tree(const Surface& surface) : path(surface.tiles().size()) {
    ById<TileId, bool> reached(path.size());
    reached[TileId(0)] = true;
    for (const SideId s : surface.sides_of(TileId(0))) rim.push_back(s);
    // Breadth first: the sides added in one round are visited in the next.
    for (bool grown = true; grown;) {
      grown = false;
      for (auto place = rim.begin(); place != rim.end();) {
        const SideId entry = surface.partner(*place);
        const TileId tile = surface.tile_of_side(entry);
        if (reached[tile]) {
          ++place;
          continue;
        }
        reached[tile] = grown = true;
        path[tile] = path[surface.tile_of_side(*place)];
        path[tile].push_back(*place);
        for (SideId s = surface.next_side(entry); s != entry; s = surface.next_side(s)) rim.insert(place, s);
        place = rim.erase(place);
      }
    }
  }
};

/// The point at the end of a path, in the coordinates where it starts, rounded to 256 bits.
Complex<Rational> rounded_from(const Surface& surface, const Word& path, const Complex<Rational>& z) {
  if (path.empty()) return z;
  Complex<Mp1024> result = convert<Mp1024>(z);
  for (auto side = path.rbegin(); side != path.rend(); ++side) {
    result = surface.crossing_as<Mp1024>(surface.partner(*side))(result);
  }
  return {Rational(Mp256(result.x)), Rational(Mp256(result.y))};
}

/// Removes pairs of neighbouring sides that are glued to each other.
std::vector<SideId> without_folds(const Surface& surface, const std::list<SideId>& rim) {
  std::vector<SideId> sides;
  for (const SideId s : rim) {
    if (!sides.empty() && surface.partner(sides.back()) == s) {
      sides.pop_back();
    } else {
      sides.push_back(s);
    }
  }
  std::size_t first = 0;
  while (sides.size() - first > 2 && surface.partner(sides[first]) == sides.back()) {
    ++first;
    sides.pop_back();
  }
  sides.erase(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(first));
  return sides;
}

PolygonSides polygon_sides(const Surface& surface, const Tree& tree) {
  PolygonSides result;
  result.side = without_folds(surface, tree.rim);
  const auto count = static_cast<std::uint32_t>(result.side.size());
  ById<SideId, std::uint32_t> place(surface.side_count());
  for (std::uint32_t k = 0; k < count; ++k) place[result.side[k]] = k;
  for (const SideId s : result.side) result.partner.push_back(place[surface.partner(s)]);
  std::vector<bool> visited(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    if (visited[k]) continue;
    std::vector<std::uint32_t>& relation = result.relations.emplace_back();
    for (std::uint32_t s = k; !visited[s]; s = (result.partner[s] + 1) % count) {
      visited[s] = true;
      relation.push_back(s);
    }
  }
  return result;
}

}  // namespace

PolygonSides polygon_sides(const Surface& surface) { return polygon_sides(surface, Tree(surface)); }

ById<TileId, Word> polygon_paths(const Surface& surface) { return Tree(surface).path; }

FundamentalPolygon fundamental_polygon(const Surface& surface) {
  const Tree tree(surface);
  PolygonSides polygon = polygon_sides(surface, tree);
  FundamentalPolygon result;
  std::optional<TileId> tile;
  Isometry<Rational> to_root;
  for (std::size_t k = 0; k < polygon.side.size(); ++k) {
    const SideId s = polygon.side[k];
    const TileId here = surface.tile_of_side(s);
    const SideId there = surface.partner(s);
    const Word& way = tree.path[surface.tile_of_side(there)];
    // The path leads from tile 0 to the tile beyond, back across the side, and back to tile 0.
    Word word = way;
    word.push_back(there);
    const Word home = reversed(surface, tree.path[here]);
    word.insert(word.end(), home.begin(), home.end());
    result.sides.push_back({std::move(word), polygon.partner[k], s});
    const Complex<Rational>& corner = surface.tile(here)[surface.place_in_tile(s)];
    if (!surface.is_rational()) {
      result.vertices.push_back(rounded_from(surface, tree.path[here], corner));
      continue;
    }
    if (tile != here) {
      to_root = inverse(exact_isometry(surface, tree.path[here]));
      tile = here;
    }
    result.vertices.push_back(to_root(corner));
  }
  result.relations = std::move(polygon.relations);
  return result;
}

}  // namespace epsnet
