#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "epsnet/kernel/lorentz.h"
#include "epsnet/kernel/numbers.h"
#include "epsnet/netgen/unfolding.h"
#include "epsnet/triangulation/triangulation.h"

namespace epsnet {

/// Closed geodesics, each as the triangles that one period of it passes through.
///
/// A closed geodesic is a conjugacy class of the group. In the chart of a triangle that it passes through it is an
/// element, and the finite list of these pairs (triangle, element), one primitive period, is the same for all elements
/// of the class. So two elements belong to the same closed geodesic if they do in one triangle: no conjugating element
/// has to be searched for. Where the geodesic passes through a vertex it is pushed a little to its right.
///
/// T is Mp256, or Mp1024 on surfaces with very short geodesics.
template <class T>
class AxisCatalogue {
 public:
  explicit AxisCatalogue(Triangulation& triangulation)
      : triangulation_(triangulation), axes_in_(triangulation.triangle_count()) {}

  /// A triangle that a geodesic passes through. The geodesic cuts the corner `cut` off from the other two.
  struct Step {
    std::uint32_t triangle;
    Isometry<T> element;  ///< In the triangle's chart: the translation along the geodesic. Determinant 1, Re a > 0.
    std::uint32_t cut;
    bool cut_is_left;  ///< The corner cut off lies to the left of the geodesic.
    T position;  ///< Where it crosses the edge from corner `cut` to the next one: grows with the distance from `cut`.
  };
  struct Geodesic {
    T length;
    ReturnPath path;
    std::vector<Step> steps;
    bool simple;
  };

  /// The element of a path: in the chart of the path's first triangle. Determinant 1, Re a > 0.
  [[nodiscard]] Isometry<T> element(const ReturnPath& path);

  /// The distance of the start of a dart from the axis of an element in the chart of the dart's triangle (hyperbolic).
  [[nodiscard]] T distance_from_axis(Dart start, const Isometry<T>& element);

  /// The geodesic of an element of a path: the number of a known one, of which it may be a power or the inverse; else
  /// it becomes a new one. Roots must come before their powers. Throws NetError if its axis is not found.
  std::uint32_t find_or_add(const ReturnPath& path, const Isometry<T>& element);

  [[nodiscard]] const std::vector<Geodesic>& geodesics() const { return geodesics_; }

 private:
  using Vector = LorentzVector<T>;
  struct Place {
    std::uint32_t triangle;
    Isometry<T> element;
  };
  struct Known {
    std::uint32_t geodesic;
    Isometry<T> element;
  };

  [[nodiscard]] static bool same_axis(const Isometry<T>& f, const Isometry<T>& g);
  [[nodiscard]] static bool axes_cross(const Isometry<T>& f, const Isometry<T>& g);
  [[nodiscard]] static Isometry<T> conjugate(const Isometry<T>& by, const Isometry<T>& f);
  [[nodiscard]] Vector corner(std::uint32_t t, std::uint32_t i);
  [[nodiscard]] Isometry<T> label(LabelId l);
  /// The isometry from the chart of a dart's triangle to that of the triangle across.
  [[nodiscard]] Isometry<T> step_across(Dart d);
  [[nodiscard]] Place walk_to_axis(Dart start, const Isometry<T>& element);
  [[nodiscard]] std::optional<std::uint32_t> find(const Place& place) const;
  /// The triangle's step of an axis, if it passes through, and the dart through which it leaves.
  [[nodiscard]] std::optional<std::pair<Step, Dart>> step_in(const Place& place, bool& through_vertex);
  [[nodiscard]] std::vector<Step> follow(Place place, bool& through_vertex);
  [[nodiscard]] bool is_simple(std::uint32_t geodesic, const std::vector<Step>& steps) const;

  Triangulation& triangulation_;
  std::vector<Geodesic> geodesics_;
  std::vector<std::vector<Known>> axes_in_;  ///< By triangle.
};

extern template class AxisCatalogue<Mp256>;
extern template class AxisCatalogue<Mp1024>;

}  // namespace epsnet
