#include "certify/claims/eigenvalues/eigenfunction.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/near_vertices.h"
#include "certify/claims/eigenvalues/partition.h"
#include "certify/numbers/parallel.h"
#include "certify/numbers/rounding.h"

namespace epsnet::certify {
namespace {

Ball one() { return Ball::exactly(1); }
Ball not_a_number() { return one() / 0; }
Ball infinity() {
  Ball result;
  arb_pos_inf(result.get());
  return result;
}
/// Of a finite ball.
Ball greatest_of(const Ball& x) {
  Ball result;
  arb_get_ubound_arf(arb_midref(result.get()), x.get(), Precision::bits());
  return result;
}
Ball exponential(const Ball& x) { return ball_of(arb_exp, x); }
Ball power(const Ball& x, std::uint64_t exponent) {
  Ball result;
  arb_pow_ui(result.get(), x.get(), exponent, Precision::bits());
  return result;
}
ComplexBall quotient(const ComplexBall& x, const ComplexBall& y) {
  ComplexBall result;
  acb_div(result.get(), x.get(), y.get(), Precision::bits());
  return result;
}

/// The functions of a row, each of all vertices.
class LocalFunctions {
 public:
  /// `greatest` is tanh² of half of the greatest distance from a vertex at which they are asked for.
  LocalFunctions(const EigenvaluesDocument::Eigenfunctions& row, std::size_t vertices, const Ball& greatest)
      : lambda_(Ball::exactly(row.lambda)),
        functions_(row.functions),
        each_(row.functions.front().size() / vertices),
        order_(static_cast<std::uint32_t>(each_ / 2)),
        factors_(lambda_, order_, greatest) {}

  [[nodiscard]] const Ball& lambda() const { return lambda_; }
  [[nodiscard]] std::uint32_t order() const { return order_; }
  [[nodiscard]] std::size_t count() const { return functions_.size(); }

  /// α_m and β_m of one of the functions.
  [[nodiscard]] std::pair<Ball, Ball> coefficients(std::size_t function, std::size_t vertex, std::uint32_t m) const {
    const double* own = functions_[function].data() + vertex * each_;
    if (m == 0) return {Ball::exactly(own[0]), Ball()};
    return {Ball::exactly(own[std::size_t{2} * m - 1]), Ball::exactly(own[std::size_t{2} * m])};
  }

  /// A bound for one of the functions.
  [[nodiscard]] Ball total(std::size_t function, std::size_t vertex) const {
    Ball sum;
    for (std::uint32_t m = 0; m <= order_; ++m) {
      const auto [alpha, beta] = coefficients(function, vertex, m);
      sum += sqrt_of_nonnegative(sqr(alpha) + sqr(beta));
    }
    return sum;
  }

  /// The cost of values, in operations of balls.
  [[nodiscard]] std::uint64_t operations() const {
    return factors_.operations() + (6 + 2 * std::uint64_t{count()}) * std::uint64_t{order_};
  }

  /// Of each function, at a point of the disk with the vertex in its centre.
  [[nodiscard]] std::vector<Ball> values(std::size_t vertex, const ComplexBall& z) const {
    const slong bits = Precision::bits();
    const std::vector<Ball> factors = factors_(norm(z));
    // cos mθ and sin mθ times t^m F_m.
    std::vector<Ball> waves{factors[0]};
    ComplexBall power(one(), Ball());
    for (std::uint32_t m = 1; m <= order_; ++m) {
      acb_mul(power.get(), power.get(), z.get(), bits);
      for (const arb_srcptr part : {power.re(), power.im()}) {
        waves.emplace_back();
        arb_mul(waves.back().get(), part, factors[m].get(), bits);
      }
    }
    std::vector<Ball> result(count());
    Ball coefficient;
    for (std::size_t j = 0; j < count(); ++j) {
      const double* own = functions_[j].data() + vertex * each_;
      for (std::size_t i = 0; i < each_; ++i) {
        arb_set_d(coefficient.get(), own[i]);
        arb_addmul(result[j].get(), waves[i].get(), coefficient.get(), bits);
      }
    }
    return result;
  }

 private:
  Ball lambda_;
  const std::vector<EigenvaluesDocument::Coefficients>& functions_;
  std::size_t each_;
  std::uint32_t order_;
  RadialFactors factors_;
};

/// Bounds for a function and its gradient.
struct Bounds {
  Ball value;
  Ball gradient;
};

/// Bounds for the differences of functions, where both count and one vertex is within ε (docs/proof.md, Lemma 37.4).
class Mismatch {
 public:
  Mismatch(const LocalFunctions& functions, const Ball& cosh_sum) : functions_(functions), cosh_sum_(cosh_sum) {}

