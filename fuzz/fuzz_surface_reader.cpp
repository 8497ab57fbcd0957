#include <epsnet/certify/reader.h>
#include <epsnet/certify/writer.h>

#include <cstdint>
#include <cstdlib>
#include <sstream>

/// Any bytes are a surface or a MalformedError; a surface that is written reads back the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace epsnet::certify;
  Surface surface;
  try {
    surface = parse_surface({reinterpret_cast<const char*>(data), size}, "input");
  } catch (const MalformedError&) {
    return 0;
  }
  std::ostringstream out;
  write_surface(surface, out);
  if (parse_surface(out.str(), "written") != surface) std::abort();
  return 0;
}
