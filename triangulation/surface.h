#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "triangulation/error.h"

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

/// Tiles and a gluing that are not a closed hyperbolic surface; what() names the element and the numbers.
class SurfaceError : public Error {
 public:
  using Error::Error;
};

/// A path that crosses sides, as side numbers: the first is a side of the tile where the path starts.
using Word = std::vector<std::uint32_t>;

/// A closed hyperbolic surface, exact: finitely many convex tiles, each in coordinates of its own, glued side to side
/// by isometries.
///
/// Sides have numbers: the sides of tile 0 in order, then those of tile 1, and so on. Immutable.
class Surface {
 public:
  /// Checks everything, exactly: tiles in the disk, strictly convex, counterclockwise; a fixed-point-free pairing of
  /// all sides; paired sides of equal length; the angles around every vertex adding up to 2π, which makes the product
  /// of its crossings the identity (Poincaré's polygon theorem); connected; genus at least 2. Throws SurfaceError,
  /// which names the first element that fails. Quasi-linear in the number of digits.
  Surface(std::vector<Tile> tiles, std::vector<Gluing> gluing);

  /// The regular 4g-gon with the interior angle π/2g, centred at 0, the midpoint of side k in the direction kπ/2g,
  /// opposite sides glued by translations: the Bolza surface for g = 2. It closes up by theorem (docs/proof.md). Its
  /// coordinates are algebraic numbers: `tiles` has them rounded to 256 bits, `crossing_as` gives the crossings to any
  /// precision. Throws SurfaceError unless 2 ≤ g ≤ 1000.
  [[nodiscard]] static Surface regular(std::uint32_t genus);
  [[nodiscard]] bool is_regular() const { return regular_; }

  [[nodiscard]] std::uint32_t genus() const { return genus_; }
  /// Where the surface comes from, in words; no part of what it is.
  [[nodiscard]] const std::string& about() const { return about_; }
  void set_about(std::string text) { about_ = std::move(text); }
  [[nodiscard]] const std::vector<Tile>& tiles() const { return tiles_; }
  /// The pairs as given to the constructor.
  [[nodiscard]] const std::vector<Gluing>& gluing() const { return gluing_; }

  [[nodiscard]] std::uint32_t side_count() const { return static_cast<std::uint32_t>(partner_.size()); }
  [[nodiscard]] std::uint32_t side_number(std::uint32_t tile, std::uint32_t side) const {
    return first_side_[tile] + side;
  }
  [[nodiscard]] std::uint32_t tile_of_side(std::uint32_t s) const { return side_tile_[s]; }
  /// The side that side s is glued to.
  [[nodiscard]] std::uint32_t partner(std::uint32_t s) const { return partner_[s]; }
  /// The isometry from the coordinates of the tile of side s to the coordinates of the tile of its partner, the start
  /// of s to the end of the partner. Its coefficients are Gaussian integers without a common integer factor. Not for
  /// `is_regular` surfaces.
  [[nodiscard]] const Isometry<Rational>& crossing(std::uint32_t s) const { return crossing_[s]; }
  /// The same rounded to T (Mp256, Mp1024, Mp4096), determinant 1.
  template <class T>
  [[nodiscard]] Isometry<T> crossing_as(std::uint32_t s) const;

  /// The corners (tile, vertex) are numbered like the sides that start there. `vertex_class(c)` is the point of the
  /// surface that corner c is, numbered from 0 in the order of first occurrence.
  [[nodiscard]] std::uint32_t vertex_class(std::uint32_t corner) const { return vertex_class_[corner]; }
  [[nodiscard]] std::uint32_t vertex_class_count() const {
    return static_cast<std::uint32_t>(vertex_class_sizes_.size());
  }
  /// The number of corners at the point that corner c is.
  [[nodiscard]] std::uint32_t corners_around(std::uint32_t corner) const {
    return vertex_class_sizes_[vertex_class_[corner]];
  }

 private:
  Surface() = default;

  bool regular_ = false;
  std::string about_;
  std::vector<Tile> tiles_;
  std::vector<Gluing> gluing_;
  std::vector<std::uint32_t> first_side_;
  std::vector<std::uint32_t> side_tile_;
  std::vector<std::uint32_t> partner_;
  std::vector<Isometry<Rational>> crossing_;
  std::vector<std::uint32_t> vertex_class_;
  std::vector<std::uint32_t> vertex_class_sizes_;
  std::uint32_t genus_ = 0;
};

}  // namespace epsnet
