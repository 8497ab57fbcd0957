#include "netgen/exchange/drawn_mesh.h"

#include <algorithm>

#include "certify/net/numbering.h"
#include "netgen/base/disjoint_sets.h"

namespace epsnet {
namespace {

using Triangles = std::vector<certify::NetDocument::Triangle>;

std::uint32_t opposite(const Triangles& triangles, std::uint32_t dart) {
  return triangles[dart / 3].opposite[dart % 3];
}

/// The darts on the boundary, each followed by the one that starts where it ends.
std::vector<std::uint32_t> boundary_cycle(const Triangles& triangles, const std::vector<bool>& on_boundary) {
  const auto first =
      static_cast<std::uint32_t>(std::find(on_boundary.begin(), on_boundary.end(), true) - on_boundary.begin());
  std::vector<std::uint32_t> cycle;
  if (first == on_boundary.size()) return cycle;
  std::uint32_t dart = first;
  do {
    cycle.push_back(dart);
    dart = certify::next_dart(dart);
    while (!on_boundary[dart]) dart = certify::next_dart(opposite(triangles, dart));
  } while (dart != first);
  return cycle;
}

/// Cuts the boundary into sides. Two edges that follow each other are glued by the same element of the group if and
/// only if their opposites follow each other too: the quotient of their elements then fixes a point.
std::vector<DrawnMesh::Side> sides(const Triangles& triangles, const std::vector<bool>& on_boundary) {
  std::vector<std::uint32_t> cycle = boundary_cycle(triangles, on_boundary);
  std::vector<std::uint32_t> place(on_boundary.size());
  for (std::uint32_t i = 0; i < cycle.size(); ++i) place[cycle[i]] = i;
  const auto begins_side = [&](std::uint32_t before, std::uint32_t dart) {
    const std::size_t next = (std::size_t{place[opposite(triangles, dart)]} + 1) % cycle.size();
    return next != place[opposite(triangles, before)];
  };
  std::size_t begin = 0;
  for (std::size_t i = 1; i < cycle.size() && begin == 0; ++i) {
    if (begins_side(cycle[i - 1], cycle[i])) begin = i;
  }
  std::vector<DrawnMesh::Side> result;
  std::vector<std::uint32_t> side_of(on_boundary.size());
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const std::uint32_t dart = cycle[(begin + i) % cycle.size()];
    if (i == 0 || begins_side(result.back().darts.back(), dart)) result.emplace_back();
    result.back().darts.push_back(dart);
    side_of[dart] = static_cast<std::uint32_t>(result.size() - 1);
  }
  for (DrawnMesh::Side& side : result) side.partner = side_of[opposite(triangles, side.darts.front())];
  return result;
}

}  // namespace

DrawnMesh drawn_mesh(const NetGeometry& geometry, const Lifts& lifts) {
  const Triangles& triangles = geometry.document().triangles;
  DrawnMesh result;
  result.on_boundary = boundary_darts(geometry, lifts);
  // Corners, numbered by the darts that start there, are identified across edges inside the drawing.
  DisjointSets corners(3 * triangles.size());
  for (std::uint32_t dart = 0; dart < corners.size(); ++dart) {
    if (result.on_boundary[dart]) continue;
    const std::uint32_t other = opposite(triangles, dart);
    corners.join(dart, certify::next_dart(other));
    corners.join(certify::next_dart(dart), other);
  }
  std::vector<std::uint32_t> number(corners.size());
  for (std::uint32_t dart = 0; dart < corners.size(); ++dart) {
    const std::uint32_t first = corners.find(dart);
    if (first == dart) {
      number[dart] = static_cast<std::uint32_t>(result.points.size());
      result.points.push_back(
          {lifts.lifted[lifts.place[dart / 3]].corner[dart % 3], triangles[dart / 3].vertex[dart % 3]});
    }
    number[dart] = number[first];
  }
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    result.triangles.push_back(
        {number[std::size_t{3} * t], number[std::size_t{3} * t + 1], number[std::size_t{3} * t + 2]});
  result.sides = sides(triangles, result.on_boundary);
  return result;
}

}  // namespace epsnet
