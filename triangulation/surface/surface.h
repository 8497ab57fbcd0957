#pragma once

#include <cassert>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/error.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"

namespace epsnet {

// Errors.

/// The base class of the library's exceptions for tasks that cannot be done: invalid input, files that cannot be read
/// or written, nets that are not found. what() gives the reason, and a program ends with that text.
class Error : public certify::LocatedError {
 public:
  using LocatedError::LocatedError;
};

/// A surface or a triangulation is beyond a limit: too many triangles or labels, a path too long to be evaluated.
class LimitError : public Error {
 public:
  using Error::Error;
};

/// A file could not be written. what() is one line: the path and the reason ("No space left on device").
class WriteError : public Error {
 public:
  using Error::Error;
};

/// Vertices and triangles are not a triangulation; what() names the first wrong element.
class TriangulationError : public Error {
 public:
  using Error::Error;
};

// Numbers of tiles, sides, charts, vertices and triangles as distinct types, so that none can stand for another.

/// The number of one of the things that are of this kind, counted from 0. Converted from and to integers explicitly.
template <class Kind>
class Id {
 public:
  Id() = default;
  /// The id with a number. Requires: 0 ≤ number < 2^32.
  constexpr explicit Id(std::integral auto number) : number_(static_cast<std::uint32_t>(number)) {
    assert(std::in_range<std::uint32_t>(number));
  }

  /// The number.
  [[nodiscard]] constexpr std::uint32_t number() const { return number_; }
  constexpr Id& operator++() {
    ++number_;
    return *this;
  }
  friend constexpr auto operator<=>(Id, Id) = default;

 private:
  std::uint32_t number_;
};

/// The number, for messages.
template <class Kind>
[[nodiscard]] std::string to_string(Id<Kind> id) {
  return std::to_string(id.number());
}

/// The number of a tile of a surface.
using TileId = Id<struct TileKind>;
/// The number of a side of a tile, through all tiles of a surface; also that of the corner where the side starts.
using SideId = Id<struct SideKind>;
/// The number of a chart in an atlas.
using ChartId = Id<struct ChartKind>;
/// The number of a vertex in a triangulation.
using VertexId = Id<struct VertexKind>;
/// The number of a triangle in a triangulation.
using TriangleId = Id<struct TriangleKind>;

/// Successive numbers, in order: what a range-based for loop needs.
template <class I>
class Ids {
 public:
  /// Points to an id.
  class Iterator {
   public:
    /// Points to this id.
    constexpr explicit Iterator(I id) : id_(id) {}
    [[nodiscard]] constexpr I operator*() const { return id_; }
    constexpr Iterator& operator++() {
      ++id_;
      return *this;
    }
    friend constexpr bool operator==(Iterator, Iterator) = default;

   private:
    I id_;
  };

  /// The numbers less than `count`.
  constexpr explicit Ids(std::uint32_t count) : Ids(I(0), count) {}
  /// `count` numbers, from this one on.
  constexpr Ids(I first, std::uint32_t count) : first_(first), count_(count) {}
  /// The first number.
  [[nodiscard]] constexpr Iterator begin() const { return Iterator(first_); }
  /// Behind the last number.
  [[nodiscard]] constexpr Iterator end() const { return Iterator(I(first_.number() + count_)); }

 private:
  I first_;
  std::uint32_t count_;
};

/// A vector whose elements are those of these numbers.
template <class I, class T>
class ById : public std::vector<T> {
 public:
  using std::vector<T>::vector;
  [[nodiscard]] decltype(auto) operator[](I id) { return std::vector<T>::operator[](id.number()); }
  [[nodiscard]] decltype(auto) operator[](I id) const { return std::vector<T>::operator[](id.number()); }
  /// All numbers of elements.
  [[nodiscard]] Ids<I> ids() const { return Ids<I>(static_cast<std::uint32_t>(this->size())); }
  /// The number of the next element that is added.
  [[nodiscard]] I end_id() const { return I(this->size()); }
};

// Surfaces.

/// A strictly convex hyperbolic polygon in the Poincaré disk, vertices counterclockwise; side k goes from vertex k to
/// vertex k + 1.
using Tile = std::vector<Complex<Rational>>;

/// Side `side` of tile `tile` is glued to side `other_side` of tile `other_tile`, start to end. Nothing is known of
/// these numbers until a surface is made of them.
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

/// Tiles over a number field, exactly; netgen/surfaces/exact_isometries.h knows them.
struct FieldTiles;

/// Tiles and a gluing that are not a closed hyperbolic surface; what() names the element and the numbers.
class SurfaceError : public Error {
 public:
  using Error::Error;
};

/// A path, as the sides that it crosses. The first is a side of the tile where the path starts.
using Word = std::vector<SideId>;

/// The word of which a file has these letters. Requires nothing of them: is_path says whether the word is a path.
[[nodiscard]] Word word_of_letters(const std::vector<std::uint32_t>& letters);
/// The letters of a word, as files have them.
[[nodiscard]] std::vector<std::uint32_t> letters_of(const Word& word);

/// How sides and corners, numbered through all tiles, belong to tiles, to each other, and to vertex classes.
struct GluedSides {
  ById<TileId, SideId> first_side;
  ById<SideId, TileId> side_tile;
  ById<SideId, SideId> partner;
  ById<SideId, std::uint32_t> vertex_class;       ///< By corner.
  std::vector<std::uint32_t> vertex_class_sizes;  ///< By vertex class.

