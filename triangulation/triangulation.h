#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kernel/predicates.h"
#include "triangulation/atlas.h"
#include "triangulation/threshold.h"

namespace epsnet {

/// A dart 4t + i: the edge of triangle t from corner i to corner i + 1, directed.
using Dart = std::uint32_t;
[[nodiscard]] constexpr Dart make_dart(std::uint32_t triangle, std::uint32_t corner) { return 4 * triangle + corner; }
[[nodiscard]] constexpr std::uint32_t triangle_of(Dart d) { return d >> 2; }
[[nodiscard]] constexpr std::uint32_t corner_of(Dart d) { return d & 3; }
/// Corner i + 1 and i + 2 modulo 3.
[[nodiscard]] constexpr std::uint32_t next(std::uint32_t i) { return i == 2 ? 0 : i + 1; }
[[nodiscard]] constexpr std::uint32_t previous(std::uint32_t i) { return i == 0 ? 2 : i - 1; }
/// The next dart of the same triangle, and the one before.
[[nodiscard]] constexpr Dart next_dart(Dart d) { return make_dart(triangle_of(d), next(corner_of(d))); }
[[nodiscard]] constexpr Dart previous_dart(Dart d) { return make_dart(triangle_of(d), previous(corner_of(d))); }

/// A vertex: the point of the surface with coordinate z in a chart, |z| ≤ kChartRadius.
struct Vertex {
  Complex<double> z;
  std::uint32_t chart;
};

/// A triangle of the labelled triangulation (thesis I.4.1 and I.4.2 in one): vertices, darts across, and the labels
/// that lift corners 1 and 2 to the chart of corner 0. 32 bytes.
struct Triangle {
  std::array<std::uint32_t, 3> vertex;
  std::array<Dart, 3> opposite;
  std::uint64_t labels_and_mark;  ///< Label of corner 1 (24 bits), of corner 2 (24 bits), 15 zeros, the mark.

  [[nodiscard]] LabelId label(std::uint32_t corner) const {
    return corner == 0   ? kIdentity
           : corner == 1 ? static_cast<LabelId>(labels_and_mark >> 40)
                         : static_cast<LabelId>((labels_and_mark >> 16) & 0xffffff);
  }
  [[nodiscard]] bool all_identity() const { return (labels_and_mark >> 16) == 0; }
  /// Set by `mark` and lost when the slot gets another triangle: for algorithms that keep lists of triangles.
  [[nodiscard]] bool marked() const { return (labels_and_mark & 1) != 0; }
  bool operator==(const Triangle&) const = default;
};
static_assert(sizeof(Triangle) == 32);
/// The largest label that a triangle has room for.
inline constexpr LabelId kLargestLabel = (1u << 24) - 1;

/// A vertex lifted by a label to some chart of reference.
struct Corner {
  std::uint32_t vertex;
  LabelId label;
  bool operator==(const Corner&) const = default;
};

/// Where a point is (thesis IV.4.3).
struct Location {
  enum class Type { face, edge, vertex, not_found };  ///< not_found: not within the steps allowed.
  Type type;
  Dart dart;           ///< Of the triangle that contains the point; the edge, or the vertex it leaves, if it is on one.
  LabelId transition;  ///< From that triangle's chart to the chart in which the point was given.
  std::uint32_t steps;  ///< Triangles entered after the first one.
};

/// Everything an operation overwrote, so that it can be undone.
struct Journal {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::vector<std::pair<std::uint32_t, Triangle>> overwritten;
};

/// A point of a surface: of a tile, in its coordinates.
struct BasePoint {
  std::uint32_t tile;
  Complex<Rational> z;
};

/// A point strictly inside of a tile with few digits: near the mean of its vertices in the Klein model. Throws
/// SurfaceError if there is no such tile.
[[nodiscard]] BasePoint centre_of_tile(const Surface& surface, std::uint32_t tile);

/// The triangles that Triangulation::insert_locally made, and those of them that are large.
struct NewTriangles {
  static constexpr std::size_t kMost = 26;
  std::uint32_t count = 0;
  std::uint32_t large_count = 0;
  std::array<std::uint32_t, kMost> slots;
  std::array<std::uint32_t, kMost> large_slots;
};

/// A geometric triangulation of a closed hyperbolic surface by geodesic triangles, in local coordinates.
///
/// A combinatorial map whose triangle corners carry isometries. One vertex, loops, multiple edges and triangles that
/// share several edges are normal. Not copied by accident: `clone` does that.
class Triangulation {
 public:
  /// The tiles of the surface cut into triangles; the vertices are the vertex classes of the tiles, exactly. With a
  /// base point, strictly inside of a tile, that is vertex 0, the corners of its tile are joined to it, and the vertex
  /// classes follow. A regular surface has one vertex, its centre, and Delaunay triangles, unless there is another base
  /// point; then the place of its vertex class is taken by a point nearer to it than 2^-250. Throws SurfaceError for a
  /// base point that is not inside of its tile.
  explicit Triangulation(const Surface& surface, const std::optional<BasePoint>& base = std::nullopt);
  Triangulation(Triangulation&&) = default;
  Triangulation& operator=(Triangulation&&) = default;
  [[nodiscard]] Triangulation clone() const { return *this; }

