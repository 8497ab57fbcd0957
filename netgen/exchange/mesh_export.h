#pragma once

#include <iosfwd>

#include "certify/document/document.h"

/// Nets in the formats of other programs (docs/exchange-formats.md), rounded to binary64: nothing here is proved. All
/// throw NetGeometryError if the document is not a net, take O(n log n) time, and write equal bytes for equal
/// documents.
namespace epsnet {

/// OFF: one lift of every triangle, as `epsnet draw` draws them, in the plane z = 0.
void write_off(const certify::NetDocument& net, std::ostream& out);

/// VTK's XML format of unstructured grids, as text: the same lifts, with the circumradius and the number of every
/// triangle and the number of every vertex.
void write_vtu(const certify::NetDocument& net, std::ostream& out);

/// Tab-separated lines "u v length": the edges of the surface with their hyperbolic lengths, in the order of their
/// first darts. Loops and parallel edges are there, too.
void write_edges(const certify::NetDocument& net, std::ostream& out);

/// A JSON object with the lifts, the isometries that glue their sides, and the labels.
void write_mesh_json(const certify::NetDocument& net, std::ostream& out);

}  // namespace epsnet
