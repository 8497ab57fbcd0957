#include "certify/exact/eigenfunctions.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "certify/exact/loops.h"

namespace epsnet::exact {

RadialFactors::RadialFactors(const Interval& lambda, long order) : last_(lambda, order), next_(lambda, order + 1) {
  for (long m = 1; m <= order; ++m) weights_.push_back(1 + lambda / (m * (m + 1)));
}

std::vector<Interval> RadialFactors::operator()(const Interval& s) const {
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

RadialFactors::Series::Series(const Interval& lambda, long m) {
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

Interval RadialFactors::Series::at(const Interval& x) const {
  Interval sum;
  for (std::size_t i = coefficients_.size(); i > 0; --i) sum = sum * x + coefficients_[i - 1];
  return sum + rest_ * power(x, coefficients_.size());
}

namespace {

using Row = EigenvaluesDocument::Eigenfunctions;
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

Interval absolute(const Interval& x) { return max(x, -x); }

/// The functions of a row around all vertices.
class LocalFunctions {
 public:
  LocalFunctions(const Row& row, std::size_t vertices)
      : lambda(row.lambda), order(static_cast<long>(row.functions[0].size() / vertices / 2)), factors(lambda, order) {
    for (const Coefficients& function : row.functions) coefficients_.emplace_back(function.begin(), function.end());
  }

  [[nodiscard]] std::size_t count() const { return coefficients_.size(); }

  /// α_m + iβ_m of function i.
  [[nodiscard]] Value coefficient(std::size_t i, Index vertex, long m) const {
    const std::vector<Interval>& all = coefficients_[i];
    const std::size_t at = vertex * static_cast<std::size_t>(2 * order + 1) + static_cast<std::size_t>(2 * m);
    return m == 0 ? Value{all[at], 0} : Value{all[at - 1], all[at]};
  }

  /// Of each function, at a point of the disk with the vertex in its centre.
  [[nodiscard]] std::vector<Interval> at(Index vertex, const Value& z) const {
    const std::vector<Interval> radial = factors(norm(z));
    std::vector<Interval> sums(count());
    Value power{1, 0};
    for (long m = 0; m <= order; ++m) {
      const Value weight = radial[static_cast<std::size_t>(m)] * power;
      for (std::size_t i = 0; i < sums.size(); ++i) {
        const Value c = coefficient(i, vertex, m);
        sums[i] = sums[i] + c.re * weight.re + c.im * weight.im;
      }
      power = power * z;
    }
    return sums;
  }

  /// A bound for function i.
  [[nodiscard]] Interval total(std::size_t i, Index vertex) const {
    Interval sum;
    for (long m = 0; m <= order; ++m) sum = sum + sqrt(norm(coefficient(i, vertex, m)));
    return sum;
  }

  const Interval lambda;
  const long order;
  const RadialFactors factors;

 private:
  std::vector<std::vector<Interval>> coefficients_;
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

/// Lemma 37.4, J = M: for the differences of the functions of two vertices, both within ε + R of each other.
class Mismatch {
 public:
  Mismatch(const LocalFunctions& functions, const Interval& cosh_sum)
      : functions_(functions),
        cosh_sum_(cosh_sum),
        roots_(roots_of_unity(static_cast<std::size_t>(2 * functions.order))) {}

  /// By function.
  [[nodiscard]] std::vector<Bounds> operator()(Index vertex, const NearLift& near) const {
    const auto& [a, b] = near.motion;
    const Interval cosh = sqrt(norm(a));  // Of half the distance.
    const Value midpoint = (1 / (cosh * (cosh + 1))) * (a * b);
    const Interval s = squared_tanh(cosh_sum_ / (2 * cosh));
    const std::vector<Interval> radial = functions_.factors(s);
    const std::vector<std::vector<Interval>> values = this->values(vertex, near, midpoint, sqrt(s));
    std::vector<Bounds> result;
    for (std::size_t i = 0; i < functions_.count(); ++i)
      result.push_back(bounds(values[i], s, radial, functions_.total(i, vertex) + functions_.total(i, near.vertex)));
    return result;
  }

 private:
  /// Of each function, on the circle around the midpoint.
  [[nodiscard]] std::vector<std::vector<Interval>> values(Index vertex, const NearLift& near, const Value& midpoint,
                                                          const Interval& t) const {
    const Motion back = inverse(near.motion);
    std::vector<std::vector<Interval>> result(functions_.count());
    for (const Value& root : roots_) {
      const Value around = t * root;
      const Value z = quotient(around + midpoint, Value{1, 0} + conjugate(midpoint) * around);
      const std::vector<Interval> there = functions_.at(near.vertex, moved(back, z));
      const std::vector<Interval> here = functions_.at(vertex, z);
      for (std::size_t i = 0; i < result.size(); ++i) result[i].push_back(there[i] - here[i]);
    }
    return result;
  }

  /// In the disk, by the values on the circle. C = `total`.
  [[nodiscard]] Bounds bounds(const std::vector<Interval>& values, const Interval& s,
                              const std::vector<Interval>& radial, const Interval& total) const {
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
    for (long m = 0; m < j; ++m) {
      Value sum{0, 0};
      for (std::size_t k = 0; k < roots_.size(); ++k)
        sum = sum + values[k] * roots_[static_cast<std::size_t>(m) * k % roots_.size()];
      const Interval one = (sqrt(norm(sum)) / (2 * j) + tail) / absolute(radial[static_cast<std::size_t>(m)]);
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

/// Lemma 37.6: q.
Interval least_square(const LocalFunctions& functions, Index vertices, const Interval& sinh_radius) {
  const Interval cosh_radius = sqrt(1 + square(sinh_radius));
  const Interval s = squared_tanh(cosh_radius);
  std::vector<Interval> weights;  // By m.
  for (long m = 0; m <= functions.order; ++m) {
    const Interval decay = exp(-2 * functions.lambda * (cosh_radius - 1) / (m + 1));
    weights.push_back((m == 0 ? 2 : 1) * Interval::pi() * decay * 2 * power(s, static_cast<unsigned long>(m) + 1) /
                      (m + 1));
  }
  const auto product = [&](std::size_t i, std::size_t j) {
    Interval result;
    for (long m = 0; m <= functions.order; ++m) {
      Interval sum;
      for (Index vertex = 0; vertex < vertices; ++vertex) {
        const Value x = functions.coefficient(i, vertex, m);
        const Value y = functions.coefficient(j, vertex, m);
        sum = sum + x.re * y.re + x.im * y.im;
      }
      result = result + weights[static_cast<std::size_t>(m)] * sum;
    }
    return result;
  };
  std::vector<Interval> rows;  // The diagonal of Q, less the other entries.
  for (std::size_t i = 0; i < functions.count(); ++i) {
    rows.push_back(product(i, i));
    for (std::size_t j = 0; j < i; ++j) {
      const Interval other = absolute(product(i, j));
      rows[i] = rows[i] - other;
      rows[j] = rows[j] - other;
    }
  }
  Interval most = -rows[0];
  for (const Interval& row : rows) most = max(most, -row);
  return -most;
}

/// Upper bounds for the sums of |Δψ| and |∇ψ|.
struct Sums {
  double laplacians = 0;
  double gradients = 0;
};

/// Lemma 37.2 for all points within ρ of 0. In binary64; ρ has room for its errors.
Sums partition_sums(const std::vector<std::complex<double>>& lifts, double rho, double beta) {
  double squares = 0;  // Σh² at least, all others at most.
  double slopes = 0;
  double changes = 0;
  double from = 0;
  double to = 0;
  std::complex<double> sum;  // Of h∇C at 0,
  double error = 0;          // and how far it is from there elsewhere.
  for (const std::complex<double>& z : lifts) {
    const double u = std::norm(z) / (1 - std::norm(z));  // sinh²(d/2)
    const std::complex<double> gradient = 2.0 * z / (1 - std::norm(z));
    const double d = 2 * std::asinh(std::sqrt(u));
    const double step = rho * std::sinh(d + rho);
    const double turn = rho * std::cosh(d + rho);
    const double h_most = 1 - (2 * u - step) / beta;
    if (h_most <= 0) continue;
    const double h_least = std::max(0.0, 1 - (2 * u + step) / beta);
    const double h = std::max(0.0, 1 - 2 * u / beta);
    const double steep = std::abs(gradient) + turn;
    const double flat = std::max(0.0, std::abs(gradient) - turn);
    squares += h_least * h_least;
    slopes += 2 * h_most * steep / beta;
    sum += h * gradient;
    error += (h_most - h_least) * steep + h * turn;
    double low = 2 * flat * flat / (beta * beta) - 4 * h_most * std::cosh(d + rho) / beta;
    double high = 2 * steep * steep / (beta * beta) - 4 * h_least * std::max(1.0, 1 + 2 * u - step) / beta;
    if (h_least == 0) {
      low = std::min(0.0, low);
      high = std::max(0.0, high);
    }
    changes += std::max(-low, high);
    from += low;
    to += high;
  }
  if (squares <= 0) give_up("vertices do not cover a disk");
  const double slope = 2 * (std::abs(sum) + error) / beta;
  return {
      (changes + std::max(std::abs(from), std::abs(to))) / squares + 2 * slope * (slopes + slope) / (squares * squares),
      (slopes + slope) / squares};
}

/// The greatest in the disk of radius ε around a vertex, from squares that cover it.
Sums partition_bounds(const std::vector<NearLift>& near, double epsilon, double radius) {
  constexpr int kSquares = 20;  // Beside each other, from the vertex to the circle.
  const auto number = [](const Interval& x) {
    if (!(x.upper() - x.lower() < 1e-13)) give_up("lifts are not known well enough");
    return (x.lower() + x.upper()) / 2;
  };
  std::vector<std::complex<double>> lifts{0};
  for (const NearLift& lift : near) {
    const Value place = quotient(lift.motion.b, conjugate(lift.motion.a));
    lifts.emplace_back(number(place.re), number(place.im));
  }
  const double edge = std::tanh(epsilon / 2);
  const double side = edge / kSquares;
  // A point of a square is that far from its centre; and what is rounded is nearer than the rest.
  const double rho = std::sqrt(2.0) * side / (1 - std::pow(edge + side, 2)) * (1 + 1e-6) + 1e-9;
  const double beta = 2 * std::pow(std::sinh(radius / 2), 2);
  Sums greatest;
  for (int i = -kSquares - 1; i <= kSquares + 1; ++i) {
    for (int j = -kSquares - 1; j <= kSquares + 1; ++j) {
      const std::complex<double> centre(i * side, j * side);
      if (std::abs(centre) > edge + side) continue;
      std::vector<std::complex<double>> seen;
      seen.reserve(lifts.size());
      for (const std::complex<double>& z : lifts) seen.push_back((z - centre) / (1.0 - std::conj(centre) * z));
      const Sums sums = partition_sums(seen, rho, beta);
      greatest = {std::max(greatest.laplacians, sums.laplacians), std::max(greatest.gradients, sums.gradients)};
    }
  }
  return {greatest.laplacians * (1 + 1e-6), greatest.gradients * (1 + 1e-6)};
}

/// Of a function on the surface that is at most the k-th value in a region around vertex k of at most a disk's area.
Interval greatest_integral(std::vector<Interval> values, const Interval& disk, const Interval& area) {
  if (!std::all_of(values.begin(), values.end(), [](const Interval& value) { return value.is_bounded(); }))
    give_up("a bound is not known");
  std::sort(values.begin(), values.end(), Interval::has_greater_upper_end);
  Interval sum;
  Interval left = area;
  for (const Interval& value : values) {
    if (is_less(left, disk) == Answer::yes) return sum + left * value;
    sum = sum + disk * value;
    left = left - disk;
  }
  return sum;
}

}  // namespace

std::size_t values_needed(const Row& row, const NearLifts& near) {
  std::size_t pairs = 0;
  for (Index vertex = 0; vertex < near.size(); ++vertex) {
    for (const NearLift& other : near[vertex]) pairs += other.vertex < vertex ? 0 : 1;
  }
  const std::size_t count = row.functions.size();
  const std::size_t coefficients = row.functions[0].size();
  return count * (pairs * 2 * (coefficients / near.size() - 1) + count * coefficients / 16);
}

Interval eigenvalue_error(const Row& row, const mpq_class& epsilon, const NearLifts& near, long minus_euler) {
  const LocalFunctions functions(row, near.size());
  const Interval cosh_epsilon = cosh(Interval(epsilon));
  const Interval cosh_radius = cosh(Interval(row.radius));
  const Mismatch mismatch(functions, cosh_epsilon + cosh_radius);
  std::vector<std::vector<Bounds>> greatest(functions.count(), std::vector<Bounds>(near.size()));
  // −sinh η of Lemma 37.5.
  Interval least = max(-sinh(Interval(epsilon)), -1 / sqrt(functions.lambda));
  for (Index vertex = 0; vertex < near.size(); ++vertex) {
    for (const NearLift& other : near[vertex]) {
      least = max(least, -sqrt(norm(other.motion.b)));
      if (other.vertex < vertex) continue;
      const std::vector<Bounds> bounds = mismatch(vertex, other);
      for (std::size_t i = 0; i < bounds.size(); ++i) {
        greatest[i][vertex].include(bounds[i]);
        greatest[i][other.vertex].include(bounds[i]);
      }
    }
  }
  std::vector<Sums> partition;
  partition.reserve(near.size());
  for (const auto& lifts : near)
    partition.push_back(partition_bounds(lifts, Interval(epsilon).upper(), Interval(row.radius).lower()));
  // By vertex, of the bounds of all functions, the sums of squares.
  std::vector<Interval> errors(near.size());
  std::vector<Interval> residuals(near.size());
  for (const std::vector<Bounds>& function : greatest) {
    for (std::size_t k = 0; k < near.size(); ++k) {
      const Interval laplacians = Interval(mpq_class(partition[k].laplacians));
      const Interval gradients = Interval(mpq_class(partition[k].gradients));
      const auto& [value, gradient] = function[k];
      errors[k] = errors[k] + square(value);
      residuals[k] = residuals[k] + square(value * laplacians + 2 * gradient * gradients);
    }
  }
  const Interval area = 2 * minus_euler * Interval::pi();
  const Interval disk = 2 * Interval::pi() * (cosh_epsilon - 1);
  const Interval norm = sqrt(least_square(functions, static_cast<Index>(near.size()), -least)) -
                        sqrt(greatest_integral(std::move(errors), disk, area));
  if (is_less(0, norm) != Answer::yes) give_up("a sum of functions may be 0");
  return sqrt(greatest_integral(std::move(residuals), disk, area)) / norm;
}

}  // namespace epsnet::exact
