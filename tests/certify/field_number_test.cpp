#include "certify/numbers/field_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <rapidcheck/gtest.h>
#include <string>
#include <utility>
#include <vector>

/// The numbers of surfaces over a number field.
namespace epsnet::certify::field_number_test {
namespace {

using Coefficients = std::vector<mpz_class>;

/// A polynomial, an interval with its root α, and α.
struct Root {
  Coefficients f;
  mpq_class lower;
  mpq_class upper;
  double alpha;
};

/// √2; the root of x³ − x − 1; √2 + √3; √2 as a root of (x² − 2)(x² − 3); −√3 as one of those; 2 cos(2π/7).
const std::vector<Root> kRoots{{{-2, 0, 1}, 1, 2, std::sqrt(2)},
                               {{-1, -1, 0, 1}, 1, 2, 1.3247179572447460},
                               {{1, 0, -10, 0, 1}, 3, 4, std::sqrt(2) + std::sqrt(3)},
                               {{6, 0, -5, 0, 1}, 1, {3, 2}, std::sqrt(2)},
                               {{6, 0, -5, 0, 1}, -2, {-3, 2}, -std::sqrt(3)},
                               {{-1, -2, 1, 1}, 1, 2, 2 * std::cos(2 * M_PI / 7)}};

double value_of(const Coefficients& x, double alpha) {
  double result = 0;
  for (std::size_t i = x.size(); i-- > 0;) result = result * alpha + x[i].get_d();
  return result;
}

Coefficients coefficients(const std::vector<int>& x) { return {x.begin(), x.end()}; }

TEST(NumberFields, KnowTheirRootToAnyPrecision) {
  for (const Root& root : kRoots) {
    const NumberField field(root.f, {root.lower, root.upper});
    for (const slong bits : {53, 200, 5000}) {
      const Precision scope(bits);
      const Ball alpha = real_ball(field_number(field, Coefficients{0, 1}));
      EXPECT_NEAR(lower_end(alpha), root.alpha, 1e-14);
      EXPECT_LT(mag_cmp_2exp_si(arb_radref(alpha.get()), 8 - bits), 0);
      // f(α) = 0, in balls.
      Ball value;
      for (std::size_t i = root.f.size(); i-- > 0;) value = value * alpha + Ball::rounded(root.f[i]);
      EXPECT_EQ(certain_sign(value), 0);
    }
  }
}

TEST(NumberFields, KnowALargeRootOfLargeCoefficients) {
  const mpz_class scale("1" + std::string(300, '0'));
  for (const slong bits : {53, 200, 5000}) {
    const NumberField field({-2 * scale * scale, 0, 1}, {scale, 2 * scale}, Budget(100'000'000));
    const Precision scope(bits);
    const Ball alpha = real_ball(field_number(field, Coefficients{0, 1})) / Ball::rounded(scale);
    EXPECT_NEAR(lower_end(alpha), std::sqrt(2), 1e-15);
    EXPECT_LT(mag_cmp_2exp_si(arb_radref(alpha.get()), 8 - bits), 0);
  }
}

/// A root that is an integer of more bits than the first enclosure has: bisection meets it at once.
TEST(NumberFields, KnowAnIntegerThatIsARoot) {
  const mpz_class near = mpz_class(1) << 300;
  for (const mpz_class& root : {mpz_class(near + 1), mpz_class(-near - 1)}) {
    const NumberField field({-root, 1}, {mpq_class(root - 1), mpq_class(root + 1)});
    const Precision scope(53);
    EXPECT_EQ(sign(field_number(field, Coefficients{mpz_class(-sgn(root) * near), 1})), sgn(root));
  }
}

/// x²⁰ = 2(10⁶x − 1)² at 10⁻⁶ ± 10⁻⁶⁶/√2, nearly: the derivative is 0 between the two.
TEST(NumberFields, KnowARootNextToAnother) {
  Coefficients f(21);
  f[0] = -2;
  f[1] = 4'000'000;
  f[2] = mpz_class("-2000000000000");
  f[20] = 1;
  const mpz_class scale("1" + std::string(66, '0'));
  const mpq_class middle(1, 1'000'000);
  for (const int side : {1, -1}) {
    const mpq_class end = middle + mpq_class(side, scale);
    const NumberField field(f, {std::min(middle, end), std::max(middle, end)}, Budget(1'000'000'000));
    const Precision scope(64);
    const FieldNumber distance = field_number(field, Coefficients{mpz_class(-scale / 1'000'000), scale});
    EXPECT_NEAR(lower_end(real_ball(distance)), side * std::sqrt(0.5), 1e-12);
    EXPECT_EQ(sign(distance), side);
  }
}

RC_GTEST_PROP(NumberFields, HaveSumsProductsAndSigns, ()) {
  const Root& root = kRoots[*rc::gen::inRange<std::size_t>(0, kRoots.size())];
  const NumberField field(root.f, {root.lower, root.upper});
  const auto some = [&] {
    return coefficients(*rc::gen::container<std::vector<int>>(field.degree(), rc::gen::inRange(-50, 51)));
  };
  const Coefficients a = some();
  const Coefficients b = some();
  const double x = value_of(a, root.alpha);
  const double y = value_of(b, root.alpha);
  const FieldNumber z = field_number(field, a) + Gaussian{0, 1} * field_number(field, b);
  const Precision scope(64);
  const auto near = [](const FieldNumber& found, double expected) {
    RC_ASSERT(std::abs(lower_end(real_ball(found)) - expected) <= 1e-9 * (1 + std::abs(expected)));
  };
  near(norm(z), x * x + y * y);
  near(twice_real(z), 2 * x);
  near(twice_imaginary(z), 2 * y);
  near(twice_real(z * z), 2 * (x * x - y * y));
  near(twice_imaginary(z * z), 4 * x * y);
  near(twice_imaginary(conjugate(z)), -2 * y);
  RC_ASSERT(sign(norm(z) - norm(conjugate(z))) == 0);
  // By a Gaussian integer, which is a number of the field.
  const Gaussian factor{*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10)};
  const FieldNumber zero = factor * z - field_number(field, factor) * z;
  RC_ASSERT(sign(zero) == 0 && sign(twice_imaginary(zero)) == 0);
  // Degrees are less than that of the field.
  const FieldNumber power = z * z * z;
  for (const Polynomial* part : {&power.re, &power.im})
    RC_ASSERT(fmpz_poly_length(part->get()) <= static_cast<slong>(field.degree()));
  if (std::abs(x) > 1e-9) RC_ASSERT(sign(field_number(field, a)) == (x > 0 ? 1 : -1));
}

TEST(NumberFields, TellZeroFromWhatIsNear) {
  // The same polynomials at the roots √2 and −√3 of (x² − 2)(x² − 3).
  const NumberField two(kRoots[3].f, {kRoots[3].lower, kRoots[3].upper});
  const NumberField three(kRoots[4].f, {kRoots[4].lower, kRoots[4].upper});
  const Coefficients square_minus_two{-2, 0, 1};
  EXPECT_EQ(sign(field_number(two, square_minus_two)), 0);
  EXPECT_EQ(sign(field_number(three, square_minus_two)), 1);
  // √2 less or more a convergent of its continued fraction: |p − q√2| < 1/q.
  mpz_class p = 1;
  mpz_class q = 1;
  for (int i = 0; i < 300; ++i) {
    const mpz_class next = p + 2 * q;
    q = p + q;
    p = next;
    EXPECT_EQ(sign(field_number(two, Coefficients{p, -q})), i % 2 == 0 ? 1 : -1);
  }
}

/// Powers of 1/α, α³ = α + 1, as polynomials in α: their other conjugates are large, so nothing else that is not 0 is
/// as small, and more bits are needed than at first.
TEST(NumberFields, TellNumbersThatAreAsSmallAsCanBeFromZero) {
  const NumberField field({-1, -1, 0, 1}, {1, 2});
  const FieldNumber alpha = field_number(field, Coefficients{0, 1});
  const FieldNumber one = field_number(field, Coefficients{1});
  FieldNumber small = alpha * alpha - one;
  FieldNumber large = alpha;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(sign(small), 1) << i;
    EXPECT_EQ(sign(mpz_class(-1) * small), -1) << i;
    EXPECT_EQ(sign(small * large - one), 0) << i;
    small = small * small;
    large = large * large;
  }
}

/// The coefficients of (1 + x)^d f((L + Ux)/(1 + x)) = Σ f_i (L + Ux)^i (1 + x)^(d − i), as rational numbers.
std::vector<mpq_class> moved(const Coefficients& f, const mpq_class& lower, const mpq_class& upper) {
  std::vector<mpq_class> result(f.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    std::vector<mpq_class> term{mpq_class(f[i])};
    for (std::size_t k = 1; k < f.size(); ++k) {
      const auto& [constant, linear] = k <= i ? std::pair(lower, upper) : std::pair(mpq_class(1), mpq_class(1));
      std::vector<mpq_class> product(term.size() + 1);
      for (std::size_t j = 0; j < term.size(); ++j) {
        product[j] += constant * term[j];
        product[j + 1] += linear * term[j];
      }
      term = std::move(product);
    }
    for (std::size_t j = 0; j < f.size(); ++j) result[j] += term[j];
  }
  return result;
}

RC_GTEST_PROP(NumberFields, CountChangesOfSign, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(1, 8);
  const Coefficients f = coefficients(*rc::gen::container<std::vector<int>>(size, rc::gen::inRange(-20, 21)));
  const auto some = [] { return mpq_class(*rc::gen::inRange(-30, 31), *rc::gen::inRange(1, 10)); };
  mpq_class lower = some();
  mpq_class upper = some();
  lower.canonicalize();
  upper.canonicalize();
  unsigned changes = 0;
  int first = 0;
  int last = 0;
  for (const mpq_class& c : moved(f, lower, upper)) {
    if (sgn(c) == 0) continue;
    if (first == 0) first = sgn(c);
    if (last == -sgn(c)) ++changes;
    last = sgn(c);
  }
  const RootCount count = count_roots(f, lower, upper);
  RC_ASSERT(count.changes == changes);
  RC_ASSERT(count.first_sign == first);
}

TEST(NumberFields, CountRootsByDescartesRule) {
  const Coefficients f{6, 0, -5, 0, 1};
  EXPECT_EQ(count_roots(f, 1, {3, 2}).changes, 1U);
  EXPECT_EQ(count_roots(f, 1, {3, 2}).first_sign, 1);
  EXPECT_EQ(count_roots(f, {3, 2}, 2).changes, 1U);
  EXPECT_EQ(count_roots(f, {3, 2}, 2).first_sign, -1);
  EXPECT_EQ(count_roots(f, 1, 2).changes, 2U);
  EXPECT_EQ(count_roots(f, 2, 3).changes, 0U);
  // A double root counts twice, and one at an end does not count.
  EXPECT_EQ(count_roots({1, -2, 1}, 0, 3).changes, 2U);
  EXPECT_EQ(count_roots({-2, 1}, 1, 2).changes, 0U);
  EXPECT_EQ(count_roots({-2, 1}, 2, 3).changes, 0U);
  EXPECT_EQ(count_roots({-4, 6, 0, -3, 1}, 1, 2).changes, 1U);
}

TEST(NumberFields, OfARootBesideAnotherOneAtAnEndAreThoseOfTheRoot) {
  // (x − 1)(x − 2)(x² − 2).
  const NumberField field({-4, 6, 0, -3, 1}, {1, 2});
  EXPECT_EQ(sign(field_number(field, Coefficients{-2, 0, 1})), 0);
}

TEST(NumberFields, MakeIsometriesOfDeterminant1) {
  const NumberField field({-2, 0, 1}, {1, 2});
  // a = 6 + 4√2, b = 2 + 2√2 i; |a|² − |b|² = 56 + 48√2.
  Isometry<FieldNumber> f{
      field_number(field, Coefficients{6, 4}),
      field_number(field, Coefficients{2}) + Gaussian{0, 2} * field_number(field, Coefficients{0, 1})};
  EXPECT_EQ(sign(determinant(f) - field_number(field, Coefficients{56, 48})), 0);
  reduce(f);
  EXPECT_EQ(sign(f.a - field_number(field, Coefficients{3, 2})), 0);
  const BallIsometry value = to_balls(f, determinant(f), 100);
  const Precision scope(100);
  EXPECT_TRUE(arb_contains_si((norm(value.a) - norm(value.b)).get(), 1));
  EXPECT_NEAR(lower_end(imaginary(value.b) / real(value.b)), std::sqrt(2), 1e-14);
  EXPECT_TRUE(is_identity(compose(f, inverse(f))));
  EXPECT_FALSE(is_identity(f));
}

/// Of the eight integers of an isometry over ℚ(√2) the greatest common divisor is taken out, whichever of them it
/// depends on, and nothing else.
TEST(NumberFields, ReduceIsometriesByTheCommonDivisor) {
  const NumberField field({-2, 0, 1}, {1, 2});
  for (std::size_t odd = 0; odd < 8; ++odd) {
    std::array<mpz_class, 8> n;
    for (std::size_t k = 0; k < 8; ++k) n[k] = k == odd ? 9 : 12;
    const auto number = [&](std::size_t k) {
      return field_number(field, Coefficients{n[k], n[k + 1]}) +
             Gaussian{0, 1} * field_number(field, Coefficients{n[k + 2], n[k + 3]});
    };
    Isometry<FieldNumber> f{number(0), number(4)};
    const auto is_third = [](const FieldNumber& x, const FieldNumber& third) {
      const FieldNumber rest = x - mpz_class(3) * third;
      return is_zero(rest.re) && is_zero(rest.im);
    };
    const Isometry<FieldNumber> before = f;
    for (int again = 0; again < 2; ++again) {
      reduce(f);
      EXPECT_TRUE(is_third(before.a, f.a) && is_third(before.b, f.b)) << odd;
    }
  }
}

// f/f₀ for f = f₀, and with one of the other three real coefficients not 0; reducible polynomials as well, where 0 is
// not only the polynomial 0.
TEST(NumberFields, TellTheIdentityFromIsometriesThatAreNear) {
  for (const Root& root : kRoots) {
    const NumberField field(root.f, {root.lower, root.upper});
    const FieldNumber scale = field_number(field, Coefficients{5, 3});
    const FieldNumber zero = field_number(field, root.f);
    EXPECT_TRUE(is_identity(Isometry<FieldNumber>{scale, zero}));
    EXPECT_TRUE(is_identity(Isometry<FieldNumber>{scale + Gaussian{0, 1} * zero, zero + Gaussian{0, 1} * zero}));
    const FieldNumber one = field_number(field, Gaussian{1, 0});
    const FieldNumber i = field_number(field, Gaussian{0, 1});
    for (const mpz_class& step : {mpz_class(1), mpz_class(-1)}) {
      EXPECT_FALSE(is_identity(Isometry<FieldNumber>{scale + step * i, zero}));
      EXPECT_FALSE(is_identity(Isometry<FieldNumber>{scale, step * one}));
      EXPECT_FALSE(is_identity(Isometry<FieldNumber>{scale, step * i}));
    }
  }
}

/// Compilers evaluate the two sides of an operation in either order, and threads ask in any.
TEST(NumberFields, TakeAsMuchWorkInAnyOrderOfQuestions) {
  const auto asked = [](std::vector<slong> precisions) {
    const NumberField field({-2, 0, 1}, {1, 2}, Budget(1'000'000'000));
    std::map<slong, std::string> values;
    for (const slong bits : precisions) {
      const Precision scope(bits);
      Polynomial alpha;
      fmpz_poly_set_coeff_si(alpha.get(), 1, 1);
      char* text = arb_dump_str(field.value(alpha).get());
      values[bits] = text;
      flint_free(text);
    }
    return std::pair(field.budget().left(), values);
  };
  EXPECT_EQ(asked({32, 40, 100, 500, 2000}), asked({2000, 500, 100, 40, 32}));
  EXPECT_EQ(asked({500, 32, 2000, 40, 100}), asked({100, 2000, 40, 32, 500}));
  EXPECT_LT(asked({2000}).first, asked({500}).first);
}

TEST(NumberFields, TakeTheirWorkOffTheBudget) {
  const NumberField field({-2, 0, 1}, {1, 2}, Budget(10'000));
  FieldNumber x = field_number(field, Coefficients{3, 7});
  EXPECT_THROW(
      {
        for (int i = 0; i < 30; ++i) x = x * x;
      },
      BudgetSpent);
}

/// x⁶⁴ = c_63 x⁶³ + … + c_0: of a product of small numbers, a remainder has 63 times as many bits as c.
TEST(NumberFields, CountRemaindersByTheBitsOfAllCoefficients) {
  const auto product = [](unsigned bits) {
    Coefficients f(65, -(mpz_class(1) << bits));
    f.back() = 1;
    const NumberField field(f, {1, (mpz_class(1) << bits) + 2}, Budget(400'000'000));
    return field_number(field, Coefficients(64, 5)) * field_number(field, Coefficients(64, 7));
  };
  EXPECT_NO_THROW(product(30));
  EXPECT_THROW(product(3000), BudgetSpent);
}

/// √2 as a root of (x² − 2)(x² − 3): that x² − 2 is 0 there is told by a greatest common divisor.
TEST(NumberFields, CountGreatestCommonDivisors) {
  const NumberField field({6, 0, -5, 0, 1}, {1, {3, 2}}, Budget(100'000'000));
  const FieldNumber zero =
      field_number(field, Coefficients{-2 * (mpz_class(1) << 100'000), 0, mpz_class(1) << 100'000});
  const std::uint64_t before = field.budget().left();
  EXPECT_EQ(sign(zero), 0);
  // Hundreds of products of that many bits.
  EXPECT_GT(before - field.budget().left(), 50'000'000);
}

}  // namespace
}  // namespace epsnet::certify::field_number_test
