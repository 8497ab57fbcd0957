#pragma once

#include <cstdint>

#include "certify/claims/bound/document.h"
#include "certify/claims/distance/document.h"
#include "certify/claims/geodesics/document.h"
#include "certify/net/document.h"

namespace epsnet::certify {

/// About the least number of bytes of a file with this content (docs/format.md, "Limits").
[[nodiscard]] std::uint64_t least_bytes(const NetDocument& document);
[[nodiscard]] std::uint64_t least_bytes(const GeodesicsDocument& document);
[[nodiscard]] std::uint64_t least_bytes(const DistanceDocument& document);
[[nodiscard]] std::uint64_t least_bytes(const BoundDocument& document);

}  // namespace epsnet::certify
