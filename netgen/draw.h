#pragma once

#include <cstdint>
#include <string>

#include "epsnet/certify/document.h"
#include "epsnet/netgen/lifts.h"

/// Pictures of nets.
namespace epsnet {

struct DrawOptions {
  DrawOrder order = DrawOrder::weight;
  std::uint32_t centre = 0;   ///< The vertex in the centre.
  bool dirichlet = false;     ///< Also the Dirichlet domain of vertex 0.
  std::uint32_t size = 1000;  ///< Width and height in pixels, 50 to 20000.
};

/// The net as an SVG picture: the edges of one lift of every triangle as geodesic arcs, the vertices as dots, the
/// boundary circle.
///
/// Strokes and dots shrink with the hyperbolic metric towards the circle; edges and dots too small to see (a tenth of a
/// pixel) are left out, and <desc> says so. Arcs that a chord follows to within 0.01 pixel are written as chords. Equal
/// documents and options give equal bytes. Throws NetGeometryError if the document is not a net (its structure is
/// checked, its geometry is not).
[[nodiscard]] std::string draw_svg(const certify::Document& document, const DrawOptions& options = {});

}  // namespace epsnet
