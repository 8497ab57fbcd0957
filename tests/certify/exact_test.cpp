#include "certify/numbers/exact.h"

#include <gtest/gtest.h>

namespace epsnet::certify::exact_test {
namespace {

ExactPoint point(long x, long y, long m) { return {{x, y}, m}; }

bool same(const MovedPoint<Gaussian>& x, const ExactPoint& y) {
  const Gaussian left = y.m * x.n;
  const Gaussian right = y.n * x.d;
  return left == right;
}

using Quadrilateral = std::array<MovedPoint<Gaussian>, 4>;

TEST(Exact, CrossingExchangesTheEndsOfEqualSegments) {
  // Two segments of equal length: one is the other moved by a translation, its ends exchanged.
  const ExactIsometry f = compose(translation_to(point(1, 2, 7)), translation_to(point(-3, 1, 5)));
  for (const auto& [p, q] : {std::pair{point(1, 0, 3), point(0, 1, 2)}, std::pair{point(0, 0, 1), point(-1, -1, 9)}}) {
    const MovedPoint<Gaussian> fp = moved(f, p);
    const MovedPoint<Gaussian> fq = moved(f, q);
    const auto as_point = [](const MovedPoint<Gaussian>& z) {
      const mpz_class m = norm(z.d);
      return ExactPoint{z.n * conjugate(z.d), m};
    };
    const ExactIsometry g = crossing(p, q, as_point(fp), as_point(fq));  // p ↦ f(q), q ↦ f(p)
    EXPECT_TRUE(same(moved(g, p), as_point(fq)));
    EXPECT_TRUE(same(moved(g, q), as_point(fp)));
    EXPECT_GT(determinant(g), 0);
  }
}

TEST(Exact, CrossingOfASegmentWithItselfIsAHalfTurn) {
  const ExactPoint p = point(-1, 0, 2);
  const ExactPoint q = point(1, 0, 2);
  const ExactIsometry g = crossing(p, q, p, q);
  EXPECT_TRUE(same(moved(g, point(0, 0, 1)), point(0, 0, 1)));
  EXPECT_TRUE(is_identity(compose(g, g)));
  EXPECT_FALSE(is_identity(g));
}

TEST(Exact, PathsComposeInTheOrderOfTheWord) {
  const ExactIsometry f = translation_to(point(1, 0, 2));
  const ExactIsometry g = translation_to(point(0, 1, 3));
  const ExactIsometry h = translation_to(point(1, 1, 5));
  const std::array<const ExactIsometry*, 3> path{&f, &g, &h};
  const ExactIsometry expected = compose(h, compose(g, f));
  EXPECT_TRUE(is_identity(compose(inverse(expected), compose_path(path))));
  EXPECT_TRUE(is_identity(compose_path({})));
}

int turn(const ExactPoint& p, const ExactPoint& q, const ExactPoint& r) {
  return orientation(hyperboloid_vector(p), hyperboloid_vector(q), hyperboloid_vector(r));
}

TEST(Exact, APointThatIsNotMovedIsItself) {
  for (const ExactPoint& z : {point(0, 0, 1), point(1, -2, 7), point(-3, 1, 5)}) EXPECT_TRUE(same(moved(z), z));
}

TEST(Exact, OrientationIsHyperbolic) {
  EXPECT_EQ(turn(point(0, 0, 1), point(1, 0, 2), point(0, 1, 2)), 1);
  EXPECT_EQ(turn(point(0, 0, 1), point(0, 1, 2), point(1, 0, 2)), -1);
  EXPECT_EQ(turn(point(0, 0, 1), point(1, 1, 4), point(1, 1, 2)), 0);
  // The hyperbolic line through (1/2, ±1/2) passes the axis at 0.382; (2/5, 0) lies right of it, left of the chord.
  EXPECT_EQ(turn(point(1, -1, 2), point(1, 1, 2), point(2, 0, 5)), -1);
  EXPECT_EQ(turn(point(1, -1, 2), point(1, 1, 2), point(1, 0, 3)), 1);
}

TEST(Exact, CrossRatioSignIsTheInCircleTest) {
  const auto z = [](long x, long y) { return moved(point(x, y, 10)); };
  // Edge from (0, −3) to (0, 3), one corner on its right at (3, 0), one on its left.
  EXPECT_EQ(cross_ratio_sign(Quadrilateral{z(0, -3), z(3, 0), z(0, 3), z(-3, 0)}), 0);
  EXPECT_EQ(cross_ratio_sign(Quadrilateral{z(0, -3), z(3, 0), z(0, 3), z(-2, 0)}), 1);
  EXPECT_EQ(cross_ratio_sign(Quadrilateral{z(0, -3), z(3, 0), z(0, 3), z(-4, 0)}), -1);
}

TEST(Exact, Binary64EntersExactly) {
  const ExactPoint z = exact_point(0.1, -5e-324);
  EXPECT_EQ(mpq_class(z.n.re) / z.m, mpq_class(0.1));
  EXPECT_NE(mpq_class(z.n.re) / z.m, mpq_class(1, 10));
  EXPECT_LT(z.n.im, 0);
}

TEST(Exact, OnlyRealMultiplesOfOneAreTheIdentity) {
  for (const long k : {1, 7, -3}) EXPECT_TRUE(is_identity({{k, 0}, {0, 0}}));
  for (const long k : {1, -1}) {
    EXPECT_FALSE(is_identity({{3, k}, {0, 0}}));
    EXPECT_FALSE(is_identity({{3, 0}, {k, 0}}));
    EXPECT_FALSE(is_identity({{3, 0}, {0, k}}));
  }
}

TEST(Exact, ThreePointsOfAGeodesicHaveNoOrientation) {
  // Points of two diameters, moved: exactly on a line, and a hair beside it.
  const auto moved_point = [](const ExactPoint& z) {
    const MovedPoint<Gaussian> w = moved(translation_to(point(2, 3, 7)), z);
    return ExactPoint{w.n * conjugate(w.d), norm(w.d)};
  };
  for (const std::array<long, 2>& direction : {std::array{1L, 0L}, std::array{0L, 1L}, std::array{3L, -4L}}) {
    const long x = direction[0];
    const long y = direction[1];
    const long scale = 6'000'000'000;
    const auto at = [&](long share, long beside) {
      return moved_point(point(share * x * scale / 60 - beside * y, share * y * scale / 60 + beside * x, scale));
    };
    const ExactPoint p = at(-5, 0), q = at(1, 0), r = at(7, 0);
    for (const auto& orientation_of : {std::array{p, q, r}, std::array{q, r, p}, std::array{r, q, p}}) {
      EXPECT_EQ(orientation(hyperboloid_vector(orientation_of[0]), hyperboloid_vector(orientation_of[1]),
                            hyperboloid_vector(orientation_of[2])),
                0);
    }
    EXPECT_EQ(orientation(hyperboloid_vector(p), hyperboloid_vector(r), hyperboloid_vector(at(1, 1))), 1);
    EXPECT_EQ(orientation(hyperboloid_vector(p), hyperboloid_vector(r), hyperboloid_vector(at(1, -1))), -1);
  }
}

TEST(Exact, CoordinatesNeedNoCommonDenominator) {
  const ExactPoint z = exact_point({mpq_class(1, 6), mpq_class(-2, 9)});
  EXPECT_EQ(mpq_class(z.n.re) / z.m, mpq_class(1, 6));
  EXPECT_EQ(mpq_class(z.n.im) / z.m, mpq_class(-2, 9));
  EXPECT_GT(z.m, 0);
}

}  // namespace
}  // namespace epsnet::certify::exact_test
