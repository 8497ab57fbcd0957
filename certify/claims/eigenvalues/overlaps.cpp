#include "certify/claims/eigenvalues/overlaps.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "certify/base/text.h"
#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

BallIsometry product(const BallIsometry& f, const BallIsometry& g) { return compose(f, g, Precision::bits()); }

/// sinh²(d/2), d the distance of 0 and f(0).
Ball displacement(const BallIsometry& f) {
  Ball result;
  half_displacement_squared(result.get(), f, Precision::bits());
  return result;
}

/// From the disk of the vertex's chart to the one with the vertex in its centre.
BallIsometry to_centre(const NetDocument::Vertex& vertex) {
  const Ball x = Ball::exactly(vertex.x);
  const Ball y = Ball::exactly(vertex.y);
  const Ball scale = rsqrt(Ball::exactly(1) - sqr(x) - sqr(y));
  return {{scale, Ball()}, {-(scale * x), -(scale * y)}};
}

/// By vertex: the ends of its edges, as they are seen from it.
std::vector<std::vector<NearVertex>> neighbours(const NetDocument& net, const std::vector<BallIsometry>& labels) {
  std::vector<BallIsometry> frames;
  for (const NetDocument::Vertex& vertex : net.vertices) frames.push_back(to_centre(vertex));
  // From the disk around the start of a dart to the chart of its triangle.
  const auto placed = [&](std::uint32_t dart) {
    const std::uint32_t label = corner_label(net, dart);
    const BallIsometry from = inverse(looked_up(frames, start(net, dart), "there is no vertex"));
    return label == 0 ? from : product(looked_up(labels, label - 1, "there is no label"), from);
  };
  std::vector<std::vector<NearVertex>> result(net.vertices.size());
  for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
    const std::uint32_t next = next_dart(dart);
    result[start(net, dart)].push_back({start(net, next), product(inverse(placed(dart)), placed(next)), {}});
  }
  return result;
}

/// The lifts around one vertex.
class Neighbourhood {
 public:
  Neighbourhood(const std::vector<std::vector<NearVertex>>& edges, const Ball& shortest, const Ball& near,
                const Ball& far, const Budget& budget)
      : edges_(edges), shortest_(shortest), near_(near), far_(far), budget_(budget) {}

  [[nodiscard]] std::optional<std::vector<NearVertex>> around(std::uint32_t centre) const {
    const std::uint64_t work = 40 * ball_work(static_cast<std::uint64_t>(Precision::bits()));
    std::vector<NearVertex> found{{centre, identity_isometry(), {}}};
    std::multimap<std::uint32_t, std::size_t> of_vertex{{centre, 0}};  // Their numbers.
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const NearVertex& edge : edges_[found[i].vertex]) {
        const auto [first, last] = of_vertex.equal_range(edge.vertex);
        budget_.spend(work, static_cast<std::uint64_t>(std::distance(first, last)) + 1);
        BallIsometry isometry = product(found[i].isometry, edge.isometry);
        const Ball sinh_squared = displacement(isometry);
        if (certainly_less(far_, sinh_squared) == Tri::yes) continue;
        bool known = false;
        for (auto other = first; other != last && !known; ++other) {
          // Two lifts are the same, or at least as far from each other as the shortest edge is long.
          const Ball apart = displacement(product(inverse(found[other->second].isometry), isometry));
          known = certainly_less(apart, shortest_) == Tri::yes;
          if (!known && certainly_positive(apart) != Tri::yes) return std::nullopt;
        }
        if (known) continue;
        budget_.spend(memory_work(500));
        of_vertex.emplace(edge.vertex, found.size());
        found.push_back({edge.vertex, std::move(isometry), sinh_squared});
      }
    }
    std::vector<NearVertex> result;
    for (std::size_t i = 1; i < found.size(); ++i) {
      if (certainly_less(found[i].sinh_squared, near_) != Tri::no) result.push_back(std::move(found[i]));
    }
    return result;
  }

 private:
  const std::vector<std::vector<NearVertex>>& edges_;
  const Ball& shortest_;
  const Ball& near_;
  const Ball& far_;
  const Budget& budget_;
};

}  // namespace

