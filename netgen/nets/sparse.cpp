#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/predicates.h"
#include "netgen/nets/refine.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {
namespace {

double power(double x, unsigned n) {
  double result = 1;
  for (; n != 0; n >>= 1, x *= x) {
    if ((n & 1) != 0) result *= x;
  }
  return result;
}

/// Weights, moves and circles are heuristic, in binary64. Proved signs decide every change of the triangulation: no
/// triangle turns over, and no Delaunay edge is flipped.
class Relaxation {
 public:
  Relaxation(Triangulation& triangulation, const Threshold& size, std::optional<VertexId> kept)
      : triangulation_(triangulation),
        editor_(triangulation),
        kept_(kept),
        scale_(4 / size.high()),
        before_(editor_.points()),
        velocity_(triangulation.vertex_count()) {
    find_circles();
  }

  void sweep(const RelaxationSweep& sweep) {
    find_pulls(sweep.exponent);
    move(sweep);
    find_circles();
    flip_where_needed();
    change_charts();
  }

  [[nodiscard]] std::uint64_t flips() const { return flips_; }

 private:
  /// The Euclidean circumcircle of a triangle in the disk of its chart.
  struct Circle {
    Complex<double> middle;
    double radius2;  ///< The square of the radius.
    double area;     ///< Twice the area of the triangle with straight sides.
  };
  /// Sums over the triangles around a vertex, in its chart: of their weights, and of their weights times the vectors to
  /// their centres.
  struct Pull {
    double weight = 0;
    Complex<double> way{0, 0};
    Complex<double> way2{0, 0};
  };

  [[nodiscard]] Complex<double> lifted(const Triangle& triangle, std::uint32_t i) const {
    const Complex<double>& z = triangulation_.point(triangle.vertex[i]);
    const LabelId label = triangle.label(i);
    return label == kIdentity ? z : triangulation_.atlas().isometry(label)(z);
  }

  /// False if the triangle is not counterclockwise.
  [[nodiscard]] bool find_circle(TriangleId t) {
    const Triangle& triangle = triangulation_.triangle(t);
    const Complex<double> a = triangulation_.point(triangle.vertex[0]);
    const Complex<double> b = lifted(triangle, 1);
    const Complex<double> c = lifted(triangle, 2);
    const StageSign seen = triangle.all_identity() ? orientation_stage<double>(a, b, c, 0) : StageSign{};
    const int sign = seen.certain ? seen.sign
                                  : triangulation_.orientation(triangulation_.corner(t, 0), triangulation_.corner(t, 1),
                                                               triangulation_.corner(t, 2));
    if (sign <= 0) return false;
    const Complex<double> u = b - a;
    const Complex<double> v = c - a;
    const double uu = norm(u);
    const double vv = norm(v);
    const double uv = cross(u, v);
    // A circle is not usable if a lifted edge is very short, as in circumcentre_fast: the error of a lift may move it
    // by many turns around a short curve. Nor is it if the triangle has an angle near 0 or π. Area 0 means no weight.
    constexpr double kShortestLifted2 = 1e-12;
    const bool is_seen = uv > 0 && uv * uv > 1e-6 * (uu * vv) &&
                         (triangle.all_identity() || std::min({uu, vv, norm(b - c)}) > kShortestLifted2);
    const double half = 0.5 / uv;
    const Complex<double> from_a{(v.y * uu - u.y * vv) * half, (u.x * vv - v.x * uu) * half};
    circles_[t] = {a + from_a, norm(from_a), is_seen ? uv : 0};
    return true;
  }

  /// Finds the circles of all triangles. If a triangle is not counterclockwise, its vertices go back to where they were
  /// before the sweep. This is repeated until all triangles are; in the worst case all vertices go back.
  void find_circles() {
    circles_.resize(triangulation_.triangle_count());
    bool all = false;
    while (!all) {
      all = true;
      for (const TriangleId t : triangulation_.triangles()) {
        if (find_circle(t)) continue;
        all = false;
        for (const VertexId v : triangulation_.triangle(t).vertex) {
          editor_.points()[v] = before_[v];
          velocity_[v] = {0, 0};
        }
      }
    }
  }

