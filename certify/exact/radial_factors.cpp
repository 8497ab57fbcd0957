#include "certify/exact/radial_factors.h"

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

}  // namespace epsnet::exact
