#include "certify/verdict/verification.h"

#include <algorithm>
#include <utility>

#include "certify/base/lookup.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

CheckOptions bounded(CheckOptions options) {
  options.threads = number_of_threads(options);
  options.max_precision = std::clamp(options.max_precision, kLeastPrecision, kGreatestPrecision);
  return options;
}

}  // namespace

unsigned number_of_threads(const CheckOptions& options) { return thread_count(options.threads); }

Verification::Verification(const CheckOptions& options, std::uint64_t least_bytes, RuleNames rules, std::string claim)
    : options_(bounded(options)),
      work_(options.max_work != 0 ? options.max_work : work_allowed(least_bytes)),
      budget_(work_),
      rules_(std::move(rules)) {
  certificate_.claim = std::move(claim);
}

void Verification::progress(std::string_view rule) const {
  if (options_.progress) options_.progress(rule, 0);
}

void Verification::used(std::uint64_t precision) {
  std::uint64_t& most = certificate_.counts.max_precision_used;
  most = std::max(most, precision);
}

Verdict Verification::report(RuleReport report) {
  rules_.report(std::move(report));
  return rules_.reports().back().verdict;
}

void Verification::give_up(const std::string& why) {
  const std::string rule(value_of(rules_.next(), "work was done after the last rule"));
  report({rule, Verdict::undecided, why});
}

Certificate Verification::conclude() {
  rules_.conclude(certificate_);
  certificate_.counts.work = work_ - budget_.left();
  return std::move(certificate_);
}

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
