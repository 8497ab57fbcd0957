#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "certify/file/compact.h"
#include "certify/file/reader.h"
#include "certify/file/writer.h"

namespace {

using namespace epsnet::certify;

std::optional<NetDocument> read(std::string_view text) {
  try {
    return parse_file<NetDocument>(text, "input");
  } catch (const MalformedError&) {
    return std::nullopt;
  }
}

/// Returns the same JSON with escapes in the names of members, so that the reader cannot take rows directly from the
/// text.
std::string with_names_escaped(std::string text) {
  for (const std::string_view start : {"\"vertices", "\"triangles"}) {
    for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at)) {
      text.replace(at + 1, 1, start[1] == 'v' ? "\\u0076" : "\\u0074");
    }
  }
  return text;
}

}  // namespace

/// Any bytes are a net or give a MalformedError. A net that is written reads back the same. Rows taken directly from
/// the text are the same as those that the strict reader finds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::optional<NetDocument> document = read(text);
  if (!is_compact(text) && read(with_names_escaped(std::string(text))) != document) std::abort();
  if (!document) return 0;
  std::ostringstream out;
  write_file(*document, out);
  if (parse_file<NetDocument>(out.str(), "written") != *document) std::abort();
  return 0;
}
