#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Writes into a triangulation, for the algorithms of this folder: each step alone leaves it unsound. Keeps references;
/// with a journal what triangles were before is recorded there.
class Editor {
 public:
  explicit Editor(Triangulation& triangulation, Journal* journal = nullptr)
      : triangulation_(triangulation), journal_(journal) {}

  /// A triangulation to be filled.
  [[nodiscard]] static Triangulation without_triangles(Atlas atlas) { return Triangulation(std::move(atlas)); }

  [[nodiscard]] Atlas& atlas() const { return triangulation_.atlas_; }
  [[nodiscard]] Mesh& mesh() const { return triangulation_.mesh_; }
  [[nodiscard]] ById<VertexId, Complex<double>>& points() const { return triangulation_.mesh_.points; }
  [[nodiscard]] ById<VertexId, ChartId>& charts() const { return triangulation_.mesh_.charts; }
  [[nodiscard]] ById<TriangleId, Triangle>& triangles() const { return triangulation_.mesh_.triangles; }

  /// No triangulation has more triangles.
  static constexpr std::size_t kMostTriangles = kLargestTriangle.number();
  /// Throws LimitError if so many more triangles are more than there may be.
  void require_room(std::size_t triangles) const { require_room(triangulation_.triangle_count(), triangles); }
  /// The same for `count` triangles that are there.
  static void require_room(std::size_t count, std::size_t triangles);
  /// Adds a vertex that no triangle has yet.
  VertexId add_vertex(const Vertex& v) const {
    assert(v.chart.number() < triangulation_.atlas().charts().count() && norm(v.z) <= kChartRadius * kChartRadius);
    const VertexId id = points().end_id();
    points().push_back(v.z);
    charts().push_back(v.chart);
    return id;
  }
  /// Takes back the last add_vertex; no triangle may have the vertex.
  void pop_vertex() const {
    assert(!points().empty());
    points().pop_back();
    charts().pop_back();
  }
  TriangleId add_triangle() const {
    const TriangleId id = triangles().end_id();
    triangles().push_back({});
    return id;
  }
  /// Gives a triangle its corners, all in one chart of reference, and takes its mark; its opposite darts stay.
  void set(TriangleId t, Corner c0, Corner c1, Corner c2) const;
  /// Makes two darts opposite to each other.
  void link(Dart d, Dart e) const {
    assert(d != e);
    record(triangle_of(e));
    triangles()[triangle_of(d)].opposite[corner_of(d)] = e;
    triangles()[triangle_of(e)].opposite[corner_of(e)] = d;
  }

 private:
  void record(TriangleId t) const {
    if (journal_ != nullptr && t.number() < journal_->triangles) {
      journal_->overwritten.emplace_back(t, triangles()[t]);
    }
  }

  Triangulation& triangulation_;
  Journal* journal_;
};

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

/// The triangulation of these vertices and triangles, whose charts and labels are those of the atlas; nothing is
/// flipped or renumbered. Throws TriangulationError if it is not sound (`problem`). O(n).
[[nodiscard]] Triangulation assembled(Atlas atlas, std::span<const Vertex> vertices,
                                      std::span<const Triangle> triangles);

}  // namespace epsnet
