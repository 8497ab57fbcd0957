#include <epsnet/certify/collar_check.h>
#include <epsnet/certify/darts.h>
#include <epsnet/certify/geometry_check.h>
#include <epsnet/certify/lifted_triangle.h>
#include <epsnet/certify/parallel.h>
#include <epsnet/certify/text.h>

#include <algorithm>
#include <memory>
#include <string>

namespace epsnet::certify {
namespace {

enum Rule : std::size_t { kOrientation, kDelaunay, kCovering, kPacking, kThick };
constexpr std::array kRules{kOrientation, kDelaunay, kCovering, kPacking, kThick};
constexpr std::array<const char*, 5> kRuleNames{"orientation", "delaunay", "covering", "packing", "thick"};

/// The questions about one triangle, one bit each: 0 orientation, 1 covering, 2 + i Delaunay and 5 + i length of edge
/// i, asked at the smaller of the two darts of an edge only.
using Questions = std::uint8_t;
constexpr Questions kOrientationBit = 1;
constexpr Questions kCoveringBit = 2;
constexpr Questions delaunay_bit(std::uint32_t edge) { return static_cast<Questions>(4U << edge); }
constexpr Questions length_bit(std::uint32_t edge) { return static_cast<Questions>(32U << edge); }

/// Bits of relative accuracy that a length must have before it counts as measured, for useful enclosures.
constexpr slong kMeasuredBits = 30;
/// Exact arithmetic is tried from this precision on: ties defeat every precision; near ties do not reach this one.
constexpr slong kExactFrom = 256;
/// Triangles handed to a thread at a time.
constexpr std::size_t kBlock = 2048;

/// The first triangle of a rule that fails, in file order, with its text.
struct Violation {
  std::size_t triangle;
  std::string text;
};

/// Contains the extreme of all quantities seen; starts empty.
class Extreme {
 public:
  void largest(Interval x) {
    value_ = value_ ? Interval{std::max(value_->lower, x.lower), std::max(value_->upper, x.upper)} : x;
  }
  void smallest(Interval x) {
    value_ = value_ ? Interval{std::min(value_->lower, x.lower), std::min(value_->upper, x.upper)} : x;
  }
  [[nodiscard]] const std::optional<Interval>& value() const { return value_; }

 private:
  std::optional<Interval> value_;
};

/// What was found in some of the triangles. Combined in file order, so nothing depends on which thread found what.
struct Findings {
  std::array<std::optional<Violation>, 5> refuted;
  std::vector<std::uint32_t> ties;
  Extreme circumradius;  ///< Of sinh² R.
  Extreme longest;       ///< Of sinh²(d/2), as the two below.
  Extreme shortest_edge;
  Extreme shortest_loop;

  void refute(Rule rule, std::size_t triangle, const std::string& text) {
    if (!refuted[rule] || triangle < refuted[rule]->triangle) refuted[rule] = Violation{triangle, text};
  }

  void add(const Findings& other) {
    for (const Rule rule : kRules) {
      if (other.refuted[rule]) refute(rule, other.refuted[rule]->triangle, other.refuted[rule]->text);
    }
    ties.insert(ties.end(), other.ties.begin(), other.ties.end());
    if (const auto& x = other.circumradius.value()) circumradius.largest(*x);
    if (const auto& x = other.longest.value()) longest.largest(*x);
    if (const auto& x = other.shortest_edge.value()) shortest_edge.smallest(*x);
    if (const auto& x = other.shortest_loop.value()) shortest_loop.smallest(*x);
  }
};

std::string text(Interval x) {
  return std::string("[").append(shortest(x.lower)).append(", ").append(shortest(x.upper)).append("]");
}

/// From an interval of sinh² of a length to one of the length, times `factor` (1 or 2).
Interval length_interval(Interval squared_sinh, slong factor) {
  Ball x;
  const auto end = [&](double value) {
    arb_set_d(x.get(), std::max(value, 0.0));
    arb_sqrtpos(x.get(), x.get(), 128);
    arb_asinh(x.get(), x.get(), 128);
    arb_mul_si(x.get(), x.get(), factor, 128);
    return outer_interval(x.get());
  };
  if (std::isinf(squared_sinh.upper)) return {end(squared_sinh.lower).lower, squared_sinh.upper};
  return {end(squared_sinh.lower).lower, end(squared_sinh.upper).upper};
}

std::string triangle_name(const Document& document, std::size_t t) {
  const auto& v = document.triangles[t].vertex;
  return "triangle " + std::to_string(t) + " (vertices " + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
         std::to_string(v[2]) + ")";
}

std::string edge_name(const Document& document, std::uint32_t dart) {
  return "the edge of dart " + std::to_string(dart) + " from vertex " + std::to_string(start(document, dart)) +
         " to vertex " + std::to_string(start(document, next_dart(dart)));
}

/// The rule that says that an edge is at least ε long; nothing if it may have any length.
std::optional<Rule> length_rule(const Document& document, const CollarMembers& collars, std::uint32_t dart) {
  const std::uint32_t u = start(document, dart);
  const std::uint32_t v = start(document, next_dart(dart));
  if (u == v) return collars.pseudo() && !collars.has_vertex(u) ? std::optional(kThick) : std::nullopt;
  return collars.are_partners(u, v) ? std::nullopt : std::optional(kPacking);
}

/// One run over the open triangles at one precision.
class Pass {
 public:
  Pass(const Document& document, const CollarMembers& collars, const LabelEvaluator& evaluator,
       const LabelTable& labels, const mpq_class& epsilon, slong precision, bool last)
      : document_(document),
        collars_(collars),
        evaluator_(evaluator),
        labels_(labels),
        precision_(precision),
        last_(last) {
    Ball radius;
    set_rational(radius.get(), epsilon, precision);
    epsilon_ = outer_interval(radius.get());
    arb_sinh(sinh_squared_.get(), radius.get(), precision);
    arb_sqr(sinh_squared_.get(), sinh_squared_.get(), precision);
    arb_mul_2exp_si(radius.get(), radius.get(), -1);
    arb_sinh(half_sinh_squared_.get(), radius.get(), precision);
    arb_sqr(half_sinh_squared_.get(), half_sinh_squared_.get(), precision);
  }

