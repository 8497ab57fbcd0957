#include "certify/claims/eigenvalues/eigenfunction.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "certify/claims/eigenvalues/local_functions.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify {
DiskWaves::DiskWaves(const Ball& lambda, const Ball& s, const std::vector<double>& least_factors,
                     const std::vector<double>& roots)
    : roots_(roots) {
  const std::size_t end = least_factors.size();
  const Ball one = Ball::exactly(1);
  const Ball t = sqrt(s);
  const Ball sinh_wider = (end + one) * rsqrt(lambda);
  const Ball cosh_wider = sqrt(1 + sqr(sinh_wider));
  const Ball q = t * (1 + cosh_wider) / sinh_wider;
  const Tri small = certainly_less(q, one);
  if (small != Tri::yes) {
    tail_ = small == Tri::no ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    return;
  }
  const Ball growth = exp(lambda * (cosh_wider - 1) / (end + 1));
  tail_ = upper_end(twice(growth * power(q, end)) / (1 - q));
  beyond_ = {1, upper_end((end + q / (1 - q)) / t + lambda * t)};
  const double inverse_t = upper_end(1 / t);
  const double slope = upper_end(lambda * t);
  for (std::size_t m = 0; m < end; ++m) {
    const double value = least_factors[m] > 0 ? kRoom / least_factors[m] : std::numeric_limits<double>::infinity();
    const double gradient = value * (static_cast<double>(m) * inverse_t + slope) * kRoom;
    const double times = m == 0 ? 1 : 2;
    weights_.push_back({times * value, times * gradient});
    all_.value += times * value;
    all_.gradient += times * gradient;
    root_.value += times * square(value);
    root_.gradient += times * square(gradient);
  }
  root_ = {std::sqrt(root_.value), std::sqrt(root_.gradient)};
}

FunctionBounds DiskWaves::bounds(const std::vector<double>& values, double error, double total) const {
  if (!std::isfinite(tail_)) return {tail_, tail_};
  const std::size_t n = values.size();
  const double tail = total * tail_;
  double greatest = 0;
  for (const double value : values) greatest = std::max(greatest, std::abs(value));
  // Of each sum over the points, divided by n: of roots of unity, products and additions.
  const double rounding = greatest * static_cast<double>(n + 8) * 0x1p-52;
  const auto bound = [&](double FunctionBounds::*part) {
    return beyond_.*part * tail + all_.*part * (tail + rounding) + root_.*part * error;
  };
  FunctionBounds result{bound(&FunctionBounds::value), bound(&FunctionBounds::gradient)};
  for (std::size_t m = 0; m < weights_.size(); ++m) {
    double real = 0;
    double imaginary = 0;
    for (std::size_t k = 0, at = 0; k < n; ++k) {
      real += values[k] * roots_[2 * at];
      imaginary += values[k] * roots_[2 * at + 1];
      at += m;
      if (at >= n) at -= n;
    }
    const double size = std::sqrt(square(real) + square(imaginary)) / static_cast<double>(n);
    result.value += weights_[m].value * size;
    result.gradient += weights_[m].gradient * size;
  }
  return {result.value * kRoom, result.gradient * kRoom};
}

std::vector<FunctionBounds> Mismatch::operator()(const Overlaps::Pair& pair, const std::vector<double>& totals) const {
  const std::vector<std::vector<double>> differences = this->differences(pair);
  const DiskWaves waves(lambda_, pair.s, least_factors(pair), overlaps_.roots_of_unity(pair.waves));
  std::vector<FunctionBounds> result;
  for (std::size_t j = 0; j < differences.size(); ++j) {
    const double error = (values_.error(j, pair.vertex) + values_.error(j, pair.other)) * kRoom;
    result.push_back(waves.bounds(differences[j], error, totals[j]));
  }
  return result;
}

std::uint64_t Mismatch::work(const Overlaps::Pair& pair) const {
  const std::uint64_t n = 2 * std::uint64_t{pair.waves};
  return 20 * ball_work(static_cast<std::uint64_t>(Precision::bits())) +
         2 * n * (values_.factors().work() + values_.work()) + values_.count() * n * (n + 20);
}

