#pragma once

#include <cassert>
#include <cstdint>
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

}  // namespace epsnet