  [[nodiscard]] const Surface& surface() const { return atlas_.surface(); }
  [[nodiscard]] Atlas& atlas() { return atlas_; }
  [[nodiscard]] const Atlas& atlas() const { return atlas_; }
  [[nodiscard]] std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(points_.size()); }
  [[nodiscard]] std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangles_.size()); }
  [[nodiscard]] Vertex vertex(std::uint32_t v) const { return {points_[v], charts_[v]}; }
  [[nodiscard]] const Triangle& triangle(std::uint32_t t) const { return triangles_[t]; }
  [[nodiscard]] Dart opposite(Dart d) const { return triangles_[triangle_of(d)].opposite[corner_of(d)]; }
  [[nodiscard]] Corner corner(std::uint32_t t, std::uint32_t i) const {
    return {triangles_[t].vertex[i], triangles_[t].label(i)};
  }
  /// The chart of a triangle: that of its corner 0.
  [[nodiscard]] std::uint32_t chart_of(std::uint32_t t) const { return charts_[triangles_[t].vertex[0]]; }
  /// The label from the chart of the triangle across d to the chart of the triangle of d that puts their lifts side by
  /// side.
  [[nodiscard]] LabelId transition(Dart d);
  /// Predicates that binary64 could not decide so far.
  [[nodiscard]] std::uint64_t multiprecision_count() const { return multiprecision_; }

  // Predicates on lifted vertices, all corners in the same chart of reference. Staged: binary64, then 256, 1024, 4096
  // bits; beyond that a tie, 0.

  /// 1 if d is strictly inside the circle through a, b, c (counterclockwise), −1 if strictly outside.
  [[nodiscard]] int in_circle(Corner a, Corner b, Corner c, Corner d);
  /// 1 if c is strictly to the left of the geodesic from a to b.
  [[nodiscard]] int orientation(Corner a, Corner b, Corner c);
  /// True if the edge is locally Delaunay (thesis Theorem I.42); ties are.
  [[nodiscard]] bool is_delaunay(Dart d);
  /// 1 if the hyperbolic circumradius R of triangle t certainly has sinh²R > s, −1 if certainly less; s is known
  /// between two binary64 bounds and as exactly as is needed.
  [[nodiscard]] int compare_circumradius(std::uint32_t t, const Threshold& s) {
    const Triangle& triangle = triangles_[t];
    if (triangle.all_identity()) {
      const StageSign sign = circumradius_stage_near_origin(points_[triangle.vertex[0]], points_[triangle.vertex[1]],
                                                            points_[triangle.vertex[2]], s.high());
      if (sign.certain) {
        return sign.sign;
      }
    }
    return compare_circumradius_staged(t, s);
  }
  /// 1 if the hyperbolic distance d of two lifted vertices certainly has sinh²(d/2) > s, −1 if certainly less.
  [[nodiscard]] int compare_distance(Corner a, Corner b, const Threshold& s) {
    if ((a.label | b.label) == kIdentity) {
      const StageSign sign = distance_stage_near_origin(points_[a.vertex], points_[b.vertex], s.high());
      if (sign.certain) {
        return sign.sign;
      }
    }
    return compare_distance_staged(a, b, s);
  }
  /// The circumcentre of triangle t in its chart, in binary64 where that is accurate enough to be inside of the circle.
  [[nodiscard]] std::optional<Complex<double>> circumcentre_fast(std::uint32_t t) const;
  /// The same from lifts in T (Mp256, Mp1024), if there is one.
  template <class T>
  [[nodiscard]] std::optional<Complex<Mp1024>> circumcentre_precise(std::uint32_t t);

  /// Sets and takes back the mark of a triangle (`Triangle::marked`).
  void mark(std::uint32_t t) { triangles_[t].labels_and_mark |= 1; }
  void unmark(std::uint32_t t) { triangles_[t].labels_and_mark &= ~std::uint64_t{1}; }

  // Asks the memory for what an insertion at triangle t is going to touch, one step of indirection after the other.
  void prefetch_triangle(std::uint32_t t) const { __builtin_prefetch(&triangles_[t]); }
  void prefetch_neighbours(std::uint32_t t) const {
    const Triangle& triangle = triangles_[t];
    for (std::uint32_t i = 0; i < 3; ++i) {
      __builtin_prefetch(&points_[triangle.vertex[i]]);
      __builtin_prefetch(&triangles_[triangle_of(triangle.opposite[i])]);
    }
  }
  void prefetch_second_neighbours(std::uint32_t t) const {
    for (const Dart d : triangles_[t].opposite) {
      const Triangle& neighbour = triangles_[triangle_of(d)];
      const std::uint32_t i = corner_of(d);
      __builtin_prefetch(&points_[neighbour.vertex[previous(i)]]);
      __builtin_prefetch(&triangles_[triangle_of(neighbour.opposite[next(i)])]);
      __builtin_prefetch(&triangles_[triangle_of(neighbour.opposite[previous(i)])]);
    }
  }

  /// Replaces the edge of d by the other diagonal of the two triangles beside it, and returns a dart of the new edge.
  /// The two triangles may share more edges. Requires their lifts side by side to make a strictly convex quadrilateral;
  /// an edge that is not Delaunay does (thesis Theorem I.31).
  Dart flip(Dart d, Journal* journal = nullptr);
  /// Flips until every edge is locally Delaunay (thesis Theorem I.32), starting from the given darts; returns the
  /// number of flips. Many flips around one short closed curve are made at once, and count as one.
  std::uint64_t restore_delaunay(std::vector<Dart>& pending, Journal* journal = nullptr);
  /// The same from all edges.
  std::uint64_t make_delaunay();

  /// Adds a vertex that no triangle has yet.
  std::uint32_t add_vertex(const Vertex& v) {
    points_.push_back(v.z);
    charts_.push_back(v.chart);
    return vertex_count() - 1;
  }
  /// Takes back the last add_vertex; no triangle may have the vertex.
  void pop_vertex() {
    points_.pop_back();
    charts_.pop_back();
  }
  /// Splits triangle t into three at a vertex in its interior. `label` leads from the vertex' chart to t's chart.
  void split_face(std::uint32_t t, std::uint32_t vertex, LabelId label, Journal* journal = nullptr);
  /// Splits the edge of d, and the two triangles beside it, at a vertex in its interior. `label` leads from the vertex'
  /// chart to the chart of d's triangle.
  void split_edge(Dart d, std::uint32_t vertex, LabelId label, Journal* journal = nullptr);

  /// Makes `vertex` (added, in no triangle) a vertex of the Delaunay triangulation by Bowyer–Watson, starting at
  /// triangle t, which must be in conflict with it. `label` leads from the vertex' chart to t's chart. False, with
  /// nothing changed, if the cavity meets a lift of itself (few vertices, short loops), or `accept(corners of the
  /// link)` says no. Requires a Delaunay triangulation.
  template <class Accept>
  [[nodiscard]] bool insert_in_cavity(std::uint32_t t, std::uint32_t vertex, LabelId label, const Accept& accept,
                                      Journal* journal = nullptr);
  /// insert_in_cavity for a new vertex at the point p of t's chart, where binary64 decides everything: the way of
  /// nearly all insertions, with every coordinate loaded once. False, with nothing changed, if a predicate is unsure,
  /// if a triangle is met twice, or if p is not certainly at a distance d with sinh²(d/2) > apart from all other
  /// vertices. Triangles with sinh²R > large are marked.
  [[nodiscard]] bool insert_locally(std::uint32_t t, const Complex<double>& p, const Threshold& apart,
                                    const Threshold& large, NewTriangles& made);
  /// The triangles around the vertex that the last insert_in_cavity, split_face or split_edge inserted: it is their
  /// corner 0, dart 1 is opposite to it.
  [[nodiscard]] const std::vector<std::uint32_t>& new_triangles() const { return new_triangles_; }

  /// Where vertex p (lifted by `label` to the chart of triangle `start`) lies. The visibility walk (thesis Theorem
  /// II.1) terminates in a Delaunay triangulation.
  [[nodiscard]] Location locate_visibility(std::uint32_t start, Corner p, std::uint32_t most_steps = ~0u);
  /// The same by the straight walk from a corner of `start` (thesis Chapter II); terminates in every triangulation.
  [[nodiscard]] Location locate_straight(std::uint32_t start, Corner p, std::uint32_t most_steps = ~0u);

  /// The darts that leave the start vertex of d, d first, clockwise.
  [[nodiscard]] std::vector<Dart> star(Dart d) const;
  /// The label from the chart of the vertex at the end of d to the chart of the one at its start that puts the end's
  /// lift at the other end of d.
  [[nodiscard]] LabelId label_along(Dart d);
  /// Moves the start vertex of d along d into its end, which it becomes; vertices and triangles are renumbered: the
  /// last ones take the numbers of those that vanish. Returns a dart that leaves the merged vertex; nothing, with
  /// nothing changed, if the two are one vertex or if some triangle would not stay counterclockwise. (What is left is
  /// again a triangulation: labels fit, triangles are counterclockwise and V − E + F is the same.) O(n).
  [[nodiscard]] std::optional<Dart> contract(Dart d);
  /// Moves the start vertex of d to a place, given by its label to that vertex' chart. False, with nothing changed, if
  /// some triangle would not stay counterclockwise. O(n).
  [[nodiscard]] bool move_vertex(Dart d, const Atlas::Place& place);

  /// Starts to record for `undo`.
  [[nodiscard]] Journal open_journal() const { return {points_.size(), triangles_.size(), {}}; }
  /// Takes back everything since the journal was opened; vertices, triangles and their order are as they were.
  void undo(const Journal& journal);

  /// Empty if the triangulation is sound: opposite is an involution that matches vertices and lifts, triangles are
  /// counterclockwise, V − E + F = 2 − 2g. Otherwise what is wrong first. O(n), in exact or staged arithmetic.
  [[nodiscard]] std::string problem();

  void reserve(std::size_t vertices);

 private:
  Triangulation(const Triangulation&) = default;

  /// Where the two triangles beside d make an annulus around a short closed curve and the edges across turn around it
  /// many times more than a Delaunay triangulation lets them: undoes all of these turns, which would take as many
  /// flips. False, with nothing changed, elsewhere. The darts stay where they are.
  [[nodiscard]] bool untwist(Dart d, Journal* journal);
  void cut_tiles(const std::optional<BasePoint>& base);
  void cut_regular();
  /// Makes the vertex classes vertices, from number `first_class` on, each the origin of a chart of its first corner.
  /// Returns the words from the tiles of these first corners to the tiles of all corners of the class, by corner.
  [[nodiscard]] std::vector<Word> add_vertex_classes(std::uint32_t first_class);
  /// Cuts a polygon with these corners into triangles: around a vertex inside of it, or again and again into halves, by
  /// diagonals, so that few triangles have corners far apart. Returns the darts of its sides, from corner k to k + 1.
  [[nodiscard]] std::vector<Dart> cut_around(Corner centre, const std::vector<Corner>& corners);
  [[nodiscard]] std::vector<Dart> cut_by_halves(const std::vector<Corner>& corners);
  /// The same for n corners; `set_corners(t, i, m, j)` sets those of triangle t to the polygon's, i < m < j.
  template <class SetCorners>
  [[nodiscard]] std::vector<Dart> cut_by_halves(std::uint32_t n, const SetCorners& set_corners);
  /// Glues the triangles along the sides of the tiles; the darts by side number.
  void glue_sides(const std::vector<Dart>& dart_of_side);

  /// An edge of the boundary of a region of triangles: its dart inside and the one outside, before the region is filled
  /// anew.
  struct BoundaryEdge {
    Dart inner;
    Dart outer;
    Corner from;
    Corner to;
  };

  /// A lift in binary64 and how far it may be from the true point.
  struct Lift {
    Complex<double> z;
    double error;
  };
  [[nodiscard]] Lift lift(Corner c) const {
    const Complex<double>& z = points_[c.vertex];
    return c.label == kIdentity ? Lift{z, 0} : Lift{atlas_.isometry(c.label)(z), atlas_.error(c.label)};
  }
  [[nodiscard]] int compare_circumradius_staged(std::uint32_t t, const Threshold& s);
  [[nodiscard]] int compare_distance_staged(Corner a, Corner b, const Threshold& s);
  /// Runs the stages of a predicate on the corners: `stage` takes the lifted points and the bound on their error.
  template <std::size_t N, class Stage>
  [[nodiscard]] int staged(const std::array<Corner, N>& corners, const Stage& stage);
  template <class T, std::size_t N, class Stage>
  [[nodiscard]] StageSign multiprecision_stage(const std::array<Corner, N>& corners, const Stage& stage);
  void set(std::uint32_t t, Corner c0, Corner c1, Corner c2, Journal* journal);
  void record(std::uint32_t t, Journal* journal) const;
  void link(Dart d, Dart e, Journal* journal);
  /// Throws if so many more triangles are more than there may be.
  void require_room(std::size_t triangles) const;
  std::uint32_t add_triangle() {
    triangles_.push_back({});
    return triangle_count() - 1;
  }
  /// Labels of the corners 1 and 2, with no mark.
  [[nodiscard]] static std::uint64_t packed(LabelId l1, LabelId l2) {
    return (std::uint64_t{l1} << 40) | (std::uint64_t{l2} << 16);
  }
  [[nodiscard]] Corner moved(LabelId by, Corner c) { return {c.vertex, atlas_.product(by, c.label)}; }
  [[nodiscard]] bool find_cavity(std::uint32_t t, Corner p);
  /// How the triangle of dart e is lifted if the ends of e are: the label from its chart. `from` is the lift of the end
  /// of e, `to` that of its start.
  [[nodiscard]] LabelId lift_across(LabelId from, LabelId to, Dart e) {
    // One end tells, as it is lifted and as the triangle sees it; best if the triangle sees it as its corner 0.
    const std::uint32_t j = corner_of(e);
    if (j == 0) {
      return to;
    }
    const LabelId seen = triangles_[triangle_of(e)].label(next(j));
    return seen == kIdentity ? from : atlas_.product(from, atlas_.inverse(seen));
  }
  /// The corners of a triangle with `vertex` replaced, wherever it is one; the replacement is given in the chart of
  /// `vertex`.
  [[nodiscard]] std::array<Corner, 3> corners_with(std::uint32_t t, std::uint32_t vertex, Corner replacement);
  /// Replaces the vertex of a star in all of its triangles but two; false, with nothing changed, if one of them would
  /// not be counterclockwise.
  [[nodiscard]] bool replace_vertex(const std::vector<Dart>& star, Corner replacement,
                                    const std::array<std::uint32_t, 2>& except);
  /// The last vertex, or triangle, takes the number of the one removed.
  void remove_vertex(std::uint32_t v);
  void remove_triangle(std::uint32_t t);
  /// Replaces the triangles of cavity_ by the fan from a vertex to boundary_.
  void fill_cavity(Corner p, Journal* journal);
  enum class Outcome { inserted, labels_met, undecided };
  /// insert_locally; without `kLabels` as far as all labels are the identity.
  template <bool kLabels>
  [[nodiscard]] Outcome insert_locally_with(std::uint32_t t, const Complex<double>& p, const Threshold& apart,
                                            const Threshold& large, NewTriangles& made);
  [[nodiscard]] Location classify(Dart d, LabelId transition, Corner p, std::uint32_t steps);

  Atlas atlas_;
  // The vertices, coordinates and charts apart: the predicates of nearly all triangles need the coordinates alone.
  std::vector<Complex<double>> points_;
  std::vector<std::uint32_t> charts_;
  std::vector<Triangle> triangles_;
  std::uint64_t multiprecision_ = 0;

  // Scratch of insert_in_cavity, kept to allocate nothing per insertion.
  std::vector<std::uint32_t> cavity_;
  std::vector<BoundaryEdge> boundary_;
  std::vector<BoundaryEdge> pending_;
  std::vector<std::uint32_t> new_triangles_;
};

template <class Accept>
bool Triangulation::insert_in_cavity(std::uint32_t t, std::uint32_t vertex, LabelId label, const Accept& accept,
                                     Journal* journal) {
  if (!find_cavity(t, {vertex, label})) {
    return false;
  }
  for (const BoundaryEdge& e : boundary_) {
    if (!accept(e.from)) {
      return false;
    }
  }
  fill_cavity({vertex, label}, journal);
  return true;
}

}  // namespace epsnet
