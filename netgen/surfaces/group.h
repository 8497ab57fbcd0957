#pragma once

#include <cstdint>
#include <vector>

#include "kernel/isometry.h"
#include "kernel/numbers.h"
#include "triangulation/surface/surface.h"

/// The group of a surface: words as isometries, exactly and enclosed to any precision; the fundamental polygon, whose
/// side pairings generate it.
namespace epsnet {

/// An interval with rational ends that contains a number.
struct EnclosedNumber {
  Rational lower;
  Rational upper;
};

/// Enclosures of the real and imaginary parts of an isometry (a, b) of determinant |a|² − |b|² = 1. Two such pairs
/// exist, (a, b) and (−a, −b); this is one of them.
struct EnclosedIsometry {
  EnclosedNumber a_re;
  EnclosedNumber a_im;
  EnclosedNumber b_re;
  EnclosedNumber b_im;
};

/// The most bits that a caller may request of an enclosure.
inline constexpr unsigned kMostEnclosureBits = 1U << 20;

/// Returns the isometry of a word, from the coordinates of the tile where the path starts to those of the tile where it
/// ends. It is the product of the crossings of its letters, the first one applied first. (a, b) are Gaussian integers
/// without a common integer factor. Throws SurfaceError if the word is not a path, and for `is_regular` surfaces, whose
/// crossings are not rational. Quasi-linear in the number of digits of the result.
[[nodiscard]] Isometry<Rational> exact_isometry(const Surface& surface, const Word& word);

/// Returns that isometry scaled to determinant 1, in intervals of width at most 2^−bits·|a|. Ball arithmetic (Arb)
/// proves them, for every surface. The ends are dyadic. Throws SurfaceError if the word is not a path,
/// std::invalid_argument beyond kMostEnclosureBits. Linear in the letters of the word, at fixed precision.
[[nodiscard]] EnclosedIsometry enclosed_isometry(const Surface& surface, const Word& word, unsigned bits);

/// The sides of a fundamental polygon, without coordinates. O(sides) but for the words of paths.
struct PolygonSides {
  std::vector<std::uint32_t> side;     ///< By side of the polygon, counterclockwise: its number on the surface.
  std::vector<std::uint32_t> partner;  ///< By side of the polygon: the one that it is glued to.
  std::vector<std::vector<std::uint32_t>> relations;  ///< As in FundamentalPolygon.
};

/// Returns the sides of fundamental_polygon(surface). Every other side of the surface lies inside of the polygon.
[[nodiscard]] PolygonSides polygon_sides(const Surface& surface);

/// Returns by tile the path from tile 0 to it along the tree of fundamental_polygon(surface).
[[nodiscard]] std::vector<Word> polygon_paths(const Surface& surface);

/// A fundamental polygon of a surface: its tiles, laid out around tile 0 in the coordinates of tile 0. Each tile is
/// placed next to an earlier one, along a tree of crossed sides. For a surface of one tile it is that tile.
///
/// Let Γ be the group of the surface in these coordinates. The images of the polygon under Γ tile the plane. Its side
/// pairings generate Γ, and the cycles of its vertices are the relations between them (Poincaré's polygon theorem).
struct FundamentalPolygon {
  /// Side k leads from vertex k to vertex k + 1, counterclockwise. Beyond it lies γP for the polygon P; γ is the
  /// isometry of `word` (exact_isometry), from the coordinates of tile 0 to themselves.
  struct Side {
    Word word;
    std::uint32_t partner;  ///< The side to which γ⁻¹ takes this one, end to start.
    std::uint32_t side;     ///< The number of this side on the surface.
  };
  std::vector<Side> sides;
  /// vertices[k] is the start of side k. Exact; for a regular surface rounded to 256 bits.
  std::vector<Complex<Rational>> vertices;
  /// One relation for each vertex of the surface that is a vertex of the polygon: the sides k₁, k₂, … crossed clockwise
  /// around it, in order. Their isometries have the product γ₁γ₂… = 1.
  std::vector<std::vector<std::uint32_t>> relations;
};

/// Returns the fundamental polygon that a breadth-first search of the tiles gives. Two neighbouring sides that are
/// paired with each other are removed, as the vertex between them is an interior point. Time and size are those of the
/// exact coordinates, whose digits grow with the distance of a tile from tile 0.
[[nodiscard]] FundamentalPolygon fundamental_polygon(const Surface& surface);

}  // namespace epsnet
