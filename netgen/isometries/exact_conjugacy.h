#pragma once

#include <optional>
#include <span>
#include <vector>

#include "certify/claims/isometries/conjugation.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

using certify::ElementPair;

/// The crossings of both surfaces, those of the second one after those of the first, in one ring. Nothing, if there is
/// no such ring here.
[[nodiscard]] std::optional<certify::Crossings> joint_crossings(const Surface& first, const Surface& second);

/// As certify::are_conjugate, for words from tile 0 of the first surface and of the second one. Nothing, also, if the
/// numbers of the surfaces are in different rings.
[[nodiscard]] std::optional<bool> are_conjugate(const Surface& first, const Surface& second,
                                                std::span<const ElementPair> pairs);

}  // namespace epsnet
