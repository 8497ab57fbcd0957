#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "kernel/predicates.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/atlas.h"

namespace epsnet {

// What binary64 does not see to be false: for assertions, as nothing is evaluated, counted or kept.

/// False if c is certainly to the right of the geodesic from a to b.
[[nodiscard]] inline bool may_be_left(const Triangulation& triangulation, Corner a, Corner b, Corner c) {
  const Triangulation::Lift p = triangulation.lift(a);
  const Triangulation::Lift q = triangulation.lift(b);
  const Triangulation::Lift r = triangulation.lift(c);
  const StageSign sign = orientation_stage<double>(p.z, q.z, r.z, std::max({p.error, q.error, r.error}));
  return !sign.certain || sign.sign > 0;
}

/// False if p is certainly outside of the circle through the corners of a triangle, in whose chart it is.
[[nodiscard]] inline bool may_be_in_circle(const Triangulation& triangulation, TriangleId t, Corner p) {
  const Triangulation::Lift a = triangulation.lift(triangulation.corner(t, 0));
  const Triangulation::Lift b = triangulation.lift(triangulation.corner(t, 1));
  const Triangulation::Lift c = triangulation.lift(triangulation.corner(t, 2));
  const Triangulation::Lift d = triangulation.lift(p);
  const StageSign sign = in_circle_stage<double>(a.z, b.z, c.z, d.z, std::max({a.error, b.error, c.error, d.error}));
  return !sign.certain || sign.sign > 0;
}

// What the refinement alone needs of a triangulation: marks of triangles, and memory that is asked for early.

/// Sets and takes back the mark of a triangle (`Triangle::marked`).
inline void mark(Triangulation& triangulation, TriangleId t) {
  Editor(triangulation).triangles()[t].labels_and_mark |= 1;
}
inline void unmark(Triangulation& triangulation, TriangleId t) {
  Editor(triangulation).triangles()[t].labels_and_mark &= ~std::uint64_t{1};
}

// Asks the memory for what an insertion at triangle t is going to touch, one step of indirection after the other.
inline void prefetch_triangle(const Triangulation& triangulation, TriangleId t) {
  __builtin_prefetch(&triangulation.triangle(t));
}
inline void prefetch_neighbours(const Triangulation& triangulation, TriangleId t) {
  const Triangle& triangle = triangulation.triangle(t);
  for (std::uint32_t i = 0; i < 3; ++i) {
    __builtin_prefetch(&triangulation.point(triangle.vertex[i]));
    __builtin_prefetch(&triangulation.triangle(triangle_of(triangle.opposite[i])));
  }
}
inline void prefetch_second_neighbours(const Triangulation& triangulation, TriangleId t) {
  for (const Dart d : triangulation.triangle(t).opposite) {
    const Triangle& neighbour = triangulation.triangle(triangle_of(d));
    const std::uint32_t i = corner_of(d);
    __builtin_prefetch(&triangulation.point(neighbour.vertex[previous(i)]));
    __builtin_prefetch(&triangulation.triangle(triangle_of(neighbour.opposite[next(i)])));
    __builtin_prefetch(&triangulation.triangle(triangle_of(neighbour.opposite[previous(i)])));
  }
}

// Insertions.

/// Returns the circumcentre of triangle t in its chart, in binary64; nullopt if binary64 cannot place it inside the
/// circle.
[[nodiscard]] std::optional<Complex<double>> circumcentre_fast(const Mesh& mesh, const Atlas& atlas, TriangleId t);

/// Returns a point of t's chart as a vertex, in whichever corner chart has the nearest origin. So charts meet along
/// lines instead of mixing, and only triangles beside these lines have labels.
[[nodiscard]] LiftedPoint in_nearest_chart(const Mesh& mesh, const Atlas& atlas, TriangleId t,
                                           const Complex<double>& z);

/// The circumcentre of t from lifts in T (Mp256, Mp1024), if there is one.
template <class T>
[[nodiscard]] std::optional<Complex<Mp1024>> circumcentre_precise(Triangulation& triangulation, TriangleId t);

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

/// The triangles that insert_locally made; those known to be large, and those that binary64 cannot classify.
struct NewTriangles {
  static constexpr std::size_t kMost = 26;
  std::uint32_t count = 0;
  std::uint32_t large_count = 0;
  std::uint32_t unsure_count = 0;
  std::array<TriangleId, kMost> slots;
  std::array<TriangleId, kMost> large_slots;
  std::array<TriangleId, kMost> unsure_slots;
};

/// In a mesh that is a part of a triangulation: the dart across from every edge of its boundary.
inline constexpr Dart kOutside = make_dart(kLargestTriangle, 0);

/// Bowyer–Watson for a new vertex in triangle t's circle, whose label leads to t's chart, where binary64 decides
/// everything: the way of nearly all insertions of a refinement, with every coordinate loaded once and nothing
/// allocated but the new vertex and triangles. False, with nothing changed, if a predicate is unsure, if a triangle is
/// met twice, if a label is not known, if it is not certainly at a distance d with sinh²(d/2) > apart from all other
/// vertices, or if the mesh is a part and the cavity reaches to its boundary. `made` is memory of the caller. Triangles
/// with sinh²R > large are marked. Reads nothing but the mesh, `labels` and its atlas, and the binary64 ends of the
/// thresholds.
[[nodiscard]] bool insert_locally(Mesh& mesh, KnownLabels& labels, TriangleId t, const LiftedPoint& point,
                                  const Threshold& apart, const Threshold& large, NewTriangles& made);

}  // namespace epsnet