std::optional<std::vector<std::vector<NearVertex>>> near_vertices(const NetDocument& net,
                                                                  const std::vector<BallIsometry>& labels,
                                                                  const Ball& distance, const Budget& budget,
                                                                  unsigned threads) {
  budget.spend(400 * ball_work(static_cast<std::uint64_t>(Precision::bits())), net.triangles.size());
  const auto edges = neighbours(net, labels);
  const Ball near = sqr(sinh(half(distance)));
  const Ball far = sqr(sinh(half(distance) + Ball::rounded(decimal(net.epsilon))));
  Ball shortest = far;
  for (const auto& ends : edges) {
    for (const NearVertex& end : ends) shortest = min(shortest, displacement(end.isometry));
  }
  const Neighbourhood neighbourhood(edges, shortest, near, far, budget);
  std::vector<std::optional<std::vector<NearVertex>>> found(net.vertices.size());
  for_each_parallel(found.size(), threads, [&](unsigned, std::size_t vertex) {
    found[vertex] = neighbourhood.around(static_cast<std::uint32_t>(vertex));
  });
  std::vector<std::vector<NearVertex>> result;
  for (auto& lifts : found) {
    if (!lifts) return std::nullopt;
    result.push_back(*std::move(lifts));
  }
  return result;
}

namespace {

using Point = std::complex<double>;

/// The sums over all lifts in a cell: all points within ρ of its centre.
class PartitionCell {
 public:
  PartitionCell(double reach, double radius)
      : reach_(reach),
        cosh_(std::cosh(reach)),
        sinh_(std::sinh(reach)),
        scale_(2 * std::pow(std::sinh(radius / 2), 2)) {}

  /// A lift, seen from the centre: C = cosh d, and the vector ∇C.
  void add(Point z) {
    const double gap = 1 - std::norm(z);
    const double beyond_one = 2 * std::norm(z) / gap;  // C − 1
    const Point vector = 2.0 * z / gap;
    const double sinh = std::sqrt(std::norm(vector));
    const double greatest_sinh = sinh * cosh_ + (1 + beyond_one) * sinh_;  // Of d + ρ.
    const double greatest_cosh = (1 + beyond_one) * cosh_ + sinh * sinh_;
    const double change = reach_ * greatest_sinh;
    const double turn = reach_ * greatest_cosh;  // Of the gradient.
    const double most = 1 - (beyond_one - change) / scale_;
    if (most <= 0) return;
    const double least = std::max(0.0, 1 - (beyond_one + change) / scale_);
    const double here = std::max(0.0, 1 - beyond_one / scale_);
    const double steepest = (sinh + turn) / scale_;
    const double flattest = std::max(0.0, sinh - turn) / scale_;
    squares_ += least * least;
    slopes_ += 2 * most * steepest;
    gradient_ += here * vector;
    turns_ += (most - least) * (sinh + turn) + here * turn;
    // Δh² = 2|∇h|² − 4hC/β, or 0 where h is 0.
    double low = 2 * flattest * flattest - 4 * most * greatest_cosh / scale_;
    double high = 2 * steepest * steepest - 4 * least * std::max(1.0, 1 + beyond_one - change) / scale_;
    if (least == 0) {
      low = std::min(low, 0.0);
      high = std::max(high, 0.0);
    }
    laplacians_ += std::max(std::abs(low), std::abs(high));
    lowest_ += low;
    highest_ += high;
  }

