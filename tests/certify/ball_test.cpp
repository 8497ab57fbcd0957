#include "certify/numbers/ball.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <flint/fmpq.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <stdexcept>
#include <thread>
#include <vector>

#include "certify/numbers/isometry.h"
#include "certify/numbers/parallel.h"

namespace epsnet::certify::ball_test {
namespace {

/// m ± 2^−k.
Ball ball(double middle, slong k) {
  Ball x;
  arb_set_d(x.get(), middle);
  mag_set_ui_2exp_si(arb_radref(x.get()), 1, -k);
  return x;
}

Ball nan_ball() {
  Ball x;
  arb_indeterminate(x.get());
  return x;
}

bool contains(const Ball& x, const mpq_class& value) {
  fmpq_t q;
  fmpq_init(q);
  fmpq_set_mpq(q, value.get_mpq_t());
  const bool result = arb_contains_fmpq(x.get(), q) != 0;
  fmpq_clear(q);
  return result;
}

// Each trap of Arb that a checker can fall into, and that our functions do not.

TEST(Ball, CopiesAreWhatIsCopied) {
  for (const double value : {-2.5, 0.0, 3.0}) {
    Ball original;
    arb_set_d(original.get(), value);
    Ball assigned, moved_to;
    assigned = original;
    const Ball copied = original;
    moved_to = Ball(original);
    for (const Ball& other : {assigned, copied, moved_to})
      EXPECT_NE(arb_equal(other.get(), original.get()), 0) << value;
    ComplexBall complex;
    arb_set_d(complex.re(), value);
    arb_set_d(complex.im(), -value);
    ComplexBall other;
    other = complex;
    EXPECT_NE(acb_equal(other.get(), complex.get()), 0);
    EXPECT_NE(acb_equal(ComplexBall(complex).get(), complex.get()), 0);
  }
  // More than a machine word, which is kept elsewhere.
  for (const mpz_class& value : {mpz_class(-7), mpz_class(mpz_class(3) << 200)}) {
    const Integer original(value);
    Integer assigned, moved_to;
    assigned = original;
    const Integer copied = original;
    moved_to = Integer(original);
    for (const Integer& other : {assigned, copied, moved_to}) EXPECT_EQ(other.value(), value);
    EXPECT_EQ(original.value(), value);
  }
}

TEST(Tri, UnknownIsDecidedByTheOtherAnswerOrNot) {
  constexpr Tri kNo = Tri::no, kYes = Tri::yes, kUnknown = Tri::unknown;
  EXPECT_EQ(!kNo, kYes);
  EXPECT_EQ(!kYes, kNo);
  EXPECT_EQ(!kUnknown, kUnknown);
  // In the order no, yes, unknown of both.
  constexpr std::array<Tri, 3> kAll{kNo, kYes, kUnknown};
  constexpr Tri kBoth[3][3]{{kNo, kNo, kNo}, {kNo, kYes, kUnknown}, {kNo, kUnknown, kUnknown}};
  constexpr Tri kEither[3][3]{{kNo, kYes, kUnknown}, {kYes, kYes, kYes}, {kUnknown, kYes, kUnknown}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(both(kAll[i], kAll[k]), kBoth[i][k]) << i << k;
      EXPECT_EQ(either(kAll[i], kAll[k]), kEither[i][k]) << i << k;
    }
  }
}

TEST(BallTraps, ComparingNanIsUnknown) {
  const Ball x = nan_ball();
  const Ball y = ball(0.5, 20);
  EXPECT_EQ(arf_cmp(arb_midref(x.get()), arb_midref(y.get())), 0);  // The trap: NaN "equals" 1/2.
  EXPECT_EQ(certainly_less(x, y), Tri::unknown);
  EXPECT_EQ(certainly_less(y, x), Tri::unknown);
  EXPECT_EQ(certainly_positive(x), Tri::unknown);
}

TEST(BallTraps, NamedPredicatesSayNothingOfNan) {
  const Ball x = nan_ball();
  EXPECT_EQ(certainly_negative(x), Tri::unknown);
  EXPECT_EQ(certain_sign(x), 0);
  EXPECT_FALSE(is_exactly_zero(x));
  EXPECT_FALSE(is_finite(x));
  EXPECT_EQ(only_integer(x), std::nullopt);
  ComplexBall z, one;
  acb_indeterminate(z.get());
  acb_one(one.get());
  EXPECT_FALSE(certainly_different(z, one));
  EXPECT_FALSE(certainly_different(one, z));
}

TEST(Ball, SignsAreCertainOnlyIfAllPointsHaveThem) {
  EXPECT_EQ(certain_sign(ball(0.5, 2)), 1);
  EXPECT_EQ(certain_sign(ball(-0.5, 2)), -1);
  EXPECT_EQ(certain_sign(ball(0.25, 2)), 0) << "0 is a point of the ball";
  EXPECT_EQ(certainly_negative(ball(0.25, 2)), Tri::no) << "0 is not negative";
  EXPECT_EQ(certainly_negative(ball(-0.25, 1)), Tri::unknown);
  Ball zero;
  EXPECT_EQ(certain_sign(zero), 0);
  EXPECT_TRUE(is_exactly_zero(zero));
  EXPECT_FALSE(is_exactly_zero(ball(0, 900)));
}

TEST(Ball, AnIntegerIsFoundOnlyIfItIsTheOnlyOne) {
  EXPECT_EQ(only_integer(ball(2.1, 2)), 2);
  EXPECT_EQ(only_integer(ball(2.5, 3)), std::nullopt) << "none";
  EXPECT_EQ(only_integer(ball(2.5, 0)), std::nullopt) << "two";
  EXPECT_EQ(only_integer(ball(0x1p80, 5)), std::nullopt) << "too large";
}

TEST(Binary64, AboveAndBelowAreNextNumbersOrBeyond) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, 0x1p-1074, 3 * 0x1p-1074, 0x1p-1022, 0x1.8p-1023, 0x1.fffffffffffffp-970, 0x1p-970, 0.1,
                         1 - 0x1p-53, 1.0, 1 + 0x1p-52, 2 - 0x1p-52, 1e300, std::numeric_limits<double>::max()}) {
    for (const double y : {x, -x}) {
      EXPECT_GE(above(y), std::nextafter(y, kInfinity)) << y;
      EXPECT_LE(below(y), std::nextafter(y, -kInfinity)) << y;
      EXPECT_LE(above(y) - y, 4 * (std::nextafter(std::fabs(y), kInfinity) - std::fabs(y))) << y;
    }
  }
  EXPECT_EQ(above(kInfinity), kInfinity);
  EXPECT_EQ(below(-kInfinity), -kInfinity);
}

