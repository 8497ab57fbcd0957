#pragma once

#include <filesystem>
#include <string_view>

#include "triangulation/surface.h"

namespace epsnet {

/// The text formats in which surfaces are exchanged with other programs (docs/exchange-formats.md).
enum class ExchangeFormat {
  automatic,      ///< Whichever the text is: see is_triangulation_stream.
  domain,         ///< A polygon (domain_format.h).
  triangulation,  ///< A triangulation by cross-ratios, with an anchor, none, or one of each triangle.
};

/// The surface that a text describes. `name` stands for the text in messages; an error after a guess says what was
/// guessed. Throws DomainError, TriangulationStreamError.
[[nodiscard]] Surface import_surface(std::string_view text, std::string_view name, ExchangeFormat format);

/// The same for a file of at most 256 MiB, read once, so that it may be a pipe.
[[nodiscard]] Surface import_surface_file(const std::filesystem::path& path, ExchangeFormat format);

}  // namespace epsnet
