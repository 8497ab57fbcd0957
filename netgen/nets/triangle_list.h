#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "triangulation/surface/id.h"

/// The lists of triangles still to be processed (thesis IV.4.7): numbers of slots, which may occur more than once.
namespace epsnet {

/// First in, first out; a ring that doubles when it is full.
class TriangleQueue {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  /// The i-th from the front.
  [[nodiscard]] TriangleId operator[](std::size_t i) const {
    assert(i < size_);
    return ring_[(first_ + i) & (ring_.size() - 1)];
  }
  /// Appends at most 1024 values.
  void push(std::span<const TriangleId> values) {
    assert(values.size() <= 1024);
    if (size_ + values.size() > ring_.size()) {
      std::rotate(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(first_), ring_.end());
      first_ = 0;
      ring_.resize(2 * ring_.size());
    }
    for (const TriangleId value : values) {
      ring_[(first_ + size_++) & (ring_.size() - 1)] = value;
    }
  }
  TriangleId pop() {
    const TriangleId value = (*this)[0];
    first_ = (first_ + 1) & (ring_.size() - 1);
    --size_;
    return value;
  }

 private:
  std::vector<TriangleId> ring_ = std::vector<TriangleId>(1024);
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

/// Last in, first out.
class TriangleStack {
 public:
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  void push(std::span<const TriangleId> values) { values_.insert(values_.end(), values.begin(), values.end()); }
  TriangleId pop() {
    assert(!values_.empty());
    const TriangleId value = values_.back();
    values_.pop_back();
    return value;
  }

 private:
  std::vector<TriangleId> values_;
};

/// The largest first; among equal ones the lowest number first.
class TriangleHeap {
 public:
  [[nodiscard]] std::size_t size() const { return heap_.size(); }
  void push(TriangleId value, double size) { heap_.emplace(size, ~value.number()); }
  TriangleId pop() {
    assert(!heap_.empty());
    const TriangleId value(~heap_.top().second);
    heap_.pop();
    return value;
  }

 private:
  std::priority_queue<std::pair<double, std::uint32_t>> heap_;
};

}  // namespace epsnet
