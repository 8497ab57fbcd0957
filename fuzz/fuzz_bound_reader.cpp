#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "certify/file/reader.h"
#include "certify/file/writer.h"

/// Any bytes are a bound file or give a MalformedError; a file that is written reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace epsnet::certify;
  BoundDocument document;
  try {
    document = parse_file<BoundDocument>({reinterpret_cast<const char*>(data), size}, "input");
  } catch (const MalformedError&) {
    return 0;
  }
  std::ostringstream out;
  write_file(document, out);
  if (parse_file<BoundDocument>(out.str(), "written") != document) std::abort();
  return 0;
}