  /// The side after side s, counterclockwise around its tile.
  [[nodiscard]] SideId next(SideId s) const {
    const SideId after(s.number() + 1);
    return after != side_tile.end_id() && side_tile[after] == side_tile[s] ? after : first_side[side_tile[s]];
  }
  /// The side before side s.
  [[nodiscard]] SideId previous(SideId s) const {
    if (s != first_side[side_tile[s]]) return SideId(s.number() - 1);
    const TileId after(side_tile[s].number() + 1);
    return SideId((after != first_side.end_id() ? first_side[after] : side_tile.end_id()).number() - 1);
  }
  /// Returns k for side k of a tile.
  [[nodiscard]] std::uint32_t place_in_tile(SideId s) const { return s.number() - first_side[side_tile[s]].number(); }
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

  /// A surface whose tiles have corners over a number field: from their corners rounded to 256 bits, and the crossings,
  /// by side, rounded to the precision of Mp4096. Requires: tiles of a closed surface (`surface_over_field` of
  /// netgen/surfaces examines them). Throws SurfaceError for tiles whose rounded corners are not convex, and for what
  /// `map` throws it for.
  [[nodiscard]] static Surface over_field(std::shared_ptr<const FieldTiles> exact, std::vector<Tile> tiles,
                                          std::vector<Gluing> gluing, ById<SideId, Isometry<Mp4096>> crossings);
  /// Returns the tiles exactly, if the surface was made by `over_field`, else nullptr.
  [[nodiscard]] const std::shared_ptr<const FieldTiles>& field_tiles() const { return data_->field_tiles; }
  /// Whether corners and crossings are rational: neither `is_regular` nor over a number field.
  [[nodiscard]] bool is_rational() const { return !is_regular() && !field_tiles(); }

  /// Returns the genus, at least 2.
  [[nodiscard]] std::uint32_t genus() const { return data_->genus; }
  /// Returns a free text about the origin of the surface. It belongs to this copy alone, and is not part of the
  /// surface.
  [[nodiscard]] const std::string& about() const { return about_; }
  /// Sets the text of `about` of this copy.
  void set_about(std::string text) { about_ = std::move(text); }
  /// The polygons, each in its own coordinates.
  [[nodiscard]] const std::vector<Tile>& tiles() const { return data_->tiles; }
  /// A polygon, in its own coordinates.
  [[nodiscard]] const Tile& tile(TileId t) const {
    assert(t.number() < tiles().size());
    return tiles()[t.number()];
  }
  /// The numbers of all tiles.
  [[nodiscard]] Ids<TileId> tile_ids() const { return data_->sides.first_side.ids(); }
  /// The pairs as given to the constructor.
  [[nodiscard]] const std::vector<Gluing>& gluing() const { return data_->gluing; }

  /// The number of sides of all tiles.
  [[nodiscard]] std::uint32_t side_count() const { return static_cast<std::uint32_t>(data_->sides.partner.size()); }
  /// The numbers of all sides.
  [[nodiscard]] Ids<SideId> side_ids() const { return data_->sides.partner.ids(); }
  /// The numbers of the sides of a tile.
  [[nodiscard]] Ids<SideId> sides_of(TileId t) const {
    return Ids<SideId>(side_number(t, 0), static_cast<std::uint32_t>(tile(t).size()));
  }
  /// Returns the number of side k of a tile.
  [[nodiscard]] SideId side_number(TileId t, std::uint32_t k) const {
    assert(t.number() < tiles().size() && k < tiles()[t.number()].size());
    return SideId(data_->sides.first_side[t].number() + k);
  }
  /// The tile that has side s.
  [[nodiscard]] TileId tile_of_side(SideId s) const {
    assert(s.number() < side_count());
    return data_->sides.side_tile[s];
  }
  /// Returns k for side k of a tile.
  [[nodiscard]] std::uint32_t place_in_tile(SideId s) const {
    assert(s.number() < side_count());
    return data_->sides.place_in_tile(s);
  }
  /// The side after side s, counterclockwise around its tile.
  [[nodiscard]] SideId next_side(SideId s) const {
    assert(s.number() < side_count());
    return data_->sides.next(s);
  }
  /// The side before side s.
  [[nodiscard]] SideId previous_side(SideId s) const {
    assert(s.number() < side_count());
    return data_->sides.previous(s);
  }
  /// The side that side s is glued to.
  [[nodiscard]] SideId partner(SideId s) const {
    assert(s.number() < side_count());
    return data_->sides.partner[s];
  }
  /// The isometry from the coordinates of the tile of side s to the coordinates of the tile of its partner, the start
  /// of s to the end of the partner. Its coefficients are Gaussian integers without a common integer factor. Throws
  /// std::logic_error unless the surface `is_rational`.
  [[nodiscard]] const Isometry<Rational>& crossing(SideId s) const;
  /// Returns `crossing` rounded to T (Mp256, Mp1024, Mp4096) and scaled to determinant 1. Works for all surfaces.
  template <class T>
  [[nodiscard]] Isometry<T> crossing_as(SideId s) const;

