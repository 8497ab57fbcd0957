#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/numbers/budget.h"
#include "certify/verdict/report.h"

namespace epsnet::certify {

/// What the rules of one claim say. The claim declares them by name, in the order in which they are asked, and nothing
/// is VERIFIED unless each of them was reported and is.
class RuleBook {
 public:
  /// Fault, if there is no rule or one occurs twice: a claim without rules would hold always.
  explicit RuleBook(RuleNames declared);

  /// Fault, unless the report is that of next().
  void report(RuleReport report);

  /// The first rule that has no report; nullopt if all have one.
  [[nodiscard]] std::optional<std::string_view> next() const;
  [[nodiscard]] const std::vector<RuleReport>& reports() const { return reports_; }
  /// Whether every report so far is VERIFIED. True if there is none.
  [[nodiscard]] bool verified_so_far() const;

  /// Writes the reports into the certificate, and the verdict: that of the first rule that is refuted; else UNDECIDED
  /// by the first rule that is undecided, else by the first that has no report; else VERIFIED.
  void conclude(Certificate& certificate) const;

 private:
  RuleNames declared_;
  std::vector<RuleReport> reports_;
};

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

/// The reports of rules that are asked together, again and again with more bits, until they are decided.
class OpenRules {
 public:
  /// None of them is decided yet.
  explicit OpenRules(const RuleNames& rules);

  /// Of a rule; `undecided` if it is not one of them.
  [[nodiscard]] Verdict verdict(std::string_view rule) const;
  /// Whether a rule is one of them and not decided.
  [[nodiscard]] bool open(std::string_view rule) const;

  /// Replaces the report of one of them. Throws Fault for any other.
  void report(RuleReport report);
  /// Says why a rule is not decided, if it is one of them and open.
  void doubt(std::string_view rule, const std::string& why);
  /// Says why all that are open remain so.
  void give_up(const std::string& why);
  /// Forgets all but the first: nothing can be said about a list whose elements are wrong.
  void keep_first() { reports_.resize(1); }

  /// Reports them to the run, in order. At the end.
  void conclude(Verification& run);

 private:
  std::vector<RuleReport> reports_;
};

}  // namespace epsnet::certify
