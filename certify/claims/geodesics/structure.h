#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "certify/claims/geodesics/document.h"

namespace epsnet::certify {

/// What a geodesics document must satisfy before any rule makes sense: its net has no structure problem; indices point
/// somewhere; words lead from a tile to itself; enclosures are positive, finite, in order; clusters are the runs that
/// the enclosures make; every side of every geodesic bounds one piece; there is exactly what the claim needs.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] std::optional<std::string> structure_problem(const GeodesicsDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const GeodesicsDocument& document);

}  // namespace epsnet::certify
