#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// A region of triangles, lifted side by side, that is to be replaced by the fan from a new vertex to its boundary.
///
/// An object is memory to be used again and again: a row of insertions allocates nothing. What it says of one region
/// holds until the triangulation changes.
class Cavity {
 public:
  /// An edge of the boundary: its dart inside, the one outside, and its ends.
  struct Edge {
    Dart inner;
    Dart outer;
    Corner from;
    Corner to;
  };

  /// The region is one triangle; corners are lifted to its chart.
  void take_face(const Triangulation& triangulation, TriangleId t);
  /// The region is the two triangles beside d; corners are lifted to the chart of d's.
  void take_edge(Triangulation& triangulation, Dart d);
  /// The region is all triangles in conflict with p, lifted to the chart of t, of which t must be one (Bowyer–Watson).
  /// False if a lift of the region meets another one (few vertices, short loops). Requires a Delaunay triangulation.
  [[nodiscard]] bool find(Triangulation& triangulation, TriangleId t, Corner p);

  /// The boundary, counterclockwise.
  [[nodiscard]] std::span<const Edge> boundary() const { return boundary_; }

  /// Replaces the region by the fan from p to its boundary. Returns the triangles of the fan: p is their corner 0, dart
  /// 1 is opposite to it.
  std::span<const TriangleId> fill(Triangulation& triangulation, Corner p, Journal* journal);

 private:
  std::vector<TriangleId> triangles_;
  std::vector<Edge> boundary_;
  std::vector<Edge> pending_;
  std::vector<TriangleId> fan_;
};

}  // namespace epsnet
