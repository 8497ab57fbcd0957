#include "certify/numbers/exact.h"

#include <gtest/gtest.h>

namespace epsnet::certify {
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

}  // namespace
}  // namespace epsnet::certify
