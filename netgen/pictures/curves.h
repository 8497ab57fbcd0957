#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "certify/document/geodesics_document.h"
#include "netgen/lifts/lifts.h"

/// Curves on the surface of a net, cut by its triangles, for pictures.
namespace epsnet {

/// A piece of a geodesic within one triangle, in the chart of the triangle's corner 0.
struct Arc {
  std::uint32_t triangle;
  Complex<double> from;
  Complex<double> to;
};

/// What a picture shows beside the triangulation: arcs, edges or triangles, all in one colour.
struct Layer {
  /// A closed geodesic: the arcs from `first_arc` on, up to the next part's, one after the other along it.
  struct Part {
    std::string name;
    double length;  ///< Rounded.
    std::size_t first_arc;
  };

  std::string name;
  std::string colour;  ///< "#rrggbb".
  bool on = true;      ///< Whether a viewer shows it at first.
  std::vector<Arc> arcs = {};
  std::vector<std::uint32_t> darts = {};
  std::vector<std::uint32_t> triangles = {};
  std::vector<Part> parts = {};  ///< Only of closed geodesics, one for each.
};

/// The segment from p to q, cut by the lifted triangles that it meets. `near` is a lift from which a walk finds the
/// first one; it becomes one that contains q. Throws NetGeometryError if the walk does not come to an end: the
/// triangles are no triangulation. Time linear in the number of triangles met.
[[nodiscard]] std::vector<Arc> cut_segment(const NetGeometry& geometry, Placement& near, const Complex<Mp256>& p,
                                           const Complex<Mp256>& q);

/// The sides of the tiles of the surface.
[[nodiscard]] Layer tile_layer(const NetGeometry& geometry);

/// The boundary of the Dirichlet domain of a vertex (dirichlet.h).
[[nodiscard]] Layer dirichlet_layer(const NetGeometry& geometry, std::uint32_t vertex);

/// The edges on the boundary of the combinatorial Dirichlet domain of a vertex: of the triangles lifted breadth first.
[[nodiscard]] Layer combinatorial_dirichlet_layer(const NetGeometry& geometry, std::uint32_t vertex);

/// Of a pseudo net: the triangles of its collars, and the boundaries of its ε-collars (the bananas of thesis figure
/// III.9), which these triangles do not quite fill. Nothing for other nets.
[[nodiscard]] std::vector<Layer> collar_layers(const NetGeometry& geometry);

/// Closed geodesics, once around each, of a geodesics file about the same surface, with the same net or another one,
/// each a part of the first layer, in the file's order; of a thick-thin decomposition also the boundaries of the
/// collars of the small curves. A document as certify::read_geodesics returns it. Throws NetGeometryError if the
/// surface is another one, or a word does not stand for a closed geodesic.
[[nodiscard]] std::vector<Layer> geodesics_layers(const NetGeometry& geometry,
                                                  const certify::GeodesicsDocument& geodesics);

}  // namespace epsnet
