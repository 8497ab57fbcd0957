#include "certify/claims/geodesics/edge_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/numbers/rounding.h"

namespace epsnet::certify {
namespace {

// Intervals of numbers that are not negative.
[[nodiscard]] Interval times(Interval x, Interval y) { return {below(x.lower * y.lower), above(x.upper * y.upper)}; }
[[nodiscard]] Interval square(Interval x) { return times(x, x); }
[[nodiscard]] Interval minus(Interval x, Interval y) { return {below(x.lower - y.upper), above(x.upper - y.lower)}; }

[[nodiscard]] Interval at_least_1(Interval x) { return {std::max(x.lower, 1.0), std::max(x.upper, 1.0)}; }

[[nodiscard]] Interval sinh2_of(Interval cosh) {
  const Interval x = minus(square(cosh), {1, 1});
  return {std::max(x.lower, 0.0), x.upper};
}

/// A lower bound of cosh² of the distance of the lines of two edges, if they have one. `product` is that of their unit
/// normals, times sinh of the lengths of both edges.
[[nodiscard]] double lines2_below(Interval product, Interval edge, Interval other) {
  const double least = product.lower > 0 ? product.lower : product.upper < 0 ? -product.upper : 0;
  const double most = std::max(std::abs(product.lower), std::abs(product.upper));
  const Interval scale = times(sinh2_of(other), sinh2_of(edge));
  // Lines that certainly meet have no distance.
  if (above(most * most) <= scale.lower) return std::numeric_limits<double>::infinity();
  return scale.upper > 0 ? below(below(least * least) / scale.upper) : 1;
}

/// Whether the distance from a line certainly is least at an end of an edge, if the line does not meet that of the
/// edge: x and y are sinh² of the distances of its ends.
[[nodiscard]] bool has_no_foot(Interval x, Interval y, Interval edge) {
  const double cosh2 = above(edge.upper * edge.upper);
  return x.lower >= above(cosh2 * y.upper) || y.lower >= above(cosh2 * x.upper);
}

/// sinh² of the distance of a point from the line of an edge, p and q the cosh of its distances from the ends.
[[nodiscard]] Interval sinh2_to_line(Interval p, Interval q, Interval edge) {
  const Interval denominator = sinh2_of(edge);
  if (!(denominator.lower > 0)) return {0, std::numeric_limits<double>::infinity()};
  const Interval twice{2 * edge.lower, 2 * edge.upper};
  const Interval numerator = minus(minus(times(twice, times(p, q)), square(p)), square(q));
  const double lower = numerator.lower > 0 ? below(numerator.lower / denominator.upper) : 0;
  const double upper = above(std::max(numerator.upper, 0.0) / denominator.lower);
  return {std::max(below(lower - 1), 0.0), std::max(above(upper - 1), 0.0)};
}

/// A lower bound of cosh² of the distance of a point from an edge, p and q the cosh of the distances from its ends.
[[nodiscard]] double end_to_edge2(Interval p, Interval q, Interval edge) {
  if (p.lower >= above(edge.upper * q.upper)) return below(q.lower * q.lower);
  if (q.lower >= above(edge.upper * p.upper)) return below(p.lower * p.lower);
  // That of the line, which is no more; and, for very short edges, that of an end less the edge's length m: cosh of
  // that is at least p e⁻ᵐ.
  const double shrink = below(edge.upper - above(std::sqrt(sinh2_of(edge).upper)));
  const double end = shrink > 0 ? below(std::max(p.lower, q.lower) * shrink) : 0;
  return std::max(below(1 + sinh2_to_line(p, q, edge).lower), below(end * end));
}

}  // namespace

double cosh2_below(SegmentPair pair) {
  const Interval el = at_least_1(pair.e_l);
  const Interval er = at_least_1(pair.e_r);
  const Interval sl = at_least_1(pair.s_l);
  const Interval sr = at_least_1(pair.s_r);
  const Interval edge = pair.l_r;
  const Interval first_edge = pair.e_s;
  // Far below what could overflow, so that nothing is NaN.
  constexpr double kFarthest = 1e70;
  if (!(std::max({el.upper, er.upper, sl.upper, sr.upper, edge.upper, first_edge.upper}) < kFarthest)) return 1;
  const double ends = std::min({end_to_edge2(el, sl, first_edge), end_to_edge2(er, sr, first_edge),
                                end_to_edge2(el, er, edge), end_to_edge2(sl, sr, edge)});
  const bool apart = has_no_foot(sinh2_to_line(el, sl, first_edge), sinh2_to_line(er, sr, first_edge), edge) ||
                     has_no_foot(sinh2_to_line(el, er, edge), sinh2_to_line(sl, sr, edge), first_edge);
  return apart ? ends : std::min(ends, lines2_below(minus(times(el, sr), times(er, sl)), edge, first_edge));
}

}  // namespace epsnet::certify
