#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "certify/check.h"
#include "certify/documents.h"
#include "certify/verdict/report.h"
#include "netgen/base/options.h"
#include "triangulation/surface/surface.h"

/// From a document that was computed to its proof. docs/design.md, "From a surface to a proof", says how.
///
/// A proof is cancelled by an exception that its Progress throws, which passes through.
namespace epsnet {

/// What was computed, with its proof. A function that returns one throws NotCertifiedError if the checker does not say
/// VERIFIED. The same document without its proof comes from the function of that name in the namespace unproved.
template <class Document>
struct Certified {
  Document document;
  certify::Certificate certificate;  ///< Of the document: VERIFIED.
};

/// Nothing was found that could be proved; what() says why. The surface and the options are valid.
class NetError : public Error {
 public:
  using Error::Error;
};

/// The checker did not say VERIFIED to what was computed; what() is "not certified: " and the verdict with its reason.
class NotCertifiedError : public NetError {
 public:
  /// Requires: the verdict is not `verified`.
  explicit NotCertifiedError(certify::Certificate certificate)
      : NetError("not certified: " + certify::verdict_line(certificate)), certificate_(std::move(certificate)) {}
  /// What the checker said.
  [[nodiscard]] const certify::Certificate& certificate() const { return certificate_; }

 private:
  certify::Certificate certificate_;
};

/// Returns how a document that was made here is checked: as `certify` checks its file without options, within the work
/// that a file of its size may take. Progress is that of the rules, as "certificate: rule NAME".
[[nodiscard]] inline certify::CheckOptions own_check(unsigned threads = 0, const Progress& progress = {}) {
  certify::CheckOptions result;
  result.threads = threads;
  if (progress) {
    result.progress = [progress](std::string_view rule, double share) {
      progress("certificate: rule " + std::string(rule), share);
    };
  }
  return result;
}

/// Returns the certificate of a document, which says VERIFIED; otherwise throws NotCertifiedError.
[[nodiscard]] inline certify::Certificate proof_of(const certify::AnyClaim& document,
                                                   const certify::CheckOptions& options) {
  certify::Certificate result = certify::check(document, options);
  if (result.verdict != certify::Verdict::verified) throw NotCertifiedError(std::move(result));
  return result;
}

/// Likewise, with the options of own_check.
[[nodiscard]] inline certify::Certificate proof_of(const certify::AnyClaim& document, unsigned threads = 0,
                                                   const Progress& progress = {}) {
  return proof_of(document, own_check(threads, progress));
}

/// Returns a document with its certificate, likewise.
template <certify::IsDocument Document>
[[nodiscard]] Certified<Document> proved(Document document, unsigned threads = 0, const Progress& progress = {}) {
  certify::Certificate certificate = proof_of(document, threads, progress);
  return {std::move(document), std::move(certificate)};
}

}  // namespace epsnet
