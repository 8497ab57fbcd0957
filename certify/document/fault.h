#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// Promises between the parts of the checker that are asked about, always: a lookup of what is not there would read
/// something else, and a verdict about something else could be VERIFIED.
namespace epsnet::certify {

/// A promise was broken, so this program is wrong: what it is about to say means nothing, whatever the file. Whoever
/// catches it gives no verdict.
class Fault : public std::logic_error {
 public:
  /// "a fault of this program: WHAT".
  explicit Fault(const std::string& what) : std::logic_error("a fault of this program: " + what) {}
};

/// Throws Fault with "WHAT INDEX".
[[noreturn]] void throw_fault(const char* what, std::size_t index);

/// Throws Fault(what) unless the promise holds.
inline void ensure(bool holds, const char* what) {
  if (!holds) throw Fault(what);
}

/// x[i]; Fault, if there is none.
template <class T>
[[nodiscard]] const T& element(const std::vector<T>& x, std::size_t i, const char* what) {
  if (i >= x.size()) throw_fault(what, i);
  return x[i];
}

/// *x; Fault, if there is nothing.
template <class T>
[[nodiscard]] T value_of(std::optional<T> x, const char* what) {
  if (!x) throw Fault(what);
  return *std::move(x);
}

}  // namespace epsnet::certify
