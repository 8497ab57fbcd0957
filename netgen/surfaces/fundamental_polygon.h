#pragma once

#include <cstdint>
#include <vector>

#include "triangulation/surface/surface.h"

namespace epsnet {

/// A fundamental polygon of a surface: its tiles, laid out around tile 0 in the coordinates of tile 0. Each tile is
/// placed next to an earlier one, along a tree of crossed sides. For a surface of one tile it is that tile.
///
/// Let Γ be the group of the surface in these coordinates. The images of the polygon under Γ tile the plane. Its side
/// pairings generate Γ, and the cycles of its vertices are the relations between them (Poincaré's polygon theorem).
struct FundamentalPolygon {
  /// Side k leads from vertex k to vertex k + 1, counterclockwise. Beyond it lies γP for the polygon P; γ is the
  /// isometry of `word` (word_isometry.h), from the coordinates of tile 0 to themselves.
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