  /// The cost of a call, in operations of balls.
  [[nodiscard]] std::uint64_t operations() const {
    const std::uint64_t n = 2 * std::uint64_t{functions_.order()};
    return n * (2 * functions_.operations() + 2 * n * functions_.count() + 30);
  }

  /// By function: of that of `near.vertex`, seen from `vertex`, and that of `vertex`.
  [[nodiscard]] std::vector<Bounds> operator()(std::uint32_t vertex, const NearVertex& near) const {
    const auto& [a, b] = near.isometry;
    // The midpoint of 0 and b/ā, and tanh² of half the radius around it.
    const Ball length = sqrt_of_nonnegative(norm(a));
    const ComplexBall middle = (1 / (length * (length + 1))) * (a * b);
    const Ball cosh_radius = cosh_sum_ / twice(length);
    const Ball s = (cosh_radius - 1) / (cosh_radius + 1);
    const std::uint32_t waves = number_of_waves(s);
    std::vector<ComplexBall> roots;
    for (std::uint32_t k = 0; k < 2 * waves; ++k) roots.push_back(root_of_unity(k, 2 * waves));
    const auto values = differences(vertex, near, middle, sqrt(s), roots);
    const std::vector<Ball> factors = RadialFactors(functions_.lambda(), waves, s)(s);
    std::vector<Bounds> result;
    for (std::size_t j = 0; j < functions_.count(); ++j) {
      const Ball total = functions_.total(j, vertex) + functions_.total(j, near.vertex);
      result.push_back(from_values(values[j], roots, factors, s, total));
    }
    return result;
  }

 private:
  /// J: so many that what is beyond them is as small as the rounding of the coefficients, and at most M. Any number is
  /// right, so it may be rounded.
  [[nodiscard]] std::uint32_t number_of_waves(const Ball& s) const {
    constexpr double kSmall = -43;  // The logarithm of 2⁻⁶².
    const double t = std::sqrt(outer_interval(s).upper);
    const double lambda = outer_interval(functions_.lambda()).upper;
    for (std::uint32_t waves = 2; waves < functions_.order(); ++waves) {
      const double sinh_wider = (waves + 1) / std::sqrt(lambda);
      const double cosh_wider = std::sqrt(1 + sinh_wider * sinh_wider);
      const double q = t * (1 + cosh_wider) / sinh_wider;
      if (q < 1 && lambda * (cosh_wider - 1) / (waves + 1) + waves * std::log(q) - std::log(1 - q) < kSmall)
        return waves;
    }
    return functions_.order();
  }

  /// By function and point on the circle.
  [[nodiscard]] std::vector<std::vector<Ball>> differences(std::uint32_t vertex, const NearVertex& near,
                                                           const ComplexBall& middle, const Ball& t,
                                                           const std::vector<ComplexBall>& roots) const {
    const BallIsometry back = inverse(near.isometry);
    std::vector<std::vector<Ball>> result(functions_.count());
    const ComplexBall unit(one(), Ball());
    for (const ComplexBall& root : roots) {
      const ComplexBall around = t * root;
      const ComplexBall z = quotient(around + middle, unit + conjugate(middle) * around);
      const ComplexBall w = quotient(back.a * z + back.b, conjugate(back.b) * z + conjugate(back.a));
      const std::vector<Ball> other = functions_.values(near.vertex, w);
      const std::vector<Ball> own = functions_.values(vertex, z);
      for (std::size_t j = 0; j < result.size(); ++j) result[j].push_back(other[j] - own[j]);
    }
    return result;
  }

  /// Bounds in the disk from values on the circle; `total` bounds both functions together.
  [[nodiscard]] Bounds from_values(const std::vector<Ball>& values, const std::vector<ComplexBall>& roots,
                                   const std::vector<Ball>& factors, const Ball& s, const Ball& total) const {
    const std::size_t n = roots.size();
    const std::size_t end = n / 2;
    const Ball& lambda = functions_.lambda();
    const Ball t = sqrt(s);
    const Ball sinh_wider = (end + one()) * rsqrt(lambda);
    const Ball cosh_wider = sqrt(1 + sqr(sinh_wider));
    const Ball q = t * (1 + cosh_wider) / sinh_wider;
    if (certainly_less(q, one()) != Tri::yes) return {not_a_number(), not_a_number()};
    const Ball tail = twice(total) * exponential(lambda * (cosh_wider - 1) / (end + 1)) * power(q, end) / (1 - q);
    Bounds result{tail, tail * ((end + q / (1 - q)) / t + lambda * t)};
    const slong bits = Precision::bits();
    for (std::size_t m = 0; m < end; ++m) {
      ComplexBall sum;
      for (std::size_t k = 0; k < n; ++k) {
        const ComplexBall& root = roots[m * k % n];
        arb_addmul(sum.re(), values[k].get(), root.re(), bits);
        arb_addmul(sum.im(), values[k].get(), root.im(), bits);
      }
      const Ball once = (sqrt_of_nonnegative(norm(sum)) / n + tail) / abs(factors[m]);
      const Ball both = m == 0 ? once : twice(once);
      result.value += both;
      result.gradient += both * (m / t + lambda * t);
    }
    return result;
  }