  /// Works on the open questions of triangle t and returns those that stay open.
  Questions examine(std::uint32_t t, Questions open, LiftedTriangle& lifted, Findings& findings) const {
    lifted.load(document_, labels_, t, precision_);
    unsigned still_open = 0;
    if (open & kOrientationBit) still_open |= examine_orientation(t, lifted, findings);
    if (open & kCoveringBit) {
      still_open |=
          collars_.has_triangle(t) ? examine_circumcircle(t, lifted, findings) : examine_covering(t, lifted, findings);
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (open & delaunay_bit(i)) still_open |= examine_delaunay(t, i, lifted, findings);
      if (open & length_bit(i)) still_open |= examine_length(t, i, lifted, findings);
    }
    return static_cast<Questions>(still_open);
  }

 private:
  Questions examine_orientation(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const {
    lifted.measure_orientation(precision_);
    Tri positive = certainly_positive(lifted.orientation.get());
    if (positive == Tri::unknown && try_exactly() && exact_orientation_is_feasible(document_, evaluator_, t)) {
      positive = exact_orientation(document_, evaluator_, t) > 0 ? Tri::yes : Tri::no;
    }
    if (positive == Tri::no) {
      findings.refute(kOrientation, t, triangle_name(document_, t) + " is not strictly counterclockwise");
    }
    return positive == Tri::unknown ? kOrientationBit : Questions{0};
  }

  Questions examine_covering(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const {
    lifted.measure_circumradius(sinh_squared_.get(), precision_);
    const Tri inside = certainly_positive(lifted.radius_slack.get());
    const Interval squared = quotient(lifted.radius_numerator.get(), lifted.radius_denominator.get());
    if (inside == Tri::no) {
      findings.refute(kCovering, t,
                      triangle_name(document_, t) + " has a circumradius in " + text(length_interval(squared, 1)) +
                          ", greater than epsilon in " + text(epsilon_) +
                          (std::isinf(squared.upper) ? " (or no circumcircle)" : ""));
    }
    if (!last_ && (inside == Tri::unknown || (inside == Tri::yes && !measured(lifted.radius_numerator)) ||
                   (inside == Tri::yes && !measured(lifted.radius_denominator)))) {
      return kCoveringBit;
    }
    findings.circumradius.largest(squared);
    return inside == Tri::unknown ? kCoveringBit : Questions{0};
  }

  /// All that rule `covering` asks of a triangle of a collar.
  Questions examine_circumcircle(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const {
    lifted.measure_circumradius(sinh_squared_.get(), precision_);
    const Tri exists = certainly_positive(lifted.radius_denominator.get());
    if (exists == Tri::no) findings.refute(kCovering, t, triangle_name(document_, t) + " has no circumcircle");
    return exists == Tri::unknown ? kCoveringBit : Questions{0};
  }

  Questions examine_delaunay(std::uint32_t t, std::uint32_t i, LiftedTriangle& lifted, Findings& findings) const {
    lifted.measure_cross_ratio(document_, labels_, t, i, precision_);
    if (is_exactly_zero(lifted.cross_ratio.get())) {
      // Nothing was rounded, as happens with coordinates of few digits: a tie already proved.
      findings.ties.push_back(3 * t + i);
      return 0;
    }
    Tri positive = certainly_positive(lifted.cross_ratio.get());
    if (positive == Tri::unknown && try_exactly() && exact_cross_ratio_is_feasible(document_, evaluator_, 3 * t + i)) {
      const int sign = exact_cross_ratio_sign(document_, evaluator_, 3 * t + i);
      positive = sign > 0 ? Tri::yes : Tri::no;
      if (sign == 0) findings.ties.push_back(3 * t + i);
    }
    if (positive == Tri::yes) {
      findings.refute(
          kDelaunay, t,
          edge_name(document_, 3 * t + i) + " is not Delaunay: the cross-ratio has positive imaginary part");
    }
    return positive == Tri::unknown ? delaunay_bit(i) : Questions{0};
  }

  Questions examine_length(std::uint32_t t, std::uint32_t i, LiftedTriangle& lifted, Findings& findings) const {
    const std::uint32_t dart = 3 * t + i;
    const bool loop = start(document_, dart) == start(document_, next_dart(dart));
    const std::optional<Rule> rule = length_rule(document_, collars_, dart);
    lifted.measure_edge(half_sinh_squared_.get(), i, precision_);
    const Tri short_edge = rule ? certainly_positive(lifted.length_lack.get()) : Tri::no;
    const Interval squared = quotient(lifted.squared_difference[i].get(), lifted.gap_product.get());
    if (short_edge == Tri::yes) {
      findings.refute(*rule, t,
                      edge_name(document_, dart) + " has a length in " + text(length_interval(squared, 2)) +
                          ", less than epsilon in " + text(epsilon_));
    }
    if (!last_ && short_edge != Tri::yes &&
        (short_edge == Tri::unknown || !measured(lifted.squared_difference[i]) || !measured(lifted.gap_product))) {
      return length_bit(i);
    }
    findings.longest.largest(squared);
    if (loop || rule) (loop ? findings.shortest_loop : findings.shortest_edge).smallest(squared);
    return short_edge == Tri::unknown ? length_bit(i) : Questions{0};
  }

  [[nodiscard]] bool try_exactly() const { return precision_ >= kExactFrom || last_; }

  [[nodiscard]] static bool measured(const Ball& x) { return arb_rel_accuracy_bits(x.get()) >= kMeasuredBits; }

  const Document& document_;
  const CollarMembers& collars_;
  const LabelEvaluator& evaluator_;
  const LabelTable& labels_;
  slong precision_;
  bool last_;
  Interval epsilon_{};
  Ball sinh_squared_;
  Ball half_sinh_squared_;
};

/// The labels that the open triangles and their neighbours carry, evaluated at one precision.
LabelTable needed_labels(const Document& document, const LabelEvaluator& evaluator,
                         const std::vector<std::uint32_t>& triangles, slong precision, slong cap, unsigned threads) {
  std::vector<char> used(document.labels.size() + 1, 0);
  const auto use = [&](std::uint32_t t) {
    for (const std::uint32_t number : document.triangles[t].label) used[number] = 1;
  };
  for (const std::uint32_t t : triangles) {
    use(t);
    for (const std::uint32_t dart : document.triangles[t].opposite) use(dart / 3);
  }
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t number = 1; number < used.size(); ++number) {
    if (used[number]) numbers.push_back(number);
  }
  return {numbers, evaluator.evaluate(numbers, precision, cap, threads), document.labels.size()};
}

RuleReport report(Rule rule, const Document& document, const CollarMembers& collars, const Findings& findings,
                  const std::vector<std::uint32_t>& open_triangles, const std::vector<Questions>& open, long bits) {
  if (findings.refuted[rule]) return {kRuleNames[rule], Verdict::refuted, findings.refuted[rule]->text};
  for (std::size_t k = 0; k < open_triangles.size(); ++k) {
    const std::uint32_t t = open_triangles[k];
    const std::string with = ", with " + std::to_string(bits) + " bits";
    if (rule == kOrientation && (open[k] & kOrientationBit)) {
      return {kRuleNames[rule], Verdict::undecided,
              triangle_name(document, t) + ": not decided whether it is strictly counterclockwise" + with};
    }
    if (rule == kCovering && (open[k] & kCoveringBit)) {
      return {kRuleNames[rule], Verdict::undecided,
              triangle_name(document, t) + ": not decided whether " +
                  (collars.has_triangle(t) ? "it has a circumcircle" : "the circumradius is at most epsilon") + with};
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (rule == kDelaunay && (open[k] & delaunay_bit(i))) {
        return {kRuleNames[rule], Verdict::undecided,
                edge_name(document, 3 * t + i) + ": not decided whether it is Delaunay" + with};
      }
      if ((open[k] & length_bit(i)) && length_rule(document, collars, 3 * t + i) == rule) {
        return {kRuleNames[rule], Verdict::undecided,
                edge_name(document, 3 * t + i) + ": not decided whether it is at least epsilon long" + with};
      }
    }
  }
  return {kRuleNames[rule], Verdict::verified, ""};
}

}  // namespace

GeometryOutcome check_geometry(const Document& document, const LabelEvaluator& evaluator, const CheckOptions& options,
                               unsigned threads) {
  const mpq_class epsilon = *parse_decimal(document.epsilon);
  const CollarMembers collars(document);
  std::vector<std::uint32_t> triangles(document.triangles.size());
  std::vector<Questions> open(document.triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    triangles[t] = t;
    open[t] = kOrientationBit | kCoveringBit;
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (3 * t + i < opposite(document, 3 * t + i)) {
        open[t] = static_cast<Questions>(open[t] | delaunay_bit(i) | length_bit(i));
      }
    }
  }

