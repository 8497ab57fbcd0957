#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "certify/check/rule_book.h"
#include "certify/crossings.h"
#include "certify/document/binary64.h"
#include "certify/document/document.h"
#include "certify/numbers/budget.h"

/// The one way in which documents are checked: the rules of the net, then those of a claim about its surface.
namespace epsnet::certify {

/// One check of one document: what it may use, and what is known so far.
class Verification {
 public:
  /// `least_bytes` says what work is allowed unless the options do. O(1).
  Verification(const CheckOptions& options, std::uint64_t least_bytes, RuleNames rules, std::string claim);

  /// With values in range: at least one thread, the precision within its limits.
  [[nodiscard]] const CheckOptions& options() const { return options_; }
  [[nodiscard]] unsigned threads() const { return options_.threads; }
  [[nodiscard]] const Budget& budget() const { return budget_; }

  /// What is said besides the rules. Rules, verdict and work are written at the end.
  [[nodiscard]] Certificate& certificate() { return certificate_; }
  [[nodiscard]] const RuleBook& rules() const { return rules_; }

  void progress(std::string_view rule) const;
  /// A rule used so many bits.
  void used(std::uint64_t precision);
  /// As RuleBook::report; returns the verdict.
  Verdict report(RuleReport report);
  /// The next rule is undecided: `why`.
  void give_up(const std::string& why);

  /// Nothing is reported after that.
  [[nodiscard]] Certificate conclude();

 private:
  CheckOptions options_;
  std::uint64_t work_;
  Budget budget_;
  RuleBook rules_;
  Certificate certificate_;
};

/// A claim about a net, or about the surface of one.
struct NetClaim {
  const NetDocument& net;
  std::string text;  ///< As in Certificate.
  RuleNames rules;   ///< Those of the net, then its own.
  /// Asks its own rules and reports each, in order; called if all rules of the net are verified, with the crossings of
  /// its surface. Empty if there are none. BudgetSpent leaves the rule that it was at undecided.
  std::function<void(Verification&, Crossings)> ask;
};

/// The verdict about the claim of a document without structure problem; `least_bytes` is that of the document.
[[nodiscard]] Certificate verify(const NetClaim& claim, std::uint64_t least_bytes, const CheckOptions& options);

/// The verdict about a document of any kind and content; `claim_of` is asked about one without structure problem.
template <class Document>
[[nodiscard]] Certificate verify(const Document& document, const CheckOptions& options,
                                 NetClaim (*claim_of)(const Document&)) {
  const RoundingToNearest rounding;
  if (options.progress) options.progress("structure", 0);
  if (const auto problem = structure_problem(document)) return malformed(*problem);
  return verify(claim_of(document), least_bytes(document), options);
}

}  // namespace epsnet::certify