  const LocalFunctions& functions_;
  Ball cosh_sum_;  ///< cosh ε + cosh R
};

/// Lower bounds for what functions have on the disks of this radius around all vertices: q of Lemma 37.6.
Ball norms_squared(const LocalFunctions& functions, std::size_t vertices, const Ball& sinh_radius) {
  const Ball cosh_radius = sqrt(1 + sqr(sinh_radius));
  const Ball s = (cosh_radius - 1) / (cosh_radius + 1);
  const std::size_t count = functions.count();
  std::vector<std::vector<Ball>> gram(count, std::vector<Ball>(count));
  for (std::uint32_t m = 0; m <= functions.order(); ++m) {
    const Ball decay = exponential(-twice(functions.lambda() * (cosh_radius - 1) / (m + 1)));
    const Ball weight = (m == 0 ? 2 : 1) * pi() * decay * twice(power(s, std::uint64_t{m} + 1)) / (m + 1);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Ball products;
        for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
          const auto [alpha, beta] = functions.coefficients(i, vertex, m);
          const auto [other_alpha, other_beta] = functions.coefficients(j, vertex, m);
          products += alpha * other_alpha + beta * other_beta;
        }
        gram[i][j] += weight * products;
      }
    }
  }
  std::optional<Ball> least;
  for (std::size_t i = 0; i < count; ++i) {
    Ball row = gram[i][i];
    for (std::size_t j = 0; j < count; ++j) {
      if (j != i) row = row - abs(gram[std::max(i, j)][std::min(i, j)]);
    }
    least = least ? min(*least, row) : row;
  }
  return *least;
}

/// By vertex, around it.
std::vector<PartitionBounds> partition_around(const std::vector<std::vector<NearVertex>>& near, const Ball& epsilon,
                                              double radius, const Budget& budget, unsigned threads) {
  constexpr std::uint64_t kCells = 1500;
  for (const auto& lifts : near) budget.spend(40 * kCells, lifts.size() + 1);
  std::vector<PartitionBounds> result(near.size());
  for_each_parallel(near.size(), threads, [&](unsigned, std::size_t vertex) {
    std::vector<std::complex<double>> lifts{0};
    for (const NearVertex& lift : near[vertex]) {
      const auto& [a, b] = lift.isometry;
      const ComplexBall place = quotient(b, conjugate(a));
      const auto middle = [](arb_srcptr x) { return arf_get_d(arb_midref(x), ARF_RND_NEAR); };
      lifts.emplace_back(middle(place.re()), middle(place.im()));
    }
    result[vertex] = partition_bounds(lifts, above(outer_interval(epsilon).upper), radius);
  });
  return result;
}

}  // namespace

RadialFactors::RadialFactors(const Ball& lambda, std::uint32_t order, const Ball& greatest)
    : order_(order),
      greatest_(greatest_of(greatest)),
      last_(series(lambda, order)),
      next_(series(lambda, order + 1)),
      weights_(1) {
  for (std::uint64_t m = 1; m <= order; ++m) weights_.push_back(1 + lambda / (m * (m + 1)));
}

/// ₂F₁(½ − ir, ½ + ir; m + 1; −x), λ = ¼ + r². For x ≤ 1 the terms alternate and, from (i + 1)(m + 1) ≥ λ on, decrease,
/// so what is left is less than the first term that is left out.
RadialFactors::Series RadialFactors::series(const Ball& lambda, std::uint32_t m) const {
  constexpr std::size_t kMostTerms = 500;
  Series result{{one()}, not_a_number()};
  if (certainly_less(half(one()), greatest_) != Tri::no) return result;
  const Ball x = greatest_ / (1 - greatest_);
  Ball power = one();
  for (std::uint64_t i = 0; i < kMostTerms; ++i) {
    Ball next = -result.coefficients.back() * (lambda + i * (i + 1)) / ((i + 1) * (m + 1 + i));
    power = power * x;
    const Ball size = abs(next) * power;
    const bool decreasing = certainly_less(lambda, Ball::exactly((i + 1) * (m + 1))) == Tri::yes;
    if (decreasing && certainly_less(size, scaled(one(), -Precision::bits())) == Tri::yes) {
      result.error = size;
      break;
    }
    result.coefficients.push_back(std::move(next));
  }
  return result;
}

