
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "tests/kernel/random_points.h"
#include "tests/kernel/rational_points.h"

namespace epsnet::lorentz_test {
namespace {

using test::rational_isometry;
using test::rational_point;

using Vector = LorentzVector<Rational>;

bool equal(const Vector& u, const Vector& v) { return u.x == v.x && u.y == v.y && u.t == v.t; }

RC_GTEST_PROP(LorentzProperty, PointsAreVectorsOfSquareMinusOne, ()) {
  const Complex<Rational> z = rational_point();
  const Vector v = on_hyperboloid(z);
  RC_ASSERT(lorentz_product(v, v) == -1);
  RC_ASSERT(in_disk(v) == z);
}

/// −⟨X, Y⟩ = cosh d = 1 + 2 sinh²(d/2).
RC_GTEST_PROP(LorentzProperty, ProductOfPointsIsTheirDistance, ()) {
  const auto z = rational_point(), w = rational_point();
  RC_ASSERT(-lorentz_product(on_hyperboloid(z), on_hyperboloid(w)) == 1 + 2 * sinh2_half_distance(z, w));
}

/// Up to the determinant, as square roots are not rational.
RC_GTEST_PROP(LorentzProperty, IsometriesActAsInTheDisk, ()) {
  const Isometry<Rational> f = rational_isometry();
  const Complex<Rational> z = rational_point();
  RC_ASSERT(equal(image(f, on_hyperboloid(z)), f.determinant() * on_hyperboloid(f(z))));
}

RC_GTEST_PROP(LorentzProperty, CrossIsTheDeterminant, ()) {
  const Vector u = on_hyperboloid(rational_point());
  const Vector v = on_hyperboloid(rational_point());
  const Vector c = lorentz_cross(u, v);
  RC_ASSERT(lorentz_product(c, u) == 0);
  RC_ASSERT(lorentz_product(c, v) == 0);
  const Vector w = on_hyperboloid(rational_point());
  const Rational determinant =
      u.x * (v.y * w.t - v.t * w.y) - u.y * (v.x * w.t - v.t * w.x) + u.t * (v.x * w.y - v.y * w.x);
  RC_ASSERT(lorentz_product(c, w) == determinant);
}

/// The normal of the axis is fixed by the isometry, and its square is the discriminant.
RC_GTEST_PROP(LorentzProperty, AxisNormalIsFixed, ()) {
  const Isometry<Rational> f = rational_isometry();
  const Vector n = axis_normal(f);
  RC_ASSERT(lorentz_product(n, n) == isometry_discriminant(f));
  RC_ASSERT(equal(image(f, n), f.determinant() * n));
}

TEST(Lorentz, TheLeftOfAnAxisIsPositive) {
  const Isometry<Rational> f = Isometry<Rational>::translation({Rational(1, 2), 0});
  EXPECT_GT(lorentz_product(axis_normal(f), on_hyperboloid(Complex<Rational>{0, Rational(1, 2)})), 0);
}

}  // namespace
}  // namespace epsnet::lorentz_test
