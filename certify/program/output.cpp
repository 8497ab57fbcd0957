#include "certify/program/output.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/numbers/budget.h"

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
  const exact::Result result = exact::check(bytes, exact ? exact::kMostLimits : exact::kUsualLimits);
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

namespace {

int exit_code(Verdict verdict) {
  switch (verdict) {
    case Verdict::verified:
      return kExitVerified;
    case Verdict::refuted:
      return kExitRefuted;
    case Verdict::undecided:
      return kExitUndecided;
    case Verdict::malformed:
      break;
  }
  return kExitMalformed;
}

/// A list of names and values, for both kinds of output.
template <class Visit>
void visit_counts(const Counts& c, const Visit& visit) {
  visit("vertices", c.vertices);
  visit("edges", c.edges);
  visit("triangles", c.triangles);
  visit("genus", c.genus);
  visit("tiles", c.tiles);
  visit("charts", c.charts);
  visit("labels", c.labels);
  visit("label_identities", c.label_identities);
  visit("exact_ties", c.exact_ties);
  visit("triangles_beyond_64_bits", c.triangles_beyond_64_bits);
  visit("max_precision_used", c.max_precision_used);
  visit("work", c.work);
  if (c.collars) visit("collars", *c.collars);
}

template <class Visit>
void visit_enclosures(const Enclosures& e, const Visit& visit) {
  visit("epsilon", e.epsilon);
  visit("area", e.area);
  visit("largest_circumradius", e.largest_circumradius);
  visit("longest_edge", e.longest_edge);
  if (e.shortest_edge) visit("shortest_edge", *e.shortest_edge);
  if (e.shortest_loop) visit("shortest_loop", *e.shortest_loop);
  if (e.shortest_core) visit("shortest_core", *e.shortest_core);
}

template <class Visit>
void visit_geodesics_counts(const GeodesicsCounts& c, const Visit& visit) {
  visit("geodesics", c.geodesics);
  visit("lifted_triangles", c.lifted_triangles);
  visit("candidates", c.candidates);
  visit("deep_vertices", c.deep_vertices);
  visit("geodesics_max_precision_used", c.max_precision_used);
}

/// The checkers that verified the claim; none, unless that is the verdict.
std::vector<const char*> verified_by(const FileReport& report) {
  if (!report.no_claim.empty() || report.certificate.verdict != Verdict::verified) return {};
  if (report.second && report.second->verdict == Verdict::verified) return {"certify", "certify-exact"};
  return {"certify"};
}

std::string joined(const std::vector<const char*>& words, const char* separator) {
  std::string result;
  for (const char* word : words) result.append(result.empty() ? "" : separator).append(word);
  return result;
}

std::string second_checker_line(const FileReport& report) {
  if (report.second) return "second checker: " + verdict_line(*report.second) + '\n';
  return "second checker: not asked, " + report.not_asked + '\n';
}

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// A list of members without its braces.
class Members {
 public:
  void add(std::string_view key, const std::string& value) {
    text_ += (text_.empty() ? "" : ", ") + json_string(key) + ": " + value;
  }
  [[nodiscard]] std::string object() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

template <class Range, class Text>
std::string json_array(const Range& range, const Text& text) {
  std::string result;
  for (const auto& x : range) result += (result.empty() ? "" : ", ") + text(x);
  return "[" + result + "]";
}

/// JSON has no infinity: an unbounded end is null.
std::string json(Interval x) {
  const std::string lower = std::isfinite(x.lower) ? decimal_below(x.lower) : "null";
  const std::string upper = std::isfinite(x.upper) ? decimal_above(x.upper) : "null";
  return "[" + lower + ", " + upper + "]";
}

std::string json(const RuleReport& rule) {
  Members members;
  members.add("rule", json_string(rule.rule));
  members.add("verdict", json_string(name(rule.verdict)));
  members.add("text", json_string(rule.text));
  return members.object();
}

std::string json(const std::optional<SecondOpinion>& second) {
  if (!second) return "null";
  Members members;
  members.add("verdict", json_string(name(second->verdict)));
  members.add("rule", json_string(second->rule));
  members.add("message", json_string(second->message));
  return members.object();
}

/// What is proved and counted.
void add_findings(const FileReport& report, Members& members) {
  const Certificate& certificate = report.certificate;
  members.add("second_checker", json(report.second));
  members.add("verified_by", json_array(verified_by(report), [](const char* checker) { return json_string(checker); }));
  members.add("claim", json_string(certificate.claim));
  members.add("rules", json_array(certificate.rules, [](const RuleReport& rule) { return json(rule); }));
  Members counts;
  visit_counts(certificate.counts, [&](const char* key, std::uint64_t n) { counts.add(key, std::to_string(n)); });
  members.add("counts", counts.object());
  if (certificate.geodesics) {
    Members geodesics;
    visit_geodesics_counts(*certificate.geodesics,
                           [&](const char* key, std::uint64_t n) { geodesics.add(key, std::to_string(n)); });
    members.add("geodesics", geodesics.object());
  }
  if (certificate.enclosures) {
    Members enclosures;
    visit_enclosures(*certificate.enclosures, [&](const char* key, Interval x) { enclosures.add(key, json(x)); });
    members.add("enclosures", enclosures.object());
  }
}

}  // namespace

int exit_code(const FileReport& report) {
  if (report.fault) return kExitFault;
  if (!report.no_claim.empty()) return kExitNoClaim;
  if (report.certificate.rule == kAgreement) return kExitDisagreement;
  return report.error.empty() ? exit_code(report.certificate.verdict) : kExitUsage;
}

std::string verdict_line(const FileReport& report, const std::string& place) {
  if (!report.no_claim.empty()) return "NO CLAIM: " + (place.empty() ? "" : place + ": ") + report.no_claim;
  if (report.error.empty()) {
    const std::string line = verdict_line(report.certificate, place);
    return line.ends_with(BudgetSpent().what()) ? line + "; --max-work allows more" : line;
  }
  return "ERROR: " + (place.empty() ? "" : place + ": ") + report.error;
}

namespace {

/// A key as it is read aloud.
std::string label(std::string_view key) {
  std::string words(key);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

}  // namespace

std::string as_text(const FileReport& report) {
  const Certificate& certificate = report.certificate;
  std::ostringstream out;
  for (const RuleReport& rule : certificate.rules) {
    out << to_string(rule) << '\n';
  }
  if (report.is_claim) {
    const auto line = [&](const char* key, std::uint64_t value) { out << label(key) << ": " << value << '\n'; };
    visit_counts(certificate.counts, line);
    if (certificate.enclosures) {
      visit_enclosures(*certificate.enclosures,
                       [&](const char* key, Interval value) { out << label(key) << ": " << to_string(value) << '\n'; });
    }
    if (certificate.geodesics) visit_geodesics_counts(*certificate.geodesics, line);
  }
  if (!report.sha256.empty()) out << "sha256: " << report.sha256 << '\n';
  if (report.is_claim) out << second_checker_line(report) << "claim: " << certificate.claim << '\n';
  if (!verified_by(report).empty()) out << "verified by: " << joined(verified_by(report), " and ") << '\n';
  return out.str();
}

std::string as_json(const FileReport& report) {
  const Certificate& certificate = report.certificate;
  Members members;
  const bool has_verdict = report.error.empty() && report.no_claim.empty();
  members.add("verdict", has_verdict ? json_string(name(certificate.verdict)) : "null");
  members.add("file", json_string(report.path));
  if (!report.no_claim.empty()) {
    members.add("sha256", json_string(report.sha256));
    members.add("no_claim", json_string(report.no_claim));
  } else if (has_verdict) {
    if (!report.sha256.empty()) members.add("sha256", json_string(report.sha256));
    members.add("rule", json_string(certificate.rule));
    members.add("message", json_string(certificate.message));
    if (report.is_claim) add_findings(report, members);
  } else {
    members.add("error", json_string(report.error));
  }
  return members.object() + '\n';
}

}  // namespace epsnet::certify::program
