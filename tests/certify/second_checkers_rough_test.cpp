#include <array>
#include <cfenv>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

#include "certify/exact/algebraic.h"
#include "certify/exact/rough_interval.h"

/// The second checker's signs of a few digits, against exact numbers.
namespace epsnet::exact::rough_interval_test {
namespace {

bool contains(const RoughInterval& x, const mpq_class& value) {
  const bool above = std::isinf(x.lower()) || mpq_class(x.lower()) <= value;
  return above && (std::isinf(x.upper()) || value <= mpq_class(x.upper()));
}

/// An interval of one number, and the number.
struct Both {
  RoughInterval rough;
  mpq_class exact;
};

/// Numbers of all sizes, of which many are near each other.
class Numbers {
 public:
  double next() {
    const double mantissa = std::uniform_real_distribution<double>(-1, 1)(random_);
    switch (random_() % 5) {
      case 0:
        return last_ = std::ldexp(mantissa, static_cast<int>(random_() % 600) - 300);
      case 1:
        return last_ = std::nextafter(last_, random_() % 2 == 0 ? -1e300 : 1e300);
      case 2:
        return last_ = -last_;
      case 3:
        return last_ = std::ldexp(mantissa, -1040);
      default:
        return last_ = mantissa;
    }
  }

 private:
  std::mt19937_64 random_{7};
  double last_ = 0.5;
};

class RoughIntervals : public testing::TestWithParam<int> {
 protected:
  void SetUp() override { std::fesetround(GetParam()); }
  void TearDown() override { std::fesetround(FE_TONEAREST); }
};

TEST_P(RoughIntervals, ContainWhatTheyStandFor) {
  Numbers numbers;
  std::vector<Both> known;
  for (int i = 0; i < 20'000; ++i) {
    const double x = numbers.next();
    known.push_back({RoughInterval::around(x, x), mpq_class(x)});
    if (known.size() < 3) continue;
    const Both& a = known[known.size() - 1];
    const Both& b = known[known.size() - 2];
    const Both& c = known[known.size() - 3];
    const std::array<Both, 5> results{{{a.rough + b.rough, a.exact + b.exact},
                                       {a.rough - b.rough, a.exact - b.exact},
                                       {a.rough * b.rough, a.exact * b.exact},
                                       {a.rough * b.rough - b.rough * c.rough, a.exact * b.exact - b.exact * c.exact},
                                       {-(a.rough * a.rough * c.rough), -(a.exact * a.exact * c.exact)}}};
    for (const Both& result : results) {
      ASSERT_TRUE(contains(result.rough, result.exact)) << x;
      const int sign = certain_sign(result.rough);
      ASSERT_TRUE(sign == 0 || sign == sgn(result.exact)) << x;
    }
    const RoughInterval square_of_a = square(a.rough);
    ASSERT_TRUE(contains(square_of_a, a.exact * a.exact) && square_of_a.lower() >= 0) << x;
    if (b.exact != 0) {
      ASSERT_TRUE(contains(a.rough / b.rough, a.exact / b.exact)) << x;
    }
    const RoughInterval root = sqrt(RoughInterval::around(std::abs(x), std::abs(x)));
    ASSERT_TRUE(root.lower() <= 0 || mpq_class(root.lower()) * root.lower() <= abs(a.exact)) << x;
    ASSERT_TRUE(mpq_class(root.upper()) * root.upper() >= abs(a.exact)) << x;
  }
}

TEST(RoughQuotients, ByWhatMayBeZeroAreUnknown) {
  for (const RoughInterval& divisor : {RoughInterval::around(-1, 1), RoughInterval::around(0, 1), RoughInterval(0)}) {
    EXPECT_EQ(certain_sign(RoughInterval(1) / divisor), 0);
    EXPECT_TRUE(std::isinf((RoughInterval(1) / divisor).lower()));
  }
}

INSTANTIATE_TEST_SUITE_P(AnyRounding, RoughIntervals,
                         testing::Values(FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO));

TEST(RoughInterval, OperationsAreThoseOfTheirEnds) {
  // All intervals with ends from −2 to 3.
  std::vector<std::array<double, 2>> all;
  for (int a = -2; a <= 3; ++a) {
    for (int b = a; b <= 3; ++b) all.push_back({static_cast<double>(a), static_cast<double>(b)});
  }
  const auto expect_ends = [](const RoughInterval& x, double lower, double upper) {
    EXPECT_LE(x.lower(), lower);
    EXPECT_NEAR(x.lower(), lower, 1e-12);
    EXPECT_GE(x.upper(), upper);
    EXPECT_NEAR(x.upper(), upper, 1e-12);
  };
  for (const auto& [a, b] : all) {
    const RoughInterval x = RoughInterval::around(a, b);
    expect_ends(-x, -b, -a);
    const bool has_zero = a <= 0 && b >= 0;
    EXPECT_NEAR(square(x).lower(), has_zero ? 0 : std::min(a * a, b * b), 1e-12);
    EXPECT_GE(square(x).upper(), std::max(a * a, b * b));
    if (a >= 0) expect_ends(sqrt(x), std::sqrt(a), std::sqrt(b));
    for (const auto& [c, d] : all) {
      const RoughInterval y = RoughInterval::around(c, d);
      expect_ends(x + y, a + c, b + d);
      expect_ends(x - y, a - d, b - c);
      expect_ends(x * y, std::min({a * c, a * d, b * c, b * d}), std::max({a * c, a * d, b * c, b * d}));
      if (c > 0 || d < 0)
        expect_ends(x / y, std::min({a / c, a / d, b / c, b / d}), std::max({a / c, a / d, b / c, b / d}));
      // Ends that are equal are not told apart.
      EXPECT_EQ(is_less(x, y), b < c ? Answer::yes : a > d ? Answer::no : Answer::unknown);
    }
  }
}

TEST(RoughInterval, WhatOverflowsIsTheWholeLine) {
  RoughInterval x = RoughInterval::around(1e200, 1e200);
  const RoughInterval zero = 0;
  x = x * x;
  EXPECT_EQ(certain_sign(x), 0);
  EXPECT_EQ(certain_sign(x * zero), 0);
  EXPECT_EQ(certain_sign(x - x), 0);
  EXPECT_EQ(certain_sign(x * x + 1), 0);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(certain_sign(RoughInterval::around(nothing, nothing)), 0);
  EXPECT_EQ(certain_sign(RoughInterval::around(1, nothing)), 0);
  // Rational numbers that are too large for binary64, or too small.
  EXPECT_EQ(certain_sign(RoughInterval(mpq_class(mpz_class(1) << 5000))), 0);
  EXPECT_TRUE(contains(RoughInterval(mpq_class(1, mpz_class(1) << 5000)), mpq_class(1, mpz_class(1) << 5000)));
}

/// A point of the disk with coordinates of so many bits.
Point<mpz_class> random_point(std::mt19937_64& random, unsigned bits) {
  const auto coordinate = [&]() -> mpz_class {
    return mpz_class(static_cast<long>(random() >> 11U) >> (53 - bits)) * 2;
  };
  const mpz_class m = mpz_class(3) << bits;
  return {{coordinate() - (mpz_class(1) << bits), coordinate() - (mpz_class(1) << bits)}, m};
}

TEST(RoughInterval, SignsOfPointsAreExactOnesOrUnknown) {
  std::mt19937_64 random(11);
  int unknown = 0;
  for (int i = 0; i < 3000; ++i) {
    const Point<mpz_class> p = random_point(random, 20);
    const Point<mpz_class> q = random_point(random, 20);
    Point<mpz_class> r = random_point(random, 20);
    if (i % 3 != 0) {
      // On the geodesic through 0 and p, or off it by a little.
      r = {mpz_class(mpz_class(1) << 80) * p.n, p.m << 81};
      if (i % 3 == 1) r.n.re += static_cast<long>(random() % 3) - 1;
    }
    const Point<mpz_class> origin{{0, 0}, 1};
    for (const auto& [u, v, w] : {std::array{p, q, r}, std::array{origin, p, r}, std::array{r, origin, p}}) {
      const int sign = certain_sign(area(rough(u), rough(v), rough(w)));
      const int exact = sgn(area(u, v, w));
      ASSERT_TRUE(sign == 0 || sign == exact) << i;
      if (sign == 0) ++unknown;
    }
    // Moved by an isometry: real multiples do not matter.
    const Isometry<mpz_class> f = compose(translation_to(q), Isometry<mpz_class>{{3, 4}, {0, 0}});
    const Point<mpz_class> moved =
        lowest_terms((f.a * p.n + p.m * f.b) * conjugate(conjugate(f.b) * p.n + p.m * conjugate(f.a)),
                     norm(conjugate(f.b) * p.n + p.m * conjugate(f.a)));
    const Point<RoughInterval> rough_moved = image(rough(f), rough(p));
    // The ratios agree: the same point.
    const RoughInterval difference =
        rough_moved.n.re * RoughInterval(mpq_class(moved.m)) - rough_moved.m * RoughInterval(mpq_class(moved.n.re));
    ASSERT_EQ(certain_sign(difference), 0) << i;
  }
  EXPECT_GT(unknown, 100);
}

TEST(RoughInterval, OfATieIsUnknown) {
  const Point<mpz_class> p{{3, 5}, 11};
  const Point<mpz_class> origin{{0, 0}, 1};
  const Point<mpz_class> opposite{{-6, -10}, 33};
  ASSERT_EQ(sgn(area(origin, p, opposite)), 0);
  EXPECT_EQ(certain_sign(area(rough(origin), rough(p), rough(opposite))), 0);
}

TEST(RoughInterval, SignsOfAlgebraicNumbersAreExactOnesOrUnknown) {
  const RealField field(7, 3, false);
  std::mt19937_64 random(13);
  const auto integer = [&] { return mpz_class(static_cast<long>(random() % 2001) - 1000); };
  const auto number = [&] {
    Algebraic result = integer();
    for (long k = 1; k < 5; ++k) result = result + Algebraic(integer()) * field.cosine(k);
    return result + Algebraic(integer()) * field.s();
  };
  int known = 0;
  for (int i = 0; i < 300; ++i) {
    const Algebraic x = number();
    const Algebraic y = number();
    const RoughInterval u(enclosure(x));
    const RoughInterval v(enclosure(y));
    const int sign = certain_sign(u * v + u);
    ASSERT_TRUE(sign == 0 || sign == sgn(x * y + x)) << i;
    if (sign != 0) ++known;
    // (x + y)(x − y) = x² − y².
    ASSERT_EQ(certain_sign((u + v) * (u - v) - (u * u - v * v)), 0) << i;
  }
  EXPECT_GT(known, 250);
}

TEST(RoughInterval, ComparesWithSinhAsExactNumbersDo) {
  const SquaredSinh s = squared_sinh(mpq_class(1, 10));
  const auto quotient = [&](const mpz_class& n, const mpz_class& d) {
    const Answer answer = is_less(RoughInterval(mpq_class(n)), RoughInterval(mpq_class(d)), rough(s));
    const Answer exact = is_less(n, d, s);
    EXPECT_TRUE(answer == Answer::unknown || answer == exact) << n << "/" << d;
    return answer;
  };
  EXPECT_EQ(quotient(1, 100), Answer::yes);
  EXPECT_EQ(quotient(11, 1000), Answer::no);
  EXPECT_EQ(quotient(s.lower, mpz_class(1) << s.k), Answer::unknown);
  EXPECT_EQ(quotient(s.upper, mpz_class(1) << s.k), Answer::unknown);
}

}  // namespace
}  // namespace epsnet::exact::rough_interval_test
