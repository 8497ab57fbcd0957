#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "certify/base/binary64.h"
#include "certify/net/crossings.h"
#include "certify/net/document.h"
#include "certify/verdict/verification.h"

/// The one way in which documents are checked: the rules of the net, then those of a claim about its surface.
namespace epsnet::certify {

/// A claim about a net, or about the surface of one.
struct Claim {
  const NetDocument& net;
  std::string text;  ///< As in Certificate.
  RuleNames rules;   ///< Those of the net, then its own.
  /// Asks its own rules and reports each, in order; called if all rules of the net are verified, with the crossings of
  /// its surface. Empty if there are none. BudgetSpent leaves the rule that it was at undecided.
  std::function<void(Verification&, Crossings)> ask;
};

/// The verdict about the claim of a document without structure problem; `least_bytes` is that of the document.
[[nodiscard]] Certificate verify(const Claim& claim, std::uint64_t least_bytes, const CheckOptions& options);

/// The verdict about a document of any kind and content; `claim_of` is asked about one without structure problem.
template <class Document>
[[nodiscard]] Certificate verify(const Document& document, const CheckOptions& options,
                                 Claim (*claim_of)(const Document&)) {
  const RoundingToNearest rounding;
  if (options.progress) options.progress("structure", 0);
  if (const auto problem = structure_problem(document)) return malformed(*problem);
  return verify(claim_of(document), least_bytes(document), options);
}

}  // namespace epsnet::certify
