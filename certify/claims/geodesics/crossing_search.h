#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "certify/claims/geodesics/orbit_search.h"
#include "certify/lifted/lifted_plane.h"

/// The closed geodesics of a triangulated surface by the sequences of edges that they cross (docs/proof.md, section
/// 11).
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

/// The search for least cyclic sequences of darts, one edge to begin at after the other.
class CrossingSearch {
 public:
  /// The net must outlive the search. `inner` says of each dart, and of its opposite alike, whether closed geodesics
  /// that cross no others need not be found. `cosh_half` is cosh(L/2).
  CrossingSearch(const MovedNet& net, const std::vector<bool>& inner, const Ball& cosh_half);

  /// How many edges there are to begin at.
  [[nodiscard]] std::size_t starts() const { return starts_; }
  /// The dart that a search from edge number `start` begins with.
  [[nodiscard]] std::uint32_t first_dart(std::size_t start) const { return dart_of_[2 * start]; }

  /// Reports, written in the chart of the vertex that first_dart(start) leaves, an element for each primitive closed
  /// geodesic of length at most L of which the least sequence begins at edge number `start`: the translation along one
  /// of its lifts, in one of the two directions. Duplicates and other elements are possible. Thread-safe.
  ///
  /// Depth first, with memory proportional to the depth. A visit is a dart crossed.
  [[nodiscard]] OrbitOutcome run(std::size_t start, std::uint64_t limit,
                                 const std::function<Search(const BallIsometry&, const LabelProduct&)>& report) const;

 private:
  class Way;

  void cross(std::uint32_t dart, BallVector& values) const;
  [[nodiscard]] bool is_to_the_right(std::uint32_t code, std::uint32_t after) const;
  [[nodiscard]] bool possibly_follows(const BallIsometry& element, const std::vector<std::uint32_t>& codes) const;
  [[nodiscard]] std::vector<double> limits(std::size_t start, Way& way) const;

  const MovedNet& net_;
  Ball cosh_half_;
  Ball length_;                         ///< L
  std::vector<std::uint32_t> code_;     ///< By dart: 2k in one direction and 2k + 1 in the other, for edge number k.
  std::vector<std::uint32_t> dart_of_;  ///< By code.
  std::size_t starts_ = 0;
};

}  // namespace epsnet::certify
