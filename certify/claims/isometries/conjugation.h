#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/isometries/document.h"
#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/numbers/budget.h"

/// Isometries of the plane that take some elements of groups to others, decided exactly (docs/proof.md, Lemmas 38 and
/// 39).
namespace epsnet::certify {

/// Words from a tile to itself; the second one is perhaps in another group over the same ring.
struct ElementPair {
  std::vector<std::uint32_t> from;
  std::vector<std::uint32_t> to;
};

/// Whether there is an isometry f of the plane with f ∘ x ∘ f⁻¹ = x' for the elements x of all pairs and their partners
/// x'. Nothing, if their numbers are too large; BudgetSpent, if that is too much work.
///
/// Requires: two pairs or more; all elements but the identity are hyperbolic, and the first two `from` have no end of
/// their axes in common.
[[nodiscard]] std::optional<bool> are_conjugate(const Crossings& crossings, std::span<const ElementPair> pairs,
                                                const Budget& budget);

/// 1 or −1 if the axes of two elements cross, with opposite signs for the mirror images of the two; 0 if they do not
/// cross. Each is directed like the translation. Nothing, if the numbers are too large; BudgetSpent.
[[nodiscard]] std::optional<int> crossing_sign(const Crossings& crossings, std::span<const std::uint32_t> word,
                                               std::span<const std::uint32_t> other, const Budget& budget);

// How many isometries some generate, by what they do with a function of words (docs/proof.md, Lemma 40).

/// By side: the values of a function of words at single letters, given for those that are less than their partners.
[[nodiscard]] std::vector<std::uint32_t> cocycle_by_side(const SurfaceSides& sides,
                                                         const std::vector<std::uint32_t>& values);

/// A number that the order of the group that the document's isometries generate is not less than; no more than one
/// above the document's `order` are counted. O(order · letters of all images); BudgetSpent, if that is too much work.
///
/// Requires: a document without structure problem, whose isometries are isometries.
[[nodiscard]] std::uint64_t orbit_size(const SurfaceSides& sides, const IsometriesDocument& document,
                                       const Budget& budget);

// Where the closed geodesics of a list cross, and what that says of isometries (docs/proof.md, Lemma 41).

/// A point where a closed geodesic crosses one of a list, perhaps itself.
struct CrossingPoint {
  Ball along;           ///< From the beginning of the period, in the geodesic's direction.
  Ball cosine;          ///< Of the angle from that direction, counterclockwise, to the line of the other one.
  std::uint32_t other;  ///< The other one.
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

/// The work that this takes at most, for one point of the geodesic. O(geodesics).
[[nodiscard]] double most_frames_work(const LiftedPlane& plane, const CrossingGeodesics& geodesics,
                                      std::size_t geodesic);

}  // namespace epsnet::certify
