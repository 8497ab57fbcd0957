#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "certify/net/rules.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/surfaces/surfaces.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

std::optional<epsnet::Surface> read(std::string_view text) {
  try {
    return epsnet::read_domain(text, "input");
  } catch (const epsnet::ExchangeError&) {
    return std::nullopt;
  }
}

}  // namespace

/// Any bytes are a polygon of a surface or give an ExchangeError. The certifier agrees that it is a surface, and the
/// text that is written reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto surface = read({reinterpret_cast<const char*>(data), size});
  if (!surface) return 0;
  const auto document = epsnet::to_document(*surface);
  require(epsnet::certify::check_surface(document).report.verdict == epsnet::certify::Verdict::verified);
  if (surface->tiles().size() == 1) {
    const auto again = read(epsnet::write_domain(*surface));
    require(again.has_value() && epsnet::to_document(*again) == document);
  }
  return 0;
}
