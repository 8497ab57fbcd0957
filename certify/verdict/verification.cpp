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

}  // namespace epsnet::certify
