// Locating points in a net: in which triangle is a point, and how far is the nearest corner?
//
// Points are given in the disk with vertex 0 in the centre, which covers the surface: a point far out is one that a
// walk from vertex 0 reaches, perhaps after going around the surface many times.
//
// Prints:
//   (0, 0): triangle 60, nearest corner at 0
//   (0.5, 0.25): triangle 97, nearest corner at 0.173858
//   (-0.3, 0.9): triangle 20, nearest corner at 0.114389
//   (0.6, 0.799999999999): triangle 121, nearest corner at 0.101573

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <epsnet/epsnet.h>
#include <iostream>
#include <limits>

// 256 bits: near the boundary of the disk, binary64 does not tell points of the surface from each other.
using Number = epsnet::Mp256;
using Point = epsnet::Complex<Number>;

// The three corners of a lifted triangle.
std::array<Point, 3> corners(const epsnet::NetGeometry& geometry, const epsnet::Placement& placement) {
  std::array<Point, 3> result;
  const auto local = geometry.corners(placement.triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = placement.isometry(epsnet::convert<Number>(local[i]));
  }
  return result;
}

// The lifted triangle that contains a point: while the point is beyond a side, step across it.
epsnet::Placement locate(const epsnet::NetGeometry& geometry, epsnet::Placement placement, const Point& point) {
  for (;;) {
    const std::array<Point, 3> p = corners(geometry, placement);
    std::uint32_t side = 0;
    while (side < 3) {
      // With p[side] moved to 0 the side is straight, and the sign of a cross product says on which side the point is.
      const auto straight = epsnet::Isometry<Number>::translation(-p[side]);
      if (cross(straight(p[(side + 1) % 3]), straight(point)) < 0) {
        break;
      }
      ++side;
    }
    if (side == 3) {
      return placement;
    }
    placement = epsnet::neighbour(geometry, placement, side);
  }
}

int main() {
  const epsnet::CertifiedNet result = epsnet::certified_net(epsnet::random_octagon(123), epsnet::Length("0.25"));
  const epsnet::NetGeometry geometry(result.net);
  const epsnet::Placement start = epsnet::placement_at(geometry, 0, epsnet::to_centre(geometry, 0));

  for (const auto& [x, y] : {std::array{"0", "0"}, {"0.5", "0.25"}, {"-0.3", "0.9"}, {"0.6", "0.799999999999"}}) {
    const Point point{Number(x), Number(y)};
    const epsnet::Placement found = locate(geometry, start, point);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& corner : corners(geometry, found)) {
      nearest = std::min(nearest, static_cast<double>(epsnet::distance(point, corner)));
    }
    // The net is a covering: this is never more than 0.25.
    std::cout << '(' << x << ", " << y << "): triangle " << found.triangle << ", nearest corner at " << nearest << '\n';
  }
}
