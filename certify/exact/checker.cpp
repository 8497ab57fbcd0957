#include "certify/exact/checker.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/document.h"
#include "certify/exact/isometry_rules.h"
#include "certify/exact/json.h"
#include "certify/exact/net_rules.h"

namespace epsnet::exact {
namespace {

Result left_out(const std::string& kind) { return {Verdict::undecided, kLeftOut, "not for this checker: " + kind}; }

/// Asks the rules in their order until one does not hold or is not decided.
Result ask(const std::vector<Rule>& rules) {
  Result result{Verdict::verified, "", ""};
  for (const Rule& rule : rules) {
    try {
      rule.ask();
    } catch (const Refutation& refutation) {
      return {Verdict::refuted, rule.name, refutation.what};
    } catch (const TooLarge& question) {
      if (result.verdict == Verdict::verified) result = {Verdict::undecided, rule.name, question.what};
      if (!rule.may_be_open) break;
    }
  }
  return result;
}

/// What `use` returns for the rules of a net.
template <class Use>
Result with_rules(const Net& net, const Use& use) {
  if (net.regular) return use(*std::make_unique<NetRules<Algebraic>>(net));
  if (net.field) return use(*std::make_unique<NetRules<FieldNumber>>(net));
  return use(*std::make_unique<NetRules<mpz_class>>(net));
}

/// The rules of the net, then those that own_rules says.
template <class OwnRules>
Result ask_all(const Net& net, const OwnRules& own_rules) {
  return with_rules(net, [&](auto& net_rules) { return ask(joined(net_rules, own_rules(net_rules))); });
}

/// Throws if the rules of a document within another one are not verified.
void expect_verified(const Result& result) {
  const std::string why = result.rule + ": " + result.message;
  if (result.verdict == Verdict::refuted) throw Refutation{why};
  if (result.verdict != Verdict::verified) throw TooLarge{why};
}

Result check_comparison(const ComparisonDocument& document, long most_lifts) {
  const AskRules ask_other = [](const std::vector<Rule>& rules) { expect_verified(ask(rules)); };
  return with_rules(document.first.net, [&](auto& net) {
    return with_rules(document.other.net, [&](auto& other) {
      const bool different = document.claim == ComparisonDocument::Claim::different;
      return ask(joined(net, different ? different_rules(document, net, other, ask_other, most_lifts)
                                       : isometric_rules(document, net, other, ask_other)));
    });
  });
}

}  // namespace

Result check(std::string_view text, const Limits& limits) {
  if (text.starts_with("\211EPSNET\n")) return left_out("compact files");
  try {
    const Json root = parse_json(text);
    if (root.kind != Json::Kind::object) throw Malformed("expected an object");
    const Json& format = member(root, "format");
    if (is_text(format, "epsnet-geodesics")) {
      const GeodesicsDocument document = read_geodesics(root);
      return ask_all(document.net, [&](auto& net) { return geodesic_rules(document, net, limits.lifts); });
    }
    if (is_text(format, "epsnet-distance")) {
      const DistanceDocument document = read_distance(root);
      return ask_all(document.net, [&](auto& net) { return distance_rules(document, net); });
    }
    if (is_text(format, "epsnet-cover")) {
      const BoundDocument document = read_bound(root);
      return ask_all(document.net, [&](auto& net) { return bound_rules(document, net, limits.bounds); });
    }
    if (is_text(format, "epsnet-eigenvalues")) {
      const EigenvaluesDocument document = read_eigenvalues(root);
      return ask_all(document.net, [&](auto& net) { return eigenvalue_rules(document, net, limits.values); });
    }
    if (is_text(format, "epsnet-isometries")) {
      const IsometriesDocument document = read_isometries(root);
      return ask_all(document.spectrum.net,
                     [&](auto& net) { return isometry_rules(document, net, limits.lifts_under_isometries); });
    }
    if (is_text(format, "epsnet-comparison")) return check_comparison(read_comparison(root), limits.lifts);
    if (is_text(format, "epsnet-curves")) {
      const CurvesDocument document = read_curves(root);
      return ask_all(document.net, [&](auto& net) { return curve_rules(document, net); });
    }
    if (is_text(format, "epsnet-pants")) {
      const PantsDocument document = read_pants(root);
      return ask_all(document.net, [&](auto& net) { return pants_rules(document, net); });
    }
    return ask_all(read_net(root), [](auto&) { return std::vector<Rule>(); });
  } catch (const LeftOut& question) {
    return left_out(question.what);
  } catch (const Malformed& error) {
    return {Verdict::malformed, "", error.what()};
  }
}

namespace {

/// What the text is by its first bytes, if it is of a kind that epsnet writes and that claims nothing; else nothing.
std::string_view kind_by_beginning(std::string_view text) {
  constexpr std::string_view kBeginnings[][2] = {{"<svg", "an SVG picture"},
                                                 {"\211PNG", "a PNG picture"},
                                                 {"<!DOCTYPE html", "an HTML page"},
                                                 {"<?xml", "a file of XML, such as VTU"},
                                                 {"OFF\n", "a mesh"},
                                                 {"$MeshFormat", "a mesh"},
                                                 {"MeshVersionFormatted", "a mesh"},
                                                 {"MFEM mesh", "a mesh"},
                                                 {"%%MatrixMarket", "a MatrixMarket matrix"},
                                                 {"\223NUMPY", "a NumPy array"},
                                                 {"u\tv\t", "a table"},
                                                 {"from,to,", "a table"},
                                                 {"step,", "a table"}};
  for (const auto& [beginning, kind] : kBeginnings) {
    if (text.starts_with(beginning)) return kind;
  }
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const bool is_number =
      digits > 0 && digits < text.size() && std::string_view(" \t\n\r").find(text[digits]) != std::string_view::npos;
  return is_number ? "a text of numbers, as of CGAL" : "";
}

/// The same of an object by its format.
std::string_view kind_by_format(const Json& format) {
  if (is_text(format, "epsnet-dirichlet")) return "a Dirichlet domain";
  if (is_text(format, "epsnet-matrices")) return "a file of matrices";
  if (is_text(format, "epsnet-mesh")) return "a mesh";
  return "";
}

}  // namespace

std::string why_no_claim(std::string_view text) {
  std::string_view kind = kind_by_beginning(text);
  if (kind.empty()) {
    try {
      const Json root = parse_json(text);
      if (root.kind != Json::Kind::object) return "";
      kind = kind_by_format(member(root, "format"));
      if (kind.empty()) {
        read_surface_file(root);
        return "this is a surface file, which claims nothing; epsnet net FILE --epsilon 0.1 -o net.json makes a net of "
               "it";
      }
    } catch (const Malformed&) {
      return "";
    }
  }
  return "this begins as " + std::string(kind) + ", which claims nothing; files of nets and of answers do";
}

}  // namespace epsnet::exact
