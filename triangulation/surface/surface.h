#pragma once

#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "triangulation/surface/error.h"

namespace epsnet {

/// A strictly convex hyperbolic polygon in the Poincaré disk, vertices counterclockwise; side k goes from vertex k to
/// vertex k + 1.
using Tile = std::vector<Complex<Rational>>;

/// Side `side` of tile `tile` is glued to side `other_side` of tile `other_tile`, start to end.
struct Gluing {
  std::uint32_t tile;
  std::uint32_t side;
  std::uint32_t other_tile;
  std::uint32_t other_side;
  bool operator==(const Gluing&) const = default;
};

/// The regular p-gon whose interior angles are 2π/q: q of them meet at a vertex.
struct RegularTile {
  std::uint32_t p;
  std::uint32_t q;
  bool operator==(const RegularTile&) const = default;
};

/// Tiles and a gluing that are not a closed hyperbolic surface; what() names the element and the numbers.
class SurfaceError : public Error {
 public:
  using Error::Error;
};

/// A path, as the numbers of the sides that it crosses. The first is a side of the tile where the path starts.
using Word = std::vector<std::uint32_t>;

/// How sides and corners, numbered through all tiles, belong to tiles, to each other, and to vertex classes.
struct GluedSides {
  std::vector<std::uint32_t> first_side;          ///< By tile.
  std::vector<std::uint32_t> side_tile;           ///< By side.
  std::vector<std::uint32_t> partner;             ///< By side.
  std::vector<std::uint32_t> vertex_class;        ///< By corner.
  std::vector<std::uint32_t> vertex_class_sizes;  ///< By vertex class.
};

/// A closed hyperbolic surface, exact: finitely many convex tiles, each in its own coordinates, glued side to side by
/// isometries.
///
/// Sides have numbers: the sides of tile 0 in order, then those of tile 1, and so on. A surface is an immutable value.
/// Copies share its data, so copying is O(1).
class Surface {
 public:
  /// Checks everything, exactly: tiles in the disk, strictly convex, counterclockwise; a fixed-point-free pairing of
  /// all sides; paired sides of equal length; the angles around every vertex adding up to 2π, which makes the product
  /// of its crossings the identity (Poincaré's polygon theorem); connected; genus at least 2. Throws SurfaceError,
  /// which names the first element that fails. Quasi-linear in the number of digits.
  Surface(std::vector<Tile> tiles, std::vector<Gluing> gluing);
  // Copied where it could be moved from: there is no surface without data.
  Surface(const Surface&) = default;
  Surface& operator=(const Surface&) = default;
  ~Surface() = default;

  /// A map of type {p, q}: every tile is the regular p-gon with the interior angle 2π/q, centred at 0, the midpoint of
  /// side k in the direction 2πk/p, and q corners meet at every vertex. It closes up by theorem (docs/proof.md). Its
  /// coordinates are algebraic numbers: `tiles` has them rounded to 256 bits, `crossing_as` gives the crossings to any
  /// precision. Throws SurfaceError unless p and q are 3 to 10,000, 1/p + 1/q < 1/2, every side of tiles 0, 1, 2, … is
  /// glued once and not to itself, the surface is connected, and every vertex has q corners.
  [[nodiscard]] static Surface map(RegularTile tile, std::vector<Gluing> gluing);
  /// The map of one tile of type {4g, 4g}, opposite sides glued by translations: the Bolza surface for g = 2. Throws
  /// SurfaceError unless 2 ≤ g ≤ 1000.
  [[nodiscard]] static Surface regular(std::uint32_t genus);
  /// Returns what every tile is, if the surface was made by `map` or `regular`.
  [[nodiscard]] const std::optional<RegularTile>& regular_tile() const { return data_->regular_tile; }
  /// Whether the surface was made by `map` or `regular`.
  [[nodiscard]] bool is_regular() const { return regular_tile().has_value(); }
  /// Whether it could have been made by `regular`.
  [[nodiscard]] bool is_regular_polygon() const;

  /// Returns the genus, at least 2.
  [[nodiscard]] std::uint32_t genus() const { return data_->genus; }
  /// Returns a free text about the origin of the surface. It belongs to this copy alone, and is not part of the
  /// surface.
  [[nodiscard]] const std::string& about() const { return about_; }
  /// Sets the text of `about` of this copy.
  void set_about(std::string text) { about_ = std::move(text); }
  /// The polygons, each in its own coordinates.
  [[nodiscard]] const std::vector<Tile>& tiles() const { return data_->tiles; }
  /// The pairs as given to the constructor.
  [[nodiscard]] const std::vector<Gluing>& gluing() const { return data_->gluing; }