Ball RadialFactors::value(const Series& series, const Ball& x) {
  Ball result;
  for (std::size_t i = series.coefficients.size(); i-- > 0;) {
    arb_mul(result.get(), result.get(), x.get(), Precision::bits());
    arb_add(result.get(), result.get(), series.coefficients[i].get(), Precision::bits());
  }
  arb_add_error(result.get(), series.error.get());
  return result;
}

std::vector<Ball> RadialFactors::operator()(const Ball& s) const {
  std::vector<Ball> result(order_ + 1);
  if (certainly_less(greatest_, s) != Tri::no) {
    std::fill(result.begin(), result.end(), not_a_number());
    return result;
  }
  const Ball x = s / (1 - s);
  const Ball sum = 1 + s;
  result[order_] = value(last_, x);
  Ball next = value(next_, x);
  Ball weighted;
  const slong bits = Precision::bits();
  for (std::uint32_t m = order_; m > 0; --m) {
    arb_mul(weighted.get(), weights_[m].get(), s.get(), bits);
    arb_mul(weighted.get(), weighted.get(), next.get(), bits);
    arb_mul(result[m - 1].get(), sum.get(), result[m].get(), bits);
    arb_sub(result[m - 1].get(), result[m - 1].get(), weighted.get(), bits);
    next = result[m];
  }
  return result;
}

std::optional<Ball> eigenvalue_error(const NetDocument& net, const EigenvaluesDocument::Eigenfunctions& row,
                                     const std::vector<BallIsometry>& labels, std::uint64_t genus, const Budget& budget,
                                     unsigned threads) {
  const std::size_t vertices = net.vertices.size();
  const Ball epsilon = Ball::rounded(decimal(net.epsilon));
  const Ball radius = Ball::exactly(row.radius);
  const Ball cosh_epsilon = cosh(epsilon);
  const Ball cosh_radius = cosh(radius);
  // A point of a circle is at most S and half of the distance d from a vertex, and that is greatest for S = d/2.
  const Ball reach = cosh_epsilon + cosh_radius;
  const LocalFunctions functions(row, vertices, (reach - 2) / reach);
  const std::size_t count = functions.count();
  const Ball& lambda = functions.lambda();
  const auto near = near_vertices(net, labels, epsilon + radius, budget, threads);
  if (!near) return std::nullopt;

  struct Pair {
    std::uint32_t vertex;
    const NearVertex* near;
    std::vector<Bounds> bounds;
  };
  std::vector<Pair> pairs;
  Ball sinh_disk = min(sinh(epsilon), rsqrt(lambda));
  for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
    for (const NearVertex& other : (*near)[vertex]) {
      sinh_disk = min(sinh_disk, sqrt(other.sinh_squared));
      if (vertex <= other.vertex) pairs.push_back({vertex, &other, {}});
    }
  }
  const Mismatch mismatch(functions, reach);
  const std::uint64_t work = ball_work(static_cast<std::uint64_t>(Precision::bits()));
  budget.spend(mismatch.operations() * work, pairs.size());
  budget.spend(memory_work(200) * count, pairs.size());
  budget.spend(6 * work * count * count, vertices * (functions.order() + std::uint64_t{1}));
  for_each_parallel(pairs.size(), threads,
                    [&](unsigned, std::size_t i) { pairs[i].bounds = mismatch(pairs[i].vertex, *pairs[i].near); });

  const std::vector<PartitionBounds> partition = partition_around(*near, epsilon, row.radius, budget, threads);
  Ball residuals;  // The sums of the squares.
  Ball errors;
  for (std::size_t j = 0; j < count; ++j) {
    std::vector<Bounds> greatest(vertices);
    for (const Pair& pair : pairs) {
      for (const std::uint32_t vertex : {pair.vertex, pair.near->vertex}) {
        greatest[vertex].value = max(greatest[vertex].value, pair.bounds[j].value);
        greatest[vertex].gradient = max(greatest[vertex].gradient, pair.bounds[j].gradient);
      }
    }
    Ball residual;
    Ball error;
    for (std::size_t k = 0; k < vertices; ++k) {
      const Ball laplacians = Ball::exactly(partition[k].laplacians);
      const Ball gradients = Ball::exactly(partition[k].gradients);
      residual = max(residual, greatest[k].value * laplacians + twice(greatest[k].gradient * gradients));
      error = max(error, greatest[k].value);
    }
    residuals += sqr(residual);
    errors += sqr(error);
  }
  const Ball area = 4 * (genus - 1) * pi();
  const Ball norm = sqrt_of_nonnegative(norms_squared(functions, vertices, sinh_disk)) - sqrt(area * errors);
  if (certainly_positive(norm) == Tri::no) return infinity();
  Ball bound = sqrt(area * residuals) / norm;
  return certainly_positive(norm) == Tri::yes && is_finite(bound) ? std::optional(std::move(bound)) : std::nullopt;
}

}  // namespace epsnet::certify
