#include "certify/verdict/report.h"

namespace epsnet::certify {

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::verified:
      return "VERIFIED";
    case Verdict::refuted:
      return "REFUTED";
    case Verdict::undecided:
      return "UNDECIDED";
    case Verdict::malformed:
      break;
  }
  return "MALFORMED";
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
