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

/// All rules; work is not counted yet.
Certificate check_rules(const NetDocument& document, const CheckOptions& options, const Budget& budget) {
  const auto progress = [&](std::string_view rule) {
    if (options.progress) options.progress(rule, 0);
  };
  Certificate certificate;
  progress("structure");
  if (const auto problem = structure_problem(document)) {
    certificate.verdict = Verdict::malformed;
    certificate.rule = "structure";
    certificate.message = *problem;
    return certificate;
  }
  certificate.claim =
      document.collars ? "a pseudo epsilon-net: an epsilon-net of the epsilon-thick part" : "an epsilon-net";
  certificate.counts.vertices = document.vertices.size();
  certificate.counts.triangles = document.triangles.size();
  certificate.counts.edges = 3 * document.triangles.size() / 2;
  certificate.counts.tiles = number_of_tiles(document.surface);
  certificate.counts.charts = document.charts.size();
  certificate.counts.labels = document.labels.size();
  if (document.collars) certificate.counts.collars = document.collars->size();
  const unsigned threads = options.threads != 0 ? options.threads : std::max(std::thread::hardware_concurrency(), 1U);
  CheckOptions bounded = options;
  bounded.max_precision = std::clamp(options.max_precision, kLeastPrecision, kGreatestPrecision);

  progress("surface");
  SurfaceOutcome surface = check_surface(document.surface, threads, budget);
  certificate.rules.push_back(surface.report);
  if (surface.report.verdict != Verdict::verified) return conclude(std::move(certificate));
  certificate.counts.genus = surface.genus;

  progress("map");
  certificate.rules.push_back(check_map(document, surface.genus));
  if (certificate.rules.back().verdict != Verdict::verified) return conclude(std::move(certificate));

  progress("gluing");
  LabelParts parts{std::move(surface.crossings), {}, budget};
  std::optional<LabelEvaluator> labels;
  try {
    parts.frames = chart_frames(document.charts, budget);
    labels.emplace(document, parts);
  } catch (const BudgetSpent& spent) {
    certificate.rules.push_back({"gluing", Verdict::undecided, spent.what()});
    return conclude(std::move(certificate));
  }
  const LabelEvaluator& evaluator = *labels;
  const GluingOutcome gluing = check_gluing(document, evaluator, parts, bounded.max_precision, threads);
  certificate.rules.push_back(gluing.report);
  certificate.counts.label_identities = gluing.identities;
  certificate.counts.max_precision_used = gluing.max_precision;
  if (gluing.report.verdict == Verdict::refuted) return conclude(std::move(certificate));

  std::optional<Interval> shortest_core;
  if (document.collars) {
    progress("collars");
    const CollarsOutcome collars = check_collars(document, evaluator, parts, bounded.max_precision);
    certificate.rules.push_back(collars.report);
    certificate.counts.max_precision_used = std::max(certificate.counts.max_precision_used, collars.max_precision);
    if (collars.report.verdict == Verdict::refuted) return conclude(std::move(certificate));
    shortest_core = collars.shortest_core;
  }

  // An undecided gluing leaves the triangles what they are: their own rules can still be refuted.
  GeometryOutcome geometry = check_geometry(document, evaluator, bounded, threads);
  certificate.rules.insert(certificate.rules.end(), geometry.reports.begin(), geometry.reports.end());
  certificate.counts.exact_ties = geometry.ties.size();
  certificate.ties = std::move(geometry.ties);
  certificate.counts.triangles_beyond_64_bits = geometry.triangles_beyond_64_bits;
  certificate.counts.max_precision_used = std::max(certificate.counts.max_precision_used, geometry.max_precision);
  certificate.enclosures = Enclosures{.epsilon = geometry.epsilon,
                                      .area = area_of(surface.genus),
                                      .largest_circumradius = geometry.largest_circumradius,
                                      .longest_edge = geometry.longest_edge,
                                      .shortest_edge = geometry.shortest_edge,
                                      .shortest_loop = geometry.shortest_loop,
                                      .shortest_core = shortest_core};
  return conclude(std::move(certificate));
}

}  // namespace

Certificate check(const NetDocument& document, const CheckOptions& options) {
  const std::uint64_t work = options.max_work != 0 ? options.max_work : work_allowed(least_bytes(document));
  const Budget budget(work);
  Certificate certificate = check_rules(document, options, budget);
  certificate.counts.work = work - budget.left();
  return certificate;
}

}  // namespace epsnet::certify
