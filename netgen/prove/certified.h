#pragma once

#include "certify/check.h"
#include "certify/documents.h"
#include "certify/verdict/report.h"
#include "netgen/base/options.h"
#include "triangulation/surface/error.h"

/// From a document that was computed to its proof. docs/design.md, "From a surface to a proof", says how.
///
/// A proof is cancelled by an exception that its Progress throws, which passes through.
namespace epsnet {

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

/// Returns how a document is checked that was made by this program: without a limit of work, which protects from the
/// files of others. Its progress is that of the rules, as "certificate: RULE".
[[nodiscard]] certify::CheckOptions own_check(unsigned threads = 0, const Progress& progress = {});

/// Returns the certificate of a document, which says VERIFIED; otherwise throws NotCertifiedError.
[[nodiscard]] certify::Certificate proof_of(const certify::AnyClaim& document,
                                            const certify::CheckOptions& options = own_check());

}  // namespace epsnet
