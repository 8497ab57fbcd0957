#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/geodesics/axis_crossings.h"

/// Where the closed geodesics of a list cross, and what that says of isometries (docs/proof.md, Lemma 41).
namespace epsnet::certify {

/// A point where a closed geodesic crosses one of a list, perhaps itself.
struct CrossingPoint {
  Ball along;           ///< From the beginning of the period, in the geodesic's direction.
  Ball cosine;          ///< Of the angle from that direction, counterclockwise, to the line of the other one.
  std::uint32_t other;  ///< The other one,
  std::uint32_t place;  ///< and where this passage of the other one is in its list.
  int turn;  ///< 1 if the direction of the other one is on one side of this one's, −1 if on the other side.
};

/// By closed geodesic, each given by one shortest period, no two the same: all points where it crosses one of them,
/// once for each time that it passes. Nullopt if the precision is too low. O(chords, and the pairs in one triangle).
[[nodiscard]] std::optional<std::vector<std::vector<CrossingPoint>>> crossing_points(
    const MovedNet& net, std::span<const AxisCrossings> geodesics);

/// What is known of the closed geodesics up to some length: of all, where they cross; and 2 arcosh of `cosh_half`.
struct CrossingGeodesics {
  std::vector<Ball> lengths;
  std::vector<std::vector<CrossingPoint>> points;
};

/// A number that isometries do not exceed: how many frames there are to which one may take the frame of a geodesic at
/// one of its points.
[[nodiscard]] std::uint64_t possible_frames(const LiftedPlane& plane, const CrossingGeodesics& geodesics,
                                            std::size_t geodesic, std::size_t point);

/// The least that possible_frames returns for one point in each set of geodesics that crossings join, if isometries are
/// followed from each geodesic to those that it crosses, until no more than `enough` frames are left, or all are
/// compared. The greatest number if no two geodesics cross.
[[nodiscard]] std::uint64_t followed_frames(const LiftedPlane& plane, const CrossingGeodesics& geodesics,
                                            std::uint64_t enough);

/// The work that possible_frames takes at most, for one point of the geodesic. O(geodesics).
[[nodiscard]] double most_frames_work(const LiftedPlane& plane, const CrossingGeodesics& geodesics,
                                      std::size_t geodesic);

}  // namespace epsnet::certify
