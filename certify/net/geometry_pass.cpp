#include "certify/net/geometry_pass.h"

#include <cmath>

#include "certify/base/text.h"
#include "certify/net/numbering.h"

namespace epsnet::certify::geometry {
namespace {

/// Bits of relative accuracy that a length must have before it counts as measured, for useful enclosures.
constexpr slong kMeasuredBits = 30;

/// The rule that says that an edge is at least ε long; nothing if it may have any length.
std::optional<Rule> length_rule(const NetDocument& document, const CollarMembers& collars, std::uint32_t dart) {
  const std::uint32_t u = start(document, dart);
  const std::uint32_t v = start(document, next_dart(dart));
  // The vertices of a collar are thick by rule collars (docs/proof.md, Lemma 10).
  if (u == v) return collars.pseudo() && !collars.has_vertex(u) ? std::optional(kThick) : std::nullopt;
  return collars.are_partners(u, v) ? std::nullopt : std::optional(kPacking);
}

void refute_orientation(const NetDocument& document, std::uint32_t t, Findings& findings) {
  findings.refute(kOrientation, t, triangle_name(document, t) + " is not strictly counterclockwise");
}

void refute_delaunay(const NetDocument& document, std::uint32_t dart, Findings& findings) {
  findings.refute(kDelaunay, dart / 3,
                  edge_name(document, dart) + " is not Delaunay: the cross-ratio has positive imaginary part");
}

bool measured(const Ball& x) { return arb_rel_accuracy_bits(x.get()) >= kMeasuredBits; }

}  // namespace

std::string triangle_name(const NetDocument& document, std::size_t t) {
  const auto& v = document.triangles[t].vertex;
  return "triangle " + std::to_string(t) + " (vertices " + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
         std::to_string(v[2]) + ")";
}

std::string edge_name(const NetDocument& document, std::uint32_t dart) {
  return "the edge of dart " + std::to_string(dart) + " from vertex " + std::to_string(start(document, dart)) +
         " to vertex " + std::to_string(start(document, next_dart(dart)));
}

Questions questions_of(const NetDocument& document, const CollarMembers& collars, Rule rule, std::uint32_t t) {
  if (rule == kOrientation) return kOrientationBit;
  if (rule == kDelaunay) return kDelaunayBits;
  if (rule == kCovering) return kCoveringBit;
  Questions result = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (length_rule(document, collars, 3 * t + i) == rule) result = static_cast<Questions>(result | length_bit(i));
  }
  return result;
}

bool examine_exactly(const NetDocument& document, const LabelEvaluator& evaluator, std::uint32_t t, Questions question,
                     Findings& findings) {
  if (question == kOrientationBit) {
    const std::optional<int> sign = exact_orientation(document, evaluator, t);
    if (sign && *sign <= 0) refute_orientation(document, t, findings);
    return sign.has_value();
  }
  const std::uint32_t dart = 3 * t + (question == delaunay_bit(0) ? 0 : question == delaunay_bit(1) ? 1 : 2);
  const std::optional<int> sign = exact_cross_ratio_sign(document, evaluator, dart);
  if (sign && *sign > 0) refute_delaunay(document, dart, findings);
  if (sign && *sign == 0) findings.ties.push_back(dart);
  return sign.has_value();
}

Pass::Pass(const NetDocument& document, const CollarMembers& collars, const LabelTable& labels,
           const mpq_class& epsilon, slong precision, bool last)
    : document_(document), collars_(collars), labels_(labels), precision_(precision), last_(last) {
  const Ball radius = Ball::rounded(epsilon);
  epsilon_ = outer_interval(radius);
  sinh_squared_ = sqr(sinh(radius));
  half_sinh_squared_ = sqr(sinh(half(radius)));
}

Questions Pass::examine(std::uint32_t t, Questions open, LiftedTriangle& lifted, Findings& findings) const {
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

Questions Pass::examine_orientation(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const {
  const Tri positive = certainly_positive(lifted.measure_orientation(precision_));
  if (positive == Tri::no) refute_orientation(document_, t, findings);
  return positive == Tri::unknown ? kOrientationBit : Questions{0};
}

Questions Pass::examine_covering(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const {
  const auto& radius = lifted.measure_circumradius(sinh_squared_.get(), precision_);
  const Tri inside = certainly_positive(radius.slack);
  const Interval squared = quotient(radius.numerator, radius.denominator);
  if (inside == Tri::no) {
    findings.refute(kCovering, t,
                    triangle_name(document_, t) + " has a circumradius in " + to_string(length_interval(squared, 1)) +
                        ", greater than epsilon in " + to_string(epsilon_) +
                        (std::isinf(squared.upper) ? " (or no circumcircle)" : ""));
  }
  if (!last_ && (inside == Tri::unknown || (inside == Tri::yes && !measured(radius.numerator)) ||
                 (inside == Tri::yes && !measured(radius.denominator)))) {
    return kCoveringBit;
  }
  findings.extremes.add(kCircumradius, squared);
  return inside == Tri::unknown ? kCoveringBit : Questions{0};
}

Questions Pass::examine_circumcircle(std::uint32_t t, LiftedTriangle& lifted, Findings& findings) const {
  const auto& radius = lifted.measure_circumradius(sinh_squared_.get(), precision_);
  const Tri exists = certainly_positive(radius.denominator);
  // Never after rule delaunay (docs/proof.md, Lemma 4).
  if (exists == Tri::no) findings.refute(kCovering, t, triangle_name(document_, t) + " has no circumcircle");
  return exists == Tri::unknown ? kCoveringBit : Questions{0};
}

Questions Pass::examine_delaunay(std::uint32_t t, std::uint32_t i, LiftedTriangle& lifted, Findings& findings) const {
  const Ball& cross_ratio = lifted.measure_cross_ratio(document_, labels_, i, precision_);
  if (is_exactly_zero(cross_ratio)) {
    // Nothing was rounded, as happens with coordinates of few digits: a tie already proved.
    findings.ties.push_back(3 * t + i);
    return 0;
  }
  const Tri positive = certainly_positive(cross_ratio);
  if (positive == Tri::yes) refute_delaunay(document_, 3 * t + i, findings);
  return positive == Tri::unknown ? delaunay_bit(i) : Questions{0};
}

Questions Pass::examine_length(std::uint32_t t, std::uint32_t i, LiftedTriangle& lifted, Findings& findings) const {
  const std::uint32_t dart = 3 * t + i;
  const bool loop = start(document_, dart) == start(document_, next_dart(dart));
  const std::optional<Rule> rule = length_rule(document_, collars_, dart);
  const auto& edge = lifted.measure_edge(half_sinh_squared_.get(), i, precision_);
  const Ball& difference = lifted.squared_difference(i);
  const Tri short_edge = rule ? certainly_positive(edge.lack) : Tri::no;
  const Interval squared = quotient(difference, edge.gap_product);
  if (short_edge == Tri::yes) {
    findings.refute(*rule, t,
                    edge_name(document_, dart) + " has a length in " + to_string(length_interval(squared, 2)) +
                        ", less than epsilon in " + to_string(epsilon_));
  }
  if (!last_ && short_edge != Tri::yes &&
      (short_edge == Tri::unknown || !measured(difference) || !measured(edge.gap_product))) {
    return length_bit(i);
  }
  findings.extremes.add(kLongest, squared);
  if (loop || rule) findings.extremes.add(loop ? kShortestLoop : kShortestEdge, squared);
  return short_edge == Tri::unknown ? length_bit(i) : Questions{0};
}

}  // namespace epsnet::certify::geometry
