#pragma once

#include <optional>
#include <string>

#include "certify/documents.h"
#include "certify/file/file.h"
#include "certify/file/json.h"

namespace epsnet::certify {

/// Where to put the contents of a file of one kind.
using DocumentPointer = Pointers<>::And<SurfaceDocument>;

/// Reads a file of this kind, a net compact or not, into an empty document. Throws MalformedError without the file's
/// name. O(size), and no more memory than a multiple of what was read. Requires: the
/// arithmetic of binary64 is rounded to nearest.
void read_document(ByteStream& bytes, DocumentPointer document, Structure structure = Structure::checked);

/// Returns what the first member `format` of an object says; nullopt if it is no string, or if the text does not begin
/// as an object that has one. What is passed over need not be JSON.
[[nodiscard]] std::optional<std::string> format_of(ByteStream& bytes);

}  // namespace epsnet::certify
