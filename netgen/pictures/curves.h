#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "netgen/lifts/lifts.h"
#include "netgen/pictures/pictures.h"

/// Curves on the surface of a net, cut by its triangles. The functions of pictures.h that make layers, for a net
/// that is laid out already.
namespace epsnet {

/// A segment cut by the lifted triangles that it meets.
struct CutSegment {
  std::vector<Arc> arcs;  ///< Along the segment.
  Placement end;          ///< A lift that contains its end.
};

/// The segment from p to q, which may be far from each other and from 0. `near` is a lift from which a walk finds the
/// first triangle. Returns nullopt if the walk or the segment meets too many triangles: it winds around a very short
/// closed geodesic, or the triangles are no triangulation. Time linear in the number of triangles met.
[[nodiscard]] std::optional<CutSegment> cut_segment(const NetGeometry& geometry, const Placement& near,
                                                    const Complex<Mp256>& p, const Complex<Mp256>& q);

[[nodiscard]] Layer tile_layer(const NetGeometry& geometry);
[[nodiscard]] Layer dirichlet_layer(const NetGeometry& geometry, std::uint32_t vertex);
[[nodiscard]] Layer combinatorial_dirichlet_layer(const NetGeometry& geometry, std::uint32_t vertex);
[[nodiscard]] std::vector<Layer> collar_layers(const NetGeometry& geometry);
[[nodiscard]] std::vector<Layer> geodesics_layers(const NetGeometry& geometry,
                                                  const certify::GeodesicsDocument& geodesics);
[[nodiscard]] Layer distance_layer(const NetGeometry& geometry, const certify::DistanceDocument& distance);

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
