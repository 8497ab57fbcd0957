#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <vector>

#include "certify/claims/bound/triangles.h"
#include "certify/net/numbering.h"

/// Triangulations at a point, of sides that no surface has: what is asked is arithmetic.
namespace epsnet::certify::bound_triangles_test {
namespace {

constexpr slong kPrecision = 128;

Ball number(double x) { return Ball::exactly(x); }

/// All numbers from lower to upper.
Ball between(double lower, double upper) {
  Ball result, end;
  arb_set_d(result.get(), lower);
  arb_set_d(end.get(), upper);
  arb_union(result.get(), result.get(), end.get(), kPrecision);
  return result;
}

double middle(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

using Triangle = std::array<Ball, 3>;

Triangle triangle(double a, double b, double c) { return {number(a), number(b), number(c)}; }

Tri fit(const Triangle& sides, const Ball& most) {
  const Precision scope(kPrecision);
  return fits(sides, most);
}
TriangleMeasures measured(const Triangle& sides) {
  const Precision scope(kPrecision);
  return measures(sides);
}
Tri counterclockwise(const std::vector<Ball>& areas) {
  const Precision scope(kPrecision);
  return all_counterclockwise(areas);
}

TEST(BoundTriangles, ATriangleThatIsNotAcuteFitsIfItsLongestSideDoes) {
  // 1 + 2 < 5: whichever side it is.
  for (const Triangle& sides : {triangle(5, 1, 2), triangle(1, 5, 2), triangle(1, 2, 5)}) {
    EXPECT_EQ(fit(sides, number(5)), Tri::yes);
    EXPECT_EQ(fit(sides, number(std::nextafter(5, 0))), Tri::no);
    EXPECT_EQ(fit(sides, between(4, 6)), Tri::unknown);
  }
  // A right angle is not acute, 1 + 2 = 3.
  for (const Triangle& sides : {triangle(3, 1, 2), triangle(2, 3, 1), triangle(1, 2, 3)}) {
    EXPECT_EQ(fit(sides, number(3)), Tri::yes);
    EXPECT_EQ(fit(sides, number(std::nextafter(3, 0))), Tri::no);
  }
}

TEST(BoundTriangles, AnAcuteTriangleFitsIfItsCircumcircleDoes) {
  // 4abc/K with a, b, c = 4, 5, 6: K = 80 − 9 = 71, and 480/71 = 6.76…
  for (const Triangle& sides : {triangle(4, 5, 6), triangle(6, 4, 5), triangle(5, 6, 4), triangle(6, 5, 4)}) {
    EXPECT_EQ(fit(sides, number(480.0 / 71 + 1e-12)), Tri::yes);
    EXPECT_EQ(fit(sides, number(480.0 / 71 - 1e-12)), Tri::no);
    EXPECT_EQ(fit(sides, between(6.5, 7)), Tri::unknown);
  }
  // Sides alone would fit.
  EXPECT_EQ(fit(triangle(1, 1, 1), number(1.25)), Tri::no);
  EXPECT_EQ(fit(triangle(1, 1, 1), number(1.5)), Tri::yes);
}

TEST(BoundTriangles, WideSidesAreNotDecidedWrongly) {
  for (std::size_t wide = 0; wide < 3; ++wide) {
    // Perhaps too long, in a triangle that is not acute for certain.
    Triangle sides = triangle(1, 1, 1);
    sides[wide] = between(4, 6);
    EXPECT_EQ(fit(sides, number(5)), Tri::unknown);
    EXPECT_EQ(fit(sides, number(6.5)), Tri::yes);
    EXPECT_EQ(fit(sides, number(3)), Tri::no);
    // Acute or not.
    sides = triangle(1, 1, 1);
    sides[wide] = between(1.9, 2.1);
    EXPECT_NE(fit(sides, number(2.2)), Tri::no);
    EXPECT_EQ(fit(sides, number(2)), Tri::unknown);
    sides[wide] = between(1.5, 2.5);
    EXPECT_EQ(fit(sides, number(1.2)), Tri::no);
    // Perhaps no circumcircle.
    sides[wide] = between(1.5, 4.5);
    EXPECT_EQ(fit(sides, number(100)), Tri::unknown);
    EXPECT_EQ(fit(sides, number(4)), Tri::unknown);
  }
  // Certainly acute, with a circumcircle that is perhaps too large.
  EXPECT_EQ(fit({between(0.99, 1.01), number(1), number(1)}, number(4.0 / 3)), Tri::unknown);
  Ball nothing;
  arb_indeterminate(nothing.get());
  EXPECT_EQ(fit({nothing, number(1), number(1)}, number(2)), Tri::unknown);
  EXPECT_EQ(fit(triangle(1, 1, 1), nothing), Tri::unknown);
}

/// Of the hyperbolic triangle with sinh²(d/2) = a, b, c, by its angles.
double area_by_angles(double a, double b, double c) {
  const auto angle = [](double opposite, double x, double y) {
    const double cx = 1 + 2 * x, cy = 1 + 2 * y;
    return std::acos((cx * cy - (1 + 2 * opposite)) / std::sqrt((cx * cx - 1) * (cy * cy - 1)));
  };
  return std::numbers::pi - angle(a, b, c) - angle(b, c, a) - angle(c, a, b);
}

TEST(BoundTriangles, MeasuresAreThoseOfTheTriangle) {
  for (const auto& [a, b, c] : std::initializer_list<std::array<double, 3>>{
           {1, 1, 1}, {4, 5, 6}, {6, 4, 5}, {5, 6, 4}, {0.01, 0.02, 0.015}, {7, 1, 5}, {100, 70, 3}, {0.5, 8, 6}}) {
    const Triangle sides = triangle(a, b, c);
    const TriangleMeasures found = measured(sides);
    const double k = 2 * (a * b + b * c + c * a) - a * a - b * b - c * c;
    ASSERT_GT(k, 0);
    EXPECT_NEAR(middle(found.k) / k, 1, 1e-12);
    EXPECT_NEAR(middle(found.cotangent[0]), (b + c - a) / std::sqrt(k), 1e-12);
    EXPECT_NEAR(middle(found.cotangent[1]), (c + a - b) / std::sqrt(k), 1e-12);
    EXPECT_NEAR(middle(found.cotangent[2]), (a + b - c) / std::sqrt(k), 1e-12);
    EXPECT_NEAR(middle(found.area), area_by_angles(a, b, c), 1e-9 * middle(found.area) + 1e-12);
    EXPECT_EQ(certainly_positive(found.area), Tri::yes);
  }
}

TEST(BoundTriangles, WithoutACircumcircleThereAreNoMeasures) {
  for (const Triangle& sides : {triangle(1, 1, 5), triangle(5, 1, 1), Triangle{between(3, 5), number(1), number(1)}}) {
    const TriangleMeasures found = measured(sides);
    EXPECT_NE(certainly_positive(found.k), Tri::yes);
    for (const Ball& cotangent : found.cotangent) EXPECT_FALSE(is_finite(cotangent));
  }
}

/// Six triangles of a surface of genus 2 have the area 4π together.
std::vector<Ball> six_areas(double each) {
  std::vector<Ball> result;
  for (int t = 0; t < 6; ++t) result.push_back(number(each));
  return result;
}

TEST(BoundTriangles, AreCounterclockwiseIfTheirAreasSumUpToThatOfTheSurface) {
  constexpr double kArea = 4 * std::numbers::pi;
  EXPECT_EQ(counterclockwise(six_areas(kArea / 6)), Tri::yes);
  // One that is turned over counts twice too much.
  for (std::size_t turned = 0; turned < 6; ++turned) {
    std::vector<Ball> areas = six_areas((kArea + 0.5) / 5);
    areas[turned] = number(0.5);
    EXPECT_EQ(counterclockwise(areas), Tri::no) << turned;
    // What is too much is nearly as large as this one.
    areas = six_areas(kArea / 5 - 1e-9);
    areas[turned] = number(0.25);
    EXPECT_EQ(counterclockwise(areas), Tri::yes) << turned;
    areas = six_areas(kArea / 5 + 1e-9);
    areas[turned] = number(0.25);
    EXPECT_EQ(counterclockwise(areas), Tri::no) << turned;
    areas[turned] = between(0.2, 0.3);
    EXPECT_NE(counterclockwise(areas), Tri::yes) << turned;
    areas = six_areas(kArea / 5 - 0.1);
    areas[turned] = between(0, 0.6);
    EXPECT_EQ(counterclockwise(areas), Tri::unknown) << turned;
  }
}

/// Across every dart of six triangles.
const std::vector<std::uint32_t> kAcross{3, 17, 8, 0, 16, 11, 12, 15, 2, 14, 13, 5, 6, 10, 9, 7, 4, 1};

/// sinh²(d/2) of each dart, all edges as long as one another.
std::vector<Ball> equal_sides(double h) {
  std::vector<Ball> result;
  for (std::size_t d = 0; d < kAcross.size(); ++d) result.push_back(number(h));
  return result;
}

std::vector<Ball> with_edge(std::vector<Ball> h, std::size_t dart, const Ball& length) {
  h[dart] = length;
  h[kAcross[dart]] = length;
  return h;
}

Tri answer(const std::vector<Ball>& h, const Ball& least) {
  const Precision scope(kPrecision);
  return is_delaunay_and_wide(kAcross, h, least);
}

TEST(BoundTriangles, AreWideIfOneIs) {
  for (std::size_t d = 0; d < kAcross.size(); ++d) ASSERT_EQ(kAcross[kAcross[d]], d);
  // 4abc/K = 4/3 of a = b = c = 1, and 16/7 · … of one side 3/2: 4 · 3/2 / (4 − 1/4) = 8/5.
  EXPECT_EQ(answer(equal_sides(1), number(4.0 / 3 - 1e-12)), Tri::yes);
  EXPECT_EQ(answer(equal_sides(1), number(4.0 / 3 + 1e-12)), Tri::no);
  EXPECT_EQ(answer(equal_sides(1), between(1, 2)), Tri::unknown);
  for (std::size_t d = 0; d < kAcross.size(); ++d) {
    const std::vector<Ball> h = with_edge(equal_sides(1), d, number(1.5));
    EXPECT_EQ(answer(h, number(1.6 - 1e-12)), Tri::yes) << d;
    EXPECT_EQ(answer(h, number(1.6 + 1e-12)), Tri::no) << d;
    // Some are certainly too small, two are open.
    EXPECT_EQ(answer(h, between(1.5, 1.7)), Tri::unknown) << d;
    // Wide for certain, whatever the others are.
    EXPECT_EQ(answer(h, between(1.2, 1.5)), Tri::yes) << d;
  }
}

TEST(BoundTriangles, AreDelaunayIfTheAnglesOppositeToEveryEdgeSaySo) {
  for (std::size_t d = 0; d < kAcross.size(); ++d) {
    // Opposite to an edge with 2 = 1 + 1 are two right angles, cot 90° = 0.
    EXPECT_EQ(answer(with_edge(equal_sides(1), d, number(1.999)), number(1)), Tri::yes) << d;
    EXPECT_EQ(answer(with_edge(equal_sides(1), d, number(2)), number(1)), Tri::no) << d;
    EXPECT_EQ(answer(with_edge(equal_sides(1), d, number(2.001)), number(1)), Tri::no) << d;
    EXPECT_EQ(answer(with_edge(equal_sides(1), d, between(1.999, 2.001)), number(1)), Tri::unknown) << d;
    // No circumcircle.
    EXPECT_EQ(answer(with_edge(equal_sides(1), d, number(5)), number(1)), Tri::no) << d;
    EXPECT_EQ(answer(with_edge(equal_sides(1), d, between(1, 5)), number(1)), Tri::unknown) << d;
  }
}

TEST(BoundTriangles, AreNoTriangulationIfTheirAreasAreTooLarge) {
  // Of six equilateral triangles, each of the area 2π/3 or more: the sum is less than 4π and one more up to 4π/5.
  const auto equilateral = [](double h) { return area_by_angles(h, h, h); };
  double low = 0.1, high = 100;
  for (int i = 0; i < 100; ++i) {
    const double h = (low + high) / 2;
    (5 * equilateral(h) < 4 * std::numbers::pi ? low : high) = h;
  }
  EXPECT_EQ(answer(equal_sides(low * (1 - 1e-9)), number(0.1)), Tri::yes);
  EXPECT_EQ(answer(equal_sides(low * (1 + 1e-9)), number(0.1)), Tri::no);
}

/// Whatever intervals decide, balls decide alike; and they decide what is not close.
TEST(BoundTriangles, IntervalsDecideAsBallsDo) {
  const auto exactly = [](double x) { return Interval{x, x}; };
  int decided = 0;
  for (const double a : {1e-9, 0.3, 1.0, 5.0}) {
    for (const double b : {0.25, 1.0, 4.0}) {
      for (const double c : {0.5, 1.0, 6.0}) {
        for (const double most : {0.2, 1.0, 4.0 / 3, 6.0, 100.0}) {
          const std::array<Interval, 3> sides{exactly(a), exactly(b), exactly(c)};
          const Tri found = fits(SidesIn<Interval>(sides), exactly(most));
          const Tri expected = fit(triangle(a, b, c), number(most));
          EXPECT_TRUE(found == expected || found == Tri::unknown) << a << ' ' << b << ' ' << c << ' ' << most;
          decided += found == Tri::unknown ? 0 : 1;
        }
      }
    }
  }
  EXPECT_GT(decided, 160);
  // One end says nothing.
  const std::array<Interval, 3> open{everything(), exactly(1), exactly(1)};
  EXPECT_EQ(fits(SidesIn<Interval>(open), exactly(2)), Tri::unknown);
  EXPECT_EQ(certainly_less(Interval{1, std::nan("")}, Interval{2, 3}), Tri::unknown);
}

/// To few units in the last place.
bool is_near(double x, double threshold) { return std::abs(x - threshold) < 1e-13 * std::abs(threshold); }

TEST(BoundTriangles, IntervalsAreNarrowAroundMeasures) {
  const Precision scope(kPrecision);
  const auto expect_around = [](const Interval& found, const Ball& exact) {
    const Interval wanted = outer_interval(exact);
    EXPECT_LE(found.lower, wanted.upper);
    EXPECT_GE(found.upper, wanted.lower);
    EXPECT_LT(found.upper - found.lower, 1e-12 * (std::abs(found.lower) + 1));
  };
  for (const double a : {0.3, 1.0, 5.0}) {
    for (const double b : {0.25, 1.0, 4.0}) {
      for (const double c : {0.5, 1.0, 6.0}) {
        if (4 * a * b - (a + b - c) * (a + b - c) < 0.01) continue;
        const std::array<Interval, 3> sides{Interval{a, a}, {b, b}, {c, c}};
        const MeasuresIn<Interval> found = measures(SidesIn<Interval>(sides));
        const TriangleMeasures wanted = measured(triangle(a, b, c));
        expect_around(found.k, wanted.k);
        expect_around(found.area, wanted.area);
        for (std::size_t i = 0; i < 3; ++i) expect_around(found.cotangent[i], wanted.cotangent[i]);
      }
    }
  }
}

/// In both arithmetics, of one wide side.
TEST(BoundTriangles, MeasuresOfWideSidesContainThoseOfTheirPoints) {
  const Precision scope(kPrecision);
  for (const auto& [a, b, c] : std::initializer_list<std::array<double, 3>>{
           {1, 1, 1}, {4, 5, 6}, {6, 4, 5}, {0.01, 0.02, 0.015}, {7, 1, 5}, {100, 70, 3}, {0.5, 8, 6}}) {
    for (const double width : {1e-2, 1e-6}) {
      for (std::size_t wide = 0; wide < 3; ++wide) {
        std::array<double, 3> sides{a, b, c};
        const double low = sides[wide] * (1 - width);
        const double high = sides[wide] * (1 + width);
        std::array<Interval, 3> intervals{Interval{a, a}, {b, b}, {c, c}};
        intervals[wide] = {low, high};
        Triangle balls = triangle(a, b, c);
        balls[wide] = between(low, high);
        const MeasuresIn<Interval> of_intervals = measures(SidesIn<Interval>(intervals));
        const TriangleMeasures of_balls = measured(balls);
        for (const double x : {low, high}) {
          sides[wide] = x;
          const TriangleMeasures point = measured(triangle(sides[0], sides[1], sides[2]));
          const auto expect_in = [&](const Ball& of_point, const Ball& ball, const Interval& interval) {
            EXPECT_NE(arb_overlaps(of_point.get(), ball.get()), 0);
            const Interval exact = outer_interval(of_point);
            EXPECT_LE(interval.lower, exact.upper) << sides[0] << ' ' << sides[1] << ' ' << sides[2];
            EXPECT_GE(interval.upper, exact.lower) << sides[0] << ' ' << sides[1] << ' ' << sides[2];
          };
          expect_in(point.k, of_balls.k, of_intervals.k);
          expect_in(point.area, of_balls.area, of_intervals.area);
          for (std::size_t i = 0; i < 3; ++i)
            expect_in(point.cotangent[i], of_balls.cotangent[i], of_intervals.cotangent[i]);
        }
      }
    }
  }
}

/// Of F areas x: Fx < x + π(F − 2).
TEST(BoundTriangles, IntervalsAndBallsKnowTheAreaOfTheSurface) {
  for (const std::size_t count : {4U, 6U, 10U, 30U}) {
    const double threshold = std::numbers::pi * static_cast<double>(count - 2) / static_cast<double>(count - 1);
    for (const double factor : {0.25, 0.999, 1 - 1e-9, 1 - 1e-12, 1.0, 1 + 1e-12, 1 + 1e-9, 1.001, 2.0}) {
      const double x = factor * threshold;
      const Tri of_balls = counterclockwise(std::vector<Ball>(count, number(x)));
      const Tri of_intervals = all_counterclockwise(std::vector<Interval>(count, Interval{x, x}));
      if (factor != 1.0) {
        EXPECT_EQ(of_balls, factor < 1 ? Tri::yes : Tri::no) << count << ' ' << factor;
        EXPECT_EQ(of_intervals, of_balls) << count << ' ' << factor;
      } else {
        EXPECT_TRUE(of_intervals == of_balls || of_intervals == Tri::unknown) << count;
      }
    }
  }
}

TEST(BoundTriangles, IntervalsTellDelaunayTriangulationsAsBallsDo) {
  int decided = 0;
  for (std::size_t d = 0; d < kAcross.size(); ++d) {
    for (const double h : {0.5, 1.0, 1.9, 1.999999, 2.0, 2.000001, 3.0, 5.0}) {
      for (const double least : {0.5, 1.3, 1.6, 100.0}) {
        const std::vector<Ball> balls = with_edge(equal_sides(1), d, number(h));
        std::vector<Interval> intervals(kAcross.size(), Interval{1, 1});
        intervals[d] = intervals[kAcross[d]] = Interval{h, h};
        const Tri wanted = answer(balls, number(least));
        const Tri found = is_delaunay_and_wide(kAcross, intervals, Interval{least, least});
        EXPECT_TRUE(found == wanted || (found == Tri::unknown && is_near(h, 2))) << d << ' ' << h << ' ' << least;
        decided += found == Tri::unknown ? 0 : 1;
      }
    }
  }
  EXPECT_GT(decided, 18 * 28 - 1);
}

// Flips and splits of triangulations (docs/proof.md, Lemma 21.2).

/// Elements of a group that is not commutative: matrices of integers modulo a prime, which are equal only if they are.
struct Matrix {
  std::uint64_t a = 1, b = 0, c = 0, d = 1;
  bool operator==(const Matrix&) const = default;
};
constexpr std::uint64_t kPrime = 1'000'003;
Matrix operator*(const Matrix& x, const Matrix& y) {
  return {(x.a * y.a + x.b * y.c) % kPrime, (x.a * y.b + x.b * y.d) % kPrime, (x.c * y.a + x.d * y.c) % kPrime,
          (x.c * y.b + x.d * y.d) % kPrime};
}
/// Of determinant 1.
Matrix inverse(const Matrix& x) { return {x.d, (kPrime - x.b) % kPrime, (kPrime - x.c) % kPrime, x.a}; }

/// Two triangles with one vertex, a torus, and elements as free as that allows.
class Steps : public testing::Test {
 protected:
  void SetUp() override {
    base = {{{3, 4, 5, 0, 1, 2}, {0, 2, 4, 1, 3, 5}}, std::vector<std::uint32_t>(6), {}};
    // Around the triangles fgh = 1 and f⁻¹g⁻¹h⁻¹ = 1: f and g commute.
    const Matrix f{1, 5, 0, 1}, g{1, 7, 0, 1};
    elements = {f, g, inverse(f * g), Matrix{}};
  }
  [[nodiscard]] Matrix along(std::uint32_t number) const {
    return number % 2 == 0 ? elements[number / 2] : inverse(elements[number / 2]);
  }
  void expect_consistent() const {
    const Map& map = base.map;
    ASSERT_EQ(base.start.size(), map.opposite.size());
    for (std::uint32_t d = 0; d < map.opposite.size(); ++d) {
      const std::uint32_t e = map.opposite[d];
      EXPECT_NE(e, d);
      EXPECT_EQ(map.opposite[e], d);
      EXPECT_EQ(along(map.element[d]) * along(map.element[e]), Matrix{}) << d;
      EXPECT_EQ(base.start[d], base.start[next_dart(e)]) << d;
    }
    for (std::uint32_t d = 0; d < map.opposite.size(); d += 3) {
      EXPECT_EQ(along(map.element[d]) * along(map.element[d + 1]) * along(map.element[d + 2]), Matrix{}) << d;
    }
  }

  Base base;
  std::vector<Matrix> elements;
};

TEST_F(Steps, KeepOppositesInverseAndTrianglesClosed) {
  expect_consistent();
  std::mt19937 random(3);
  int flips = 0;
  for (int step = 0; step < 200; ++step) {
    const auto d = static_cast<std::uint32_t>(random() % base.map.opposite.size());
    if (d / 3 == base.map.opposite[d] / 3) continue;
    if (step % 4 == 0) {
      const std::size_t triangles = base.start.size() / 3;
      split(base, d, 6);
      EXPECT_EQ(base.start.size() / 3, triangles + 2);
    } else {
      const Product product = flip(base, d, static_cast<std::uint32_t>(elements.size()));
      elements.push_back(along(product.first) * along(product.second));
      ++flips;
    }
    expect_consistent();
  }
  EXPECT_GT(flips, 50);
}

TEST_F(Steps, ASplitHasANewVertexBetweenTheEndsOfItsEdge) {
  split(base, 1, 6);
  ASSERT_EQ(base.midpoints.size(), 1U);
  EXPECT_EQ(base.midpoints[0].from, 0U);
  EXPECT_EQ(base.midpoints[0].to, 0U);
  EXPECT_EQ(base.midpoints[0].element, 2U);
  // From a to m the identity, from m on to b what led there.
  EXPECT_EQ(along(base.map.element[1]), Matrix{});
  EXPECT_EQ(base.start[next_dart(1)], 1U);
  EXPECT_EQ(along(base.map.element[6]), elements[1]);
  EXPECT_EQ(base.start[6], 1U);
  int darts = 0;
  for (const std::uint32_t vertex : base.start) darts += vertex == 1 ? 1 : 0;
  EXPECT_EQ(darts, 4);
}

}  // namespace
}  // namespace epsnet::certify::bound_triangles_test
