#include <cstdlib>
#include <string_view>

#include "certify/base/error.h"
#include "certify/exact/checker.h"

/// A second checker that says of every file what EPSNET_SECOND_VERDICT says, to see the program `certify` when its two
/// checkers disagree, or when it is at fault. No file is known for which the true ones do or it is.
namespace epsnet::exact {

Result check(std::string_view /*text*/, const Limits& /*limits*/) {
  const std::string_view wanted = std::getenv("EPSNET_SECOND_VERDICT");
  if (wanted == "VERIFIED") return {Verdict::verified, "", ""};
  if (wanted == "REFUTED") return {Verdict::refuted, "delaunay", "no edge is\nDelaunay"};
  if (wanted == "MALFORMED") return {Verdict::malformed, "", "not JSON"};
  // Whatever part of the program notices that another part is wrong.
  if (wanted == "FAULT") throw certify::Fault("made for a test");
  return {Verdict::undecided, kLeftOut, "not for this checker: any"};
}

}  // namespace epsnet::exact
