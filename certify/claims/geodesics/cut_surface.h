#pragma once

#include <optional>
#include <vector>

#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/claims/geodesics/document.h"

namespace epsnet::certify {

/// The components of the surface minus geodesics, which are simple and pairwise disjoint; the genus of each, and its
/// boundaries in increasing order. The components are in the order of their first triangle.
///
/// Each geodesic is given by one period in the net, of whose vertices none is on it. Returns nullopt if the precision
/// is too low. O(n log n), n the number of triangles and chords.
[[nodiscard]] std::optional<std::vector<GeodesicsDocument::Piece>> cut_surface(
    const MovedNet& net, const std::vector<AxisCrossings>& geodesics);

}  // namespace epsnet::certify
