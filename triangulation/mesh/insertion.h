#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/atlas.h"

namespace epsnet {

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
