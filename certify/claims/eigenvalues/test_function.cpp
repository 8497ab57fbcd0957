#include "certify/claims/eigenvalues/test_function.h"

#include <utility>
#include <vector>

#include "certify/base/text.h"

namespace epsnet::certify {
namespace {

/// cos(δr) and sinc(δr/2) for λ = ¼ + r². Both decrease in λ as long as δr ≤ π.
std::pair<Ball, Ball> cosine_and_sinc(const Ball& step, double lambda) {
  const Ball square = Ball::exactly(lambda) - scaled(Ball::exactly(1), -2);
  if (certain_sign(square) < 0) {
    const Ball x = step * sqrt(-square);
    return {cosh(x), sinh(half(x)) / half(x)};
  }
  const Ball x = step * sqrt_of_nonnegative(square);
  return {ball_of(arb_cos, x), ball_of(arb_sinc, half(x))};
}

Ball hull(const Ball& x, const Ball& y) { return ball_of(arb_union, x, y); }

}  // namespace

mpq_class greatest_eigenvalue(const TestFunctions& functions) {
  return mpq_class(1, 4) + 9 / (functions.step() * functions.step());
}

TestFunctions test_functions(const EigenvaluesDocument& document) {
  return {decimal(document.up_to), document.order, document.degree};
}

SquaredTestFunction::SquaredTestFunction(const TestFunctions& functions, std::span<const double> coefficients)
    : step_(Ball::rounded(functions.step())), order_(functions.order) {
  for (const double c : coefficients) coefficients_.push_back(Ball::exactly(c));
}

Ball SquaredTestFunction::on(Interval lambda) const {
  const auto [cosine, sinc] = cosine_and_sinc(step_, lambda.lower);
  const auto [other_cosine, other_sinc] = cosine_and_sinc(step_, lambda.upper);
  const Ball x = hull(cosine, other_cosine);
  Ball middle;
  arb_get_mid_arb(middle.get(), x.get());
  // Clenshaw's algorithm for Σ c_k T_k(middle + y): polynomials of y, exact but for rounding.
  const std::size_t size = coefficients_.size();
  std::vector<Ball> next(size + 1);
  std::vector<Ball> after(size + 1);
  for (std::size_t k = size; k-- > 0;) {
    const bool last = k == 0;
    std::vector<Ball> current(size + 1);
    for (std::size_t i = 0; i + k < size; ++i) {
      const Ball product = i == 0 ? middle * next[0] : middle * next[i] + next[i - 1];
      current[i] = (last ? product : twice(product)) - after[i];
    }
    current[0] += coefficients_[k];
    after = std::exchange(next, std::move(current));
  }
  const Ball y = x - middle;
  Ball sum;
  for (std::size_t i = size; i-- > 0;) sum = sum * y + next[i];
  Ball power;
  arb_pow_ui(power.get(), hull(sinc, other_sinc).get(), order_, Precision::bits());
  return power * sqr(sum);
}

Tri is_positive_on(Interval interval, const std::function<Ball(Interval)>& enclose) {
  constexpr int kMostParts = 4000;
  std::vector<Interval> open{interval};
  for (int parts = 0; !open.empty(); ++parts) {
    if (parts == kMostParts) return Tri::unknown;
    const auto [lower, upper] = open.back();
    open.pop_back();
    if (certainly_positive(enclose({lower, upper})) == Tri::yes) continue;
    const double middle = lower + (upper - lower) / 2;
    for (const double point : {lower, middle, upper}) {
      if (certainly_positive(enclose({point, point})) == Tri::no) return Tri::no;
    }
    if (middle == lower || middle == upper) return Tri::unknown;
    open.push_back({middle, upper});
    open.push_back({lower, middle});
  }
  return Tri::yes;
}

}  // namespace epsnet::certify