  GeometryOutcome outcome;
  Findings all;
  const slong cap = options.max_precision;
  for (slong precision = std::min<slong>(64, cap); !triangles.empty(); precision = std::min(2 * precision, cap)) {
    const bool last = precision >= cap;
    const LabelTable labels =
        needed_labels(document, evaluator, triangles, precision, std::min(4 * precision, 2 * cap), threads);
    const Pass pass(document, collars, evaluator, labels, epsilon, precision, last);
    const std::size_t blocks = (triangles.size() + kBlock - 1) / kBlock;
    std::vector<Findings> found(blocks);
    std::vector<std::unique_ptr<LiftedTriangle>> lifted(std::max(threads, 1U));
    for_each_parallel(blocks, threads, [&](unsigned worker, std::size_t block) {
      if (!lifted[worker]) lifted[worker] = std::make_unique<LiftedTriangle>();
      const std::size_t end = std::min(triangles.size(), (block + 1) * kBlock);
      for (std::size_t k = block * kBlock; k < end; ++k) {
        open[k] = pass.examine(triangles[k], open[k], *lifted[worker], found[block]);
      }
      if (worker == 0 && options.progress) {
        options.progress("geometry", static_cast<double>(block) / static_cast<double>(blocks));
      }
    });
    for (const Findings& findings : found) all.add(findings);
    outcome.max_precision = static_cast<std::uint64_t>(precision);

    std::size_t kept = 0;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      if (open[k] == 0) continue;
      triangles[kept] = triangles[k];
      open[kept++] = open[k];
    }
    triangles.resize(kept);
    open.resize(kept);
    if (precision == 64) outcome.triangles_beyond_64_bits = kept;
    if (last) break;
  }

