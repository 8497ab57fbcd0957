#include "certify/exact/eigenfunctions.h"

#include <algorithm>

namespace epsnet::exact {
namespace {

using Function = EigenvaluesDocument::Eigenfunction;
using Value = Complex<Interval>;

Value quotient(const Value& x, const Value& y) { return (1 / norm(y)) * (x * conjugate(y)); }
Value moved(const Motion& g, const Value& z) {
  const Place place = image(g, Place{z, {1, 0}});
  return quotient(place.n, place.d);
}

/// tanh²(ρ/2) by cosh ρ.
Interval squared_tanh(const Interval& cosh) { return (cosh - 1) / (cosh + 1); }

/// e^(2πik/n), k = 0, …, n − 1, n even.
std::vector<Value> roots_of_unity(std::size_t n) {
  const Interval angle = Interval::pi() / static_cast<long>(2 * n);  // At most π/4.
  Value root{cos(angle), sin(angle)};
  root = root * root;
  root = root * root;
  std::vector<Value> roots{{1, 0}};
  while (roots.size() < n) roots.push_back(roots.back() * root);
  return roots;
}

/// Lemma 37.1: F_0, …, F_M at s <= ½, by the series of F_M and F_(M + 1), and then (b).
class RadialFactors {
 public:
  RadialFactors(const Interval& lambda, long order) : last_(lambda, order), next_(lambda, order + 1) {
    for (long m = 1; m <= order; ++m) weights_.push_back(1 + lambda / (m * (m + 1)));
  }

  [[nodiscard]] std::vector<Interval> operator()(const Interval& s) const {
    if (is_less(1, 2 * s) != Answer::no) give_up("a function is asked for too far from its vertex");
    const Interval x = s / (1 - s);
    std::vector<Interval> values(weights_.size() + 1);
    Interval after = next_.at(x);
    values.back() = last_.at(x);
    for (std::size_t m = weights_.size(); m > 0; --m) {
      values[m - 1] = (1 + s) * values[m] - weights_[m - 1] * s * after;
      after = values[m];
    }
    return values;
  }

 private:
  /// For x <= 1. Terms alternate, and decrease from (i + 1)(m + 1) >= λ on: the rest is less than the first of them.
  class Series {
   public:
    Series(const Interval& lambda, long m) {
      constexpr long kMostTerms = 500;
      // By (b) errors become less than twice as large, M times.
      const Interval small(1, 1, 128 + m);
      Interval term = 1;
      for (long i = 0; i < kMostTerms && is_less(square(term), square(small)) != Answer::yes; ++i) {
        coefficients_.push_back(term);
        term = -term * (lambda + i * (i + 1)) / ((i + 1) * (m + 1 + i));
      }
      const auto next = static_cast<long>(coefficients_.size());
      if (is_less(lambda, (next + 1) * (m + 1)) != Answer::yes) give_up("lambda is too large for a series");
      rest_ = hull(term, -term);
    }
    [[nodiscard]] Interval at(const Interval& x) const {
      Interval sum;
      for (std::size_t i = coefficients_.size(); i > 0; --i) sum = sum * x + coefficients_[i - 1];
      return sum + rest_;
    }

   private:
    std::vector<Interval> coefficients_;
    Interval rest_;
  };

  Series last_;
  Series next_;
  std::vector<Interval> weights_;  ///< By m − 1: 1 + λ/(m(m + 1)).
};

/// The functions of all vertices.
class LocalFunctions {
 public:
  LocalFunctions(const Function& function, std::size_t vertices)
      : lambda(function.lambda),
        order(static_cast<long>(function.coefficients.size() / vertices / 2)),
        factors(lambda, order) {
    for (const mpq_class& c : function.coefficients) coefficients_.emplace_back(c);
  }

  /// α_m + iβ_m
  [[nodiscard]] Value coefficient(Index vertex, long m) const {
    const std::size_t at = vertex * static_cast<std::size_t>(2 * order + 1) + static_cast<std::size_t>(2 * m);
    return m == 0 ? Value{coefficients_[at], 0} : Value{coefficients_[at - 1], coefficients_[at]};
  }

