#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace epsnet {

/// A permutation of 0, …, n − 1, which takes i to entry i.
using Permutation = std::vector<std::uint32_t>;

/// First p, then q: two permutations of the same degree.
[[nodiscard]] inline Permutation composed(const Permutation& p, const Permutation& q) {
  Permutation result(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) result[i] = q[p[i]];
  return result;
}

}  // namespace epsnet
