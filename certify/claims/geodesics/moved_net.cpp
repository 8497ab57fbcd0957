#include "certify/claims/geodesics/moved_net.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "certify/net/darts.h"

namespace epsnet::certify {
namespace {

/// The translation that takes 0 to x + iy.
BallIsometry translation_to(double x, double y) {
  const Ball re = Ball::exactly(x);
  const Ball im = Ball::exactly(y);
  const Ball scale = rsqrt(1 - sqr(re) - sqr(im));
  return {{scale, Ball()}, {re * scale, im * scale}};
}

}  // namespace

MovedNet::MovedNet(const LiftedPlane& plane) : plane_(plane) {
  const NetDocument& net = plane.net();
  const std::size_t darts = 3 * net.triangles.size();
  plane.spend(400, darts);
  plane.keep(8, darts);
  shortest_.assign(net.vertices.size(), std::numeric_limits<double>::infinity());
  const Precision scope(plane.precision());
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    const Ball value = half(-lorentz_product(plane.corner(dart), plane.corner(next_dart(dart)), plane.precision()) - 1);
    // With so few bits nothing would be known of the triangles.
    if (certainly_positive(value) != Tri::yes) return;
    const double length = std::sqrt(arf_get_d(arb_midref(value.get()), ARF_RND_NEAR));
    for (const std::uint32_t v : {start(net, dart), start(net, next_dart(dart))}) {
      shortest_[v] = std::min(shortest_[v], length);
    }
  }
  corners_.resize(darts);
  constexpr int kTries = 12;
  double share = 0.125;
  for (int tries = 0; tries < kTries && !valid_; ++tries, share /= 2) valid_ = place(share);
  if (valid_) measure();
}

/// Moves the vertices; false if not all triangles certainly are counterclockwise.
bool MovedNet::place(double share) {
  const NetDocument& net = plane_.net();
  std::mt19937 random;
  const auto moved_by = [&](double size) { return size * (std::ldexp(static_cast<double>(random()), -31) - 1); };
  // In the chart with the vertex at its origin, as next to other numbers small ones would be lost.
  std::vector<std::array<double, 2>> moves(net.vertices.size());
  for (std::uint32_t v = 0; v < moves.size(); ++v) {
    for (double& x : moves[v]) x = moved_by(share * shortest_[v]);
    if (!(std::hypot(moves[v][0], moves[v][1]) < 0.5)) return false;
  }
  for (std::uint32_t dart = 0; dart < corners_.size(); ++dart) {
    const std::uint32_t v = start(net, dart);
    const BallIsometry from_origin = compose(plane_.label(corner_label(net, dart)),
                                             translation_to(net.vertices[v].x, net.vertices[v].y), plane_.precision());
    corners_[dart] = unit_vector(from_origin, moves[v][0], moves[v][1], plane_.precision());
    // Else it is no point of the plane.
    if (certainly_positive(corners_[dart][2]) != Tri::yes) return false;
  }
  Ball determinant;
  for (std::uint32_t dart = 0; dart < corners_.size(); dart += 3) {
    dot(determinant, cross_product(corners_[dart], corners_[dart + 1], plane_.precision()), corners_[dart + 2],
        plane_.precision());
    if (certainly_positive(determinant) != Tri::yes) return false;
  }
  return true;
}

void MovedNet::measure() {
  const slong precision = plane_.precision();
  beyond_.resize(corners_.size());
  cosh_.resize(corners_.size());
  const Precision scope(precision);
  Ball volume;
  for (std::uint32_t dart = 0; dart < corners_.size(); ++dart) {
    const BallVector& right = corners_[dart];
    const BallVector& left = corners_[next_dart(dart)];
    const BallVector& apex = corners_[previous_dart(dart)];
    cosh_[dart] = outer_interval(-lorentz_product(left, right, precision));
    const std::uint32_t other = opposite(plane_.net(), dart);
    BallVector x = corners_[previous_dart(other)];
    if (const auto* transition = plane_.transition(other)) x = apply(transition->matrix, x, precision);
    // Cramer's rule.
    const std::array<BallVector, 3> lines = {cross_product(right, apex, precision),
                                             cross_product(apex, left, precision),
                                             cross_product(left, right, precision)};
    dot(volume, lines[0], left, precision);
    for (std::size_t i = 0; i < 3; ++i) {
      dot(beyond_[dart][i], lines[i], x, precision);
      beyond_[dart][i] = beyond_[dart][i] / volume;
    }
  }
}

DartOrder::DartOrder(const MovedNet& net, const std::vector<bool>& inner) : code_(inner.size()) {
  const NetDocument& document = net.plane().net();
  std::vector<std::uint32_t> edges;
  for (std::uint32_t dart = 0; dart < inner.size(); ++dart) {
    if (dart < opposite(document, dart)) edges.push_back(dart);
  }
  // Any order is right. Short edges first: fewer geodesics cross them, and later searches have fewer edges to cross.
  std::stable_sort(edges.begin(), edges.end(), [&](std::uint32_t x, std::uint32_t y) {
    return inner[x] != inner[y] ? inner[y] : net.cosh_length(x).lower < net.cosh_length(y).lower;
  });
  for (const std::uint32_t edge : edges) {
    starts_ += inner[edge] ? 0 : 1;
    for (const std::uint32_t dart : {edge, opposite(document, edge)}) {
      code_[dart] = static_cast<std::uint32_t>(darts_.size());
      darts_.push_back(dart);
    }
  }
}

}  // namespace epsnet::certify
