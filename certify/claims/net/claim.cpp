#include "certify/claims/net/claim.h"

#include <utility>

#include "certify/claims/net/net_rules.h"

namespace epsnet::certify {

RuleNames with_net_rules(const NetDocument& net, const RuleNames& own) {
  RuleNames rules{"surface", "map", "gluing", "orientation", "delaunay", "covering", "packing"};
  if (net.collars)
    rules = {"surface", "map", "gluing", "collars", "orientation", "delaunay", "covering", "packing", "thick"};
  rules.insert(rules.end(), own.begin(), own.end());
  return rules;
}

Claim claim_of(const NetDocument& document) {
  const char* const text =
      document.collars ? "a pseudo epsilon-net: an epsilon-net of the epsilon-thick part" : "an epsilon-net";
  return {document, text, own_rules(document), {}};
}

Certificate verify(const Claim& claim, std::uint64_t least_bytes, const CheckOptions& options) {
  Verification run(options, least_bytes, with_net_rules(claim.net, claim.rules), claim.text);
  try {
    Crossings crossings = ask_net_rules(claim.net, run);
    if (claim.ask && run.rules().verified_so_far()) {
      if (claim.net.triangles.size() > options.max_triangles) {
        run.give_up("the net has more triangles than the limit, " + std::to_string(options.max_triangles));
      } else {
        claim.ask(run, std::move(crossings));
      }
    }
  } catch (const BudgetSpent& spent) {
    run.give_up(spent.what());
  }
  return run.conclude();
}

}  // namespace epsnet::certify
