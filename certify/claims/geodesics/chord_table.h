#pragma once

#include <span>
#include <vector>

#include "certify/claims/geodesics/chords.h"
#include "certify/lifted/interval_index.h"

namespace epsnet::certify {

/// The chords of all geodesics of a list, by triangle, at one precision.
class ChordTable {
 public:
  /// One geodesic's element, in the chart of the vertex that the dart leaves.
  struct Member {
    std::uint32_t first_dart;
    BallIsometry element;
  };

  /// `complete()` is false if the chords of a member could not be found to this precision. Several threads work.
  ChordTable(const LiftedPlane& plane, std::vector<Member> members, unsigned threads);

  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] std::size_t size() const { return lists_.size(); }
  [[nodiscard]] const ChordList& list(std::size_t geodesic) const { return looked_up(lists_, geodesic, kNoGeodesic); }
  [[nodiscard]] Interval length(std::size_t geodesic) const { return looked_up(lengths_, geodesic, kNoGeodesic); }
  [[nodiscard]] std::uint32_t first_dart(std::size_t geodesic) const {
    return looked_up(first_darts_, geodesic, kNoGeodesic);
  }

  struct Place {
    std::uint32_t geodesic;
    std::uint32_t chord;
  };
  /// All chords in a triangle, by geodesic and chord.
  [[nodiscard]] const std::vector<Place>& in_triangle(std::uint32_t triangle) const {
    return looked_up(places_, triangle, "there is no triangle");
  }
  /// Those of one geodesic.
  [[nodiscard]] std::span<const Place> in_triangle(std::uint32_t triangle, std::uint32_t geodesic) const;
  /// Every chord in the triangle of the given one that may be on the same axis: all others are certainly not. In order
  /// of geodesic and chord.
  [[nodiscard]] std::vector<Place> on_axis(const Chord& chord) const;
  [[nodiscard]] const Chord& chord(Place place) const {
    return looked_up(list(place.geodesic).chords, place.chord, "there is no chord");
  }

  struct Match {
    Tri found = Tri::no;
    std::uint32_t geodesic = 0;
    std::uint32_t power = 0;
  };
  /// Whether the chord's element, of the length given, is a power of a chord of the list or of the inverse of one, the
  /// geodesic `except` left out. `unknown` if it may be. Only chords that may be on its axis are compared, which are
  /// few.
  [[nodiscard]] Match find(const Chord& chord, Interval length, std::uint32_t except = Chord::kNone) const;

  /// Another geodesic of the list of which this one is a power, up to orientation.
  [[nodiscard]] Match find_other(std::uint32_t geodesic) const;

  /// Whether the geodesic is not simple: two of its chords cross in one triangle.
  [[nodiscard]] Tri crosses_itself(std::uint32_t geodesic) const;
  /// Whether one of its chords crosses one of another geodesic. None is the same or a power of another.
  [[nodiscard]] Tri crosses_another(std::uint32_t geodesic) const;

 private:
  static constexpr const char* kNoGeodesic = "there is no geodesic";

  /// Whether two axes cross; different axes of the group have no common end.
  [[nodiscard]] Tri cross(const Chord& x, const Chord& y) const;
  [[nodiscard]] Tri is_power(const Chord& chord, const BallIsometry& root, std::uint32_t exponent) const;

  const LiftedPlane& plane_;
  std::vector<std::uint32_t> first_darts_;
  std::vector<ChordList> lists_;
  std::vector<Interval> lengths_;
  std::vector<std::vector<Place>> places_;     ///< By triangle.
  std::vector<IntervalIndex> places_by_axis_;  ///< By triangle: indices of places by the chords' keys.
  bool complete_ = true;
};

}  // namespace epsnet::certify
