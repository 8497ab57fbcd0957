#pragma once

#include <cstdint>
#include <string>

#include "certify/net/document.h"
#include "netgen/base/json_text.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/surface.h"

/// The contents of a file, for people and for programs. Nothing here is proved: numbers are computed in floating point
/// and rounded to nearest, and are no bounds. Intervals that a file claims are printed rounded outward.
namespace epsnet {

/// The same facts in two forms.
struct Facts {
  std::string text;  ///< "name: value" lines, six digits.
  Json json;         ///< An object, digits that round-trip (docs/exchange-formats.md).
};

/// Returns facts about a surface: genus, tiles, sides, vertices, the size of the coordinates, area, perimeter. `kind`
/// is the kind of file it is from.
[[nodiscard]] Facts surface_info(const Surface& surface, const std::string& kind = "surface");

/// Returns facts about a net: ε, counts beside the thesis' bounds, charts, labels, edges, circumradii, and the bounds
/// of the systole that follow from its loops if the net is verified. Lengths are hyperbolic. Throws NetGeometryError if
/// the document is not a net. O(triangles).
[[nodiscard]] Facts net_info(const certify::NetDocument& net);

/// Returns facts about a Dirichlet domain: its sides, and their distances and those of its vertices from the base
/// point.
[[nodiscard]] Facts dirichlet_info(const DirichletPolygon& polygon);

}  // namespace epsnet
