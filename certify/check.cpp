#include "certify/check.h"

#include <algorithm>
#include <thread>

#include "certify/collars/collar_check.h"
#include "certify/document/least_bytes.h"
#include "certify/document/structure_check.h"
#include "certify/document/surface_sides.h"
#include "certify/geometry_check.h"
#include "certify/gluing_check.h"
#include "certify/map_check.h"
#include "certify/surface_check.h"

namespace epsnet::certify {
namespace {

/// Writes the final verdict from the rules: the first refuted one, else the first undecided one, else verified.
Certificate conclude(Certificate certificate) {
  for (const Verdict wanted : {Verdict::refuted, Verdict::undecided}) {
    for (const RuleReport& report : certificate.rules) {
      if (report.verdict != wanted) continue;
      certificate.verdict = wanted;
      certificate.rule = report.rule;
      certificate.message = report.text;
      return certificate;
    }
  }
  // Nothing is verified unless all seven rules, nine for a pseudo net, were evaluated and every one of them was.
  const std::size_t rules = certificate.counts.collars ? 9 : 7;
  const bool all = certificate.rules.size() == rules &&
                   std::all_of(certificate.rules.begin(), certificate.rules.end(),
                               [](const RuleReport& report) { return report.verdict == Verdict::verified; });
  certificate.verdict = all ? Verdict::verified : Verdict::undecided;
  return certificate;
}

/// 4π(g − 1).
Interval area_of(std::uint64_t genus) {
  Ball area;
  arb_const_pi(area.get(), 128);
  arb_mul_ui(area.get(), area.get(), 4 * (genus - 1), 128);
  return outer_interval(area.get());
}

Certificate malformed(const std::string& problem) {
  Certificate certificate;
  certificate.verdict = Verdict::malformed;
  certificate.rule = "structure";
  certificate.message = problem;
  return certificate;
}

CheckOptions bounded(CheckOptions options) {
  if (options.threads == 0) options.threads = std::max(std::thread::hardware_concurrency(), 1U);
  options.max_precision = std::clamp(options.max_precision, kLeastPrecision, kGreatestPrecision);
  return options;
}

/// The rules in their order, each with what the rules before it made; work is not counted yet.
class RuleChecker {
 public:
  RuleChecker(const NetDocument& document, const CheckOptions& options, const Budget& budget)
      : document_(document), options_(bounded(options)), parts_{{}, {}, budget} {}

  Certificate run() {
    progress("structure");
    if (const auto problem = structure_problem(document_)) return malformed(*problem);
    describe();
    if (surface() && map() && gluing() && collars()) geometry();
    return conclude(std::move(certificate_));
  }

 private:
  void progress(std::string_view rule) const {
    if (options_.progress) options_.progress(rule, 0);
  }

  /// Adds a report; whether its verdict is not `refuted`.
  bool add(RuleReport report) {
    certificate_.rules.push_back(std::move(report));
    return certificate_.rules.back().verdict != Verdict::refuted;
  }

  void used(std::uint64_t precision) {
    certificate_.counts.max_precision_used = std::max(certificate_.counts.max_precision_used, precision);
  }

  /// The claim, and what can be counted before anything is proved.
  void describe() {
    certificate_.claim =
        document_.collars ? "a pseudo epsilon-net: an epsilon-net of the epsilon-thick part" : "an epsilon-net";
    Counts& counts = certificate_.counts;
    counts.vertices = document_.vertices.size();
    counts.triangles = document_.triangles.size();
    counts.edges = 3 * document_.triangles.size() / 2;
    counts.tiles = number_of_tiles(document_.surface);
    counts.charts = document_.charts.size();
    counts.labels = document_.labels.size();
    if (document_.collars) counts.collars = document_.collars->size();
  }

  // Each rule says whether the next one can be asked.

  bool surface() {
    progress("surface");
    SurfaceOutcome outcome = check_surface(document_.surface, options_.threads, parts_.budget);
    add(outcome.report);
    if (outcome.report.verdict != Verdict::verified) return false;
    certificate_.counts.genus = outcome.genus;
    parts_.crossings = std::move(outcome.crossings);
    return true;
  }

  bool map() {
    progress("map");
    add(check_map(document_, certificate_.counts.genus));
    return certificate_.rules.back().verdict == Verdict::verified;
  }

  bool gluing() {
    progress("gluing");
    try {
      parts_.frames = chart_frames(document_.charts, parts_.budget);
      evaluator_.emplace(document_, parts_);
    } catch (const BudgetSpent& spent) {
      add({"gluing", Verdict::undecided, spent.what()});
      return false;
    }
    const GluingOutcome outcome =
        check_gluing(document_, *evaluator_, parts_, options_.max_precision, options_.threads);
    certificate_.counts.label_identities = outcome.identities;
    used(outcome.max_precision);
    // An undecided gluing leaves the triangles what they are: their own rules can still be refuted.
    return add(outcome.report);
  }

  bool collars() {
    if (!document_.collars) return true;
    progress("collars");
    const CollarsOutcome outcome = check_collars(document_, *evaluator_, parts_, options_.max_precision);
    used(outcome.max_precision);
    shortest_core_ = outcome.shortest_core;
    return add(outcome.report);
  }

  void geometry() {
    GeometryOutcome outcome = check_geometry(document_, *evaluator_, options_, options_.threads);
    for (RuleReport& report : outcome.reports) add(std::move(report));
    certificate_.counts.exact_ties = outcome.ties.size();
    certificate_.ties = std::move(outcome.ties);
    certificate_.counts.triangles_beyond_64_bits = outcome.triangles_beyond_64_bits;
    used(outcome.max_precision);
    certificate_.enclosures = Enclosures{.epsilon = outcome.epsilon,
                                         .area = area_of(certificate_.counts.genus),
                                         .largest_circumradius = outcome.largest_circumradius,
                                         .longest_edge = outcome.longest_edge,
                                         .shortest_edge = outcome.shortest_edge,
                                         .shortest_loop = outcome.shortest_loop,
                                         .shortest_core = shortest_core_};
  }

  const NetDocument& document_;
  CheckOptions options_;
  LabelParts parts_;
  std::optional<LabelEvaluator> evaluator_;  ///< From rule `gluing` on.
  std::optional<Interval> shortest_core_;
  Certificate certificate_;
};

}  // namespace

Certificate check(const NetDocument& document, const CheckOptions& options) {
  const std::uint64_t work = options.max_work != 0 ? options.max_work : work_allowed(least_bytes(document));
  const Budget budget(work);
  Certificate certificate = RuleChecker(document, options, budget).run();
  certificate.counts.work = work - budget.left();
  return certificate;
}

}  // namespace epsnet::certify
