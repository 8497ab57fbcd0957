#include "certify/numbers/two_rings.h"

#include <array>
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>
#include <gtest/gtest.h>
#include <numeric>
#include <rapidcheck/gtest.h>
#include <vector>

#include "tests/certify/biquadratic.h"

/// Numbers of two rings compared: √2 is 2cos(2π/8), and the root of x² − 2.
namespace epsnet::certify::two_rings_test {
namespace {

const std::array<PowerOfZeta, 1> kThree{{{3, 0}}};

/// ℤ[ζ, s], ζ = e^{2πi/8}, s² = 3.
const RegularRing& ring() {
  static const RegularRing ring(8, kThree);
  return ring;
}

/// ℤ[α, i], α² = 2, α > 0.
const NumberField& field() {
  static const NumberField field({-2, 0, 1}, {mpq_class(1), mpq_class(2)});
  return field;
}

/// a + b√2.
RegularNumber in_ring(const mpz_class& a, const mpz_class& b) {
  const std::array<PowerOfZeta, 2> root{{{1, 1}, {1, -1}}};
  return a * regular_number(ring(), Gaussian{1, 0}) + b * regular_number(ring(), root, {});
}
FieldNumber in_field(const mpz_class& a, const mpz_class& b) {
  return field_number(field(), std::vector<mpz_class>{a, b});
}

std::optional<bool> agree(const RegularNumber& x, const FieldNumber& y, const RegularNumber& other_x,
                          const FieldNumber& other_y) {
  return products_agree(ProductPair<RegularNumber, FieldNumber>{x, y, other_x, other_y}, {});
}

mpz_class power(unsigned long base, unsigned long exponent) {
  mpz_class result;
  mpz_ui_pow_ui(result.get_mpz_t(), base, exponent);
  return result;
}

/// Integers x_i, about 2^bits, for which Σ x_i numbers_i is about 2^(−bits (n − 1)), as small as it can be.
std::vector<mpz_class> small_combination(const std::vector<Ball>& numbers, slong bits) {
  const auto n = static_cast<slong>(numbers.size());
  fmpz_mat_t basis;
  fmpz_mat_init(basis, n, n + 1);
  for (slong i = 0; i < n; ++i) {
    fmpz_one(fmpz_mat_entry(basis, i, i));
    const Ball scaled_number = scaled(numbers[static_cast<std::size_t>(i)], bits * n);
    arf_get_fmpz(fmpz_mat_entry(basis, i, n), arb_midref(scaled_number.get()), ARF_RND_NEAR);
  }
  fmpz_lll_t lll;
  fmpz_lll_context_init_default(lll);
  fmpz_lll(basis, nullptr, lll);
  std::vector<mpz_class> result(numbers.size());
  for (slong i = 0; i < n; ++i)
    fmpz_get_mpz(result[static_cast<std::size_t>(i)].get_mpz_t(), fmpz_mat_entry(basis, 0, i));
  fmpz_mat_clear(basis);
  return result;
}

RC_GTEST_PROP(TwoRings, ProductsAgreeExactlyIfTheyAreEqual, (short a, short b, short c, short d)) {
  // (a + b√2)(c + d√2) = (c + d√2)(a + b√2), and not (c + d√2)(a + b√2 + 1) unless c = d = 0.
  RC_ASSERT(agree(in_ring(a, b), in_field(c, d), in_ring(c, d), in_field(a, b)) == true);
  RC_ASSERT(agree(in_ring(a, b), in_field(c, d), in_ring(c, d), in_field(a + 1, b)) == (c == 0 && d == 0));
}

TEST(TwoRings, NumbersThatAreCloseAreToldApart) {
  // (√2 − 1)ⁿ = p − q√2 is not 0, but as small as numbers of this size can be.
  mpz_class p = 1;
  mpz_class q = 0;
  for (int n = 1; n < 400; ++n) {
    const mpz_class last = p;
    p = p + 2 * q;
    q = last + q;
    EXPECT_EQ(agree(in_ring(p, 0), in_field(1, 0), in_ring(q, 0), in_field(0, 1)), false) << n;
    EXPECT_EQ(agree(in_ring(1, 0), in_field(p, 0), in_ring(0, 1), in_field(q, 0)), false) << n;
    EXPECT_EQ(agree(in_ring(0, q), in_field(1, 0), in_ring(1, 0), in_field(0, q)), true) << n;
  }
}

TEST(TwoRings, NumbersMayBeMuchCloserThanTheirConjugatesAreLarge) {
  // A unit of which the other three conjugates are all large: the product of all is 1.
  const std::array<PowerOfZeta, 1> one{{{1, 0}}};
  const RegularNumber root_of_three = regular_number(ring(), {}, one);
  const RegularNumber first = in_ring(-1, 1);
  const RegularNumber second = root_of_three - in_ring(0, 1);
  const RegularNumber third = in_ring(2, 0) - root_of_three;
  const RegularNumber unit = first * first * first * second * second * third * third;
  RegularNumber small = in_ring(1, 0);
  for (int n = 1; n < 40; ++n) {
    small = small * unit;
    EXPECT_EQ(agree(small + in_ring(1, 0), in_field(1, 0), in_ring(1, 0), in_field(1, 0)), false) << n;
    EXPECT_EQ(products_agree(ProductPair<RegularNumber, mpz_class>{in_ring(1, 0), 1, small + in_ring(1, 0), 1}, {}),
              false)
        << n;
  }
}

TEST(TwoRings, TheDegreeIsThatOfBothFieldsTogether) {
  // x₀ + x₁√2 = −(x₂ + x₃√2)√5, but for the small number.
  const NumberField five({-5, 0, 1}, {mpq_class(2), mpq_class(3)});
  const FieldNumber one = field_number(five, std::vector<mpz_class>{1});
  const FieldNumber root = field_number(five, std::vector<mpz_class>{0, 1});
  for (const auto& x : biquadratic::powers_with_five(15)) {
    EXPECT_EQ(products_agree(
                  ProductPair<FieldNumber, FieldNumber>{in_field(x[2], x[3]), root, in_field(-x[0], -x[1]), one}, {}),
              false);
  }
}

/// Two roots of x³ − 4x − 1, which together make a field of degree 6: x₀ + x₁α + x₂α² = −x₃β − x₄β², nearly.
TEST(TwoRings, TheDegreeIsThatOfTwoRootsOfOnePolynomialTogether) {
  const std::vector<mpz_class> f{-1, -4, 0, 1};
  const NumberField first(f, {mpq_class(2), mpq_class(3)});
  const NumberField second(f, {mpq_class(-1), mpq_class(0)});
  const auto number = [](const NumberField& field, const std::vector<mpz_class>& x) { return field_number(field, x); };
  const Precision scope(1000);
  const std::vector<Ball> numbers{Ball::exactly(1), value(number(first, {0, 1})), value(number(first, {0, 0, 1})),
                                  value(number(second, {0, 1})), value(number(second, {0, 0, 1}))};
  for (const slong bits : {20, 35, 50}) {
    const auto x = small_combination(numbers, bits);
    EXPECT_EQ(
        products_agree(ProductPair<FieldNumber, FieldNumber>{number(first, {x[0], x[1], x[2]}), number(second, {1}),
                                                             number(first, {1}), number(second, {0, -x[3], -x[4]})},
                       {}),
        false);
  }
  // The roots of x² − 2 and of x² − 3 between 1 and 2.
  const NumberField three({-3, 0, 1}, {mpq_class(1), mpq_class(2)});
  for (const auto& x : biquadratic::powers_with_three(15)) {
    EXPECT_EQ(products_agree(ProductPair<FieldNumber, FieldNumber>{in_field(x[2], x[3]), number(three, {0, 1}),
                                                                   in_field(-x[0], -x[1]), number(three, {1})},
                             {}),
              false);
  }
}

/// x + yr = (z + w√2)t, nearly, r and t the roots of 3 and of 5: a field of degree 8.
TEST(TwoRings, TheDegreeIsThatOfBothRootsTogether) {
  const RegularRing other(8, std::array<PowerOfZeta, 1>{{{5, 0}}});
  const std::array<PowerOfZeta, 1> one{{{1, 0}}};
  const std::array<PowerOfZeta, 2> two{{{1, 1}, {1, -1}}};
  const RegularNumber unit = in_ring(1, 0);
  const RegularNumber r = regular_number(ring(), {}, one);
  const RegularNumber t = regular_number(other, {}, one);
  const RegularNumber t_two = regular_number(other, {}, two);
  const RegularNumber other_unit = regular_number(other, one, {});
  const RegularNumber zero = other_unit - other_unit;
  const Precision scope(1000);
  const std::vector<Ball> numbers{value(unit), value(in_ring(0, 1)), value(r), value(in_ring(0, 1) * r),
                                  value(t),    value(t_two)};
  for (const slong bits : {20, 30}) {
    const auto x = small_combination(numbers, bits);
    const RegularNumber left = in_ring(x[0], x[1]) + in_ring(x[2], x[3]) * r;
    const RegularNumber right = mpz_class(-x[4]) * t - x[5] * t_two;
    EXPECT_EQ(products_agree(ProductPair<RegularNumber, RegularNumber>{left, other_unit, unit, right}, {}), false);
    EXPECT_EQ(products_agree(ProductPair<RegularNumber, RegularNumber>{right, unit, other_unit, left}, {}), false);
    EXPECT_EQ(products_agree(ProductPair<RegularNumber, RegularNumber>{left, zero, unit, zero}, {}), true);
  }
}

/// x + yr = zt, nearly, r the root of 3 in a ring and t that of 5 in a field.
TEST(TwoRings, TheDegreeIsThatOfRingAndFieldTogether) {
  const RegularRing four(4, kThree);
  const NumberField five({-5, 0, 1}, {mpq_class(2), mpq_class(3)});
  const RegularNumber unit = regular_number(four, Gaussian{1, 0});
  const RegularNumber r = regular_number(four, {}, std::array<PowerOfZeta, 1>{{{1, 0}}});
  const auto of_t = [&](const mpz_class& x, const mpz_class& y) {
    return field_number(five, std::vector<mpz_class>{x, y});
  };
  const Precision scope(1000);
  for (const slong bits : {20, 80}) {
    const auto x = small_combination({value(unit), value(r), value(of_t(0, 1))}, bits);
    EXPECT_EQ(
        products_agree(
            ProductPair<RegularNumber, FieldNumber>{x[0] * unit + x[1] * r, of_t(1, 0), unit, of_t(0, -x[2])}, {}),
        false);
  }
}

/// x + y√2 = (z + w√2)r, nearly, r the root of 3, which only one of the two sides has.
TEST(TwoRings, TheDegreeIsThatOfBothSides) {
  const std::array<PowerOfZeta, 1> one{{{1, 0}}};
  const RegularNumber r = regular_number(ring(), {}, one);
  const Precision scope(1000);
  const std::vector<Ball> numbers{Ball::exactly(1), value(in_ring(0, 1)), value(r), value(in_ring(0, 1) * r)};
  for (const slong bits : {20, 60}) {
    const auto x = small_combination(numbers, bits);
    const RegularNumber left = in_ring(x[0], x[1]);
    const RegularNumber right = in_ring(-x[2], -x[3]) * r;
    EXPECT_EQ(products_agree(ProductPair<RegularNumber, mpz_class>{left, 1, right, 1}, {}), false);
    EXPECT_EQ(products_agree(ProductPair<RegularNumber, mpz_class>{right, 1, left, 1}, {}), false);
    EXPECT_EQ(products_agree(ProductPair<mpz_class, RegularNumber>{1, left, 1, right}, {}), false);
    EXPECT_EQ(products_agree(ProductPair<mpz_class, RegularNumber>{1, right, 1, left}, {}), false);
  }
}

/// Of ProductPairs of which one product is 0, the bound is that of the other: (√2 − 1)ⁿ is not 0.
TEST(TwoRings, OnlyProductsOfZeroAreZero) {
  const FieldNumber zero = in_field(0, 0);
  mpz_class p = 1;
  mpz_class q = 0;
  for (int n = 1; n < 100; ++n) {
    const mpz_class last = p;
    p = -p + 2 * q;
    q = last - q;
    const FieldNumber small = in_field(p, q);
    for (const mpz_class& factor : {mpz_class(1), mpz_class(-5)}) {
      EXPECT_EQ(products_agree(ProductPair<mpz_class, FieldNumber>{factor, small, 0, zero}, {}), false);
      EXPECT_EQ(products_agree(ProductPair<mpz_class, FieldNumber>{0, zero, factor, small}, {}), false);
      EXPECT_EQ(products_agree(ProductPair<FieldNumber, mpz_class>{small, factor, zero, 0}, {}), false);
      EXPECT_EQ(products_agree(ProductPair<FieldNumber, mpz_class>{zero, 0, small, factor}, {}), false);
      EXPECT_EQ(products_agree(ProductPair<FieldNumber, mpz_class>{zero, factor, small, 0}, {}), true);
    }
  }
}

/// A ball around 0 says that a number is 0 only if none of its other points may be one: 2^−10 may, not less.
TEST(TwoRings, WhatMayBeTheLeastNumberIsNotZero) {
  const auto around_zero = [](double radius) {
    Ball result;
    mag_set_d(arb_radref(result.get()), radius);
    return result;
  };
  int calls = 0;
  EXPECT_EQ(is_zero(2, 10, [&] { return ++calls == 1 ? around_zero(0x1.8p-10) : Ball::exactly(0x1p-10); }), false);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(is_zero(2, 10, [&] { return around_zero(0x1.8p-11); }), true);
  EXPECT_EQ(is_zero(3, 10, [&] { return around_zero(0x1p-15); }), std::nullopt);
}

TEST(TwoRings, TheDegreeIsThatOfAllRootsOfUnityTogether) {
  // √2 is in the ring of order 8, √3 in that of order 12, and both are in that of order 24, of degree 4.
  const RegularRing twelve(12, kThree);
  const std::array<PowerOfZeta, 2> root{{{1, 1}, {1, -1}}};
  const RegularNumber one = regular_number(twelve, Gaussian{1, 0});
  const RegularNumber root_of_three = regular_number(twelve, root, {});
  for (const auto& x : biquadratic::powers_with_three(15)) {
    EXPECT_EQ(products_agree(ProductPair<RegularNumber, RegularNumber>{in_ring(x[2], x[3]), root_of_three,
                                                                       in_ring(-x[0], -x[1]), one},
                             {}),
              false);
  }
}

TEST(TwoRings, OtherConjugatesDoNotCount) {
  // √2 and −√2 are conjugates; so are √3 and −√3.
  EXPECT_EQ(agree(in_ring(0, 1), in_field(1, 0), in_ring(1, 0), in_field(0, 1)), true);
  EXPECT_EQ(agree(in_ring(0, 1), in_field(1, 0), in_ring(1, 0), in_field(0, -1)), false);
  const std::array<PowerOfZeta, 1> one{{{1, 0}}};
  const RegularNumber s = regular_number(ring(), {}, one);
  EXPECT_EQ(agree(s, in_field(1, 0), s, in_field(-1, 0)), false);
  EXPECT_EQ(agree(norm(s), in_field(1, 0), in_ring(1, 0), in_field(3, 0)), true);
}

TEST(TwoRings, IntegersAreComparedAsTheyAre) {
  const auto agree_integers = [](const mpz_class& x, const FieldNumber& y, const mpz_class& z, const FieldNumber& w) {
    return products_agree(ProductPair<mpz_class, FieldNumber>{x, y, z, w}, {});
  };
  const mpz_class large = power(7, 300);
  EXPECT_EQ(agree_integers(large, in_field(0, 1), 1, in_field(0, large)), true);
  EXPECT_EQ(agree_integers(large, in_field(0, 1), 1, in_field(1, large)), false);
  EXPECT_EQ(agree_integers(2, in_field(0, 1), 1, in_field(3, 0)), false);
}

TEST(TwoRings, BoundsHoldForAllConjugates) {
  // Of 1000 − 700√2, small itself, the conjugate is 1990.
  EXPECT_GE(real_number(in_ring(1000, -700)).bits, 11U);
  EXPECT_GE(real_number(in_field(1000, -700)).bits, 11U);
  // x³ − 1000x − 1 has roots near ±31.6 beside the one near −0.001, the square of which is of a polynomial of degree 2.
  const NumberField cubic({-1, -1000, 0, 1}, {mpq_class(-1), mpq_class(0)});
  EXPECT_GE(real_number(field_number(cubic, std::vector<mpz_class>{0, 0, 1})).bits, 10U);
  EXPECT_EQ(real_number(field_number(cubic, std::vector<mpz_class>{0, 0, 1})).degree, 3U);
  // x⁹ − Σ (4^i − 1) x^(9−i) has a root near 8, whose eighth power has 24 bits.
  std::vector<mpz_class> coefficients(10);
  coefficients[9] = 1;
  for (unsigned long i = 1; i <= 9; ++i) coefficients[9 - i] = 1 - power(4, i);
  const NumberField ninth(coefficients, {mpq_class(7), mpq_class(8)});
  std::vector<mpz_class> eighth_power(9);
  eighth_power[8] = 1;
  EXPECT_GE(real_number(field_number(ninth, eighth_power)).bits, 24U);
  // 1 − 2^(ik + i − 1) for 1 − 4^i: a root near 3·2^k.
  for (const unsigned long k : {0UL, 1UL, 5UL}) {
    for (unsigned long i = 1; i <= 9; ++i) coefficients[9 - i] = 1 - power(2, i * k + i - 1);
    const NumberField field(coefficients, {mpq_class(power(2, k + 1)), mpq_class(power(2, k + 2))});
    EXPECT_GE(real_number(field_number(field, eighth_power)).bits, 8 * (k + 1) + 4);
  }
  // The square of s is 1000003.
  const RegularRing large(8, std::array<PowerOfZeta, 1>{{{1'000'003, 0}}});
  EXPECT_GE(real_number(regular_number(large, {}, std::array<PowerOfZeta, 1>{{{1, 0}}})).bits, 10U);
}

TEST(TwoRings, DegreesAreThoseOfRealNumbers) {
  EXPECT_EQ(real_number(mpz_class(1)).degree, 1U);
  EXPECT_EQ(real_number(in_ring(1, 1)).order, 8U);
  EXPECT_EQ(real_number(in_ring(1, 1)).degree, 1U);
  EXPECT_EQ(real_number(regular_number(ring(), {}, std::array<PowerOfZeta, 1>{{{1, 0}}})).degree, 2U);
  EXPECT_EQ(real_number(in_field(1, 1)).degree, 2U);
  // Of the cosines of 2πk/n, k ≤ n/2 without a common divisor.
  for (std::uint64_t n = 1; n < 100; ++n) {
    std::uint64_t conjugates = 0;
    for (std::uint64_t k = 1; k <= std::max<std::uint64_t>(n / 2, 1); ++k) conjugates += std::gcd(k, n) == 1 ? 1 : 0;
    EXPECT_EQ(cyclotomic_degree(n), conjugates) << n;
  }
}

TEST(TwoRings, WhatTakesTooManyBitsIsOpen) {
  const mpz_class large = power(2, 1UL << 19);
  EXPECT_EQ(agree(in_ring(large, 0), in_field(1, 0), in_ring(1, 0), in_field(large, 0)), std::nullopt);
}

TEST(TwoRings, WorkIsPaidFor) {
  const Budget budget(1000);
  EXPECT_THROW((void)products_agree(ProductPair<RegularNumber, FieldNumber>{in_ring(0, 1), in_field(1, 0),
                                                                            in_ring(1, 0), in_field(0, 1)},
                                    budget),
               BudgetSpent);
}

}  // namespace
}  // namespace epsnet::certify::two_rings_test
