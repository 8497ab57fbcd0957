#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace epsnet::certify {

/// The first of `count` ≥ 1 nodes to which no path leads from node 0; nullopt if there is none. neighbours(node, visit)
/// calls visit(other) for each neighbour. O(count + neighbours).
///
/// What is found first is left first, so that nodes stay near in memory whose neighbours are.
template <class Neighbours>
[[nodiscard]] std::optional<std::size_t> first_unreached(std::size_t count, const Neighbours& neighbours) {
  std::vector<bool> reached(count);
  std::vector<std::uint32_t> found{0};
  found.reserve(count);
  reached[0] = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    neighbours(found[i], [&](std::uint32_t other) {
      if (reached[other]) return;
      reached[other] = true;
      found.push_back(other);
    });
  }
  for (std::size_t node = 0; node < count; ++node) {
    if (!reached[node]) return node;
  }
  return std::nullopt;
}

}  // namespace epsnet::certify
