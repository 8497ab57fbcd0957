#pragma once

#include <cstdint>
#include <vector>

#include "netgen/lifts/lifts.h"

namespace epsnet {

/// A Dirichlet domain that takes too long for a picture, or is not verified, although the surface is one.
class DomainNotDrawn : public NetGeometryError {
 public:
  using NetGeometryError::NetGeometryError;
};

/// The corners of the Dirichlet domain of a vertex of a net, counterclockwise, in the Poincaré disk with the vertex at
/// 0 and directions as in the vertex's chart: the Voronoi cell of one lift among all lifts of this vertex (not of the
/// others), thesis Definition I.34.
///
/// The domain is that of dirichlet_polygon, of the exact surface, so that its sides are those; its corners are
/// rounded. A vertex that is a corner of a tile is the base point exactly, any other to within 2⁻²⁵⁰ in the coordinates
/// of its tile, or 2⁻⁶⁰ on a side of one. Throws NetGeometryError if there is no such vertex, if the document's surface
/// is none; DomainNotDrawn if the domain is not verified, and beyond genus 100, where it takes too long for a picture.
[[nodiscard]] std::vector<Complex<double>> dirichlet_domain(const NetGeometry& geometry, std::uint32_t vertex);

}  // namespace epsnet
