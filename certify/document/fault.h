#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// Invariants between the parts of the checker, checked in every build. A lookup of a missing element would read
/// another one, and a verdict about that one could be VERIFIED.
namespace epsnet::certify {

/// An invariant is broken, so this program has a bug, whatever the file. Handlers must not give a verdict.
class Fault : public std::logic_error {
 public:
  /// "a fault of this program: WHAT".
  explicit Fault(const std::string& what) : std::logic_error("a fault of this program: " + what) {}
};

/// Throws Fault with "WHAT INDEX".
[[noreturn]] void throw_fault(const char* what, std::size_t index);

/// Throws Fault(what) unless the invariant holds.
inline void ensure(bool holds, const char* what) {
  if (!holds) throw Fault(what);
}

/// Returns x[i]. Throws Fault if i is out of range.
template <class T>
[[nodiscard]] const T& element(const std::vector<T>& x, std::size_t i, const char* what) {
  if (i >= x.size()) throw_fault(what, i);
  return x[i];
}

/// Returns *x. Throws Fault if x is empty.
template <class T>
[[nodiscard]] T value_of(std::optional<T> x, const char* what) {
  if (!x) throw Fault(what);
  return *std::move(x);
}

}  // namespace epsnet::certify
