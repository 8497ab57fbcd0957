#include "netgen/lifts/lifts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <string>
#include <utility>

#include "certify/net/darts.h"

namespace epsnet {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// The labels of the corner where a dart starts: in the dart's triangle, and in the triangle on the other side.
std::pair<std::uint32_t, std::uint32_t> labels_across(const NetGeometry& geometry, std::uint32_t dart) {
  const certify::NetDocument& net = geometry.document();
  return {certify::corner_label(net, dart),
          certify::corner_label(net, certify::next_dart(certify::opposite(net, dart)))};
}

/// The isometries from the charts of corners to the disk. Corners with the same isometry share one.
class Placements {
 public:
  explicit Placements(const NetGeometry& geometry) : geometry_(geometry) {}

  std::uint32_t add(const Isometry<Mp256>& isometry) {
    placements_.emplace_back(normalized(isometry));
    return static_cast<std::uint32_t>(placements_.size() - 1);
  }

  /// Returns the placement of corner 0 of the triangle across a dart, from that of the dart's triangle.
  std::uint32_t across(std::uint32_t placement, std::uint32_t dart) {
    const auto [here, there] = labels_across(geometry_, dart);
    if (here == there) return placement;
    return add(placements_[placement].precise * geometry_.label(here).precise *
               inverse(geometry_.label(there).precise));
  }

  /// Returns the placement of a corner with this label, from that of corner 0 of its triangle. It has 256 bits: in a
  /// thin collar the corners of a triangle are so far apart that binary64 cannot distinguish one, seen from the other,
  /// from a point of the unit circle.
  std::uint32_t of_corner(std::uint32_t placement, std::uint32_t label) {
    if (label == 0) return placement;
    const auto [known, is_new] = of_corners_.try_emplace({placement, label}, 0);
    if (is_new) known->second = add(placements_[placement].precise * geometry_.label(label).precise);
    return known->second;
  }

  [[nodiscard]] const Isometry<double>& rounded(std::uint32_t placement) const {
    return placements_[placement].rounded;
  }
  [[nodiscard]] std::vector<PreciseIsometry> all() && { return std::move(placements_); }

 private:
  const NetGeometry& geometry_;
  std::vector<PreciseIsometry> placements_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> of_corners_;  ///< By placement and label.
};

/// Grows the set of lifted triangles.
class Lifter {
 public:
  Lifter(const NetGeometry& geometry, DrawOrder order, std::uint32_t centre)
      : geometry_(geometry),
        triangles_(geometry.document().triangles),
        order_(order),
        centre_(centre),
        placements_(geometry) {
    lifts_.place.assign(triangles_.size(), kNone);
  }

  [[nodiscard]] Lifts run() {
    lift_first();
    while (!edges_.empty()) {
      const std::uint32_t dart = edges_.top().second;
      edges_.pop();
      const std::uint32_t other = triangles_[dart / 3].opposite[dart % 3] / 3;
      if (lifts_.place[other] != kNone) continue;
      lift(other, placements_.across(lifts_.lifted[lifts_.place[dart / 3]].placement[0], dart));
    }
    if (lifts_.lifted.size() != triangles_.size())
      throw NetGeometryError("only " + std::to_string(lifts_.lifted.size()) + " of " +
                             std::to_string(triangles_.size()) + " triangles are connected");
    lifts_.placements = std::move(placements_).all();
    return std::move(lifts_);
  }

 private:
  void lift_first() {
    const Placement first = placement_at(geometry_, centre_, to_centre(geometry_, centre_));
    lift(first.triangle, placements_.add(first.isometry));
  }

