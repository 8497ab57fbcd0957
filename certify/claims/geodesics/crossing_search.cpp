#include "certify/claims/geodesics/crossing_search.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "certify/net/darts.h"
#include "certify/numbers/rounding.h"

namespace epsnet::certify {
namespace {

/// Bits that a distance must be known to; with fewer, hardly anything would be given up.
constexpr slong kLeastAccuracy = 24;
/// Operations of balls that a visit takes.
constexpr std::uint64_t kVisitOperations = 30;

[[nodiscard]] double lower_end(const Ball& x) { return outer_interval(x).lower; }
[[nodiscard]] double upper_end(const Ball& x) { return outer_interval(x).upper; }

// Intervals of numbers that are not negative.
[[nodiscard]] Interval times(Interval x, Interval y) { return {below(x.lower * y.lower), above(x.upper * y.upper)}; }
[[nodiscard]] Interval square(Interval x) { return times(x, x); }
[[nodiscard]] Interval minus(Interval x, Interval y) { return {below(x.lower - y.upper), above(x.upper - y.lower)}; }

}  // namespace

// The net with moved vertices.

MovedNet::MovedNet(const LiftedPlane& plane) : plane_(plane) {
  const NetDocument& net = plane.net();
  const std::size_t darts = 3 * net.triangles.size();
  plane.spend(400, darts);
  plane.keep(8, darts);
  shortest_.assign(net.vertices.size(), std::numeric_limits<double>::infinity());
  const Precision scope(plane.precision());
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    const Ball value = half(lorentz_product(plane.corner(dart), plane.corner(next_dart(dart)), plane.precision()) + 1);
    const double length = std::sqrt(std::abs(arf_get_d(arb_midref(value.get()), ARF_RND_NEAR)));
    for (const std::uint32_t v : {start(net, dart), start(net, next_dart(dart))}) {
      shortest_[v] = std::min(shortest_[v], length);
    }
  }
  corners_.resize(darts);
  constexpr int kTries = 12;
  double share = 0.125;
  for (int tries = 0; tries < kTries && !valid_; ++tries, share /= 2) valid_ = place(share);
  if (valid_) measure();
}

/// Moves the vertices; false if not all triangles certainly are counterclockwise.
bool MovedNet::place(double share) {
  const NetDocument& net = plane_.net();
  std::mt19937 random;
  std::vector<NetDocument::Vertex> vertices = net.vertices;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    NetDocument::Vertex& vertex = vertices[v];
    const double size = share * shortest_[v] * (1 - vertex.x * vertex.x - vertex.y * vertex.y);
    vertex.x += size * (std::ldexp(static_cast<double>(random()), -31) - 1);
    vertex.y += size * (std::ldexp(static_cast<double>(random()), -31) - 1);
    if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y)) return false;
  }
  for (std::uint32_t dart = 0; dart < corners_.size(); ++dart) {
    const NetDocument::Vertex& vertex = vertices[start(net, dart)];
    corners_[dart] = unit_vector(plane_.label(corner_label(net, dart)), vertex.x, vertex.y, plane_.precision());
    // Else it is no point of the plane.
    if (certainly_positive(corners_[dart][2]) != Tri::yes) return false;
  }
  Ball determinant;
  for (std::uint32_t dart = 0; dart < corners_.size(); dart += 3) {
    dot(determinant, cross_product(corners_[dart], corners_[dart + 1], plane_.precision()), corners_[dart + 2],
        plane_.precision());
    if (certainly_positive(determinant) != Tri::yes) return false;
  }
  return true;
}

void MovedNet::measure() {
  const slong precision = plane_.precision();
  beyond_.resize(corners_.size());
  cosh_.resize(corners_.size());
  const Precision scope(precision);
  Ball volume;
  for (std::uint32_t dart = 0; dart < corners_.size(); ++dart) {
    const BallVector& right = corners_[dart];
    const BallVector& left = corners_[next_dart(dart)];
    const BallVector& apex = corners_[previous_dart(dart)];
    cosh_[dart] = outer_interval(-lorentz_product(left, right, precision));
    const std::uint32_t other = opposite(plane_.net(), dart);
    BallVector x = corners_[previous_dart(other)];
    if (const auto* transition = plane_.transition(other)) x = apply(transition->matrix, x, precision);
    // Cramer's rule.
    const std::array<BallVector, 3> lines = {cross_product(right, apex, precision),
                                             cross_product(apex, left, precision),
                                             cross_product(left, right, precision)};
    dot(volume, lines[0], left, precision);
    for (std::size_t i = 0; i < 3; ++i) {
      dot(beyond_[dart][i], lines[i], x, precision);
      beyond_[dart][i] = beyond_[dart][i] / volume;
    }
  }
}

