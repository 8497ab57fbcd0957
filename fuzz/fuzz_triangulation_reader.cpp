#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

#include "certify/net/rules.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/surfaces/surfaces.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

std::optional<epsnet::TriangulationStream> read(std::string_view text) {
  try {
    return epsnet::read_triangulation_stream(text, "input");
  } catch (const epsnet::ExchangeError&) {
    return std::nullopt;
  }
}

std::optional<epsnet::Surface> develop(const epsnet::TriangulationStream& stream) {
  try {
    return epsnet::develop(stream, "input");
  } catch (const epsnet::ExchangeError&) {
    return std::nullopt;
  }
}

std::string text_of(const epsnet::TriangulationStream& stream) {
  std::ostringstream out;
  epsnet::write_triangulation_stream(stream, out);
  return out.str();
}

}  // namespace

/// Any bytes are a triangulation or give an ExchangeError. The text that is written reads back the same. If the
/// triangulation has a surface, the certifier agrees that it is one, and its cross-ratios give the same surface again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto stream = read({reinterpret_cast<const char*>(data), size});
  if (!stream) return 0;
  require(read(text_of(*stream)) == stream);
  const auto surface = develop(*stream);
  if (!surface) return 0;
  require(epsnet::certify::check_surface(epsnet::to_document(*surface)).report.verdict ==
          epsnet::certify::Verdict::verified);
  const auto written = epsnet::triangulation_stream(*surface);
  const auto again = develop(written);
  require(again.has_value() && again->genus() == surface->genus() && epsnet::triangulation_stream(*again) == written);
  return 0;
}
