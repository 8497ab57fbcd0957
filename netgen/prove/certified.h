#pragma once

#include <utility>

#include "certify/check.h"
#include "certify/documents.h"
#include "certify/verdict/report.h"
#include "netgen/base/options.h"
#include "triangulation/surface/error.h"

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
  explicit NotCertifiedError(certify::Certificate certificate);
  [[nodiscard]] const certify::Certificate& certificate() const { return certificate_; }

 private:
  certify::Certificate certificate_;
};

/// Returns how a document that was made here is checked. A net may take the work that a file of its size may, so that
/// `certify` verifies the file without options. Other claims have no limit of work: the limit protects from the files
/// of others, and would refuse a true list that is long. Progress is that of the rules, as "certificate: RULE".
[[nodiscard]] certify::CheckOptions own_check(const certify::AnyClaim& document, unsigned threads = 0,
                                              const Progress& progress = {});

/// Returns the certificate of a document, which says VERIFIED; otherwise throws NotCertifiedError.
[[nodiscard]] certify::Certificate proof_of(const certify::AnyClaim& document, const certify::CheckOptions& options);

/// Likewise, with the options of own_check.
[[nodiscard]] certify::Certificate proof_of(const certify::AnyClaim& document, unsigned threads = 0,
                                            const Progress& progress = {});

/// Returns a document with its certificate, likewise.
template <certify::IsDocument Document>
[[nodiscard]] Certified<Document> proved(Document document, unsigned threads = 0, const Progress& progress = {}) {
  certify::Certificate certificate = proof_of(document, threads, progress);
  return {std::move(document), std::move(certificate)};
}

}  // namespace epsnet
