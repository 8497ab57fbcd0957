#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>
#include <flint/ulong_extras.h>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

#include "certify/net/labels.h"
#include "certify/net/numbering.h"

namespace epsnet::certify::regular_number_test {
namespace {

RegularNumber integer(const RegularRing& ring, const mpz_class& value) { return regular_number(ring, {value, 0}); }
RegularNumber power_of_zeta(const RegularRing& ring, std::int64_t k) {
  return regular_number(ring, std::array{PowerOfZeta{1, k}}, {});
}
RegularNumber regular_s(const RegularRing& ring) { return regular_number(ring, {}, std::array{PowerOfZeta{1, 0}}); }

/// Those of the 4g-gon with opposite sides glued.
RegularCrossings regular_polygon(std::uint32_t genus) {
  SurfaceDocument surface;
  surface.regular_genus = genus;
  return {*regular_tile(surface), SurfaceSides(surface).partner};
}

/// The crossing of one side, and what it is multiplied by.
Isometry<RegularNumber> crossing(const RegularCrossings& crossings, std::uint32_t side) {
  return crossings.turn(side, 1, Turn::clockwise);
}
RegularNumber scale(const RegularRing& ring) {
  const RegularNumber c = integer(ring, 2) - twice_real(power_of_zeta(ring, 1));
  return c * c;
}
bool is_zero(const RegularNumber& x) { return sign(norm(x)) == 0; }

/// The ball contains the real number x/divisor, by exact comparisons with its ends.
void expect_contains(const Ball& ball, const RegularNumber& x, const RegularNumber& divisor) {
  const Interval interval = outer_interval(ball);
  EXPECT_LT(interval.upper - interval.lower, 1e-9);
  for (const auto& [end, wanted] : {std::pair{interval.lower, 1}, std::pair{interval.upper, -1}}) {
    const mpq_class value(end);
    const int side = sign(value.get_den() * x - value.get_num() * divisor);
    EXPECT_TRUE(side == 0 || side == wanted);
  }
}

void expect_contains(const ComplexBall& ball, const RegularNumber& x, const RegularNumber& divisor) {
  expect_contains(twice(real(ball)), twice_real(x), divisor);
  expect_contains(twice(imaginary(ball)), twice_imaginary(x), divisor);
}

TEST(RegularNumber, CrossingsAreWhatTheFormulaSays) {
  for (std::uint32_t genus = 2; genus <= 30; ++genus) {
    const RegularCrossings crossings = regular_polygon(genus);
    const RegularRing& ring = crossings.ring();
    const RegularNumber zeta = power_of_zeta(ring, 1);
    const RegularNumber one = integer(ring, 1);
    const auto [a, b] = crossing(crossings, 0);
    // cosh ρ = i(ζ + 1)/(ζ − 1), sinh²ρ = cosh²ρ − 1; b is negative.
    EXPECT_TRUE(is_zero(a * (zeta - one) - Gaussian{0, 1} * ((zeta + one) * scale(ring))));
    EXPECT_TRUE(is_zero(b * b + scale(ring) * scale(ring) - a * a));
    EXPECT_EQ(sign(a), 1);
    EXPECT_EQ(sign(b), -1);
    EXPECT_TRUE(is_zero(crossing(crossings, 3).b - power_of_zeta(ring, 3) * b));
  }
}

TEST(RegularNumber, ZeroIsFoundWhereverTheLeastRelationHides) {
  for (std::uint32_t genus = 2; genus <= 40; ++genus) {
    const RegularCrossings crossings = regular_polygon(genus);
    const RegularRing& ring = crossings.ring();
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
  const Precision scope(4000);
  for (const std::uint32_t genus : {2U, 3U, 7U, 20U}) {
    const RegularCrossings crossings = regular_polygon(genus);
    const RegularRing& ring = crossings.ring();
    // 2 cos θ, and s² = 2(2 − 2 cos θ)·2 cos θ.
    const Ball cosine = twice(real(root_of_unity(1, 4 * genus)));
    const Ball s = sqrt(twice((2 - cosine) * cosine));
    const RegularNumber zeta = power_of_zeta(ring, 1);
    for (const auto& [ball, number] : {std::pair{cosine, twice_real(zeta)}, std::pair{s, regular_s(ring)}}) {
      // The integer below 2^3000 times the number.
      const Ball product = scaled(ball, 3000);
      Ball below;
      arb_floor(below.get(), product.get(), 4000);
      Integer floor;
      ASSERT_TRUE(arb_get_unique_fmpz(floor.get(), below.get()));
      const mpz_class factor = mpz_class(1) << 3000;
      EXPECT_EQ(sign(factor * number - integer(ring, floor.value())), 1);
      EXPECT_EQ(sign(factor * number - integer(ring, floor.value() + 1)), -1);
    }
    EXPECT_EQ(sign(integer(ring, 0)), 0);
  }
}

TEST(RegularNumber, MultiplesOfManyPrimesAreNotZero) {
  // Not even of primes of which the field has all roots of unity of order 4g.
  for (const std::uint32_t genus : {2U, 3U, 7U}) {
    const RegularCrossings crossings = regular_polygon(genus);
    const RegularRing& ring = crossings.ring();
    const mpz_class order = 4 * genus;
    mpz_class p = (mpz_class(1) << 62) / order * order + 1;
    mpz_class product = 1;
    for (int found = 0; found < 40; p -= order) {
      if (p >= mpz_class(1) << 62 || mpz_probab_prime_p(p.get_mpz_t(), 30) == 0) continue;
      product *= p;
      ++found;
    }
    for (const RegularNumber& x : {integer(ring, 1), crossing(crossings, 0).a, regular_s(ring)}) {
      EXPECT_EQ(sign(product * x), 1);
      EXPECT_EQ(sign(mpz_class(-product) * x), -1);
      EXPECT_EQ(sign(product * x - product * x), 0);
    }
  }
}

/// Powers of (√2 − 1)³(√3 − √2)²(2 − √3)², of which the other conjugates are large.
TEST(RegularNumber, NumbersThatAreAsSmallAsCanBeAreNotZero) {
  const RegularRing ring(8, std::array{PowerOfZeta{3, 0}});
  const RegularNumber two = twice_real(power_of_zeta(ring, 1));
  const RegularNumber three = regular_s(ring);
  const RegularNumber first = two - integer(ring, 1);
  const RegularNumber second = three - two;
  const RegularNumber third = integer(ring, 2) - three;
  RegularNumber small = first * first * first * second * second * third * third;
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(sign(small), 1) << i;
    EXPECT_EQ(sign(mpz_class(-1) * small), -1) << i;
    EXPECT_EQ(sign(small - small), 0) << i;
    small = small * small;
  }
}

/// (1 + √2)² = 3 + 2√2 has no new root, in whatever order its terms are.
TEST(RegularNumber, ARootThatIsNotNewIsTheNumber) {
  const auto by_power = [](const PowerOfZeta& x, const PowerOfZeta& y) { return x.power < y.power; };
  std::vector<PowerOfZeta> square{{2, -1}, {3, 0}, {2, 1}};
  do {
    const RegularRing ring(8, square);
    EXPECT_FALSE(ring.has_new_root());
    const RegularNumber known = integer(ring, 1) + twice_real(power_of_zeta(ring, 1));
    EXPECT_EQ(sign(regular_s(ring) - known), 0);
    EXPECT_EQ(sign(regular_s(ring) + known), 1);
  } while (std::next_permutation(square.begin(), square.end(), by_power));
}

TEST(RegularNumber, TurnsAreProductsOfCrossings) {
  for (const std::uint32_t genus : {2U, 3U, 4U, 6U, 15U}) {
    const RegularCrossings crossings = regular_polygon(genus);
    const RegularRing& ring = crossings.ring();
    for (const Turn turn : {Turn::clockwise, Turn::counterclockwise}) {
      const std::uint32_t step = turn == Turn::clockwise ? 2 * genus + 1 : 2 * genus - 1;
      for (const std::uint32_t start : {0U, 1U, 3 * genus}) {
        Isometry<RegularNumber> product = crossing(crossings, start);
        RegularNumber factor = integer(ring, 1);
        for (std::uint32_t count = 1; count <= 4 * genus + 2; ++count) {
          const Isometry<RegularNumber> closed = crossings.turn(start, count, turn);
          EXPECT_TRUE(is_zero(factor * closed.a - product.a)) << genus << ' ' << start << ' ' << count;
          EXPECT_TRUE(is_zero(factor * closed.b - product.b)) << genus << ' ' << start << ' ' << count;
          product = compose(crossing(crossings, (start + count * step) % (4 * genus)), product);
          factor = factor * scale(ring);
        }
      }
    }
  }
}

TEST(RegularNumber, TurnsMayBeLongerThanOnceAround) {
  const std::uint32_t genus = 33;
  const RegularCrossings crossings = regular_polygon(genus);
  const RegularRing& ring = crossings.ring();
  for (const Turn turn : {Turn::clockwise, Turn::counterclockwise}) {
    const std::uint32_t step = turn == Turn::clockwise ? 2 * genus + 1 : 2 * genus - 1;
    for (const std::uint32_t count : {1U, 62U, 63U, 64U, 65U, 127U, 128U, 131U, 132U, 133U, 200U, 1000U, 100'000U}) {
      const Isometry<RegularNumber> before = crossings.turn(5, count, turn);
      const Isometry<RegularNumber> after = crossings.turn(5, count + 1, turn);
      const Isometry<RegularNumber> product = compose(crossing(crossings, (5 + count * step) % (4 * genus)), before);
      EXPECT_TRUE(is_zero(scale(ring) * after.a - product.a)) << count;
      EXPECT_TRUE(is_zero(scale(ring) * after.b - product.b)) << count;
      EXPECT_FALSE(is_zero(after.b - before.b)) << count;
    }
  }
}

TEST(RegularNumber, MultiplesAreSums) {
  for (const std::uint32_t genus : {2U, 5U}) {
    const RegularCrossings crossings = regular_polygon(genus);
    const RegularRing& ring = crossings.ring();
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

TEST(RegularNumber, TurnsHaveTheSignsOfTheirProducts) {
  // Many times around a corner.
  for (const std::uint32_t genus : {2U, 3U, 4U}) {
    const RegularCrossings crossings = regular_polygon(genus);
    std::array<std::complex<double>, 4> product{1, 0, 0, 1};
    for (std::uint32_t count = 1; count <= 30 * genus; ++count) {
      const auto m = embedded_crossing(genus, 1, (count - 1) * (2 * genus + 1) % (4 * genus));
      product = {m[0] * product[0] + m[1] * product[2], m[0] * product[1] + m[1] * product[3],
                 m[2] * product[0] + m[3] * product[2], m[2] * product[1] + m[3] * product[3]};
      const Isometry<RegularNumber> turn = crossings.turn(0, count, Turn::clockwise);
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

TEST(RegularNumber, GaussianIntegersAreANumberOfTheRing) {
  const RegularCrossings crossings = regular_polygon(5);
  const RegularRing& ring = crossings.ring();
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
    const RegularCrossings crossings = regular_polygon(genus);
    ASSERT_EQ(crossings.size(), 4 * genus);
    for (std::uint32_t side = 0; side < 4 * genus; ++side) {
      const BallIsometry balls = crossings.balls(side, 64);
      const auto exact = crossings.exact(std::array{side});
      expect_contains(balls.a, exact.a, scale(crossings.ring()));
      expect_contains(balls.b, exact.b, scale(crossings.ring()));
      const auto back = compose(exact, crossings.exact(std::array{(side + 2 * genus) % (4 * genus)}));
      EXPECT_TRUE(is_zero(back.b));
      EXPECT_EQ(sign(twice_imaginary(back.a)), 0);
    }
  }
}

/// The vertex k of the polygon: tanh(R/2) e^{i(2k−1)π/(4g)} with cosh R = cot²(π/(4g)).
ComplexBall polygon_vertex(std::uint32_t genus, std::uint32_t k) {
  const Ball cosh = sqr(real(regular_crossing({4 * genus, 4 * genus}, 0, 2 * genus, 128).a));
  return sqrt((cosh - 1) / (cosh + 1)) * root_of_unity(2 * k + 8 * genus - 1, 8 * genus);
}

TEST(RegularCrossings, EveryShortWordIsTheProductOfItsLetters) {
  for (const std::uint32_t genus : {2U, 3U}) {
    const RegularCrossings crossings = regular_polygon(genus);
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
  const Precision scope(128);
  for (const std::uint32_t genus : {2U, 3U, 10U}) {
    const RegularCrossings crossings = regular_polygon(genus);
    const auto sides = 4 * genus;
    for (std::uint32_t k = 0; k < sides; ++k) {
      const BallIsometry f = crossings.balls(k, 128);
      for (const std::uint32_t end : {0U, 1U}) {
        const ComplexBall z = polygon_vertex(genus, k + end);
        ComplexBall image = f.a * z + f.b;
        const ComplexBall denominator = conjugate(f.b) * z + f.a;
        acb_div(image.get(), image.get(), denominator.get(), 128);
        const ComplexBall target = polygon_vertex(genus, (k + 2 * genus + 1 - end) % sides);
        EXPECT_FALSE(certainly_different(image, target)) << genus << ' ' << k;
        EXPECT_GT(acb_rel_accuracy_bits(image.get()), 60);
      }
    }
  }
}

TEST(RegularCrossings, TheCornersCloseUpExactlyAndNotBefore) {
  for (std::uint32_t genus = 2; genus <= 12; ++genus) {
    SurfaceDocument surface;
    surface.regular_genus = genus;
    const SurfaceSides sides(surface);
    const RegularCrossings crossings = regular_polygon(genus);
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
    } else {
      result = integer(ring, 2) * result;
    }
    if (size >> bit & 1U) result = result + integer(ring, 1);
  }
  return value < 0 ? integer(ring, 0) - result : result;
}

TEST(RegularNumber, RegularMapsHaveARingToo) {
  // {p,q}: R turns the p-gon with angles 2π/q by 2π/p, H is the half-turn about the midpoint of a side; both generate
  // the triangle group with R^p = H² = (RH)^q = 1. With 2 sin(π/p) sinh ρ = s and 2 sin(π/p) cosh ρ = 2 cos(π/q).
  for (const auto& [p, q] : {std::pair{7, 3}, std::pair{3, 7}, std::pair{8, 3}, std::pair{5, 4}, std::pair{4, 5}}) {
    const auto half = std::lcm(std::lcm(p, q), 2);
    const std::int64_t at_p = half / p, at_q = half / q;  // ζ^at_p = e^{iπ/p}.
    const std::array<PowerOfZeta, 4> square{{{1, 2 * at_p}, {1, -2 * at_p}, {1, 2 * at_q}, {1, -2 * at_q}}};
    const RegularRing ring(static_cast<std::uint32_t>(2 * half), square);
    const Isometry<RegularNumber> turn{power_of_zeta(ring, at_p), integer(ring, 0)};
    const Isometry<RegularNumber> flip{Gaussian{0, 1} * twice_real(power_of_zeta(ring, at_q)),
                                       Gaussian{0, -1} * regular_s(ring)};
    SCOPED_TRACE(std::to_string(p) + ", " + std::to_string(q));
    const auto expect_order = [](const Isometry<RegularNumber>& f, int order) {
      Isometry<RegularNumber> power = f;
      for (int k = 1; k <= order; ++k, power = compose(f, power)) {
        const bool is_one = is_zero(power.b) && sign(twice_imaginary(power.a)) == 0;
        EXPECT_EQ(is_one, k == order) << k;
      }
    };
    expect_order(turn, p);
    expect_order(flip, 2);
    expect_order(compose(turn, flip), q);
  }
}

TEST(RegularNumber, NumbersThatAreZeroModuloALargePrimeAreNotZero) {
  // c₀ + c₁√2 + c₂s + c₃√2s of genus 2 that is 0 modulo a prime near 2⁶², with c as small as can be: its norm is hardly
  // more than the prime.
  const RegularCrossings crossings = regular_polygon(2);
  const RegularRing& ring = crossings.ring();
  const RegularNumber root = twice_real(power_of_zeta(ring, 1));
  const RegularNumber s = regular_s(ring);
  const double root_value = std::sqrt(2);
  const double s_value = std::sqrt(4 * root_value - 4);
  int seen = 0;
  ulong p = (ulong{1} << 62) + 1;
  for (int primes = 0; primes < 8; ++primes) {
    do p -= 8;
    while (!n_is_prime(p));
    const ulong r = n_sqrtmod(2, p);
    ASSERT_NE(r, 0U);
    for (const ulong root_residue : {r, p - r}) {
      // s² = 4√2 − 4.
      const ulong s_residue = n_sqrtmod(n_mulmod2(4, n_submod(root_residue, 1, p), p), p);
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
}  // namespace epsnet::certify::regular_number_test
