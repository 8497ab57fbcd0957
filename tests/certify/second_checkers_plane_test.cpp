#include <array>
#include <gtest/gtest.h>
#include <vector>

#include "certify/exact/plane.h"

/// The second checker's points and isometries: what they are by what they do to points with rational coordinates.
namespace epsnet::exact::second_checkers_plane_test {
namespace {

using Number = Complex<mpz_class>;
using Rational = Complex<mpq_class>;

Number number(int re, int im) { return {re, im}; }

Rational quotient(const Rational& x, const Rational& y) { return mpq_class(1 / norm(y)) * (x * conjugate(y)); }
bool equal(const Rational& x, const Rational& y) { return x.re == y.re && x.im == y.im; }

/// (az + b)/(b̄z + ā)
Rational image_of(const Isometry<mpz_class>& f, const Rational& z) {
  const Rational a{f.a.re, f.a.im};
  const Rational b{f.b.re, f.b.im};
  return quotient(a * z + b, conjugate(b) * z + conjugate(a));
}

/// No isometry but the identity leaves all of them where they are.
const std::array<Rational, 3> kPoints{Rational{0, 0}, Rational{mpq_class(1, 2), 0}, Rational{0, mpq_class(1, 3)}};

using Images = std::array<Rational, 3>;

Images images_of(const Isometry<mpz_class>& f) {
  return {image_of(f, kPoints[0]), image_of(f, kPoints[1]), image_of(f, kPoints[2])};
}
bool equal(const Images& x, const Images& y) { return equal(x[0], y[0]) && equal(x[1], y[1]) && equal(x[2], y[2]); }

/// All with numbers from −2 to 2.
std::vector<Isometry<mpz_class>> small_isometries() {
  std::vector<Isometry<mpz_class>> result;
  for (int n = 0; n < 625; ++n) {
    const Isometry<mpz_class> f{number(n % 5 - 2, n / 5 % 5 - 2), number(n / 25 % 5 - 2, n / 125 - 2)};
    if (norm(f.a) > norm(f.b)) result.push_back(f);
  }
  return result;
}

TEST(SecondCheckersPlane, IsometriesAreWhatTheyDo) {
  const auto isometries = small_isometries();
  ASSERT_GT(isometries.size(), 200U);
  std::vector<Images> images;
  for (const Isometry<mpz_class>& f : isometries) images.push_back(images_of(f));
  for (std::size_t i = 0; i < isometries.size(); ++i) {
    const Isometry<mpz_class>& f = isometries[i];
    EXPECT_EQ(is_identity(f), equal(images[i], kPoints));
    EXPECT_TRUE(is_identity(compose(f, inverse(f))));
    Isometry<mpz_class> multiple{mpz_class(-6) * f.a, mpz_class(-6) * f.b};
    EXPECT_TRUE(are_equal(f, multiple));
    reduce(multiple);
    EXPECT_TRUE(equal(images_of(multiple), images[i]));
    EXPECT_LE(bits(multiple), bits(f));
    for (std::size_t j = 0; j < isometries.size(); ++j)
      ASSERT_EQ(are_equal(f, isometries[j]), equal(images[i], images[j])) << i << ' ' << j;
    for (std::size_t j = i % 29; j < isometries.size(); j += 29) {
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_TRUE(equal(image_of(compose(f, isometries[j]), kPoints.at(k)), image_of(f, images[j].at(k))));
    }
  }
}

/// Vectors of points, in any scale, and of their images.
TEST(SecondCheckersPlane, VectorsAreThoseOfPoints) {
  for (const Isometry<mpz_class>& f : small_isometries()) {
    for (const Rational& z : kPoints) {
      const mpz_class m = lcm(z.re.get_den(), z.im.get_den());
      const Point<mpz_class> point{{mpz_class(z.re * m), mpz_class(z.im * m)}, m};
      const Rational w = image_of(f, z);
      const mpz_class n = lcm(w.re.get_den(), w.im.get_den());
      const Point<mpz_class> moved{{mpz_class(w.re * n), mpz_class(w.im * n)}, n};
      EXPECT_TRUE(are_parallel(image(f, minkowski_vector(point)), minkowski_vector(moved)));
      EXPECT_EQ(sgn(gap(moved)), 1);
    }
  }
}

TEST(SecondCheckersPlane, VectorsAreParallelIfOneIsAMultipleOfTheOther) {
  std::vector<MinkowskiVector<mpz_class>> vectors;
  for (int n = 0; n < 125; ++n) {
    if (n / 25 != 2) vectors.push_back({n % 5 - 2, n / 5 % 5 - 2, n / 25 - 2});
  }
  for (const auto& u : vectors) {
    for (const auto& v : vectors) {
      const mpq_class factor = mpq_class(u.t) / v.t;
      EXPECT_EQ(are_parallel(u, v), factor * v.x == u.x && factor * v.y == u.y);
    }
  }
}

TEST(SecondCheckersPlane, LowestTermsAreTheSamePoint) {
  for (int n = 1; n < 50; ++n) {
    const Point<mpz_class> z = lowest_terms<mpz_class>(number(12 * n, -18 * n), 30 * n);
    EXPECT_TRUE(z.n.re == 2 && z.n.im == -3 && z.m == 5) << n;
    const Point<mpz_class> w = lowest_terms<mpz_class>(number(0, n), 2 * n + 1);
    EXPECT_TRUE(w.n.re == 0 && w.n.im == n && w.m == 2 * n + 1) << n;
  }
}

}  // namespace
}  // namespace epsnet::exact::second_checkers_plane_test
