#include "certify/verdict/verification.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "certify/base/error.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 4> kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string to_string(const RuleReport& report) {
  return report.rule + ": " + std::string(name(report.verdict)) + ": " + report.text;
}

Certificate malformed(const std::string& problem) {
  Certificate certificate;
  certificate.verdict = Verdict::malformed;
  certificate.rule = "structure";
  certificate.message = problem;
  return certificate;
}

std::string verdict_line(const Certificate& certificate, std::string_view subject) {
  std::string line(name(certificate.verdict));
  if (certificate.verdict == Verdict::verified) return line;
  if (!subject.empty()) line.append(": ").append(subject);
  if (certificate.verdict != Verdict::malformed) line += ": " + certificate.rule;
  return line + ": " + certificate.message;
}

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
