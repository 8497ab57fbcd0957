#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <utility>

#include "tests/support/triangulations.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet::threshold_test {
namespace {

Mp4096 power_of_two(int exponent) { return boost::multiprecision::ldexp(Mp4096(1), exponent); }

/// sinh²x to about 4090 bits.
Mp4096 sinh2(const Rational& x) {
  using boost::multiprecision::sinh;
  const Mp4096 root = sinh(Mp4096(x));
  return root * root;
}

/// Both ends are `value` rounded once, down and up: neighbours, `value` between them.
template <class T>
void expect_tight(const Threshold& threshold, const Mp4096& value, const Rational& x) {
  const auto& [low, high] = threshold.at<T>();
  EXPECT_LE(Mp4096(low), value) << x;
  EXPECT_GE(Mp4096(high), value) << x;
  EXPECT_LE((Mp4096(high) - Mp4096(low)) / value, power_of_two(1 - kMantissaBits<T>)) << x;
}

void expect_enclosure(const Rational& x) {
  const Threshold threshold(x);
  const Mp4096 value = sinh2(x);
  expect_tight<double>(threshold, value, x);
  expect_tight<Mp256>(threshold, value, x);
  expect_tight<Mp1024>(threshold, value, x);
  EXPECT_EQ(threshold.low(), threshold.at<double>()[0]);
  EXPECT_EQ(threshold.high(), threshold.at<double>()[1]);
  // At the last stage the value here is no better than the ends themselves.
  const auto& [low, high] = threshold.at<Mp4096>();
  EXPECT_LE(low, high) << x;
  EXPECT_LE(abs(Mp4096(low - value)), value * power_of_two(-4080)) << x;
  EXPECT_LE(abs(Mp4096(high - value)), value * power_of_two(-4080)) << x;
  // Every stage lies inside of the one before.
  EXPECT_LE(Mp4096(threshold.low()), low) << x;
  EXPECT_GE(Mp4096(threshold.high()), high) << x;
  EXPECT_LE(Mp4096(threshold.at<Mp256>()[0]), Mp4096(threshold.at<Mp1024>()[0])) << x;
  EXPECT_GE(Mp4096(threshold.at<Mp256>()[1]), Mp4096(threshold.at<Mp1024>()[1])) << x;
}

TEST(Threshold, EnclosesTheSquareOfTheHyperbolicSineTightly) {
  for (const char* x :
       {"1/10", "1/2", "1", "13/4", "1/3", "1/100000", "17", "200", "1/123456789012345678901234567890"}) {
    expect_enclosure(Rational(x));
  }
}

TEST(Threshold, BeyondBinary64IsStillAnEnclosure) {
  for (const auto& [x, exponent] : {std::pair{Rational(1, 3), -2000},
                                    {Rational(1, 3), -400},
                                    {Rational(400), 0},
                                    {Rational(1), 20},
                                    {Rational(3), 1000}}) {
    using boost::multiprecision::pow;
    const Rational power(pow(boost::multiprecision::mpz_int(2), static_cast<unsigned>(std::abs(exponent))));
    const Threshold threshold(exponent < 0 ? Rational(x / power) : Rational(x * power));
    const auto& [low, high] = threshold.at<Mp256>();
    EXPECT_GE(threshold.low(), 0);
    EXPECT_LE(threshold.low(), threshold.high());
    EXPECT_GT(threshold.high(), 0);
    EXPECT_LE(low, high);
    EXPECT_GT(low, 0);
    EXPECT_LE(Mp256(threshold.low()), high);
    EXPECT_GE(Mp256(threshold.high()), low);
  }
}

RC_GTEST_PROP(ThresholdProperty, EnclosesTightly, ()) {
  const Rational x(1 + test::any_index(1'000'000u), 1 + test::any_index(1'000'000u));
  RC_PRE(x < 300);
  const Threshold threshold(x);
  const Mp4096 value = sinh2(x);
  RC_ASSERT(Mp4096(threshold.low()) <= value);
  RC_ASSERT(Mp4096(threshold.high()) >= value);
  RC_ASSERT(std::nextafter(threshold.low(), HUGE_VAL) >= threshold.high());
}

}  // namespace
}  // namespace epsnet::threshold_test
