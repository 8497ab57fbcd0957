#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "certify/verdict/verification.h"

namespace epsnet::certify {

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
