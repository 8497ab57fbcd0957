#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "certify/net/document.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// Returns the surface as plain data of a surface file or net file (docs/format.md). O(size).
[[nodiscard]] certify::SurfaceDocument to_document(const Surface& surface);

/// Returns the surface that a document describes, checked completely. Throws SurfaceError.
[[nodiscard]] Surface from_document(const certify::SurfaceDocument& surface);

/// Like from_document; messages begin with the name of the file that the document is from.
[[nodiscard]] Surface from_document(const certify::SurfaceDocument& surface, const std::string& name);

/// Reads the surface of a surface file, or of any file that `certify` checks: a net file, compact or not, a file of
/// closed geodesics, of a distance, of a diameter, a radius or an embedded disk. What such a file says of the surface
/// is not checked. Throws certify::FileError, certify::MalformedError, or SurfaceError if the file is well-formed but
/// not a surface; what() is one line that starts with the path.
[[nodiscard]] Surface load_surface(const std::filesystem::path& path);

/// Like load_surface, from memory; `name` stands for the file in messages. Throws certify::MalformedError,
/// SurfaceError.
[[nodiscard]] Surface parse_surface_file(const std::string& text, const std::string& name);

/// Writes a surface file, atomically; the same bytes for equal surfaces. Throws WriteError.
void save_surface(const Surface& surface, const std::filesystem::path& path);

}  // namespace epsnet
