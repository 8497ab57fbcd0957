#include "tests/kernel/exact.h"

#include <gtest/gtest.h>
#include <random>

#include "kernel/plane.h"
#include "tests/support/scale.h"

namespace epsnet::exact_test {
namespace {

using test::Dyadic;

// The oracle of the predicates' tests against GMP's rational numbers.

TEST(Dyadic, IsExactForBinary64) {
  for (const double x : {0.0, 1.0, -1.0, 0.1, -0.3, 1e300, 1e-300, 0x1p-1074, 0x1.fffffffffffffp+1023}) {
    EXPECT_EQ(Dyadic(x).rational(), Rational(x)) << x;
  }
}

TEST(Dyadic, IsExactForMultiprecision) {
  const Mp256 third = Mp256(1) / Mp256(3);
  EXPECT_EQ(Dyadic(third).rational(), static_cast<Rational>(third));
  EXPECT_EQ(Dyadic(Mp256(0)).rational(), 0);
}

TEST(Dyadic, AgreesWithRational) {
  std::mt19937_64 random(1);
  const auto next = [&] {
    return std::ldexp(static_cast<double>(static_cast<long>(random())), -static_cast<int>(random() % 200));
  };
  for (int i = test::scaled(5000); i > 0; --i) {
    const double x = next();
    const double y = random() % 8 == 0 ? x : next();
    const double z = next();
    const Rational exact = Rational(x) * Rational(y) - Rational(z) * (Rational(x) + Rational(y));
    const Dyadic dyadic = Dyadic(x) * Dyadic(y) - Dyadic(z) * (Dyadic(x) + Dyadic(y));
    ASSERT_EQ(dyadic.rational(), exact);
    ASSERT_EQ(sign(dyadic), sign(exact));
    ASSERT_EQ(Dyadic(x) < Dyadic(y), x < y);
    ASSERT_EQ(Dyadic(x) <= Dyadic(y), x <= y);
    ASSERT_EQ(Dyadic(x) == Dyadic(y), x == y);
  }
}

}  // namespace
}  // namespace epsnet::exact_test
