#include "certify/claims/geodesics/crossing_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {

DoubleDouble to_double_double(const Ball& x) {
  constexpr slong kExactBits = 4096;  // More than are between the greatest and the least binary64: nothing is rounded.
  const double high = arf_get_d(arb_midref(x.get()), ARF_RND_NEAR);
  const Precision scope(kExactBits);
  const double low = arf_get_d(arb_midref((x - Ball::exactly(high)).get()), ARF_RND_NEAR);
  const Interval rest = outer_interval(abs(x - Ball::exactly(high) - Ball::exactly(low)));
  if (!std::isfinite(high) || !std::isfinite(low)) return {0, 0, std::numeric_limits<double>::infinity()};
  return {high, low, rest.upper};
}

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
  const Interval edge = at_least_1(pair.l_r);
  const Interval first_edge = at_least_1(pair.e_s);
  // Far below what could overflow, so that nothing is NaN.
  constexpr double kFarthest = 1e70;
  for (const Interval& x : {el, er, sl, sr, edge, first_edge}) {
    if (!(x.lower >= 1 && x.upper < kFarthest)) return 1;
  }
  const double ends = std::min({end_to_edge2(el, sl, first_edge), end_to_edge2(er, sr, first_edge),
                                end_to_edge2(el, er, edge), end_to_edge2(sl, sr, edge)});
  const bool apart = has_no_foot(sinh2_to_line(el, sl, first_edge), sinh2_to_line(er, sr, first_edge), edge) ||
                     has_no_foot(sinh2_to_line(el, er, edge), sinh2_to_line(sl, sr, edge), first_edge);
  return apart ? ends : std::min(ends, lines2_below(minus(times(el, sr), times(er, sl)), edge, first_edge));
}

namespace {

/// Bits that a distance must be known to; with fewer, hardly anything would be given up.
constexpr slong kLeastBits = 24;
/// Operations of balls that a visit takes, and visits that are paid for at once.
constexpr std::uint64_t kCrossingOperations = 30;
constexpr std::uint64_t kVisitsAtOnce = 256;
/// How many edges have their work shared out, and by how many turns.
constexpr std::size_t kSharedEdges = 8;
constexpr unsigned kSharedTurns = 3;
/// Bits of balls up to which numbers of twice the length of binary64 take their place.
constexpr slong kMostBitsOfDoubleDouble = 128;

// What the search asks of its numbers, for balls as for numbers of twice the length of binary64.

template <class Number>
[[nodiscard]] Number from_ball(const Ball& x) {
  if constexpr (std::is_same_v<Number, Ball>) {
    return x;
  } else {
    return to_double_double(x);
  }
}

template <class Number>
[[nodiscard]] std::array<Number, 3> from_balls(const BallVector& x) {
  return {from_ball<Number>(x[0]), from_ball<Number>(x[1]), from_ball<Number>(x[2])};
}

[[nodiscard]] bool is_accurate(const Ball& x) { return is_finite(x) && arb_rel_accuracy_bits(x.get()) >= kLeastBits; }
[[nodiscard]] bool is_accurate(const DoubleDouble& x) {
  return is_finite(x) && x.radius <= std::ldexp(std::fabs(x.high), -static_cast<int>(kLeastBits));
}

/// A multiple of a ray by a positive number, so that nothing overflows. Balls never do.
void scale(std::array<Ball, 3>&) {}
void scale(std::array<DoubleDouble, 3>& ray) {
  constexpr double kLarge = 0x1p+100;
  const double size = std::max({std::fabs(ray[0].high), std::fabs(ray[1].high), std::fabs(ray[2].high)});
  if (size > 1 / kLarge && size < kLarge) return;
  const double factor = size < 1 ? kLarge : 1 / kLarge;
  for (DoubleDouble& x : ray) x = {factor * x.high, factor * x.low, factor * x.radius + kUnderflow};
}

}  // namespace

/// A way across darts, and a cone that contains all functionals that have the ends of its edges on the right sides.
///
/// A functional is kept by its values at the three corners of the current triangle, in the order of `beyond`: the end
/// of the dart just crossed, its start, and the third corner of the triangle entered.
template <class Number>
class CrossingSearch::Way {
 public:
  using Triple = Functional<Number>;