TEST(BallTraps, SetPredicatesSayYesToNan) {
  // Documented here so that nobody uses them as evidence.
  EXPECT_NE(arb_contains_zero(nan_ball().get()), 0);
  EXPECT_NE(arb_overlaps(nan_ball().get(), ball(1, 10).get()), 0);
}

TEST(BallTraps, RootOfABallAroundZeroIsNotFinite) {
  Ball root;
  arb_sqrt(root.get(), ball(0, 60).get(), 64);
  EXPECT_FALSE(arb_is_finite(root.get()));
  arb_sqrtpos(root.get(), ball(0, 60).get(), 64);
  EXPECT_TRUE(arb_is_finite(root.get()));
  Ball area;
  arb_acosh(area.get(), ball(1, 60).get(), 64);
  EXPECT_FALSE(arb_is_finite(area.get()));
}

TEST(BallTraps, DecimalsEnterAsRationals) {
  Ball binary;
  arb_set_d(binary.get(), 0.1);
  EXPECT_FALSE(contains(binary, mpq_class(1, 10)));
  const Precision scope(64);
  EXPECT_FALSE(contains(Ball::exactly(0.1), mpq_class(1, 10)));
  EXPECT_TRUE(contains(Ball::rounded(mpq_class(1, 10)), mpq_class(1, 10)));
}

TEST(BallTraps, AliasedArgumentsAreTheSameNumber) {
  const Ball x = ball(0, 10);
  Ball square;
  arb_mul(square.get(), x.get(), x.get(), 64);
  Ball product;
  arb_mul(product.get(), x.get(), ball(0, 10).get(), 64);
  Ball difference;
  arb_sub(difference.get(), x.get(), Ball(x).get(), 64);
  EXPECT_EQ(certainly_less(product, product), Tri::unknown);
  EXPECT_TRUE(contains(difference, mpq_class(1, 1024)));  // A copy is a number of its own.
}

