#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/error.h"

/// Invariants between the parts of the checker, checked in every build. A lookup of a missing element would read
/// another one, and a verdict about that one could be VERIFIED.
namespace epsnet::certify {

/// Throws Fault with WHAT, or "WHAT INDEX".
[[noreturn]] inline void throw_fault(const char* what) { throw Fault(what); }
[[noreturn]] inline void throw_fault(const char* what, std::size_t index) {
  throw Fault(what + (" " + std::to_string(index)));
}

/// Throws Fault(what) unless the invariant holds.
inline void ensure(bool holds, const char* what) {
  if (!holds) throw_fault(what);
}

/// Returns x[i]. Throws Fault, "WHAT i", if i is out of range.
template <class T>
[[nodiscard]] const T& looked_up(const std::vector<T>& x, std::size_t i, const char* what) {
  if (i >= x.size()) throw_fault(what, i);
  return x[i];
}

/// Returns *x. Throws Fault if x is empty.
template <class T>
[[nodiscard]] T value_of(std::optional<T> x, const char* what) {
  if (!x) throw_fault(what);
  return *std::move(x);
}

/// Returns the numbers of all x of a range in increasing order, each once; add(x, numbers) appends those of one x.
template <class Range, class Add>
[[nodiscard]] std::vector<std::uint32_t> increasing(const Range& range, const Add& add) {
  std::vector<std::uint32_t> numbers;
  for (const auto& x : range) add(x, numbers);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Returns the index of a number among numbers in increasing order. Throws Fault if it is not one of them.
[[nodiscard]] inline std::size_t place_of(std::uint32_t number, std::span<const std::uint32_t> increasing) {
  const auto found = std::lower_bound(increasing.begin(), increasing.end(), number);
  if (found == increasing.end() || *found != number) throw_fault("not in the list: number", number);
  return static_cast<std::size_t>(found - increasing.begin());
}

}  // namespace epsnet::certify
