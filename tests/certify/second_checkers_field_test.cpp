#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <numbers>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "certify/exact/checker.h"
#include "certify/exact/document.h"
#include "certify/exact/json.h"
#include "certify/exact/net_rules.h"
#include "certify/exact/number_field.h"

/// The second checker's surfaces over a number field: their numbers, their files, and every clause of rule `surface`.
namespace epsnet::exact::second_checkers_field_test {
namespace {

void expect_near(const FieldNumber& x, double value) {
  const Interval found = enclosure(x);
  EXPECT_EQ(is_less(found, Interval(mpq_class(value - 1e-9))), Answer::no) << value;
  EXPECT_EQ(is_less(Interval(mpq_class(value + 1e-9)), found), Answer::no) << value;
  EXPECT_LE(found.upper() - found.lower(), 1e-15 * (1 + std::abs(value)));
}

/// C_n(2cos φ) = 2cos nφ: 2, x, x² − 2, …, C_(n+1) = x C_n − C_(n−1).
Polynomial twice_cosine(int n) {
  Polynomial before{2};
  Polynomial result{0, 1};
  for (int k = 1; k < n; ++k) {
    Polynomial next(result.size() + 1);
    for (std::size_t i = 0; i < result.size(); ++i) next[i + 1] = result[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = result;
    result = next;
  }
  return n == 0 ? Polynomial{2} : result;
}

/// The roots of C_n are 2cos((2k + 1)π/2n), of which this is between the largest, α, and the next one.
mpq_class below_largest_root(int n) { return 2 * std::cos(std::numbers::pi / n); }

/// C_n is reducible if n has an odd divisor.
TEST(SecondCheckersField, ProductsAreThoseOfCosines) {
  for (const int n : {2, 3, 4, 5, 9, 12, 15, 32, 45, 63, 64}) {
    SCOPED_TRACE(n);
    const NumberField field(twice_cosine(n), below_largest_root(n), 2);
    const FieldNumber alpha(field, {0, 1});
    std::vector<FieldNumber> cosines{2, alpha};
    while (cosines.size() < 4 * static_cast<std::size_t>(n) + 1) {
      cosines.push_back(alpha * cosines.back() - cosines[cosines.size() - 2]);
    }
    for (std::size_t k = 0; k < cosines.size(); k += 1 + cosines.size() / 20) {
      expect_near(cosines[k], 2 * std::cos(std::numbers::pi * static_cast<double>(k) / (2 * n)));
      for (std::size_t j = 0; j <= k && j + k < cosines.size(); j += 1 + k / 5) {
        EXPECT_EQ(sgn(cosines[j] * cosines[k] - cosines[k + j] - cosines[k - j]), 0);
        EXPECT_EQ(sgn(cosines[j] * cosines[k] - cosines[k + j] - cosines[k - j] + 1), 1);
      }
    }
    EXPECT_EQ(sgn(cosines[4 * static_cast<std::size_t>(n)] - 2), 0);
    EXPECT_EQ(sgn(cosines[static_cast<std::size_t>(n)]), 0);
    EXPECT_EQ(sgn(cosines[static_cast<std::size_t>(n) - 1]), 1);
    EXPECT_EQ(sgn(cosines[static_cast<std::size_t>(n) + 1]), -1);
  }
}

TEST(SecondCheckersField, RootsInASum) {
  const NumberField field({121, 0, -30, 0, 1}, 5, 6);  // √2 + √13
  const FieldNumber alpha(field, {0, 1});
  expect_near(alpha, std::sqrt(2) + std::sqrt(13));
  const FieldNumber root2 = FieldNumber(field, {0, -19, 0, 1});  // 22√2
  expect_near(root2, 22 * std::sqrt(2));
  EXPECT_EQ(sgn(root2 * root2 - 968), 0);
  EXPECT_EQ(sgn(22 * alpha - root2 - FieldNumber(field, {0, 41, 0, -1})), 0);  // 22√13
  EXPECT_EQ(sgn(root2 - 31), 1);
  EXPECT_EQ(sgn(root2 - 32), -1);
}

TEST(SecondCheckersField, APolynomialThatIsReducible) {
  for (const bool first : {true, false}) {
    const NumberField field({6, 0, -5, 0, 1}, 1, mpq_class(3, 2));  // (x² − 2)(x² − 3) at √2
    const FieldNumber alpha(field, {0, 1});
    // Whichever factor is asked first.
    if (first) {
      EXPECT_EQ(sgn(FieldNumber(field, {-3, 0, 1})), -1);
      EXPECT_FALSE(field.is_zero({-3, 0, 1}));
    }
    EXPECT_EQ(sgn(FieldNumber(field, {-2, 0, 1})), 0);
    EXPECT_TRUE(field.is_zero({-2, 0, 1}));
    EXPECT_TRUE(field.is_zero({0, -10, 0, 5}));
    EXPECT_FALSE(field.is_zero({-3, 0, 1}));
    EXPECT_FALSE(field.is_zero({0, 1}));
    EXPECT_EQ(sgn(alpha * alpha - 2), 0);
    EXPECT_EQ(sgn(alpha * alpha * alpha - 3), -1);
    expect_near(FieldNumber(field, {0, 1, 0, 1}), 3 * std::numbers::sqrt2);
    EXPECT_EQ(is_less(Interval(0), enclosure(alpha * alpha - 2)), Answer::no);
  }
  // A factor of higher multiplicity is no obstacle.
  const NumberField field({0, 0, 0, -2, 0, 1}, 1, 2);  // x³(x² − 2)
  EXPECT_FALSE(field.is_zero({0, 0, 1}));
  EXPECT_TRUE(field.is_zero({0, -2, 0, 1}));
}

Polynomial product_of(const Polynomial& x, const Polynomial& y) {
  Polynomial result(x.size() + y.size() - 1);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) result[i + j] += x[i] * y[j];
  }
  return result;
}

/// The sign of x(√n), of which the even and the odd part are u + v√n.
int sign_at_root(const Polynomial& x, long n) {
  mpz_class u, v;
  mpz_class power = 1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    (i % 2 == 0 ? u : v) += power * x[i];
    if (i % 2 == 1) power *= n;
  }
  if (sgn(u) * sgn(v) >= 0) return sgn(u) == 0 ? sgn(v) : sgn(u);
  return sgn(u) * sgn(mpz_class(u * u - n * v * v));
}

