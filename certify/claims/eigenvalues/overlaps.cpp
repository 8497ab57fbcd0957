#include "certify/claims/eigenvalues/overlaps.h"

#include <atomic>
#include <cmath>
#include <complex>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/near_vertices.h"
#include "certify/numbers/parallel.h"
#include "certify/numbers/rounding.h"

namespace epsnet::certify {
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