  Way(const CrossingSearch& search, const std::vector<Triple>& beyond)
      : net_(search.net_), order_(search.order_), beyond_(beyond) {}

  /// The codes of the darts crossed.
  [[nodiscard]] const std::vector<std::uint32_t>& codes() const { return codes_; }

  /// Whether all distances were known well enough.
  [[nodiscard]] bool accurate() const { return accurate_; }

  /// All ways from a dart across darts of codes that are not less than `least`, of which the first turns are those
  /// given, to the left or to the right. may_cross(code) is asked about the next dart; then is_near(code, c), c at most
  /// cosh² of the distance of its edge from the first; and crosses(code, c) if perhaps there is a line across all
  /// edges: whether to go on beyond the dart.
  template <class MayCross, class IsNear, class Crosses>
  void walk(std::uint32_t first, std::uint32_t least, const std::vector<bool>& turns, const MayCross& may_cross,
            const IsNear& is_near, const Crosses& crosses) {
    nodes_.clear();
    rays_.clear();
    accurate_ = true;
    ended_ = false;
    codes_.assign(1, order_.code(first));
    first_edge_ = net_.cosh_length(first);
    clipped_.clear();
    push(first, distances_from(first, next_dart(first)), distances_from(first, first));
    while (!nodes_.empty() && accurate_ && !ended_) {
      if (nodes_.back().next_side == 2) {
        rays_.resize(nodes_.back().first_ray);
        nodes_.pop_back();
        codes_.pop_back();
        continue;
      }
      const bool left = nodes_.back().next_side++ == 0;
      if (nodes_.size() <= turns.size() && left != turns[nodes_.size() - 1]) continue;
      const std::uint32_t back = opposite(net_.plane().net(), order_.dart(codes_.back()));
      const std::uint32_t dart = left ? next_dart(back) : previous_dart(back);
      const std::uint32_t code = order_.code(dart);
      if (code < least) continue;
      if (tried_++ % kVisitsAtOnce == 0) net_.plane().spend(kCrossingOperations, kVisitsAtOnce);
      if (!may_cross(code)) continue;
      Triple from_end = turned(nodes_.back().from_end, left);
      Triple from_start = turned(nodes_.back().from_start, left);
      const double cosh2 = cosh2_below(from_end, from_start, net_.cosh_length(dart));
      if (!is_near(code, cosh2) || !clip(left) || !crosses(code, cosh2)) continue;
      codes_.push_back(code);
      push(dart, std::move(from_end), std::move(from_start));
    }
  }

  /// Ends the walk before another dart is crossed.
  void end() { ended_ = true; }
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  struct Node {
    int next_side = 0;
    std::size_t first_ray = 0;
    Triple from_end;    ///< cosh of the distances from the end of the first dart,
    Triple from_start;  ///< and from its start.
  };

  /// cosh of the distances of a corner of the first triangle from all its corners.
  [[nodiscard]] Triple distances_from(std::uint32_t first, std::uint32_t corner) const {
    BallVector result;
    std::size_t i = 0;
    for (const std::uint32_t dart : {next_dart(first), first, previous_dart(first)}) {
      result[i++] = -lorentz_product(net_.corner(corner), net_.corner(dart), net_.plane().precision());
    }
    return from_balls<Number>(result);
  }

  /// The third corner c comes to lie on the left or on the right of the way: the values in the order of the next dart's
  /// triangle. On the left, the dart leads from r to c and l is behind, on the right from c to l with r behind.
  [[nodiscard]] static Triple turned(Triple values, bool left) {
    std::swap(values[2], values[left ? 0 : 1]);
    return values;
  }

  /// From the values in the triangle before a dart to those in the one beyond.
  void cross(std::uint32_t dart, Triple& values) const { values[2] = sum_of_products(beyond_[dart], values); }

  /// With the rays that are left.
  void push(std::uint32_t dart, Triple from_end, Triple from_start) {
    Node node;
    node.first_ray = rays_.size();
    cross(dart, from_end);
    cross(dart, from_start);
    for (Triple& ray : clipped_) {
      cross(dart, ray);
      scale(ray);
      rays_.push_back(std::move(ray));
    }
    accurate_ = accurate_ && is_accurate(from_end[2]) && is_accurate(from_start[2]);
    node.from_end = std::move(from_end);
    node.from_start = std::move(from_start);
    nodes_.push_back(std::move(node));
  }

