#include "certify/claims/net/claim.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/numbers/ball.h"

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

namespace {

std::string name_of(const NetDocument& document, std::size_t c) {
  const auto& [p, q] = (*document.collars)[c].vertices;
  return "collar " + std::to_string(c) + " (vertices " + std::to_string(p) + ", " + std::to_string(q) + ")";
}

/// The dart of a triangle that goes from `twice` to itself, if the corners are `twice`, `twice` and `once`.
std::optional<std::uint32_t> loop_dart(const NetDocument& document, std::uint32_t t, std::uint32_t twice,
                                       std::uint32_t once) {
  for (std::uint32_t dart = 3 * t; dart < 3 * t + 3; ++dart) {
    if (start(document, dart) == twice && start(document, next_dart(dart)) == twice &&
        start(document, previous_dart(dart)) == once) {
      return dart;
    }
  }
  return std::nullopt;
}

/// Clause (b): the two triangles are an annulus between a loop at p and a loop at q. The darts p → p → q → p of t and
/// q → q → p → q of u: p → q lies across q → p.
Problem shape_problem(const NetDocument& document, const NetDocument::Collar& collar) {
  const auto [p, q] = collar.vertices;
  const auto [t, u] = collar.triangles;
  const auto at_p = loop_dart(document, t, p, q);
  if (!at_p) return "triangle " + std::to_string(t) + " has not two corners at the first vertex, one at the second";
  const auto at_q = loop_dart(document, u, q, p);
  if (!at_q) return "triangle " + std::to_string(u) + " has not two corners at the second vertex, one at the first";
  if (opposite(document, next_dart(*at_p)) != next_dart(*at_q) ||
      opposite(document, previous_dart(*at_p)) != previous_dart(*at_q)) {
    return "the two triangles are not glued along two edges to an annulus";
  }
  return std::nullopt;
}

/// Clauses (a) and (b) for all collars: which is the first wrong one, and what is wrong.
Problem combinatorial_problem(const NetDocument& document) {
  std::vector<bool> triangle_used(document.triangles.size(), false);
  std::vector<bool> vertex_used(document.vertices.size(), false);
  for (std::size_t c = 0; c < document.collars->size(); ++c) {
    const NetDocument::Collar& collar = (*document.collars)[c];
    for (const std::uint32_t t : collar.triangles) {
      if (triangle_used[t]) return name_of(document, c) + ": triangle " + std::to_string(t) + " is named twice";
      triangle_used[t] = true;
    }
    for (const std::uint32_t v : collar.vertices) {
      if (vertex_used[v]) return name_of(document, c) + ": vertex " + std::to_string(v) + " is named twice";
      vertex_used[v] = true;
    }
    if (const auto problem = shape_problem(document, collar)) return name_of(document, c) + ": " + *problem;
  }
  return std::nullopt;
}

/// sinh(l/2) sinh(h) with the length l of a translation γ and the distance h from its axis, positive on one side of it,
/// either one, of the point to which a label takes a vertex. The fixed points of γ = (a, b) are the z with |z| = 1 and
/// Im(b̄z) = Im a, so this is (2 Im(b̄z) − (1 + |z|²) Im a)/(1 − |z|²); with z = n/d nothing but 1 − |w|² is divided by.
Ball height(const BallIsometry& translation, const BallIsometry& label, const NetDocument::Vertex& vertex) {
  const ComplexBall w(Ball::exactly(vertex.x), Ball::exactly(vertex.y));
  const ComplexBall n = label.a * w + label.b;
  const ComplexBall conjugate_d = label.b * conjugate(w) + label.a;
  const Ball imaginary_part = imaginary(n * conjugate_d * conjugate(translation.b));
  return (twice(imaginary_part) - (norm(n) + norm(conjugate_d)) * imaginary(translation.a)) / (1 - norm(w));
}

/// The lengths of one collar in balls. S = sinh²(l/2), E = sinh²(ε/2), and for each of the two vertices at the distance
/// d from the core H = sinh²(loop/2) = S cosh²d (thesis Theorem I.24).
struct Measures {
  Ball s;
  Ball e;
  Ball epsilon;
  Ball length;
  std::array<Ball, 2> heights;    ///< sinh(l/2) sinh(±d).
  std::array<Ball, 2> h;          ///< H.
  std::array<Ball, 2> distances;  ///< d.
  Ball thin_width;                ///< d_ε with sinh(l/2) cosh d_ε = sinh(ε/2).
};

/// arsinh √(numerator/S).
Ball arsinh_of_root(const Ball& numerator, const Ball& s) { return asinh(sqrt_of_nonnegative(numerator / s)); }

Measures measure(const mpq_class& epsilon, const BallIsometry& loop, std::array<Ball, 2> heights) {
  Measures m;
  m.heights = std::move(heights);
  // sinh²(l/2) = |b|² − (Im a)².
  m.s = norm(loop.b) - sqr(imaginary(loop.a));
  m.epsilon = Ball::rounded(epsilon);
  m.e = sqr(sinh(half(m.epsilon)));
  m.length = twice(asinh(sqrt_of_nonnegative(m.s)));
  for (std::size_t i = 0; i < 2; ++i) {
    const Ball square = sqr(m.heights[i]);
    m.h[i] = m.s + square;
    m.distances[i] = arsinh_of_root(square, m.s);
  }
  m.thin_width = arsinh_of_root(m.e - m.s, m.s);
  return m;
}

/// Clause (g): 2 arsinh(sinh(l/4) cosh d) + (d − d_ε) < ε.
Tri covers(const Measures& m, std::size_t i) {
  const Ball& d = m.distances[i];
  return certainly_less(twice(asinh(sinh(scaled(m.length, -2)) * cosh(d))) + d - m.thin_width, m.epsilon);
}

/// Something that a collar must satisfy, and what to say if it does not.
struct Clause {
  Tri holds;
  std::string otherwise;
};

/// Clauses (d) to (g).
std::vector<Clause> clauses(const NetDocument::Collar& collar, const Measures& m) {
  const std::string found = "the core has a length in " + to_string(outer_interval(m.length));
  const auto& [least, most] = collar.length;
  std::vector<Clause> result{
      {certainly_positive(m.s), "the core is no closed geodesic"},
      {!certainly_less(m.length, Ball::exactly(least)), found + ", less than the file says"},
      {!certainly_less(Ball::exactly(most), m.length), found + ", more than the file says"},
      {certainly_less(m.s, m.e), found + ", greater than epsilon"},
      {certainly_negative(m.heights[0] * m.heights[1]), "the two vertices are not on different sides of the core"}};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string vertex = "vertex " + std::to_string(collar.vertices[i]);
    result.push_back({!certainly_less(m.h[i], m.e), vertex + " is in the epsilon-thin part"});
    result.push_back({covers(m, i), vertex + " does not cover the thick part of its side of the annulus"});
  }
  return result;
}

