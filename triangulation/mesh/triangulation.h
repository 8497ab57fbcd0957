#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/predicates.h"
#include "triangulation/surface/atlas.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// Encloses the number sinh²x for an exact x > 0, with which circumradii (x = ε) and distances (x = ε/2) are compared.
/// There is an enclosure, lower end first, for each stage of the predicates; it is computed on first use. MPFR rounds
/// the ends correctly, so they are the same on every machine.
class Threshold {
 public:
  /// Encloses sinh²x. Requires: x > 0.
  explicit Threshold(Rational x);

  /// The ends in T: double, Mp256, Mp1024, Mp4096.
  template <class T>
  [[nodiscard]] const std::array<T, 2>& at() const;
  /// The lower end at the binary64 stage.
  [[nodiscard]] double low() const { return ends_[0]; }
  /// The upper end at the binary64 stage.
  [[nodiscard]] double high() const { return ends_[1]; }

 private:
  Rational x_;
  std::array<double, 2> ends_;
  mutable std::optional<std::array<Mp256, 2>> at_256_;
  mutable std::optional<std::array<Mp1024, 2>> at_1024_;
  mutable std::optional<std::array<Mp4096, 2>> at_4096_;
};

/// A dart: the edge of triangle t from corner i to corner i + 1, directed.
///
/// It is a distinct type because files number darts differently (docs/format.md). `document_dart` and
/// `triangulation_dart` (netgen/nets/triangulations.h) convert between the two.
enum class Dart : std::uint32_t {};

/// The largest number of a triangle that a dart has room for.
inline constexpr TriangleId kLargestTriangle{(1U << 30) - 1};

/// Dart i of a triangle, i < 3.
[[nodiscard]] constexpr Dart make_dart(TriangleId triangle, std::uint32_t corner) {
  assert(triangle <= kLargestTriangle && corner < 3);
  return Dart{4 * triangle.number() + corner};
}
/// The triangle of a dart.
[[nodiscard]] constexpr TriangleId triangle_of(Dart d) { return TriangleId(static_cast<std::uint32_t>(d) >> 2); }
/// The corner of its triangle at which it starts.
[[nodiscard]] constexpr std::uint32_t corner_of(Dart d) {
  const std::uint32_t corner = static_cast<std::uint32_t>(d) & 3;
  assert(corner < 3);
  return corner;
}
/// Corner i + 1 modulo 3.
[[nodiscard]] constexpr std::uint32_t next(std::uint32_t i) {
  assert(i < 3);
  return i == 2 ? 0 : i + 1;
}
/// Corner i + 2 modulo 3.
[[nodiscard]] constexpr std::uint32_t previous(std::uint32_t i) {
  assert(i < 3);
  return i == 0 ? 2 : i - 1;
}
/// The next dart of the same triangle.
[[nodiscard]] constexpr Dart next_dart(Dart d) { return make_dart(triangle_of(d), next(corner_of(d))); }
/// The dart before it in the same triangle.
[[nodiscard]] constexpr Dart previous_dart(Dart d) { return make_dart(triangle_of(d), previous(corner_of(d))); }

/// A vertex: the point of the surface with coordinate z in a chart, |z| ≤ kChartRadius.
struct Vertex {
  Complex<double> z;
  ChartId chart;
};

/// The largest label that a triangle has room for.
inline constexpr LabelId kLargestLabel = (1u << 24) - 1;

/// A triangle of the labelled triangulation (thesis I.4.1 and I.4.2 in one): vertices, darts across, and the labels
/// that lift corners 1 and 2 to the chart of corner 0. 32 bytes.
struct Triangle {
  std::array<VertexId, 3> vertex;
  std::array<Dart, 3> opposite;
  std::uint64_t labels_and_mark;  ///< Label of corner 1 (24 bits), of corner 2 (24 bits), 15 zeros, the mark.

