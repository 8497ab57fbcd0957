#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "certify/claims/bound/document.h"

namespace epsnet::certify {

/// What is wrong with the structure of a bound file, with its place; nullopt if it can be evaluated: the net has one
/// vertex and no collars, the value is 0 < lo ≤ hi, triangulations come after those they are made from, and the cells
/// of every triangle are one whole subdivision. O(size).
[[nodiscard]] std::optional<std::string> structure_problem(const BoundDocument& document);

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const BoundDocument& document);

}  // namespace epsnet::certify
