#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace epsnet::certify {

/// Where an error is, and what.
struct ErrorParts {
  std::string file = {};      ///< As it is called in messages; empty if no file is to blame.
  std::string place = {};     ///< In the file or among the arguments: a member and its row, a line; empty if unknown.
  std::string problem = {};   ///< What was wrong.
  std::string expected = {};  ///< What would not have been wrong; empty if `problem` says it, or nothing can.

  /// "PROBLEM, expected EXPECTED", or the problem alone.
  [[nodiscard]] std::string reason() const { return expected.empty() ? problem : problem + ", expected " + expected; }
};

/// The base class of errors in what a program was given. what() is one line that says where and what; its parts can be
/// asked for one by one.
class LocatedError : public std::runtime_error {
 public:
  /// what() is the problem.
  explicit LocatedError(const std::string& problem) : LocatedError(ErrorParts{.problem = problem}) {}
  /// what() is "FILE: PLACE: PROBLEM, expected EXPECTED", without what is empty.
  explicit LocatedError(const ErrorParts& parts)
      : LocatedError(before(parts.file) + before(parts.place) + parts.reason(), parts) {}
  /// For a line of another form.
  LocatedError(const std::string& line, ErrorParts parts) : std::runtime_error(line), parts_(std::move(parts)) {}

  /// All parts; one that is not known is empty.
  [[nodiscard]] const ErrorParts& parts() const { return parts_; }
  /// The name of the file.
  [[nodiscard]] const std::string& file() const { return parts_.file; }
  /// Where in the file.
  [[nodiscard]] const std::string& place() const { return parts_.place; }
  /// What is wrong.
  [[nodiscard]] const std::string& problem() const { return parts_.problem; }
  /// What was expected instead.
  [[nodiscard]] const std::string& expected() const { return parts_.expected; }

 private:
  static std::string before(const std::string& part) { return part.empty() ? "" : part + ": "; }

  ErrorParts parts_;
};

/// An invariant is broken, so this program has a bug, whatever the file. Handlers must not give a verdict.
class Fault : public std::logic_error {
 public:
  /// "a fault of this program: WHAT".
  explicit Fault(const std::string& what) : std::logic_error("a fault of this program: " + what) {}
};

// Invariants between the parts of the checker, checked in every build. A lookup of a missing element would read another
// one, and a verdict about that one could be VERIFIED.

/// Throws Fault with WHAT.
[[noreturn]] inline void throw_fault(const char* what) { throw Fault(what); }
/// Throws Fault with "WHAT INDEX".
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
