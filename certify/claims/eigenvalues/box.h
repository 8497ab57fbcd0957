#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/net/numbering.h"

/// The box of characters of an eigenvalues file: how far eigenvalues may be from those in its centre (docs/proof.md,
/// section 17.3).
namespace epsnet::certify {

/// What is wrong with a box of a net, on a surface of so many sides: nullopt if the radius is a decimal > 0, there are
/// at most 2g directions, as the triangles and vertices of the net say, and each direction has a step of absolute value
/// at most 10⁶ for each side and a finite height for each vertex.
[[nodiscard]] Problem box_problem(const EigenvaluesDocument::Box& box, const NetDocument& net, std::size_t sides);

/// The first direction whose steps are no homomorphism of the group: those of two sides that are glued, or of the sides
/// that are crossed around a vertex, do not add up to 0. Exact, O(directions · sides).
[[nodiscard]] Problem homomorphism_problem(const EigenvaluesDocument::Box& box, const SurfaceSides& sides);

/// The sum of the steps across the sides. Requires: no problem.
[[nodiscard]] std::int64_t step(const EigenvaluesDocument::Direction& direction, std::span<const std::uint32_t> word);

/// A number y ≥ 0 for which √y is at most √x − distance; 0 if there is no other. x for distance 0.
[[nodiscard]] double least_beside(double x, double distance);
/// A number y for which √y is at least √x + distance; x for distance 0.
[[nodiscard]] double greatest_beside(double x, double distance);

}  // namespace epsnet::certify
