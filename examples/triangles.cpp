// Walking over the triangles of a net: their corners in one disk, their sides, their angles.
//
// A net has coordinates in many small disks, its charts, so that no point is near the boundary of its disk. The corners
// of one triangle can be had in one chart; that is enough for lengths and angles. To see triangles beside each other,
// as in a picture, they are lifted to one disk.
//
// Prints:
//   290 triangles, area 12.5664 (4 pi (g - 1) = 12.5664)
//   sides from 0.250264 to 0.487804, 0.327257 in the mean
//   290 lifts; the first, of triangle 60, has its corners at (0.0203767, -0.126185) (0.198245, 0.000274509) (0, 0)

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <epsnet/epsnet.h>
#include <iostream>
#include <limits>
#include <numbers>

using Point = epsnet::Complex<double>;  // A point x + iy of the Poincaré disk.

// The angle at p of the triangle pqr: with p moved to 0 the two sides are straight.
double angle(const Point& p, const Point& q, const Point& r) {
  const auto to_centre = epsnet::Isometry<double>::translation(-p);
  const Point u = to_centre(q);
  const Point v = to_centre(r);
  return std::atan2(cross(u, v), dot(u, v));
}

int main() {
  const epsnet::CertifiedNet result = epsnet::certified_net(epsnet::random_octagon(123), epsnet::Length("0.25"));
  const epsnet::certify::NetDocument& net = result.document;

  // Evaluates the isometries of the net. It refers to the document, which has to live longer.
  const epsnet::NetGeometry geometry(net);

  double area = 0;
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0;
  double sum = 0;
  for (std::uint32_t t = 0; t < net.triangles.size(); ++t) {
    const std::array<Point, 3> p = geometry.corners(t);  // Counterclockwise, in the chart of corner 0.
    area += std::numbers::pi;  // A triangle with the angles a, b, c has the area pi - a - b - c.
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Point& next = p[(i + 1) % 3];
      area -= angle(p[i], next, p[(i + 2) % 3]);
      const double length = epsnet::distance(p[i], next);
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
      sum += length;
      // What is across this side: triangle opposite / 3, its side opposite % 3. It may be triangle t itself.
      [[maybe_unused]] const std::uint32_t opposite = net.triangles[t].opposite[i];
    }
  }
  std::cout << net.triangles.size() << " triangles, area " << area << " (4 pi (g - 1) = " << 4 * std::numbers::pi
            << ")\nsides from " << shortest << " to " << longest << ", "
            << sum / (3.0 * static_cast<double>(net.triangles.size())) << " in the mean\n";

  // One lift of every triangle in one disk, connected, with vertex 0 in the centre: what a picture shows.
  const epsnet::Lifts lifts = epsnet::lift_triangles(geometry, epsnet::DrawOrder::weight);
  std::cout << lifts.lifted.size() << " lifts; the first, of triangle " << lifts.lifted[0].triangle
            << ", has its corners at";
  for (const Point& p : lifts.lifted[0].corner) {
    std::cout << " (" << p.x << ", " << p.y << ')';
  }
  std::cout << '\n';
}
