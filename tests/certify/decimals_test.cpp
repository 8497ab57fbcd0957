#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <initializer_list>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/claims/net/claim.h"
#include "certify/numbers/ball.h"

namespace epsnet::certify::decimals_test {
namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

mpq_class power_of_ten(long exponent) {
  mpz_class value;
  mpz_ui_pow_ui(value.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? mpq_class(1) / value : mpq_class(value);
}

/// The digits from the first that is not 0 to the last that is not.
std::size_t significant_digits(std::string text) {
  text.erase(std::min(text.find('e'), text.size()));
  std::erase_if(text, [](char c) { return c == '.' || c == '-'; });
  const std::size_t first = text.find_first_not_of('0');
  return first == std::string::npos ? 0 : text.find_last_not_of('0') + 1 - first;
}

/// 10^e ≤ x < 10^(e + 1).
long first_place(const mpq_class& x) {
  auto e = static_cast<long>(std::floor(std::log10(x.get_d())));
  while (power_of_ten(e + 1) <= x) ++e;
  while (power_of_ten(e) > x) --e;
  return e;
}

/// The greatest decimal of so many digits that is at most x > 0, straight from the definition.
mpq_class rounded_down(const mpq_class& x, long digits) {
  const mpq_class place = power_of_ten(first_place(x) - digits + 1);
  const mpq_class places = x / place;
  return mpz_class(places.get_num() / places.get_den()) * place;
}

mpq_class rounded_up(const mpq_class& x, long digits) {
  const mpq_class below = rounded_down(x, digits);
  return below == x ? x : mpq_class(below + power_of_ten(first_place(x) - digits + 1));
}

/// Whether the rational number reads as x: it is nearer to x than to the numbers beside it, or a tie and x is even.
bool reads_as(const mpq_class& value, double x) {
  const mpq_class magnitude = abs(value);
  const double to = std::fabs(x);
  const double next = std::nextafter(to, kInfinity);
  mpz_class overflow;
  mpz_ui_pow_ui(overflow.get_mpz_t(), 2, 1024);
  const mpq_class after = std::isinf(next) ? mpq_class(overflow) : mpq_class(next);
  const mpq_class lower = (mpq_class(to) + mpq_class(std::nextafter(to, 0.0))) / 2;
  const mpq_class upper = (mpq_class(to) + after) / 2;
  const bool even = (std::bit_cast<std::uint64_t>(to) & 1U) == 0;
  return even ? lower <= magnitude && magnitude <= upper : lower < magnitude && magnitude < upper;
}

/// What is wrong with the two decimals of x > 0, or of −x; nothing if they are as they are defined.
std::string problem(double x) {
  const mpq_class value(x);
  const mpq_class magnitude = abs(value);
  for (const bool down : {true, false}) {
    const std::string text = down ? decimal_below(x) : decimal_above(x);
    const auto found = parse_decimal(text);
    if (!found) return text + " is no decimal";
    if (down ? *found > value : *found < value) return text + " is on the wrong side";
    if (!reads_as(*found, x)) return text + " does not read back";
    if (parse_binary64(text) != x) return text + " is not read back";
    const std::size_t digits = significant_digits(text);
    if (digits > 18) return text + " is too long";
    const bool towards_zero = down == (x > 0);
    const auto of_length = [&](std::size_t n) {
      return towards_zero ? rounded_down(magnitude, static_cast<long>(n)) : rounded_up(magnitude, static_cast<long>(n));
    };
    if (abs(*found) != of_length(digits)) return text + " is not the nearest of its length";
    if (digits > 1 && reads_as(of_length(digits - 1), x)) return text + " is not the shortest";
  }
  return "";
}

TEST(Decimals, AreWhatTheyAreDefinedToBe) {
  std::vector<double> values{5e-324,
                             1e-323,
                             2.2250738585072009e-308,
                             2.2250738585072014e-308,
                             kMax,
                             0x1p53 - 1,
                             0x1p53,
                             0x1p53 + 2,
                             0.1,
                             0.3,
                             1.0 / 3,
                             1e21,
                             1e22,
                             1e23,
                             37.699111843077517,
                             0.37176624190819079};
  for (int k = -1074; k < 1024; ++k) values.push_back(std::ldexp(1.0, k));
  for (int k = -300; k <= 300; ++k) values.push_back(std::pow(10.0, k));
  for (const double value : std::vector<double>(values)) {
    values.push_back(std::nextafter(value, 0.0));
    if (value < kMax) values.push_back(std::nextafter(value, kInfinity));
  }
  for (const double value : values) {
    if (value == 0) continue;
    EXPECT_EQ(problem(value), "") << value;
    EXPECT_EQ(problem(-value), "") << -value;
  }
}

RC_GTEST_PROP(DecimalsProperty, AreWhatTheyAreDefinedToBe, ()) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  const auto exponent = *rc::gen::inRange<std::uint64_t>(0, 2047);
  constexpr std::uint64_t kExponent = std::uint64_t{0x7ff} << 52U;
  const auto value = std::bit_cast<double>((bits & ~kExponent) | (exponent << 52U));
  RC_PRE(value != 0);
  RC_ASSERT(problem(value) == "");
}

/// The sizes of the lengths that are printed.
RC_GTEST_PROP(DecimalsProperty, AreWhatTheyAreDefinedToBeForLengths, ()) {
  const auto bits = *rc::gen::arbitrary<std::uint64_t>();
  const double value = std::ldexp(static_cast<double>(bits % (std::uint64_t{1} << 53U) + 1),
                                  -static_cast<int>(*rc::gen::inRange(45, 60)));
  RC_ASSERT(problem(value) == "");
  RC_ASSERT(parse_decimal(decimal_below(value)).value() <= parse_decimal(decimal_above(value)).value());
}

/// Below 2^k the numbers are nearer to each other than above: the one case in which 17 digits may not be enough.
TEST(Decimals, SeventeenDigitsAreNotAlwaysEnough) {
  std::size_t most = 0;
  for (int k = -1022; k < 1024; ++k) most = std::max(most, significant_digits(decimal_below(std::ldexp(1.0, k))));
  EXPECT_EQ(most, 18U);
}

TEST(Decimals, OfGivenLengthAreTheNearest) {
  EXPECT_EQ(decimal_below(0.123456, 4), "0.1234");
  EXPECT_EQ(decimal_above(0.123456, 4), "0.1235");
  EXPECT_EQ(decimal_below(-0.123456, 4), "-0.1235");
  EXPECT_EQ(decimal_above(-0.123456, 4), "-0.1234");
  EXPECT_EQ(decimal_above(9.9996, 4), "10");
  EXPECT_EQ(decimal_above(1.01e-13, 2), "1.1e-13");
  EXPECT_EQ(decimal_below(0.25, 6), "0.25");
  EXPECT_EQ(decimal_above(0.25, 6), "0.25");
  EXPECT_EQ(decimal_below(123456, 2), "120000");
  for (int k = -60; k < 60; ++k) {
    const double x = std::ldexp(std::nextafter(1.0, 2.0), k);
    for (unsigned digits = 1; digits <= 20; ++digits) {
      EXPECT_EQ(parse_decimal(decimal_below(x, digits)), rounded_down(mpq_class(x), digits)) << x;
      EXPECT_EQ(parse_decimal(decimal_above(x, digits)), rounded_up(mpq_class(x), digits)) << x;
    }
  }
}

TEST(Decimals, WhatIsNoPositiveOrNegativeNumberIsAsBefore) {
  for (const double x : {0.0, -0.0, kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(decimal_below(x), shortest(x));
    EXPECT_EQ(decimal_above(x), shortest(x));
  }
  EXPECT_EQ(to_string(Interval{-kInfinity, 0}), "[-inf, 0]");
}

/// Numbers that are exact decimals, as those that people write, stay as they are.
TEST(Decimals, EndsThatAreShortDecimalsArePrintedExactly) {
  EXPECT_EQ(to_string(Interval{0.25, 3}), "[0.25, 3]");
  EXPECT_EQ(to_string(Interval{-1e22, 1e22}), "[-1e+22, 1e+22]");
}

/// The ends of "[lower, upper]" as the decimals that they are.
std::pair<mpq_class, mpq_class> printed_ends(const std::string& text) {
  const std::size_t comma = text.find(", ");
  return {parse_decimal(text.substr(1, comma - 1)).value(),
          parse_decimal(text.substr(comma + 2, text.size() - comma - 3)).value()};
}

/// Whether "[lower, upper]" contains the number, of which 1,000 bits are known, and is as narrow as it should be.
void expect_printed_around(arb_srcptr number, const std::string& text) {
  const auto [lower, upper] = printed_ends(text);
  ASSERT_GT(arb_rel_accuracy_bits(number), 950);
  const Precision scope(1000);
  EXPECT_TRUE(arb_le(Ball::rounded(lower).get(), number)) << text;
  EXPECT_TRUE(arb_ge(Ball::rounded(upper).get(), number)) << text;
  EXPECT_LE(mpq_class(upper - lower), mpq_class(upper * 0x1p-51)) << text;
}

/// 4π(g − 1), not 12π ≥ 37.69911184307752, which is wrong.
TEST(PrintedIntervals, ContainTheAreasOfAllGenera) {
  for (std::uint64_t genus = 2; genus <= 1000; ++genus) {
    Ball area;
    arb_const_pi(area.get(), 1000);
    arb_mul_ui(area.get(), area.get(), 4 * (genus - 1), 1000);
    SCOPED_TRACE(genus);
    expect_printed_around(area.get(), to_string(area_of(genus)));
  }
}

}  // namespace
}  // namespace epsnet::certify::decimals_test
