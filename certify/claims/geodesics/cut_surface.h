#pragma once

#include <optional>
#include <vector>

#include "certify/claims/geodesics/chord_table.h"
#include "certify/claims/geodesics/document.h"

namespace epsnet::certify {

/// The components of the surface minus all geodesics of the table, which are simple and pairwise disjoint; the genus of
/// each, and its boundaries in increasing order. The components are in the order of their first triangle.
///
/// A vertex on a geodesic counts as on its left: the curves are pushed slightly to the right (docs/proof.md, section
/// 11). Whether a vertex lies on one is decided exactly where 128 bits do not tell. `elements[i]` is the label number
/// of geodesic i, whose element is the inverse of that label. Returns nullopt if the precision is too low. O(n log n),
/// n the number of triangles and chords.
[[nodiscard]] std::optional<std::vector<GeodesicsDocument::Piece>> cut_surface(
    const LiftedPlane& plane, const LabelEvaluator& evaluator, const ChordTable& table,
    const std::vector<std::uint32_t>& elements);

}  // namespace epsnet::certify
