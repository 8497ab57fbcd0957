#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

#include "certify/claims/geodesics/crossing_search.h"
#include "tests/support/scale.h"

/// The lower bound for the distance of two segments, beside the distance itself.
namespace epsnet::certify::edge_distance_test {
namespace {

using Real = long double;
using Point = std::array<Real, 3>;  ///< Of the hyperboloid.

Real cosh_distance(const Point& x, const Point& y) {
  return std::max(x[2] * y[2] - x[0] * y[0] - x[1] * y[1], Real(1));
}

/// At a distance from the origin, in a direction.
Point polar(Real distance, Real angle) {
  return {std::sinh(distance) * std::cos(angle), std::sinh(distance) * std::sin(angle), std::cosh(distance)};
}

struct Segment {
  Point start;
  Point end;

  [[nodiscard]] Real length() const { return std::acosh(cosh_distance(start, end)); }
  /// The point at so many parts of the length.
  [[nodiscard]] Point at(Real part) const {
    const Real l = length();
    const Real x = l < 1e-9L ? 1 - part : std::sinh((1 - part) * l) / std::sinh(l);
    const Real y = l < 1e-9L ? part : std::sinh(part * l) / std::sinh(l);
    return {x * start[0] + y * end[0], x * start[1] + y * end[1], x * start[2] + y * end[2]};
  }
};

/// cosh of the distance of a point from a segment of length l: (p sinh(l − τ) + q sinh τ)/sinh l, where p and q are
/// those of its ends, is least where its derivative vanishes.
Real cosh_distance(const Point& point, const Segment& segment) {
  const Real l = segment.length();
  const Real p = cosh_distance(point, segment.start);
  const Real q = cosh_distance(point, segment.end);
  if (l < 1e-9L) return std::min(p, q);
  const Real tanh = (p * std::cosh(l) - q) / (p * std::sinh(l));
  if (tanh <= 0) return p;
  if (tanh >= std::tanh(l)) return q;
  return cosh_distance(point, segment.at(std::atanh(tanh) / l));
}

/// cosh of the distance, which is convex along a segment.
Real cosh_distance(const Segment& x, const Segment& y) {
  Real low = 0;
  Real high = 1;
  const auto f = [&](Real s) { return cosh_distance(x.at(s), y); };
  for (int i = 0; i < 70; ++i) {
    const Real first = low + (high - low) / 3;
    const Real second = high - (high - low) / 3;
    if (f(first) < f(second)) {
      high = second;
    } else {
      low = first;
    }
  }
  return std::min({f(0), f(1), f((low + high) / 2)});
}

int side(const Segment& line, const Point& p) {
  const auto& [u, v] = line;
  const Real determinant =
      p[0] * (u[1] * v[2] - u[2] * v[1]) + p[1] * (u[2] * v[0] - u[0] * v[2]) + p[2] * (u[0] * v[1] - u[1] * v[0]);
  return determinant > 0 ? 1 : -1;
}

bool cross(const Segment& x, const Segment& y) {
  return side(x, y.start) != side(x, y.end) && side(y, x.start) != side(y, x.end);
}

/// An enclosure, wide or narrow, of which the number has so many parts of the width below it.
Interval around(Real x, Real width, Real part) {
  return {static_cast<double>(x - 2 * width * part * x) - 1e-15,
          static_cast<double>(x + 2 * width * (1 - part) * x) + 1e-15};
}

/// Each number is in the middle of its enclosure, or anywhere.
SegmentPair pair_of(
    const Segment& first, const Segment& other, Real width,
    const std::function<Real()>& part = [] { return Real(0.5); }) {
  const auto around = [&](Real x, Real w) { return edge_distance_test::around(x, w, part()); };
  // From s to e, and from r to l.
  return {.e_l = around(cosh_distance(first.end, other.end), width),
          .s_l = around(cosh_distance(first.start, other.end), width),
          .e_r = around(cosh_distance(first.end, other.start), width),
          .s_r = around(cosh_distance(first.start, other.start), width),
          .l_r = around(cosh_distance(other.start, other.end), width),
          .e_s = around(cosh_distance(first.start, first.end), width)};
}

class Segments {
 public:
  /// One in a disk.
  Segment any(Real radius) {
    const auto point = [&] { return polar(radius * share_(random_), Real(6.3) * share_(random_)); };
    const Point start = point();
    return {start, point()};
  }
  /// From 0 to 1: anywhere, or one of the ends.
  Real part(int kind) {
    const Real share = share_(random_);
    return kind % 2 == 0 ? share : std::round(share);
  }