  [[nodiscard]] PartitionBounds bounds() const {
    if (squares_ <= 0) return {kInfinity, kInfinity};
    const double gradient = 2 * (std::abs(gradient_) + turns_) / scale_;
    const double laplacian = std::max(std::abs(lowest_), std::abs(highest_));
    return {(laplacians_ + laplacian) / squares_ +
                (2 * slopes_ * gradient + 2 * gradient * gradient) / (squares_ * squares_),
            (slopes_ + gradient) / squares_};
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  double reach_;  ///< ρ
  double cosh_;
  double sinh_;
  double scale_;        ///< β = cosh R − 1
  double squares_ = 0;  ///< Of h, at least.
  double slopes_ = 0;   ///< 2h|∇h|, at most.
  Point gradient_;      ///< Σ h∇C, at the centre,
  double turns_ = 0;    ///< and how far it may be from there.
  double laplacians_ = 0;
  double lowest_ = 0;
  double highest_ = 0;
};

}  // namespace

PartitionBounds partition_bounds(const std::vector<Point>& lifts, double epsilon, double radius) {
  constexpr double kSide = 0.05;  // Of the squares, relative to the disk.
  const double disk = std::tanh(epsilon / 2);
  const double side = kSide * disk;
  const double half_diagonal = side * 0.70710679;
  // In the disk with its cells, lengths are at most 2/(1 − |z|²) times as long. The rest is for rounding.
  const double reach = 2 * half_diagonal / (1 - std::pow(disk + side, 2)) * (1 + 1e-6) + 1e-9;
  PartitionBounds result;
  const int most = static_cast<int>(std::ceil(1 / kSide)) + 1;
  for (int i = -most; i <= most; ++i) {
    for (int j = -most; j <= most; ++j) {
      const Point centre(i * side, j * side);
      if (std::abs(centre) > disk + half_diagonal) continue;
      PartitionCell cell(reach, radius);
      for (const Point& lift : lifts) cell.add((lift - centre) / (1.0 - std::conj(centre) * lift));
      const PartitionBounds here = cell.bounds();
      result.laplacians = std::max(result.laplacians, here.laplacians);
      result.gradients = std::max(result.gradients, here.gradients);
    }
  }
  constexpr double kRounding = 1 + 1e-6;
  return {result.laplacians * kRounding, result.gradients * kRounding};
}

namespace {

ComplexBall quotient(const ComplexBall& x, const ComplexBall& y) {
  ComplexBall result;
  acb_div(result.get(), x.get(), y.get(), Precision::bits());
  return result;
}

/// J: so many that what is beyond them is as small as the rounding of the coefficients, and at most so many. Any number
/// is right, so it may be rounded.
std::uint32_t number_of_waves(const Ball& s, double lambda, std::uint32_t most) {
  constexpr double kSmall = -43;  // The logarithm of 2⁻⁶².
  const double t = std::sqrt(outer_interval(s).upper);
  for (std::uint32_t waves = 2; waves < most; ++waves) {
    const double sinh_wider = (waves + 1) / std::sqrt(lambda);
    const double cosh_wider = std::sqrt(1 + sinh_wider * sinh_wider);
    const double q = t * (1 + cosh_wider) / sinh_wider;
    if (q < 1 && lambda * (cosh_wider - 1) / (waves + 1) + waves * std::log(q) - std::log(1 - q) < kSmall) return waves;
  }
  return most;
}

/// By vertex, the bounds around it. Lifts are placed with errors of less than 10⁻¹²; nothing if the balls are wider.
std::optional<std::vector<PartitionBounds>> partition_around(const std::vector<std::vector<NearVertex>>& near,
                                                             const Ball& epsilon, double radius, unsigned threads) {
  std::vector<PartitionBounds> result(near.size());
  std::atomic<bool> known = true;
  for_each_parallel(near.size(), threads, [&](unsigned, std::size_t vertex) {
    std::vector<std::complex<double>> lifts{0};
    const auto middle = [&](arb_srcptr x) {
      if (arb_is_finite(x) == 0 || mag_cmp_2exp_si(arb_radref(x), -42) > 0) known = false;
      return arf_get_d(arb_midref(x), ARF_RND_NEAR);
    };
    for (const NearVertex& lift : near[vertex]) {
      const ComplexBall place = quotient(lift.isometry.b, conjugate(lift.isometry.a));
      lifts.emplace_back(middle(place.re()), middle(place.im()));
    }
    if (known) result[vertex] = partition_bounds(lifts, above(outer_interval(epsilon).upper), radius);
  });
  return known ? std::optional(std::move(result)) : std::nullopt;
}

/// The points of a circle around the midpoint of two vertices.
class MeetingCircle {
 public:
  /// With this tanh of half the radius.
  MeetingCircle(const BallIsometry& isometry, const ComplexBall& middle, const Ball& t, const Ball& greatest)
      : back_(inverse(isometry)), middle_(middle), turned_(conjugate(middle)), t_(t), greatest_(greatest) {}

  [[nodiscard]] bool set(const ComplexBall& direction, Overlaps::Point& point) const {
    const ComplexBall unit(Ball::exactly(1), Ball());
    const ComplexBall around = t_ * direction;
    const ComplexBall z = quotient(around + middle_, unit + turned_ * around);
    const ComplexBall w = quotient(back_.a * z + back_.b, conjugate(back_.b) * z + conjugate(back_.a));
    const auto own = LocalPoint::of(z, greatest_);
    const auto other = LocalPoint::of(w, greatest_);
    if (!own || !other) return false;
    point = {*own, *other};
    return true;
  }

