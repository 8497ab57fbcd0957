#include <cmath>
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "certify/claims/geodesics/crossing_search.h"

/// The numbers must enclose what they say, exactly; inputs cancel, and are of all sizes.
namespace epsnet::certify::double_double_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

mpq_class middle(const DoubleDouble& x) { return mpq_class(x.high) + mpq_class(x.low); }

bool contains(const DoubleDouble& x, const mpq_class& value) {
  return abs(mpq_class(value - middle(x))) <= mpq_class(x.radius);
}

class Random {
 public:
  double number() {
    const double x = std::ldexp(static_cast<double>(bits_()) / 0x1p63 - 1, static_cast<int>(bits_() % 61) - 30);
    return bits_() % 8 == 0 ? std::ldexp(std::round(x), static_cast<int>(bits_() % 9)) : x;
  }
  DoubleDouble inexact() {
    const double high = number();
    const double low = std::ldexp(high, -54 - static_cast<int>(bits_() % 8)) * unit();
    return {high, low, bits_() % 3 == 0 ? 0 : std::fabs(std::ldexp(high, -static_cast<int>(bits_() % 120)))};
  }
  /// A number of which x is one enclosure.
  mpq_class in(const DoubleDouble& x) { return middle(x) + mpq_class(x.radius) * mpq_class(unit()); }
  /// From −1 to 1, and these often.
  double unit() { return bits_() % 4 == 0 ? (bits_() % 2 == 0 ? 1 : -1) : static_cast<double>(bits_()) / 0x1p63 - 1; }

 private:
  std::mt19937_64 bits_{1};
};

TEST(DoubleDouble, SumsOfProductsAreEnclosed) {
  Random random;
  int accurate = 0;
  for (int i = 0; i < 200'000; ++i) {
    std::array<DoubleDouble, 3> x;
    std::array<DoubleDouble, 3> y;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = random.inexact();
      y[k] = random.inexact();
    }
    // The third product is nearly what the first two need to cancel.
    if (i % 2 == 0 && y[2].high != 0) {
      const mpq_class wanted = -(middle(x[0]) * middle(y[0]) + middle(x[1]) * middle(y[1])) / middle(y[2]);
      x[2].high = wanted.get_d();
      x[2].low = mpq_class(wanted - mpq_class(x[2].high)).get_d();
      x[2].radius = 0;
      if (std::fabs(x[2].low) > std::ldexp(std::fabs(x[2].high), -53)) continue;
    }
    mpq_class exact = 0;
    for (std::size_t k = 0; k < 3; ++k) exact += random.in(x[k]) * random.in(y[k]);
    const DoubleDouble sum = sum_of_products(x, y);
    ASSERT_TRUE(contains(sum, exact)) << i;
    ASSERT_LE(std::fabs(sum.low), std::ldexp(std::fabs(sum.high), -53)) << i;
    accurate += sum.radius < std::ldexp(std::fabs(sum.high), -90) ? 1 : 0;
    if (const int sign = certain_sign(sum); sign != 0) {
      ASSERT_EQ(sign, sgn(exact)) << i;
    }
    const Interval around = fast_interval(sum);
    ASSERT_LE(mpq_class(around.lower), exact) << i;
    ASSERT_GE(mpq_class(around.upper), exact) << i;
  }
  EXPECT_GT(accurate, 1000);
}

TEST(DoubleDouble, WhatUnderflowsIsWithinTheRadius) {
  for (const double tiny : {0x1p-1074, 0x1p-1030, 0x1.8p-540, 0x1.5555555555555p-520}) {
    const std::array<DoubleDouble, 2> x{DoubleDouble{tiny, 0, 0}, {1 / 3.0, 0, 0}};
    const DoubleDouble sum = sum_of_products(x, x);
    EXPECT_TRUE(contains(sum, mpq_class(tiny) * mpq_class(tiny) + mpq_class(1 / 3.0) * mpq_class(1 / 3.0)));
    const std::array<DoubleDouble, 1> alone{x[0]};
    EXPECT_TRUE(contains(sum_of_products(alone, alone), mpq_class(tiny) * mpq_class(tiny)));
  }
}

TEST(DoubleDouble, NothingIsSaidOfWhatOverflows) {
  const DoubleDouble huge{0x1p1000, 0, 0};
  const DoubleDouble unknown{1, 0, kInfinity};
  const std::array<std::array<DoubleDouble, 2>, 3> cases{{{huge, huge}, {huge, -huge}, {unknown, huge}}};
  for (const auto& x : cases) {
    const DoubleDouble sum = sum_of_products(x, x);
    EXPECT_FALSE(is_finite(sum));
    EXPECT_EQ(certain_sign(sum), 0);
  }
  EXPECT_EQ(certain_sign({std::numeric_limits<double>::quiet_NaN(), 0, 0}), 0);
  EXPECT_EQ(certain_sign({kInfinity, 0, kInfinity}), 0);
}

TEST(DoubleDouble, SignsAreCertainOnlyBeyondTheRadius) {
  EXPECT_EQ(certain_sign({1, 0, 0.25}), 1);
  EXPECT_EQ(certain_sign({-1, 0, 0.25}), -1);
  EXPECT_EQ(certain_sign({1, 0, 1}), 0);
  EXPECT_EQ(certain_sign({1, 0, 2}), 0);
  EXPECT_EQ(certain_sign({0, 0, 0}), 0);
}

TEST(DoubleDouble, BallsAreEnclosed) {
  const Precision scope(300);
  const Ball third = 1 / Ball::exactly(3);
  for (const slong bits : {20, 53, 64, 106, 128, 300}) {
    Ball x;
    arb_set_round(x.get(), third.get(), bits);
    const DoubleDouble y = to_double_double(x);
    EXPECT_TRUE(contains(y, mpq_class(1, 3))) << bits;
    EXPECT_LE(y.radius, std::max(std::ldexp(1.0, -static_cast<int>(bits) + 1), 0x1p-104)) << bits;
    EXPECT_GT(y.radius, 0) << bits;
  }
  const DoubleDouble exact = to_double_double(Ball::exactly(0.1));
  EXPECT_EQ(middle(exact), mpq_class(0.1));
  EXPECT_LE(exact.radius, 0x1p-1000);
  Ball infinite;
  arb_zero_pm_inf(infinite.get());
  Ball nan;
  arb_indeterminate(nan.get());
  Ball huge;
  arb_set_ui(huge.get(), 1);
  arb_mul_2exp_si(huge.get(), huge.get(), 5000);
  for (const Ball& x : {infinite, nan, huge}) EXPECT_FALSE(is_finite(to_double_double(x)));
}

}  // namespace
}  // namespace epsnet::certify::double_double_test
