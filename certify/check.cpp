#include "certify/check.h"

#include <optional>
#include <string>
#include <type_traits>

#include "certify/base/interval.h"
#include "certify/claims.h"
#include "certify/claims/net/claim.h"

namespace epsnet::certify {

namespace {

/// Only nets may be so large that one thread is slow.
template <class Document>
Problem structure_problem_by(const Document& document, unsigned threads) {
  if constexpr (std::is_same_v<Document, NetDocument>) {
    return structure_problem(document, threads);
  } else {
    return structure_problem(document);
  }
}

}  // namespace

std::optional<std::string> malformation(const AnyClaim& document, unsigned threads) {
  const RoundingToNearest rounding;
  return document.visit([&](const auto& one) { return structure_problem_by(one, threads); });
}

Certificate check(const AnyClaim& document, const CheckOptions& options) {
  const RoundingToNearest rounding;
  if (options.progress) options.progress("structure", 0);
  if (const auto problem = malformation(document, number_of_threads(options))) return malformed(*problem);
  return document.visit([&](const auto& one) { return verify(claim_of(one), least_bytes(one), options); });
}

}  // namespace epsnet::certify