TEST(BallTraps, InfiniteBallsProveNothing) {
  Ball x;
  arb_zero_pm_inf(x.get());
  EXPECT_EQ(certainly_less(x, ball(1, 10)), Tri::unknown);
  const Interval all = outer_interval(x);
  EXPECT_EQ(all.lower, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(all.upper, std::numeric_limits<double>::infinity());
}

TEST(Ball, TouchingBallsAreNotCompared) {
  EXPECT_EQ(certainly_less(ball(0, 1), ball(1.5, 1)), Tri::yes);
  EXPECT_EQ(certainly_less(ball(0, 1), ball(1, 1)), Tri::unknown);  // Both may be 1/2.
  EXPECT_EQ(certainly_less(ball(2, 1), ball(1, 1)), Tri::no);       // At best both are 3/2.
  EXPECT_EQ(certainly_positive(ball(0.5, 1)), Tri::unknown);
  EXPECT_EQ(certainly_positive(ball(0.75, 1)), Tri::yes);
  EXPECT_EQ(certainly_positive(ball(-0.5, 1)), Tri::no);
  EXPECT_EQ(certainly_positive(Ball()), Tri::no);
}

TEST(Ball, OuterIntervalRoundsOutward) {
  const Precision scope(200);
  const Ball third = Ball::rounded(mpq_class(1, 3));
  const Interval x = outer_interval(third);
  EXPECT_LT(mpq_class(x.lower), mpq_class(1, 3));
  EXPECT_GT(mpq_class(x.upper), mpq_class(1, 3));
  EXPECT_EQ(above(x.lower), x.upper);
}

TEST(Ball, OuterIntervalHoldsHugeAndTinyNumbers) {
  Ball x = ball(1, 10);
  arb_mul_2exp_si(x.get(), x.get(), 5000);
  EXPECT_LE(outer_interval(x).lower, std::numeric_limits<double>::max());
  EXPECT_EQ(outer_interval(x).upper, std::numeric_limits<double>::infinity());
  arb_mul_2exp_si(x.get(), x.get(), -10000);
  EXPECT_EQ(outer_interval(x).lower, 0);
  EXPECT_GT(outer_interval(x).upper, 0);
}

mpz_class random_integer(int bits) {
  mpz_class value = 0;
  for (int i = 0; i < bits; i += 32) value = (value << 32) + *rc::gen::arbitrary<std::uint32_t>();
  return value;
}

/// A point with numerator and denominator of random size inside the disk.
ExactPoint random_point() {
  const int bits = *rc::gen::inRange(1, 300);
  ExactPoint z{{random_integer(bits), random_integer(bits)}, 0};
  if (*rc::gen::arbitrary<bool>()) z.n.re = -z.n.re;
  if (*rc::gen::arbitrary<bool>()) z.n.im = -z.n.im;
  z.m = abs(z.n.re) + abs(z.n.im) + 1 + random_integer(*rc::gen::inRange(0, bits));
  return z;
}

// The inclusion principle: the ball of an exact isometry contains it, at every precision.
RC_GTEST_PROP(BallProperty, IsometriesContainTheExactOnes, ()) {
  const ExactIsometry f = compose(translation_to(random_point()), inverse(translation_to(random_point())));
  const slong precision = *rc::gen::inRange(20, 400);
  const BallIsometry balls = to_balls(f, precision);
  // (a, b) is only known up to a real factor: compare the products with b̄ and det = 1.
  const mpz_class determinant_value = determinant(f);
  Ball square, part;
  arb_sqr(square.get(), balls.a.re(), precision);
  arb_sqr(part.get(), balls.a.im(), precision);
  arb_add(square.get(), square.get(), part.get(), precision);
  RC_ASSERT(contains(square, mpq_class(norm(f.a)) / determinant_value));
  arb_mul(square.get(), balls.a.re(), balls.b.im(), precision);
  RC_ASSERT(contains(square, mpq_class(f.a.re * f.b.im) / determinant_value));
}

RC_GTEST_PROP(BallProperty, CompositionContainsTheExactOne, ()) {
  const ExactIsometry f = translation_to(random_point());
  const ExactIsometry g = translation_to(random_point());
  const slong precision = *rc::gen::inRange(20, 400);
  const BallIsometry balls = compose(to_balls(f, precision), inverse(to_balls(g, precision)), precision);
  const ExactIsometry exact = compose(f, inverse(g));
  Ball square;
  half_displacement_squared(square.get(), balls, precision);
  RC_ASSERT(contains(square, mpq_class(norm(exact.b)) / determinant(exact)));
}

TEST(Ball, OuterIntervalHoldsBothEndsOfAWideBall) {
  for (const double middle : {1.0, -1.0, 0.0, 1e-3}) {
    const Interval interval = outer_interval(ball(middle, 1));  // ± 1/2.
    EXPECT_LE(interval.lower, middle - 0.5);
    EXPECT_GE(interval.upper, middle + 0.5);
    EXPECT_NEAR(interval.lower, middle - 0.5, 1e-9);
    EXPECT_NEAR(interval.upper, middle + 0.5, 1e-9);
  }
}

TEST(Ball, AFastIntervalHoldsTheBall) {
  // Midpoints between two binary64 numbers, near one or the other or half-way, and radii from nothing to much.
  for (const double sign : {1.0, -1.0}) {
    for (const double start : {0.0, 1.0, 1.3, 1.9, 0x1p-60, 0x1p300, 0x1.fffffffffffffp0}) {
      for (const double share : {0.0, 0.25, 0.49, 0.5, 0.51, 0.75, 0.99}) {
        for (int radius = -1; radius < 120; radius += 7) {
          Ball x = ball(sign * start, 2000);
          mag_zero(arb_radref(x.get()));
          Ball rest = ball(sign * share * (std::nextafter(start, HUGE_VAL) - start), 2000);
          mag_zero(arb_radref(rest.get()));
          arb_add(x.get(), x.get(), rest.get(), 400);
          if (radius >= 0) mag_set_ui_2exp_si(arb_radref(x.get()), 1, -radius);
          const Interval outer = outer_interval(x);
          const Interval fast = fast_interval(x);
          EXPECT_LE(fast.lower, outer.lower) << start << ", " << share << ", " << radius;
          EXPECT_GE(fast.upper, outer.upper) << start << ", " << share << ", " << radius;
          const double width = outer.upper - outer.lower + std::fabs(start) * 0x1p-49 + 0x1p-1060;
          EXPECT_LE(outer.lower - fast.lower, width);
          EXPECT_LE(fast.upper - outer.upper, width);
        }
      }
    }
  }
}

TEST(Ball, AreSortedIfBallsTellTheirOrder) {
  const auto sorted = [](std::vector<Ball> balls) {
    const bool certain = sort_certainly(balls, [](const Ball& x) -> const Ball& { return x; });
    EXPECT_TRUE(std::is_sorted(balls.begin(), balls.end(), [](const Ball& x, const Ball& y) {
      return arf_cmp(arb_midref(x.get()), arb_midref(y.get())) < 0;
    }));
    return certain;
  };
  EXPECT_TRUE(sorted({}));
  EXPECT_TRUE(sorted({nan_ball()})) << "one alone";
  EXPECT_TRUE(sorted({ball(3, 40), ball(1, 40), ball(2, 40)}));
  EXPECT_TRUE(sorted({ball(3, 3), ball(1, 3), ball(2, 1)}));
  EXPECT_FALSE(sorted({ball(3, 0), ball(1, 3), ball(2, 1)})) << "the last two";
  EXPECT_FALSE(sorted({ball(3, 3), ball(1, 1), ball(2, 0)})) << "the first two";
  EXPECT_FALSE(sorted({ball(1, 40), ball(1, 40)})) << "equal, perhaps";
  EXPECT_FALSE(sorted({ball(3, 40), ball(2, 40), ball(1, 40), ball(2.5, 0), ball(5, 40)}));
}

TEST(Ball, WhatIsNotFiniteIsUnknown) {
  Ball infinite, minus, one;
  arb_pos_inf(infinite.get());
  arb_neg_inf(minus.get());
  arb_one(one.get());
  for (const Ball& x : {infinite, minus, nan_ball()}) {
    EXPECT_EQ(certainly_less(x, one), Tri::unknown);
    EXPECT_EQ(certainly_less(one, x), Tri::unknown);
    EXPECT_EQ(certainly_positive(x), Tri::unknown);
    EXPECT_EQ(certainly_negative(x), Tri::unknown);
    EXPECT_EQ(outer_interval(x).lower, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(outer_interval(x).upper, std::numeric_limits<double>::infinity());
  }
}

TEST(Ball, BallsAreDifferentIfTheyHaveNoPointInCommon) {
  ComplexBall x, y;
  acb_set_si(x.get(), 1);
  acb_set_si(y.get(), 2);
  EXPECT_TRUE(certainly_different(x, y));
  EXPECT_FALSE(certainly_different(x, x));
  mag_set_ui(arb_radref(y.re()), 1);
  EXPECT_FALSE(certainly_different(x, y));
}

/// A number of random size, and a ball of random width that contains it.
struct Enclosed {
  mpq_class value;
  Ball ball;
};

Enclosed random_number() {
  const mpz_class denominator = 1 + abs(random_integer(*rc::gen::inRange(1, 100)));
  const mpz_class numerator = random_integer(*rc::gen::inRange(1, 100));
  mpq_class value = mpq_class(*rc::gen::arbitrary<bool>() ? numerator : mpz_class(-numerator)) / mpq_class(denominator);
  Ball ball = Ball::rounded(value);
  if (*rc::gen::arbitrary<bool>()) arb_add_error_2exp_si(ball.get(), -*rc::gen::inRange(0, 100));
  return {value, ball};
}

// The inclusion principle, for each operator.
RC_GTEST_PROP(BallProperty, OperatorsContainWhatTheyName, ()) {
  const Precision scope(*rc::gen::inRange(2, 200));
  const auto [x, a] = random_number();
  const auto [y, b] = random_number();
  RC_ASSERT(contains(a + b, x + y));
  RC_ASSERT(contains(a - b, x - y));
  RC_ASSERT(contains(a * b, x * y));
  if (y != 0) RC_ASSERT(contains(a / b, x / y));
  RC_ASSERT(contains(-a, -x));
  RC_ASSERT(contains(a + 3, x + 3));
  RC_ASSERT(contains(3 + a, x + 3));
  RC_ASSERT(contains(a - 3, x - 3));
  RC_ASSERT(contains(3 - a, 3 - x));
  RC_ASSERT(contains(3 * a, 3 * x));
  RC_ASSERT(contains(a / 3, x / 3));
  if (x != 0) RC_ASSERT(contains(3 / a, 3 / x));
  RC_ASSERT(contains(half(a), x / 2) && contains(twice(a), 2 * x) && contains(scaled(a, -7), x / 128));
  RC_ASSERT(contains(abs(a), abs(x)) && contains(sqr(a), x * x));
  RC_ASSERT(contains(min(a, b), std::min(x, y)) && contains(max(a, b), std::max(x, y)));
  RC_ASSERT(contains(sqr(sqrt_of_nonnegative(abs(a))), abs(x)));
  // Functions with their inverses.
  RC_ASSERT(contains(sinh(asinh(a)), x));
  RC_ASSERT(contains(sqr(cosh(a)) - sqr(sinh(a)), 1));
  const Ball more = abs(a) + 2;
  RC_ASSERT(contains(sqr(sqrt(more)), abs(x) + 2) && contains(1 / sqr(rsqrt(more)), abs(x) + 2));
  RC_ASSERT(contains(cosh(acosh(more)), abs(x) + 2));
  // (x + iy)(x − iy), and its angle, 0.
  const ComplexBall z(a, b);
  RC_ASSERT(contains(norm(z), x * x + y * y) && contains(real(z * conjugate(z)), x * x + y * y));
  RC_ASSERT(contains(imaginary(z * conjugate(z)), 0) && contains(imaginary(-(z + z)), -2 * y));
  RC_ASSERT(contains(real(b * z), x * y) && contains(imaginary(b * z), y * y));
}

TEST(Ball, ConstantsAndAnglesAreThose) {
  const Precision scope(100);
  const double right = std::acos(0.0);
  const auto expect = [](const Ball& x, double value) {
    const Interval found = outer_interval(x);
    EXPECT_LE(found.lower, found.upper);
    EXPECT_NEAR(found.lower, value, 1e-15);
    EXPECT_NEAR(found.upper, value, 1e-15);
  };
  expect(half(pi()), right);
  expect(ln2(), std::log(2.0));
  expect(atan(Ball::exactly(1)), right / 2);
  expect(atan2(Ball::exactly(1), Ball::exactly(-1)), 1.5 * right);
  expect(atan2(Ball::exactly(-1), Ball::exactly(1)), -right / 2);
  expect(real(root_of_unity(1, 8)), std::sqrt(0.5));
  expect(imaginary(root_of_unity(7, 8)), -std::sqrt(0.5));
  EXPECT_TRUE(contains(real(root_of_unity(4000000000U, 4000000001U)) - real(root_of_unity(1, 4000000001U)), 0));
}

TEST(BallTraps, FunctionsHaveNoValueWhereItIsNotCertain) {
  const Precision scope(64);
  EXPECT_FALSE(is_finite(sqrt(ball(0, 60))));
  EXPECT_TRUE(is_finite(sqrt_of_nonnegative(ball(0, 60))));
  EXPECT_FALSE(is_finite(rsqrt(ball(0, 60))));
  EXPECT_FALSE(is_finite(acosh(ball(1, 60))));
  EXPECT_FALSE(is_finite(1 / ball(0, 60)));
  EXPECT_EQ(certainly_negative(sqr(ball(0, 1))), Tri::unknown) << "a square, but the ball does not say so";
  EXPECT_EQ(certainly_negative(sqr(ball(1, 2))), Tri::no);
  // Integers are not rounded when they enter.
  EXPECT_TRUE(contains(Ball::exactly(std::numeric_limits<std::uint64_t>::max()), mpq_class("18446744073709551615")));
  EXPECT_TRUE(contains(Ball::exactly(std::numeric_limits<std::int64_t>::min()), mpq_class("-9223372036854775808")));
  const Precision few(2);
  EXPECT_TRUE(contains(Ball::rounded(mpz_class(1001)), 1001));
  EXPECT_FALSE(is_exactly_zero(Ball::rounded(mpz_class(1001)) - 1001));
}

TEST(Precision, IsThatOfTheInnermostScopeAndOfTheCallersThread) {
  const auto accuracy = [] { return arb_rel_accuracy_bits(pi().get()); };
  EXPECT_THROW((void)pi(), Fault);
  EXPECT_THROW((void)(Ball() + Ball()), Fault);
  {
    const Precision outer(300);
    EXPECT_NEAR(static_cast<double>(accuracy()), 300, 10);
    {
      const Precision inner(80);
      EXPECT_NEAR(static_cast<double>(accuracy()), 80, 10);
    }
    EXPECT_NEAR(static_cast<double>(accuracy()), 300, 10);
    for_each_parallel(20, 4, [&](unsigned, std::size_t) { EXPECT_NEAR(static_cast<double>(accuracy()), 300, 10); });
    with_rising_precision(1000, [&](long precision) {
      EXPECT_NEAR(static_cast<double>(accuracy()), static_cast<double>(precision), 10);
      return false;
    });
  }
  EXPECT_THROW((void)pi(), Fault);
}

TEST(Parallel, BlocksHaveEveryNumberOnceAndInOrder) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{16'384}, std::size_t{100'001}}) {
    for (const unsigned threads : {1U, 3U}) {
      std::size_t next = 0;
      for (const auto& [first, last] : results_of_blocks(
               count, threads, [](std::size_t first, std::size_t last) { return std::pair(first, last); })) {
        EXPECT_EQ(first, next);
        EXPECT_LT(first, last);
        next = last;
      }
      EXPECT_EQ(next, count);
    }
  }
}

