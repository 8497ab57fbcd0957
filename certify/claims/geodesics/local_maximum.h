#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/claims/geodesics/axis_crossings.h"
#include "certify/lifted/lifted_plane.h"
#include "certify/numbers/ball.h"

/// Whether the systole has a local maximum at a surface: derivatives of the lengths of its shortest closed geodesics
/// along twists (docs/proof.md, Lemmas 15.5 to 15.7).
namespace epsnet::certify {

/// By element k of `about` and geodesic j: the derivative of the length of geodesic j as the surface is twisted along
/// geodesic about[k]. Each geodesic is one shortest period; they are simple, all different, and no two cross twice.
///
/// Nullopt if the precision is too low. The pairs in one triangle, at most, are looked at.
[[nodiscard]] std::optional<std::vector<std::vector<Ball>>> twist_derivatives(const LiftedPlane& plane,
                                                                              std::span<const AxisCrossings> geodesics,
                                                                              std::span<const std::uint32_t> about);

/// The weights of the geodesics of the basis, in order, with which the weighted sum of all derivatives is 0 along all
/// twists about the basis. `weights` has those of the other geodesics, in order.
///
/// Nullopt unless the derivatives of the basis, a square matrix, have certainly an inverse. O(n³) for n elements of the
/// basis; `plane` pays.
[[nodiscard]] std::optional<std::vector<Ball>> weights_of_basis(const LiftedPlane& plane,
                                                                const std::vector<std::vector<Ball>>& derivatives,
                                                                const std::vector<std::uint32_t>& basis,
                                                                const std::vector<std::uint32_t>& weights);

}  // namespace epsnet::certify
