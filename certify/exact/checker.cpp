#include "certify/exact/checker.h"

#include <optional>
#include <string>
#include <vector>

#include "certify/exact/claim_rules.h"
#include "certify/exact/document.h"
#include "certify/exact/json.h"
#include "certify/exact/net_rules.h"

namespace epsnet::exact {
namespace {

/// Whether the file is one of those that this checker leaves to the other.
std::optional<std::string> not_for_this_checker(const Json& root) {
  const Json& format = member(root, "format");
  for (const std::string kind : {"geodesics", "eigenvalues"}) {
    if (is_text(format, "epsnet-" + kind)) return kind + " files";
  }
  const Json* net = is_text(format, "epsnet-net") ? &root : find(root, "net");
  const Json* surface = net == nullptr ? nullptr : find(*net, "surface");
  const Json* kind = surface == nullptr ? nullptr : find(*surface, "kind");
  if (kind != nullptr && is_text(*kind, "regular")) return "regular surfaces";
  if (kind != nullptr && is_text(*kind, "map")) return "maps of regular tiles";
  return std::nullopt;
}

Result left_out(const std::string& kind) { return {Verdict::undecided, kLeftOut, "not for this checker: " + kind}; }

/// Asks the rules in their order until one does not hold or is not decided.
Result ask(const std::vector<Rule>& rules) {
  for (const Rule& rule : rules) {
    try {
      rule.ask();
    } catch (const Refutation& refutation) {
      return {Verdict::refuted, rule.name, refutation.what};
    } catch (const TooLarge& question) {
      return {Verdict::undecided, rule.name, question.what};
    }
  }
  return {Verdict::verified, "", ""};
}

/// A claim about a net: the rules of the net, then its own.
template <class Document, class OwnRules>
Result check_claim(const Document& document, const OwnRules& own_rules) {
  NetRules net(document.net);
  std::vector<Rule> rules = net.rules();
  for (Rule& rule : own_rules(document, net)) rules.push_back(std::move(rule));
  return ask(rules);
}

}  // namespace

Result check(std::string_view text) {
  if (text.starts_with("\211EPSNET\n")) return left_out("compact files");
  try {
    const Json root = parse_json(text);
    if (root.kind != Json::Kind::object) throw Malformed("expected an object");
    if (const auto reason = not_for_this_checker(root)) {
      return left_out(*reason);
    }
    const Json& format = member(root, "format");
    if (is_text(format, "epsnet-distance")) return check_claim(read_distance(root), distance_rules);
    if (is_text(format, "epsnet-cover")) return check_claim(read_bound(root), bound_rules);
    const Net net = read_net(root);
    NetRules rules(net);
    return ask(rules.rules());
  } catch (const Malformed& error) {
    return {Verdict::malformed, "", error.what()};
  }
}

}  // namespace epsnet::exact
