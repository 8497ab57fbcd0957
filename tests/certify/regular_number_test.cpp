#include <array>
#include <cmath>
#include <complex>
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>
#include <flint/ulong_extras.h>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

#include "certify/net/crossings.h"
#include "certify/net/surface_sides.h"

namespace epsnet::certify {
namespace {

RegularNumber integer(const RegularRing& ring, const mpz_class& value) { return regular_number(ring, {value, 0}); }
/// The crossing of one side.
Isometry<RegularNumber> crossing(const RegularRing& ring, std::uint32_t side) {
  return regular_turn(ring, side, 1, Turn::counterclockwise);
}
RegularNumber cotangent(const RegularRing& ring) { return crossing(ring, 0).a; }
bool is_zero(const RegularNumber& x) { return sign(norm(x)) == 0; }

/// The ball contains the real number, by exact comparisons with its ends.
void expect_contains(arb_srcptr ball, const RegularNumber& x) {
  const Interval interval = outer_interval(ball);
  EXPECT_LT(interval.upper - interval.lower, 1e-9);
  for (const auto& [end, wanted] : {std::pair{interval.lower, 1}, std::pair{interval.upper, -1}}) {
    const mpq_class value(end);
    const int side = sign(value.get_den() * x - integer(*x.ring, value.get_num()));
    EXPECT_TRUE(side == 0 || side == wanted);
  }
}

void expect_contains(const ComplexBall& ball, const RegularNumber& x) {
  Ball twice;
  arb_mul_2exp_si(twice.get(), ball.re(), 1);
  expect_contains(twice.get(), twice_real(x));
  arb_mul_2exp_si(twice.get(), ball.im(), 1);
  expect_contains(twice.get(), twice_imaginary(x));
}

TEST(RegularNumber, CotangentIsWhatTheFormulaSays) {
  for (std::uint32_t genus = 2; genus <= 30; ++genus) {
    const RegularRing ring(genus);
    const RegularNumber zeta = power_of_zeta(ring, 1);
    const RegularNumber one = integer(ring, 1);
    EXPECT_TRUE(is_zero(cotangent(ring) * (zeta - one) - Gaussian{0, 1} * (zeta + one)));
    EXPECT_TRUE(is_zero(regular_s(ring) * regular_s(ring) + one - cotangent(ring) * cotangent(ring)));
    Ball cosh, sinh;
    set_regular_apothem(cosh.get(), sinh.get(), genus, 64);
    expect_contains(cosh.get(), cotangent(ring));
    expect_contains(sinh.get(), regular_s(ring));
  }
}

TEST(RegularNumber, ZeroIsFoundWhereverTheLeastRelationHides) {
  for (std::uint32_t genus = 2; genus <= 40; ++genus) {
    const RegularRing ring(genus);
    // For odd divisors p of g, 1 − ζ^(2g/p) + ζ^(4g/p) − … = 0.
    for (std::uint32_t p = 3; p <= genus; p += 2) {
      if (genus % p != 0) continue;
      RegularNumber sum = integer(ring, 0);
      for (std::uint32_t k = 0; k < p; ++k) {
        sum = sum + mpz_class(k % 2 == 0 ? 1 : -1) * power_of_zeta(ring, std::int64_t{k} * (2 * genus / p));
      }
      EXPECT_TRUE(is_zero(sum));
      EXPECT_TRUE(is_zero(sum * regular_s(ring)));
      EXPECT_EQ(sign(norm(sum + integer(ring, 1)) - integer(ring, 1)), 0);
    }
    EXPECT_FALSE(is_zero(power_of_zeta(ring, 1) - integer(ring, 1)));
    EXPECT_FALSE(is_zero(regular_s(ring)));
  }
}

TEST(RegularNumber, SignsOfNumbersThatAreNearlyZeroAreFound) {
  for (const std::uint32_t genus : {2U, 3U, 7U, 20U}) {
    const RegularRing ring(genus);
    Ball cosh, sinh;
    set_regular_apothem(cosh.get(), sinh.get(), genus, 4000);
    for (const auto& [ball, number] : {std::pair{&cosh, cotangent(ring)}, std::pair{&sinh, regular_s(ring)}}) {
      // The integer below 2^3000 times the number.
      arb_mul_2exp_si(ball->get(), ball->get(), 3000);
      arb_floor(ball->get(), ball->get(), 4000);
      fmpz_t below;
      fmpz_init(below);
      ASSERT_TRUE(arb_get_unique_fmpz(below, ball->get()));
      mpz_class floor;
      fmpz_get_mpz(floor.get_mpz_t(), below);
      fmpz_clear(below);
      const mpz_class scale = mpz_class(1) << 3000;
      EXPECT_EQ(sign(scale * number - integer(ring, floor)), 1);
      EXPECT_EQ(sign(scale * number - integer(ring, floor + 1)), -1);
    }
    EXPECT_EQ(sign(integer(ring, 0)), 0);
  }
}

TEST(RegularNumber, MultiplesOfThePrimesTriedAreNotZero) {
  // Whatever the primes 1 + 4g m below 2^62 are that a sign begins with, the product of the first of them is no zero.
  for (const std::uint32_t genus : {2U, 3U, 7U}) {
    const RegularRing ring(genus);
    const mpz_class order = 4 * genus;
    mpz_class p = (mpz_class(1) << 62) / order * order + 1;
    mpz_class product = 1;
    for (int found = 0; found < 40; p -= order) {
      if (p >= mpz_class(1) << 62 || mpz_probab_prime_p(p.get_mpz_t(), 30) == 0) continue;
      product *= p;
      ++found;
    }
    for (const RegularNumber& x : {integer(ring, 1), cotangent(ring), regular_s(ring)}) {
      EXPECT_EQ(sign(product * x), 1);
      EXPECT_EQ(sign(mpz_class(-product) * x), -1);
      EXPECT_EQ(sign(product * x - product * x), 0);
    }
  }
}

TEST(RegularNumber, TurnsAreProductsOfCrossings) {
  for (const std::uint32_t genus : {2U, 3U, 4U, 6U, 15U}) {
    const RegularRing ring(genus);
    for (const Turn turn : {Turn::counterclockwise, Turn::clockwise}) {
      const std::uint32_t step = turn == Turn::counterclockwise ? 2 * genus + 1 : 2 * genus - 1;
      for (const std::uint32_t start : {0U, 1U, 3 * genus}) {
        Isometry<RegularNumber> product = crossing(ring, start);
        for (std::uint32_t count = 1; count <= 4 * genus + 2; ++count) {
          const Isometry<RegularNumber> closed = regular_turn(ring, start, count, turn);
          EXPECT_TRUE(is_zero(closed.a - product.a)) << genus << ' ' << start << ' ' << count;
          EXPECT_TRUE(is_zero(closed.b - product.b)) << genus << ' ' << start << ' ' << count;
          product = compose(crossing(ring, (start + count * step) % (4 * genus)), product);
        }
      }
    }
  }
}

TEST(RegularNumber, PowersOfManyRootsAreMultipliedFromTwoTables) {
  // More than 128 roots of unity, and counts beyond all of them.
  const std::uint32_t genus = 33;
  const RegularRing ring(genus);
  for (const Turn turn : {Turn::counterclockwise, Turn::clockwise}) {
    const std::uint32_t step = turn == Turn::counterclockwise ? 2 * genus + 1 : 2 * genus - 1;
    for (const std::uint32_t count : {1U, 62U, 63U, 64U, 65U, 127U, 128U, 131U, 132U, 133U, 200U, 1000U, 100'000U}) {
      const Isometry<RegularNumber> before = regular_turn(ring, 5, count, turn);
      const Isometry<RegularNumber> after = regular_turn(ring, 5, count + 1, turn);
      const Isometry<RegularNumber> product = compose(crossing(ring, (5 + count * step) % (4 * genus)), before);
      EXPECT_TRUE(is_zero(after.a - product.a)) << count;
      EXPECT_TRUE(is_zero(after.b - product.b)) << count;
      EXPECT_FALSE(is_zero(after.b - before.b)) << count;
    }
  }
}

TEST(RegularNumber, MultiplesAreSums) {
  for (const std::uint32_t genus : {2U, 5U}) {
    const RegularRing ring(genus);
    const RegularNumber x = regular_s(ring) + integer(ring, 1);
    EXPECT_EQ(sign(mpz_class(0) * x), 0);
    EXPECT_EQ(sign(mpz_class(1) * x - x), 0);
    EXPECT_EQ(sign(mpz_class(2) * x - (x + x)), 0);
    EXPECT_EQ(sign(mpz_class(2) * x - x), 1);
    EXPECT_EQ(sign(mpz_class(-1) * x + x), 0);
    EXPECT_EQ(sign(mpz_class(-1) * x), -1);
  }
}

/// The crossing of a side in the embedding ζ ↦ ζ^k.
std::array<std::complex<double>, 4> embedded_crossing(std::uint32_t genus, std::uint32_t k, std::uint32_t side) {
  const double angle = M_PI * k / (2 * genus);
  const std::complex<double> i_to_k = k % 4 == 1 ? std::complex<double>(0, 1) : std::complex<double>(0, -1);
  const std::complex<double> zeta = std::polar(1.0, angle);
  const std::complex<double> a = i_to_k * (zeta + 1.0) / (zeta - 1.0);
  const std::complex<double> s = std::sqrt(a * a - 1.0);
  return {a, -s * std::polar(1.0, angle * side), -s * std::polar(1.0, -angle * side), a};
}

TEST(RegularNumber, ConjugatesOfTurnsAreWithinTheirBounds) {
  for (const std::uint32_t genus : {2U, 3U, 5U, 9U, 16U}) {
    const RegularRing ring(genus);
    for (std::uint32_t count = 1; count <= 4 * genus; ++count) {
      double log_norm = 0;
      std::size_t embeddings = 0;
      for (std::uint32_t k = 1; k < 2 * genus; k += 2) {
        if (std::gcd(k, 4 * genus) != 1) continue;
        std::array<std::complex<double>, 4> product{1, 0, 0, 1};
        for (std::uint32_t i = 0; i < count; ++i) {
          const auto m = embedded_crossing(genus, k, i * (2 * genus + 1) % (4 * genus));
          product = {m[0] * product[0] + m[1] * product[2], m[0] * product[1] + m[1] * product[3],
                     m[2] * product[0] + m[3] * product[2], m[2] * product[1] + m[3] * product[3]};
        }
        log_norm += 2 * std::log2(std::max({1.0, std::abs(product[0]), std::abs(product[1])}));
        ++embeddings;
      }
      ASSERT_EQ(ring.embeddings().size(), embeddings);
      // No less, up to the rounding of the bound to an integer; and no useless bound.
      EXPECT_GE(static_cast<double>(regular_turn_bits(ring, count)) + 1, log_norm) << genus << ' ' << count;
    }
    // A bound for all counts, so it is good for those in the middle.
    EXPECT_LE(regular_turn_bits(ring, 2 * genus), 8 * ring.embeddings().size());
  }
}

TEST(RegularNumber, EmbeddingsHaveTheirLogarithmsRoundedUp) {
  // θ = kπ/(2g) for k prime to 4g below 2g; s² = cot²(θ/2) − 1 = cos θ/sin²(θ/2).
  for (std::uint32_t genus = 2; genus < 40; ++genus) {
    const RegularRing ring(genus);
    std::size_t number = 0;
    for (std::uint32_t k = 1; k < 2 * genus; ++k) {
      if (std::gcd(k, 4 * genus) != 1) continue;
      ASSERT_LT(number, ring.embeddings().size());
      const RegularRing::Embeddings& at = ring.embeddings()[number++];
      const long double theta = std::acos(-1.0L) * k / (2 * genus);
      const long double sine = std::sin(theta / 2);
      const auto expect_rounded_up = [&](std::int64_t log, long double x) {
        const long double exact = RegularRing::kLogScale * std::log2(x);
        EXPECT_GE(static_cast<long double>(log), exact) << genus << ", " << k;
        EXPECT_LT(static_cast<long double>(log), exact + 1) << genus << ", " << k;
      };
      expect_rounded_up(at.log_s, std::sqrt(std::abs(std::cos(theta))) / sine);
      expect_rounded_up(at.log_inverse_sine, 1 / sine);
      EXPECT_EQ(at.s_is_real, theta < std::acos(-1.0L) / 2) << genus << ", " << k;
    }
    EXPECT_EQ(number, ring.embeddings().size()) << genus;
  }
}

TEST(RegularNumber, TurnsHaveTheSignsOfTheirProducts) {
  // Many times around a corner.
  for (const std::uint32_t genus : {2U, 3U, 4U}) {
    const RegularRing ring(genus);
    std::array<std::complex<double>, 4> product{1, 0, 0, 1};
    for (std::uint32_t count = 1; count <= 30 * genus; ++count) {
      const auto m = embedded_crossing(genus, 1, (count - 1) * (2 * genus + 1) % (4 * genus));
      product = {m[0] * product[0] + m[1] * product[2], m[0] * product[1] + m[1] * product[3],
                 m[2] * product[0] + m[3] * product[2], m[2] * product[1] + m[3] * product[3]};
      const Isometry<RegularNumber> turn = regular_turn(ring, 0, count, Turn::counterclockwise);
      const auto expect_sign = [&](const RegularNumber& x, double expected) {
        EXPECT_EQ(sign(x), std::abs(expected) < 1e-9 ? 0 : expected < 0 ? -1 : 1) << genus << ", " << count;
      };
      expect_sign(twice_real(turn.a), product[0].real());
      expect_sign(twice_imaginary(turn.a), product[0].imag());
      expect_sign(twice_real(turn.b), product[1].real());
      expect_sign(twice_imaginary(turn.b), product[1].imag());
    }
  }
}

TEST(RegularNumber, LogarithmsOfIntegersAreBounded) {
  const RegularRing ring(3);
  constexpr std::int64_t kBit = RegularRing::kLogScale;
  const auto bounds = [](const RegularNumber& x) { return log_bounds(x); };
  const auto all = [&](std::int64_t bound) { return std::vector<std::int64_t>(ring.embeddings().size(), bound); };
  for (std::int64_t k = 0; k < 200; ++k) {
    // Powers of 2 exactly, others by that above; of sums of equal ones, and of products, exactly.
    const mpz_class power = mpz_class(1) << static_cast<mp_bitcnt_t>(k);
    EXPECT_EQ(bounds(integer(ring, power)), all(k * kBit)) << k;
    EXPECT_EQ(bounds(integer(ring, -power)), all(k * kBit)) << k;
    EXPECT_EQ(bounds(integer(ring, power) + integer(ring, power)), all((k + 1) * kBit)) << k;
    EXPECT_EQ(bounds(integer(ring, power) - integer(ring, -power)), all((k + 1) * kBit)) << k;
    EXPECT_EQ(bounds(integer(ring, power) * integer(ring, power)), all(2 * k * kBit)) << k;
    EXPECT_EQ(bounds(conjugate(integer(ring, power))), all(k * kBit)) << k;
    if (k < 2) continue;
    for (const mpz_class& other : {mpz_class(power + 1), mpz_class(2 * power - 1), mpz_class(power + power / 2)}) {
      EXPECT_EQ(bounds(integer(ring, other)), all((k + 1) * kBit)) << k;
      EXPECT_EQ(bounds(integer(ring, -other)), all((k + 1) * kBit)) << k;
    }
  }
}

TEST(RegularNumber, LogarithmsOfPrimesAreRoundedDown) {
  for (int k = 1; k < 63; ++k) {
    const std::uint64_t power = std::uint64_t{1} << k;
    EXPECT_EQ(log_rounded_down(power), k * RegularRing::kLogScale);
    EXPECT_EQ(log_rounded_down(power + 1), k * RegularRing::kLogScale);
    EXPECT_EQ(log_rounded_down(power - 1), (k - 1) * RegularRing::kLogScale);
  }
}

TEST(RegularNumber, LogarithmsOfTurnsAreBounded) {
  // |b| = |s sin(count θ/2)/sin(θ/2)|, |a|² = 1 ± |b|². That of a is nearly its bound somewhere.
  double nearest = 1;
  for (std::uint32_t genus = 2; genus <= 60; ++genus) {
    const RegularRing ring(genus);
    for (std::uint32_t count = 1; count <= 40; ++count) {
      const Isometry<RegularNumber> turn = regular_turn(ring, 0, count, Turn::counterclockwise);
      const std::vector<std::int64_t> of_a = log_bounds(turn.a);
      const std::vector<std::int64_t> of_b = log_bounds(turn.b);
      std::size_t i = 0;
      for (std::uint32_t k = 1; k < 2 * genus; k += 2) {
        if (std::gcd(k, 4 * genus) != 1) continue;
        const double theta = M_PI * k / (2 * genus);
        const double square = std::cos(theta) * std::pow(std::sin(count * theta / 2) / std::sin(theta / 2), 2) /
                              std::pow(std::sin(theta / 2), 2);
        const double log_a = RegularRing::kLogScale / 2.0 * std::log2(std::abs(1 + square));
        const double log_b = RegularRing::kLogScale / 2.0 * std::log2(std::abs(square));
        const auto bound_of_a = static_cast<double>(of_a[i]);
        EXPECT_GE(bound_of_a, log_a - 1e-6) << genus << ", " << k << ", " << count;
        EXPECT_GE(static_cast<double>(of_b[i]), log_b - 1e-6) << genus << ", " << k << ", " << count;
        if (k < genus) nearest = std::min(nearest, bound_of_a - log_a);
        ++i;
      }
      EXPECT_EQ(i, of_a.size());
    }
  }
  EXPECT_LT(nearest, 0.9);
}

TEST(RegularNumber, GaussianIntegersAreANumberOfTheRing) {
  const RegularRing ring(5);
  const Gaussian x{-7, 3};
  const Gaussian y{2, 11};
  const auto embedded = [&](const Gaussian& z) { return regular_number(ring, z); };
  EXPECT_TRUE(is_zero(embedded(x) * embedded(y) - embedded(x * y)));
  EXPECT_TRUE(is_zero(x * embedded(y) - embedded(x * y)));
  EXPECT_TRUE(is_zero(conjugate(embedded(x)) - embedded(conjugate(x))));
  EXPECT_TRUE(is_zero(norm(embedded(x)) - embedded({norm(x), 0})));
  EXPECT_TRUE(is_zero(twice_real(embedded(x)) - embedded({twice_real(x), 0})));
  EXPECT_TRUE(is_zero(twice_imaginary(embedded(x)) - embedded({twice_imaginary(x), 0})));
}

TEST(RegularCrossings, BallsContainTheExactOnes) {
  for (const std::uint32_t genus : {2U, 3U, 4U, 9U}) {
    const RegularCrossings crossings(genus);
    ASSERT_EQ(crossings.size(), 4 * genus);
    for (std::uint32_t side = 0; side < 4 * genus; ++side) {
      const BallIsometry balls = crossings.balls(side, 64);
      const auto exact = crossings.exact(std::array{side});
      expect_contains(balls.a, exact.a);
      expect_contains(balls.b, exact.b);
      const auto back = compose(exact, crossings.exact(std::array{(side + 2 * genus) % (4 * genus)}));
      EXPECT_TRUE(is_zero(back.b));
      EXPECT_EQ(sign(twice_imaginary(back.a)), 0);
    }
  }
}

/// The vertex k of the polygon: tanh(R/2) e^{i(2k−1)π/(4g)} with cosh R = cot²(π/(4g)).
ComplexBall polygon_vertex(std::uint32_t genus, std::uint32_t k) {
  ComplexBall vertex;
  Ball cosh, sinh, radius, root;
  set_regular_apothem(cosh.get(), sinh.get(), genus, 128);
  arb_sqr(cosh.get(), cosh.get(), 128);
  arb_sub_ui(radius.get(), cosh.get(), 1, 128);
  arb_add_ui(root.get(), cosh.get(), 1, 128);
  arb_div(radius.get(), radius.get(), root.get(), 128);
  arb_sqrt(radius.get(), radius.get(), 128);
  set_regular_direction(vertex.get(), 2 * genus, 2 * k + 8 * genus - 1, 128);
  acb_mul_arb(vertex.get(), vertex.get(), radius.get(), 128);
  return vertex;
}

TEST(RegularCrossings, EveryShortWordIsTheProductOfItsLetters) {
  for (const std::uint32_t genus : {2U, 3U}) {
    const RegularCrossings crossings(genus);
    const auto expect_equal = [](const Isometry<RegularNumber>& f, const Isometry<RegularNumber>& g) {
      // Real multiples are the same: f.a g.b = f.b g.a and f.a conj(g.a) real, and the like for b.
      EXPECT_TRUE(is_zero(f.a * g.b - f.b * g.a));
      EXPECT_EQ(sign(twice_imaginary(f.a * conjugate(g.a))), 0);
      EXPECT_EQ(sign(twice_imaginary(f.b * conjugate(g.b))), 0);
    };
    const Isometry<RegularNumber> nothing = crossings.exact({});
    EXPECT_TRUE(is_zero(nothing.b));
    EXPECT_EQ(sign(twice_imaginary(nothing.a)), 0);
    EXPECT_EQ(sign(norm(nothing.a)), 1);
    for (std::uint32_t j = 0; j < 4 * genus; ++j) {
      for (std::uint32_t k = 0; k < 4 * genus; ++k) {
        if (j == 2 * genus || k == (j + 2 * genus) % (4 * genus)) continue;
        SCOPED_TRACE(std::to_string(genus) + ": " + std::to_string(j) + ", " + std::to_string(k));
        const std::array<std::uint32_t, 3> word{0, j, k};
        const auto letter = [&](std::size_t i) { return crossings.exact(std::array{word[i]}); };
        expect_equal(crossings.exact(word), compose(letter(2), compose(letter(1), letter(0))));
      }
    }
  }
}

TEST(RegularCrossings, SidesGoToTheirPartnersReversed) {
  for (const std::uint32_t genus : {2U, 3U, 10U}) {
    const RegularCrossings crossings(genus);
    const auto sides = 4 * genus;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const BallIsometry f = crossings.balls(k, 128);
      for (const std::uint32_t end : {0U, 1U}) {
        const ComplexBall z = polygon_vertex(genus, k + end);
        ComplexBall numerator, denominator, conjugate_b;
        acb_mul(numerator.get(), f.a.get(), z.get(), 128);
        acb_add(numerator.get(), numerator.get(), f.b.get(), 128);
        acb_conj(conjugate_b.get(), f.b.get());
        acb_mul(denominator.get(), conjugate_b.get(), z.get(), 128);
        acb_add(denominator.get(), denominator.get(), f.a.get(), 128);
        acb_div(numerator.get(), numerator.get(), denominator.get(), 128);
        const ComplexBall target = polygon_vertex(genus, (k + 2 * genus + 1 - end) % sides);
        EXPECT_TRUE(acb_overlaps(numerator.get(), target.get())) << genus << ' ' << k;
        EXPECT_GT(acb_rel_accuracy_bits(numerator.get()), 60);
      }
    }
  }
}

TEST(RegularCrossings, TheCornersCloseUpExactlyAndNotBefore) {
  for (std::uint32_t genus = 2; genus <= 12; ++genus) {
    SurfaceDocument surface;
    surface.regular_genus = genus;
    const SurfaceSides sides(surface);
    const RegularCrossings crossings(genus);
    auto product = crossings.embed(exact_identity());
    std::uint32_t side = 0;
    for (std::uint32_t count = 1; count <= 4 * genus; ++count) {
      product = compose(crossings.exact(std::array{side}), product);
      side = sides.next_around(side);
      EXPECT_EQ(is_zero(product.b), count == 4 * genus);
      EXPECT_EQ(side == 0, count == 4 * genus);
    }
    EXPECT_EQ(sign(twice_imaginary(product.a)), 0);
  }
}

/// The integer as itself, as a sum of ones that are doubled, and as a product of twos and sums with one.
enum class Made { asItIs, bySums, byProducts };
RegularNumber integer(const RegularRing& ring, long value, Made made) {
  if (made == Made::asItIs) return integer(ring, value);
  RegularNumber result = integer(ring, 0);
  const unsigned long size = value < 0 ? -static_cast<unsigned long>(value) : static_cast<unsigned long>(value);
  for (int bit = 63; bit >= 0; --bit) {
    if (made == Made::bySums) {
      result = result + result;
    } else if (result.expression) {
      result = integer(ring, 2) * result;
    }
    if (size >> bit & 1U) result = result + integer(ring, 1);
  }
  return value < 0 ? integer(ring, 0) - result : result;
}

TEST(RegularNumber, NumbersThatArePrimesOfTheFirstFieldsAreNotZero) {
  // c₀ + c₁√2 + c₂s + c₃√2s of genus 2 that is 0 modulo a prime near 2⁶², with c as small as can be: its norm is hardly
  // more than the prime. A norm bounded by half of its bits, or without the bits of sums, would call it 0.
  const RegularRing ring(2);
  const RegularNumber root = twice_real(power_of_zeta(ring, 1));
  const RegularNumber s = regular_s(ring);
  const double root_value = std::sqrt(2);
  const double s_value = std::sqrt((1 + root_value) * (1 + root_value) - 1);
  int seen = 0;
  ulong p = (ulong{1} << 62) + 1;
  for (int primes = 0; primes < 8; ++primes) {
    do p -= 8;
    while (!n_is_prime(p));
    const ulong r = n_sqrtmod(2, p);
    ASSERT_NE(r, 0U);
    for (const ulong root_residue : {r, p - r}) {
      // s² = a² − 1 with a = 1 + √2.
      const ulong a = n_addmod(1, root_residue, p);
      const ulong s_residue = n_sqrtmod(n_submod(n_mulmod2(a, a, p), 1, p), p);
      if (s_residue == 0) continue;
      for (const ulong t : {s_residue, p - s_residue}) {
        fmpz_mat_t basis;
        fmpz_mat_init(basis, 4, 4);
        fmpz_set_ui(fmpz_mat_entry(basis, 0, 0), p);
        const std::array<ulong, 3> residues{root_residue, t, n_mulmod2(root_residue, t, p)};
        for (slong i = 1; i < 4; ++i) {
          fmpz_set_ui(fmpz_mat_entry(basis, i, 0), p - residues[static_cast<std::size_t>(i - 1)]);
          fmpz_one(fmpz_mat_entry(basis, i, i));
        }
        fmpz_lll_t lll;
        fmpz_lll_context_init_default(lll);
        fmpz_lll(basis, nullptr, lll);
        for (slong i = 0; i < 4; ++i) {
          std::array<long, 4> c{};
          for (slong k = 0; k < 4; ++k) c[static_cast<std::size_t>(k)] = fmpz_get_si(fmpz_mat_entry(basis, i, k));
          const double value = static_cast<double>(c[0]) + static_cast<double>(c[1]) * root_value +
                               s_value * (static_cast<double>(c[2]) + static_cast<double>(c[3]) * root_value);
          if (std::fabs(value) < 1) continue;
          ++seen;
          for (const Made made : {Made::asItIs, Made::bySums, Made::byProducts}) {
            const auto number = [&](std::size_t k) { return integer(ring, c[k], made); };
            const RegularNumber x = number(0) + number(1) * root + (number(2) + number(3) * root) * s;
            EXPECT_EQ(sign(x), value > 0 ? 1 : -1);
            EXPECT_EQ(sign(x - x), 0);
          }
        }
        fmpz_mat_clear(basis);
      }
    }
  }
  EXPECT_GT(seen, 16);
}

}  // namespace
}  // namespace epsnet::certify