  /// The label of a corner; the identity for corner 0.
  [[nodiscard]] LabelId label(std::uint32_t corner) const {
    assert(corner < 3);
    return corner == 0   ? kIdentity
           : corner == 1 ? static_cast<LabelId>(labels_and_mark >> 40)
                         : static_cast<LabelId>((labels_and_mark >> 16) & 0xffffff);
  }
  /// The labels of corners 1 and 2 as `labels_and_mark`, with no mark.
  [[nodiscard]] static constexpr std::uint64_t packed(LabelId l1, LabelId l2) {
    assert(l1 <= kLargestLabel && l2 <= kLargestLabel);
    return (std::uint64_t{l1} << 40) | (std::uint64_t{l2} << 16);
  }
  /// Whether all corners are given in the chart of the triangle.
  [[nodiscard]] bool all_identity() const { return (labels_and_mark >> 16) == 0; }
  /// Whether the triangle is marked. The mark is lost when another triangle takes the slot; algorithms that keep lists
  /// of triangles use it.
  [[nodiscard]] bool marked() const { return (labels_and_mark & 1) != 0; }
  bool operator==(const Triangle&) const = default;
};
static_assert(sizeof(Triangle) == 32);

/// The vertices and triangles of a triangulation, or of a part of one. Coordinates and charts are separate arrays, as
/// the predicates of nearly all triangles need only the coordinates.
struct Mesh {
  ById<VertexId, Complex<double>> points;
  ById<VertexId, ChartId> charts;
  ById<TriangleId, Triangle> triangles;
};

/// A vertex lifted by a label to some chart of reference.
struct Corner {
  VertexId vertex;
  LabelId label;
  bool operator==(const Corner&) const = default;
};

/// A geometric triangulation of a closed hyperbolic surface by geodesic triangles, in local coordinates.
///
/// A combinatorial map whose triangle corners carry isometries. One vertex, loops, multiple edges and triangles that
/// share several edges are normal. Copied only by `clone`.
///
/// The class has the data, the darts and the predicates; `locate` (operations.h) searches a triangulation. The
/// functions that change one serve the refinement of nets (docs/design.md). Most predicates may add labels to the
/// atlas, so they are not const.
class Triangulation {
 public:
  /// Cuts the tiles of the surface into triangles; the vertices are the vertex classes of the tiles, exactly. With a
  /// base point, which is strictly inside a tile, vertex 0 is the base point, the corners of its tile are joined to it,
  /// and the vertex classes follow. A regular surface without a base point has one vertex, its centre, and Delaunay
  /// triangles. With another base point, the vertex class of a regular surface is replaced by a point nearer to it than
  /// 2^-250. Throws SurfaceError for a base point that is not strictly inside its tile, LimitError.
  explicit Triangulation(const Surface& surface, const std::optional<BasePoint>& base = std::nullopt);
  Triangulation(Triangulation&&) = default;
  Triangulation& operator=(Triangulation&&) = default;
  ~Triangulation() = default;
  /// A copy.
  [[nodiscard]] Triangulation clone() const { return *this; }
  /// Reserves memory for this many vertices and their triangles.
  void reserve(std::size_t vertices);

