#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/geodesics/document.h"
#include "netgen/isometries/lifted_tiles.h"
#include "triangulation/surface/surface.h"

/// Where isometries are found: by pairs of elements to which an isometry may take one chosen pair, among the lifts of
/// tiles near closed geodesics (docs/isometries.md, "How all are found"); by the closed geodesics that an isometry
/// permutes; by automorphisms of maps; and what decides exactly.
namespace epsnet {

/// By how much numbers of 512 bits may differ that are equal but for the errors of some operations, relative to their
/// size, if that is more than 1.
inline constexpr double kRounding = 0x1p-100;
/// Whether two numbers differ by no more than that, or another tolerance.
[[nodiscard]] bool agree(const LiftedTiles::Number& x, const LiftedTiles::Number& y, double tolerance = kRounding);
/// Whether three are.
[[nodiscard]] bool agree(const LiftedTiles::Vector& u, const LiftedTiles::Vector& v);

/// A closed geodesic: an element in the coordinates of a tile. Re a > 0.
struct Line {
  TileId tile;
  Word word;
  Isometry<LiftedTiles::Number> element;
  LiftedTiles::Number length;

  /// The point of the axis that is `along` farther than the one next to a point.
  [[nodiscard]] LiftedTiles::Vector point(const LiftedTiles::Vector& near, const LiftedTiles::Number& along) const;
};

/// The primitive closed geodesics of a surface up to some length.
[[nodiscard]] std::vector<Line> lines(const LiftedTiles& tiles, const certify::GeodesicsDocument& document);

/// A closed geodesic x, and an element y of which the axis has no end in common with that of x.
struct Pair {
  Line x;
  Isometry<LiftedTiles::Number> y;
  Word y_word;
  double displacement;  ///< By how much y moves a point of the axis of x.
};

/// A pair of elements to which an isometry may take another pair, in the coordinates of a tile.
struct Match {
  TileId tile;
  Isometry<LiftedTiles::Number> x;
  Isometry<LiftedTiles::Number> y;
  Word x_word;
  Word y_word;
};

/// Returns the pairs (x', y') of which x', y' and x'y' have the traces of x, y and xy, to within the tolerance: x' is
/// `line` in one of its two directions, and y' moves a point of its axis by no more than y moves one of the axis of x.
/// Up to powers of x', every such pair is among them, perhaps more than once.
///
/// The result is the same for any number of threads. Throws LimitError if too many tiles are near the line.
[[nodiscard]] std::vector<Match> matches(const ElementSearch& search, const Line& line, const Pair& pair,
                                         unsigned threads, double tolerance = kRounding);

/// The generators of a surface's group.
struct Generators {
  std::vector<Word> words;
  std::vector<Isometry<LiftedTiles::Number>> elements;

  explicit Generators(const LiftedTiles& tiles);
};

/// The image of a generator's element under an isometry of the plane, as a word from tile 0 to itself; nothing, if it
/// is not in the group, to within the tolerance.
[[nodiscard]] std::optional<Word> image_word(const LiftedTiles& to, const Motion<LiftedTiles::Number>& f,
                                             const Isometry<LiftedTiles::Number>& element,
                                             double tolerance = kRounding);

/// What is common to all isometries from one surface: where they are told from.
struct Source {
  ElementSearch search;
  Generators generators;
  Pair pair;

  /// Requires: a spectrum of the surface with at least one closed geodesic. Throws LimitError.
  Source(const Surface& surface, const certify::GeodesicsDocument& geodesics);

  [[nodiscard]] const LiftedTiles& tiles() const { return search.tiles(); }

  /// The isometry of the plane that a match tells, from the coordinates of tile 0 to those of tile 0.
  [[nodiscard]] Motion<LiftedTiles::Number> motion_of(const Match& match, const LiftedTiles& to) const;

  /// The images of all generators under an isometry of the plane, as words from tile 0 to itself; nothing, if one of
  /// them is not in the group, to within the tolerance.
  [[nodiscard]] std::optional<std::vector<Word>> images(const LiftedTiles& to, const Motion<LiftedTiles::Number>& f,
                                                        double tolerance = kRounding) const;