/// Numbers, and those that are 0 by a factor of f, or nearly, over polynomials (x² − n) g with any g.
TEST(SecondCheckersField, SignsAreThoseOfTheNumbersInASubfield) {
  std::mt19937 random(20261127);
  const auto polynomial = [&](std::size_t size, long most) {
    Polynomial x(size);
    for (mpz_class& c : x) c = static_cast<long>(random() % static_cast<unsigned long>(2 * most + 1)) - most;
    return x;
  };
  int zeros = 0;
  for (int round = 0; round < 200; ++round) {
    const long n = 2 + static_cast<long>(random() % 30);  // Squares, too.
    Polynomial g = polynomial(1 + random() % 12, 9);
    g.back() = 1;
    if (sign_at_root(g, n) == 0) continue;  // A double root.
    const Polynomial minimal{-n, 0, 1};
    const mpq_class middle = std::sqrt(static_cast<double>(n));
    const mpq_class width(1, 1'000'000);
    const NumberField field(product_of(minimal, g), middle - width, middle + width);
    for (int i = 0; i < 50; ++i) {
      Polynomial x = polynomial(1 + random() % (g.size() + 1), 1000);
      if (i % 3 == 1) x = product_of(x, i % 2 == 0 ? minimal : g);
      if (i % 3 == 2) x = sum(product_of(product_of(x, minimal), g), polynomial(2, 2));
      const int expected = sign_at_root(x, n);
      zeros += expected == 0 ? 1 : 0;
      const FieldNumber number(field, x);
      ASSERT_EQ(sgn(number), expected) << n << ' ' << round << ' ' << i;
      trim(x);
      ASSERT_EQ(field.is_zero(x), expected == 0);
      const Interval found = enclosure(number * number + number);
      ASSERT_NE(is_less(found, Interval(mpq_class(-1, 4))), Answer::yes);
    }
  }
  EXPECT_GT(zeros, 500);
}

TEST(SecondCheckersField, SignsOfNumbersNearZero) {
  const NumberField field({-2, 0, 1}, 1, 2);
  const FieldNumber x(field, {-1, 1});
  FieldNumber power = 1;
  for (int k = 1; k <= 500; ++k) {
    power = power * x;
    EXPECT_EQ(sgn(power), 1);
    EXPECT_EQ(sgn(-power), -1);
  }
  // (√2 − 1)^500 is about 2^−636.
  const Interval found = enclosure(power);
  EXPECT_EQ(is_less(found, Interval(1, 1, 635)), Answer::yes);
  EXPECT_EQ(is_less(Interval(1, 1, 637), found), Answer::yes);
  EXPECT_EQ(sgn(power * FieldNumber(field, {1, 1}) - power * FieldNumber(field, {1, 1})), 0);
}

