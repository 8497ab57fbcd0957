#pragma once

#include <cstdint>
#include <vector>

namespace epsnet {

/// A permutation of 0, …, n − 1, which takes i to entry i.
using Permutation = std::vector<std::uint32_t>;

}  // namespace epsnet