  Ball radius;
  set_rational(radius.get(), epsilon, 128);
  outcome.epsilon = outer_interval(radius.get());
  outcome.ties = std::move(all.ties);
  std::sort(outcome.ties.begin(), outcome.ties.end());
  if (const auto& x = all.circumradius.value()) outcome.largest_circumradius = length_interval(*x, 1);
  if (const auto& x = all.longest.value()) outcome.longest_edge = length_interval(*x, 2);
  if (const auto& x = all.shortest_edge.value()) outcome.shortest_edge = length_interval(*x, 2);
  if (const auto& x = all.shortest_loop.value()) outcome.shortest_loop = length_interval(*x, 2);

  const std::string edges = std::to_string(3 * document.triangles.size() / 2);
  const std::array<std::string, 5> proved{
      "all " + std::to_string(document.triangles.size()) + " triangles are strictly counterclockwise",
      "all " + edges + " edges are Delaunay, " + std::to_string(outcome.ties.size()) + " of them exact ties",
      std::string("every circumradius") + (collars.pseudo() ? " outside of collars" : "") +
          " is at most epsilon; the largest lies in " + text(outcome.largest_circumradius),
      outcome.shortest_edge ? std::string("every edge between different vertices") +
                                  (collars.pseudo() ? " that are not those of one collar" : "") +
                                  " is at least epsilon long; the shortest lies in " + text(*outcome.shortest_edge)
                            : std::string("there is only one vertex, every edge is a loop"),
      "every loop at a vertex of no collar is at least epsilon long"};
  for (const Rule rule : kRules) {
    if (rule == kThick && !collars.pseudo()) break;
    outcome.reports.push_back(report(rule, document, collars, all, triangles, open, options.max_precision));
    if (outcome.reports.back().verdict == Verdict::verified) outcome.reports.back().text = proved[rule];
  }
  return outcome;
}

}  // namespace epsnet::certify
