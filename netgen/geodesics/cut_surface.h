#pragma once

#include <cstdint>
#include <vector>

#include "certify/claims/geodesics/document.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// A simple closed curve passing through a triangle: it cuts off one corner.
struct CornerArc {
  TriangleId triangle;
  std::uint32_t corner;  ///< The corner cut off.
  bool corner_is_left;   ///< Whether it is on the left of the directed curve.
  std::uint32_t rank;    ///< How many other arcs are nearer to it.
};

/// Returns the components of a surface minus pairwise disjoint simple closed curves, each given by all of its arcs:
/// their genus and boundaries (curve, side), side 0 on the left. The method only counts: arcs cut triangles into cells,
/// cells are joined across edges, and V − E + F is 2 − 2g − b for a component of genus g with b boundaries. The pieces
/// are in the order of their first boundaries; without curves the only piece is the surface. O(triangles + arcs).
[[nodiscard]] std::vector<certify::GeodesicsDocument::Piece> cut_surface(
    const Triangulation& triangulation, const std::vector<std::vector<CornerArc>>& curves);

}  // namespace epsnet
