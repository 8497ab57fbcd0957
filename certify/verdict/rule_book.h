#pragma once

#include <optional>
#include <string_view>
#include <vector>

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

}  // namespace epsnet::certify