/// Powers of the ninth root α of n: 2^k α^i is ⌊(2^9k n^i)^(1/9)⌋, or less than 1 more.
TEST(SecondCheckersField, ApproximationsAreAsNearAsTheySay) {
  for (const char* digits :
       {"2", "1000000007", "1000000000000000000000000000007", "123456789012345678901234567890123456789"}) {
    const mpz_class n(digits);
    for (const int sign : {1, -1}) {
      Polynomial f(10);
      f[0] = -sign * n;
      f[9] = 1;
      const NumberField field(f, sign > 0 ? mpq_class(0) : mpq_class(-n), sign > 0 ? mpq_class(n) : mpq_class(0));
      for (mp_bitcnt_t bits = 1; bits < 60; ++bits) {
        for (unsigned long i = 0; i < 9; ++i) {
          mpz_class power, root;
          mpz_pow_ui(power.get_mpz_t(), n.get_mpz_t(), i);
          power <<= 9 * bits;
          mpz_root(root.get_mpz_t(), power.get_mpz_t(), 9);
          const int sign_of_power = i % 2 == 0 ? 1 : sign;
          Polynomial x(i + 1);
          x[i] = sign_of_power * 7;
          const Approximation found = field.approximation(x, bits);
          EXPECT_GE(found.value + found.error, 7 * root) << digits << ' ' << bits << ' ' << i;
          EXPECT_LE(found.value - found.error, 7 * root + 7) << digits << ' ' << bits << ' ' << i;
        }
      }
    }
  }
}

/// Of f = x^d + …, with roots that are known, or that f(2^k) < 0 shows to be greater than 2^k.
TEST(SecondCheckersField, BoundsHoldForAllConjugates) {
  const auto power = [](unsigned long base, unsigned long exponent) {
    mpz_class result;
    mpz_ui_pow_ui(result.get_mpz_t(), base, exponent);
    return result;
  };
  const auto bits_of = [](const Polynomial& f, const mpq_class& lower, const mpq_class& upper) {
    return NumberField(f, lower, upper).bits_of_roots();
  };
  // ±2²⁰; 2²⁰ and 1; nearly −2²⁰.
  EXPECT_GE(bits_of({-power(2, 40), 0, 1}, 0, mpq_class(power(2, 21))), 20U);
  EXPECT_GE(bits_of({power(2, 20), -power(2, 20) - 1, 1}, 0, 2), 20U);
  EXPECT_GE(bits_of({-1, power(2, 20), 1}, 0, 1), 20U);
  for (const unsigned long more : {0UL, 1UL, 2UL, 5UL}) {
    // f_(d−i) = 1 − 2^(ik + i − 1): a root near 3·2^k.
    Polynomial f(10);
    f[9] = 1;
    for (unsigned long i = 1; i <= 9; ++i) f[9 - i] = 1 - power(2, i * more + i - 1);
    const NumberField field(f, mpq_class(power(2, more + 1)), mpq_class(power(2, more + 2)));
    EXPECT_GE(field.bits_of_roots(), more + 2);
    Polynomial eighth_power(9);
    eighth_power[8] = 1000;
    const RealNumber x = real_number(FieldNumber(field, eighth_power));
    EXPECT_GE(x.bits, 8 * (more + 1) + 10);
    EXPECT_EQ(x.degree, 9U);
    EXPECT_EQ(x.n, 1U);
    EXPECT_EQ(x.field, field.name());
  }
}

TEST(SecondCheckersField, NamesAreThoseOfRoots) {
  const NumberField field({-2, 0, 1}, 1, 2);
  EXPECT_NE(field.name(), NumberField({-2, 0, 1}, -2, -1).name());
  EXPECT_NE(field.name(), NumberField({-3, 0, 1}, 1, 2).name());
  EXPECT_EQ(field.name(), NumberField({-2, 0, 1}, 1, 2).name());
  // Of numbers with a denominator: 2/3 to 1, and 2 to 3.
  EXPECT_NE(NumberField({-1, 0, 0, 2, 0, 0, 1}, mpq_class(2, 3), 1).name(),
            NumberField({-1, 0, 0, 2, 0, 0, 1}, 0, 1).name());
}

