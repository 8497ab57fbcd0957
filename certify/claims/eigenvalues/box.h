#pragma once

#include <optional>
#include <vector>

#include "certify/base/text.h"
#include "certify/claims/eigenvalues/document.h"
#include "certify/net/numbering.h"
#include "certify/numbers/ball.h"
#include "certify/numbers/budget.h"
#include "certify/numbers/isometry.h"

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

/// ρ of Lemma 37.10: the roots of eigenvalues are at most that far from those in the centre. Nothing if the corners of
/// a triangle are too near to a line. `labels` are the values of the net's labels, number k ≥ 1 at k − 1; balls round
/// to the precision of the caller. O(directions · (triangles + letters of the labels)), taken off the budget. Requires:
/// a box without problems; the rule `map` is verified.
[[nodiscard]] std::optional<Ball> root_distance(const EigenvaluesDocument& document,
                                                const std::vector<BallIsometry>& labels, const Budget& budget);

/// A number y ≥ 0 for which √y is at most √x − distance; 0 if there is no other. x for distance 0.
[[nodiscard]] double least_beside(double x, double distance);
/// A number y for which √y is at least √x + distance; x for distance 0.
[[nodiscard]] double greatest_beside(double x, double distance);

}  // namespace epsnet::certify
