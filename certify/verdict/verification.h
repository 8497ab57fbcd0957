#pragma once

#include <cstdint>
#include <string>

#include "certify/numbers/budget.h"
#include "certify/verdict/rule_book.h"

namespace epsnet::certify {

/// At least one.
[[nodiscard]] unsigned number_of_threads(const CheckOptions& options);

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

}  // namespace epsnet::certify
