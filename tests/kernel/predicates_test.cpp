#include "kernel/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <string>
#include <type_traits>

#include "tests/kernel/exact.h"
#include "tests/kernel/random_points.h"
#include "tests/kernel/rational_points.h"
#include "tests/support/in_circle.h"
#include "tests/support/scale.h"

namespace epsnet::predicates_test {
namespace {

using test::Dyadic;
using test::Random;
using test::scaled;

/// binary64 whose unit roundoff is claimed to be a hundredth of what it is, and that knows of no underflow: the error
/// bounds of the stages shrink to a hundredth, and the tests have to notice.
struct Careless {
  double value = 0;
  Careless() = default;
  explicit Careless(double v) : value(v) {}
  explicit Careless(int v) : value(v) {}
  friend Careless operator-(Careless x) { return Careless(-x.value); }
  friend Careless operator+(Careless x, Careless y) { return Careless(x.value + y.value); }
  friend Careless operator-(Careless x, Careless y) { return Careless(x.value - y.value); }
  friend Careless operator*(Careless x, Careless y) { return Careless(x.value * y.value); }
  friend Careless operator/(Careless x, Careless y) { return Careless(x.value / y.value); }
  Careless& operator+=(Careless y) { return *this = *this + y; }
  Careless& operator/=(Careless y) { return *this = *this / y; }
  friend bool operator<(Careless x, Careless y) { return x.value < y.value; }
  friend bool operator>(Careless x, Careless y) { return x.value > y.value; }
  friend bool operator<=(Careless x, Careless y) { return x.value <= y.value; }
  friend bool operator!=(Careless x, int y) { return x.value != y; }
  friend Careless sqrt(Careless x) { return Careless(std::sqrt(x.value)); }
  friend Careless abs(Careless x) { return Careless(std::abs(x.value)); }
};

template <class To, class From>
To to(const From& x) {
  if constexpr (std::is_same_v<To, From>) {
    return x;
  } else {
    return To(x);
  }
}
template <class To, class From>
Complex<To> to(const Complex<From>& z) {
  return {to<To>(z.x), to<To>(z.y)};
}

}  // namespace
}  // namespace epsnet::predicates_test

template <>
inline epsnet::predicates_test::Careless epsnet::unit_roundoff<epsnet::predicates_test::Careless>() {
  return epsnet::predicates_test::Careless(kUnitRoundoff / 100);
}

namespace epsnet::predicates_test {
namespace {

/// The input of a predicate as a stage sees it, and what it stands for.
template <class T, std::size_t N>
struct Case {
  std::array<Complex<T>, N> points;
  T error{0};
  T s_low{0};  ///< The threshold, for the predicates that have one.
  T s_high{0};
  std::array<Complex<Dyadic>, N> true_points;
  Dyadic s;
};

template <class T>
std::string hexadecimal(const T& x) {
  std::ostringstream text;
  text << std::hexfloat << x;
  return text.str();
}

template <class T, std::size_t N>
std::string show(const Case<T, N>& c) {
  std::string text;
  for (const Complex<T>& z : c.points) {
    text += "{" + hexadecimal(z.x) + ", " + hexadecimal(z.y) + "} ";
  }
  return text + "error " + hexadecimal(c.error) + " s " + hexadecimal(c.s_low) + " to " + hexadecimal(c.s_high);
}

struct Tally {
  int count = 0;
  int unsure = 0;
  int ties = 0;  ///< Exact sign 0.
  int wrong = 0;
  std::string first_wrong;