  /// The number of sides of all tiles.
  [[nodiscard]] std::uint32_t side_count() const { return static_cast<std::uint32_t>(data_->sides.partner.size()); }
  /// Returns the number of side `side` of tile `tile`.
  [[nodiscard]] std::uint32_t side_number(std::uint32_t tile, std::uint32_t side) const {
    assert(tile < tiles().size() && side < tiles()[tile].size());
    return data_->sides.first_side[tile] + side;
  }
  /// The tile that has side s.
  [[nodiscard]] std::uint32_t tile_of_side(std::uint32_t s) const {
    assert(s < side_count());
    return data_->sides.side_tile[s];
  }
  /// The side after side s, counterclockwise around its tile.
  [[nodiscard]] std::uint32_t next_side(std::uint32_t s) const {
    const std::uint32_t tile = tile_of_side(s);
    return s + 1 < side_count() && tile_of_side(s + 1) == tile ? s + 1 : side_number(tile, 0);
  }
  /// The side before side s.
  [[nodiscard]] std::uint32_t previous_side(std::uint32_t s) const {
    const std::uint32_t tile = tile_of_side(s);
    const std::uint32_t first = side_number(tile, 0);
    return s > first ? s - 1 : first + static_cast<std::uint32_t>(tiles()[tile].size()) - 1;
  }
  /// The side that side s is glued to.
  [[nodiscard]] std::uint32_t partner(std::uint32_t s) const {
    assert(s < side_count());
    return data_->sides.partner[s];
  }
  /// The isometry from the coordinates of the tile of side s to the coordinates of the tile of its partner, the start
  /// of s to the end of the partner. Its coefficients are Gaussian integers without a common integer factor. Throws
  /// std::logic_error for `is_regular` surfaces, whose crossings are not rational.
  [[nodiscard]] const Isometry<Rational>& crossing(std::uint32_t s) const;
  /// Returns `crossing` rounded to T (Mp256, Mp1024, Mp4096) and scaled to determinant 1. Works for `is_regular`
  /// surfaces too.
  template <class T>
  [[nodiscard]] Isometry<T> crossing_as(std::uint32_t s) const;

  /// Returns the vertex class of a corner: the point of the surface at that corner. Corners (tile, vertex) are numbered
  /// like the sides that start there; classes are numbered from 0 in the order of first occurrence.
  [[nodiscard]] std::uint32_t vertex_class(std::uint32_t corner) const {
    assert(corner < side_count());
    return data_->sides.vertex_class[corner];
  }
  /// Returns the number of vertex classes.
  [[nodiscard]] std::uint32_t vertex_class_count() const {
    return static_cast<std::uint32_t>(data_->sides.vertex_class_sizes.size());
  }
  /// Returns the number of corners in the vertex class of a corner.
  [[nodiscard]] std::uint32_t corners_around(std::uint32_t corner) const {
    return data_->sides.vertex_class_sizes[vertex_class(corner)];
  }
  /// Returns the corners in the vertex class of `corner`, `corner` first, clockwise around the point. Crossing side s
  /// leads to the corner at the end of its partner, which is the start of the side after the partner. Read as a word, a
  /// part of the cycle leads from the tile of its first corner to the tile of the corner after its last.
  [[nodiscard]] Word corner_cycle(std::uint32_t corner) const;

 private:
  struct Data {
    std::optional<RegularTile> regular_tile;
    std::vector<Tile> tiles;
    std::vector<Gluing> gluing;
    GluedSides sides;
    std::vector<Isometry<Rational>> crossing;
    std::uint32_t genus = 0;
  };
  explicit Surface(Data data) : data_(std::make_shared<const Data>(std::move(data))) {}
  [[nodiscard]] static Data checked(std::vector<Tile> tiles, std::vector<Gluing> gluing);

  std::shared_ptr<const Data> data_;
  std::string about_;
};

// Paths as words: combinatorics alone, nothing is evaluated.

/// The word of the reversed path.
[[nodiscard]] Word reversed(const Surface& surface, const Word& word);
/// The word of the path `first` followed by `then`, shortened (Dehn's algorithm): a crossing followed by its inverse is
/// removed, and a path that turns around a vertex takes the shorter way.
[[nodiscard]] Word concatenated(const Surface& surface, Word first, const Word& then);
/// Returns a shortest word from one tile to another. O(sides).
[[nodiscard]] Word path_between_tiles(const Surface& surface, std::uint32_t from, std::uint32_t to);
/// Whether a word is a path from one tile to another.
[[nodiscard]] bool is_path(const Surface& surface, std::uint32_t from, std::uint32_t to, const Word& word);

/// A point of a surface, in the coordinates of a tile.
struct BasePoint {
  std::uint32_t tile;
  Complex<Rational> z;
};

/// Returns a point with few digits, strictly inside a tile: near the mean of the vertices in the Klein model. Throws
/// SurfaceError if there is no such tile.
[[nodiscard]] BasePoint centre_of_tile(const Surface& surface, std::uint32_t tile);

/// Throws SurfaceError if the point is not strictly inside its tile.
void require_inside(const Surface& surface, const BasePoint& base);

}  // namespace epsnet
