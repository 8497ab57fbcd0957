#include "certify/verdict/report.h"

#include <array>

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

}  // namespace epsnet::certify
