#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "certify/numbers/regular_number.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/surface/surface.h"

/// The rotation group of the tiling of the plane by regular p-gons, q of them at each vertex, exactly: the orientation
/// preserving triangle group (2, p, q). Every surface of a map has a subgroup of it as its group.
namespace epsnet {

/// A walk over the tiling, from tile to tile. It looks along a side of the tile where it is, at first along side 0.
struct TileWalk {
  std::vector<std::uint32_t> turns;  ///< So many sides counterclockwise, then across the side ahead, and so on.
  std::uint32_t last_turn = 0;       ///< After all of these.
};

/// The walk of a word from tile 0 to itself over regular tiles. O(letters).
[[nodiscard]] TileWalk walk_of(const Surface& surface, const Word& word);

/// The triangle group, in coordinates with a tile centred at 0 and the midpoint of its side 0 on the positive real
/// axis.
class TriangleGroup {
 public:
  using Number = Mp1024;
  using ExactElement = certify::Isometry<certify::RegularNumber>;

  /// Products of its numbers take their work off the budget: certify::BudgetSpent. Throws SurfaceError unless p and q
  /// are at least 3, 1/p + 1/q < 1/2, and lcm(2p, 2q, 4) is at most 100,000.
  explicit TriangleGroup(RegularTile tile, const certify::Budget& budget = {});

  [[nodiscard]] RegularTile tile() const { return tile_; }
  /// Its numbers: ζ = e^{2πi/n} with n = lcm(2p, 2q, 4), and s as in docs/proof.md, section 9.
  [[nodiscard]] const certify::RegularRing& ring() const { return *ring_; }
  /// s, rounded.
  [[nodiscard]] const Number& s() const { return s_; }

  /// Returns the walk that an element takes back to where it started, by which it is known; nothing if the isometry, of
  /// determinant 1 and rounded, is not near any element, or too far out.
  [[nodiscard]] std::optional<TileWalk> walk(const Isometry<Number>& element) const;
  /// The element of a walk, up to a real factor.
  [[nodiscard]] ExactElement element(const TileWalk& walk) const;
  /// Whether two pairs are real multiples of each other: the same isometry.
  [[nodiscard]] static bool same(const ExactElement& f, const ExactElement& g);

 private:
  RegularTile tile_;
  std::unique_ptr<const certify::RegularRing> ring_;  ///< Numbers point to it.
  Number s_;
};

/// The tiles of the surface of a subgroup, and paths of its generators.
struct SubgroupTiles {
  std::vector<Gluing> gluing;
  std::vector<std::vector<std::uint32_t>> paths;  ///< By walk: the numbers of the sides that it crosses.
};

/// Returns the tiles of the plane up to the subgroup that the elements of walks generate, by enumerating cosets (J. A.
/// Todd, H. S. M. Coxeter, A practical method for enumerating cosets of a finite abstract group, Proc. Edinburgh Math.
/// Soc. 5, 1936): tiles are the same if the walks, or a turn around a vertex, say so. Tile 0 is where walks start.
/// Nothing if more than 2^20 sides are needed, as for a group that is not cocompact. Throws SurfaceError if an
/// element other than 1 has a fixed point in the plane, and says whether that is in the middle of a tile, of a side, or
/// a vertex.
[[nodiscard]] std::optional<SubgroupTiles> subgroup_tiles(RegularTile tile, const std::vector<TileWalk>& walks);

}  // namespace epsnet
