#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string_view>

#include "certify/file/file.h"

namespace {

using namespace epsnet::certify;

std::optional<NetDocument> read(std::string_view text) {
  try {
    return parse_file<NetDocument>(text, "input");
  } catch (const MalformedError&) {
    return std::nullopt;
  }
}

}  // namespace

/// Any bytes are a net or give a MalformedError. A net that is written reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::optional<NetDocument> document = read(text);
  if (!document) return 0;
  std::ostringstream out;
  write_file(*document, out);
  if (parse_file<NetDocument>(out.str(), "written") != *document) std::abort();
  return 0;
}
