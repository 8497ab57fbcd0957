#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "epsnet/certify/document.h"
#include "epsnet/netgen/net_geometry.h"

/// Pictures of nets.
namespace epsnet {

/// The order in which triangles get their lift (thesis IV.5).
enum class DrawOrder {
  weight,  ///< Next the triangle across the edge uv of least |u|² + |v|²: looks like the Dirichlet domain (figure
           ///< IV.9).
  breadth_first,  ///< By the number of edges crossed: the combinatorial Dirichlet domain (figure IV.10, bottom).
};

struct DrawOptions {
  DrawOrder order = DrawOrder::weight;
  bool dirichlet = false;     ///< Also the Dirichlet domain of vertex 0.
  std::uint32_t size = 1000;  ///< Width and height in pixels, 50 to 20000.
};

/// One lift of every triangle of a net in the Poincaré disk, connected, with vertex 0 of the document in the centre.
struct Lifts {
  struct LiftedTriangle {
    std::uint32_t triangle;
    std::array<Complex<double>, 3> corner;
  };
  std::vector<LiftedTriangle> lifted;  ///< In the order of lifting.
  std::vector<std::uint32_t> place;    ///< By triangle: its index in `lifted`.
};

/// Lifts all triangles. The directions at the centre are those of vertex 0's chart, so drawings of nets of one surface
/// that start with the same vertex match. Each lift is as accurate as its labels: products along the way are taken with
/// 256 bits and rounded once. Throws NetGeometryError if the triangles are not connected, or a corner is not in the
/// disk. O(n log n) by weight, else O(n).
[[nodiscard]] Lifts lift_triangles(const NetGeometry& geometry, DrawOrder order);

/// The net as an SVG picture: the edges of one lift of every triangle as geodesic arcs, the vertices as dots, the
/// boundary circle.
///
/// Strokes and dots shrink with the hyperbolic metric towards the circle; edges and dots too small to see (a tenth of a
/// pixel) are left out, and <desc> says so. Arcs that a chord follows to within 0.01 pixel are written as chords. Equal
/// documents and options give equal bytes. Throws NetGeometryError if the document is not a net (its structure is
/// checked, its geometry is not).
[[nodiscard]] std::string draw_svg(const certify::Document& document, const DrawOptions& options = {});

}  // namespace epsnet
