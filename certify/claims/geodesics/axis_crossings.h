#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/geodesics/moved_net.h"

/// The edges that the axis of an element crosses, in the triangulation of a moved net (docs/proof.md, section 11).
namespace epsnet::certify {

/// One period of an axis that certainly passes through no vertex.
struct AxisCrossings {
  std::vector<std::uint32_t> darts;  ///< Crossed one after the other, out of their triangles.
  std::vector<BallVector> axes;      ///< The row of the axis in the chart of each of these triangles.
};

/// `element` is written in the chart of the vertex that `first_dart` leaves. Returns nullopt if the precision is too
/// low, or the axis passes through a vertex. Throws BudgetSpent.
[[nodiscard]] std::optional<AxisCrossings> axis_crossings(const MovedNet& net, std::uint32_t first_dart,
                                                          const BallIsometry& element);

/// The element that takes the triangle of the first dart to that beyond the last one, if one crosses them one after the
/// other, in the chart of the former; these two are lifts of one triangle.
[[nodiscard]] BallIsometry element_across(const LiftedPlane& plane, std::span<const std::uint32_t> darts);

/// Whether the axis of an element, in the chart of the first dart's triangle, crosses all darts out of their triangles.
/// They follow each other.
[[nodiscard]] Tri crosses(const MovedNet& net, const BallIsometry& element, std::span<const std::uint32_t> darts);

/// What a geodesic crosses.
struct Meetings {
  Tri itself = Tri::no;
  Tri another = Tri::no;  ///< Of those that are given.
};

/// Each is one shortest period of a geodesic, and no two are the same. O(n log n) for n chords, and the pairs in one
/// triangle.
[[nodiscard]] std::vector<Meetings> find_meetings(const LiftedPlane& plane, std::span<const AxisCrossings> geodesics);

/// The length of an element from cosh(l/2) = |Re a| > 1, rounded outward; from 0 up if balls do not tell |Re a| > 1.
[[nodiscard]] Interval translation_length(const BallIsometry& element, slong precision);

/// A dart that leaves each vertex.
[[nodiscard]] std::vector<std::uint32_t> first_darts(const NetDocument& net);

}  // namespace epsnet::certify