  void lift(std::uint32_t triangle, std::uint32_t placement) {
    Lifts::LiftedTriangle lifted{triangle, {}, {}};
    for (std::uint32_t i = 0; i < 3; ++i) {
      const certify::NetDocument::Vertex& v = geometry_.document().vertices[triangles_[triangle].vertex[i]];
      lifted.placement[i] =
          placements_.of_corner(placement, certify::corner_label(geometry_.document(), 3 * triangle + i));
      lifted.corner[i] = placements_.rounded(lifted.placement[i])({v.x, v.y});
      // Points that round to the circle are allowed, as they are no farther from it than rounding.
      if (!(norm(lifted.corner[i]) < 1 + 1e-12))
        throw NetGeometryError("triangles[" + std::to_string(triangle) + "]: a corner is not in the disk");
    }
    lifts_.place[triangle] = static_cast<std::uint32_t>(lifts_.lifted.size());
    lifts_.lifted.push_back(lifted);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const double weight = order_ == DrawOrder::weight ? norm(lifted.corner[i]) + norm(lifted.corner[(i + 1) % 3])
                                                        : static_cast<double>(lifts_.place[triangle]);
      edges_.push({weight, 3 * triangle + i});
    }
  }

  using Edge = std::pair<double, std::uint32_t>;  ///< Weight and dart; the dart breaks ties.

  const NetGeometry& geometry_;
  const std::vector<certify::NetDocument::Triangle>& triangles_;
  DrawOrder order_;
  std::uint32_t centre_;
  Placements placements_;
  Lifts lifts_;
  std::priority_queue<Edge, std::vector<Edge>, std::greater<>> edges_;
};

}  // namespace

Isometry<Mp256> to_centre(const NetGeometry& geometry, std::uint32_t vertex) {
  if (vertex >= geometry.document().vertices.size())
    throw NetGeometryError("there is no vertex " + std::to_string(vertex));
  const certify::NetDocument::Vertex& v = geometry.document().vertices[vertex];
  return Isometry<Mp256>::translation({Mp256(-v.x), Mp256(-v.y)});
}

Placement placement_at(const NetGeometry& geometry, std::uint32_t vertex, const Isometry<Mp256>& frame) {
  const std::vector<certify::NetDocument::Triangle>& triangles = geometry.document().triangles;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (triangles[t].vertex[i] == vertex)
        return {t, frame * inverse(geometry.label(certify::corner_label(geometry.document(), 3 * t + i)).precise)};
    }
  }
  throw NetGeometryError("vertex " + std::to_string(vertex) + " is a corner of no triangle");
}

Placement neighbour(const NetGeometry& geometry, const Placement& placement, std::uint32_t side) {
  assert(placement.triangle < geometry.document().triangles.size() && side < 3);
  const std::uint32_t dart = 3 * placement.triangle + side;
  const std::uint32_t other = geometry.document().triangles[placement.triangle].opposite[side] / 3;
  const auto [here, there] = labels_across(geometry, dart);
  if (here == there) return {other, placement.isometry};
  return {other,
          normalized(placement.isometry * geometry.label(here).precise * inverse(geometry.label(there).precise))};
}

Lifts lift_triangles(const NetGeometry& geometry, DrawOrder order, std::uint32_t centre) {
  return Lifter(geometry, order, centre).run();
}

std::vector<bool> boundary_darts(const NetGeometry& geometry, const Lifts& lifts) {
  const std::vector<certify::NetDocument::Triangle>& triangles = geometry.document().triangles;
  const auto corner = [&](std::uint32_t dart) { return lifts.lifted[lifts.place[dart / 3]].corner[dart % 3]; };
  // Two lifts of a point are the same or far apart, at the scale of the place.
  const auto same = [](const Complex<double>& u, const Complex<double>& v) {
    return std::sqrt(norm(u - v)) < 1e-6 * std::max(1 - norm(u), 1e-9);
  };
  std::vector<bool> result(3 * triangles.size());
  for (std::uint32_t dart = 0; dart < result.size(); ++dart) {
    const std::uint32_t other = triangles[dart / 3].opposite[dart % 3];
    result[dart] = !(same(corner(dart), corner(certify::next_dart(other))) &&
                     same(corner(certify::next_dart(dart)), corner(other)));
  }
  return result;
}

}  // namespace epsnet
