#include "certify/verdict/rule_book.h"

#include <algorithm>
#include <string>
#include <utility>

#include "certify/base/lookup.h"

namespace epsnet::certify {

RuleBook::RuleBook(RuleNames declared) : declared_(std::move(declared)) {
  ensure(!declared_.empty(), "a claim declares no rule");
  RuleNames sorted = declared_;
  std::sort(sorted.begin(), sorted.end());
  ensure(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end(), "a claim declares a rule twice");
}

void RuleBook::report(RuleReport report) {
  const std::optional<std::string_view> expected = next();
  if (report.rule != expected) {
    throw Fault("rule " + report.rule + " was reported, expected " + std::string(expected.value_or("no more")));
  }
  ensure(report.verdict != Verdict::malformed, "a rule called a document malformed");
  reports_.push_back(std::move(report));
}

std::optional<std::string_view> RuleBook::next() const {
  if (reports_.size() == declared_.size()) return std::nullopt;
  return declared_[reports_.size()];
}

bool RuleBook::verified_so_far() const {
  return std::all_of(reports_.begin(), reports_.end(),
                     [](const RuleReport& report) { return report.verdict == Verdict::verified; });
}

void RuleBook::conclude(Certificate& certificate) const {
  certificate.rules = reports_;
  const auto decide = [&](Verdict verdict, std::string_view rule, std::string_view message) {
    certificate.verdict = verdict;
    certificate.rule = rule;
    certificate.message = message;
  };
  for (const Verdict wanted : {Verdict::refuted, Verdict::undecided}) {
    const auto found = std::find_if(reports_.begin(), reports_.end(),
                                    [&](const RuleReport& report) { return report.verdict == wanted; });
    if (found != reports_.end()) return decide(wanted, found->rule, found->text);
  }
  if (const auto missing = next()) return decide(Verdict::undecided, *missing, "the rule was not asked");
  decide(Verdict::verified, "", "");
}

}  // namespace epsnet::certify