/// (x² − 2)(x² − qx + p − 2) at √2, where the other factor is p − q√2: less than any number of the first bits tells.
TEST(SecondCheckersField, AFactorThatIsNearlyZeroIsNotZero) {
  mpz_class p = 1;
  mpz_class q = 1;
  for (int i = 1; i < 300; ++i) {
    const mpz_class next = p + 2 * q;
    q = p + q;
    p = next;
    if (i % 50 != 0) continue;
    const Polynomial square{-2, 0, 1};
    const Polynomial near{mpz_class(p - 2), mpz_class(-q), 1};
    // √2 within 2^−2000.
    mpz_class floor;
    mpz_sqrt(floor.get_mpz_t(), mpz_class(mpz_class(2) << 4000).get_mpz_t());
    const mpz_class scale = mpz_class(1) << 2000;
    for (const bool first : {true, false}) {
      const NumberField field(product_of(square, near), mpq_class(floor, scale), mpq_class(floor + 1, scale));
      if (first) {
        EXPECT_FALSE(field.is_zero(near)) << i;
      }
      EXPECT_TRUE(field.is_zero(square)) << i;
      EXPECT_FALSE(field.is_zero(near)) << i;
      EXPECT_EQ(sgn(FieldNumber(field, near)), sgn(mpz_class(p * p - 2 * q * q))) << i;
    }
  }
}

TEST(SecondCheckersField, NumbersThatAreLessThanTheirCoefficientsSay) {
  mpz_class large;
  mpz_ui_pow_ui(large.get_mpz_t(), 10, 300);
  // x⁵(x − 10³⁰⁰) = 1: x − 10³⁰⁰ is 10⁻¹⁵⁰⁰, and x's conjugates are small.
  const NumberField field({-1, 0, 0, 0, 0, mpz_class(-large), 1}, mpq_class(large), mpq_class(2 * large));
  const FieldNumber alpha(field, {0, 1});
  EXPECT_EQ(sgn(alpha - large), 1);
  EXPECT_EQ(sgn(alpha * alpha * alpha * alpha * alpha * (alpha - large) - 1), 0);
  EXPECT_EQ(is_less(enclosure(alpha - large), Interval(1, 1, 4982)), Answer::yes);
  EXPECT_EQ(is_less(Interval(1, 1, 4983), enclosure(alpha - large)), Answer::yes);
}

TEST(SecondCheckersField, CommonIntegersAreTakenOut) {
  const NumberField field({-2, 0, 1}, 1, 2);
  FieldNumber x(field, {6, 10});
  FieldNumber y = 14;
  reduce(x, y);
  EXPECT_EQ(sgn(x - FieldNumber(field, {3, 5})), 0);
  EXPECT_EQ(sgn(y - 7), 0);
}

/// "root", "none" or "several".
std::string roots(const Polynomial& f, const mpq_class& lower, const mpq_class& upper) {
  try {
    const NumberField field(f, lower, upper);
    return "root";
  } catch (const Refutation&) {
    return "none";
  } catch (const TooLarge&) {
    return "several";
  }
}

TEST(SecondCheckersField, TheRootIsTheOnlyOneOfItsInterval) {
  EXPECT_EQ(roots({-2, 0, 1}, 1, 2), "root");
  EXPECT_EQ(roots({-2, 0, 1}, -2, -1), "root");
  EXPECT_EQ(roots({-2, 0, 1}, -1, 1), "none");
  EXPECT_EQ(roots({-2, 0, 1}, 2, 3), "none");
  EXPECT_EQ(roots({-2, 0, 1}, -2, 2), "several");
  EXPECT_EQ(roots({1, -2, 1}, 0, 3), "several");  // A double root.
  EXPECT_EQ(roots({1, 0, 1}, -3, 3), "several");  // Roots near the interval, which is too long.
  EXPECT_EQ(roots({1, 0, 1}, mpq_class(-1, 9), mpq_class(1, 9)), "none");
  EXPECT_EQ(roots({-5, 1}, 4, 6), "root");
  EXPECT_EQ(roots({-5, 1}, 5, 6), "none");
  EXPECT_EQ(roots({-5, 1}, 4, 5), "none");
}

