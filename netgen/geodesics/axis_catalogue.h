#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// A way through the triangulation from a vertex to a lift of the same vertex, which names an element of the group: the
/// one that takes the vertex's lift at the start to the one at the end.
struct ReturnPath {
  Dart start;               ///< Leaves the vertex; its triangle is the first.
  std::vector<Dart> darts;  ///< Crossed one after the other, each a dart of the triangle that is left.
  Dart end;                 ///< Of the last triangle; leaves the lift of the vertex.
};

/// Closed geodesics, each as the triangles that one period of it passes through.
///
/// A closed geodesic is a conjugacy class of the group. In the chart of each triangle that it passes through, it is an
/// element. The finite list of these pairs (triangle, element) over one primitive period is the same for all elements
/// of the class. So two elements belong to the same closed geodesic if they do so in one triangle, and no conjugating
/// element has to be searched for. A geodesic that passes through a vertex is pushed a little to its right.
///
/// T is Mp256, or Mp1024 on surfaces with very short geodesics.
template <class T>
class AxisCatalogue {
 public:
  /// Keeps a reference to the triangulation.
  explicit AxisCatalogue(Triangulation& triangulation)
      : triangulation_(triangulation), corners_(triangulation.triangle_count()), axes_in_(corners_.size()) {}

  /// A triangle that a geodesic passes through. The geodesic cuts the corner `cut` off from the other two.
  struct Step {
    TriangleId triangle;
    Isometry<T> element;  ///< In the triangle's chart: the translation along the geodesic. Determinant 1, Re a > 0.
    std::uint32_t cut;
    bool cut_is_left;  ///< Whether the corner cut off lies to the left of the geodesic.
    T position;  ///< Where it crosses the edge from corner `cut` to the next one: grows with the distance from `cut`.
  };
  struct Geodesic {
    T length;
    ReturnPath path;
    std::vector<Step> steps;
    bool simple;
  };

  /// Returns the element of a path in the chart of the path's first triangle. Determinant 1, Re a > 0.
  [[nodiscard]] Isometry<T> element(const ReturnPath& path);

  /// Returns the hyperbolic distance of the start of a dart from the axis of an element, which is given in the chart of
  /// the dart's triangle.
  [[nodiscard]] T distance_from_axis(Dart start, const Isometry<T>& element);

  /// An element in the chart of a dart's triangle, written in that of the triangle across.
  [[nodiscard]] Isometry<T> element_beyond(Dart d, const Isometry<T>& element) { return beyond(d, element).element; }

  /// Returns the number of the geodesic of an element of a path. The element may be a power or the inverse of a known
  /// geodesic; otherwise it becomes a new one. Requires: roots come before their powers. Throws NetError if its axis is
  /// not found.
  ///
  /// O(log n) for n axes known in a triangle, plus time proportional to the triangles on the way.
  std::uint32_t find_or_add(const ReturnPath& path, const Isometry<T>& element);

  [[nodiscard]] const std::vector<Geodesic>& geodesics() const { return geodesics_; }

 private:
  using Vector = LorentzVector<T>;
  struct Place {
    TriangleId triangle;
    Isometry<T> element;
  };
  struct Known {
    std::uint32_t geodesic;
    Isometry<T> element;
  };
  using Corners = std::array<Vector, 3>;

  [[nodiscard]] static double key(const Isometry<T>& f);
  [[nodiscard]] static bool same_axis(const Isometry<T>& f, const Isometry<T>& g);
  [[nodiscard]] static bool axes_cross(const Isometry<T>& f, const Isometry<T>& g);
  [[nodiscard]] static Isometry<T> conjugate(const Isometry<T>& by, const Isometry<T>& f);
  [[nodiscard]] const Corners& corners(TriangleId t);
  [[nodiscard]] Isometry<T> label(LabelId l);
  /// Returns a vector moved from the chart of a dart's triangle to that of the triangle across.
  [[nodiscard]] Vector carried(Dart d, const Vector& x);
  /// Returns the triangle across a dart, with the element moved there.
  [[nodiscard]] Place beyond(Dart d, const Isometry<T>& element);
  [[nodiscard]] Place walk_to_axis(Dart start, const Isometry<T>& element);
  [[nodiscard]] std::optional<std::uint32_t> find(const Place& place);
  /// How an axis passes through a triangle.
  struct Passage {
    std::optional<Step> step;             ///< Absent if the axis misses the triangle.
    Dart leave{};                         ///< Through which it leaves; with a step only.
    std::optional<std::uint32_t> vertex;  ///< A corner on the axis.
  };
  [[nodiscard]] Passage passage(const Place& place);
  /// If the axis was pushed out of a triangle at a vertex or along an edge: a triangle at that vertex which it cuts.
  [[nodiscard]] Place cut_triangle(Place place);
  /// One period of an axis.
  struct Period {
    std::vector<Step> steps;
    bool meets_vertex = false;
  };
  [[nodiscard]] Period follow(Place place);
  [[nodiscard]] static bool is_simple(const std::vector<Step>& steps);

  Triangulation& triangulation_;
  std::vector<Geodesic> geodesics_;
  ById<TriangleId, std::optional<Corners>> corners_;        ///< By triangle, once they have been needed.
  ById<TriangleId, std::multimap<double, Known>> axes_in_;  ///< By triangle: by `key`.
};

extern template class AxisCatalogue<Mp256>;
extern template class AxisCatalogue<Mp1024>;

}  // namespace epsnet
