#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <vector>

namespace epsnet {

/// A partition of the numbers 0, …, n − 1 whose sets can be joined (union-find with path halving: nearly constant
/// time).
class DisjointSets {
 public:
  /// Every number is a set of its own.
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::uint32_t{0}); }

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(parent_.size()); }

  /// Returns the least number in the set of i, which identifies the set.
  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    assert(i < size());
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Joins the sets of i and j.
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace epsnet
