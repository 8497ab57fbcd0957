#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "certify/lifted/lifted_plane.h"

/// Closed geodesics as finite sets of chords: a pair (t, g) for each lifted triangle that the axis of an element meets,
/// modulo the element's centralizer, where t is the triangle and g the element written in the chart of t
/// (docs/proof.md, section 11).
namespace epsnet::certify {

/// One lifted triangle, in the chart of its triangle, that an axis possibly meets.
struct Chord {
  /// Whether the axis certainly meets the triangle: it has corners on both sides.
  [[nodiscard]] bool is_certain() const {
    const auto [least, most] = std::minmax_element(side.begin(), side.end());
    return *least < 0 && *most > 0;
  }

  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t triangle = 0;
  BallIsometry element;
  BallVector axis;               ///< axis_row(element).
  Interval key{};                ///< Search key: encloses a value determined by the undirected axis.
  std::array<int, 3> side{};     ///< Of the corners: 1 certainly left of the axis, −1 certainly right, else 0.
  std::uint32_t parent = kNone;  ///< The chord of the same geodesic from which this one was reached.
  std::uint32_t dart = kNone;    ///< The dart crossed from there.
};

/// All chords of one axis. `approach` are the darts crossed from the first triangle of the vertex to the first chord.
struct ChordList {
  std::vector<std::uint32_t> approach;
  std::vector<Chord> chords;
};

/// The length of an element from cosh(l/2) = |Re a| > 1, rounded outward; from 0 up if balls do not tell |Re a| > 1.
[[nodiscard]] Interval translation_length(const BallIsometry& element, slong precision);

/// A dart that leaves each vertex.
[[nodiscard]] std::vector<std::uint32_t> first_darts(const NetDocument& net);

/// Finds the chords of the axis of `element`, and passes each to `visit` until it returns false. `element` is written
/// in the chart of the vertex that `first_dart` leaves. Every triangle that the axis truly meets is among them.
///
/// Returns nullopt if the precision is too low. Throws BudgetSpent. O(n log n) for n chords.
[[nodiscard]] std::optional<ChordList> find_chords(const LiftedPlane& plane, std::uint32_t first_dart,
                                                   const BallIsometry& element,
                                                   const std::function<bool(const Chord&)>& visit = {});

}  // namespace epsnet::certify
