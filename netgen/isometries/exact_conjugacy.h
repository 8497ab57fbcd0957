#pragma once

#include <optional>
#include <span>

#include "triangulation/surface/surface.h"

/// Questions about elements of groups of surfaces, answered without rounding (docs/isometries.md, "Why finitely many
/// products decide"). Elements are given by words from tile 0 to itself, and all but 1 are hyperbolic.
namespace epsnet {

/// An element of the group of one surface, and one of another.
struct ElementPair {
  Word from;
  Word to;
};

/// Whether there is an isometry f of the plane with f ∘ x ∘ f⁻¹ = x' for the elements x of all pairs and their partners
/// x'. Nothing, if their numbers are too large, or in a field of a degree above 64.
///
/// Requires: two pairs or more; the first two `from` have no end of their axes in common.
[[nodiscard]] std::optional<bool> are_conjugate(const Surface& first, const Surface& second,
                                                std::span<const ElementPair> pairs);

/// Whether the axes of two elements other than 1 cross. Nothing, if their numbers are too large.
[[nodiscard]] std::optional<bool> axes_cross(const Surface& surface, const Word& first, const Word& second);

}  // namespace epsnet