  /// At a point of the disk with the vertex in its centre.
  [[nodiscard]] Interval at(Index vertex, const Value& z) const {
    const std::vector<Interval> radial = factors(norm(z));
    Interval sum;
    Value power{1, 0};
    for (long m = 0; m <= order; ++m) {
      const Value c = coefficient(vertex, m);
      sum = sum + (c.re * power.re + c.im * power.im) * radial[static_cast<std::size_t>(m)];
      power = power * z;
    }
    return sum;
  }

  /// A bound for the function.
  [[nodiscard]] Interval total(Index vertex) const {
    Interval sum;
    for (long m = 0; m <= order; ++m) sum = sum + sqrt(norm(coefficient(vertex, m)));
    return sum;
  }

  const Interval lambda;
  const long order;
  const RadialFactors factors;

 private:
  std::vector<Interval> coefficients_;
};

/// Bounds for a function and its gradient.
struct Bounds {
  Interval value;
  Interval gradient;

  void include(const Bounds& other) {
    value = max(value, other.value);
    gradient = max(gradient, other.gradient);
  }
};

/// Lemma 37.4, J = M: for the difference of the functions of two vertices, both within ε + R of each other.
class Mismatch {
 public:
  Mismatch(const LocalFunctions& functions, const Interval& cosh_sum)
      : functions_(functions),
        cosh_sum_(cosh_sum),
        roots_(roots_of_unity(static_cast<std::size_t>(2 * functions.order))) {}

  [[nodiscard]] Bounds operator()(Index vertex, const NearLift& near) const {
    const auto& [a, b] = near.motion;
    const Interval cosh = sqrt(norm(a));  // Of half the distance.
    const Value midpoint = (1 / (cosh * (cosh + 1))) * (a * b);
    const Interval s = squared_tanh(cosh_sum_ / (2 * cosh));
    return bounds(values(vertex, near, midpoint, sqrt(s)), s, functions_.total(vertex) + functions_.total(near.vertex));
  }

 private:
  /// On the circle around the midpoint.
  [[nodiscard]] std::vector<Interval> values(Index vertex, const NearLift& near, const Value& midpoint,
                                             const Interval& t) const {
    const Motion back = inverse(near.motion);
    std::vector<Interval> result;
    for (const Value& root : roots_) {
      const Value around = t * root;
      const Value z = quotient(around + midpoint, Value{1, 0} + conjugate(midpoint) * around);
      result.push_back(functions_.at(near.vertex, moved(back, z)) - functions_.at(vertex, z));
    }
    return result;
  }

  /// In the disk, by the values on the circle. C = `total`.
  [[nodiscard]] Bounds bounds(const std::vector<Interval>& values, const Interval& s, const Interval& total) const {
    const Interval& lambda = functions_.lambda;
    const long j = functions_.order;
    const Interval t = sqrt(s);
    const Interval sinh_wider = (j + 1) / sqrt(lambda);
    const Interval cosh_wider = sqrt(1 + square(sinh_wider));
    const Interval q = t * (1 + cosh_wider) / sinh_wider;
    if (is_less(q, 1) != Answer::yes) give_up("a disk is too large");
    const Interval tail =
        2 * total * exp(lambda * (cosh_wider - 1) / (j + 1)) * power(q, static_cast<unsigned long>(j)) / (1 - q);
    Bounds result{tail, tail * ((j + q / (1 - q)) / t + lambda * t)};
    const std::vector<Interval> radial = functions_.factors(s);
    for (long m = 0; m < j; ++m) {
      Value sum{0, 0};
      for (std::size_t k = 0; k < roots_.size(); ++k)
        sum = sum + values[k] * roots_[static_cast<std::size_t>(m) * k % roots_.size()];
      const Interval size = sqrt(square(radial[static_cast<std::size_t>(m)]));
      const Interval one = (sqrt(norm(sum)) / (2 * j) + tail) / size;
      const Interval both = m == 0 ? one : 2 * one;
      result.value = result.value + both;
      result.gradient = result.gradient + both * (m / t + lambda * t);
    }
    return result;
  }

