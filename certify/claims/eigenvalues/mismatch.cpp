#include "certify/claims/eigenvalues/mismatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/numbers/budget.h"
#include "certify/numbers/rounding.h"

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

}  // namespace epsnet::certify
