#include "netgen/prove/certified.h"

#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

namespace epsnet {

NotCertifiedError::NotCertifiedError(certify::Certificate certificate)
    : NetError("not certified: " + certify::verdict_line(certificate)), certificate_(std::move(certificate)) {}

certify::CheckOptions own_check(const certify::AnyClaim& document, unsigned threads, const Progress& progress) {
  const bool is_net =
      document.visit([]<class Document>(const Document&) { return std::same_as<Document, certify::NetDocument>; });
  certify::CheckOptions result;
  result.threads = threads;
  if (!is_net) result.max_work = std::numeric_limits<std::uint64_t>::max();
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

certify::Certificate proof_of(const certify::AnyClaim& document, unsigned threads, const Progress& progress) {
  return proof_of(document, own_check(document, threads, progress));
}

}  // namespace epsnet
