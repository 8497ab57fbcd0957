#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>

#include "certify/file/compact.h"
#include "certify/file/file.h"

/// Any bytes, followed by their checksum, are a compact net file or give a MalformedError. A document that is read and
/// written again stays the same, also as JSON.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace epsnet::certify;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  CompactChecksum sum;
  sum.add(bytes);
  for (unsigned i = 0; i < 8; ++i) bytes += static_cast<char>(static_cast<unsigned char>(sum.value() >> (8 * i)));
  NetDocument document;
  try {
    document = parse_file<NetDocument>(bytes, "input");
  } catch (const MalformedError&) {
    return 0;
  }
  std::ostringstream text;
  write_file(document, text);
  if (parse_file<NetDocument>(text.str(), "written") != document) std::abort();
  if (!is_compact(bytes)) return 0;
  std::ostringstream compact;
  write_compact_net(document, compact);
  if (parse_file<NetDocument>(compact.str(), "written") != document) std::abort();
  return 0;
}