  /// Finds the part of the cone where the third corner is on its side, in the order of the next triangle, or a larger
  /// cone; false only if there certainly is no such part.
  [[nodiscard]] bool clip(bool left) {
    clipped_.clear();
    const int wanted = left ? 1 : -1;
    if (nodes_.size() == 1) {
      for (std::size_t i = 0; i < 3; ++i) {
        Triple ray;
        ray[i] = from_ball<Number>(Ball::exactly(i == 0 ? 1 : i == 1 ? -1 : wanted));
        clipped_.push_back(turned(ray, left));
      }
      return true;
    }
    const std::span<const Triple> rays(rays_);
    clip_cone(rays.subspan(nodes_.back().first_ray), wanted, side_, clipped_);
    for (Triple& ray : clipped_) ray = turned(std::move(ray), left);
    return !clipped_.empty();
  }

  /// A lower bound of cosh² of the distance between the first edge and one with the ends l and r, from the cosh of the
  /// distances of these from the ends of the first edge.
  [[nodiscard]] double cosh2_below(const Triple& from_end, const Triple& from_start, Interval edge) const {
    if (!is_finite(from_end[0]) || !is_finite(from_end[1]) || !is_finite(from_start[0]) || !is_finite(from_start[1]))
      return 1;
    return certify::cosh2_below({.e_l = fast_interval(from_end[0]),
                                 .s_l = fast_interval(from_start[0]),
                                 .e_r = fast_interval(from_end[1]),
                                 .s_r = fast_interval(from_start[1]),
                                 .l_r = edge,
                                 .e_s = first_edge_});
  }

  const MovedNet& net_;
  const DartOrder& order_;
  const std::vector<Triple>& beyond_;  ///< By dart, as MovedNet has it.
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> codes_;
  std::vector<Triple> rays_;  ///< Of all nodes, one after the other.
  std::vector<Triple> clipped_;
  std::uint64_t tried_ = 0;
  std::vector<int> side_;
  Interval first_edge_{};
  bool accurate_ = true;
  bool ended_ = false;
};

/// Upper bounds of cosh² of how far from the first edge a geodesic may be when it crosses a dart: L less a lower bound
/// for the way back from there, which is half of L for most darts.
struct CrossingSearch::Limits {
  [[nodiscard]] double of(std::uint32_t code) const {
    const auto found = near.find(code);
    return found == near.end() ? elsewhere : found->second;
  }

  std::unordered_map<std::uint32_t, double> near;  ///< By code.
  double elsewhere = 0;
};

CrossingSearch::CrossingSearch(const MovedNet& net, const DartOrder& order, const Ball& cosh_half)
    : net_(net), order_(order) {
  const Precision scope(net.plane().precision());
  length_ = twice(acosh(cosh_half));
  if (scope.bits() <= kMostBitsOfDoubleDouble) {
    for (const BallVector& beyond : net.beyond()) beyond_.push_back(from_balls<DoubleDouble>(beyond));
  }
  for (std::uint32_t edge = 0; edge < order.starts(); ++edge) {
    const unsigned turns = edge < kSharedEdges ? kSharedTurns : 0;
    for (unsigned choice = 0; choice < 1U << turns; ++choice) {
      Part& part = parts_.emplace_back(Part{2 * edge, {}});
      for (unsigned i = 0; i < turns; ++i) part.to_left.push_back((choice >> i & 1U) != 0);
    }
  }
}