  /// The surface that is triangulated.
  [[nodiscard]] const Surface& surface() const { return atlas_.surface(); }
  /// Vertices and triangles.
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  /// The charts of the vertices and the labels of the corners.
  [[nodiscard]] const Atlas& atlas() const { return atlas_; }
  /// Returns the number of vertices.
  [[nodiscard]] std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(mesh_.points.size()); }
  /// Returns the number of triangles.
  [[nodiscard]] std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(mesh_.triangles.size()); }
  /// The numbers of all vertices.
  [[nodiscard]] Ids<VertexId> vertices() const { return mesh_.points.ids(); }
  /// The numbers of all triangles.
  [[nodiscard]] Ids<TriangleId> triangles() const { return mesh_.triangles.ids(); }
  /// Returns vertex v.
  [[nodiscard]] Vertex vertex(VertexId v) const {
    assert(v.number() < vertex_count());
    return {mesh_.points[v], mesh_.charts[v]};
  }
  /// The coordinate of a vertex in its chart.
  [[nodiscard]] const Complex<double>& point(VertexId v) const {
    assert(v.number() < vertex_count());
    return mesh_.points[v];
  }
  /// Returns triangle t.
  [[nodiscard]] const Triangle& triangle(TriangleId t) const {
    assert(t.number() < triangle_count());
    return mesh_.triangles[t];
  }
  /// The chart of a triangle: that of its corner 0.
  [[nodiscard]] ChartId chart_of(TriangleId t) const { return mesh_.charts[triangle(t).vertex[0]]; }
  /// Corner i of triangle t, lifted to the chart of t.
  [[nodiscard]] Corner corner(TriangleId t, std::uint32_t i) const {
    assert(i < 3);
    return {triangle(t).vertex[i], triangle(t).label(i)};
  }

  /// Returns the opposite dart: the same edge in the other direction, a dart of the adjacent triangle.
  [[nodiscard]] Dart opposite(Dart d) const { return triangle(triangle_of(d)).opposite[corner_of(d)]; }
  /// The corner from which d leaves, lifted to the chart of its triangle.
  [[nodiscard]] Corner corner(Dart d) const { return corner(triangle_of(d), corner_of(d)); }
  /// The darts that leave the start vertex of d, d first, clockwise.
  [[nodiscard]] std::vector<Dart> star(Dart d) const;
  /// Returns the corner with its label replaced by `by` ∘ label.
  [[nodiscard]] Corner moved(LabelId by, Corner c) { return {c.vertex, atlas_.product(by, c.label)}; }
  /// Returns the label that puts the two triangles beside d side by side: from the chart of the triangle across d to
  /// the chart of the triangle of d.
  [[nodiscard]] LabelId transition(Dart d);
  /// Returns the label from the chart of the end vertex of d to the chart of its start vertex. It takes the end vertex
  /// to its lift at the end of d.
  [[nodiscard]] LabelId label_along(Dart d);
  /// Returns the label that lifts the triangle of dart e next to an edge whose ends are lifted already. `from` is the
  /// lift of the end of e, `to` the lift of its start.
  [[nodiscard]] LabelId lift_across(LabelId from, LabelId to, Dart e) {
    // One end tells, as it is lifted and as the triangle sees it; best if the triangle sees it as its corner 0.
    const std::uint32_t j = corner_of(e);
    if (j == 0) {
      return to;
    }
    const LabelId seen = triangle(triangle_of(e)).label(next(j));
    return seen == kIdentity ? from : atlas_.product(from, atlas_.inverse(seen));
  }

  /// A lift in binary64, and a bound of its distance from the true point.
  struct Lift {
    Complex<double> z;  ///< In the chart of reference.
    double error;       ///< Euclidean.
  };
  /// Returns a lifted vertex in binary64.
  [[nodiscard]] Lift lift(Corner c) const {
    const Complex<double>& z = point(c.vertex);
    return c.label == kIdentity ? Lift{z, 0} : Lift{atlas_.isometry(c.label)(z), atlas_.error(c.label)};
  }

  // Labels and lifts beyond binary64. As the predicates, these may add charts and labels to the atlas; those that there
  // are stay as they are.

  /// As Atlas::product.
  [[nodiscard]] LabelId product(LabelId f, LabelId g) { return atlas_.product(f, g); }
  /// As Atlas::inverse.
  [[nodiscard]] LabelId inverse(LabelId f) { return atlas_.inverse(f); }
  /// As Atlas::isometry_in.
  template <class T>
  [[nodiscard]] const Isometry<T>& isometry_in(LabelId l) {
    return atlas_.isometry_in<T>(l);
  }
  /// Returns a lifted vertex, to within `Atlas::lift_error<T>()`.
  template <class T>
  [[nodiscard]] Complex<T> lift_in(Corner c) {
    return atlas_.lift<T>(c.label, point(c.vertex));
  }
  /// As Atlas::lifted_point.
  [[nodiscard]] std::optional<LiftedPoint> lifted_point(ChartId chart, const Complex<Mp1024>& z,
                                                        Atlas::Precision precision) {
    return atlas_.lifted_point(chart, z, precision);
  }
  /// Returns a point in its closed tile as the origin of a chart of its own, lifted to the chart of triangle t. Throws
  /// LimitError if the path there leads too far.
  [[nodiscard]] LiftedPoint lifted_point(const BasePoint& point, TriangleId t);

  // Predicates on lifted vertices, all corners in the same chart of reference. Staged: binary64, then 256, 1024, 4096
  // bits; beyond that a tie, 0.

  /// Returns 1 if d is strictly inside the circle through a, b, c (counterclockwise), −1 if strictly outside, 0 for a
  /// tie.
  [[nodiscard]] int in_circle(Corner a, Corner b, Corner c, Corner d);
  /// Returns 1 if c is strictly to the left of the geodesic from a to b, −1 if strictly to the right, 0 for a tie.
  [[nodiscard]] int orientation(Corner a, Corner b, Corner c);
  /// Returns whether the edge is locally Delaunay (thesis Theorem I.42). A tie counts as Delaunay.
  [[nodiscard]] bool is_delaunay(Dart d);
  /// Returns 1 if the hyperbolic circumradius R of triangle t certainly has sinh²R > s, −1 if certainly sinh²R < s, 0
  /// for a tie.
  [[nodiscard]] int compare_circumradius(TriangleId t, const Threshold& s) {
    const Triangle& triangle = mesh_.triangles[t];
    if (triangle.all_identity()) {
      const StageSign sign =
          circumradius_stage_near_origin(mesh_.points[triangle.vertex[0]], mesh_.points[triangle.vertex[1]],
                                         mesh_.points[triangle.vertex[2]], s.high());
      if (sign.certain) {
        return sign.sign;
      }
    }
    return compare_circumradius_staged(t, s);
  }
  /// Returns 1 if the hyperbolic distance d of two lifted vertices certainly has sinh²(d/2) > s, −1 if certainly
  /// sinh²(d/2) < s, 0 for a tie.
  [[nodiscard]] int compare_distance(Corner a, Corner b, const Threshold& s) {
    if ((a.label | b.label) == kIdentity) {
      const StageSign sign = distance_stage_near_origin(point(a.vertex), point(b.vertex), s.high());
      if (sign.certain) {
        return sign.sign;
      }
    }
    return compare_distance_staged(a, b, s);
  }
  /// Returns the number of predicates so far that binary64 could not decide.
  [[nodiscard]] std::uint64_t multiprecision_count() const { return multiprecision_; }

 private:
  friend class Editor;

  /// No vertices and no triangles.
  explicit Triangulation(Atlas atlas) : atlas_(std::move(atlas)) {}
  Triangulation(const Triangulation&) = default;

  [[nodiscard]] int compare_circumradius_staged(TriangleId t, const Threshold& s);
  [[nodiscard]] int compare_distance_staged(Corner a, Corner b, const Threshold& s);
  /// Runs the stages of a predicate on the corners: `stage` takes the lifted points and the bound on their error.
  template <std::size_t N, class Stage>
  [[nodiscard]] int staged(const std::array<Corner, N>& corners, const Stage& stage);
  template <class T, std::size_t N, class Stage>
  [[nodiscard]] StageSign multiprecision_stage(const std::array<Corner, N>& corners, const Stage& stage);

  Atlas atlas_;
  Mesh mesh_;
  std::uint64_t multiprecision_ = 0;
};

// What writes into a triangulation: the journal of what it overwrites, and the editor.

/// Everything an operation overwrote, so that it can be undone.
struct Journal {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::vector<std::pair<TriangleId, Triangle>> overwritten;
};

/// Starts to record for `undo`.
[[nodiscard]] Journal open_journal(const Triangulation& triangulation);
/// Takes back everything since the journal was opened; vertices, triangles and their order are as they were.
void undo(Triangulation& triangulation, const Journal& journal);

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

/// The triangulation of these vertices and triangles, whose charts and labels are those of the atlas; nothing is
/// flipped or renumbered. Throws TriangulationError if it is not sound (`problem`). O(n).
[[nodiscard]] Triangulation assembled(Atlas atlas, std::span<const Vertex> vertices,
                                      std::span<const Triangle> triangles);

}  // namespace epsnet
