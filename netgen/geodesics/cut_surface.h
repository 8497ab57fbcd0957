#pragma once

#include <cstdint>
#include <vector>

#include "certify/claims/geodesics/document.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// A simple closed curve passing through a triangle: it cuts off one corner.
struct CornerArc {
  std::uint32_t triangle;
  std::uint32_t corner;  ///< The one cut off,
  bool corner_is_left;   ///< on the left of the directed curve,
  std::uint32_t rank;    ///< with this many other arcs nearer to it.
};

/// The components of a surface minus pairwise disjoint simple closed curves, each given by all of its arcs: genus and
/// boundaries (curve, side), side 0 on the left. No topology but counting: arcs cut triangles into cells, cells are
/// joined across edges, and V − E + F is 2 − 2g − b for a component of genus g with b boundaries. In the order of their
/// first boundaries; without curves the one piece is the surface. O(triangles + arcs).
[[nodiscard]] std::vector<certify::GeodesicsDocument::Piece> cut_surface(
    const Triangulation& triangulation, const std::vector<std::vector<CornerArc>>& curves);

}  // namespace epsnet