  void find_pulls(unsigned exponent) {
    pulls_.assign(triangulation_.vertex_count(), {});
    for (const TriangleId t : triangulation_.triangles()) {
      const Circle& circle = circles_[t];
      const Triangle& triangle = triangulation_.triangle(t);
      // As in circumcentre_near_origin. If the circle comes near the unit circle, or does not exist, the weight is NaN,
      // and so are the sums of the triangle's vertices, which therefore stay where they are.
      const double sum = 1 + norm(circle.middle) - circle.radius2;
      const double rest = sum * sum - 4 * norm(circle.middle);
      constexpr double kSmallestRest = 0.01;
      const double inverse = circle.area > 0 && rest > kSmallestRest ? 1 / rest : kNaN;
      const Complex<double> hyperbolic_centre = (2 / (sum + std::sqrt(rest))) * circle.middle;
      // sinh²R = 4 radius2/rest. The unit of areas is about 1/rest, up to a factor.
      const double weight = circle.area * inverse * power(scale_ * circle.radius2 * inverse, exponent);
      for (std::uint32_t i = 0; i < 3; ++i) {
        const VertexId v = triangle.vertex[i];
        const LabelId label = triangle.label(i);
        const Complex<double> centre = label == kIdentity
                                           ? hyperbolic_centre
                                           : epsnet::inverse(triangulation_.atlas().isometry(label))(hyperbolic_centre);
        const Complex<double> way = centre - triangulation_.point(v);
        Pull& pull = pulls_[v];
        pull.weight += weight;
        pull.way = pull.way + weight * way;
        pull.way2 = pull.way2 + weight * (way * way);
      }
    }
  }

  void move(const RelaxationSweep& sweep) {
    before_ = editor_.points();
    for (const VertexId v : triangulation_.vertices()) {
      const Pull& pull = pulls_[v];
      constexpr double kMost = std::numeric_limits<double>::max();
      if (v == kept_ || !(pull.weight > 0 && pull.weight < kMost)) continue;
      // When v is moved to the origin, the point v + w gets the coordinate (w + v̄w²/h + …)/h, h = 1 − |v|². The mean is
      // taken of these to second order; otherwise all vertices would drift away from or towards the chart's origin.
      const Complex<double>& z = before_[v];
      const Complex<double> bend = (1 / (1 - norm(z))) * conj(z);
      const Complex<double> mean = (1 / pull.weight) * (pull.way + bend * pull.way2);
      const Complex<double> way = sweep.momentum * velocity_[v] + sweep.step * mean;
      velocity_[v] = way;
      const Complex<double> moved = z + way - bend * (way * way);
      // Predicates are valid up to 0.75; in the next step the vertex gets another chart.
      constexpr double kFarthest = 0.74;
      if (norm(moved) < kFarthest * kFarthest) editor_.points()[v] = moved;
    }
  }

  void flip_where_needed() {
    Journal journal = open_journal(triangulation_);
    for (const TriangleId t : triangulation_.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const Dart d = make_dart(t, i);
        if (!(d < triangulation_.opposite(d)) || is_seen_delaunay(d) || triangulation_.is_delaunay(d)) continue;
        pending_.push_back(d);
        flips_ += restore_delaunay(triangulation_, pending_, &journal);
        for (const auto& [changed, old] : journal.overwritten) {
          (void)find_circle(changed);  // Counterclockwise, as flips are of convex quadrilaterals.
        }
        journal.overwritten.clear();
      }
    }
  }

  /// Whether d is Delaunay according to binary64 and the circle of the triangle of d.
  [[nodiscard]] bool is_seen_delaunay(Dart d) const {
    const TriangleId t = triangle_of(d);
    const Dart e = triangulation_.opposite(d);
    const Triangle& across = triangulation_.triangle(triangle_of(e));
    if (!triangulation_.triangle(t).all_identity() || !across.all_identity()) return false;
    const Complex<double>& apex = triangulation_.point(across.vertex[previous(corner_of(e))]);
    constexpr double kBeyond = 1 + 1e-9;
    return norm(apex - circles_[t].middle) > kBeyond * circles_[t].radius2;
  }