/// By a search the other way round. Empty if the precision is too low.
template <class Number>
std::optional<CrossingSearch::Limits> CrossingSearch::limits(std::uint32_t first, Way<Number>& way) const {
  const Ball half_length = half(length_);
  const auto upper_cosh2 = [](const Ball& x) {
    const Precision scope(64);
    return upper_end(sqr(cosh(x)));
  };
  const double most = upper_cosh2(half_length);
  // cosh² of the least distance; ways longer than half are not followed.
  std::unordered_map<std::uint32_t, double> cosh2{{first, 1}};
  way.walk(
      order_.dart(first + 1), first, {}, [](std::uint32_t) { return true; },
      [&](std::uint32_t, double least) { return !(least > most); },
      [&](std::uint32_t code, double least) {
        double& known = cosh2.try_emplace(code ^ 1U, least).first->second;
        known = std::min(known, least);
        return true;
      });
  if (!way.accurate()) return std::nullopt;
  const auto limit = [&](double distance) { return upper_cosh2(length_ - Ball::exactly(distance)); };
  const double half_below = lower_end(half_length);
  Limits result{{}, limit(half_below)};
  for (const auto& [code, least] : cosh2) {
    const Ball back = acosh(sqrt(Ball::exactly(std::max(least, 1.0))));
    result.near[code] = limit(std::min(half_below, std::max(lower_end(back), 0.0)));
  }
  return result;
}

SearchOutcome CrossingSearch::run(std::size_t part, std::uint64_t limit, const Report& report) const {
  const Precision scope(net_.plane().precision());
  const Part& own = looked_up(parts_, part, "the search has no part");
  if (!beyond_.empty()) {
    bool stopped = false;
    const SearchOutcome outcome = run_with(beyond_, own, limit, [&](const std::vector<std::uint32_t>& codes) {
      const Search answer = report(codes);
      stopped = answer == Search::stop;
      return answer;
    });
    if (outcome.complete || outcome.limit_reached || stopped) return outcome;
  }
  // The same again, where numbers of twice the length of binary64 are not accurate enough.
  return run_with(net_.beyond(), own, limit, report);
}

template <class Number>
SearchOutcome CrossingSearch::run_with(const std::vector<std::array<Number, 3>>& beyond, const Part& part,
                                       std::uint64_t limit, const Report& report) const {
  SearchOutcome outcome;
  Way<Number> way(*this, beyond);
  const std::optional<Limits> farthest = limits(part.first, way);
  if (!farthest) return outcome;
  // period[n]: of the first n letters, as the beginning of a least rotation.
  std::vector<std::size_t> period{0, 1};
  // Of ways that end before all turns are taken, those whose other turns would be to the right belong to the part.
  const auto is_own = [&](std::size_t turns) {
    return std::none_of(part.to_left.begin() + static_cast<std::ptrdiff_t>(std::min(turns, part.to_left.size())),
                        part.to_left.end(), [](bool left) { return left; });
  };
  const auto rival = [&] { return way.codes()[way.codes().size() - period[way.codes().size()]]; };
  way.walk(
      order_.dart(part.first), part.first, part.to_left,
      [&](std::uint32_t code) {
        if (++outcome.visits > limit) {
          outcome.limit_reached = true;
          way.end();
          return false;
        }
        return code >= rival();
      },
      [&](std::uint32_t code, double cosh2) { return !(cosh2 > farthest->of(code)); },
      [&](std::uint32_t code, double) {
        const std::size_t n = way.codes().size();
        const std::size_t next_period = code == rival() ? period[n] : n + 1;
        period.resize(n + 1);
        period.push_back(next_period);
        if (code == part.first && period[n] == n && is_own(n) && report(way.codes()) == Search::stop) way.end();
        return !way.ended();
      });
  outcome.complete = !way.ended() && way.accurate();
  return outcome;
}

namespace {

/// Bits of two lengths that agree before they are compared exactly.
constexpr slong kTieBits = 30;

/// The element of a loop edge in the chart of its vertex.
BallIsometry element_of_loop(const LiftedPlane& plane, std::uint32_t dart) {
  BallIsometry element = compose(inverse(plane.label(corner_label(plane.net(), dart))),
                                 plane.label(corner_label(plane.net(), next_dart(dart))), plane.precision());
  choose_sign(element);
  return element;
}

}  // namespace

