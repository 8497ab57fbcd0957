#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "certify/document/document.h"
#include "netgen/lifts/lifts.h"
#include "netgen/pictures/curves.h"

/// Pictures of nets.
namespace epsnet {

/// What the triangles of a picture are filled with.
enum class Colouring {
  none,
  circumradius,  ///< From pale, ε/2 or less, to dark, ε.
  chart,         ///< By the chart of the triangle: where in the net file's coordinates it lies.
};

struct DrawOptions {
  DrawOrder order = DrawOrder::weight;
  std::uint32_t centre = 0;  ///< The vertex in the centre.
  bool triangles = true;     ///< The edges of the triangles.
  bool vertices = true;
  bool dirichlet = false;                ///< The Dirichlet domain of the centre.
  bool combinatorial_dirichlet = false;  ///< The outline of the triangles lifted breadth first from the centre.
  bool covering_disks = false;           ///< Disks of radius ε around the vertices: they cover the surface.
  bool packing_disks = false;            ///< Disks of radius ε/2: they do not overlap.
  Colouring colouring = Colouring::none;
  bool legend = false;
  std::vector<Layer> layers = {};  ///< Drawn on top, within the lifts of the triangles.
  std::uint32_t size = 1000;       ///< Width and height in pixels, 50 to 20000.
};

/// The net as an SVG picture: the edges of one lift of every triangle as geodesic arcs, the vertices as dots, the
/// boundary circle, on white.
///
/// Strokes and dots shrink with the hyperbolic metric towards the circle; edges and dots too small to see (a tenth of a
/// pixel) are left out, and `<desc>` says so. Arcs that a chord follows to within 0.01 pixel are written as chords. Equal
/// documents and options give equal bytes. Throws NetGeometryError if the document is not a net (its structure is
/// checked, its geometry is not).
[[nodiscard]] std::string draw_svg(const certify::NetDocument& document, const DrawOptions& options = {});

}  // namespace epsnet
