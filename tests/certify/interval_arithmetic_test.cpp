#include "certify/numbers/interval_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

/// An interval contains, strictly inside, the value of each operation at all ends of its arguments.
namespace epsnet::certify::interval_arithmetic_test {
namespace {

/// Of all signs, with 0 as an end and inside.
std::vector<Interval> intervals() {
  const std::vector<double> ends{-7.3, -1.1, -1e-9, 0, 0.1, 3.7, 1e5};
  std::vector<Interval> result;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t k = i; k < ends.size(); ++k) result.push_back({ends[i], ends[k]});
  }
  return result;
}

void expect_inside(const mpq_class& value, Interval x) {
  EXPECT_LT(mpq_class(x.lower), value);
  EXPECT_LT(value, mpq_class(x.upper));
}

/// And hardly more: some units in the last place beyond the least and the greatest value.
void expect_hull(const std::vector<mpq_class>& values, Interval x) {
  for (const mpq_class& value : values) expect_inside(value, x);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  EXPECT_NEAR(least->get_d(), x.lower, 1e-15 * (1e-300 + std::fabs(x.lower)));
  EXPECT_NEAR(most->get_d(), x.upper, 1e-15 * (1e-300 + std::fabs(x.upper)));
}

TEST(IntervalArithmetic, ContainsTheExactValuesAtTheEndsAndHardlyMore) {
  for (const Interval x : intervals()) {
    for (const Interval y : intervals()) {
      std::vector<mpq_class> sums, differences, products, quotients;
      for (const mpq_class& a : {mpq_class(x.lower), mpq_class(x.upper)}) {
        for (const mpq_class& b : {mpq_class(y.lower), mpq_class(y.upper)}) {
          sums.emplace_back(a + b);
          differences.emplace_back(a - b);
          products.emplace_back(a * b);
          if (y.lower > 0) quotients.emplace_back(a / b);
        }
      }
      expect_hull(sums, x + y);
      expect_hull(differences, x - y);
      expect_hull(products, x * y);
      if (y.lower > 0) {
        expect_hull(quotients, x / y);
      } else {
        EXPECT_FALSE(is_finite(x / y));
      }
    }
    const mpq_class a(x.lower);
    const mpq_class b(x.upper);
    EXPECT_LE(sqr(x).lower, 0 < a || b < 0 ? std::min<mpq_class>(a * a, b * b).get_d() : 0);
    EXPECT_GE(sqr(x).lower, 0);
    EXPECT_LT(std::max<mpq_class>(a * a, b * b), mpq_class(sqr(x).upper));
    expect_inside(3 * b, 3 * x);
    expect_inside(3 + a, 3 + x);
  }
}

TEST(IntervalArithmetic, RootsContainTheRootsOfBothEnds) {
  for (const Interval x : intervals()) {
    if (x.lower < 0) {
      EXPECT_FALSE(is_finite(sqrt(x)));
      continue;
    }
    const mpq_class lower(sqrt(x).lower);
    const mpq_class upper(sqrt(x).upper);
    EXPECT_TRUE(lower < 0 || lower * lower < mpq_class(x.lower));
    EXPECT_LT(mpq_class(x.upper), upper * upper);
  }
}

TEST(IntervalArithmetic, AnArctangentContainsThoseOfBothEnds) {
  const Precision scope(128);
  for (const Interval x : intervals()) {
    EXPECT_NE(certainly_less(atan(Ball::exactly(x.lower)), Ball::exactly(atan(x).lower)), Tri::yes);
    EXPECT_NE(certainly_less(Ball::exactly(atan(x).upper), atan(Ball::exactly(x.upper))), Tri::yes);
    EXPECT_LE(atan(x).upper - atan(x).lower, x.upper - x.lower + 1e-15);
  }
}

TEST(IntervalArithmetic, ComparisonsAreCertain) {
  EXPECT_EQ(certainly_less(Interval{1, 2}, Interval{3, 4}), Tri::yes);
  EXPECT_EQ(certainly_less(Interval{1, 3}, Interval{3, 4}), Tri::unknown);
  EXPECT_EQ(certainly_less(Interval{1, 3}, Interval{2, 4}), Tri::unknown);
  EXPECT_EQ(certainly_less(Interval{3, 4}, Interval{2, 3}), Tri::no);
  EXPECT_EQ(certainly_less(Interval{3, 4}, Interval{2, 3.5}), Tri::unknown);
  EXPECT_EQ(certainly_positive(Interval{1e-300, 1}), Tri::yes);
  EXPECT_EQ(certainly_positive(Interval{0, 1}), Tri::unknown);
  EXPECT_EQ(certainly_positive(Interval{-1, 0}), Tri::no);
  EXPECT_EQ(certainly_positive(Interval{-1, 1}), Tri::unknown);
}

/// An end that is infinite or not a number says nothing: whatever is computed with it is everything, or has such an
/// end.
TEST(IntervalArithmetic, OfAnEndThatIsNotFiniteNothingFollows) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto is_everything = [&](Interval x) { return x.lower == -infinity && x.upper == infinity; };
  for (const Interval x : {Interval{-infinity, 1}, Interval{1, infinity}, Interval{-infinity, infinity},
                           Interval{nan, 1}, Interval{1, nan}, Interval{nan, nan}}) {
    EXPECT_FALSE(is_finite(x));
    for (const Interval y : intervals()) {
      EXPECT_TRUE(is_everything(x * y) && is_everything(y * x));
      EXPECT_TRUE(is_everything(x / y) && is_everything(y / x));
      EXPECT_FALSE(is_finite(x + y) || is_finite(y - x));
    }
    EXPECT_TRUE(is_everything(sqr(x)) && is_everything(sqrt(x)) && is_everything(atan(x)));
  }
  // A quotient and a root that may not be there.
  EXPECT_TRUE(is_everything(Interval{1, 2} / Interval{0, 1}));
  EXPECT_TRUE(is_everything(Interval{0, 0} / Interval{-1, 1}));
  EXPECT_TRUE(is_everything(sqrt(Interval{-1e-300, 1})));
}

/// Neither an overflow nor what is not a number says anything.
TEST(IntervalArithmetic, WhatIsNotFiniteSaysNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Interval huge{1e300, 1e301};
  for (const Interval x :
       {huge * huge, -huge * huge, sqr(huge), everything(), Interval{nan, nan}, Interval{nan, 1} * huge,
        huge / Interval{0, 1}, everything() - everything(), sqrt(everything())}) {
    EXPECT_FALSE(is_finite(x));
    EXPECT_FALSE(is_finite(x * huge) || is_finite(x / huge) || is_finite(sqr(x)) || is_finite(sqrt(x)) ||
                 is_finite(atan(x)));
  }
  EXPECT_EQ(certainly_less(Interval{nan, nan}, huge), Tri::unknown);
  EXPECT_EQ(certainly_less(huge, Interval{nan, nan}), Tri::unknown);
  EXPECT_EQ(certainly_less(huge, huge * huge), Tri::unknown);
  EXPECT_EQ(certainly_positive(everything()), Tri::unknown);
  EXPECT_EQ(certainly_positive(Interval{nan, nan}), Tri::unknown);
}

}  // namespace
}  // namespace epsnet::certify::interval_arithmetic_test