// The search.

/// A way across darts, and a cone that contains all functionals that have the ends of its edges on the right sides.
///
/// A functional is kept by its values at the three corners of the current triangle, in the order of `beyond`: the end
/// of the dart just crossed, its start, and the third corner of the triangle entered.
class CrossingSearch::Way {
 public:
  explicit Way(const CrossingSearch& search) : search_(search), net_(search.net_) {}

  /// The codes of the darts crossed.
  [[nodiscard]] const std::vector<std::uint32_t>& codes() const { return codes_; }

  /// Whether all distances were known well enough.
  [[nodiscard]] bool accurate() const { return accurate_; }

  /// All ways from a dart across darts of codes that are not less than `least`. may_cross(code, c) is asked about the
  /// next dart, c at most cosh² of the distance of its edge from the first, and crosses(code, c) if perhaps there is a
  /// line across all edges; whether to go on beyond the dart.
  template <class MayCross, class Crosses>
  void walk(std::uint32_t first, std::uint32_t least, const MayCross& may_cross, const Crosses& crosses) {
    nodes_.clear();
    rays_.clear();
    accurate_ = true;
    ended_ = false;
    codes_.assign(1, search_.code_[first]);
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
      const std::uint32_t back = opposite(net_.plane().net(), search_.dart_of_[codes_.back()]);
      const std::uint32_t dart = left ? next_dart(back) : previous_dart(back);
      const std::uint32_t code = search_.code_[dart];
      if (code < least) continue;
      BallVector from_end = turned(nodes_.back().from_end, left);
      BallVector from_start = turned(nodes_.back().from_start, left);
      const double cosh2 = cosh2_below(from_end, from_start, net_.cosh_length(dart));
      if (!may_cross(code, cosh2) || !clip(left) || !crosses(code, cosh2)) continue;
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
    BallVector from_end;    ///< cosh of the distances from the end of the first dart,
    BallVector from_start;  ///< and from its start.
  };

  [[nodiscard]] slong precision() const { return net_.plane().precision(); }

  /// cosh of the distances of a corner of the first triangle from all its corners.
  [[nodiscard]] BallVector distances_from(std::uint32_t first, std::uint32_t corner) const {
    BallVector result;
    std::size_t i = 0;
    for (const std::uint32_t dart : {next_dart(first), first, previous_dart(first)}) {
      result[i++] = -lorentz_product(net_.corner(corner), net_.corner(dart), precision());
    }
    return result;
  }

  /// The third corner c comes to lie on the left or on the right of the way: the values in the order of the next dart's
  /// triangle. On the left, the dart leads from r to c and l is behind, on the right from c to l with r behind.
  [[nodiscard]] static BallVector turned(const BallVector& values, bool left) {
    BallVector result = values;
    arb_swap(result[2].get(), result[left ? 0 : 1].get());
    return result;
  }