TEST(SecondCheckersField, EndsOfTheIntervalMayBeOtherRoots) {
  const Polynomial f{0, 2, -3, 1};  // x(x − 1)(x − 2)
  for (const int root : {0, 1, 2}) {
    for (const mpq_class& below : {mpq_class(1), mpq_class(1, 3)}) {
      for (const mpq_class& above : {mpq_class(1), mpq_class(2, 3)}) {
        const NumberField field(f, root - below, root + above);
        EXPECT_EQ(sgn(FieldNumber(field, {0, 1}) - root), 0);
        EXPECT_EQ(sgn(FieldNumber(field, {1, 3}) - root), 1);
        expect_near(FieldNumber(field, {7, 1}), 7 + root);
      }
    }
  }
  EXPECT_EQ(roots(f, 0, 1), "none");
}

TEST(SecondCheckersField, AnIntervalMayBeLong) {
  mpz_class large;
  mpz_ui_pow_ui(large.get_mpz_t(), 10, 1000);
  const NumberField field({-2, 0, 0, 1}, 0, mpq_class(large));
  expect_near(FieldNumber(field, {0, 1}), std::cbrt(2));
  const NumberField negative({2, 0, 0, 1}, mpq_class(-large), 0);
  expect_near(FieldNumber(negative, {0, 1}), -std::cbrt(2));
}

TEST(SecondCheckersField, RootsThatAreNearToEachOther) {
  // x²⁰ = 2(10⁶x − 1)² at 10⁻⁶ ± 10⁻⁶⁶/√2, nearly.
  Polynomial f(21);
  f[0] = -2;
  f[1] = 4'000'000;
  f[2] = mpz_class("-2000000000000");
  f[20] = 1;
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, 66);
  const mpq_class middle(1, 1'000'000);
  const NumberField above(f, middle, middle + mpq_class(1, scale));
  const NumberField below(f, middle - mpq_class(1, scale), middle);
  EXPECT_EQ(sgn(FieldNumber(above, {-1, 1'000'000})), 1);
  EXPECT_EQ(sgn(FieldNumber(below, {-1, 1'000'000})), -1);
  expect_near(FieldNumber(above, {mpz_class(-scale / 1'000'000), scale}), std::sqrt(0.5));
  expect_near(FieldNumber(below, {mpz_class(-scale / 1'000'000), scale}), -std::sqrt(0.5));
}

