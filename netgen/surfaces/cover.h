#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "netgen/surfaces/permutation.h"
#include "triangulation/surface/surface.h"

/// Unbranched covers of a surface, given by how its group permutes the sheets. docs/covers.md has the conventions.
namespace epsnet {

/// Permutations that do not describe a connected cover; what() names the generator or relation, and the sheets.
class CoverError : public SurfaceError {
 public:
  using SurfaceError::SurfaceError;
};

/// The largest degree of random_sheets.
inline constexpr std::uint32_t kMostRandomSheets = 50;

/// Returns the permutations of an array of arrays of integers, a JSON text. Throws CoverError.
[[nodiscard]] std::vector<Permutation> parse_permutations(const std::string& text);

/// Returns the cover of a surface that the permutations describe, one for each pair of sides of its fundamental polygon
/// (polygon_sides), in the order of their first sides: from sheet i across the first side of pair k one gets to sheet
/// permutations[k][i]. Copy i of tile t is tile iT + t, for T tiles: a copy has the coordinates of its tile, so that
/// the surface is exact, and a closed geodesic of the cover goes to one of the base.
///
/// Throws CoverError if there are not as many permutations as pairs, if they are no permutations of the same numbers,
/// if their product around a vertex of the polygon is not the identity, if the cover is not connected, or if it would
/// have more than 2^20 sides. The time is that of the constructor of Surface. The cover of a map is a map.
[[nodiscard]] Surface cover(const Surface& base, const std::vector<Permutation>& permutations);

/// Returns permutations for `cover`, drawn uniformly from all those that describe a connected cover of this degree with
/// numbered sheets; the same ones for a seed on every machine. Draws about p(degree)/2 times, where p counts
/// partitions: tenths of a second for 50 sheets of genus 2. Throws CoverError unless 1 ≤ degree ≤ kMostRandomSheets.
[[nodiscard]] std::vector<Permutation> random_sheets(const Surface& base, std::uint32_t degree, std::uint64_t seed);

}  // namespace epsnet
