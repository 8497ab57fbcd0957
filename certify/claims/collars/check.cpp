#include "certify/claims/collars/check.h"

#include <algorithm>
#include <map>
#include <string>

#include "certify/base/counted.h"
#include "certify/base/text.h"
#include "certify/net/darts.h"
#include "certify/net/gluing_check.h"
#include "certify/net/surface_check.h"
#include "certify/numbers/precision.h"

namespace epsnet::certify {
namespace {

using Problem = std::optional<std::string>;

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

/// |z|², of a ball each.
Ball norm(const ComplexBall& z, slong precision) {
  Ball result, square;
  arb_sqr(result.get(), z.re(), precision);
  arb_sqr(square.get(), z.im(), precision);
  arb_add(result.get(), result.get(), square.get(), precision);
  return result;
}

/// sinh(l/2) sinh(h) with the length l of a translation γ and the distance h from its axis, positive on one side of it,
/// either one, of the point to which a label takes a vertex. The fixed points of γ = (a, b) are the z with |z| = 1 and
/// Im(b̄z) = Im a, so this is (2 Im(b̄z) − (1 + |z|²) Im a)/(1 − |z|²); with z = n/d nothing but 1 − |w|² is divided by.
Ball height(const BallIsometry& translation, const BallIsometry& label, const NetDocument::Vertex& vertex,
            slong precision) {
  ComplexBall w, n, d, product;
  arb_set_d(w.re(), vertex.x);
  arb_set_d(w.im(), vertex.y);
  acb_mul(n.get(), label.a.get(), w.get(), precision);
  acb_add(n.get(), n.get(), label.b.get(), precision);
  acb_conj(d.get(), w.get());  // d̄ = b w̄ + a.
  acb_mul(d.get(), d.get(), label.b.get(), precision);
  acb_add(d.get(), d.get(), label.a.get(), precision);
  acb_mul(product.get(), n.get(), d.get(), precision);
  ComplexBall conjugate;
  acb_conj(conjugate.get(), translation.b.get());
  acb_mul(product.get(), product.get(), conjugate.get(), precision);
  Ball result, sum, gap;
  arb_mul_2exp_si(result.get(), product.im(), 1);
  arb_add(sum.get(), norm(n, precision).get(), norm(d, precision).get(), precision);
  arb_mul(sum.get(), sum.get(), translation.a.im(), precision);
  arb_sub(result.get(), result.get(), sum.get(), precision);
  arb_sub_ui(gap.get(), norm(w, precision).get(), 1, precision);
  arb_neg(gap.get(), gap.get());
  arb_div(result.get(), result.get(), gap.get(), precision);
  return result;
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
Ball arsinh_of_root(const Ball& numerator, const Ball& s, slong precision) {
  Ball result;
  arb_div(result.get(), numerator.get(), s.get(), precision);
  arb_sqrtpos(result.get(), result.get(), precision);
  arb_asinh(result.get(), result.get(), precision);
  return result;
}

Measures measure(const mpq_class& epsilon, const BallIsometry& loop, std::array<Ball, 2> heights, slong precision) {
  Measures m;
  m.heights = std::move(heights);
  // sinh²(l/2) = |b|² − (Im a)².
  Ball square;
  half_displacement_squared(m.s.get(), loop, precision);
  arb_sqr(square.get(), loop.a.im(), precision);
  arb_sub(m.s.get(), m.s.get(), square.get(), precision);
  set_rational(m.epsilon.get(), epsilon, precision);
  arb_mul_2exp_si(m.e.get(), m.epsilon.get(), -1);
  arb_sinh(m.e.get(), m.e.get(), precision);
  arb_sqr(m.e.get(), m.e.get(), precision);
  arb_sqrtpos(m.length.get(), m.s.get(), precision);
  arb_asinh(m.length.get(), m.length.get(), precision);
  arb_mul_2exp_si(m.length.get(), m.length.get(), 1);
  for (std::size_t i = 0; i < 2; ++i) {
    arb_sqr(square.get(), m.heights[i].get(), precision);
    arb_add(m.h[i].get(), m.s.get(), square.get(), precision);
    m.distances[i] = arsinh_of_root(square, m.s, precision);
  }
  arb_sub(square.get(), m.e.get(), m.s.get(), precision);
  m.thin_width = arsinh_of_root(square, m.s, precision);
  return m;
}

/// Clause (g): 2 arsinh(sinh(l/4) cosh d) + (d − d_ε) < ε.
Tri covers(const Measures& m, std::size_t i, slong precision) {
  Ball reach, cosh;
  arb_mul_2exp_si(reach.get(), m.length.get(), -2);
  arb_sinh(reach.get(), reach.get(), precision);
  arb_cosh(cosh.get(), m.distances[i].get(), precision);
  arb_mul(reach.get(), reach.get(), cosh.get(), precision);
  arb_asinh(reach.get(), reach.get(), precision);
  arb_mul_2exp_si(reach.get(), reach.get(), 1);
  arb_add(reach.get(), reach.get(), m.distances[i].get(), precision);
  arb_sub(reach.get(), reach.get(), m.thin_width.get(), precision);
  return certainly_less(reach.get(), m.epsilon.get());
}

/// Something that a collar must satisfy, and what to say if it does not.
struct Clause {
  Tri holds;
  std::string otherwise;
};

/// Clauses (d) to (g).
std::vector<Clause> clauses(const NetDocument::Collar& collar, const Measures& m, slong precision) {
  const Interval length = outer_interval(m.length.get());
  const std::string found = "the core has a length in " + to_string(length);
  Ball least, most, product;
  arb_set_d(least.get(), collar.length[0]);
  arb_set_d(most.get(), collar.length[1]);
  arb_mul(product.get(), m.heights[0].get(), m.heights[1].get(), precision);
  arb_neg(product.get(), product.get());
  std::vector<Clause> result{
      {certainly_positive(m.s.get()), "the core is no closed geodesic"},
      {!certainly_less(m.length.get(), least.get()), found + ", less than the file says"},
      {!certainly_less(most.get(), m.length.get()), found + ", more than the file says"},
      {certainly_less(m.s.get(), m.e.get()), found + ", greater than epsilon"},
      {certainly_positive(product.get()), "the two vertices are not on different sides of the core"}};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string vertex = "vertex " + std::to_string(collar.vertices[i]);
    result.push_back({!certainly_less(m.h[i].get(), m.e.get()), vertex + " is in the epsilon-thin part"});
    result.push_back({covers(m, i, precision), vertex + " does not cover the thick part of its side of the annulus"});
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
    decide("epsilon", outcome, [&](slong precision) { return epsilon_clause(precision); });
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
  [[nodiscard]] Clause epsilon_clause(slong precision) const {
    Ball twice, limit;
    set_rational(twice.get(), 2 * epsilon_, precision);
    arb_const_log2(limit.get(), precision);
    return {certainly_less(twice.get(), limit.get()), "it is greater than ln sqrt(2), the limit for a pseudo net"};
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
      const Measures measures =
          measure(epsilon_, loop,
                  {height(loop, from, document_.vertices[p], precision),
                   height(loop, label(previous_dart(at_p), precision), document_.vertices[q], precision)},
                  precision);
      all = clauses(collar, measures, precision);
      if (first_failure(all).holds == Tri::yes) {
        const Interval length = outer_interval(measures.length.get());
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
    const std::uint32_t chart = document_.vertices[collar.vertices[0]].chart;
    const auto& disk = disk_of(document_.charts[chart].tile);
    Tri same = Tri::unknown;
    if (disk) {
      const BallIsometry core =
          evaluator_.evaluate(std::array{evaluator_.core_number(c)}, precision, 4 * precision, 1).front();
      // From 0 to the disk's centre, in the coordinates of the chart.
      parts_.budget.spend(to_balls_work(bits(parts_.frames[chart]) + bits(disk->centre), 0));
      const BallIsometry base =
          to_balls(compose(inverse(parts_.frames[chart]), translation_to(disk->centre)), precision);
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