/// By function and point.
std::vector<std::vector<double>> Mismatch::differences(const Overlaps::Pair& pair) const {
  std::vector<std::vector<double>> result(values_.count());
  std::vector<std::int64_t> factors;
  std::vector<std::int64_t> own;
  std::vector<std::int64_t> other;
  for (const Overlaps::Point& point : overlaps_.points(pair)) {
    values_.factors().set(point.own, factors);
    values_.set(pair.vertex, point.own, factors, own);
    values_.factors().set(point.other, factors);
    values_.set(pair.other, point.other, factors, other);
    for (std::size_t j = 0; j < result.size(); ++j)
      result[j].push_back(values_.unit(j) * static_cast<double>(other[j] - own[j]));
  }
  return result;
}

/// By m < J, at the boundary of the disk.
std::vector<double> Mismatch::least_factors(const Overlaps::Pair& pair) const {
  constexpr double kUnit = 0x1p-61;
  std::vector<std::int64_t> factors;
  values_.factors().set(pair.edge, factors);
  std::vector<double> result;
  for (std::uint32_t m = 0; m < pair.waves; ++m)
    result.push_back(kUnit * (static_cast<double>(factors[m]) / kRoom - values_.factors().errors()[m] * kRoom));
  return result;
}

namespace {

/// The coefficients of a row, each function of all vertices.
class Coefficients {
 public:
  Coefficients(const EigenvaluesDocument::Eigenfunctions& row, std::size_t vertices)
      : functions_(row.functions), vertices_(vertices), each_(row.functions.front().size() / vertices) {}

  [[nodiscard]] std::size_t count() const { return functions_.size(); }
  [[nodiscard]] std::size_t vertices() const { return vertices_; }
  [[nodiscard]] std::uint32_t order() const { return static_cast<std::uint32_t>(each_ / 2); }

  /// α_m and β_m.
  [[nodiscard]] std::pair<Ball, Ball> operator()(std::size_t function, std::size_t vertex, std::uint32_t m) const {
    const double* own = functions_[function].data() + vertex * each_;
    if (m == 0) return {Ball::exactly(own[0]), Ball()};
    return {Ball::exactly(own[std::size_t{2} * m - 1]), Ball::exactly(own[std::size_t{2} * m])};
  }

  /// A bound for a function around a vertex.
  [[nodiscard]] double total(std::size_t function, std::size_t vertex) const {
    Ball sum;
    for (std::uint32_t m = 0; m <= order(); ++m) {
      const auto [alpha, beta] = (*this)(function, vertex, m);
      sum += sqrt_of_nonnegative(sqr(alpha) + sqr(beta));
    }
    return upper_end(sum);
  }

