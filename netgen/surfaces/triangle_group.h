#pragma once

#include <array>
#include <cstdint>
#include <gmpxx.h>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/numbers/regular_number.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "netgen/surfaces/group.h"
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

// The real numbers of the ring of a triangle group, as texts, and matrices of them.

/// A number of the ring, divided by an integer: exactly, and rounded.
struct RingNumber {
  certify::RegularNumber numerator;
  mpz_class denominator;
  TriangleGroup::Number rounded;
};

/// Reads a real number of the ring: sums, differences and products of integers, fractions, sqrt(x), cos(a*pi/b),
/// sin(a*pi/b) and s, with parentheses and division by rational numbers, as in "(1+sqrt(2))/2-s*cos(pi/8)". Throws
/// SurfaceError, which says what is wrong, or which number is not in the ring.
[[nodiscard]] RingNumber parse_ring_number(std::string_view text, const TriangleGroup& group);

/// Texts of real numbers that parse_ring_number reads, up to a common positive integer factor. Requires: the degrees
/// of the numbers are less than half of the order.
[[nodiscard]] std::vector<std::string> field_texts(const std::vector<certify::RegularNumber>& numbers);

/// Texts for 2cos(2π/n) with the order n of a ring, and for its s.
struct RingGenerators {
  std::string cosine;
  std::string s;
};

/// The numbers that generate the real numbers of a ring, as texts that NumberFieldReader reads.
[[nodiscard]] RingGenerators generator_texts(const certify::RegularRing& ring);

/// Real numbers of a ring as polynomials in its generators, texts that NumberFieldReader reads; up to a common positive
/// factor. Requires: as field_texts.
[[nodiscard]] std::vector<std::string> number_texts(const std::vector<certify::RegularNumber>& numbers,
                                                    const RingGenerators& generators);

/// The isometry of the disk of a matrix with these numbers, as its text has them, up to scale. w = (z − i)/(z + i)
/// takes the half-plane to the disk.
template <class T>
[[nodiscard]] Isometry<T> isometry_of_entries(const std::array<T, 4>& e, MatrixModel model) {
  if (model == MatrixModel::su11) return {{e[0], e[1]}, {e[2], e[3]}};
  return {{T(e[0] + e[3]), T(e[1] - e[2])}, {T(e[0] - e[3]), T(-e[1] - e[2])}};
}

/// surface_of_matrices for matrices in the ring of a triangle group: `matrices.tile` is there. Throws likewise.
[[nodiscard]] MatrixSurface surface_of_field_matrices(const MatrixGenerators& matrices);

}  // namespace epsnet
