#include "certify/verdict/open_rules.h"

#include <algorithm>
#include <utility>

#include "certify/base/lookup.h"

namespace epsnet::certify {

OpenRules::OpenRules(const RuleNames& rules) {
  for (const std::string_view rule : rules) reports_.push_back({std::string(rule), Verdict::undecided, "not decided"});
}

Verdict OpenRules::verdict(std::string_view rule) const {
  const auto found = std::find_if(reports_.begin(), reports_.end(), [&](const auto& own) { return own.rule == rule; });
  return found == reports_.end() ? Verdict::undecided : found->verdict;
}

bool OpenRules::open(std::string_view rule) const {
  return std::any_of(reports_.begin(), reports_.end(),
                     [&](const auto& own) { return own.rule == rule && own.verdict == Verdict::undecided; });
}

void OpenRules::report(RuleReport report) {
  const auto found =
      std::find_if(reports_.begin(), reports_.end(), [&](const auto& own) { return own.rule == report.rule; });
  ensure(found != reports_.end(), "a rule was reported that the claim does not declare");
  *found = std::move(report);
}

void OpenRules::doubt(std::string_view rule, const std::string& why) {
  if (open(rule)) report({std::string(rule), Verdict::undecided, why});
}

void OpenRules::give_up(const std::string& why) {
  for (RuleReport& report : reports_) {
    if (report.verdict == Verdict::undecided) report.text = why;
  }
}

void OpenRules::conclude(Verification& run) {
  for (RuleReport& report : reports_) run.report(std::move(report));
}

}  // namespace epsnet::certify
