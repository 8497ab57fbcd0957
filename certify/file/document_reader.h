#pragma once

#include <optional>
#include <string>

#include "certify/file/pieces.h"

namespace epsnet::certify {

/// Reads a file of one kind, and checks its structure. `Document` is NetDocument, compact or not, SurfaceDocument,
/// GeodesicsDocument, DistanceDocument or BoundDocument. Throws MalformedError without the file's name. O(size), and no
/// more memory than a multiple of what was read. Requires: the arithmetic of binary64 is rounded to nearest.
template <class Document>
[[nodiscard]] Document read_document(Pieces& bytes);

/// Returns what the first member `format` of an object says; nullopt if it is no string, or if the text does not begin
/// as an object that has one. What is passed over need not be JSON.
[[nodiscard]] std::optional<std::string> format_of(Pieces& bytes);

}  // namespace epsnet::certify
