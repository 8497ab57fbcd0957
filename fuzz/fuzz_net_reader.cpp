#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "certify/file/reader.h"
#include "certify/file/writer.h"

/// Any bytes are a net or a MalformedError; a net that is written reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace epsnet::certify;
  NetDocument document;
  try {
    document = parse_net({reinterpret_cast<const char*>(data), size}, "input");
  } catch (const MalformedError&) {
    return 0;
  }
  std::ostringstream out;
  write_net(document, out);
  if (parse_net(out.str(), "written") != document) std::abort();
  return 0;
}