  /// Whether an isometry that agrees with the numbers is one: exactly.
  [[nodiscard]] std::optional<bool> is_exact(const Match& match, const LiftedTiles& to,
                                             const std::vector<Word>& images) const;
};

/// The isometries that generate a group, as isometries of the plane in the coordinates of tile 0.
struct IsometryLifts {
  Source source;
  std::vector<Motion<LiftedTiles::Number>> generators;

  [[nodiscard]] const LiftedTiles& tiles() const { return source.tiles(); }

  /// The same isometry of the surface, but one that moves the middle of tile 0 not far.
  [[nodiscard]] Motion<LiftedTiles::Number> near(const Motion<LiftedTiles::Number>& f) const;
};

/// Closed geodesics by the tiles that they cross, to find the one on which the image of another one lies.
///
/// Numbers have 512 bits. What is found is right to 100 of them; a line may not be found, if a point of it is a corner
/// of tiles.
class LinePlaces {
 public:
  /// Requires: the tiles live as long. O(tiles crossed × sides of a tile).
  LinePlaces(const LiftedTiles& tiles, const std::vector<Line>& lines);

  /// Returns the number of the line to which an isometry, from the coordinates of tile 0 to themselves, takes line i;
  /// nothing, if it is not found.
  [[nodiscard]] std::optional<std::uint32_t> image(const Motion<LiftedTiles::Number>& f, std::uint32_t i) const;

 private:
  using Vector = LiftedTiles::Vector;
  /// A line in the coordinates of a tile that it crosses.
  struct Place {
    TileId tile;
    Vector normal;  ///< Of length 1.
    Vector point;   ///< Inside of the tile, or of one of its sides.
  };

  void follow(const Line& line, std::uint32_t number);
  void add(TileId tile, const Vector& normal, std::uint32_t number);
  [[nodiscard]] std::optional<std::uint32_t> find(TileId tile, const Vector& normal) const;

  const LiftedTiles& tiles_;
  ById<TileId, Word> from_tile_0_;
  std::vector<Place> middle_;  ///< By line: of its longest part in a tile.
  struct Known {
    Vector normal;
    std::uint32_t line;
  };
  std::map<TileId, std::multimap<double, Known>> known_;  ///< By tile and |x| of the normal.
};

// The automorphisms of a map of regular tiles, by combinatorics alone. They are isometries of its surface: tiles are
// congruent, and a tile is determined by one of its sides.

/// An isometry of a surface that takes tiles to tiles.
struct MapAutomorphism {
  bool preserves_orientation;
  ById<SideId, SideId> image;  ///< By side.
};

/// Returns automorphisms that generate all; none for a surface without regular tiles. O(sides) for each one, and for
/// each side where side 0 is not taken, as far as the map looks the same from there.
[[nodiscard]] std::vector<MapAutomorphism> map_automorphisms(const Surface& surface);

/// The image of a path.
[[nodiscard]] Word image_of(const MapAutomorphism& automorphism, const Word& word);
/// The image of a tile.
[[nodiscard]] TileId image_of(const Surface& surface, const MapAutomorphism& automorphism, TileId tile);

// Questions about elements of groups of surfaces, answered without rounding (docs/isometries.md, "Why finitely many
// products decide"). Elements are given by words from tile 0 to itself, and all but 1 are hyperbolic.

/// An element of the group of one surface, and one of another.
struct ElementPair {
  Word from;
  Word to;
};

/// Whether there is an isometry f of the plane with f ∘ x ∘ f⁻¹ = x' for the elements x of all pairs and their partners
/// x'. Nothing, if their numbers are too large, or in a field of a degree above 64.
///
/// Requires: two pairs or more; the first two `from` have no end of their axes in common.
[[nodiscard]] std::optional<bool> are_conjugate(const Surface& first, const Surface& second,
                                                std::span<const ElementPair> pairs);

/// Whether the axes of two elements other than 1 cross. Nothing, if their numbers are too large.
[[nodiscard]] std::optional<bool> axes_cross(const Surface& surface, const Word& first, const Word& second);

}  // namespace epsnet
