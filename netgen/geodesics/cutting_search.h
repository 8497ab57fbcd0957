#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "certify/claims/geodesics/document.h"
#include "kernel/plane.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// A closed path through the triangles, by the darts that it crosses in turn, each a dart of the triangle that is left:
/// the last one leads to the triangle of the first. It names an element of the group in the chart of that triangle.
struct CuttingPath {
  std::vector<Dart> darts;
  /// Whether it is certainly how a closed geodesic crosses the edges, all of their ends some 10⁻¹⁰ or more from it.
  /// Then it belongs to no other geodesic, and the geodesic, which is primitive, to no other path.
  bool certain;
  /// Whether the geodesic is simple, if binary64 tells.
  std::optional<bool> simple;
};

/// The closed geodesics of a triangulated surface, by the edges that they cross, in binary64 (docs/geodesics.md).
///
/// A closed geodesic crosses a cyclic sequence of darts. Darts have numbers, and the geodesic is found where the
/// sequence is least among all its rotations and those of the way back. Nothing is remembered but the way from the
/// first dart, and a way is left if it cannot be the beginning of a least sequence, if no line crosses all of its
/// edges, or if its end is too far away to be back in time. The vertices are moved a little, to places where hardly any
/// closed geodesic passes through one.
class CuttingSearch {
 public:
  /// Keeps a reference to the triangulation, and evaluates everything once. `inner` marks darts, by their numbers, in
  /// both directions: geodesics that cross no others are not looked for. O(triangles).
  CuttingSearch(Triangulation& triangulation, const std::vector<bool>& inner);

  /// How many edges there are to begin at.
  [[nodiscard]] std::size_t starts() const { return starts_; }

  /// Every closed geodesic of length at most `length` whose least sequence begins at edge number `start`, and perhaps
  /// some others. The bound is taken a little larger than given, so none is missed to rounding. Thread-safe. `tick`, if
  /// given, is called now and then. Throws NetError if that takes more than `most` edges crossed.
  [[nodiscard]] std::vector<CuttingPath> paths(std::size_t start, double length, std::uint64_t most,
                                               const std::function<void()>& tick = {}) const;

 private:
  /// Values of a linear functional at the corners of a triangle that is left through a dart: the end of the dart, which
  /// is on the left hand, its start, and the third corner.
  struct Values {
    double left;
    double right;
    double apex;
  };
  using Corners = std::array<LorentzVector<double>, 3>;
  class Way;
  class Judge;

  [[nodiscard]] static std::uint32_t index(Dart d) { return static_cast<std::uint32_t>(d); }
  void place_corners(Triangulation& triangulation);
  void number_darts(const std::vector<bool>& inner);

  const Triangulation& triangulation_;
  std::size_t starts_ = 0;
  ById<TriangleId, Corners> corners_;  ///< By triangle, in its chart.
  ById<TriangleId, Corners> dual_;     ///< By triangle: the rows of the inverse of the products of its corners.
  std::vector<Values> beyond_;         ///< By dart: the third corner of the triangle across, in terms of those here.
  std::vector<double> cosh_;           ///< By dart: of the length of its edge.
  std::vector<std::uint32_t> code_;    ///< By dart: 2k for an edge of number k in one direction, 2k + 1 in the other.
  std::vector<Dart> dart_;             ///< By code.
  std::vector<std::uint32_t> step_;    ///< By dart: which isometry leads from the chart across.
  std::vector<Isometry<double>> isometries_{{}};  ///< Number 0 is the identity.
};

/// A simple closed curve passing through a triangle: it cuts off one corner.
struct CornerArc {
  TriangleId triangle;
  std::uint32_t corner;  ///< The corner cut off.
  bool corner_is_left;   ///< Whether it is on the left of the directed curve.
  std::uint32_t rank;    ///< How many other arcs are nearer to it.
};

/// Returns the components of a surface minus pairwise disjoint simple closed curves, each given by all of its arcs:
/// their genus and boundaries (curve, side), side 0 on the left. The method only counts: arcs cut triangles into cells,
/// cells are joined across edges, and V − E + F is 2 − 2g − b for a component of genus g with b boundaries. The pieces
/// are in the order of their first boundaries; without curves the only piece is the surface. O(triangles + arcs).
[[nodiscard]] std::vector<certify::GeodesicsDocument::Piece> cut_surface(
    const Triangulation& triangulation, const std::vector<std::vector<CornerArc>>& curves);

}  // namespace epsnet