  /// Gives another chart to vertices that have moved too far from the origin of theirs.
  void change_charts() {
    constexpr double kRadius2 = kChartRadius * kChartRadius;
    const ById<VertexId, Complex<double>>& points = editor_.points();
    if (std::ranges::none_of(points, [](const Complex<double>& z) { return norm(z) > kRadius2; })) return;
    for (const TriangleId t : triangulation_.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (norm(points[triangulation_.triangle(t).vertex[i]]) > kRadius2) change_chart(make_dart(t, i));
      }
    }
  }

  /// The same for the vertex that d leaves.
  void change_chart(Dart d) {
    const VertexId v = triangulation_.corner(d).vertex;
    const Vertex vertex = triangulation_.vertex(v);
    std::optional<LiftedPoint> point = triangulation_.atlas().lifted_point_nearby(vertex.chart, vertex.z);
    if (!point)
      point = triangulation_.lifted_point(vertex.chart, convert<Mp1024>(vertex.z), Atlas::Precision::binary64);
    // If rounding the vertex turns a triangle over, it is tried again after the next sweep.
    if (!point || !move_vertex(triangulation_, d, *point)) return;
    velocity_[v] = {0, 0};
    for (const Dart x : triangulation_.star(d)) {
      (void)find_circle(triangle_of(x));  // Counterclockwise, as move_vertex has checked.
    }
  }

  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  Triangulation& triangulation_;
  const Editor editor_;
  const std::optional<VertexId> kept_;
  const double scale_;  ///< 4/sinh²R of a typical triangle.
  ById<VertexId, Complex<double>> before_;
  ById<VertexId, Complex<double>> velocity_;
  ById<TriangleId, Circle> circles_;
  ById<VertexId, Pull> pulls_;
  std::vector<Dart> pending_;
  std::uint64_t flips_ = 0;
};

}  // namespace

std::uint64_t relax(Triangulation& triangulation, const Threshold& size, std::span<const RelaxationSweep> sweeps,
                    std::optional<VertexId> kept) {
  Relaxation relaxation(triangulation, size, kept);
  for (const RelaxationSweep& sweep : sweeps) {
    relaxation.sweep(sweep);
  }
  // Flips the edges that binary64 wrongly took for Delaunay.
  return relaxation.flips() + make_delaunay(triangulation);
}

namespace {

Length times(const Length& length, const Rational& factor) {
  const Rational product = length.value() * factor;
  return Length(product.str());
}

/// Returns `count` sweeps whose exponent grows evenly from the first to the last. A step of 1.4/exponent is nearly the
/// longest with which vertices come to rest.
std::vector<RelaxationSweep> sweeps(unsigned count, unsigned first, unsigned last) {
  std::vector<RelaxationSweep> result;
  for (unsigned k = 0; k < count; ++k) {
    const unsigned exponent = first + k * (last - first) / count;
    result.push_back({exponent, 1.4 / exponent, 0.7});
  }
  return result;
}

/// The numbers below were found by trials, which docs/design.md lists.
class SparseRefinement {
 public:
  SparseRefinement(Triangulation& triangulation, const Length& epsilon, const NetOptions& options,
                   const Variant& variant)
      : triangulation_(triangulation),
        epsilon_(epsilon),
        options_(options),
        variant_(variant),
        covering_(epsilon.value()) {
    if (options.base) kept_ = VertexId(0);
  }

  [[nodiscard]] RefinementStatistics run() {
    // 2.15/1.24² = 1.40 times the lower bound of ε.
    refine_for(Rational(124, 100), 0.15);
    // Sweeps pass over all triangles many times, so these should be near each other in memory.
    renumber_by_neighbours(triangulation_);
    relax_with(sweeps(14, 6, 14), 0.5);
    // Some places have a few points too many, others too few; relaxation alone would be slow to even this out.
    const std::array<Rational, 3> factors{Rational(106, 100), Rational(103, 100), Rational(102, 100)};
    for (std::size_t i = 0; i < factors.size() && (i == 0 || are_many_large()); ++i) {
      thin(factors[i]);
      refine_for(factors[i], shown_ + 0.03);
      relax_with(sweeps(8, 16, 16), shown_ + 0.1);
    }
    if (thin(1) > 0) relax_with(sweeps(3, 16, 16), 0.92);
    thin(1);
    refine_for(1, 1);
    return statistics_;
  }