 private:
  BallIsometry back_;
  ComplexBall middle_;
  ComplexBall turned_;
  Ball t_;
  const Ball& greatest_;
};

}  // namespace

std::optional<Overlaps> Overlaps::make(const NetDocument& net, const std::vector<BallIsometry>& labels, double radius,
                                       std::uint32_t order, double lambda, const Budget& budget, unsigned threads) {
  const Ball epsilon = Ball::rounded(decimal(net.epsilon));
  const Ball big_radius = Ball::exactly(radius);
  const auto near = near_vertices(net, labels, epsilon + big_radius, budget, threads);
  if (!near) return std::nullopt;
  const Ball cosh_epsilon = cosh(epsilon);
  const Ball reach = cosh_epsilon + cosh(big_radius);
  Overlaps result;
  // A point of a circle is at most S and half of the distance d from a vertex, and that is greatest for S = d/2. One of
  // balls that contain it is not greater than the upper end.
  const Ball greatest = (reach - 2) / reach;
  arb_get_ubound_arf(arb_midref(result.greatest_.get()), greatest.get(), Precision::bits());
  if (!is_finite(result.greatest_)) return std::nullopt;
  result.sinh_disk_ = sinh(epsilon);
  result.disk_area_ = outer_interval(twice(pi()) * (cosh_epsilon - 1)).upper;

  const std::uint64_t work = ball_work(static_cast<std::uint64_t>(Precision::bits()));
  std::vector<const BallIsometry*> isometries;
  std::vector<std::vector<ComplexBall>> roots(order + std::size_t{1});  // By J.
  result.roots_.resize(roots.size());
  for (std::uint32_t vertex = 0; vertex < near->size(); ++vertex) {
    for (const NearVertex& other : (*near)[vertex]) {
      result.sinh_disk_ = min(result.sinh_disk_, sqrt(other.sinh_squared));
      if (vertex > other.vertex) continue;
      budget.spend(20 * work + memory_work(200) + 60 * std::uint64_t{order});
      const Ball cosh_radius = half(reach) * rsqrt(norm(other.isometry.a));
      const Ball s = (cosh_radius - 1) / (cosh_radius + 1);
      const auto edge = LocalPoint::of(ComplexBall(sqrt(s), Ball()), result.greatest_);
      if (!edge) return std::nullopt;
      const std::uint32_t waves = number_of_waves(s, lambda, order);
      budget.spend(150 * work + memory_work(sizeof(Point)), std::uint64_t{2} * waves);
      if (roots[waves].empty()) {
        for (std::uint32_t k = 0; k < 2 * waves; ++k) {
          const ComplexBall& root = roots[waves].emplace_back(root_of_unity(k, 2 * waves));
          for (const arb_srcptr part : {root.re(), root.im()})
            result.roots_[waves].push_back(arf_get_d(arb_midref(part), ARF_RND_NEAR));
        }
      }
      result.pairs_.push_back({vertex, other.vertex, waves, result.points_.size(), *edge, s});
      result.points_.resize(result.points_.size() + std::size_t{2} * waves);
      isometries.push_back(&other.isometry);
    }
  }
  std::atomic<bool> known = true;
  for_each_parallel(result.pairs_.size(), threads, [&](unsigned, std::size_t i) {
    const Pair& pair = result.pairs_[i];
    const auto& [a, b] = *isometries[i];
    const Ball length = sqrt_of_nonnegative(norm(a));
    // The midpoint of 0 and b/ā.
    const MeetingCircle circle(*isometries[i], (1 / (length * (length + 1))) * (a * b), sqrt(pair.s), result.greatest_);
    const std::vector<ComplexBall>& directions = roots[pair.waves];
    for (std::size_t k = 0; k < directions.size() && known; ++k) {
      if (!circle.set(directions[k], result.points_[pair.first + k])) known = false;
    }
  });
  if (!known) return std::nullopt;
  constexpr std::uint64_t kCells = 1500;
  for (const auto& lifts : *near) budget.spend(40 * kCells, lifts.size() + 1);
  auto partition = partition_around(*near, epsilon, radius, threads);
  if (!partition) return std::nullopt;
  result.partition_ = *std::move(partition);
  return result;
}

}  // namespace epsnet::certify
