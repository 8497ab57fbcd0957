#include "certify/document/report.h"

namespace epsnet::certify {

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::verified:
      return "VERIFIED";
    case Verdict::refuted:
      return "REFUTED";
    case Verdict::undecided:
      return "UNDECIDED";
    case Verdict::malformed:
      break;
  }
  return "MALFORMED";
}

}  // namespace epsnet::certify
