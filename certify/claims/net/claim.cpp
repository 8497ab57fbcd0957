#include "certify/claims/net/claim.h"

#include <optional>
#include <utility>

#include "certify/claims/net/collars.h"
#include "certify/net/geometry_check.h"
#include "certify/net/numbering.h"
#include "certify/net/surface_check.h"
#include "certify/net/triangulation_check.h"

namespace epsnet::certify {
namespace {

/// The rules in their order, each with what the rules before it made. Each says whether the next one can be asked.
class NetRules {
 public:
  NetRules(const NetDocument& document, Verification& run) : document_(document), run_(run) {}

  /// The crossings of the surface, if rule `surface` is verified. BudgetSpent leaves the next rule to be given up.
  Crossings ask() {
    count();
    if (surface() && map() && gluing() && collars()) geometry();
    return std::move(parts_.crossings);
  }

 private:
  /// What can be counted before anything is proved.
  void count() {
    counts_.vertices = document_.vertices.size();
    counts_.triangles = document_.triangles.size();
    counts_.edges = 3 * document_.triangles.size() / 2;
    counts_.tiles = number_of_tiles(document_.surface);
    counts_.charts = document_.charts.size();
    counts_.labels = document_.labels.size();
    if (document_.collars) counts_.collars = document_.collars->size();
  }

  bool surface() {
    run_.progress("surface");
    SurfaceOutcome outcome = check_surface(document_.surface, run_.threads(), run_.budget());
    if (run_.report(std::move(outcome.report)) != Verdict::verified) return false;
    counts_.genus = outcome.genus;
    parts_.crossings = std::move(outcome.crossings);
    return true;
  }

  bool map() {
    run_.progress("map");
    return run_.report(check_map(document_, counts_.genus, run_.threads())) == Verdict::verified;
  }

  bool gluing() {
    run_.progress("gluing");
    parts_ = label_parts(std::move(parts_.crossings), document_.charts, run_.budget());
    evaluator_.emplace(document_, parts_);
    GluingOutcome outcome = check_gluing(document_, *evaluator_, parts_, run_.options().max_precision, run_.threads());
    counts_.label_identities = outcome.identities;
    run_.used(outcome.max_precision);
    // An undecided gluing leaves the triangles what they are: their own rules can still be refuted.
    return run_.report(std::move(outcome.report)) != Verdict::refuted;
  }

  bool collars() {
    if (!document_.collars) return true;
    run_.progress("collars");
    CollarsOutcome outcome = check_collars(document_, *evaluator_, parts_, run_.options().max_precision);
    run_.used(outcome.max_precision);
    shortest_core_ = outcome.shortest_core;
    return run_.report(std::move(outcome.report)) != Verdict::refuted;
  }

  void geometry() {
    GeometryOutcome outcome = check_geometry(document_, *evaluator_, run_.options(), run_.threads());
    for (RuleReport& report : outcome.reports) run_.report(std::move(report));
    run_.used(outcome.max_precision);
    counts_.exact_ties = outcome.ties.size();
    counts_.triangles_beyond_64_bits = outcome.triangles_beyond_64_bits;
    run_.certificate().ties = std::move(outcome.ties);
    outcome.enclosures.area = area_of(counts_.genus);
    outcome.enclosures.shortest_core = shortest_core_;
    run_.certificate().enclosures = outcome.enclosures;
  }

  const NetDocument& document_;
  Verification& run_;
  Counts& counts_ = run_.certificate().counts;
  LabelParts parts_;
  std::optional<LabelEvaluator> evaluator_;  ///< From rule `gluing` on.
  std::optional<Interval> shortest_core_;
};

}  // namespace

Interval area_of(std::uint64_t genus) {
  const Precision scope(128);
  return outer_interval(4 * (genus - 1) * pi());
}

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
    Crossings crossings = NetRules(claim.net, run).ask();
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
