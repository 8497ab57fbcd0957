#include "certify/numbers/two_rings.h"

#include <array>
#include <gtest/gtest.h>
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
  EXPECT_EQ(cyclotomic_degree(1), 1U);
  EXPECT_EQ(cyclotomic_degree(8), 2U);
  EXPECT_EQ(cyclotomic_degree(21), 6U);
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
