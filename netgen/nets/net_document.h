#pragma once

#include "certify/net/document.h"
#include "netgen/base/options.h"
#include "triangulation/mesh/triangulation.h"

/// Conversion between triangulations and the plain data of net files.
namespace epsnet {

/// Returns the number of a triangulation's dart in a net file.
[[nodiscard]] constexpr std::uint32_t document_dart(Dart d) { return 3 * triangle_of(d).number() + corner_of(d); }
/// Returns the triangulation's dart with a number of a net file.
[[nodiscard]] constexpr Dart triangulation_dart(std::uint32_t d) { return make_dart(TriangleId(d / 3), d % 3); }

/// Returns a triangulation as the plain data of a net file, without unused charts and labels. O(size).
[[nodiscard]] certify::NetDocument net_document(const Triangulation& triangulation, const Length& epsilon);

/// Returns the triangulation that a net file describes. Charts, labels, vertices and triangles are those of the file;
/// nothing is flipped or recomputed. So for a document that net_document made, net_document returns it again. A
/// triangulation has no epsilon and no collars; those of the document are left out. Does not check whether the vertices
/// are a net.
///
/// Throws SurfaceError if the document's surface is invalid, TriangulationError if charts, labels, vertices or
/// triangles are inconsistent, LimitError. O(size) plus the time of `Surface` and of evaluating the labels.
[[nodiscard]] Triangulation triangulation_of(const certify::NetDocument& net);

}  // namespace epsnet