  /// With the rays that are left.
  void push(std::uint32_t dart, BallVector from_end, BallVector from_start) {
    Node node;
    node.first_ray = rays_.size();
    search_.cross(dart, from_end);
    search_.cross(dart, from_start);
    for (BallVector& ray : clipped_) {
      search_.cross(dart, ray);
      rays_.push_back(std::move(ray));
    }
    for (const BallVector* distances : {&from_end, &from_start}) {
      accurate_ =
          accurate_ && is_finite((*distances)[2]) && arb_rel_accuracy_bits((*distances)[2].get()) >= kLeastAccuracy;
    }
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
        BallVector ray;
        ray[i] = Ball::exactly(i == 0 ? 1 : i == 1 ? -1 : wanted);
        clipped_.push_back(turned(ray, left));
      }
      return true;
    }
    const std::size_t first = nodes_.back().first_ray;
    const std::size_t count = rays_.size() - first;
    side_.resize(count);
    for (std::size_t i = 0; i < count; ++i) side_[i] = wanted * certain_sign(rays_[first + i][2]);
    if (std::all_of(side_.begin(), side_.end(), [](int side) { return side < 0; })) return false;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = i == 0 ? count - 1 : i - 1;
      const std::size_t after = i + 1 == count ? 0 : i + 1;
      // One that is certainly out, next to one of which that is not known: the edge between may be partly in.
      if (side_[i] >= 0 || side_[before] == 0 || side_[after] == 0) clipped_.push_back(turned(rays_[first + i], left));
      if (side_[i] * side_[after] < 0) {
        clipped_.push_back(turned(meeting(rays_[first + i], rays_[first + after]), left));
      }
    }
    return true;
  }

  /// The ray between two on which the third corner's value vanishes; that has different signs at the two.
  [[nodiscard]] BallVector meeting(const BallVector& x, const BallVector& y) const {
    BallVector result;
    Ball a, b;
    arb_abs(a.get(), y[2].get());
    arb_abs(b.get(), x[2].get());
    for (std::size_t i = 0; i < 2; ++i) {
      arb_mul(result[i].get(), a.get(), x[i].get(), precision());
      arb_addmul(result[i].get(), b.get(), y[i].get(), precision());
    }
    return result;
  }

  /// A lower bound of cosh² of the distance between the first edge and one with the ends l and r, from the cosh of the
  /// distances of these from the ends of the first edge: the least of four distances of an end from the other edge, and
  /// that of the lines, if it is possibly attained on the edges.
  [[nodiscard]] double cosh2_below(const BallVector& from_end, const BallVector& from_start, Interval edge) const {
    if (!is_finite(from_end[0]) || !is_finite(from_end[1]) || !is_finite(from_start[0]) || !is_finite(from_start[1]))
      return 1;
    const Interval el = at_least_1(from_end[0]);
    const Interval er = at_least_1(from_end[1]);
    const Interval sl = at_least_1(from_start[0]);
    const Interval sr = at_least_1(from_start[1]);
    // Far below what could overflow, so that nothing is NaN.
    constexpr double kFarthest = 1e70;
    if (!(std::max({el.upper, er.upper, sl.upper, sr.upper, edge.upper, first_edge_.upper}) < kFarthest)) return 1;
    const double ends = std::min({end_to_edge2(el, sl, first_edge_), end_to_edge2(er, sr, first_edge_),
                                  end_to_edge2(el, er, edge), end_to_edge2(sl, sr, edge)});
    const bool apart = has_no_foot(sinh2_to_line(el, sl, first_edge_), sinh2_to_line(er, sr, first_edge_), edge) ||
                       has_no_foot(sinh2_to_line(el, er, edge), sinh2_to_line(sl, sr, edge), first_edge_);
    return apart ? ends : std::min(ends, lines2_below(minus(times(el, sr), times(er, sl)), edge));
  }

  /// A lower bound of cosh² of the distance of the lines, if they have one. `product` is that of their
  /// unit normals, times sinh of the lengths of both edges.
  [[nodiscard]] double lines2_below(Interval product, Interval edge) const {
    const double least = product.lower > 0 ? product.lower : product.upper < 0 ? -product.upper : 0;
    const double most = std::max(std::abs(product.lower), std::abs(product.upper));
    const Interval scale = times(sinh2_of(first_edge_), sinh2_of(edge));
    // Lines that certainly meet have no distance.
    if (above(most * most) <= scale.lower) return std::numeric_limits<double>::infinity();
    return scale.upper > 0 ? below(below(least * least) / scale.upper) : 1;
  }

  /// Whether the distance from a line certainly is least at an end of an edge, if the line does not meet that of the
  /// edge: x and y are sinh² of the distances of its ends.
  [[nodiscard]] static bool has_no_foot(Interval x, Interval y, Interval edge) {
    const double cosh2 = above(edge.upper * edge.upper);
    return x.lower >= above(cosh2 * y.upper) || y.lower >= above(cosh2 * x.upper);
  }

  /// sinh² of the distance of a point from the line of an edge, p and q the cosh of its distances from the ends.
  [[nodiscard]] static Interval sinh2_to_line(Interval p, Interval q, Interval edge) {
    const Interval denominator = sinh2_of(edge);
    if (!(denominator.lower > 0)) return {0, std::numeric_limits<double>::infinity()};
    const Interval twice{2 * edge.lower, 2 * edge.upper};
    const Interval numerator = minus(minus(times(twice, times(p, q)), square(p)), square(q));
    const double lower = numerator.lower > 0 ? below(numerator.lower / denominator.upper) : 0;
    const double upper = above(std::max(numerator.upper, 0.0) / denominator.lower);
    return {std::max(below(lower - 1), 0.0), std::max(above(upper - 1), 0.0)};
  }

  [[nodiscard]] static Interval at_least_1(const Ball& cosh) {
    const Interval x = fast_interval(cosh);
    return {std::max(x.lower, 1.0), std::max(x.upper, 1.0)};
  }

  [[nodiscard]] static Interval sinh2_of(Interval cosh) {
    const Interval x = minus(square(cosh), {1, 1});
    return {std::max(x.lower, 0.0), x.upper};
  }

  /// A lower bound of cosh² of the distance of a point from an edge, p and q the cosh of the distances from its ends.
  [[nodiscard]] static double end_to_edge2(Interval p, Interval q, Interval edge) {
    if (p.lower >= above(edge.upper * q.upper)) return below(q.lower * q.lower);
    if (q.lower >= above(edge.upper * p.upper)) return below(p.lower * p.lower);
    // That of the line, which is no more; and, for very short edges, that of an end less the edge's length m: cosh of
    // that is at least p e⁻ᵐ.
    const double shrink = below(edge.upper - above(std::sqrt(sinh2_of(edge).upper)));
    const double end = shrink > 0 ? below(std::max(p.lower, q.lower) * shrink) : 0;
    return std::max(below(1 + sinh2_to_line(p, q, edge).lower), below(end * end));
  }

  const CrossingSearch& search_;
  const MovedNet& net_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> codes_;
  std::vector<BallVector> rays_;  ///< Of all nodes, one after the other.
  std::vector<BallVector> clipped_;
  std::vector<int> side_;
  Interval first_edge_{};
  bool accurate_ = true;
  bool ended_ = false;
};

