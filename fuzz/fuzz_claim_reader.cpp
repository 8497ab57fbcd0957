#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "certify/file/file.h"

/// Any bytes are the file of a claim or give a MalformedError; a file that is written reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace epsnet::certify;
  ClaimDocument document;
  try {
    document = parse_file<ClaimDocument>({reinterpret_cast<const char*>(data), size}, "input");
  } catch (const MalformedError&) {
    return 0;
  }
  std::ostringstream out;
  write_file(document, out);
  if (parse_file<ClaimDocument>(out.str(), "written") != document) std::abort();
  return 0;
}