std::optional<std::vector<std::uint32_t>> edges_in_collar(const MovedNet& net, std::uint32_t loop) {
  const LiftedPlane& plane = net.plane();
  const slong precision = plane.precision();
  const BallIsometry element = element_of_loop(plane, loop);
  const Precision scope(precision);
  const Ball sinh_half = sqrt(sqr(real(element.a)) - 1);
  if (certainly_positive(sinh_half) != Tri::yes) return std::nullopt;
  std::vector<std::uint32_t> result;
  if (certainly_less(sinh_half, Ball::exactly(1)) != Tri::yes) return result;
  const Ball width = 1 / sinh_half;
  Ball distance;
  const auto is_inside = [&](const BallVector& axis, std::uint32_t dart) {
    dot(distance, axis, net.corner(dart), precision);
    return certainly_less(abs(distance), width) == Tri::yes;
  };
  std::uint32_t dart = loop;
  do {
    // The vertex is in one place, seen from whichever triangle; the axis is carried to the chart of this one.
    const BallIsometry& to_triangle = plane.label(corner_label(plane.net(), dart));
    BallIsometry carried = compose(compose(to_triangle, element, precision), inverse(to_triangle), precision);
    choose_sign(carried);
    const BallVector axis = axis_row(carried, precision);
    if (is_inside(axis, dart) && is_inside(axis, next_dart(dart))) result.push_back(dart);
    dart = next_dart(opposite(plane.net(), dart));
  } while (dart != loop);
  return result;
}

CrossingPass::CrossingPass(const GeodesicsDocument& document, const LabelEvaluator& evaluator, const LiftedPlane& plane,
                           const Ball& cosh_half, const std::function<Member(std::size_t)>& member, unsigned threads)
    : document_(document),
      evaluator_(evaluator),
      first_element_(static_cast<std::uint32_t>(document.net.labels.size()) + 1),
      plane_(plane),
      net_(plane.net()),
      traces_(evaluator),
      cosh_half_(cosh_half),
      moved_(plane) {
  if (!moved_.valid()) return;
  std::vector<bool> inner(3 * net_.triangles.size());
  for (std::uint32_t dart = 0; dart < inner.size(); ++dart) {
    if (start(net_, dart) != start(net_, next_dart(dart)) || opposite(net_, dart) < dart) continue;
    const auto edges = edges_in_collar(moved_, dart);
    if (!edges) return;
    for (const std::uint32_t edge : *edges) inner[edge] = inner[opposite(net_, edge)] = true;
    if (!edges->empty()) loops_.push_back(dart);
  }
  order_.emplace(moved_, inner);
  search_.emplace(moved_, *order_, cosh_half);
  const std::size_t count = document.geodesics.size();
  const bool together = document.claim == GeodesicsDocument::Claim::thick_thin;
  const bool is_maximum = document.claim == GeodesicsDocument::Claim::local_maximum;
  const std::size_t kept = together ? count : is_maximum ? document.clusters[0].count : 0;
  std::vector<LeastSequence> sequences(count);
  meetings_.resize(count);
  geodesics_.resize(kept);
  for_each_parallel(count, threads, [&](unsigned, std::size_t i) {
    const auto [first_dart, element] = member(i);
    std::optional<AxisCrossings> crossings = axis_crossings(moved_, first_dart, element);
    if (!crossings) return;
    sequences[i] = least_sequence(codes_of(crossings->darts));
    // A power runs through the same chords again and again.
    crossings->darts.resize(crossings->darts.size() / sequences[i].exponent);
    if (!together) meetings_[i] = find_meetings(plane_, {&*crossings, 1})[0];
    if (i < kept) geodesics_[i] = *std::move(crossings);
  });
  if (std::any_of(sequences.begin(), sequences.end(), [](const auto& sequence) { return sequence.root.empty(); })) {
    return;
  }
  if (together) meetings_ = find_meetings(plane_, geodesics_);
  table_.emplace(std::move(sequences));
}

std::vector<std::uint32_t> CrossingPass::codes_of(const std::vector<std::uint32_t>& darts) const {
  std::vector<std::uint32_t> codes(darts.size());
  std::transform(darts.begin(), darts.end(), codes.begin(), [&](std::uint32_t dart) { return order_->code(dart); });
  return codes;
}