TEST(Parallel, NoNumberOfThreadsIsAsManyAsThereAreCores) {
  for (const unsigned threads : {1U, 2U, 77U}) EXPECT_EQ(thread_count(threads), threads);
  EXPECT_EQ(thread_count(0), std::max(std::thread::hardware_concurrency(), 1U));
}

TEST(Parallel, EveryIndexOnceByAnyNumberOfThreads) {
  for (const unsigned threads : {0U, 1U, 2U, 5U}) {
    for (const std::size_t count : {0U, 1U, 3U, 100U}) {
      std::vector<std::atomic<int>> times(count);
      for_each_parallel(count, threads, [&](unsigned worker, std::size_t i) {
        EXPECT_LT(worker, std::max(threads, 1U));
        ++times[i];
      });
      for (const auto& n : times) EXPECT_EQ(n, 1);
    }
  }
}

TEST(Parallel, AnExceptionArrivesWhereverItIsThrown) {
  for (const unsigned threads : {1U, 2U, 5U}) {
    for (const std::size_t bad : {0U, 50U, 99U}) {
      EXPECT_THROW(for_each_parallel(100, threads,
                                     [&](unsigned, std::size_t i) {
                                       if (i == bad) throw std::runtime_error("this one");
                                     }),
                   std::runtime_error);
    }
  }
}

TEST(Precision, RisesUntilItIsDecidedOrTheCapIsReached) {
  std::vector<long> asked;
  const auto until = [&](long enough) {
    return [&asked, enough](long precision) {
      asked.push_back(precision);
      return precision >= enough;
    };
  };
  EXPECT_TRUE(with_rising_precision(1000, until(200)));
  EXPECT_EQ(asked, (std::vector<long>{64, 128, 256}));
  asked.clear();
  EXPECT_FALSE(with_rising_precision(200, until(1000)));
  EXPECT_EQ(asked, (std::vector<long>{64, 128, 200}));
  asked.clear();
  EXPECT_TRUE(with_rising_precision(40, until(40)));
  EXPECT_EQ(asked, (std::vector<long>{40}));
}

}  // namespace
}  // namespace epsnet::certify::ball_test
