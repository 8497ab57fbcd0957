#include "certify/net/filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"

/// Whatever the filter says must be true in rationals; inputs are chosen where it hardly is.
namespace epsnet::certify::filter_test {
namespace {

using filter::Point;

TEST(Lanes, ComputeAsBinary64DoesAndDoNotMix) {
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<double> numbers{0, -0.0, 1, -1, 0.1, -3.7, 1e300, -1e300, 5e-324, inf, -inf};
  for (const double x : numbers) {
    for (const double y : numbers) {
      const std::array<double, 2> first{x, y};
      const std::array<double, 2> second{y, 3};
      const filter::Lanes a(first.data());
      const filter::Lanes b(second.data());
      for (std::size_t lane = 0; lane < 2; ++lane) {
        const double p = first[lane];
        const double q = second[lane];
        const auto same = [](double found, double wanted) {
          return std::isnan(wanted) ? std::isnan(found) : found == wanted;
        };
        EXPECT_TRUE(same((a + b)[lane], p + q) && same((a - b)[lane], p - q) && same((a * b)[lane], p * q));
        EXPECT_TRUE(same((a / b)[lane], p / q));
        EXPECT_EQ((a < b)[lane], p < q);
        EXPECT_EQ((a > b)[lane], p > q);
        EXPECT_EQ((a > b && a > 0)[lane], p > q && p > 0);
        EXPECT_EQ(max(a, b)[lane], std::max(p, q));
        EXPECT_EQ(abs(a)[lane], std::abs(p));
        EXPECT_EQ(select(a > b, a, 7)[lane], p > q ? p : 7);
      }
    }
  }
}

// The tests of the filter for one triangle or edge, in all lanes.

filter::Points points(Point z) { return {z.x, z.y}; }
bool in_all(const filter::Mask& mask) {
  for (std::size_t lane = 1; lane < filter::Lanes::size(); ++lane) EXPECT_EQ(mask[lane], mask[0]);
  return mask[0];
}
Interval in_all(const filter::Intervals& x) {
  for (std::size_t lane = 1; lane < filter::Lanes::size(); ++lane) {
    EXPECT_EQ(x.lower[lane], x.lower[0]);
    EXPECT_EQ(x.upper[lane], x.upper[0]);
  }
  return {x.lower[0], x.upper[0]};
}
bool counterclockwise(Point z0, Point z1, Point z2) {
  return in_all(filter::counterclockwise(points(z0), points(z1), points(z2)));
}
bool delaunay(Point z0, Point z1, Point z2, Point z3) {
  return in_all(filter::delaunay(points(z0), points(z1), points(z2), points(z3)));
}
double gap(Point z) { return filter::gap(points(z))[0]; }
struct Squared {
  double value;
  bool accurate;
};
Squared squared_distance(Point p, Point q) {
  const filter::Squared squared = filter::squared_distance(points(p), points(q));
  return {squared.value[0], in_all(squared.accurate)};
}
Interval squared_half_sinh(double d, double a, double b) { return in_all(filter::squared_half_sinh(d, a, b)); }
Interval squared_sinh_of_circumradius(const std::array<double, 3>& d, const std::array<double, 3>& a) {
  return in_all(filter::squared_sinh_of_circumradius({d[0], d[1], d[2]}, {a[0], a[1], a[2]}));
}

/// Exactly.
struct Rational {
  explicit Rational(Point z) : x(z.x), y(z.y) {}
  Rational(mpq_class re, mpq_class im) : x(std::move(re)), y(std::move(im)) {}
  mpq_class x;
  mpq_class y;
};
Rational minus(const Rational& p, const Rational& q) { return {p.x - q.x, p.y - q.y}; }
Rational times(const Rational& p, const Rational& q) { return {p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x}; }
mpq_class cross(const Rational& p, const Rational& q) { return p.x * q.y - p.y * q.x; }
mpq_class square(const Rational& p) { return p.x * p.x + p.y * p.y; }

/// det(x, y, 1 + |z|²).
mpq_class orientation(Point z0, Point z1, Point z2) {
  const Rational a(z0), b(z1), c(z2);
  const auto third = [](const Rational& z) { return mpq_class(1 + square(z)); };
  return third(a) * cross(b, c) + third(b) * cross(c, a) + third(c) * cross(a, b);
}

/// Im of (z3−z1)(z2−z0) times the conjugate of (z3−z0)(z2−z1).
mpq_class cross_ratio(Point z0, Point z1, Point z2, Point z3) {
  const Rational a(z0), b(z1), c(z2), d(z3);
  return cross(times(minus(d, a), minus(c, b)), times(minus(d, b), minus(c, a)));
}

mpq_class exact_gap(Point z) { return 1 - square(Rational(z)); }
mpq_class exact_distance(Point p, Point q) { return square(minus(Rational(p), Rational(q))); }

/// sinh²R of three points (Lemma 5).
mpq_class exact_circumradius(const std::array<Point, 3>& z) {
  std::array<mpq_class, 3> h;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    h[i] = exact_distance(z[i], z[j]) / (exact_gap(z[i]) * exact_gap(z[j]));
  }
  const mpq_class k = 2 * (h[0] * h[1] + h[1] * h[2] + h[2] * h[0]) - h[0] * h[0] - h[1] * h[1] - h[2] * h[2];
  return 4 * h[0] * h[1] * h[2] / k;
}

bool contains(Interval x, const mpq_class& value) {
  return mpq_class(x.lower) <= value && (std::isinf(x.upper) || value <= mpq_class(x.upper));
}

class Filtered : public testing::Test {
 protected:
  double uniform(double a, double b) { return a + (b - a) * static_cast<double>(random_() >> 11) * 0x1p-53; }
  /// Between 2^a and 2^b, as often in each octave.
  double scale(double a, double b) { return std::exp2(uniform(a, b)); }
  Point in_disk(double radius) {
    const double angle = uniform(0, 2 * std::numbers::pi);
    const double r = radius * std::sqrt(uniform(0, 1));
    return {r * std::cos(angle), r * std::sin(angle)};
  }
  std::mt19937_64 random_{20261122};
};

TEST_F(Filtered, DelaunayIsTrueWhereItIsSaid) {
  int said = 0;
  int silent = 0;
  for (int k = 0; k < 100'000; ++k) {
    // Four points in order on a circle, the last one a little outside or inside; rounding alone decides some.
    const Point centre = in_disk(0.7);
    const double radius = scale(-30, -2);
    const double off = k % 3 == 0 ? 0 : (k % 2 == 0 ? 1 : -1) * scale(-60, -1);
    std::array<double, 4> angle{};
    for (double& a : angle) a = uniform(0, 2 * std::numbers::pi);
    std::sort(angle.begin(), angle.end());
    std::array<Point, 4> z{};
    for (std::size_t i = 0; i < 4; ++i) {
      const double r = i == 1 ? radius * (1 + off) : radius;
      z[i] = {centre.x + r * std::cos(angle[i]), centre.y + r * std::sin(angle[i])};
    }
    if (delaunay(z[0], z[1], z[2], z[3])) {
      ++said;
      ASSERT_LT(cross_ratio(z[0], z[1], z[2], z[3]), 0);
    } else if (cross_ratio(z[0], z[1], z[2], z[3]) < 0) {
      ++silent;
    }
  }
  EXPECT_GT(said, 5'000);
  EXPECT_GT(silent, 1'000);
}

TEST_F(Filtered, TrianglesAreCounterclockwiseWhereItIsSaid) {
  int said = 0;
  int silent = 0;
  for (int k = 0; k < 100'000; ++k) {
    // Three points near a geodesic: the image of a diameter under a translation.
    const Point c = in_disk(0.9);
    const double turn = uniform(0, 2 * std::numbers::pi);
    const double length = scale(-30, -1);
    const double off = k % 3 == 0 ? 0 : (k % 2 == 0 ? 1 : -1) * scale(-60, -1);
    const auto move = [&](double along, double across) {
      const std::complex<double> z = std::polar(1.0, turn) * std::complex<double>(along, across);
      const std::complex<double> t(c.x, c.y);
      const std::complex<double> w = (z + t) / (1.0 + std::conj(t) * z);
      return Point{w.real(), w.imag()};
    };
    const Point z0 = move(-length, 0);
    const Point z1 = move(length * uniform(-1, 1), -length * off);
    const Point z2 = move(length, 0);
    if (counterclockwise(z0, z1, z2)) {
      ++said;
      ASSERT_GT(orientation(z0, z1, z2), 0);
    } else if (orientation(z0, z1, z2) > 0) {
      ++silent;
    }
  }
  EXPECT_GT(said, 10'000);
  EXPECT_GT(silent, 1'000);
}

TEST_F(Filtered, MeasuresContainTheTrueOnes) {
  int measured = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Point centre = in_disk(k % 2 == 0 ? 0.7 : 0.9999);
    const double size = scale(-40, -4);
    std::array<Point, 3> z{};
    std::array<double, 3> a{};
    std::array<double, 3> d{};
    for (Point& p : z) {
      const Point q = in_disk(size);
      p = {centre.x + q.x, centre.y + q.y};
    }
    if (std::any_of(z.begin(), z.end(), [](Point p) { return exact_gap(p) <= 0; })) continue;
    bool accurate = true;
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] = gap(z[i]);
      const Squared s = squared_distance(z[i], z[(i + 1) % 3]);
      d[i] = s.value;
      accurate = accurate && s.accurate && a[i] > 0;
      if (a[i] > 0) {
        ASSERT_LE(abs(mpq_class(a[i]) - exact_gap(z[i])), exact_gap(z[i]) * 0x1p-38);
      }
      if (s.accurate) {
        const mpq_class distance = exact_distance(z[i], z[(i + 1) % 3]);
        ASSERT_LE(abs(mpq_class(d[i]) - distance), distance * 0x1p-46);
      }
    }
    if (!accurate) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const Interval x = squared_half_sinh(d[i], a[i], a[j]);
      ASSERT_TRUE(contains(x, exact_distance(z[i], z[j]) / (exact_gap(z[i]) * exact_gap(z[j]))));
      ASSERT_LT(x.upper, x.lower * (1 + 0x1p-28));
    }
    const Interval r = squared_sinh_of_circumradius(d, a);
    if (!std::isinf(r.upper)) {
      ++measured;
      ASSERT_TRUE(contains(r, exact_circumradius(z)));
      ASSERT_LT(r.upper, r.lower * (1 + 0x1p-15));
    }
  }
  EXPECT_GT(measured, 10'000);
}

// What each bound is, to the last bit that matters: coordinates with few digits, so that nothing is rounded.

TEST_F(Filtered, DelaunayIsSaidExactlyBeyondItsBound) {
  // z0 = −1/2, z2 = 1/2, z3 = i/2, z1 = −i(1/2 + t): Im of the cross-ratio's product is −t(1 + t/2 …) exactly known.
  const auto value = [](double t) { return cross_ratio({-0.5, 0}, {0, -0.5 - t}, {0.5, 0}, {0, 0.5}); };
  const auto says = [](double t) { return delaunay({-0.5, 0}, {0, -0.5 - t}, {0.5, 0}, {0, 0.5}); };
  // The norms are 1 + t, 1, 1/2, 1/2 + t.
  for (int e = 5; e < 52; ++e) {
    const double t = std::ldexp(1, -e);
    const mpq_class bound = mpq_class(0x1p-16) * (1 + mpq_class(t)) * mpq_class(0.5) * (mpq_class(0.5) + mpq_class(t));
    EXPECT_EQ(says(t), -value(t) > bound) << e;
    EXPECT_FALSE(says(-t)) << e;
  }
  EXPECT_TRUE(says(0x1p-16));
  EXPECT_FALSE(says(0x1p-18));
  EXPECT_FALSE(says(0));
}

TEST_F(Filtered, CounterclockwiseIsSaidOnlyBeyondItsBound) {
  const auto says = [](double t) { return counterclockwise({0, 0}, {0.5, 0}, {0.5, t}); };
  // The determinant is t/2, the norms are 1/2.
  EXPECT_TRUE(says(0x1p-23));
  EXPECT_FALSE(says(0x1p-24));
  EXPECT_FALSE(says(0x1p-25));
  EXPECT_FALSE(says(-0x1p-10));
}

TEST_F(Filtered, NothingIsSaidOfNormsAndGapsBelowTheLeast) {
  const auto triangle = [](double s) { return counterclockwise({0, 0}, {s, 0}, {0, s}); };
  EXPECT_TRUE(triangle(0x1p-99));
  EXPECT_FALSE(triangle(0x1p-100));
  EXPECT_FALSE(counterclockwise({0, 0}, {0.5, 0}, {0, 0x1p-100}));
  EXPECT_FALSE(counterclockwise({0, 0}, {0x1p-100, 0}, {0, 0.5}));
  const auto square = [](double s) { return delaunay({-s, 0}, {0, -2 * s}, {s, 0}, {0, 2 * s}); };
  EXPECT_TRUE(square(0x1p-99));
  EXPECT_FALSE(square(0x1p-102));
  EXPECT_TRUE(squared_distance({0, 0}, {0, 0x1p-99}).accurate);
  EXPECT_FALSE(squared_distance({0, 0}, {0x1p-100, 0}).accurate);
  EXPECT_EQ(gap({0.5, 0.5}), 0.5);
  EXPECT_EQ(gap({0, std::sqrt(1 - 0x1p-11)}), 1 - std::sqrt(1 - 0x1p-11) * std::sqrt(1 - 0x1p-11));
  EXPECT_EQ(gap({std::sqrt(1 - 0x1p-13), 0}), 0);
  EXPECT_EQ(gap({std::sqrt(1 - 0x1.8p-13), 0}), 0);
}

TEST_F(Filtered, EachOfTheFourDifferencesMustExceedTheLeastNorm) {
  constexpr std::array<std::array<std::size_t, 2>, 4> kDifferences{{{3, 1}, {2, 0}, {3, 0}, {2, 1}}};
  const std::array<Point, 4> directions{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (const auto& difference : kDifferences) {
    const std::size_t from = difference[0];
    const std::size_t to = difference[1];
    int negative = 0;
    for (const Point direction : directions) {
      const auto corners = [&](double s) {
        std::array<Point, 4> z{{{-0.5, 0}, {0, -0.5}, {0.5, 0.25}, {0.125, 0.5}}};
        z[to] = {0, 0};
        z[from] = {s * direction.x, s * direction.y};
        return z;
      };
      const auto says = [&](double s) {
        const auto z = corners(s);
        return delaunay(z[0], z[1], z[2], z[3]);
      };
      const auto z = corners(0x1p-99);
      if (cross_ratio(z[0], z[1], z[2], z[3]) > 0) {
        EXPECT_FALSE(says(0x1p-99));
        continue;
      }
      ++negative;
      EXPECT_TRUE(says(0x1p-99)) << from << to;
      EXPECT_FALSE(says(0x1p-100)) << from << to;
    }
    EXPECT_EQ(negative, 2);
  }
}

TEST_F(Filtered, FlatTrianglesAreLeftToBalls) {
  // Products x = y = 1 and z = 4 − t: K = 4 − (t − 2)² = 4t − t².
  const auto measure = [](double t) { return squared_sinh_of_circumradius({1, 1, 4 - t}, {1, 1, 1}); };
  EXPECT_TRUE(std::isinf(measure(0).upper));
  EXPECT_TRUE(std::isinf(measure(0x1p-3).upper));
  EXPECT_FALSE(std::isinf(measure(0x1p-2).upper));
  EXPECT_TRUE(contains(measure(0x1p-2), 16));
  EXPECT_EQ(measure(0).lower, 0);
  // K = 128x − 1024 = 64, which is 2⁻⁴·32².
  constexpr double x = 8.5;
  EXPECT_TRUE(std::isinf(squared_sinh_of_circumradius({x, x, 32}, {1, 1, 1}).upper));
  EXPECT_FALSE(std::isinf(squared_sinh_of_circumradius({x + 0x1p-40, x, 32}, {1, 1, 1}).upper));
}

TEST_F(Filtered, MeasuresAreWidenedByTheirErrors) {
  // K = 3, and the greatest product is 1.
  const Interval radius = squared_sinh_of_circumradius({1, 1, 1}, {1, 1, 1});
  EXPECT_EQ(radius.lower, 4 / (3 + 0x1p-29) * (1 - 0x1p-30));
  EXPECT_EQ(radius.upper, 4 / (3 - 0x1p-29) * (1 + 0x1p-30));
  const Interval length = squared_half_sinh(1, 0.5, 0.25);
  EXPECT_EQ(length.lower, 8 * (1 - 0x1p-30));
  EXPECT_EQ(length.upper, 8 * (1 + 0x1p-30));
}

// What is asked of which corners.

NetDocument load(const std::string& name) { return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/" + name); }

constexpr Questions kAll = 255;

/// The filter of a document, which is asked about one triangle. It knows the labels of a net with the same ones.
class OneByOne {
 public:
  OneByOne(const NetDocument& document, const CollarMembers& collars, Interval sinh_squared, Interval half_sinh_squared)
      : filter_(document, collars, numbers(document), labels(document), sinh_squared, half_sinh_squared) {}

  [[nodiscard]] Filter::Answer answer(std::uint32_t t, Questions asked) const {
    Filter::Answer answer;
    filter_.answer({&t, 1}, {&asked, 1}, {&answer, 1});
    return answer;
  }

  static std::vector<std::uint32_t> numbers(const NetDocument& document) {
    std::vector<std::uint32_t> result(document.labels.size());
    std::iota(result.begin(), result.end(), 1U);
    return result;
  }
  static LabelTable labels(const NetDocument& document, slong precision = 64) {
    const LabelParts parts{check_surface(document.surface).crossings, chart_frames(document.charts, {}), {}};
    const LabelEvaluator evaluator(document, parts);
    const std::vector<std::uint32_t> all = numbers(document);
    return {all, evaluator.evaluate(all, precision, 4 * precision, 1), document.labels.size()};
  }

 private:
  Filter filter_;
};

bool has_no_label(const NetDocument::Triangle& triangle) { return triangle.label[0] == 0 && triangle.label[1] == 0; }

/// sinh²ε and sinh²(ε/2) such that every question about lengths is easy.
OneByOne easy(const NetDocument& document, const CollarMembers& collars) {
  return {document, collars, {1e9, 1e9}, {1e-9, 1e-9}};
}

TEST_F(Filtered, EasyTrianglesAreSettledWithAndWithoutLabels) {
  const NetDocument document = load("certify/verified/octagon-33-vertices.json");
  const CollarMembers collars(document);
  const OneByOne filter = easy(document, collars);
  unsigned labelled = 0;
  unsigned left = 0;
  for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
    const NetDocument::Triangle& triangle = document.triangles[t];
    const Questions answer = filter.answer(t, kAll).settled;
    if (!has_no_label(triangle)) {
      // Where the images of corners are not known well enough, nothing is settled.
      ++(answer == 0 ? left : labelled);
      if (answer == 0) continue;
    }
    EXPECT_NE(answer & kOrientationBit, 0) << t;
    EXPECT_NE(answer & kCoveringBit, 0) << t;
    EXPECT_EQ(filter.answer(t, 0).settled, 0);
    for (std::uint32_t i = 0; i < 3; ++i) {
      EXPECT_EQ((answer & length_bit(i)) != 0, triangle.vertex[i] != triangle.vertex[(i + 1) % 3]) << t;
      EXPECT_EQ(filter.answer(t, length_bit(i)).settled & ~length_bit(i), 0) << t;
    }
  }
  EXPECT_GT(labelled, 10U);
  EXPECT_LT(left, labelled);
}

TEST_F(Filtered, AnswersDoNotDependOnWhatIsAskedTogether) {
  const NetDocument document = load("certify/verified/octagon-33-vertices.json");
  const CollarMembers collars(document);
  const std::vector<std::uint32_t> numbers = OneByOne::numbers(document);
  const Filter filter(document, collars, numbers, OneByOne::labels(document), {0.2, 0.2}, {0.03, 0.03});
  const OneByOne one(document, collars, {0.2, 0.2}, {0.03, 0.03});
  std::vector<std::uint32_t> triangles(document.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0U);
  unsigned settled = 0;
  for (int k = 0; k < 100; ++k) {
    std::shuffle(triangles.begin(), triangles.end(), random_);
    const std::size_t size = std::min<std::size_t>(1 + random_() % Filter::kMost, triangles.size());
    std::vector<Questions> asked(size);
    for (Questions& questions : asked) questions = static_cast<Questions>(random_());
    std::vector<Filter::Answer> answers(size);
    filter.answer(std::span(triangles).first(size), asked, answers);
    for (std::size_t i = 0; i < size; ++i) {
      const Filter::Answer alone = one.answer(triangles[i], asked[i]);
      ASSERT_EQ(answers[i].settled, alone.settled);
      settled += alone.settled != 0;
      ASSERT_EQ(answers[i].circumradius.upper, alone.circumradius.upper);
      for (std::size_t e = 0; e < 3; ++e) ASSERT_EQ(answers[i].length[e].lower, alone.length[e].lower);
    }
  }
  EXPECT_GT(settled, 1000U);
}

/// The image of a point under an isometry, in balls.
ComplexBall ball_image(const BallIsometry& f, const ComplexBall& z) {
  const ComplexBall n = f.a * z + f.b;
  const ComplexBall d = conjugate(f.b) * z + conjugate(f.a);
  ComplexBall result;
  acb_div(result.get(), n.get(), d.get(), Precision::bits());
  return result;
}
ComplexBall ball_point(Point z) { return {Ball::exactly(z.x), Ball::exactly(z.y)}; }
bool within(Point z, const ComplexBall& w, double error) {
  return certainly_less(norm(ball_point(z) + -w), Ball::exactly(error * error)) == Tri::yes;
}

class Moved : public Filtered {
 protected:
  /// cosh and sinh of half of the distance by which it moves something are the sizes of its parts.
  BallIsometry isometry(double half_length) {
    const Ball l = Ball::exactly(half_length);
    const auto turned = [&](const Ball& size) {
      const double x = uniform(-3, 3);
      ComplexBall turn;
      arb_sin_cos(turn.im(), turn.re(), Ball::exactly(x).get(), Precision::bits());
      return size * turn;
    };
    return {turned(cosh(l)), turned(sinh(l))};
  }
  Precision precision_{300};
};

TEST_F(Moved, ImagesAreWithinTheirErrors) {
  int thrice = 0;
  int far = 0;
  for (int k = 0; k < 20'000; ++k) {
    const double least = k % 2 == 0 ? 0 : 0.9;
    Point z{};
    do z = in_disk(1 - scale(-20, 0) / 2);
    while (std::hypot(z.x, z.y) < least);
    ComplexBall exact = ball_point(z);
    int moves = 0;
    for (; moves < 3; ++moves) {
      const BallIsometry f = isometry(k % 3 == 0 ? scale(-10, 3) : uniform(0, 1));
      const bool back = random_() % 2 == 0;
      filter::Label label = filter::label_of(f);
      if (back) label = inverse(label);
      const auto image = filter::image(label, z);
      if (!image) break;
      exact = ball_image(back ? inverse(f) : f, exact);
      z = *image;
      ASSERT_TRUE(z.moved);
      ASSERT_TRUE(within(z, exact, moves == 0 ? 0x1p-44 : 0x1p-35)) << k << " " << moves;
    }
    thrice += moves == 3;
    far += moves == 0;
  }
  EXPECT_GT(thrice, 3'000);
  EXPECT_GT(far, 1'000);
}

TEST_F(Moved, PointsNearTheCircleAreNotMoved) {
  const filter::Label none = filter::label_of(identity_isometry());
  EXPECT_EQ(none.least_stretch, 0x1p-4);
  for (const double radius : {0x1p-8 * (1 + 0x1p-30), 0x1p-8 * (1 - 0x1p-30)}) {
    EXPECT_EQ(filter::image(none, {0, std::sqrt(1 - radius)}).has_value(), radius > 0x1p-8);
    EXPECT_EQ(filter::image(none, {-std::sqrt(1 - radius), 0}).has_value(), radius > 0x1p-8);
  }
  // |b| is 1 and |a| is √2: the stretch of −x is (√2 − x)², and the image of 1/2 is nearer to the circle than ¼.
  const double root = std::sqrt(2);
  EXPECT_FALSE(filter::image({{root, 0}, {1, 0}, (root - 0.5) * (root - 0.5)}, {-0.5, 0}));
  EXPECT_TRUE(filter::image({{root, 0}, {1, 0}, (root - 0.5) * (root - 0.5) * (1 - 0x1p-40)}, {-0.5, 0}));
}

TEST_F(Moved, LabelsThatAreNotKnownMoveNothing) {
  const BallIsometry f = isometry(0.5);
  EXPECT_TRUE(std::isfinite(filter::label_of(f).least_stretch));
  for (arb_srcptr part : {f.a.re(), f.a.im(), f.b.re(), f.b.im()}) {
    for (const int exponent : {-64, -58}) {
      BallIsometry g = f;
      arb_ptr wide = part == f.a.re() ? g.a.re() : part == f.a.im() ? g.a.im() : part == f.b.re() ? g.b.re() : g.b.im();
      mag_set_ui_2exp_si(arb_radref(wide), 1, exponent);
      EXPECT_EQ(std::isfinite(filter::label_of(g).least_stretch), exponent == -64);
    }
  }
  EXPECT_FALSE(std::isfinite(filter::label_of(isometry(100)).least_stretch));
  BallIsometry unknown = f;
  arb_indeterminate(unknown.b.im());
  EXPECT_FALSE(std::isfinite(filter::label_of(unknown).least_stretch));
  EXPECT_FALSE(filter::image(filter::Label(), {0, 0}));
}

/// Triangles 0 2 3 and 0 1 2 of a square, counterclockwise, with the labels of corners 2 and 3, and of 1 and 2.
NetDocument two_triangles(const std::array<Point, 4>& z, const std::array<std::uint32_t, 4>& labels) {
  NetDocument document;
  for (const Point& point : z) document.vertices.push_back({point.x, point.y, 0});
  document.triangles = {{.vertex = {0, 2, 3}, .opposite = {5, 1, 2}, .label = {labels[0], labels[1]}},
                        {.vertex = {0, 1, 2}, .opposite = {3, 4, 0}, .label = {labels[2], labels[3]}}};
  document.labels.resize(1);
  return document;
}

/// What is settled of the first of these triangles, where label 1 is the identity; all lengths are easy.
Filter::Answer settled_of(const NetDocument& document) {
  const CollarMembers collars(document);
  const std::vector<std::uint32_t> numbers{1};
  const Filter filter(document, collars, numbers, LabelTable(numbers, {identity_isometry()}, 1), {1e9, 1e9}, {0, 0});
  const std::uint32_t t = 0;
  // What was there before does not count.
  Filter::Answer answer{.settled = kAll};
  filter.answer({&t, 1}, {&kAll, 1}, {&answer, 1});
  return answer;
}

TEST_F(Moved, PointsThatLabelsMovedAreMoreThanTheLeastNormApart) {
  // A square from 0 to (s, s), with its corners turned around it, so that each of its edges is each of the four.
  const Questions all = kOrientationBit | kCoveringBit | delaunay_bit(0);
  for (const Point side : {Point{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    for (const int exponent : {-10, -13, -14, -20}) {
      const double s = std::ldexp(1, exponent);
      // The far corner is well outside of the circle.
      const std::array<Point, 4> z{{{0, 0},
                                    {1.5 * s * side.x - 0.5 * s * -side.y, 1.5 * s * side.y - 0.5 * s * side.x},
                                    {s * (side.x - side.y), s * (side.y + side.x)},
                                    {-s * side.y, s * side.x}}};
      for (unsigned which = 0; which < 16; ++which) {
        const NetDocument document = two_triangles(z, {which & 1U, which >> 1U & 1U, which >> 2U & 1U, which >> 3U});
        const bool own = (which & 3U) != 0;
        const bool far = (which >> 2U & 1U) != 0;
        const Questions settled = settled_of(document).settled;
        EXPECT_EQ((settled & kOrientationBit) != 0, !own || s > 0x1p-14) << exponent << ' ' << which;
        EXPECT_EQ((settled & kCoveringBit) != 0, !own || s > 0x1p-14) << exponent << ' ' << which;
        EXPECT_EQ((settled & delaunay_bit(0)) != 0, (!own && !far) || s > 0x1p-14) << exponent << ' ' << which;
      }
    }
  }
  EXPECT_EQ(settled_of(two_triangles({{{0, 0}, {0.5, -0.5}, {0.5, 0}, {0, 0.5}}}, {})).settled & all, all);
}

TEST_F(Moved, PointsAreApartInOneOfTheirCoordinates) {
  // One corner of a triangle is near to another one: by t in one coordinate, and as much or nothing in the other one.
  for (const double t : {0x1.8p-15, 0x1p-14, 0x1p-14 * (1 + 0x1p-20), 0x1p-13}) {
    for (const Point off : {Point{t, 0}, {0, t}, {-t, 0}, {0, -t}, {t, 0.25 * t}, {0.25 * t, t}}) {
      for (std::size_t i = 0; i < 3; ++i) {
        std::array<Point, 3> z{};
        z[i] = {0.25, 0.25};
        z[(i + 1) % 3] = {0.25 + off.x, 0.25 + off.y};
        z[(i + 2) % 3] = {-0.5, -0.25};
        if (orientation(z[0], z[1], z[2]) < 0) z[(i + 2) % 3] = {0.5, 0.375};
        if (orientation(z[0], z[1], z[2]) < 0) z[(i + 2) % 3] = {0.25, 0.75};
        if (orientation(z[0], z[1], z[2]) < 0) continue;
        for (const bool moved : {false, true}) {
          const NetDocument document = two_triangles({z[0], {0, -0.875}, z[1], z[2]}, {moved, 0, 0, 0});
          EXPECT_EQ((settled_of(document).settled & kOrientationBit) != 0, !moved || t > 0x1p-14) << i << ' ' << t;
        }
      }
    }
  }
}

TEST_F(Moved, TheFarCornerIsMovedByALabelThatBothTrianglesHave) {
  // Of an edge from vertex 0 to vertex 2, whose corners at vertices 0 and 1 have one label, f.
  const BallIsometry f{{Ball::exactly(1.25), Ball::exactly(0)}, {Ball::exactly(0.75), Ball::exactly(0)}};
  const auto before = [](Point z) {
    const std::complex<double> w = (1.25 * std::complex(z.x, z.y) - 0.75) / (1.25 - 0.75 * std::complex(z.x, z.y));
    return Point{w.real(), w.imag()};
  };
  int outside = 0;
  for (int k = 0; k < 2000; ++k) {
    const Point z0{0, 0}, z1 = in_disk(0.9), z2{0.5, 0}, z3{0.125, 0.375};
    if (z1.y > -0.01) continue;
    NetDocument document = two_triangles({before(z0), before(z1), z2, z3}, {});
    document.triangles = {{.vertex = {3, 0, 2}, .opposite = {0, 3, 2}, .label = {1, 0}},
                          {.vertex = {2, 0, 1}, .opposite = {1, 4, 5}, .label = {1, 1}}};
    const CollarMembers collars(document);
    const std::vector<std::uint32_t> numbers{1};
    const Filter filter(document, collars, numbers, LabelTable(numbers, {f}, 1), {1e9, 1e9}, {0, 0});
    const std::uint32_t t = 0;
    Filter::Answer answer;
    filter.answer({&t, 1}, {&kAll, 1}, {&answer, 1});
    const bool settled = (answer.settled & delaunay_bit(1)) != 0;
    if (settled) {
      EXPECT_LT(cross_ratio(z0, z1, z2, z3), 0);
    }
    outside += settled;
  }
  EXPECT_GT(outside, 100);
}

TEST_F(Moved, MeasuresOfPointsThatLabelsMovedAreWider) {
  const std::array<Point, 4> z{{{0, 0}, {0.5, -0.5}, {0.5, 0}, {0, 0.5}}};
  const Filter::Answer plain = settled_of(two_triangles(z, {}));
  ASSERT_NE(plain.settled & kCoveringBit, 0);
  const auto expect_wider = [](Interval wide, Interval x) {
    EXPECT_EQ(wide, (Interval{x.lower * (1 - 0x1p-19), x.upper * (1 + 0x1p-19)}));
  };
  for (const auto& labels : {std::array{1U, 0U}, std::array{0U, 1U}, std::array{1U, 1U}}) {
    const Filter::Answer moved = settled_of(two_triangles(z, {labels[0], labels[1], 0, 0}));
    expect_wider(moved.circumradius, plain.circumradius);
    for (std::size_t i = 0; i < 3; ++i) expect_wider(moved.length[i], plain.length[i]);
  }
}

TEST_F(Moved, ALabelMovesAPointThatItStretchesByLittleOnly) {
  // 2⁻¹⁰ of the square of the sum of all parts of a and b.
  const double size = 1.5 + 1.25;
  const BallIsometry f{{Ball::exactly(1.5), Ball::exactly(0)}, {Ball::exactly(0), Ball::exactly(1.25)}};
  EXPECT_EQ(filter::label_of(f).least_stretch, 0x1p-4);
  const BallIsometry g{{Ball::exactly(0x1p8), Ball::exactly(3)}, {Ball::exactly(-0x1p8), Ball::exactly(5)}};
  EXPECT_EQ(filter::label_of(g).least_stretch, 0x1p-10 * (0x1p9 + 8) * (0x1p9 + 8));
  EXPECT_LT(0x1p-10 * size * size, 0x1p-4);
}

TEST_F(Moved, WhatIsSettledWithLabelsIsTrue) {
  NetDocument document = load("certify/verified/octagon-33-vertices.json");
  const CollarMembers collars(document);
  const OneByOne filter = easy(document, collars);
  const LabelTable labels = OneByOne::labels(document, 300);
  std::array<int, 3> said{};
  std::array<int, 3> silent{};
  const auto note = [&](std::size_t question, bool settled, const Ball& positive) {
    const Tri holds = certainly_positive(positive);
    if (settled) {
      EXPECT_EQ(holds, Tri::yes);
      ++said[question];
    } else if (holds == Tri::yes) {
      ++silent[question];
    }
  };
  LiftedTriangle lifted;
  for (int k = 0; k < 20'000; ++k) {
    const auto t = static_cast<std::uint32_t>(random_() % document.triangles.size());
    const NetDocument::Triangle& triangle = document.triangles[t];
    // One vertex of the triangle or of a neighbour goes elsewhere: far away, or very near to a line or a circle.
    const auto i = static_cast<std::uint32_t>(random_() % 3);
    const std::uint32_t far = start(document, previous_dart(triangle.opposite[i]));
    const std::uint32_t v = k % 2 == 0 ? far : triangle.vertex[i];
    const NetDocument::Vertex before = document.vertices[v];
    const auto measure = [&] {
      lifted.load(document, labels, t, 300);
      return k % 2 == 0 ? -lifted.measure_cross_ratio(document, labels, i, 300) : lifted.measure_orientation(300);
    };
    const Point off = in_disk(0.5);
    double least = 0;
    double most = 1;
    const auto place = [&](double share) {
      document.vertices[v].x = before.x + share * off.x;
      document.vertices[v].y = before.y + share * off.y;
    };
    place(1);
    if (std::hypot(document.vertices[v].x, document.vertices[v].y) < 1 && k % 4 < 2 &&
        certainly_positive(measure()) == Tri::no) {
      // Bisection: the last place at which the triangle is good, give or take a little.
      for (int step = 0; step < 60; ++step) {
        place((least + most) / 2);
        (certainly_positive(measure()) == Tri::yes ? least : most) = (least + most) / 2;
      }
      place(least * (1 - scale(-50, -5)));
    }
    if (std::hypot(document.vertices[v].x, document.vertices[v].y) < 1) {
      const Filter::Answer answer = filter.answer(t, kAll);
      const bool delaunay = k % 2 == 0;
      note(delaunay ? 0 : 1, (answer.settled & (delaunay ? delaunay_bit(i) : kOrientationBit)) != 0, measure());
      if (answer.settled & kCoveringBit) {
        const auto& radius = lifted.measure_circumradius(Ball::exactly(1).get(), 300);
        const Ball squared = radius.numerator / radius.denominator;
        EXPECT_EQ(certainly_less(Ball::exactly(answer.circumradius.lower), squared), Tri::yes);
        EXPECT_EQ(certainly_less(squared, Ball::exactly(answer.circumradius.upper)), Tri::yes);
      }
      for (std::uint32_t e = 0; e < 3; ++e) {
        if ((answer.settled & length_bit(e)) == 0) continue;
        ++said[2];
        const Ball squared = lifted.squared_difference(e) / (lifted.gap(e) * lifted.gap((e + 1) % 3));
        EXPECT_EQ(certainly_less(Ball::exactly(answer.length[e].lower), squared), Tri::yes);
        EXPECT_EQ(certainly_less(squared, Ball::exactly(answer.length[e].upper)), Tri::yes);
      }
    }
    document.vertices[v] = before;
  }
  for (const std::size_t question : {0U, 1U}) {
    EXPECT_GT(said[question], 1'000) << question;
    EXPECT_GT(silent[question], 300) << question;
  }
  EXPECT_GT(said[2], 1'000);
}

TEST_F(Filtered, LengthsAreComparedWithTheirOwnBounds) {
  const NetDocument document = load("certify/verified/octagon-33-vertices.json");
  const CollarMembers collars(document);
  const OneByOne all = easy(document, collars);
  for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
    const Filter::Answer answer = all.answer(t, kAll);
    if (!has_no_label(document.triangles[t]) || (answer.settled & kCoveringBit) == 0) continue;
    std::array<Point, 3> z{};
    for (std::size_t i = 0; i < 3; ++i) {
      const NetDocument::Vertex& vertex = document.vertices[document.triangles[t].vertex[i]];
      z[i] = {vertex.x, vertex.y};
    }
    EXPECT_TRUE(contains(answer.circumradius, exact_circumradius(z)));
    const double radius = answer.circumradius.upper;
    const auto covered = [&](double bound) {
      return (OneByOne(document, collars, {bound, 2 * bound}, {0, 0}).answer(t, kAll).settled & kCoveringBit) != 0;
    };
    EXPECT_TRUE(covered(std::nextafter(radius, 2 * radius)));
    EXPECT_FALSE(covered(radius));
    for (std::uint32_t i = 0; i < 3; ++i) {
      if ((answer.settled & length_bit(i)) == 0) continue;
      const std::size_t j = (i + 1) % 3;
      EXPECT_TRUE(contains(answer.length[i], exact_distance(z[i], z[j]) / (exact_gap(z[i]) * exact_gap(z[j]))));
      const auto long_enough = [&](double bound) {
        return (OneByOne(document, collars, {0, 0}, {bound / 2, bound}).answer(t, kAll).settled & length_bit(i)) != 0;
      };
      EXPECT_TRUE(long_enough(std::nextafter(answer.length[i].lower, 0.0)));
      EXPECT_FALSE(long_enough(answer.length[i].lower));
    }
  }
}

TEST_F(Filtered, EdgesAreDelaunayIfTheFarCornerIsOutsideOfTheCircle) {
  NetDocument document = load("certify/verified/octagon-33-vertices.json");
  const CollarMembers collars(document);
  const OneByOne filter = easy(document, collars);
  const auto point = [&](std::uint32_t v) { return Point{document.vertices[v].x, document.vertices[v].y}; };
  int outside = 0;
  int inside = 0;
  for (std::uint32_t t = 0; t < document.triangles.size(); ++t) {
    const NetDocument::Triangle& triangle = document.triangles[t];
    for (std::uint32_t i = 0; i < 3; ++i) {
      if ((filter.answer(t, kAll).settled & delaunay_bit(i)) == 0) continue;
      if (!has_no_label(triangle) || !has_no_label(document.triangles[triangle.opposite[i] / 3])) continue;
      const std::uint32_t far = start(document, previous_dart(triangle.opposite[i]));
      if (std::count(triangle.vertex.begin(), triangle.vertex.end(), far) != 0) continue;
      const NetDocument::Vertex before = document.vertices[far];
      for (int k = 0; k < 20; ++k) {
        const Point off = in_disk(0.5);
        const Point near = point(triangle.vertex[static_cast<std::size_t>(k % 3)]);
        const Point moved{near.x + off.x, near.y + off.y};
        document.vertices[far].x = moved.x;
        document.vertices[far].y = moved.y;
        const bool is_outside = cross_ratio(point(triangle.vertex[i]), moved, point(triangle.vertex[(i + 1) % 3]),
                                            point(triangle.vertex[(i + 2) % 3])) < 0;
        ++(is_outside ? outside : inside);
        EXPECT_EQ((filter.answer(t, kAll).settled & delaunay_bit(i)) != 0, is_outside) << t << " " << i;
      }
      document.vertices[far] = before;
    }
  }
  EXPECT_GT(outside, 100);
  EXPECT_GT(inside, 40);
}

/// The first triangle whose corners carry the identity, moved.
class FilteredTriangle : public Filtered {
 protected:
  Questions settled(const std::array<Point, 3>& z) {
    for (std::size_t i = 0; i < 3; ++i) {
      NetDocument::Vertex& vertex = document_.vertices[document_.triangles[t_].vertex[i]];
      vertex.x = z[i].x;
      vertex.y = z[i].y;
    }
    const CollarMembers collars(document_);
    return OneByOne(document_, collars, {1e9, 1e9}, {0, 0}).answer(t_, kAll).settled;
  }
  static constexpr Questions kMeasures =
      static_cast<Questions>(kCoveringBit | length_bit(0) | length_bit(1) | length_bit(2));

  NetDocument document_ = load("certify/verified/octagon-33-vertices.json");
  std::uint32_t t_ = [&] {
    std::uint32_t t = 0;
    while (document_.triangles[t].label != std::array<std::uint32_t, 2>{0, 0}) ++t;
    return t;
  }();
};

TEST_F(FilteredTriangle, IsNotMeasuredWithACornerNearTheCircle) {
  const std::array<Point, 3> good{{{0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
  EXPECT_EQ(settled(good) & kMeasures, kMeasures);
  for (std::size_t i = 0; i < 3; ++i) {
    auto z = good;
    z[i] = {i == 2 ? 0.0 : 1 - 0x1p-14, i == 2 ? 1 - 0x1p-14 : 0.0};
    // The edge across from it is none of its.
    EXPECT_EQ(settled(z) & kMeasures, length_bit((static_cast<std::uint32_t>(i) + 1) % 3)) << i;
  }
}

TEST_F(FilteredTriangle, IsNotMeasuredWithTwoCornersThatAreTooNear) {
  const auto corners = [](std::size_t i, double s) {
    std::array<Point, 3> z{{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}};
    z[i] = {0, 0};
    z[(i + 1) % 3] = {s, 0};
    return z;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const unsigned own = kCoveringBit | length_bit(static_cast<std::uint32_t>(i));
    EXPECT_NE(settled(corners(i, 0x1p-99)) & own, 0) << i;
    EXPECT_EQ(settled(corners(i, 0x1p-100)) & own, 0) << i;
  }
  // Small, but not flat.
  EXPECT_EQ(settled({{{0, 0}, {0x1p-99, 0}, {0, 0x1p-99}}}) & kMeasures, kMeasures);
  EXPECT_EQ(settled({{{0, 0}, {0x1p-100, 0}, {0, 0x1p-100}}}) & kMeasures, 0);
}

TEST_F(Filtered, CollarsAreLeftToBalls) {
  NetDocument document = load("certify/verified/octagon-33-vertices.json");
  const auto settled = [&](std::uint32_t t) {
    const CollarMembers collars(document);
    return easy(document, collars).answer(t, kAll).settled;
  };
  constexpr Questions kLengths = static_cast<Questions>(length_bit(0) | length_bit(1) | length_bit(2));
  std::uint32_t t = 0;
  while ((settled(t) & kLengths) != kLengths) ++t;
  const Questions before = settled(t);
  document.collars.emplace();
  EXPECT_EQ(settled(t), before);
  for (std::uint32_t i = 0; i < 3; ++i) {
    NetDocument::Collar collar{};
    collar.vertices = {document.triangles[t].vertex[i], document.triangles[t].vertex[(i + 1) % 3]};
    collar.triangles = {t + 1, t + 2};
    document.collars = {collar};
    EXPECT_EQ(settled(t), before & ~length_bit(i));
    document.collars->front().triangles = {t, t + 1};
    EXPECT_EQ(settled(t), 0);
  }
}

}  // namespace
}  // namespace epsnet::certify::filter_test
