#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include "certify/claims/geodesics/crossing_search.h"

/// Parts of cones, of rays of which the third value is not known: nothing of a part is lost, whatever it is.
namespace epsnet::certify::cone_test {
namespace {

constexpr slong kBits = 128;

/// Between the ends.
template <class Number>
Number number(double lower, double upper) {
  Ball result, end;
  arb_set_d(result.get(), lower);
  arb_set_d(end.get(), upper);
  arb_union(result.get(), result.get(), end.get(), kBits);
  if constexpr (std::is_same_v<Number, Ball>) {
    return result;
  } else {
    return to_double_double(result);
  }
}

template <class Number>
Functional<Number> ray(double x, double y, double lower, double upper) {
  return {number<Number>(x, x), number<Number>(y, y), number<Number>(lower, upper)};
}

/// Whether a linear form is certainly negative on all rays.
template <class Number>
bool is_negative(const std::vector<Functional<Number>>& rays, double x, double y, double z) {
  const Functional<Number> form{number<Number>(x, x), number<Number>(y, y), number<Number>(z, z)};
  return std::all_of(rays.begin(), rays.end(),
                     [&](const auto& ray) { return certain_sign(sum_of_products(form, ray)) < 0; });
}

/// Whether a positive multiple of (x, y, z) is among the rays.
template <class Number>
bool contains(const std::vector<Functional<Number>>& rays, double x, double y, double z) {
  const auto zero = [](const auto& ray, double a, double b, double c) {
    const Functional<Number> form{number<Number>(a, a), number<Number>(b, b), number<Number>(c, c)};
    return certain_sign(sum_of_products(form, ray)) == 0;
  };
  return std::any_of(rays.begin(), rays.end(), [&](const auto& ray) {
    const Functional<Number> form{number<Number>(x, x), number<Number>(y, y), number<Number>(z, z)};
    return certain_sign(sum_of_products(form, ray)) > 0 && zero(ray, 0, z, -y) && zero(ray, -z, 0, x) &&
           zero(ray, y, -x, 0);
  });
}

template <class Number>
class Cones : public testing::Test {
 protected:
  using Rays = std::vector<Functional<Number>>;

  /// In the order given, turned, and mirrored: these are the same cone.
  template <class Expect>
  void each_part(const Rays& rays, int wanted, const Expect& expect) {
    const Precision scope(kBits);
    Rays same = rays;
    for (std::size_t turn = 0; turn < 2 * rays.size(); ++turn) {
      if (turn == rays.size()) std::reverse(same.begin(), same.end());
      std::rotate(same.begin(), same.begin() + 1, same.end());
      Rays part;
      clip_cone<Number>(same, wanted, sides_, part);
      expect(part);
    }
  }

