#pragma once

#include <optional>
#include <span>
#include <vector>

#include "triangulation/surface/surface.h"

namespace epsnet {

/// Elements of the groups of two surfaces that some isometry may take to each other. Words lead from tile 0 to itself.
struct ElementPair {
  Word from;  ///< Of the first surface.
  Word to;    ///< Of the second one.
};

/// Whether there is an isometry f of the plane with f ∘ x ∘ f⁻¹ = x' for the elements x of all pairs and their partners
/// x': decided exactly, by the traces of the elements and of their products with the first two (docs/isometries.md).
/// Nothing, if the numbers of the surfaces are in different rings, or too large.
///
/// Requires: no end of the axis of the first element is one of the second.
[[nodiscard]] std::optional<bool> are_conjugate(const Surface& first, const Surface& second,
                                                std::span<const ElementPair> pairs);

}  // namespace epsnet