 private:
  const std::vector<EigenvaluesDocument::Coefficients>& functions_;
  std::size_t vertices_;
  std::size_t each_;
};

/// q of Lemma 37.6: a lower bound for what functions have on the disks of this radius around all vertices.
Ball norms_squared(const Coefficients& coefficients, const Ball& lambda, const Ball& sinh_radius) {
  const Ball cosh_radius = sqrt(1 + sqr(sinh_radius));
  const Ball s = (cosh_radius - 1) / (cosh_radius + 1);
  const std::size_t count = coefficients.count();
  std::vector<std::vector<Ball>> gram(count, std::vector<Ball>(count));
  for (std::uint32_t m = 0; m <= coefficients.order(); ++m) {
    const Ball decay = exp(-twice(lambda * (cosh_radius - 1) / (m + 1)));
    const Ball weight = (m == 0 ? 2 : 1) * pi() * decay * twice(power(s, std::uint64_t{m} + 1)) / (m + 1);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        Ball products;
        for (std::size_t vertex = 0; vertex < coefficients.vertices(); ++vertex) {
          const auto [alpha, beta] = coefficients(i, vertex, m);
          const auto [other_alpha, other_beta] = coefficients(j, vertex, m);
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

/// With all functions multiplied by a power of 2, so that the greatest coefficient is about 1. Functions prove what
/// they prove, also where the least coefficients are rounded. One power for all: sizes of functions beside each other
/// are in Lemma 37.6.
EigenvaluesDocument::Eigenfunctions normalized(EigenvaluesDocument::Eigenfunctions row) {
  double greatest = 0;
  for (const EigenvaluesDocument::Coefficients& function : row.functions) {
    for (const double x : function) greatest = std::max(greatest, std::abs(x));
  }
  const int exponent = std::ilogb(greatest);
  for (EigenvaluesDocument::Coefficients& function : row.functions) {
    for (double& x : function) x = std::ldexp(x, -exponent);
  }
  return row;
}

}  // namespace

double greatest_integral(std::vector<double> values, double disk, double area) {
  std::sort(values.begin(), values.end(), std::greater<>());
  double result = 0;
  // Wrong by roundings of the area, for the least of the values that count: kRoom is more than these as well.
  double left = area;
  for (const double value : values) {
    const double part = std::min(disk, left);
    result += part * value;
    left -= part;
  }
  return result * kRoom;
}

std::optional<double> eigenvalue_error(const Overlaps& overlaps, const EigenvaluesDocument::Eigenfunctions& given,
                                       std::uint64_t genus, const Budget& budget, unsigned threads) {
  const EigenvaluesDocument::Eigenfunctions row = normalized(given);
  const std::size_t vertices = overlaps.partition().size();
  const Ball lambda = Ball::exactly(row.lambda);
  const Coefficients coefficients(row, vertices);
  const std::size_t count = coefficients.count();
  const std::uint64_t work = ball_work(static_cast<std::uint64_t>(Precision::bits()));
  const std::uint64_t numbers = vertices * (coefficients.order() + std::uint64_t{1});
  budget.spend(memory_work(16) + (20 + 6 * count) * work, count * numbers);
  const auto values = LocalValues::make(row, vertices, overlaps.greatest());
  if (!values) return std::nullopt;
  std::vector<std::vector<double>> totals(count, std::vector<double>(vertices));
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) totals[j][vertex] = coefficients.total(j, vertex);
  }

  const Mismatch mismatch(overlaps, *values, lambda);
  const std::vector<Overlaps::Pair>& pairs = overlaps.pairs();
  for (const Overlaps::Pair& pair : pairs) budget.spend(mismatch.work(pair) + memory_work(50) * count);
  std::vector<std::vector<FunctionBounds>> of_pair(pairs.size());
  for_each_parallel(pairs.size(), threads, [&](unsigned, std::size_t i) {
    std::vector<double> both;
    both.reserve(count);
    for (const std::vector<double>& total : totals) both.push_back(total[pairs[i].vertex] + total[pairs[i].other]);
    of_pair[i] = mismatch(pairs[i], both);
  });

  // By vertex, of the squares of all functions' bounds.
  std::vector<double> residuals(vertices);
  std::vector<double> errors(vertices);
  for (std::size_t j = 0; j < count; ++j) {
    std::vector<FunctionBounds> greatest(vertices);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const FunctionBounds& bounds = of_pair[i][j];
      if (std::isinf(bounds.value)) return std::numeric_limits<double>::infinity();
      if (!std::isfinite(bounds.value) || !std::isfinite(bounds.gradient)) return std::nullopt;
      for (const std::uint32_t vertex : {pairs[i].vertex, pairs[i].other}) {
        greatest[vertex].value = std::max(greatest[vertex].value, bounds.value);
        greatest[vertex].gradient = std::max(greatest[vertex].gradient, bounds.gradient);
      }
    }
    for (std::size_t k = 0; k < vertices; ++k) {
      const PartitionBounds& partition = overlaps.partition()[k];
      residuals[k] += square(greatest[k].value * partition.laplacians + 2 * greatest[k].gradient * partition.gradients);
      errors[k] += square(greatest[k].value);
    }
  }
  const double area = upper_end(4 * (genus - 1) * pi());
  const Ball norms = norms_squared(coefficients, lambda, min(overlaps.sinh_disk(), rsqrt(lambda)));
  const Ball norm = sqrt_of_nonnegative(norms) -
                    sqrt(Ball::exactly(greatest_integral(std::move(errors), overlaps.disk_area(), area)));
  if (certainly_positive(norm) == Tri::no) return std::numeric_limits<double>::infinity();
  const double bound =
      upper_end(sqrt(Ball::exactly(greatest_integral(std::move(residuals), overlaps.disk_area(), area))) / norm);
  return certainly_positive(norm) == Tri::yes && std::isfinite(bound) ? std::optional(bound) : std::nullopt;
}

}  // namespace epsnet::certify