TEST(SecondCheckersField, FieldsThatAreTooLargeAreNotTried) {
  mpz_class large;
  mpz_ui_pow_ui(large.get_mpz_t(), 10, 100'000);
  EXPECT_THROW(NumberField({-large, 0, 0, 0, 1}, 0, mpq_class(large)), TooLarge);
  EXPECT_THROW(NumberField({-2, 0, 0, 0, 1}, 0, mpq_class(large)), TooLarge);
}

// ---- Files ----

std::string contents(const std::string& name) {
  std::ostringstream out;
  out << std::ifstream(std::string(EPSNET_TEST_DATA) + "/" + name + ".json", std::ios::binary).rdbuf();
  return out.str();
}

/// The value of the member `surface`, which ends before `epsilon`.
std::string surface_of(const std::string& net) {
  const std::size_t begin = net.find("\"surface\":") + 10;
  return net.substr(begin, net.find(",\n\"epsilon\"") - begin);
}

TEST(SecondCheckersField, NetsAreVerified) {
  for (const std::string name : {"field-octagon", "field-reducible", "field-bolza"}) {
    const Result result = check(contents("forgeries/" + name));
    EXPECT_EQ(result.verdict, Verdict::verified) << name << ": " << result.rule << ": " << result.message;
  }
  EXPECT_THAT(why_no_claim("{\"format\":\"epsnet-surface\",\"version\":1,\"surface\":" +
                           surface_of(contents("forgeries/field-bolza")) + "}"),
              testing::StartsWith("this is a surface file"));
}

/// Bolza's surface over a number field in the place of the regular one: sides and coordinates are the same.
TEST(SecondCheckersField, ClaimsOfEveryKindAreVerified) {
  const std::string surface = surface_of(contents("forgeries/field-bolza"));
  for (const std::string name : {"distances/bolza", "geodesics/bolza-to-6.2", "isometries/bolza-of-one-vertex",
                                 "pants/bolza", "curves/bolza", "eigenvalues/bolza", "bounds/regular-diameter"}) {
    const std::string text = contents(name);
    const std::string changed = std::regex_replace(text, std::regex(R"(\{"kind":"regular","genus":2[^}]*\})"), surface);
    EXPECT_TRUE(changed != text) << name;
    const Result result = check(changed);
    EXPECT_EQ(result.verdict, Verdict::verified) << name << ": " << result.rule << ": " << result.message;
  }
}

TEST(SecondCheckersField, MalformedSurfaces) {
  const std::string good = contents("forgeries/field-bolza");
  const auto message_of = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const Result result = check(text);
    EXPECT_EQ(result.verdict, Verdict::malformed) << result.rule << result.message;
    return result.message;
  };
  const std::string polynomial = R"(["-4","0","-4","0","1"])";
  EXPECT_EQ(message_of(polynomial, R"(["-4","0","-4","0","2"])"), "polynomial: not monic, or of degree 0");
  EXPECT_EQ(message_of(polynomial, R"(["-4","0","-4","0","-1"])"), "polynomial: not monic, or of degree 0");
  EXPECT_EQ(message_of(polynomial, R"(["1"])"), "polynomial: not monic, or of degree 0");
  EXPECT_EQ(message_of(polynomial, "[]"), "polynomial: not 1 to 65 integers");
  std::string many = R"(["1")";
  for (int i = 0; i < 65; ++i) many += R"(,"1")";
  EXPECT_EQ(message_of(polynomial, many + "]"), "polynomial: not 1 to 65 integers");
  EXPECT_EQ(message_of(polynomial, R"(["-4","0","-4","0",1])"), "'1' found, expected an integer in a string");
  EXPECT_EQ(message_of(polynomial, R"(["-4","0","-4","0","1/1"])"), "'1/1' found, expected an integer");
  EXPECT_EQ(message_of(polynomial, R"(["-4","0","-4","0","+1"])"), "'+1' found, expected an integer");
  EXPECT_EQ(message_of(R"(["2","3"])", R"(["3","2"])"), "root: expected L < U");
  EXPECT_EQ(message_of(R"(["2","3"])", R"(["3","3"])"), "root: expected L < U");
  EXPECT_EQ(message_of(R"(["2","3"])", R"(["3"])"), "root: expected 2 elements");
  EXPECT_EQ(message_of(R"(["0","-4","0","1"])", R"([])"), "a number of the field: not 1 to 4 integers");
  EXPECT_EQ(message_of(R"(["0","-4","0","1"])", R"(["0","-4","0","1","0"])"),
            "a number of the field: not 1 to 4 integers");
  EXPECT_EQ(message_of(R"([["0","-4","0","1"],)", "["), "a vertex of a tile: expected 3 elements");
  EXPECT_EQ(message_of(R"([["2"],["0"],["0","4","0","-1"],["0"]],)", ""), "crossings: not one for each row of gluing");
  EXPECT_EQ(message_of(R"(["2"],["0"],["0","4","0","-1"],["0"])", R"(["0"])"), "a crossing: expected 4 elements");
  EXPECT_EQ(message_of("\"crossings\":", "\"crossing\":"), "unknown member \"crossing\"");
  EXPECT_EQ(message_of(R"("root":["2","3"],)", ""), "no member \"root\"");
  EXPECT_EQ(message_of("[0,3,0,7]", "[0,3,0,6]"), "a side is glued twice");
}

// ---- Rule `surface` ----

Polynomial negative(Polynomial x) {
  for (mpz_class& n : x) n = -n;
  return x;
}

/// The octagon with the vertices (x, −y, t), (x, y, t) and so on, with the symmetries of a square, opposite sides
/// glued: the crossing of a side is the turn by π about its midpoint M, and then about 0.
Net octagon(const Polynomial& f, const mpq_class& lower, const mpq_class& upper, const Polynomial& x,
            const Polynomial& y, const Polynomial& t) {
  Net net;
  net.epsilon = 1;
  FieldTiles& field = net.field.emplace();
  field.polynomial = f;
  field.root = {lower, upper};
  auto& tile = field.tiles.emplace_back();
  for (std::array<Polynomial, 2> corner : {std::array{x, negative(y)}, std::array{x, y}}) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      tile.push_back({corner[0], corner[1], t});
      corner = {negative(corner[1]), corner[0]};
    }
  }
  // The two orbits in turns.
  tile = {tile[0], tile[4], tile[1], tile[5], tile[2], tile[6], tile[3], tile[7]};
  for (Index k = 0; k < 4; ++k) {
    net.gluing.push_back({0, k, 0, k + 4});
    const auto middle = [&](std::size_t i) { return sum(tile[k].at(i), tile[k + 1].at(i)); };
    const auto nonempty = [](const Polynomial& p) { return p.empty() ? Polynomial{0} : p; };
    field.crossings.push_back({middle(2), {0}, nonempty(negative(middle(0))), nonempty(negative(middle(1)))});
  }
  return net;
}