  [[nodiscard]] int undecided() const { return unsure - ties; }
};

std::ostream& operator<<(std::ostream& out, const Tally& t) {
  return out << t.count << " cases, " << t.unsure << " unsure, " << t.ties << " ties, " << t.wrong << " wrong "
             << t.first_wrong;
}

/// Runs a stage on `count` cases and compares with the exact sign.
template <class Make, class Stage, class Exact>
Tally tally(int count, const Make& make, const Stage& stage, const Exact& exact) {
  Random random(20250915);
  Tally result;
  while (result.count < count) {
    const auto c = make(random);
    // Predicates are about points of the open disk.
    const bool inside = std::all_of(c.true_points.begin(), c.true_points.end(),
                                    [](const Complex<Dyadic>& z) { return Dyadic(1) - norm(z) > 0; });
    if (!inside) {
      continue;
    }
    ++result.count;
    const int expected = exact(c);
    const StageSign got = stage(c);
    result.ties += expected == 0 ? 1 : 0;
    if (!got.certain) {
      ++result.unsure;
    } else if (got.sign != expected) {
      ++result.wrong;
      if (result.first_wrong.empty()) {
        result.first_wrong = show(c) + " is " + std::to_string(expected);
      }
    }
  }
  return result;
}

// The predicates: a stage over `T` (the case's own field or Careless), and the exact sign.

constexpr auto exact_in_circle = [](const auto& c) {
  return sign(test::in_circle_determinant(c.true_points[0], c.true_points[1], c.true_points[2], c.true_points[3]));
};
template <class T>
constexpr auto in_circle = [](const auto& c) {
  return in_circle_stage<T>(to<T>(c.points[0]), to<T>(c.points[1]), to<T>(c.points[2]), to<T>(c.points[3]),
                            to<T>(c.error));
};

constexpr auto exact_orientation = [](const auto& c) {
  return sign(orientation_determinant(c.true_points[0], c.true_points[1], c.true_points[2]));
};
template <class T>
constexpr auto orientation = [](const auto& c) {
  return orientation_stage<T>(to<T>(c.points[0]), to<T>(c.points[1]), to<T>(c.points[2]), to<T>(c.error));
};

constexpr auto exact_circumradius = [](const auto& c) {
  const auto r = sinh2_circumradius(c.true_points[0], c.true_points[1], c.true_points[2]);
  return sign(Dyadic(r.numerator - c.s * r.denominator));
};
template <class T>
constexpr auto circumradius = [](const auto& c) {
  return circumradius_stage<T>(to<T>(c.points[0]), to<T>(c.points[1]), to<T>(c.points[2]), to<T>(c.s_low),
                               to<T>(c.s_high), to<T>(c.error));
};
template <class T>
constexpr auto circumradius_near_origin = [](const auto& c) {
  return circumradius_stage_near_origin<T>(to<T>(c.points[0]), to<T>(c.points[1]), to<T>(c.points[2]), to<T>(c.s_high));
};

constexpr auto exact_distance = [](const auto& c) {
  const Dyadic one(1);
  const Complex<Dyadic>& p = c.true_points[0];
  const Complex<Dyadic>& q = c.true_points[1];
  return sign(Dyadic(norm(p - q) - c.s * (one - norm(p)) * (one - norm(q))));
};
template <class T>
constexpr auto distance_ = [](const auto& c) {
  return distance_stage<T>(to<T>(c.points[0]), to<T>(c.points[1]), to<T>(c.s_low), to<T>(c.s_high), to<T>(c.error));
};
template <class T>
constexpr auto distance_near_origin = [](const auto& c) {
  return distance_stage_near_origin<T>(to<T>(c.points[0]), to<T>(c.points[1]), to<T>(c.s_high));
};

// The inputs.

enum class Points { exact, inexact };

/// Gives a case its true points: the points themselves, or, for inexact ones, points moved by at most an error, which
/// is small or nearly as large as the figure; the given points are moved off their degenerate place by a few errors.
template <class T, std::size_t N>
void add_truth(Random& random, Points kind, Case<T, N>& c) {
  if (kind == Points::inexact) {
    T size(0);
    for (const Complex<T>& z : c.points) {
      using std::sqrt;
      size = std::max(size, T(sqrt(norm(z - c.points[0]))));
    }
    c.error = size * test::power_of_two<T>(-test::integer(random, 1, std::numeric_limits<T>::digits));
    const T reach = c.error * T(std::array{0.0, 1.0, 3.0, 10.0, 30.0}[random() % 5]);
    for (Complex<T>& z : c.points) {
      z = z + T(reach * test::uniform<T>(random)) * test::direction<T>(random);
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    c.true_points[i] = to<Dyadic>(c.points[i]);
    if (kind == Points::inexact) {
      // As far as is allowed: the direction is a unit vector to rounding, so a little less.
      const Complex<T> moved = T(c.error * T(1 - 0x1p-40)) * test::direction<T>(random);
      c.true_points[i] = c.true_points[i] + to<Dyadic>(moved);
    }
  }
}

template <class T, std::size_t N>
auto adversarial(Points kind) {
  return [kind](Random& random) {
    Case<T, N> c;
    c.points = test::adversarial_points<T, N>(random);
    add_truth(random, kind, c);
    return c;
  };
}

/// Random points with |z| ≤ 0.7, all different, as the vertices of a net are.
template <std::size_t N>
Case<double, N> benign(Random& random) {
  Case<double, N> c;
  for (Complex<double>& z : c.points) {
    z = test::point<double>(random, 0.7);
  }
  add_truth(random, Points::exact, c);
  return c;
}

/// sinh²R of the triangle, or sinh²(d/2) of the two points, of a case; some number where that is none.
template <class T, std::size_t N>
T measure(Random& random, const Case<T, N>& c) {
  T value(0);
  if constexpr (N == 3) {
    const Sinh2Circumradius<T> r = sinh2_circumradius(c.points[0], c.points[1], c.points[2]);
    value = r.denominator > 0 ? T(r.numerator / r.denominator) : T(0);
  } else {
    value = sinh2_half_distance(c.points[0], c.points[1]);
  }
  const bool usable = value > 0 && value < T(1e300) && random() % 16 != 0;
  return usable ? value : test::power_of_two<T>(test::integer(random, -900, 900));
}

/// Sets the threshold of a case to the value that it has, or to one a few ulps (or errors) away, known to a few ulps.
template <class T, std::size_t N>
void add_threshold(Random& random, Case<T, N>& c) {
  const int reach = std::array{3, 30, 300}[random() % 3];
  c.s_low = test::moved_by_ulps(measure(random, c), test::integer(random, -reach, reach));
  if (c.error > 0) {
    c.s_low *= T(1) + c.error * T(test::integer(random, -20, 20));
  }
  if (!(c.s_low > 0)) {
    c.s_low = test::power_of_two<T>(-30);
  }
  c.s_high = test::moved_by_ulps(c.s_low, test::integer(random, 0, 3));
  c.s = random() % 2 == 0 ? to<Dyadic>(c.s_low) : to<Dyadic>(c.s_high);
  if (random() % 2 == 0) {
    c.s = (to<Dyadic>(c.s_low) + to<Dyadic>(c.s_high)).times_power_of_two(-1);
  }
}

template <class T, std::size_t N>
auto adversarial_with_threshold(Points kind) {
  return [kind](Random& random) {
    Case<T, N> c = adversarial<T, N>(kind)(random);
    add_threshold(random, c);
    return c;
  };
}

/// Points with |z| ≤ 0.75, and a threshold up to 100u lower than the bound that the stage gets.
template <std::size_t N>
Case<double, N> adversarial_near_origin(Random& random) {
  Case<double, N> c;
  do {
    c = adversarial<double, N>(Points::exact)(random);
  } while (std::any_of(c.points.begin(), c.points.end(), [](const auto& z) { return norm(z) > 0.5624; }));
  add_threshold(random, c);
  const int lower = test::integer(random, 0, 99);
  c.s = Dyadic(c.s_high) * (Dyadic(1) - Dyadic(lower * kUnitRoundoff));
  return c;
}

template <std::size_t N>
Case<double, N> benign_with_threshold(Random& random) {
  Case<double, N> c = benign<N>(random);
  c.s_low = c.s_high = std::exp2(8 * test::symmetric<double>(random) - 4);
  c.s = Dyadic(c.s_low);
  return c;
}

/// No certain sign is wrong, and the stage is of use: it decides some of the cases.
void expect_sound(const Tally& t) {
  EXPECT_EQ(t.wrong, 0) << t;
  EXPECT_LT(t.unsure, t.count) << t;
  testing::Test::RecordProperty("unsure_percent", std::to_string(100.0 * t.unsure / t.count));
}
/// The stage leaves less than 1% of benign inputs to the next one.
void expect_useful(const Tally& t) {
  EXPECT_EQ(t.wrong, 0) << t;
  EXPECT_LT(t.unsure, t.count / 100.0) << t;
}

TEST(InCircle, NeverWrongInDouble) {
  expect_sound(tally(scaled(300'000), adversarial<double, 4>(Points::exact), in_circle<double>, exact_in_circle));
}
TEST(InCircle, NeverWrongInDoubleForInexactPoints) {
  expect_sound(tally(scaled(100'000), adversarial<double, 4>(Points::inexact), in_circle<double>, exact_in_circle));
}
TEST(InCircle, NeverWrongInMp256) {
  expect_sound(tally(scaled(10'000), adversarial<Mp256, 4>(Points::exact), in_circle<Mp256>, exact_in_circle));
  expect_sound(tally(scaled(10'000), adversarial<Mp256, 4>(Points::inexact), in_circle<Mp256>, exact_in_circle));
}
TEST(InCircle, DecidesBenignInputs) {
  expect_useful(tally(scaled(20'000), benign<4>, in_circle<double>, exact_in_circle));
}
TEST(InCircle, NextStageDecidesWhatDoubleCannot) {
  const Tally t = tally(scaled(20'000), adversarial<double, 4>(Points::exact), in_circle<Mp256>, exact_in_circle);
  EXPECT_EQ(t.wrong, 0) << t;
  EXPECT_LT(t.undecided(), t.count / 1000.0) << t;
}

TEST(Orientation, NeverWrongInDouble) {
  expect_sound(tally(scaled(250'000), adversarial<double, 3>(Points::exact), orientation<double>, exact_orientation));
}
TEST(Orientation, NeverWrongInDoubleForInexactPoints) {
  expect_sound(tally(scaled(80'000), adversarial<double, 3>(Points::inexact), orientation<double>, exact_orientation));
}
TEST(Orientation, NeverWrongInMp256) {
  expect_sound(tally(scaled(10'000), adversarial<Mp256, 3>(Points::exact), orientation<Mp256>, exact_orientation));
  expect_sound(tally(scaled(10'000), adversarial<Mp256, 3>(Points::inexact), orientation<Mp256>, exact_orientation));
}
TEST(Orientation, DecidesBenignInputs) {
  expect_useful(tally(scaled(20'000), benign<3>, orientation<double>, exact_orientation));
}
TEST(Orientation, NextStageDecidesWhatDoubleCannot) {
  const Tally t = tally(scaled(20'000), adversarial<double, 3>(Points::exact), orientation<Mp256>, exact_orientation);
  EXPECT_EQ(t.wrong, 0) << t;
  EXPECT_LT(t.undecided(), t.count / 1000.0) << t;
}

TEST(Circumradius, NeverWrongInDouble) {
  expect_sound(tally(scaled(150'000), adversarial_with_threshold<double, 3>(Points::exact), circumradius<double>,
                     exact_circumradius));
}
TEST(Circumradius, NeverWrongInDoubleForInexactPoints) {
  expect_sound(tally(scaled(60'000), adversarial_with_threshold<double, 3>(Points::inexact), circumradius<double>,
                     exact_circumradius));
}
TEST(Circumradius, NeverWrongInMp256) {
  expect_sound(tally(scaled(8'000), adversarial_with_threshold<Mp256, 3>(Points::exact), circumradius<Mp256>,
                     exact_circumradius));
  expect_sound(tally(scaled(8'000), adversarial_with_threshold<Mp256, 3>(Points::inexact), circumradius<Mp256>,
                     exact_circumradius));
}
TEST(Circumradius, NeverWrongNearOrigin) {
  expect_sound(
      tally(scaled(150'000), adversarial_near_origin<3>, circumradius_near_origin<double>, exact_circumradius));
}
TEST(Circumradius, DecidesBenignInputs) {
  expect_useful(tally(scaled(20'000), benign_with_threshold<3>, circumradius<double>, exact_circumradius));
  expect_useful(tally(scaled(20'000), benign_with_threshold<3>, circumradius_near_origin<double>, exact_circumradius));
}

TEST(Distance, NeverWrongInDouble) {
  expect_sound(
      tally(scaled(100'000), adversarial_with_threshold<double, 2>(Points::exact), distance_<double>, exact_distance));
}
TEST(Distance, NeverWrongInDoubleForInexactPoints) {
  expect_sound(
      tally(scaled(60'000), adversarial_with_threshold<double, 2>(Points::inexact), distance_<double>, exact_distance));
}
TEST(Distance, NeverWrongInMp256) {
  expect_sound(
      tally(scaled(8'000), adversarial_with_threshold<Mp256, 2>(Points::exact), distance_<Mp256>, exact_distance));
  expect_sound(
      tally(scaled(8'000), adversarial_with_threshold<Mp256, 2>(Points::inexact), distance_<Mp256>, exact_distance));
}
TEST(Distance, NeverWrongNearOrigin) {
  expect_sound(tally(scaled(100'000), adversarial_near_origin<2>, distance_near_origin<double>, exact_distance));
}
TEST(Distance, DecidesBenignInputs) {
  expect_useful(tally(scaled(20'000), benign_with_threshold<2>, distance_<double>, exact_distance));
  expect_useful(tally(scaled(20'000), benign_with_threshold<2>, distance_near_origin<double>, exact_distance));
}

// By hand: what the stages know and what they do not.

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Number>
class StageOver : public testing::Test {};
// Names for the fields: CTest shows the types.
struct Binary64 {
  using Type = double;
};
struct Bits256 {
  using Type = Mp256;
};
using Fields = testing::Types<Binary64, Bits256>;
TYPED_TEST_SUITE(StageOver, Fields);

/// Calls `f` with every coordinate of every point, and every one of the numbers, replaced by each of `values`.
template <class T, std::size_t N, std::size_t M, class F>
void with_each_replaced(const std::array<Complex<T>, N>& points, const std::array<T, M>& numbers,
                        std::initializer_list<double> values, const F& f) {
  for (const double value : values) {
    for (std::size_t i = 0; i < 2 * N; ++i) {
      std::array<Complex<T>, N> p = points;
      (i % 2 == 0 ? p[i / 2].x : p[i / 2].y) = T(value);
      EXPECT_FALSE(f(p, numbers).certain) << value << " as coordinate " << i;
    }
    for (std::size_t i = 0; i < M; ++i) {
      std::array<T, M> n = numbers;
      n[i] = T(value);
      EXPECT_FALSE(f(points, n).certain) << value << " as number " << i;
    }
  }
}

TYPED_TEST(StageOver, NanAndInfinityAreUnsure) {
  using T = typename TypeParam::Type;
  using Point = Complex<T>;
  const Point a{T(0.1), T(0.2)};
  const Point b{T(-0.4), T(0.1)};
  const Point c{T(0.3), T(-0.3)};
  const Point d{T(0), T(0)};
  with_each_replaced(std::array{a, b, c, d}, std::array{T(1e-20)}, {kNan, kInfinity},
                     [](const auto& p, const auto& n) { return in_circle_stage<T>(p[0], p[1], p[2], p[3], n[0]); });
  with_each_replaced(std::array{a, b, c}, std::array{T(1e-20)}, {kNan, kInfinity},
                     [](const auto& p, const auto& n) { return orientation_stage<T>(p[0], p[1], p[2], n[0]); });
  const auto radius = [](const auto& p, const auto& n) {
    return circumradius_stage<T>(p[0], p[1], p[2], n[0], n[1], n[2]);
  };
  const auto length = [](const auto& p, const auto& n) { return distance_stage<T>(p[0], p[1], n[0], n[1], n[2]); };
  const std::array numbers{T(0.5), T(0.5), T(1e-20)};
  with_each_replaced(std::array{a, b, c}, numbers, {kNan}, radius);
  with_each_replaced(std::array{a, b}, numbers, {kNan}, length);
  for (const double low : {0.5, kInfinity}) {
    const std::array unbounded{T(low), T(kInfinity), T(0)};
    EXPECT_FALSE(radius(std::array{a, b, c}, unbounded).certain) << low;
    EXPECT_FALSE(length(std::array{a, b}, unbounded).certain) << low;
  }
  EXPECT_FALSE(radius(std::array{a, b, c}, std::array{T(0.5), T(0.5), T(kInfinity)}).certain);
  EXPECT_FALSE(length(std::array{a, b}, std::array{T(0.5), T(0.5), T(kInfinity)}).certain);
  with_each_replaced(std::array{a, b, c}, std::array{T(0.5)}, {kNan, kInfinity}, [](const auto& p, const auto& n) {
    return circumradius_stage_near_origin<T>(p[0], p[1], p[2], n[0]);
  });
  with_each_replaced(std::array{a, b}, std::array{T(0.5)}, {kNan, kInfinity},
                     [](const auto& p, const auto& n) { return distance_stage_near_origin<T>(p[0], p[1], n[0]); });
}

TYPED_TEST(StageOver, DecidesOnBothSidesOfAKnownValueAndNotOnIt) {
  using T = typename TypeParam::Type;
  using Point = Complex<T>;
  const Point east{T(0.5), T(0)};
  const Point north{T(0), T(0.5)};
  const Point west{T(-0.5), T(0)};
  const Point south{T(0), T(-0.5)};
  const auto expect = [](int expected, const StageSign& got) {
    EXPECT_TRUE(got.certain);
    EXPECT_EQ(got.sign, expected);
  };
  for (const double exact_or_not : {0.0, 1e-10}) {
    const T error(exact_or_not);
    expect(1, in_circle_stage<T>(east, north, west, Point{}, error));
    expect(-1, in_circle_stage<T>(east, north, west, Point{T(0.6), T(0)}, error));
    expect(-1, in_circle_stage<T>(north, east, west, Point{}, error));
    EXPECT_FALSE(in_circle_stage<T>(east, north, west, south, error).certain);
    expect(1, orientation_stage<T>(east, north, Point{}, error));
    expect(-1, orientation_stage<T>(north, east, Point{}, error));
    EXPECT_FALSE(orientation_stage<T>(west, Point{}, east, error).certain);
    // Left of the straight line through east and north, right of the geodesic.
    expect(-1, orientation_stage<T>(east, north, Point{T(0.3), T(0.3)}, error));
    expect(1, orientation_stage<T>(east, north, Point{T(0.2), T(0.2)}, error));
    // sinh R = 2·0.5/(1 − 0.25).
    expect(1, circumradius_stage<T>(east, north, west, T(1.77), T(1.77), error));
    expect(-1, circumradius_stage<T>(east, north, west, T(1.78), T(1.78), error));
    EXPECT_FALSE(circumradius_stage<T>(east, north, west, T(1.77), T(1.78), error).certain);
    // sinh²(d/2) = 0.25/0.75.
    expect(1, distance_stage<T>(Point{}, east, T(0.33), T(0.33), error));
    expect(-1, distance_stage<T>(Point{}, east, T(0.34), T(0.34), error));
    EXPECT_FALSE(distance_stage<T>(Point{}, east, T(0.33), T(0.34), error).certain);
  }
  expect(1, circumradius_stage_near_origin<T>(east, north, west, T(1.77)));
  expect(-1, circumradius_stage_near_origin<T>(east, north, west, T(1.78)));
  expect(1, distance_stage_near_origin<T>(Point{}, east, T(0.33)));
  expect(-1, distance_stage_near_origin<T>(Point{}, east, T(0.34)));
}

TYPED_TEST(StageOver, PointsOnNoCircleHaveInfiniteCircumradius) {
  using T = typename TypeParam::Type;
  using Point = Complex<T>;
  // On a diameter, and on a hypercycle near to it.
  for (const double bend : {0.0, 0.01}) {
    for (const double s : {1e-6, 1.0, 1e6}) {
      const StageSign sign =
          circumradius_stage<T>(Point{T(-0.5), T(0)}, Point{T(0), T(-bend)}, Point{T(0.5), T(0)}, T(s), T(s), T(0));
      EXPECT_TRUE(sign.certain);
      EXPECT_EQ(sign.sign, 1);
    }
  }
}

TYPED_TEST(StageOver, PointsWithinTheErrorOfEachOtherAreUnsure) {
  using T = typename TypeParam::Type;
  using Point = Complex<T>;
  const T e = test::power_of_two<T>(-20);
  const Point a{T(0.25), T(0.25)};
  const Point b{T(0.25 + 0x1p-20), T(0.25)};
  const Point c{T(0.25), T(0.25 + 0x1p-20)};
  EXPECT_FALSE(in_circle_stage<T>(a, b, c, Point{T(0.25 + 0x1p-21), T(0.25 + 0x1p-21)}, e).certain);
  EXPECT_FALSE(orientation_stage<T>(a, b, c, e).certain);
  EXPECT_FALSE(circumradius_stage<T>(a, b, c, T(1), T(1), e).certain);
  EXPECT_FALSE(distance_stage<T>(a, b, test::power_of_two<T>(-40), test::power_of_two<T>(-40), e).certain);
  EXPECT_TRUE(distance_stage<T>(a, b, T(1), T(1), e).certain);
}

TEST(StageUnderflow, IsUnsureRatherThanZero) {
  // All products vanish in binary64.
  const auto p = [](double x, double y) { return Complex<double>{x * 1e-300, y * 1e-300}; };
  EXPECT_FALSE(in_circle_stage<double>(p(1, 0), p(0, 1), p(-1, 0), p(0, 0), 0).certain);
  EXPECT_FALSE(orientation_stage<double>(p(1, 0), p(0, 1), p(-1, 0), 0).certain);
  EXPECT_FALSE(circumradius_stage<double>(p(1, 0), p(0, 1), p(-1, 0), 1e300, 1e300, 0).certain);
  EXPECT_FALSE(circumradius_stage_near_origin<double>(p(1, 0), p(0, 1), p(-1, 0), 1e300).certain);
  EXPECT_FALSE(distance_stage<double>(p(1, 0), p(0, 1), 1e-300, 1e-300, 0).certain);
  EXPECT_FALSE(distance_stage_near_origin<double>(p(1, 0), p(0, 1), 1e-300).certain);
  EXPECT_EQ(in_circle_stage<Mp256>(to<Mp256>(p(1, 0)), to<Mp256>(p(0, 1)), to<Mp256>(p(-1, 0)), {}, Mp256(0)).sign, 1);
}

TEST(StageUnderflow, BoundOfOrientationDoesNotVanishBeforeItsError) {
  // Found by Orientation.NeverWrongInDouble: |b − a|²|c − a|² underflows, the determinant does not.
  const Complex<double> a{-0x1.7ed524154cbf5p-395, -0x1.94bd2872707bep-394};
  const Complex<double> b{0x1.7f06b8334c16p-395, 0x1.94f192d407dd6p-394};
  const Complex<double> c{-0x1.f1c73344bf058p-397, -0x1.0721833e1ddafp-395};
  const StageSign sign = orientation_stage<double>(a, b, c, 0);
  EXPECT_TRUE(!sign.certain || sign.sign == 1);
}

TEST(StageUnderflow, HugeThresholdsDoNotMagnifyIt) {
  // Nearly straight: the denominator is positive, zero or negative as its terms underflow.
  for (int k = 200; k < 540; ++k) {
    const double h = std::ldexp(1.0, -k);
    for (const double bend : {0.0, 0x1p-26, 0x1.8p-27}) {
      const Complex<double> a{-h, 0};
      const Complex<double> b{h * 0.375, h * bend};
      const Complex<double> c{h, 0};
      const double s = 0x1p1000;
      const auto exact = sinh2_circumradius(to<Dyadic>(a), to<Dyadic>(b), to<Dyadic>(c));
      const int expected = sign(Dyadic(exact.numerator - Dyadic(s) * exact.denominator));
      for (const StageSign got :
           {circumradius_stage<double>(a, b, c, s, s, 0), circumradius_stage_near_origin<double>(a, b, c, s)}) {
        EXPECT_TRUE(!got.certain || got.sign == expected) << k << " " << bend;
      }
    }
  }
}

// Numbered identities. They hold exactly for the determinants over Rational; and a stage that is certain of two related
// inputs is certain of related signs.

using test::rational_isometry;
using test::rational_point;

RC_GTEST_PROP(InCircleProperty, KeepsItsSignUnderCyclicRotation, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point(), d = rational_point();
  RC_ASSERT(test::in_circle_determinant(a, b, c, d) == test::in_circle_determinant(b, c, a, d));
}
RC_GTEST_PROP(InCircleProperty, IsOddUnderExchangeOfAnyTwo, ()) {
  std::array p{rational_point(), rational_point(), rational_point(), rational_point()};
  const Rational before = test::in_circle_determinant(p[0], p[1], p[2], p[3]);
  const std::size_t i = *rc::gen::inRange<std::size_t>(0, 3);
  const std::size_t j = *rc::gen::inRange<std::size_t>(i + 1, 4);
  std::swap(p[i], p[j]);
  RC_ASSERT(test::in_circle_determinant(p[0], p[1], p[2], p[3]) == -before);
}
RC_GTEST_PROP(InCircleProperty, IsZeroForCoincidentPoints, ()) {
  std::array p{rational_point(), rational_point(), rational_point(), rational_point()};
  const std::size_t i = *rc::gen::inRange<std::size_t>(0, 3);
  const std::size_t j = *rc::gen::inRange<std::size_t>(i + 1, 4);
  p[i] = p[j];
  RC_ASSERT(test::in_circle_determinant(p[0], p[1], p[2], p[3]) == 0);
}
RC_GTEST_PROP(InCircleProperty, SignIsInvariantUnderIsometries, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point(), d = rational_point();
  const Isometry<Rational> f = rational_isometry();
  RC_ASSERT(sign(test::in_circle_determinant(f(a), f(b), f(c), f(d))) == sign(test::in_circle_determinant(a, b, c, d)));
}
RC_GTEST_PROP(InCircleProperty, StagesKeepTheSymmetry, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const auto p = test::adversarial_points<double, 4>(random);
  const double e = random() % 2 == 0 ? 0 : 1e-12;
  const StageSign s = in_circle_stage(p[0], p[1], p[2], p[3], e);
  const StageSign rotated = in_circle_stage(p[1], p[2], p[0], p[3], e);
  const StageSign swapped = in_circle_stage(p[1], p[0], p[2], p[3], e);
  RC_ASSERT(!s.certain || !rotated.certain || rotated.sign == s.sign);
  RC_ASSERT(!s.certain || !swapped.certain || swapped.sign == -s.sign);
}

RC_GTEST_PROP(OrientationProperty, KeepsItsSignUnderCyclicRotation, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point();
  RC_ASSERT(orientation_determinant(a, b, c) == orientation_determinant(b, c, a));
}
RC_GTEST_PROP(OrientationProperty, IsOddUnderExchange, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point();
  RC_ASSERT(orientation_determinant(a, b, c) == -orientation_determinant(b, a, c));
}
RC_GTEST_PROP(OrientationProperty, IsZeroOnTheGeodesic, ()) {
  // Points on a diameter, moved: any geodesic.
  const Isometry<Rational> f = rational_isometry();
  const auto on_diameter = [] { return Complex<Rational>{Rational(*rc::gen::inRange(-96, 97), 97), Rational(0)}; };
  RC_ASSERT(orientation_determinant(f(on_diameter()), f(on_diameter()), f(on_diameter())) == 0);
}
RC_GTEST_PROP(OrientationProperty, SignIsInvariantUnderIsometries, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point();
  const Isometry<Rational> f = rational_isometry();
  RC_ASSERT(sign(orientation_determinant(f(a), f(b), f(c))) == sign(orientation_determinant(a, b, c)));
}

RC_GTEST_PROP(CircumradiusProperty, IsSymmetric, ()) {
  std::array p{rational_point(), rational_point(), rational_point()};
  const auto r = sinh2_circumradius(p[0], p[1], p[2]);
  const std::size_t i = *rc::gen::inRange<std::size_t>(0, 2);
  std::swap(p[i], p[2]);
  const auto swapped = sinh2_circumradius(p[0], p[1], p[2]);
  RC_ASSERT(swapped.numerator == r.numerator);
  RC_ASSERT(swapped.denominator == r.denominator);
}
RC_GTEST_PROP(CircumradiusProperty, DenominatorIsAtMostTheScale, ()) {
  const auto r = sinh2_circumradius(rational_point(), rational_point(), rational_point());
  RC_ASSERT(r.denominator <= r.scale);
  RC_ASSERT(-r.denominator <= r.scale);
}
RC_GTEST_PROP(CircumradiusProperty, IsInvariantUnderIsometries, ()) {
  const auto a = rational_point(), b = rational_point(), c = rational_point();
  const Isometry<Rational> f = rational_isometry();
  const auto r = sinh2_circumradius(a, b, c);
  const auto moved = sinh2_circumradius(f(a), f(b), f(c));
  RC_ASSERT(r.numerator * moved.denominator == moved.numerator * r.denominator);
  RC_ASSERT(sign(r.denominator) == sign(moved.denominator));
}
RC_GTEST_PROP(CircumradiusProperty, IsLongerThanHalfOfEachEdge, ()) {
  // sinh R ≥ sinh(d/2): the denominator times sinh²(d/2) is at most the numerator.
  const auto a = rational_point(), b = rational_point(), c = rational_point();
  const auto r = sinh2_circumradius(a, b, c);
  RC_PRE(r.denominator > 0);
  RC_ASSERT(sinh2_half_distance(a, b) * r.denominator <= r.numerator);
}

// Do the tests above bite? With a hundredth of the rounding part of the bounds, or of the error of inexact points, they
// must find wrong signs.

template <class Make>
auto with_error_over_100(const Make& make) {
  return [make](Random& random) {
    auto c = make(random);
    c.error /= 100;
    return c;
  };
}

TEST(Mutation, HundredthOfTheRoundingBoundIsCaught) {
  const int n = std::max(scaled(50'000), 50'000);  // Fewer would prove nothing.
  EXPECT_GT(tally(n, adversarial<double, 4>(Points::exact), in_circle<Careless>, exact_in_circle).wrong, 0);
  EXPECT_GT(tally(n, adversarial<double, 3>(Points::exact), orientation<Careless>, exact_orientation).wrong, 0);
  EXPECT_GT(
      tally(n, adversarial_with_threshold<double, 3>(Points::exact), circumradius<Careless>, exact_circumradius).wrong,
      0);
  EXPECT_GT(tally(n, adversarial_with_threshold<double, 2>(Points::exact), distance_<Careless>, exact_distance).wrong,
            0);
  EXPECT_GT(tally(n, adversarial_near_origin<3>, circumradius_near_origin<Careless>, exact_circumradius).wrong, 0);
  EXPECT_GT(tally(n, adversarial_near_origin<2>, distance_near_origin<Careless>, exact_distance).wrong, 0);
}

TEST(Mutation, HundredthOfTheErrorOfThePointsIsCaught) {
  const int n = std::max(scaled(40'000), 40'000);
  EXPECT_GT(
      tally(n, with_error_over_100(adversarial<double, 4>(Points::inexact)), in_circle<double>, exact_in_circle).wrong,
      0);
  EXPECT_GT(
      tally(n, with_error_over_100(adversarial<double, 3>(Points::inexact)), orientation<double>, exact_orientation)
          .wrong,
      0);
  EXPECT_GT(tally(n, with_error_over_100(adversarial_with_threshold<double, 3>(Points::inexact)), circumradius<double>,
                  exact_circumradius)
                .wrong,
            0);
  EXPECT_GT(tally(n, with_error_over_100(adversarial_with_threshold<double, 2>(Points::inexact)), distance_<double>,
                  exact_distance)
                .wrong,
            0);
  EXPECT_GT(tally(5'000, with_error_over_100(adversarial<Mp256, 4>(Points::inexact)), in_circle<Mp256>, exact_in_circle)
                .wrong,
            0);
}

}  // namespace
}  // namespace epsnet::predicates_test
