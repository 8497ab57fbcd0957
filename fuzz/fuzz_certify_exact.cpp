#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/file/file.h"

namespace {

using namespace epsnet;

/// Returns the verdict of `certify` without its second checker, and the rule that it names.
certify::Verdict first_opinion(std::string_view text, std::string& rule) {
  try {
    const auto document = certify::parse_file<certify::ClaimDocument>(text, "input");
    const certify::Certificate certificate =
        certify::check(document, {.threads = 1, .max_precision = 512, .max_work = 400'000'000});
    rule = certificate.rule;
    return certificate.verdict;
  } catch (const certify::MalformedError&) {
    return certify::Verdict::malformed;
  }
}

}  // namespace

/// For any bytes: if both checkers decide, they agree, and refute a file by the same rule.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  constexpr long kLifts = 1000;  // One of the two takes long with more.
  const exact::Result second = exact::check(
      text, {.lifts = kLifts, .lifts_under_isometries = kLifts, .values = kLifts, .bounds = 10'000 * kLifts});
  if (second.verdict == exact::Verdict::undecided) return 0;
  std::string rule;
  const certify::Verdict first = first_opinion(text, rule);
  if (first == certify::Verdict::undecided) return 0;
  const auto same = [&] {
    switch (second.verdict) {
      case exact::Verdict::verified:
        return first == certify::Verdict::verified;
      case exact::Verdict::refuted:
        return first == certify::Verdict::refuted && second.rule == rule;
      case exact::Verdict::malformed:
        return first == certify::Verdict::malformed;
      case exact::Verdict::undecided:
        break;
    }
    return true;
  };
  if (!same()) std::abort();
  return 0;
}