  const LocalFunctions& functions_;
  Interval cosh_sum_;  ///< cosh ε + cosh R
  std::vector<Value> roots_;
};

/// Lemma 37.5: A.
Interval norm_on_disks(const LocalFunctions& functions, std::size_t vertices, const Interval& sinh_radius) {
  const Interval cosh_radius = sqrt(1 + square(sinh_radius));
  const Interval s = squared_tanh(cosh_radius);
  Interval sum;
  for (long m = 0; m <= functions.order; ++m) {
    Interval squares;
    for (Index vertex = 0; vertex < vertices; ++vertex) squares = squares + norm(functions.coefficient(vertex, m));
    const Interval decay = exp(-2 * functions.lambda * (cosh_radius - 1) / (m + 1));
    sum = sum + (m == 0 ? 2 : 1) * Interval::pi() * squares * decay * 2 * power(s, static_cast<unsigned long>(m) + 1) /
                    (m + 1);
  }
  return sqrt(sum);
}

/// Lemma 37.2: bounds for the sums of |Δψ| and of |∇ψ| if so many lifts count.
std::array<Interval, 2> partition_bounds(std::size_t count, const Interval& cosh_epsilon, const Interval& cosh_radius) {
  const Interval overlap = static_cast<long>(count) / square((cosh_radius - cosh_epsilon) / (cosh_radius - 1));
  const Interval slope = (cosh_radius + 1) / (cosh_radius - 1);
  const Interval bend = 2 * cosh_radius / (cosh_radius - 1);
  return {4 * bend * sqrt(overlap) + 20 * slope * overlap, 4 * sqrt(slope * overlap)};
}

}  // namespace

std::size_t values_needed(const Function& function, const NearLifts& near) {
  std::size_t pairs = 0;
  for (Index vertex = 0; vertex < near.size(); ++vertex) {
    for (const NearLift& other : near[vertex]) pairs += other.vertex < vertex ? 0 : 1;
  }
  return pairs * 2 * (function.coefficients.size() / near.size() - 1);
}

Interval eigenvalue_error(const Function& function, const mpq_class& epsilon, const NearLifts& near, long minus_euler) {
  const LocalFunctions functions(function, near.size());
  const Interval cosh_epsilon = cosh(Interval(epsilon));
  const Interval cosh_radius = cosh(Interval(function.radius));
  const Mismatch mismatch(functions, cosh_epsilon + cosh_radius);
  std::vector<Bounds> greatest(near.size());
  // −η of Lemma 37.5.
  Interval least = max(-sinh(Interval(epsilon)), -1 / sqrt(functions.lambda));
  for (Index vertex = 0; vertex < near.size(); ++vertex) {
    for (const NearLift& other : near[vertex]) {
      least = max(least, -sqrt(norm(other.motion.b)));
      if (other.vertex < vertex) continue;
      const Bounds bounds = mismatch(vertex, other);
      greatest[vertex].include(bounds);
      greatest[other.vertex].include(bounds);
    }
  }
  Bounds error;
  Interval residual;
  for (std::size_t k = 0; k < near.size(); ++k) {
    const auto [laplacians, gradients] = partition_bounds(near[k].size() + 1, cosh_epsilon, cosh_radius);
    residual = max(residual, greatest[k].value * laplacians + 2 * greatest[k].gradient * gradients);
    error.include(greatest[k]);
  }
  const Interval root_of_area = sqrt(2 * minus_euler * Interval::pi());
  const Interval norm = norm_on_disks(functions, near.size(), -least) - root_of_area * error.value;
  if (is_less(0, norm) != Answer::yes) give_up("a function may be 0");
  return root_of_area * residual / norm;
}

}  // namespace epsnet::exact