Completeness CrossingPass::search(std::uint64_t limit, unsigned threads,
                                  const std::function<void(double)>& progress) const {
  std::vector<Completeness> parts(loops_.size() + search_->size());
  std::atomic<std::uint64_t> visits = 0;
  for_each_parallel(parts.size(), threads, [&](unsigned worker, std::size_t i) {
    Completeness& part = parts[i];
    if (i < loops_.size()) {
      const std::vector<std::uint32_t> codes = codes_of_loop(loops_[i]);
      if (!codes.empty()) part.complete = is_in_order(codes, part);
      return;
    }
    const std::uint64_t done = std::min<std::uint64_t>(visits, limit);
    Tri answer = Tri::yes;
    const SearchOutcome outcome = search_->run(i - loops_.size(), limit - done, [&](const auto& codes) {
      if (worker == 0) progress(static_cast<double>(i) / static_cast<double>(parts.size()));
      answer = is_in_order(codes, part);
      return answer == Tri::yes ? Search::go_on : Search::stop;
    });
    visits += outcome.visits;
    part.complete = answer == Tri::yes && !outcome.complete ? Tri::unknown : answer;
  });
  Completeness result;
  result.visits = std::min<std::uint64_t>(visits, limit);
  result.limit_reached = visits > limit;
  if (result.limit_reached) return result;
  result.complete = Tri::yes;
  for (const Completeness& part : parts) {
    result.candidates += part.candidates;
    if (result.complete == Tri::no) continue;
    if (part.complete == Tri::no) result.missing = part.missing;
    result.complete = both(result.complete, part.complete);
  }
  return result;
}

/// The sequence of a loop edge's geodesic; empty if the precision is too low.
std::vector<std::uint32_t> CrossingPass::codes_of_loop(std::uint32_t loop) const {
  const auto crossings = axis_crossings(moved_, loop, element_of_loop(plane_, loop));
  return crossings ? codes_of(crossings->darts) : std::vector<std::uint32_t>();
}

/// Whether a cyclic sequence that is no power is in the list, or not that of a geodesic, or of one that is too long.
Tri CrossingPass::is_in_order(const std::vector<std::uint32_t>& codes, Completeness& part) const {
  plane_.spend(1, codes.size());
  if (table_->contains(least_sequence(codes).root)) {
    ++part.candidates;
    return Tri::yes;
  }
  std::vector<std::uint32_t> darts(codes.size());
  std::transform(codes.begin(), codes.end(), darts.begin(), [&](std::uint32_t code) { return order_->dart(code); });
  const BallIsometry element = element_across(plane_, darts);
  if (certainly_less(cosh_half_length(element), cosh_half_) == Tri::no) return Tri::yes;
  const Tri is_sequence = crosses(moved_, element, darts);
  if (is_sequence == Tri::no) return Tri::yes;
  ++part.candidates;
  const Tri listed = is_to_be_listed(element, darts);
  if (listed == Tri::no) return Tri::yes;
  if (listed == Tri::unknown || is_sequence == Tri::unknown) return Tri::unknown;
  part.missing = "a closed geodesic near vertex " + std::to_string(start(net_, darts.front())) + " of length in " +
                 to_string(translation_length(element, plane_.precision())) +
                 (document_.claim == GeodesicsDocument::Claim::systole ? " is shorter" : " is not in the list");
  return Tri::no;
}

/// Whether a closed geodesic is so short that it should be in the list: shorter than the systole listed, or at most as
/// long as the list goes. Where balls do not tell, exact numbers do, if the two lengths are near enough.
Tri CrossingPass::is_to_be_listed(const BallIsometry& element, const std::vector<std::uint32_t>& darts) const {
  const Tri shorter = certainly_less(cosh_half_length(element), cosh_half_);
  const bool is_near_tie =
      arb_rel_accuracy_bits(element.a.re()) >= kTieBits && arb_rel_accuracy_bits(cosh_half_.get()) >= kTieBits;
  // An `up_to` is never a length, 2 arsinh 1 may be one.
  if (shorter != Tri::unknown || document_.has_up_to() || !is_near_tie) return shorter;
  std::vector<SignedLabel> product;
  for (const std::uint32_t dart : darts) {
    product.push_back({corner_label(net_, dart), false});
    product.push_back({corner_label(net_, next_dart(opposite(net_, dart))), true});
  }
  const std::vector<std::uint32_t> word = evaluator_.word(product);
  const bool is_systole = document_.claim == GeodesicsDocument::Claim::systole;
  const auto sign =
      is_systole ? traces_.compare(word, evaluator_.word(first_element_)) : traces_.compare_with_short(word);
  if (!sign) return Tri::unknown;
  return *sign < (is_systole ? 0 : 1) ? Tri::yes : Tri::no;
}

}  // namespace epsnet::certify
