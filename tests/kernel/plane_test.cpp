#include "kernel/plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "kernel/numbers.h"
#include "tests/kernel/random_points.h"
#include "tests/kernel/rational_points.h"
#include "tests/support/in_circle.h"
#include "tests/support/scale.h"

namespace epsnet::plane_test {
namespace {

using test::Random;
using test::rational_isometry;
using test::rational_point;
using test::rational_rotation;
using test::scaled;

Mp256 tolerance(int bits) { return test::power_of_two<Mp256>(-bits); }

TEST(Distance, FromTheOriginIsTwiceTheArtanhOfTheModulus) {
  EXPECT_EQ(distance(Complex<double>{0.3, 0.4}, Complex<double>{0.3, 0.4}), 0);
  // d(0, r) = 2 artanh r.
  EXPECT_NEAR(distance(Complex<double>{}, Complex<double>{0.5, 0}), 2 * std::atanh(0.5), 1e-15);
  EXPECT_NEAR(distance(Complex<double>{}, Complex<double>{0, -0.999}), 2 * std::atanh(0.999), 1e-12);
}

TEST(Distance, IsAccurateForPointsAnyDistanceApart) {
  Random random(7);
  for (int i = scaled(3000); i > 0; --i) {
    const Complex<double> p = test::point<double>(random, 0.9);
    const double apart = std::pow(10.0, -test::integer(random, 0, 15));
    const Complex<double> q = p + (0.09 * apart) * test::direction<double>(random);
    if (p == q) {
      continue;
    }
    const Mp256 exact = distance(convert<Mp256>(p), convert<Mp256>(q));
    const double relative = static_cast<double>(Mp256(Mp256(distance(p, q)) / exact - 1));
    // 1 − |z|² ≥ 0.19 loses little more than two bits.
    ASSERT_LT(std::abs(relative), 16 * 0x1p-53) << apart;
  }
}

TEST(Distance, OfPoints1e12ApartIsNotOneOfArcosh) {
  const Complex<double> p{0.25, 0.5};
  const Complex<double> q{0.25, 0.5 + 0x1p-40};
  const Mp256 exact = distance(convert<Mp256>(p), convert<Mp256>(q));
  EXPECT_NEAR(distance(p, q) / static_cast<double>(exact), 1, 1e-15);
  // arcosh(1 + δ), the form of thesis Theorem I.2, is the same function.
  const Mp256 delta = 2 * sinh2_half_distance(convert<Mp256>(p), convert<Mp256>(q));
  EXPECT_LT(abs(Mp256(exact / acosh(Mp256(1 + delta)) - 1)), tolerance(100));
}

RC_GTEST_PROP(DistanceProperty, IsSymmetric, ()) {
  const auto p = rational_point(), q = rational_point();
  RC_ASSERT(sinh2_half_distance(p, q) == sinh2_half_distance(q, p));
}
RC_GTEST_PROP(DistanceProperty, IsZeroForEqualPointsAlone, ()) {
  const auto p = rational_point(), q = rational_point();
  RC_ASSERT((sinh2_half_distance(p, q) == 0) == (p == q));
  RC_ASSERT(sinh2_half_distance(p, p) == 0);
}
RC_GTEST_PROP(DistanceProperty, ObeysTheTriangleInequality, ()) {
  const auto p = convert<Mp256>(rational_point());
  const auto q = convert<Mp256>(rational_point());
  const auto r = convert<Mp256>(rational_point());
  RC_ASSERT(distance(p, r) <= distance(p, q) + distance(q, r) + tolerance(240));
}
RC_GTEST_PROP(DistanceProperty, IsInvariantUnderIsometries, ()) {
  const auto p = rational_point(), q = rational_point();
  const Isometry<Rational> f = rational_isometry();
  RC_ASSERT(sinh2_half_distance(f(p), f(q)) == sinh2_half_distance(p, q));
  const Mp256 d = distance(convert<Mp256>(p), convert<Mp256>(q));
  RC_ASSERT(abs(Mp256(distance(convert<Mp256>(f(p)), convert<Mp256>(f(q))) - d)) < tolerance(200));
}
RC_GTEST_PROP(DistanceProperty, AddsUpAlongGeodesics, ()) {
  const Isometry<Rational> f = rational_isometry();
  std::array<int, 3> x{*rc::gen::inRange(-96, 97), *rc::gen::inRange(-96, 97), *rc::gen::inRange(-96, 97)};
  std::sort(x.begin(), x.end());
  const auto on_geodesic = [&f](int t) { return convert<Mp256>(f({Rational(t, 97), Rational(0)})); };
  const auto p = on_geodesic(x[0]), q = on_geodesic(x[1]), r = on_geodesic(x[2]);
  RC_ASSERT(abs(Mp256(distance(p, r) - distance(p, q) - distance(q, r))) < tolerance(120));
}

RC_GTEST_PROP(CircumcentreProperty, IsEquidistantAtTheCircumradius, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point();
  const auto r = sinh2_circumradius(a, b, c);
  const auto centre = circumcentre(convert<Mp256>(a), convert<Mp256>(b), convert<Mp256>(c));
  if (r.denominator > 0) {
    RC_ASSERT(centre.has_value());
    const Mp256 radius = asinh(Mp256(sqrt(static_cast<Mp256>(Rational(r.numerator / r.denominator)))));
    for (const auto& z : {a, b, c}) {
      RC_ASSERT(abs(Mp256(distance(*centre, convert<Mp256>(z)) - radius)) < tolerance(120));
    }
  } else {
    RC_TAG("no centre");
    RC_ASSERT(r.denominator == 0 || !centre.has_value());
  }
}
RC_GTEST_PROP(CircumcentreProperty, MovesWithTheTriangle, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point();
  RC_PRE(sinh2_circumradius(a, b, c).denominator > 0);
  const Isometry<Rational> f = rational_isometry();
  const auto centre = circumcentre(convert<Mp256>(a), convert<Mp256>(b), convert<Mp256>(c));
  const auto moved = circumcentre(convert<Mp256>(f(a)), convert<Mp256>(f(b)), convert<Mp256>(f(c)));
  RC_ASSERT(centre.has_value() && moved.has_value());
  RC_ASSERT(distance(convert<Mp256>(f)(*centre), *moved) < tolerance(100));
}
TEST(Circumcentre, IsAccurateInDoubleForSmallTriangles) {
  Random random(11);
  for (int i = scaled(2000); i > 0; --i) {
    // Corners about 2π/3 apart on a circle: the well-conditioned triangles of a net.
    const double size = std::pow(10.0, -test::integer(random, 1, 8));
    const Complex<double> place = test::point<double>(random, 0.7);
    std::array<Complex<double>, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = 2.1 * static_cast<double>(k) + 0.3 * test::uniform<double>(random);
      p[k] = place + size * Complex<double>{std::cos(angle), std::sin(angle)};
    }
    const auto centre = circumcentre(p[0], p[1], p[2]);
    ASSERT_TRUE(centre.has_value());
    const auto exact = circumcentre(convert<Mp256>(p[0]), convert<Mp256>(p[1]), convert<Mp256>(p[2]));
    const Complex<Mp256> off = convert<Mp256>(*centre) - *exact;
    // Rounding of the centre itself, and a few units relative to the triangle.
    ASSERT_LT(sqrt(norm(off)), 0x1p-53 * (4 + 100 * size)) << size;
  }
}
TEST(Circumcentre, OfPointsOnADiameterOrAHypercycleIsNone) {
  const Complex<double> west{-0.5, 0};
  const Complex<double> east{0.5, 0};
  EXPECT_FALSE(circumcentre(west, Complex<double>{}, east).has_value());
  EXPECT_FALSE(circumcentre(west, Complex<double>{0, -0.01}, east).has_value());
  EXPECT_FALSE(circumcentre(west, west, east).has_value());
  EXPECT_TRUE(circumcentre(west, Complex<double>{0, -0.5}, east).has_value());
}

/// Thesis Theorem I.42.
RC_GTEST_PROP(CrossRatioProperty, ImaginaryPartHasTheSignOfTheInCircleTest, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point(), d = rational_point();
  RC_PRE(!(a == d) && !(b == c));
  const Rational determinant = test::in_circle_determinant(a, b, c, d);
  // More than the sign: Im R times the square of the denominator's modulus is the determinant.
  RC_ASSERT(cross_ratio(a, b, c, d).y * norm((d - a) * (c - b)) == determinant);
}

/// Thesis Theorem I.41.
RC_GTEST_PROP(CrossRatioProperty, IsRealForCocircularPoints, ()) {
  // On the circle around 0 through a rational point, by rational rotations; then moved.
  const Complex<Rational> p{Rational(*rc::gen::inRange(1, 96), 97), Rational(0)};
  const Isometry<Rational> f = rational_isometry();
  const auto a = f(rational_rotation()(p)), b = f(rational_rotation()(p));
  const auto c = f(rational_rotation()(p)), d = f(rational_rotation()(p));
  RC_PRE(!(a == d) && !(b == c));
  RC_ASSERT(cross_ratio(a, b, c, d).y == 0);
  RC_ASSERT(test::in_circle_determinant(a, b, c, d) == 0);
}
RC_GTEST_PROP(CrossRatioProperty, IsInvariantUnderIsometries, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point(), d = rational_point();
  RC_PRE(!(a == d) && !(b == c));
  const Isometry<Rational> f = rational_isometry();
  RC_ASSERT(cross_ratio(f(a), f(b), f(c), f(d)) == cross_ratio(a, b, c, d));
}

TEST(InCircle, CentreOfACounterclockwiseCircleIsInside) {
  const Complex<Rational> east{Rational(1, 2), Rational(0)};
  const Complex<Rational> north{Rational(0), Rational(1, 2)};
  EXPECT_GT(test::in_circle_determinant(east, north, -east, {}), 0);
  EXPECT_GT(orientation_determinant(east, north, -east), 0);
  EXPECT_EQ(test::in_circle_determinant(east, north, -east, -north), 0);
}

RC_GTEST_PROP(OrientationProperty, IsTheSideSeenFromTheFirstPoint, ()) {
  // With a moved to 0 geodesics through it are straight.
  const auto a = rational_point(), b = rational_point(), c = rational_point();
  const Isometry<Rational> home = Isometry<Rational>::translation(-a);
  RC_ASSERT(sign(orientation_determinant(a, b, c)) == sign(cross(home(b), home(c))));
}

}  // namespace
}  // namespace epsnet::plane_test
