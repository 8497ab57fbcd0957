#include "certify/net/filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/net/darts.h"

namespace epsnet::certify {
namespace filter {
namespace {

// Differences of coordinates are rounded once, so they are as accurate as numbers can be, however close the points.
Point minus(Point p, Point q) { return {p.x - q.x, p.y - q.y}; }
double norm(Point z) { return std::max(std::abs(z.x), std::abs(z.y)); }
double cross(Point p, Point q) { return p.x * q.y - p.y * q.x; }
Point times(Point p, Point q) { return {p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x}; }

/// Below, products might underflow (proof.md, Lemma 26).
constexpr double kLeastNorm = 0x1p-100;
constexpr double kLeastGap = 0x1p-12;
/// What quotients of measures are widened by.
constexpr double kWider = 1 + 0x1p-30;
constexpr double kNarrower = 1 - 0x1p-30;

}  // namespace

bool counterclockwise(Point z0, Point z1, Point z2) {
  const Point s = minus(z1, z0);
  const Point v = minus(z2, z0);
  if (!(norm(s) > kLeastNorm && norm(v) > kLeastNorm)) return false;
  // det(x, y, 1 + |z|²), the first row subtracted from the others: |z1|² − |z0|² = s·(z0 + z1).
  const double f = s.x * (z0.x + z1.x) + s.y * (z0.y + z1.y);
  const double g = v.x * (z0.x + z2.x) + v.y * (z0.y + z2.y);
  const double middle = (1 + (z0.x * z0.x + z0.y * z0.y)) * cross(s, v);
  const double determinant = (middle + z0.x * (s.y * g - v.y * f)) - z0.y * (s.x * g - v.x * f);
  return determinant > 0x1p-42 * (norm(s) * norm(v));
}

bool delaunay(Point z0, Point z1, Point z2, Point z3) {
  const Point a = minus(z3, z1);
  const Point b = minus(z2, z0);
  const Point c = minus(z3, z0);
  const Point d = minus(z2, z1);
  if (!(norm(a) > kLeastNorm && norm(b) > kLeastNorm && norm(c) > kLeastNorm && norm(d) > kLeastNorm)) return false;
  return cross(times(c, d), times(a, b)) < -0x1p-41 * ((norm(a) * norm(b)) * (norm(c) * norm(d)));
}

Squared squared_distance(Point p, Point q) {
  const Point s = minus(p, q);
  return {s.x * s.x + s.y * s.y, norm(s) > kLeastNorm};
}

double gap(Point z) {
  const double a = 1 - (z.x * z.x + z.y * z.y);
  return a > kLeastGap ? a : 0;
}

Interval squared_half_sinh(double d, double a, double b) {
  const double quotient = d / (a * b);
  return {quotient * kNarrower, quotient * kWider};
}

Interval squared_sinh_of_circumradius(const std::array<double, 3>& d, const std::array<double, 3>& a) {
  const double x = d[0] * a[2];
  const double y = d[1] * a[0];
  const double z = d[2] * a[1];
  const double w = x + y - z;
  const double k = 4 * (x * y) - w * w;
  const double greatest = std::max({x, y, z});
  const double error = 0x1p-29 * (greatest * greatest);
  // A flat triangle, for which balls are better.
  if (!(k > 0x1p-10 * (greatest * greatest))) return {0, std::numeric_limits<double>::infinity()};
  const double numerator = 4 * ((d[0] * d[1]) * d[2]);
  return {numerator / (k + error) * kNarrower, numerator / (k - error) * kWider};
}

}  // namespace filter

Filter::Answer Filter::answer(std::uint32_t t, Questions asked) const {
  Answer answer;
  if (!is_proved_) return answer;
  const NetDocument::Triangle& triangle = document_.triangles[t];
  if (triangle.label[0] != 0 || triangle.label[1] != 0 || collars_.has_triangle(t)) return answer;
  const auto point = [&](std::uint32_t vertex) {
    return filter::Point{document_.vertices[vertex].x, document_.vertices[vertex].y};
  };
  std::array<filter::Point, 3> z{};
  std::array<double, 3> a{};
  for (std::size_t i = 0; i < 3; ++i) {
    z[i] = point(triangle.vertex[i]);
    a[i] = filter::gap(z[i]);
  }
  const auto settle = [&](Questions question) { answer.settled = static_cast<Questions>(answer.settled | question); };
  if ((asked & kOrientationBit) != 0 && filter::counterclockwise(z[0], z[1], z[2])) settle(kOrientationBit);
  std::array<double, 3> d{};
  bool accurate = a[0] > 0 && a[1] > 0 && a[2] > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const filter::Squared squared = filter::squared_distance(z[i], z[(i + 1) % 3]);
    d[i] = squared.value;
    accurate = accurate && squared.accurate;
  }
  if ((asked & kCoveringBit) != 0 && accurate) {
    answer.circumradius = filter::squared_sinh_of_circumradius(d, a);
    if (answer.circumradius.upper < sinh_squared_) settle(kCoveringBit);
  }
  for (std::uint32_t i = 0; i < 3; ++i) {
    const std::uint32_t from = triangle.vertex[i];
    const std::uint32_t to = triangle.vertex[(i + 1) % 3];
    if ((asked & length_bit(i)) != 0 && accurate && from != to && !collars_.are_partners(from, to)) {
      answer.length[i] = filter::squared_half_sinh(d[i], a[i], a[(i + 1) % 3]);
      if (answer.length[i].lower > half_sinh_squared_) settle(length_bit(i));
    }
    if ((asked & delaunay_bit(i)) != 0) {
      const std::uint32_t other = triangle.opposite[i];
      const std::uint32_t far = previous_dart(other);
      // The far corner lies where its coordinates say, if it and the corner next to it carry the identity.
      if (corner_label(document_, next_dart(other)) == 0 && corner_label(document_, far) == 0 &&
          filter::delaunay(z[i], point(start(document_, far)), z[(i + 1) % 3], z[(i + 2) % 3])) {
        settle(delaunay_bit(i));
      }
    }
  }
  return answer;
}

}  // namespace epsnet::certify