 private:
  std::mt19937 random_{44};
  std::uniform_real_distribution<double> share_{0, 1};
};

TEST(EdgeDistance, IsNeverMoreThanThatOfSegments) {
  Segments segments;
  int narrow = 0;
  const auto count = static_cast<int>(3000 * test::multiplier());
  for (int i = 0; i < count; ++i) {
    const Real radius = i % 4 == 0 ? 0.3L : i % 4 == 1 ? 1.5L : 4;
    const Segment first = segments.any(radius);
    const Segment other = segments.any(radius);
    if (cross(first, other)) continue;
    const Real cosh = cosh_distance(first, other);
    for (const Real width : {0.0L, 1e-12L, 1e-5L, 1e-3L, 1e-2L, 5e-2L, 0.2L}) {
      const double bound = cosh2_below(pair_of(first, other, width));
      EXPECT_LE(bound, static_cast<double>(cosh * cosh) * (1 + 1e-10)) << i << ", " << static_cast<double>(width);
      // Wherever the numbers are in their enclosures.
      for (int k = 0; k < 6; ++k) {
        const auto part = [&] { return segments.part(k); };
        EXPECT_LE(cosh2_below(pair_of(first, other, width, part)), static_cast<double>(cosh * cosh) * (1 + 1e-10))
            << i << ", " << static_cast<double>(width);
      }
      if (width == 0 && bound > static_cast<double>(cosh * cosh) * (1 - 1e-6)) ++narrow;
    }
  }
  // It is the distance itself for most of them.
  EXPECT_GT(narrow, count / 2);
}

TEST(EdgeDistance, IsThatOfTheNearestEndWhicheverItIs) {
  // Two perpendicular segments of lengths 2 and 4, the end of one at the distance 1 from the middle of the other.
  const Segment base{polar(2, M_PIl / 2), polar(2, -M_PIl / 2)};
  const Segment upright{polar(1, 0), polar(3, 0)};
  const auto turned = [](const Segment& x) { return Segment{x.end, x.start}; };
  for (const Segment& x : {base, turned(base)}) {
    for (const Segment& y : {upright, turned(upright)}) {
      const double expected = std::pow(std::cosh(1.0), 2);
      EXPECT_NEAR(cosh2_below(pair_of(x, y, 0)), expected, 1e-9);
      EXPECT_NEAR(cosh2_below(pair_of(y, x, 0)), expected, 1e-9);
    }
  }
}

TEST(EdgeDistance, IsThatOfTheLinesWhereTheyHaveTheirFeetOnTheSegments) {
  // Two segments perpendicular to one of length 1 in their middles.
  const auto upright = [](Real x) {
    // The point at the distance x on the axis, and those at the distance 2 beside it.
    const auto point = [&](Real y) {
      return Point{std::cosh(y) * std::sinh(x), std::sinh(y), std::cosh(y) * std::cosh(x)};
    };
    return Segment{point(-2), point(2)};
  };
  EXPECT_NEAR(cosh2_below(pair_of(upright(0), upright(1), 0)), std::pow(std::cosh(1.0), 2), 1e-9);
}

TEST(EdgeDistance, OfShortSegmentsIsNoMoreThanThatOfTheirEnds) {
  for (const Real length : {0.0L, 1e-14L, 1e-9L, 1e-3L}) {
    const Segment first{polar(length, 0), polar(0, 0)};
    for (const Segment& other : {Segment{polar(3, 1), polar(3 + length, 1)}, Segment{polar(3, 0), polar(4, 2)}}) {
      const auto cosh = static_cast<double>(cosh_distance(first, other));
      EXPECT_LE(cosh2_below(pair_of(first, other, 0)), cosh * cosh * (1 + 1e-10));
      EXPECT_LE(cosh2_below(pair_of(other, first, 0)), cosh * cosh * (1 + 1e-10));
    }
  }
}

TEST(EdgeDistance, OfWhatIsTooFarAwayNothingIsSaid) {
  const Interval far{1e71, 1e71};
  EXPECT_EQ(cosh2_below({far, far, far, far, {2, 2}, {2, 2}}), 1);
  const Interval near{1, 2};
  for (const Interval x : {Interval{1, INFINITY}, Interval{1, NAN}, Interval{NAN, NAN}}) {
    EXPECT_EQ(cosh2_below({x, near, near, near, near, near}), 1);
    EXPECT_EQ(cosh2_below({near, near, near, x, near, near}), 1);
    EXPECT_EQ(cosh2_below({near, near, near, near, x, near}), 1);
    EXPECT_EQ(cosh2_below({near, near, near, near, near, x}), 1);
  }
}

}  // namespace
}  // namespace epsnet::certify::edge_distance_test
