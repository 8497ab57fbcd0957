#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <mpfr.h>
#include <string>
#include <vector>

#include "certify/exact/interval.h"

/// The second checker's intervals, its three answers, and its numbers around sinh².
namespace epsnet::exact::second_checkers_intervals_test {
namespace {

constexpr std::array<Answer, 3> kAnswers{Answer::no, Answer::yes, Answer::unknown};

std::vector<bool> meanings(Answer x) {
  if (x == Answer::unknown) return {false, true};
  return {x == Answer::yes};
}

/// What is known if all of these may be true.
Answer answer_of(const std::vector<bool>& possible) {
  const bool yes = std::find(possible.begin(), possible.end(), true) != possible.end();
  const bool no = std::find(possible.begin(), possible.end(), false) != possible.end();
  return yes && no ? Answer::unknown : yes ? Answer::yes : Answer::no;
}

TEST(SecondCheckersAnswers, AreWhatFollowsFromTheirMeanings) {
  for (const Answer x : kAnswers) {
    std::vector<bool> negations;
    for (const bool a : meanings(x)) negations.push_back(!a);
    EXPECT_EQ(!x, answer_of(negations));
    for (const Answer y : kAnswers) {
      std::vector<bool> conjunctions, disjunctions;
      for (const bool a : meanings(x)) {
        for (const bool b : meanings(y)) {
          conjunctions.push_back(a && b);
          disjunctions.push_back(a || b);
        }
      }
      EXPECT_EQ(both(x, y), answer_of(conjunctions));
      EXPECT_EQ(either(x, y), answer_of(disjunctions));
    }
  }
}

TEST(SecondCheckersIntervals, TheMiddleIsOneNumber) {
  const Interval third(mpq_class(1, 3));  // Its ends are different.
  const Interval from_1_to_3 = hull(Interval(1), Interval(3));
  for (const Interval& x : {third, from_1_to_3, hull(-third, third), Interval(-5)}) {
    const Interval middle = x.middle();
    EXPECT_EQ(is_less(middle, middle), Answer::no);  // Unknown, if it had two ends.
    EXPECT_NE(is_less(middle, x), Answer::yes);
    EXPECT_NE(is_less(x, middle), Answer::yes);
  }
  EXPECT_EQ(from_1_to_3.middle().lower(), 2);
  EXPECT_EQ(from_1_to_3.middle().upper(), 2);
}

/// sinh²x to about 3,000 bits.
mpq_class precise_squared_sinh(const mpq_class& x) {
  mpfr_t value;
  mpfr_init2(value, 3000);
  mpfr_set_q(value, x.get_mpq_t(), MPFR_RNDN);
  mpfr_sinh(value, value, MPFR_RNDN);
  mpfr_sqr(value, value, MPFR_RNDN);
  mpq_class result;
  mpfr_get_q(result.get_mpq_t(), value);
  mpfr_clear(value);
  return result;
}

TEST(SecondCheckersSinh, IsBetweenItsBounds) {
  for (const mpq_class& x :
       {mpq_class(1, 3), mpq_class(1), mpq_class(31, 3), mpq_class(1000), mpq_class(999'999, 1000),
        mpq_class(1, 1'000'003), mpq_class(mpq_class(1, 7) / mpz_class("1" + std::string(100, '0')))}) {
    const SquaredSinh s = squared_sinh(x);
    const mpq_class value = precise_squared_sinh(x);
    const mpz_class scale = mpz_class(1) << s.k;
    EXPECT_LE(mpq_class(s.lower, scale), value) << x;
    EXPECT_GE(mpq_class(s.upper, scale), value) << x;
    EXPECT_LT(mpz_class(s.upper - s.lower) << 200, s.upper) << x;
    // Numbers beside it.
    const mpq_class below = value * mpq_class(999, 1000);
    const mpq_class above = value * mpq_class(1001, 1000);
    EXPECT_EQ(is_less(below.get_num(), below.get_den(), s), Answer::yes) << x;
    EXPECT_EQ(is_less(above.get_num(), above.get_den(), s), Answer::no) << x;
    EXPECT_EQ(is_less(value.get_num(), value.get_den(), s), Answer::unknown) << x;
    EXPECT_EQ(is_less(mpz_class(0), mpz_class(1), s), Answer::yes) << x;
    // Not positive: the radius of no circle.
    for (const int denominator : {0, -1}) EXPECT_EQ(is_less(mpz_class(1), mpz_class(denominator), s), Answer::no) << x;
  }
  EXPECT_EQ(is_less(mpz_class(0), mpz_class(1), squared_sinh(0)), Answer::no);
  EXPECT_EQ(is_less(mpz_class(1), mpz_class(1'000'000), squared_sinh(0)), Answer::no);
  EXPECT_THROW((void)squared_sinh(1001), TooLarge);
  EXPECT_THROW((void)squared_sinh(mpq_class(1) / (mpz_class(1) << 100'000)), TooLarge);
}

/// All intervals with ends from −2 to 3, and their ends.
struct Ends {
  long lower, upper;
};
std::vector<Ends> small_intervals() {
  std::vector<Ends> result;
  for (long a = -2; a <= 3; ++a) {
    for (long b = a; b <= 3; ++b) result.push_back({a, b});
  }
  return result;
}
Interval interval(const Ends& ends) { return {ends.lower, ends.upper, 0}; }

void expect_ends(const Interval& x, double lower, double upper) {
  EXPECT_NEAR(x.lower(), lower, 1e-15);
  EXPECT_NEAR(x.upper(), upper, 1e-15);
}

/// Neither less nor not less than anything.
void expect_nothing(const Interval& x) {
  for (const long n : {-1'000'000L, 0L, 1'000'000L}) {
    EXPECT_EQ(is_less(x, Interval(n)), Answer::unknown);
    EXPECT_EQ(is_less(Interval(n), x), Answer::unknown);
  }
}

TEST(SecondCheckersIntervals, OperationsAreThoseOfTheirEnds) {
  for (const Ends& a : small_intervals()) {
    const Interval x = interval(a);
    const double least =
        a.lower <= 0 && a.upper >= 0 ? 0 : static_cast<double>(std::min(a.lower * a.lower, a.upper * a.upper));
    expect_ends(square(x), least, static_cast<double>(std::max(a.lower * a.lower, a.upper * a.upper)));
    EXPECT_GE(square(x).lower(), 0);
    if (a.upper >= 0) {
      expect_ends(sqrt(x), std::sqrt(std::max(static_cast<double>(a.lower), 0.0)),
                  std::sqrt(static_cast<double>(a.upper)));
    }
    for (const Ends& b : small_intervals()) {
      const Interval y = interval(b);
      expect_ends(hull(x, y), static_cast<double>(std::min(a.lower, b.lower)),
                  static_cast<double>(std::max(a.upper, b.upper)));
      expect_ends(max(x, y), static_cast<double>(std::max(a.lower, b.lower)),
                  static_cast<double>(std::max(a.upper, b.upper)));
      EXPECT_EQ(is_less(x, y), a.upper < b.lower ? Answer::yes : a.lower >= b.upper ? Answer::no : Answer::unknown);
      if (b.lower <= 0 && b.upper >= 0) {
        expect_nothing(x / y);
        continue;
      }
      std::array<double, 4> quotients{};
      for (std::size_t i = 0; i < 4; ++i) {
        quotients.at(i) =
            static_cast<double>(i % 2 == 0 ? a.lower : a.upper) / static_cast<double>(i < 2 ? b.lower : b.upper);
      }
      const auto [lower, upper] = std::minmax_element(quotients.begin(), quotients.end());
      expect_ends(x / y, *lower, *upper);
    }
  }
}

TEST(SecondCheckersIntervals, FromWhatIsNotANumberNothingFollows) {
  const Interval nothing = Interval(1) / Interval(0);
  expect_nothing(nothing);
  expect_nothing(-nothing);
  expect_nothing(square(nothing));
  expect_nothing(power(nothing, 3));
  expect_nothing(sqrt(nothing));
  expect_nothing(sinh(nothing));
  expect_nothing(cosh(nothing));
  expect_nothing(arsinh(nothing));
  expect_nothing(arctan(nothing));
  expect_nothing(cos(nothing));
  expect_nothing(sin(nothing));
  expect_nothing(exp(nothing));
  expect_nothing(log(nothing));
  for (const Ends& ends : small_intervals()) {
    const Interval x = interval(ends);
    for (const Interval& result :
         {x + nothing, nothing + x, x - nothing, nothing - x, x * nothing, nothing * x, x / nothing, nothing / x,
          hull(x, nothing), hull(nothing, x), max(x, nothing), max(nothing, x)}) {
      expect_nothing(result);
    }
  }
}

}  // namespace
}  // namespace epsnet::exact::second_checkers_intervals_test
