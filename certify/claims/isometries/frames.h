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
  std::uint32_t chord;  ///< The number of the dart across which the geodesic leaves the triangle of the point.
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

/// The closed geodesics of a document in the triangulation of its net.
class GeodesicsInNet {
 public:
  /// The document and the parts of its labels must live as long.
  GeodesicsInNet(const GeodesicsDocument& document, const LabelParts& parts);
  GeodesicsInNet(const GeodesicsInNet&) = delete;
  GeodesicsInNet& operator=(const GeodesicsInNet&) = delete;

  /// With balls of so many bits; must not live longer than this.
  [[nodiscard]] LiftedPlane plane(slong precision, slong cap, unsigned threads) const;
  /// Where they cross. Nullopt if the precision is too low.
  [[nodiscard]] std::optional<CrossingGeodesics> crossings(const LiftedPlane& plane, unsigned threads) const;

 private:
  const GeodesicsDocument& document_;
  const LabelParts& parts_;
  NetDocument net_;
  LabelEvaluator evaluator_;
  std::vector<std::uint32_t> first_darts_;
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

/// Whether certainly no isometry takes one surface to another, given all closed geodesics of each up to one length:
/// for one frame of one of them no frame of the other one is left. The plane is of either surface.
[[nodiscard]] bool no_isometry(const LiftedPlane& plane, const CrossingGeodesics& first,
                               const CrossingGeodesics& other);

}  // namespace epsnet::certify
