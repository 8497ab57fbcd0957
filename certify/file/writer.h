#pragma once

#include <iosfwd>

#include "certify/document/cover_document.h"
#include "certify/document/distance_document.h"
#include "certify/document/document.h"
#include "certify/document/geodesics_document.h"

/// Writes the files of docs/format.md. Not trusted: the checker reads what was written with reader.h.
///
/// The text is canonical: one row a line, numbers as short as they can be, so equal documents give equal bytes, and
/// parse_net(write_net(x)) == x. O(size), buffered. Errors show in the state of the stream.
namespace epsnet::certify {

/// Writes a net file.
void write_net(const NetDocument& document, std::ostream& out);

/// Writes a compact net file, some 55 bytes for each vertex. Throws std::invalid_argument, before anything is written,
/// if `opposite` is not an involution without fixed points: then only write_net can.
void write_compact_net(const NetDocument& document, std::ostream& out);

/// Writes a surface file.
void write_surface(const SurfaceDocument& surface, std::ostream& out);

/// Writes the members that the document's claim has, and no others.
void write_geodesics(const GeodesicsDocument& document, std::ostream& out);

/// Writes a distance file.
void write_distance(const DistanceDocument& document, std::ostream& out);

/// Writes a cover file.
void write_cover(const CoverDocument& document, std::ostream& out);

}  // namespace epsnet::certify
