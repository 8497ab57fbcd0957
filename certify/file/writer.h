#pragma once

#include <iosfwd>

#include "certify/claims/bound/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/net/document.h"

/// Writes the files of docs/format.md. The writer is not trusted: the checker reads its output with reader.h.
///
/// The text is canonical: one row per line, every number as short as possible. So equal documents give equal bytes, and
/// parse_net(write_net(x)) == x. O(size), buffered. Errors are reported by the state of the stream.
namespace epsnet::certify {

/// Writes a net file.
void write_net(const NetDocument& document, std::ostream& out);

/// Writes a compact net file, about 55 bytes per vertex. Requires: `opposite` is an involution without fixed points.
/// Otherwise throws std::invalid_argument before anything is written, and only write_net can write the document.
void write_compact_net(const NetDocument& document, std::ostream& out);

/// Writes a surface file.
void write_surface(const SurfaceDocument& surface, std::ostream& out);

/// Writes a geodesics file, with only the members that its claim has.
void write_geodesics(const GeodesicsDocument& document, std::ostream& out);

/// Writes a distance file.
void write_distance(const DistanceDocument& document, std::ostream& out);

/// Writes a bound file.
void write_bound(const BoundDocument& document, std::ostream& out);

}  // namespace epsnet::certify
