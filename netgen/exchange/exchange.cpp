#include "netgen/exchange/exchange.h"

#include "certify/file/reader.h"
#include "netgen/exchange/domain_format.h"
#include "netgen/exchange/triangulation_stream.h"

namespace epsnet {

Surface import_surface(std::string_view text, std::string_view name, ExchangeFormat format) {
  if (text.size() > kMaxTextBytes)
    throw ExchangeError(certify::ErrorParts{.file = std::string(name), .problem = "is larger than 256 MiB"});
  const bool guess = format == ExchangeFormat::automatic;
  if (format == ExchangeFormat::triangulation || (guess && is_triangulation_stream(text))) {
    return develop(read_triangulation_stream(text, name), name);
  }
  try {
    return read_domain(text, name);
  } catch (const ExchangeError& error) {
    if (!guess) throw;
    const std::string reading =
        " (read as the domain format: the second token is neither \"yes\" nor \"no\", nor do points of a first "
        "triangle follow, as in the triangulation formats)";
    certify::ErrorParts parts = error.parts();
    parts.problem += reading;
    throw ExchangeError(error.what() + reading, parts);
  }
}

Surface import_surface_file(const std::filesystem::path& path, ExchangeFormat format) {
  return import_surface(certify::load(path), path.string(), format);
}

}  // namespace epsnet
