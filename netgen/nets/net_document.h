#pragma once

#include "certify/document/document.h"
#include "netgen/base/length.h"
#include "triangulation/dart.h"
#include "triangulation/triangulation.h"

/// From triangulations to the plain data of net files, and back.
namespace epsnet {

/// A dart of a triangulation as net files number it.
[[nodiscard]] constexpr std::uint32_t document_dart(Dart d) { return 3 * triangle_of(d) + corner_of(d); }
/// A dart of a net file as one of a triangulation.
[[nodiscard]] constexpr Dart triangulation_dart(std::uint32_t d) { return make_dart(d / 3, d % 3); }

/// A triangulation as the plain data of a net file. Charts and labels that nothing uses are left out. O(size).
[[nodiscard]] certify::NetDocument net_document(const Triangulation& triangulation, const Length& epsilon);

/// The triangulation that a net file describes: charts, labels, vertices and triangles as in the file, nothing flipped
/// or computed anew, so that net_document gives the same document again if it made the first one. Collars are no part
/// of a triangulation: those of a pseudo net are left out, and epsilon is. Whether it is a net is not asked.
///
/// Throws SurfaceError if there is no such surface, TriangulationError for charts, labels, vertices or
/// triangles that do not fit, LimitError. O(size), and the time of `Surface` and of evaluating the labels.
[[nodiscard]] Triangulation triangulation_of(const certify::NetDocument& net);

}  // namespace epsnet
