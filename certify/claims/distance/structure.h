#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "certify/claims/distance/document.h"

namespace epsnet::certify {

/// What a distance document must satisfy before any rule makes sense: its net has no structure problem, one vertex and
/// no collars; the point is in the disk of a tile; words lead from the tile of the vertex's chart to that tile, and
/// there is at least one; the enclosure is finite, not negative and in order.
///
/// The first problem; nullopt if there is none. Exact, O(size of the document).
[[nodiscard]] std::optional<std::string> structure_problem(const DistanceDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const DistanceDocument& document);

}  // namespace epsnet::certify
