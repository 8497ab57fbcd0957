#include "netgen/prove/certified.h"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace epsnet {

NotCertifiedError::NotCertifiedError(certify::Certificate certificate)
    : NetError("not certified: " + certify::verdict_line(certificate)), certificate_(std::move(certificate)) {}

certify::CheckOptions own_check(unsigned threads, const Progress& progress) {
  certify::CheckOptions result;
  result.threads = threads;
  result.max_work = std::numeric_limits<std::uint64_t>::max();
  if (progress) {
    result.progress = [progress](std::string_view rule, double share) {
      progress("certificate: " + std::string(rule), share);
    };
  }
  return result;
}

certify::Certificate proof_of(const certify::AnyClaim& document, const certify::CheckOptions& options) {
  certify::Certificate result = certify::check(document, options);
  if (result.verdict != certify::Verdict::verified) throw NotCertifiedError(std::move(result));
  return result;
}

}  // namespace epsnet
