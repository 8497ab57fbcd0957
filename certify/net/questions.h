#pragma once

#include <cstdint>

/// What the rules `orientation`, `delaunay`, `covering`, `packing` and `thick` ask of one triangle.
namespace epsnet::certify {

/// One bit each: 0 orientation, 1 covering, 2 + i Delaunay and 5 + i length of edge i, asked at the smaller of the two
/// darts of an edge only.
using Questions = std::uint8_t;
inline constexpr Questions kOrientationBit = 1;
inline constexpr Questions kCoveringBit = 2;
[[nodiscard]] constexpr Questions delaunay_bit(std::uint32_t edge) { return static_cast<Questions>(4U << edge); }
inline constexpr Questions kDelaunayBits = delaunay_bit(0) | delaunay_bit(1) | delaunay_bit(2);
[[nodiscard]] constexpr Questions length_bit(std::uint32_t edge) { return static_cast<Questions>(32U << edge); }

}  // namespace epsnet::certify