/// Decides collars one after the other, each with the precision that it needs.
class CollarChecker {
 public:
  CollarChecker(const NetDocument& document, const LabelEvaluator& evaluator, const LabelParts& parts,
                long max_precision)
      : document_(document),
        evaluator_(evaluator),
        parts_(parts),
        max_precision_(max_precision),
        epsilon_(decimal(document.epsilon)) {}

  CollarsOutcome run() {
    CollarsOutcome outcome;
    outcome.report = {"collars", Verdict::verified, ""};
    decide("epsilon", outcome, [&](slong) { return epsilon_clause(); });
    if (outcome.report.verdict != Verdict::verified) return outcome;
    if (const auto problem = combinatorial_problem(document_)) {
      outcome.report = {"collars", Verdict::refuted, *problem};
      return outcome;
    }
    for (std::size_t c = 0; c < document_.collars->size() && outcome.report.verdict == Verdict::verified; ++c) {
      decide(name_of(document_, c), outcome, [&](slong precision) { return examine(c, precision, outcome); });
    }
    if (outcome.report.verdict == Verdict::verified) outcome.report.text = proved(outcome);
    return outcome;
  }

 private:
  /// The first clause that is refuted, else the first that is unknown, else the last one.
  static Clause first_failure(const std::vector<Clause>& clauses) {
    for (const Tri wanted : {Tri::no, Tri::unknown}) {
      const auto found =
          std::find_if(clauses.begin(), clauses.end(), [&](const Clause& c) { return c.holds == wanted; });
      if (found != clauses.end()) return *found;
    }
    return clauses.back();
  }

  /// Asks with more and more bits.
  template <class Question>
  void decide(const std::string& subject, CollarsOutcome& outcome, const Question& question) const {
    Clause clause{Tri::unknown, ""};
    with_rising_precision(max_precision_, [&](slong precision) {
      outcome.max_precision = std::max(outcome.max_precision, static_cast<std::uint64_t>(precision));
      clause = question(precision);
      return clause.holds != Tri::unknown;
    });
    if (clause.holds == Tri::no) {
      outcome.report = {"collars", Verdict::refuted, subject + ": " + clause.otherwise};
    } else if (clause.holds == Tri::unknown) {
      outcome.report = {"collars", Verdict::undecided,
                        subject + ": not decided, with " + std::to_string(max_precision_) +
                            " bits, that it is not so that " + clause.otherwise};
    }
  }