CrossingSearch::CrossingSearch(const MovedNet& net, const std::vector<bool>& inner, const Ball& cosh_half)
    : net_(net), cosh_half_(cosh_half), code_(inner.size()) {
  const NetDocument& document = net.plane().net();
  const Precision scope(net.plane().precision());
  length_ = twice(acosh(cosh_half));
  std::vector<std::uint32_t> edges;
  for (std::uint32_t dart = 0; dart < inner.size(); ++dart) {
    if (dart < opposite(document, dart)) edges.push_back(dart);
  }
  // Any order is right. Short edges first: fewer geodesics cross them, and later searches have fewer edges to cross.
  std::stable_sort(edges.begin(), edges.end(), [&](std::uint32_t x, std::uint32_t y) {
    return inner[x] != inner[y] ? inner[y] : net.cosh_length(x).lower < net.cosh_length(y).lower;
  });
  for (const std::uint32_t edge : edges) {
    starts_ += inner[edge] ? 0 : 1;
    for (const std::uint32_t dart : {edge, opposite(document, edge)}) {
      code_[dart] = static_cast<std::uint32_t>(dart_of_.size());
      dart_of_.push_back(dart);
    }
  }
}

/// By code: an upper bound of cosh² of how far from the first edge a geodesic may be when it crosses a dart: L less a
/// lower bound for the way back from there, found by a search the other way round. Empty if the precision is too low.
std::vector<double> CrossingSearch::limits(std::size_t start, Way& way) const {
  const auto first = static_cast<std::uint32_t>(2 * start);
  const Ball half_length = half(length_);
  const double half_below = lower_end(half_length);
  const Precision scope(64);
  const double most = upper_end(sqr(cosh(half_length)));
  // cosh² of the least distance; ways longer than half are not followed.
  std::vector<double> cosh2(dart_of_.size(), std::numeric_limits<double>::infinity());
  cosh2[first] = 1;
  way.walk(
      dart_of_[first + 1], first, [&](std::uint32_t, double least) { return !(least > most); },
      [&](std::uint32_t code, double least) {
        cosh2[code ^ 1U] = std::min(cosh2[code ^ 1U], least);
        return true;
      });
  if (!way.accurate()) return {};
  std::vector<double> result(cosh2.size());
  for (std::size_t code = 0; code < result.size(); ++code) {
    double distance = half_below;
    if (std::isfinite(cosh2[code])) {
      const Ball back = acosh(sqrt(Ball::exactly(std::max(cosh2[code], 1.0))));
      distance = std::min(distance, std::max(lower_end(back), 0.0));
    }
    result[code] = upper_end(sqr(cosh(length_ - Ball::exactly(distance))));
  }
  return result;
}

/// From the values in the triangle before a dart to those in the one beyond.
void CrossingSearch::cross(std::uint32_t dart, BallVector& values) const {
  Ball apex;
  dot(apex, net_.beyond(dart), values, net_.plane().precision());
  values[2] = std::move(apex);
}

