#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/geodesics/document.h"
#include "certify/lifted/lifted_plane.h"

namespace epsnet::certify {

/// The triangulation of a net with its vertices moved a little, at one precision: nothing else of the net is changed,
/// so that it is a triangulation of the same surface as long as no triangle turns over.
///
/// Vertices of nets often lie on closed geodesics, which then cross edges at their ends, in many sequences. A moved one
/// hardly ever does; nothing but the time depends on that.
class MovedNet {
 public:
  /// The plane must outlive the net. `valid()` is false if no way to move the vertices was found that certainly turns
  /// no triangle over; then nothing else may be asked.
  explicit MovedNet(const LiftedPlane& plane);

  [[nodiscard]] bool valid() const { return valid_; }
  [[nodiscard]] const LiftedPlane& plane() const { return plane_; }
  /// The corner where the dart starts, as a unit vector in the chart of its triangle.
  [[nodiscard]] const BallVector& corner(std::uint32_t dart) const { return looked_up(corners_, dart, kNoDart); }
  /// The third corner c of the triangle across a dart: c = k₀ l + k₁ r + k₂ p, with l and r the end and the start of
  /// the dart and p the third corner of its triangle.
  [[nodiscard]] const BallVector& beyond(std::uint32_t dart) const { return looked_up(beyond_, dart, kNoDart); }
  /// That of all darts.
  [[nodiscard]] const std::vector<BallVector>& beyond() const { return beyond_; }
  /// cosh of the length of the dart's edge.
  [[nodiscard]] Interval cosh_length(std::uint32_t dart) const { return looked_up(cosh_, dart, kNoDart); }

 private:
  static constexpr const char* kNoDart = "there is no dart";

  [[nodiscard]] bool place(double share);
  void measure();

  const LiftedPlane& plane_;
  bool valid_ = false;
  std::vector<double> shortest_;  ///< By vertex: sinh(d/2) for the shortest edge there, about.
  std::vector<BallVector> corners_;
  std::vector<BallVector> beyond_;
  std::vector<Interval> cosh_;
};

/// The darts of a net in an order, the two directions of an edge one after the other.
class DartOrder {
 public:
  /// `inner` says of each dart, and of its opposite alike, whether it comes last.
  DartOrder(const MovedNet& net, const std::vector<bool>& inner);

  /// How many darts there are.
  [[nodiscard]] std::size_t size() const { return darts_.size(); }
  /// How many edges are not inner.
  [[nodiscard]] std::size_t starts() const { return starts_; }
  /// Of a dart: 2k in one direction and 2k + 1 in the other, for edge number k.
  [[nodiscard]] std::uint32_t code(std::uint32_t dart) const { return looked_up(code_, dart, "there is no dart"); }
  [[nodiscard]] std::uint32_t dart(std::uint32_t code) const { return looked_up(darts_, code, "there is no code"); }

 private:
  std::vector<std::uint32_t> code_;   ///< By dart.
  std::vector<std::uint32_t> darts_;  ///< By code.
  std::size_t starts_ = 0;
};

// The edges that the axis of an element crosses, in the triangulation of a moved net (docs/proof.md, section 11).

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

/// The components of the surface minus geodesics, which are simple and pairwise disjoint; the genus of each, and its
/// boundaries in increasing order. The components are in the order of their first triangle.
///
/// Each geodesic is given by one period in the net, of whose vertices none is on it. Returns nullopt if the precision
/// is too low. O(n log n), n the number of triangles and chords.
[[nodiscard]] std::optional<std::vector<GeodesicsDocument::Piece>> cut_surface(
    const MovedNet& net, const std::vector<AxisCrossings>& geodesics);

}  // namespace epsnet::certify
