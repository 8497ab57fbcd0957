#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "certify/file/file.h"
#include "certify/net/rules.h"
#include "netgen/surfaces/surfaces.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

bool accepted(const epsnet::certify::SurfaceDocument& surface) {
  try {
    require(epsnet::to_document(epsnet::from_document(surface)) == surface);
    return true;
  } catch (const epsnet::SurfaceError&) {
    return false;
  }
}

}  // namespace

/// Any bytes are the text of a surface or give a MalformedError. The text that is written reads back the same. The
/// generator accepts a surface if and only if the certifier proves it to be one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace epsnet::certify;
  SurfaceDocument surface;
  try {
    surface = parse_file<SurfaceDocument>({reinterpret_cast<const char*>(data), size}, "input");
  } catch (const MalformedError&) {
    return 0;
  }
  std::ostringstream out;
  write_file(surface, out);
  require(parse_file<SurfaceDocument>(out.str(), "written") == surface);
  require(accepted(surface) == (check_surface(surface).report.verdict == Verdict::verified));
  return 0;
}
