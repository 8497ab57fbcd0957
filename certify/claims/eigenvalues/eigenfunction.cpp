#include "certify/claims/eigenvalues/eigenfunction.h"

#include <algorithm>
#include <array>
#include <utility>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/near_vertices.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
namespace {

Ball one() { return Ball::exactly(1); }
Ball not_a_number() { return one() / 0; }
Ball infinity() {
  Ball result;
  arb_pos_inf(result.get());
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

/// The functions of all vertices.
class LocalFunctions {
 public:
  LocalFunctions(const EigenvaluesDocument::Eigenfunction& function, std::size_t vertices)
      : lambda_(Ball::exactly(function.lambda)),
        coefficients_(function.coefficients),
        each_(function.coefficients.size() / vertices),
        order_(static_cast<std::uint32_t>(each_ / 2)),
        factors_(lambda_, order_) {}

  [[nodiscard]] const Ball& lambda() const { return lambda_; }
  [[nodiscard]] std::uint32_t order() const { return order_; }

  /// √(α_m² + β_m²)
  [[nodiscard]] Ball amplitude(std::size_t vertex, std::uint32_t m) const {
    const auto [alpha, beta] = coefficients(vertex, m);
    return sqrt_of_nonnegative(sqr(Ball::exactly(alpha)) + sqr(Ball::exactly(beta)));
  }

  /// The cost of a value, in operations of balls.
  [[nodiscard]] std::uint64_t operations() const { return factors_.operations() + 8 * std::uint64_t{order_}; }

  /// At a point of the disk with the vertex in its centre.
  [[nodiscard]] Ball value(std::size_t vertex, const ComplexBall& z) const {
    const std::vector<Ball> factors = factors_(norm(z));
    ComplexBall power(one(), Ball());
    Ball result;
    Ball term;
    const slong bits = Precision::bits();
    for (std::uint32_t m = 0; m <= order_; ++m) {
      const auto [alpha, beta] = coefficients(vertex, m);
      arb_mul(term.get(), power.re(), Ball::exactly(alpha).get(), bits);
      arb_addmul(term.get(), power.im(), Ball::exactly(beta).get(), bits);
      arb_addmul(result.get(), term.get(), factors[m].get(), bits);
      acb_mul(power.get(), power.get(), z.get(), bits);
    }
    return result;
  }

 private:
  [[nodiscard]] std::pair<double, double> coefficients(std::size_t vertex, std::uint32_t m) const {
    const auto own = coefficients_.subspan(vertex * each_, each_);
    return m == 0 ? std::pair(own[0], 0.0) : std::pair(own[std::size_t{2} * m - 1], own[std::size_t{2} * m]);
  }

  Ball lambda_;
  std::span<const double> coefficients_;
  std::size_t each_;
  std::uint32_t order_;
  RadialFactors factors_;
};

/// Bounds for a function and its gradient.
struct Bounds {
  Ball value;
  Ball gradient;
};

/// Bounds for the difference of two functions, where both count and one vertex is within ε (docs/proof.md, Lemma 37.4).
class Mismatch {
 public:
  Mismatch(const LocalFunctions& functions, const Ball& cosh_sum) : functions_(functions), cosh_sum_(cosh_sum) {}

  /// The cost of a call, in operations of balls.
  [[nodiscard]] std::uint64_t operations() const {
    const std::uint64_t half = half_number();
    return 2 * half * (2 * functions_.operations() + 4 * half + 30);
  }

  /// Of the functions of `near.vertex`, seen from `vertex`, and of `vertex`. `total` bounds both together.
  [[nodiscard]] Bounds operator()(std::uint32_t vertex, const NearVertex& near, const Ball& total) const {
    const auto& [a, b] = near.isometry;
    // The midpoint of 0 and b/ā, and tanh² of half the radius around it.
    const Ball length = sqrt_of_nonnegative(norm(a));
    const ComplexBall middle = (1 / (length * (length + 1))) * (a * b);
    const Ball cosh_radius = cosh_sum_ / twice(length);
    const Ball s = (cosh_radius - 1) / (cosh_radius + 1);
    return from_values(values(vertex, near, middle, sqrt(s)), s, total);
  }

 private:
  /// J: half the number of sampled points.
  [[nodiscard]] std::uint32_t half_number() const { return functions_.order(); }

  /// On the circle.
  [[nodiscard]] std::vector<Ball> values(std::uint32_t vertex, const NearVertex& near, const ComplexBall& middle,
                                         const Ball& t) const {
    const BallIsometry back = inverse(near.isometry);
    std::vector<Ball> result;
    const ComplexBall unit(one(), Ball());
    for (std::uint32_t k = 0; k < 2 * half_number(); ++k) {
      const ComplexBall around = t * root_of_unity(k, 2 * half_number());
      const ComplexBall z = quotient(around + middle, unit + conjugate(middle) * around);
      const ComplexBall w = quotient(back.a * z + back.b, conjugate(back.b) * z + conjugate(back.a));
      result.push_back(functions_.value(near.vertex, w) - functions_.value(vertex, z));
    }
    return result;
  }

  /// Bounds in the disk from values on the circle.
  [[nodiscard]] Bounds from_values(const std::vector<Ball>& values, const Ball& s, const Ball& total) const {
    const std::uint32_t n = 2 * half_number();
    const std::uint32_t end = half_number();
    const Ball& lambda = functions_.lambda();
    const Ball t = sqrt(s);
    const Ball sinh_wider = (end + one()) * rsqrt(lambda);
    const Ball cosh_wider = sqrt(1 + sqr(sinh_wider));
    const Ball q = t * (1 + cosh_wider) / sinh_wider;
    if (certainly_less(q, one()) != Tri::yes) return {not_a_number(), not_a_number()};
    const Ball tail = twice(total) * exponential(lambda * (cosh_wider - 1) / (end + 1)) * power(q, end) / (1 - q);
    Bounds result{tail, tail * ((end + q / (1 - q)) / t + lambda * t)};
    std::vector<ComplexBall> roots;
    for (std::uint32_t k = 0; k < n; ++k) roots.push_back(root_of_unity(k, n));
    const std::vector<Ball> factors = RadialFactors(lambda, end)(s);
    for (std::uint32_t m = 0; m < end; ++m) {
      ComplexBall sum;
      for (std::uint32_t k = 0; k < n; ++k) sum = sum + values[k] * roots[std::uint64_t{m} * k % n];
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

/// A lower bound for the square of the norm of the functions of all vertices, each on the disk of this radius.
Ball norm_squared(const LocalFunctions& functions, std::size_t vertices, const Ball& sinh_radius) {
  const Ball cosh_radius = sqrt(1 + sqr(sinh_radius));
  const Ball s = (cosh_radius - 1) / (cosh_radius + 1);
  Ball result;
  for (std::uint32_t m = 0; m <= functions.order(); ++m) {
    Ball squares;
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) squares += sqr(functions.amplitude(vertex, m));
    const Ball decay = exponential(-twice(functions.lambda() * (cosh_radius - 1) / (m + 1)));
    result += (m == 0 ? 2 : 1) * pi() * squares * decay * twice(power(s, std::uint64_t{m} + 1)) / (m + 1);
  }
  return result;
}

}  // namespace

RadialFactors::RadialFactors(const Ball& lambda, std::uint32_t order)
    : order_(order), last_(series(lambda, order)), next_(series(lambda, order + 1)), weights_(1) {
  for (std::uint64_t m = 1; m <= order; ++m) weights_.push_back(1 + lambda / (m * (m + 1)));
}

/// ₂F₁(½ − ir, ½ + ir; m + 1; −x), λ = ¼ + r². For x ≤ 1 the terms alternate and, from (i + 1)(m + 1) ≥ λ on, decrease,
/// so what is left is less than the first term that is left out.
RadialFactors::Series RadialFactors::series(const Ball& lambda, std::uint32_t m) {
  constexpr std::size_t kMostTerms = 500;
  Series result{{one()}, not_a_number()};
  for (std::uint64_t i = 0; i < kMostTerms; ++i) {
    Ball next = -result.coefficients.back() * (lambda + i * (i + 1)) / ((i + 1) * (m + 1 + i));
    const Ball size = abs(next);
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
  if (certainly_less(half(one()), s) != Tri::no) {
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

std::optional<Ball> eigenvalue_error(const EigenvaluesDocument& document,
                                     const EigenvaluesDocument::Eigenfunction& function,
                                     const std::vector<BallIsometry>& labels, std::uint32_t genus, const Budget& budget,
                                     unsigned threads) {
  const std::size_t vertices = document.net.vertices.size();
  const LocalFunctions functions(function, vertices);
  const Ball& lambda = functions.lambda();
  const Ball epsilon = Ball::rounded(decimal(document.net.epsilon));
  const Ball radius = Ball::exactly(function.radius);
  const Ball cosh_epsilon = cosh(epsilon);
  const Ball cosh_radius = cosh(radius);
  const auto near = near_vertices(document, labels, epsilon + radius, budget);
  if (!near) return std::nullopt;

  std::vector<Ball> amplitudes(vertices);  // Bounds for the functions.
  for (std::size_t k = 0; k < vertices; ++k) {
    for (std::uint32_t m = 0; m <= functions.order(); ++m) amplitudes[k] += functions.amplitude(k, m);
  }
  struct Pair {
    std::uint32_t vertex;
    const NearVertex* near;
    Bounds bounds;
  };
  std::vector<Pair> pairs;
  Ball sinh_disk = min(sinh(epsilon), rsqrt(lambda));
  for (std::uint32_t vertex = 0; vertex < vertices; ++vertex) {
    for (const NearVertex& other : (*near)[vertex]) {
      sinh_disk = min(sinh_disk, sqrt(other.sinh_squared));
      if (vertex <= other.vertex) pairs.push_back({vertex, &other, {}});
    }
  }
  const Mismatch mismatch(functions, cosh_epsilon + cosh_radius);
  budget.spend(mismatch.operations() * ball_work(static_cast<std::uint64_t>(Precision::bits())), pairs.size());
  for_each_parallel(pairs.size(), threads, [&](unsigned, std::size_t i) {
    Pair& pair = pairs[i];
    pair.bounds = mismatch(pair.vertex, *pair.near, amplitudes[pair.vertex] + amplitudes[pair.near->vertex]);
  });

  std::vector<Bounds> greatest(vertices);
  for (const Pair& pair : pairs) {
    for (const std::uint32_t vertex : {pair.vertex, pair.near->vertex}) {
      greatest[vertex].value = max(greatest[vertex].value, pair.bounds.value);
      greatest[vertex].gradient = max(greatest[vertex].gradient, pair.bounds.gradient);
    }
  }
  const Ball least_sum = sqr((cosh_radius - cosh_epsilon) / (cosh_radius - 1));
  const Ball slope = (cosh_radius + 1) / (cosh_radius - 1);  // The square of the greatest one of 1 − (cosh d − 1)/….
  const Ball bend = twice(cosh_radius) / (cosh_radius - 1);
  Ball residual;
  Ball error;
  for (std::size_t k = 0; k < vertices; ++k) {
    const Ball overlap = ((*near)[k].size() + 1) / least_sum;
    const Ball gradients = 4 * sqrt(slope * overlap);
    const Ball laplacians = 4 * bend * sqrt(overlap) + 20 * slope * overlap;
    residual = max(residual, greatest[k].value * laplacians + twice(greatest[k].gradient * gradients));
    error = max(error, greatest[k].value);
  }
  const Ball root_of_area = sqrt(4 * (genus - 1) * pi());
  const Ball norm = sqrt_of_nonnegative(norm_squared(functions, vertices, sinh_disk)) - root_of_area * error;
  if (certainly_positive(norm) == Tri::no) return infinity();
  Ball bound = root_of_area * residual / norm;
  return certainly_positive(norm) == Tri::yes && is_finite(bound) ? std::optional(std::move(bound)) : std::nullopt;
}

}  // namespace epsnet::certify
