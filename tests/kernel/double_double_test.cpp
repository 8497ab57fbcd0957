#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "kernel/numbers.h"

namespace epsnet::double_double_test {
namespace {

Rational exact(const DoubleDouble& a) { return Rational(a.high) + Rational(a.low); }

/// |a − b| ≤ n u² |b|, u the unit roundoff.
bool within(const Rational& a, const Rational& b, int n) {
  const Rational u(kUnitRoundoff);
  return abs(a - b) <= n * u * u * abs(b);
}

/// Numbers of all signs, their second part up to half of an ulp; now and then the first parts cancel to the last bits.
DoubleDouble any_number() {
  const double high =
      std::ldexp(static_cast<double>(*rc::gen::inRange<long>(-(1L << 53), 1L << 53)), *rc::gen::inRange(-60, 20));
  const double low = std::ldexp(static_cast<double>(*rc::gen::inRange<long>(-(1L << 52), 1L << 52)) * high, -106);
  return DoubleDouble(high + low, low - ((high + low) - high));
}

RC_GTEST_PROP(DoubleDoubleProperty, SumsAreWithinTheirBound, ()) {
  const DoubleDouble a = any_number();
  const DoubleDouble b = *rc::gen::inRange(0, 3) == 0
                             ? DoubleDouble(-a.high, -a.low * *rc::gen::element(1.0, 0.5, 1 - 0x1p-50, -1.0))
                             : any_number();
  RC_ASSERT(exact(-a) == -exact(a));
  RC_ASSERT(within(exact(a + b), exact(a) + exact(b), 4));
  RC_ASSERT(within(exact(a - b), exact(a) - exact(b), 4));
}

RC_GTEST_PROP(DoubleDoubleProperty, ProductsAreWithinTheirBound, ()) {
  const DoubleDouble a = any_number();
  const DoubleDouble b = any_number();
  RC_ASSERT(within(exact(a * b), exact(a) * exact(b), 7));
}

RC_GTEST_PROP(DoubleDoubleProperty, ResultsAreNormalised, ()) {
  const DoubleDouble a = any_number();
  const DoubleDouble b = any_number();
  for (const DoubleDouble& c : {a + b, a - b, a * b}) {
    RC_ASSERT(c.high == c.high + c.low);
  }
}

TEST(DoubleDouble, RoundsNumbersOf256Bits) {
  const Mp256 third = Mp256(1) / Mp256(3);
  const DoubleDouble rounded(third);
  EXPECT_EQ(static_cast<double>(rounded), 1.0 / 3);
  EXPECT_TRUE(within(exact(rounded), static_cast<Rational>(third), 1));
  EXPECT_EQ(exact(DoubleDouble(Mp256(0))), 0);
  EXPECT_EQ(exact(DoubleDouble(Mp256(-0.75))), Rational(-3, 4));
}

}  // namespace
}  // namespace epsnet::double_double_test