/// The regular octagon with the angles π/4: α² = 2 + 2√2.
Net bolza() { return octagon({-4, 0, -4, 0, 1}, 2, 3, {0, -4, 0, 1}, {0, 10, 0, -2}, {2}); }

/// "", or what is wrong.
std::string outcome(const Net& net) {
  try {
    NetRules<FieldNumber> rules(net);
    rules.rules()[0].ask();
    return "";
  } catch (const Refutation& refutation) {
    return refutation.what;
  } catch (const TooLarge& question) {
    return "undecided: " + question.what;
  } catch (const Malformed& error) {
    return std::string("malformed: ") + error.what();
  }
}

std::string changed(const std::function<void(Net&)>& change) {
  Net net = bolza();
  change(net);
  return outcome(net);
}

TEST(SecondCheckersFieldSurface, TheRegularOctagon) { EXPECT_EQ(outcome(bolza()), ""); }

TEST(SecondCheckersFieldSurface, TheRoot) {
  EXPECT_EQ(changed([](Net& net) { net.field->root = {3, 4}; }), "the polynomial has no root in the interval");
  EXPECT_EQ(
      changed([](Net& net) {
        net.field->root = {-3, 3};
      }),
      "undecided: the polynomial may have several roots in the interval, by 4 changes of sign: give a shorter one");
  // With the other real root, −α, the octagon is the same, turned by π.
  EXPECT_EQ(changed([](Net& net) { net.field->root = {-3, -2}; }), "");
}

TEST(SecondCheckersFieldSurface, VerticesAreInTheDisk) {
  const std::string expected = "tile 0 has a vertex outside of the disk";
  for (std::size_t k = 0; k < 8; ++k) {
    const auto vertex = [&](Net & net) -> auto& { return net.field->tiles[0][k]; };
    EXPECT_EQ(changed([&](Net& net) { vertex(net)[2] = {-2}; }), expected);
    EXPECT_EQ(changed([&](Net& net) { vertex(net)[2] = {1}; }), expected);
    EXPECT_EQ(changed([&](Net& net) { vertex(net)[2] = {0}; }), expected);
    // On the circle, exactly.
    EXPECT_EQ(changed([&](Net& net) {
                vertex(net) = {Polynomial{0, 3}, Polynomial{0, -4}, Polynomial{0, 5}};
              }),
              expected);
    // Positive multiples are the same.
    EXPECT_EQ(changed([&](Net& net) {
                const auto [x, y, t] = vertex(net);
                vertex(net) = {sum(sum(x, x), x), sum(sum(y, y), y), sum(sum(t, t), t)};
              }),
              "");
  }
}

TEST(SecondCheckersFieldSurface, TilesAreConvexAndCounterclockwise) {
  const std::string expected = "tile 0 is not strictly convex and counterclockwise at its vertex ";
  EXPECT_EQ(changed([](Net& net) { std::swap(net.field->tiles[0][2], net.field->tiles[0][3]); }), expected + "1");
  EXPECT_EQ(changed([](Net& net) { std::reverse(net.field->tiles[0].begin(), net.field->tiles[0].end()); }),
            expected + "0");
  // A flat corner.
  EXPECT_EQ(changed([](Net& net) {
              auto& tile = net.field->tiles[0];
              for (std::size_t i = 0; i < 3; ++i) tile[4].at(i) = sum(tile[3].at(i), tile[5].at(i));
            }),
            expected + "3");
}

