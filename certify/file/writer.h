#pragma once

#include <iosfwd>

#include "certify/documents.h"

/// Writes the files of docs/format.md. The writer is not trusted: the checker reads its output with reader.h.
///
/// The text is canonical: one row per line, every number as short as possible. So equal documents give equal bytes, and
/// what is read from them equals the document. O(size), buffered. Errors are reported by the state of the stream.
namespace epsnet::certify {

/// Writes a file, of a geodesics document the members that its claim has.
void write_file(const AnyClaim& document, std::ostream& out);
/// Writes a surface file.
void write_file(const SurfaceDocument& surface, std::ostream& out);

/// Writes a compact net file, about 55 bytes per vertex. Requires: `opposite` is an involution without fixed points.
/// Otherwise throws std::invalid_argument before anything is written, and only write_file can write the document.
void write_compact_net(const NetDocument& document, std::ostream& out);

}  // namespace epsnet::certify