 private:
  /// Refines for a larger ε. `shown` is the share of the progress that is done afterwards.
  void refine_for(const Rational& factor, double shown) {
    NetOptions options = options_;
    if (options_.progress) {
      options.progress = [this, shown](std::string_view what, double share) {
        options_.progress(what, shown_ + (shown - shown_) * share);
      };
    }
    const RefinementStatistics made =
        refine(triangulation_, factor == 1 ? epsilon_ : times(epsilon_, factor), options, variant_);
    shown_ = shown;
    statistics_.insertions += made.insertions;
    statistics_.flips += made.flips;
    statistics_.removed += made.removed;
    statistics_.located += made.located;
    statistics_.located_at_start += made.located_at_start;
    statistics_.walk_steps += made.walk_steps;
    statistics_.longest_walk = std::max(statistics_.longest_walk, made.longest_walk);
  }

  void relax_with(std::span<const RelaxationSweep> sweeps, double shown) {
    statistics_.flips += relax(triangulation_, covering_, sweeps, kept_);
    shown_ = shown;
    if (options_.progress) {
      options_.progress("net: " + std::to_string(triangulation_.vertex_count()) + " vertices, spread evenly", shown);
    }
  }

  /// Removes vertices that are closer than a multiple of ε to others, and returns how many.
  std::uint32_t thin(const Rational& factor) {
    const Threshold apart(epsilon_.value() * factor / 2);
    const auto contracts = [&](Dart d) {
      const Corner from = triangulation_.corner(d);
      const Corner to = triangulation_.corner(next_dart(d));
      return from.vertex != kept_ && triangulation_.compare_distance(from, to, apart) <= 0;
    };
    const std::uint32_t removed = contract_all(triangulation_, contracts);
    statistics_.removed += removed;
    statistics_.flips += make_delaunay(triangulation_);
    return removed;
  }

  /// Whether more than one percent of the triangles are larger than ε, each of which would lead to a new vertex.
  [[nodiscard]] bool are_many_large() {
    std::uint64_t large = 0;
    for (const TriangleId t : triangulation_.triangles()) {
      if (triangulation_.compare_circumradius(t, covering_) > 0) ++large;
    }
    return 100 * large > triangulation_.triangle_count();
  }

  Triangulation& triangulation_;
  const Length& epsilon_;
  const NetOptions& options_;
  const Variant& variant_;
  const Threshold covering_;
  std::optional<VertexId> kept_;
  double shown_ = 0;
  RefinementStatistics statistics_;
};

}  // namespace

RefinementStatistics refine_sparsely(Triangulation& triangulation, const Length& epsilon, const NetOptions& options,
                                     const Variant& variant) {
  const double least = require_possible(triangulation.surface(), epsilon);
  const Vertex base = triangulation.vertex(VertexId(0));
  Triangulation plain = triangulation.clone();
  RefinementStatistics statistics = SparseRefinement(triangulation, epsilon, options, variant).run();
  // With few points, or thin parts, the refinement alone may happen to be better. The base may also have moved.
  const Vertex first = triangulation.vertex(VertexId(0));
  const bool base_is_lost = options.base && !(first.z == base.z && first.chart == base.chart);
  if (base_is_lost || triangulation.vertex_count() > 1.5 * least) {
    const RefinementStatistics plain_statistics = refine(plain, epsilon, options, variant);
    if (base_is_lost || plain.vertex_count() <= triangulation.vertex_count()) {
      triangulation = std::move(plain);
      statistics = plain_statistics;
    }
  }
  return statistics;
}

}  // namespace epsnet