  /// Returns the vertex class of a corner: the point of the surface at that corner. Corners (tile, vertex) are numbered
  /// like the sides that start there; classes are numbered from 0 in the order of first occurrence.
  [[nodiscard]] std::uint32_t vertex_class(SideId corner) const {
    assert(corner.number() < side_count());
    return data_->sides.vertex_class[corner];
  }
  /// Returns the number of vertex classes.
  [[nodiscard]] std::uint32_t vertex_class_count() const {
    return static_cast<std::uint32_t>(data_->sides.vertex_class_sizes.size());
  }
  /// Returns the number of corners in the vertex class of a corner.
  [[nodiscard]] std::uint32_t corners_around(SideId corner) const {
    return data_->sides.vertex_class_sizes[vertex_class(corner)];
  }
  /// Returns the corners in the vertex class of `corner`, `corner` first, clockwise around the point. Crossing side s
  /// leads to the corner at the end of its partner, which is the start of the side after the partner. Read as a word, a
  /// part of the cycle leads from the tile of its first corner to the tile of the corner after its last.
  [[nodiscard]] Word corner_cycle(SideId corner) const;

 private:
  struct Data {
    std::optional<RegularTile> regular_tile;
    std::vector<Tile> tiles;
    std::vector<Gluing> gluing;
    GluedSides sides;
    ById<SideId, Isometry<Rational>> crossing;
    std::shared_ptr<const FieldTiles> field_tiles;
    ById<SideId, Isometry<Mp4096>> field_crossing;
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
/// removed, and a path that turns around a vertex takes the shorter way. Of more than 64 letters, a path along a row of
/// tiles beside which there is a shorter row takes that one, if three tiles meet at every vertex between.
[[nodiscard]] Word concatenated(const Surface& surface, Word first, const Word& then);
/// Returns a shortest word from one tile to another. O(sides).
[[nodiscard]] Word path_between_tiles(const Surface& surface, TileId from, TileId to);
/// Whether a word is a path from one tile to another.
[[nodiscard]] bool is_path(const Surface& surface, TileId from, TileId to, const Word& word);
/// Why a word is not a path from some tile to itself: its first letter that is none; nothing if it is one.
[[nodiscard]] std::optional<std::string> closed_path_problem(const Surface& surface, const Word& word);

/// A point of a surface, in the coordinates of a tile.
struct BasePoint {
  TileId tile;
  Complex<Rational> z;
};

/// Returns a point with few digits, strictly inside a tile: near the mean of the vertices in the Klein model. Throws
/// SurfaceError if there is no such tile.
[[nodiscard]] BasePoint centre_of_tile(const Surface& surface, TileId tile);

/// Throws SurfaceError if the point is not strictly inside its tile.
void require_inside(const Surface& surface, const BasePoint& base);

// Points wherever in the disk of a tile they are given: beyond a side the tile's disk goes on with the neighbours.

/// Throws SurfaceError unless the surface has the tile and the coordinates are in its disk.
void require_on_surface(const Surface& surface, const BasePoint& point);

/// Returns the same point of the surface in a closed tile that contains it: the point as given if its own tile does.
/// Exact. Unless the surface `is_rational`, every point is returned as given. Throws SurfaceError if it is no point of
/// the surface, or more than 10,000 tiles away from its own.
[[nodiscard]] BasePoint in_its_tile(const Surface& surface, const BasePoint& point);

/// Returns whether two points are the same point of the surface, on sides and corners of tiles too. Exact; of a regular
/// surface only equal coordinates are known to be. Throws as in_its_tile.
[[nodiscard]] bool is_same_point(const Surface& surface, const BasePoint& p, const BasePoint& q);

}  // namespace epsnet

/// \cond Doxygen does not know the namespace std.
/// The hash of the number.
template <class Kind>
struct std::hash<epsnet::Id<Kind>> {
  [[nodiscard]] std::size_t operator()(epsnet::Id<Kind> id) const noexcept {
    return std::hash<std::uint32_t>{}(id.number());
  }
};
/// \endcond
