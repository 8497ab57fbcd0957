#include <epsnet/certify/crossings.h>
#include <epsnet/certify/surface_sides.h>
#include <gtest/gtest.h>

#include <vector>

namespace epsnet::certify {
namespace {

RegularNumber power_of_zeta(const RegularRing& ring, slong k) {
  RegularNumber result{&ring, {}, {}};
  fmpz_poly_set_coeff_si(result.even.get(), k, 1);
  return result;
}

RegularNumber integer(const RegularRing& ring, const mpz_class& value) { return regular_number(ring, {value, 0}); }
RegularNumber cotangent(const RegularRing& ring) { return {&ring, ring.cotangent(), {}}; }

RegularNumber s(const RegularRing& ring) {
  RegularNumber result{&ring, {}, {}};
  fmpz_poly_set_coeff_si(result.odd.get(), 0, 1);
  return result;
}

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
    EXPECT_TRUE(is_zero(s(ring) * s(ring) + one - cotangent(ring) * cotangent(ring)));
    Ball cosh, sinh;
    set_regular_apothem(cosh.get(), sinh.get(), genus, 64);
    expect_contains(cosh.get(), cotangent(ring));
    expect_contains(sinh.get(), s(ring));
  }
}

TEST(RegularNumber, ZeroIsFoundWhereverTheLeastRelationHides) {
  for (std::uint32_t genus = 2; genus <= 40; ++genus) {
    const RegularRing ring(genus);
    // ζ^(2g) + 1 = 0 is used in calculations; for odd divisors p of g, 1 − ζ^(2g/p) + ζ^(4g/p) − … = 0 is not.
    for (std::uint32_t p = 3; p <= genus; p += 2) {
      if (genus % p != 0) continue;
      RegularNumber sum = integer(ring, 0);
      for (std::uint32_t k = 0; k < p; ++k) {
        sum = sum + mpz_class(k % 2 == 0 ? 1 : -1) * power_of_zeta(ring, slong{k} * (2 * genus / p));
      }
      EXPECT_FALSE(fmpz_poly_is_zero(sum.even.get()));
      EXPECT_TRUE(is_zero(sum));
      EXPECT_TRUE(is_zero(sum * s(ring)));
      EXPECT_EQ(sign(norm(sum + integer(ring, 1)) - integer(ring, 1)), 0);
    }
    EXPECT_FALSE(is_zero(power_of_zeta(ring, 1) - integer(ring, 1)));
    EXPECT_FALSE(is_zero(s(ring)));
  }
}

TEST(RegularNumber, SignsOfNumbersThatAreNearlyZero) {
  for (const std::uint32_t genus : {2U, 3U, 7U, 20U}) {
    const RegularRing ring(genus);
    Ball cosh, sinh;
    set_regular_apothem(cosh.get(), sinh.get(), genus, 4000);
    for (const auto& [ball, number] : {std::pair{&cosh, cotangent(ring)}, std::pair{&sinh, s(ring)}}) {
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
      const auto exact = crossings.exact(side);
      expect_contains(balls.a, exact.a);
      expect_contains(balls.b, exact.b);
      const auto back = compose(exact, crossings.exact((side + 2 * genus) % (4 * genus)));
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
    Surface surface;
    surface.regular_genus = genus;
    const SurfaceSides sides(surface);
    const RegularCrossings crossings(genus);
    auto product = crossings.embed(exact_identity());
    std::uint32_t side = 0;
    for (std::uint32_t count = 1; count <= 4 * genus; ++count) {
      product = compose(crossings.exact(side), product);
      side = sides.next[sides.partner[side]];
      EXPECT_EQ(is_zero(product.b), count == 4 * genus);
      EXPECT_EQ(side == 0, count == 4 * genus);
    }
    EXPECT_EQ(sign(twice_imaginary(product.a)), 0);
  }
}

}  // namespace
}  // namespace epsnet::certify