  /// e^2ε ≤ 2, never an equality (Lemma 7).
  [[nodiscard]] Clause epsilon_clause() const {
    return {certainly_less(Ball::rounded(mpq_class(2 * epsilon_)), ln2()),
            "it is greater than ln sqrt(2), the limit for a pseudo net"};
  }

  [[nodiscard]] BallIsometry label(std::uint32_t dart, slong precision) const {
    const std::uint32_t number = corner_label(document_, dart);
    if (number == 0) return identity_isometry();
    return evaluator_.evaluate(std::array{number}, precision, 4 * precision, 1).front();
  }

  /// Clauses (c) to (g) of one collar.
  [[nodiscard]] Clause examine(std::size_t c, slong precision, CollarsOutcome& outcome) {
    const auto bits_used = static_cast<std::uint64_t>(precision);
    parts_.budget.spend(500 * ball_work(bits_used) + 20 * function_work(bits_used));
    const NetDocument::Collar& collar = (*document_.collars)[c];
    const auto [p, q] = collar.vertices;
    const std::uint32_t at_p = value_of(loop_dart(document_, collar.triangles[0], p, q), "a collar without its loop");
    const BallIsometry from = label(at_p, precision);
    const BallIsometry to = label(next_dart(at_p), precision);
    std::vector<Clause> all{core_clause(c, compose(inverse(from), to, precision), precision)};
    if (all.front().holds == Tri::yes) {
      // From here on in the chart of the triangle.
      const BallIsometry loop = compose(to, inverse(from), precision);
      const Measures measures = measure(epsilon_, loop,
                                        {height(loop, from, document_.vertices[p]),
                                         height(loop, label(previous_dart(at_p), precision), document_.vertices[q])});
      all = clauses(collar, measures);
      if (first_failure(all).holds == Tri::yes) {
        const Interval length = outer_interval(measures.length);
        Interval& shortest = outcome.shortest_core ? *outcome.shortest_core : outcome.shortest_core.emplace(length);
        shortest = {std::min(shortest.lower, length.lower), std::min(shortest.upper, length.upper)};
      }
    }
    return first_failure(all);
  }

  const std::optional<InscribedDisk>& disk_of(std::uint32_t tile) {
    const auto [found, is_new] = disks_.try_emplace(tile);
    if (is_new) found->second = inscribed_disk(document_.surface, tile, max_precision_, parts_.budget);
    return found->second;
  }

  /// Clause (c): the loop at p, an isometry of p's chart, is the core or its inverse.
  [[nodiscard]] Clause core_clause(std::size_t c, const BallIsometry& loop, slong precision) {
    const NetDocument::Collar& collar = (*document_.collars)[c];
    const std::uint32_t chart = chart_of_core(document_, collar);
    const auto& disk = disk_of(document_.charts[chart].tile);
    Tri same = Tri::unknown;
    if (disk) {
      const BallIsometry core =
          evaluator_.evaluate(std::array{evaluator_.core_number(c)}, precision, 4 * precision, 1).front();
      parts_.budget.spend(to_balls_work(bits(parts_.frames[chart]) + bits(disk->centre), 0));
      const BallIsometry base = base_of(*disk, parts_.frames[chart], precision);
      same = Tri::no;
      for (const BallIsometry& other : {core, inverse(core)}) {
        const BallIsometry quotient = compose(inverse(other), loop, precision);
        const BallIsometry element = compose(inverse(base), compose(quotient, base, precision), precision);
        same = either(same, is_identity(element, disk->sinh_radius, precision));
      }
    }
    return {same, "the loop at vertex " + std::to_string(collar.vertices[0]) + " is not the core"};
  }

  [[nodiscard]] std::string proved(const CollarsOutcome& outcome) const {
    if (document_.collars->empty()) return "there are none, and epsilon is at most ln sqrt(2)";
    return counted(document_.collars->size(), "annulus", "annuli") +
           " of two triangles around closed geodesics no longer " + "than epsilon, the shortest of a length in " +
           to_string(*outcome.shortest_core) + "; their vertices are in the thick part and cover what they have of it";
  }

  const NetDocument& document_;
  const LabelEvaluator& evaluator_;
  const LabelParts& parts_;
  slong max_precision_;
  mpq_class epsilon_;
  std::map<std::uint32_t, std::optional<InscribedDisk>> disks_;  ///< By tile.
};

}  // namespace

CollarsOutcome check_collars(const NetDocument& document, const LabelEvaluator& evaluator, const LabelParts& parts,
                             long max_precision) {
  try {
    return CollarChecker(document, evaluator, parts, max_precision).run();
  } catch (const BudgetSpent& spent) {
    CollarsOutcome outcome;
    outcome.report = {"collars", Verdict::undecided, spent.what()};
    return outcome;
  }
}

}  // namespace epsnet::certify