/// Whether the dart crossed after another one is that which has the third corner on the left.
bool CrossingSearch::is_to_the_right(std::uint32_t code, std::uint32_t after) const {
  return dart_of_[after] == next_dart(opposite(net_.plane().net(), dart_of_[code]));
}

/// Whether the axis of an element, in the chart of the first dart's triangle, possibly has the ends of all darts on the
/// sides where a closed geodesic has them that crosses them in this order.
bool CrossingSearch::possibly_follows(const BallIsometry& element, const std::vector<std::uint32_t>& codes) const {
  const slong precision = net_.plane().precision();
  const BallVector axis = axis_row(element, precision);
  const std::uint32_t root = dart_of_[codes[0]];
  BallVector values;
  dot(values[0], axis, net_.corner(next_dart(root)), precision);
  dot(values[1], axis, net_.corner(root), precision);
  dot(values[2], axis, net_.corner(previous_dart(root)), precision);
  net_.plane().spend(2 * codes.size() + 40);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (certainly_negative(values[0]) == Tri::yes || certainly_positive(values[1]) == Tri::yes) return false;
    if (i + 1 == codes.size()) break;
    cross(dart_of_[codes[i]], values);
    // The next dart begins or ends with the third corner.
    arb_swap(values[2].get(), values[is_to_the_right(codes[i], codes[i + 1]) ? 0 : 1].get());
  }
  return true;
}

OrbitOutcome CrossingSearch::run(std::size_t start, std::uint64_t limit,
                                 const std::function<Search(const BallIsometry&, const LabelProduct&)>& report) const {
  const LiftedPlane& plane = net_.plane();
  const NetDocument& document = plane.net();
  OrbitOutcome outcome;
  Way way(*this);
  const std::vector<double> farthest = limits(start, way);
  if (farthest.empty()) return outcome;
  const auto first = static_cast<std::uint32_t>(2 * start);
  const std::uint32_t root = dart_of_[first];

  // The element that takes the first triangle to the one where the first dart is met again, in the chart of the former.
  const auto element = [&] {
    BallIsometry to_end = identity_isometry();
    for (const std::uint32_t code : way.codes()) {
      if (const auto* transition = plane.transition(dart_of_[code])) {
        to_end = compose(transition->isometry, to_end, plane.precision());
      }
    }
    BallIsometry result = inverse(to_end);
    choose_sign(result);
    return result;
  };
  const auto labels = [&] {
    std::vector<SignedLabel> product{{corner_label(document, root), true}};
    for (const std::uint32_t code : way.codes()) {
      const std::uint32_t dart = dart_of_[code];
      product.push_back({corner_label(document, dart), false});
      product.push_back({corner_label(document, next_dart(opposite(document, dart))), true});
    }
    product.push_back({corner_label(document, root), false});
    return product;
  };

  const auto report_element = [&] {
    const BallIsometry g = element();
    if (certainly_less(cosh_half_, cosh_half_length(g)) == Tri::yes) return Search::go_on;
    if (!possibly_follows(g, way.codes())) return Search::go_on;
    // In the chart of the root's vertex.
    const BallIsometry& from_vertex = plane.label(corner_label(document, root));
    BallIsometry result = compose(inverse(from_vertex), compose(g, from_vertex, plane.precision()), plane.precision());
    choose_sign(result);
    return report(result, labels);
  };

  // period[n]: of the first n letters, as the beginning of a least rotation.
  std::vector<std::size_t> period{0, 1};
  const auto rival = [&] { return way.codes()[way.codes().size() - period[way.codes().size()]]; };
  way.walk(
      root, first,
      [&](std::uint32_t code, double cosh2) {
        plane.spend(kVisitOperations);
        if (++outcome.visits > limit) {
          outcome.limit_reached = true;
          way.end();
          return false;
        }
        return !(cosh2 > farthest[code]) && code >= rival();
      },
      [&](std::uint32_t code, double) {
        const std::size_t n = way.codes().size();
        const std::size_t next_period = code == rival() ? period[n] : n + 1;
        period.resize(n + 1);
        period.push_back(next_period);
        if (code == first && period[n] == n && report_element() == Search::stop) way.end();
        return !way.ended();
      });
  outcome.complete = !way.ended() && way.accurate();
  return outcome;
}

}  // namespace epsnet::certify