TEST(SecondCheckersFieldSurface, CrossingsTakeSidesToTheirPartners) {
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string name = "the crossing of side " + std::to_string(k) + " of tile 0";
    const auto row = [&](Net & net) -> auto& { return net.field->crossings[k]; };
    EXPECT_EQ(changed([&](Net& net) { row(net)[0] = negative(row(net)[0]); }),
              name + " does not take it to side " + std::to_string(k + 4) + " of tile 0");
    EXPECT_EQ(changed([&](Net& net) {
                row(net)[1] = {0, 1};
              }),
              name + " does not take it to side " + std::to_string(k + 4) + " of tile 0");
    EXPECT_EQ(changed([&](Net& net) {
                std::swap(row(net)[0], row(net)[2]);
                std::swap(row(net)[1], row(net)[3]);
              }),
              name + " is no isometry");
    EXPECT_EQ(changed([&](Net& net) {
                row(net) = {Polynomial{0}, Polynomial{0}, Polynomial{0}, Polynomial{0}};
              }),
              name + " is no isometry");
    // Real multiples are the same, whatever their sign.
    EXPECT_EQ(changed([&](Net& net) {
                for (Polynomial& x : row(net)) x = negative(sum(x, x));
              }),
              "");
  }
}

/// Isometries that take one end of a side to where it belongs, but not the other one.
TEST(SecondCheckersFieldSurface, CrossingsTakeBothEndsOfSides) {
  Net net = bolza();
  net.gluing = {{0, 0, 0, 3}, {0, 1, 0, 4}, {0, 2, 0, 5}, {0, 6, 0, 7}};
  EXPECT_EQ(outcome(net), "the crossing of side 0 of tile 0 does not take it to side 3 of tile 0");
  net = bolza();
  // The turn by π/2 about 0 takes vertex 0 to vertex 2, the end of side 1, and vertex 1 to vertex 3.
  net.gluing = {{0, 0, 0, 1}, {0, 2, 0, 3}, {0, 4, 0, 5}, {0, 6, 0, 7}};
  net.field->crossings.assign(4, {Polynomial{1}, Polynomial{1}, Polynomial{0}, Polynomial{0}});
  EXPECT_EQ(outcome(net), "the crossing of side 0 of tile 0 does not take it to side 1 of tile 0");
  // And vertex 1, the end of side 0, to vertex 3, the start of side 3.
  net.gluing = {{0, 0, 0, 3}, {0, 1, 0, 2}, {0, 4, 0, 5}, {0, 6, 0, 7}};
  EXPECT_EQ(outcome(net), "the crossing of side 0 of tile 0 does not take it to side 3 of tile 0");
}

TEST(SecondCheckersFieldSurface, EverySideIsGluedOnce) {
  EXPECT_EQ(changed([](Net& net) { net.gluing[3] = {0, 3, 0, 6}; }), "malformed: a side is glued twice");
  EXPECT_EQ(changed([](Net& net) { net.gluing.pop_back(); }), "malformed: a side is not glued");
}

TEST(SecondCheckersFieldSurface, TilesAreConnected) {
  EXPECT_EQ(changed([](Net& net) {
              net.field->tiles.push_back(net.field->tiles[0]);
              for (Index k = 0; k < 4; ++k) net.gluing.push_back({1, k, 1, k + 4});
              const auto crossings = net.field->crossings;
              net.field->crossings.insert(net.field->crossings.end(), crossings.begin(), crossings.end());
            }),
            "the tiles are not connected");
}

TEST(SecondCheckersFieldSurface, CornersCloseUp) {
  // Rational, and over √2: octagons whose angles add up to other numbers.
  EXPECT_EQ(outcome(octagon({-1, 1}, 0, 2, {7}, {3}, {8})), "the corners around vertex 0 of tile 0 do not close up");
  EXPECT_EQ(outcome(octagon({-2, 0, 1}, 1, 2, {0, 5}, {3}, {8})),
            "the corners around vertex 0 of tile 0 do not close up");
}

/// The regular octagon with right angles, α⁴ = 2: around its corner they add up to 4π, and all else is true.
TEST(SecondCheckersFieldSurface, AnglesAddUpToOneTurn) {
  EXPECT_EQ(outcome(octagon({-2, 0, 0, 0, 1}, 1, 2, {0, 0, 0, 1}, {0, 2, 0, -1}, {2})),
            "the angles around vertex 0 of tile 0 add up to 2 full turns");
}

TEST(SecondCheckersFieldSurface, NumbersThatAreTooLargeAreUndecided) {
  mpz_class large;
  mpz_ui_pow_ui(large.get_mpz_t(), 10, 400'000);
  const std::string expected = "undecided: its exact numbers are too large";
  EXPECT_EQ(changed([&](Net& net) { net.field->tiles[0][3][2] = {0, large}; }), expected);
  EXPECT_EQ(changed([&](Net& net) { net.field->crossings[1][2] = {0, large}; }), expected);
}

}  // namespace
}  // namespace epsnet::exact::second_checkers_field_test
