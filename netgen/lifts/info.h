#pragma once

#include <cstdint>
#include <string>

#include "certify/net/document.h"
#include "netgen/base/json_text.h"
#include "netgen/nets/dirichlet_polygon.h"
#include "triangulation/surface/surface.h"

/// What is in a file, for people and for programs. Nothing here is proved: numbers are computed in floating point and
/// rounded to nearest, and are no bounds. Intervals that a file claims are printed outward.
namespace epsnet {

/// The same facts twice.
struct Facts {
  std::string text;  ///< "name: value" lines, six digits.
  Json json;         ///< An object, digits that round-trip (docs/exchange-formats.md).
};

/// About a surface: genus, tiles, sides, vertices, the size of the coordinates, area, perimeter. `kind` says what file
/// it is from.
[[nodiscard]] Facts surface_info(const Surface& surface, const std::string& kind = "surface");

/// About a net: ε, counts against the thesis' bounds, charts, labels, edges, circumradii, and what
/// the loops among the edges say about the systole if the net is verified. Lengths are hyperbolic. Throws
/// NetGeometryError if the document is not a net. O(triangles).
[[nodiscard]] Facts net_info(const certify::NetDocument& net);

/// About a Dirichlet domain: its sides, how far they and its vertices are from the base point.
[[nodiscard]] Facts dirichlet_info(const DirichletPolygon& polygon);

}  // namespace epsnet
