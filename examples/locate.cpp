// Locating points in a net: in which triangle is a point, and how far is the nearest corner?
//
// Points are given in the Poincaré disk of a tile, exactly.
//
// Prints:
//   (0, 0): triangle 95, nearest corner at 0.015509
//   (1/2, 1/4): triangle 194, nearest corner at 0.017909
//   (-1/3, 1/4): triangle 237, nearest corner at 0.124765

#include <array>
#include <epsnet/epsnet.h>
#include <iostream>

int main() {
  const epsnet::CertifiedNet result = epsnet::certified_net(epsnet::random_octagon(123), epsnet::Length("0.25"));
  epsnet::Locator locator(result.document);
  using epsnet::Rational;
  for (const auto& [x, y] :
       {std::array{Rational(0), Rational(0)}, {Rational(1, 2), Rational(1, 4)}, {Rational(-1, 3), Rational(1, 4)}}) {
    const epsnet::PointLocation found = locator.locate({epsnet::TileId(0), {x, y}});
    // The net is a covering: this is never more than 0.25.
    std::cout << '(' << x << ", " << y << "): triangle " << found.triangle << ", nearest corner at "
              << found.distances[found.nearest_corner()] << '\n';
  }
}
