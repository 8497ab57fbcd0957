#include "certify/claims/geodesics/moved_net.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "certify/net/darts.h"

namespace epsnet::certify {

MovedNet::MovedNet(const LiftedPlane& plane) : plane_(plane) {
  const NetDocument& net = plane.net();
  const std::size_t darts = 3 * net.triangles.size();
  plane.spend(400, darts);
  plane.keep(8, darts);
  shortest_.assign(net.vertices.size(), std::numeric_limits<double>::infinity());
  const Precision scope(plane.precision());
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    const Ball value = half(lorentz_product(plane.corner(dart), plane.corner(next_dart(dart)), plane.precision()) + 1);
    const double length = std::sqrt(std::abs(arf_get_d(arb_midref(value.get()), ARF_RND_NEAR)));
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
  std::vector<NetDocument::Vertex> vertices = net.vertices;
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    NetDocument::Vertex& vertex = vertices[v];
    const double size = share * shortest_[v] * (1 - vertex.x * vertex.x - vertex.y * vertex.y);
    vertex.x += size * (std::ldexp(static_cast<double>(random()), -31) - 1);
    vertex.y += size * (std::ldexp(static_cast<double>(random()), -31) - 1);
    if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y)) return false;
  }
  for (std::uint32_t dart = 0; dart < corners_.size(); ++dart) {
    const NetDocument::Vertex& vertex = vertices[start(net, dart)];
    corners_[dart] = unit_vector(plane_.label(corner_label(net, dart)), vertex.x, vertex.y, plane_.precision());
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
