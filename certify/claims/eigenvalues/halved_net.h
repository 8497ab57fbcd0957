#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "certify/net/document.h"
#include "certify/numbers/isometry.h"

/// A net whose triangles are divided into four, several times (docs/proof.md, section 17.1).
namespace epsnet::certify {

/// How many sides and vertices there are after `halvings`.
struct HalvedSizes {
  std::uint64_t sides;
  std::uint64_t vertices;
};

/// Requires: at most 12 halvings.
[[nodiscard]] HalvedSizes halved_sizes(const NetDocument& net, std::uint32_t halvings);

/// Which triangles, sides and vertices meet.
struct HalvedNet {
  /// By triangle: the number of the side from corner i to corner i + 1, and of the vertex at corner i.
  std::vector<std::array<std::uint32_t, 3>> sides;
  std::vector<std::array<std::uint32_t, 3>> vertices;
};

/// O(number of triangles). Requires: the rule `map` is verified; the sizes are less than 2³⁰.
[[nodiscard]] HalvedNet halved_net(const NetDocument& net, std::uint32_t halvings);

/// By triangle of the halved net that triangle `t` of the net contains, 4^halvings of them: the squares of the sides of
/// its flat triangle, 4 sinh²(d/2), the one opposite to corner i at i. Balls round to the precision of the caller.
///
/// `labels` are the values of the net's labels, number k ≥ 1 at k − 1.
[[nodiscard]] std::vector<std::array<Ball, 3>> flat_sides(const NetDocument& net,
                                                          const std::vector<BallIsometry>& labels, std::uint32_t t,
                                                          std::uint32_t halvings);

}  // namespace epsnet::certify
