#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <span>
#include <utility>
#include <vector>

/// The lists of triangles still to be processed (thesis IV.4.7): numbers of slots, which may occur more than once.
namespace epsnet {

/// First in, first out; a ring that doubles when it is full.
class TriangleQueue {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The i-th from the front.
  [[nodiscard]] std::uint32_t operator[](std::size_t i) const {
    assert(i < size_);
    return ring_[(first_ + i) & (ring_.size() - 1)];
  }
  /// Appends at most 1024 values.
  void push(std::span<const std::uint32_t> values) {
    assert(values.size() <= 1024);
    if (size_ + values.size() > ring_.size()) {
      std::rotate(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(first_), ring_.end());
      first_ = 0;
      ring_.resize(2 * ring_.size());
    }
    for (const std::uint32_t value : values) {
      ring_[(first_ + size_++) & (ring_.size() - 1)] = value;
    }
  }
  std::uint32_t pop() {
    const std::uint32_t value = (*this)[0];
    first_ = (first_ + 1) & (ring_.size() - 1);
    --size_;
    return value;
  }

 private:
  std::vector<std::uint32_t> ring_ = std::vector<std::uint32_t>(1024);
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// Last in, first out.
class TriangleStack {
 public:
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  void push(std::span<const std::uint32_t> values) { values_.insert(values_.end(), values.begin(), values.end()); }
  std::uint32_t pop() {
    assert(!values_.empty());
    const std::uint32_t value = values_.back();
    values_.pop_back();
    return value;
  }

 private:
  std::vector<std::uint32_t> values_;
};

/// The largest first; among equal ones the lowest number first.
class TriangleHeap {
 public:
  [[nodiscard]] std::size_t size() const { return heap_.size(); }
  void push(std::uint32_t value, double size) { heap_.emplace(size, ~value); }
  std::uint32_t pop() {
    assert(!heap_.empty());
    const std::uint32_t value = ~heap_.top().second;
    heap_.pop();
    return value;
  }

 private:
  std::priority_queue<std::pair<double, std::uint32_t>> heap_;
};

}  // namespace epsnet
