#include "certify/program/second_checker.h"

#include <utility>

#include "certify/base/text.h"

namespace epsnet::certify::program {
namespace {

Verdict verdict_of(exact::Verdict verdict) {
  switch (verdict) {
    case exact::Verdict::verified:
      return Verdict::verified;
    case exact::Verdict::refuted:
      return Verdict::refuted;
    case exact::Verdict::malformed:
      return Verdict::malformed;
    case exact::Verdict::undecided:
      break;
  }
  return Verdict::undecided;
}

}  // namespace

SecondOpinion ask_second_checker(std::string_view bytes, bool exact) {
  const exact::Result result = exact::check(bytes, exact ? exact::kMostLifts : exact::kUsualLifts);
  return {verdict_of(result.verdict), printable(result.rule), printable(result.message)};
}

std::string verdict_line(const SecondOpinion& opinion) {
  std::string line(name(opinion.verdict));
  if (!opinion.rule.empty()) line += ": " + opinion.rule;
  if (!opinion.message.empty()) line += ": " + opinion.message;
  return line;
}

bool disagree(Verdict first, Verdict second) {
  const auto denies = [](Verdict verdict) { return verdict == Verdict::refuted || verdict == Verdict::malformed; };
  return (first == Verdict::verified && denies(second)) || (denies(first) && second == Verdict::verified);
}

Certificate agreed(Certificate first, const SecondOpinion& second) {
  if (!disagree(first.verdict, second.verdict)) return first;
  first.message = "the two checkers disagree: certify says " + verdict_line(first) + "; certify-exact says " +
                  verdict_line(second) + "; please report this, with the file, to the authors of epsnet";
  first.rule = kAgreement;
  first.verdict = Verdict::undecided;
  return first;
}

}  // namespace epsnet::certify::program
