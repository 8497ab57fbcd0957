#pragma once

#include <cstdint>
#include <vector>

#include "triangulation/surface.h"

namespace epsnet {

/// A fundamental polygon of a surface: its tiles, laid out around tile 0 along a tree of sides that are crossed, in the
/// coordinates of tile 0. For a surface of one tile it is that tile.
///
/// Copies of it by the group Γ of the surface, written in these coordinates, fill the plane once: its side pairings
/// generate Γ, and the cycles of its vertices are the relations between them (Poincaré's polygon theorem).
struct FundamentalPolygon {
  /// Side k leads from vertex k to vertex k + 1, counterclockwise. Beyond it lies γP for the polygon P; γ is the
  /// isometry of `word` (word_isometry.h), from the coordinates of tile 0 to themselves.
  struct Side {
    Word word;
    std::uint32_t partner;  ///< The side to which γ⁻¹ takes this one, end to start.
    std::uint32_t side;     ///< The side of the surface that it is.
  };
  std::vector<Side> sides;
  /// By side, its start. Exact; of a regular surface rounded to 256 bits.
  std::vector<Complex<Rational>> vertices;
  /// By vertex of the surface that is one of the polygon's: sides k₁, k₂, … whose γ have the product γ₁γ₂… = 1, in the
  /// order in which they are crossed clockwise around it.
  std::vector<std::vector<std::uint32_t>> relations;
};

/// The tiles are reached breadth first. Two neighbouring sides that are paired with each other have a vertex between
/// them that lies inside; they are left out. Time and size are that of the exact coordinates, whose digits grow with
/// the distance of a tile from tile 0.
[[nodiscard]] FundamentalPolygon fundamental_polygon(const Surface& surface);

}  // namespace epsnet