 private:
  std::vector<int> sides_;
};

using Numbers = testing::Types<Ball, DoubleDouble>;
TYPED_TEST_SUITE(Cones, Numbers, );

TYPED_TEST(Cones, OfKnownRaysArePartsWhereTheThirdValueHasTheSign) {
  // A square around (0, 0, 1), in a plane where two of its sides have a point with the third value 0.
  const auto at = [](double x, double y, double z) { return ray<TypeParam>(x, y, z, z); };
  const typename TestFixture::Rays square{at(1, 1, 1), at(-1, 1, 3), at(-1, -1, -1), at(1, -1, -3)};
  for (const int wanted : {1, -1}) {
    const double y = wanted;
    this->each_part(square, wanted, [&](const auto& part) {
      EXPECT_EQ(part.size(), 4U) << wanted;
      EXPECT_TRUE(contains(part, 1, y, wanted == 1 ? 1 : -3)) << wanted;
      EXPECT_TRUE(contains(part, -1, y, wanted == 1 ? 3 : -1)) << wanted;
      EXPECT_TRUE(contains(part, 1, 0.5, 0)) << wanted;
      EXPECT_TRUE(contains(part, -1, -0.5, 0)) << wanted;
    });
    const typename TestFixture::Rays outside{at(1, 1, -wanted), at(-1, 1, -wanted), at(0, -1, -2 * wanted)};
    this->each_part(outside, wanted, [&](const auto& part) { EXPECT_TRUE(part.empty()) << wanted; });
    const typename TestFixture::Rays inside{at(1, 1, wanted), at(-1, 1, wanted), at(0, -1, 2 * wanted)};
    this->each_part(inside, wanted, [&](const auto& part) { EXPECT_EQ(part.size(), 3U) << wanted; });
  }
}

TYPED_TEST(Cones, ARayOfUnknownSignMayBeIn) {
  // If it is, nothing else need be: x + y is positive there, and negative at the others.
  for (const int wanted : {1, -1}) {
    const typename TestFixture::Rays rays{ray<TypeParam>(1, 1, -0.5, 0.5), ray<TypeParam>(-1, 0, -wanted, -wanted),
                                          ray<TypeParam>(0, -1, -wanted, -wanted)};
    this->each_part(rays, wanted, [&](const auto& part) { EXPECT_FALSE(is_negative(part, 1, 1, 0)) << wanted; });
  }
}

TYPED_TEST(Cones, ThePartMayReachBeyondARayOfUnknownSign) {
  // Of (1, 0, h), h about 0, and two rays that are certainly out: for h = ½ the part reaches to (1, ⅓, 0) and to
  // (1, −⅓, 0), where 6y − x and −6y − x are positive. They are negative at (1, 0, h), whatever h is.
  for (const int wanted : {1, -1}) {
    const typename TestFixture::Rays rays{ray<TypeParam>(1, 0, -0.5, 0.5), ray<TypeParam>(1, 1, -wanted, -wanted),
                                          ray<TypeParam>(1, -1, -wanted, -wanted)};
    this->each_part(rays, wanted, [&](const auto& part) {
      EXPECT_FALSE(is_negative(part, -1, 6, 0)) << wanted;
      EXPECT_FALSE(is_negative(part, -1, -6, 0)) << wanted;
    });
  }
  // Next to a ray that is certainly in, too.
  for (const int wanted : {1, -1}) {
    const typename TestFixture::Rays rays{ray<TypeParam>(1, 0, -0.5, 0.5), ray<TypeParam>(1, 1, -wanted, -wanted),
                                          ray<TypeParam>(1, -1, wanted, wanted)};
    this->each_part(rays, wanted, [&](const auto& part) {
      EXPECT_FALSE(is_negative(part, -1, 6, 0)) << wanted;
      EXPECT_FALSE(is_negative(part, -1, -6, 0)) << wanted;
    });
  }
}

// The same in many steps, beside a cone in binary64.

using Vector = std::array<double, 3>;

double dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

/// Where a form has a sign, of a cone by its rays.
std::vector<Vector> true_part(const std::vector<Vector>& rays, const Vector& form, int wanted) {
  std::vector<Vector> result;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vector& x = rays[i];
    const Vector& y = rays[(i + 1) % rays.size()];
    const double f = wanted * dot(form, x);
    const double g = wanted * dot(form, y);
    if (f >= 0) result.push_back(x);
    if (f * g < 0) {
      const double scale = 1 / (std::abs(f) + std::abs(g));
      Vector between{};
      for (std::size_t k = 0; k < 3; ++k) between[k] = scale * (std::abs(g) * x[k] + std::abs(f) * y[k]);
      result.push_back(between);
    }
  }
  return result;
}

/// A form that is positive on ray i, and negative on all others.
Vector separating(const std::vector<Vector>& rays, std::size_t i) {
  const auto between = [&](std::size_t other) {
    Vector result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = 0.99 * rays[i][k] + 0.01 * rays[other][k];
    return result;
  };
  const Vector x = between((i + rays.size() - 1) % rays.size());
  const Vector y = between((i + 1) % rays.size());
  Vector form{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
  if (dot(form, rays[i]) < 0) form = {-form[0], -form[1], -form[2]};
  return form;
}

TYPED_TEST(Cones, NothingIsLostInManySteps) {
  using Ray = Functional<TypeParam>;
  const Precision scope(kBits);
  std::mt19937 random(1);  // NOLINT: the same in every run.
  const auto uniform = [&] { return static_cast<double>(random() % 20001) / 10000 - 1; };
  std::vector<int> sides;
  int compared = 0;
  for (int run = 0; run < 400; ++run) {
    // A triangle in a plane, whose third value is not known well at first.
    std::vector<Vector> truth{{1, 0, 1}, {-0.6, 0.8, 1}, {-0.5, -0.7, 1}};
    std::vector<Ray> rays;
    for (const Vector& x : truth)
      rays.push_back({number<TypeParam>(x[0], x[0]), number<TypeParam>(x[1], x[1]), number<TypeParam>(x[2], x[2])});
    for (int step = 0; step < 5; ++step) {
      // A new third value, for that or the first or the second one: of a form that vanishes on a line across the cone,
      // often near one of its rays.
      const Vector& near = truth[random() % truth.size()];
      const double close = random() % 2 == 0 ? 0.01 : 0.5;
      const Vector inside{near[0] + close * uniform(), near[1] + close * uniform(), near[2] + close * uniform()};
      const Vector direction{uniform(), uniform(), uniform()};
      Vector form{inside[1] * direction[2] - inside[2] * direction[1],
                  inside[2] * direction[0] - inside[0] * direction[2],
                  inside[0] * direction[1] - inside[1] * direction[0]};
      const int wanted = random() % 2 == 0 ? 1 : -1;
      const std::vector<Vector> part = true_part(truth, form, wanted);
      if (part.size() < 3) break;
      const double error = std::ldexp(1, -4 - static_cast<int>(random() % 12));
      const std::size_t dropped = random() % 3;
      if (std::abs(form[dropped]) < 0.05) break;
      std::vector<Ray> changed;
      for (const Ray& ray : rays) {
        const Ray of_form{number<TypeParam>(form[0], form[0]), number<TypeParam>(form[1], form[1]),
                          number<TypeParam>(form[2], form[2])};
        // Known to less, and anywhere in what is known.
        const double shift = error * uniform();
        const Ray sum{sum_of_products(of_form, ray), number<TypeParam>(1, 1), number<TypeParam>(0, 0)};
        const Ray with{number<TypeParam>(1, 1), number<TypeParam>(shift - error, shift + error),
                       number<TypeParam>(0, 0)};
        Ray next = ray;
        next[dropped] = next[2];
        next[2] = sum_of_products(with, sum);
        changed.push_back(next);
      }
      std::vector<Ray> result;
      clip_cone<TypeParam>(changed, wanted, sides, result);
      rays = std::move(result);
      truth = part;
      for (Vector& x : truth) {
        const double value = dot(form, x);
        x[dropped] = x[2];
        x[2] = value;
      }
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const Vector separate = separating(truth, i);
        if (!(dot(separate, truth[i]) > 1e-9)) continue;
        ++compared;
        EXPECT_FALSE(is_negative(rays, separate[0], separate[1], separate[2])) << run << ", step " << step;
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace epsnet::certify::cone_test
