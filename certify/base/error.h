#pragma once

#include <stdexcept>
#include <string>
#include <utility>

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
  explicit LocatedError(const std::string& problem) : LocatedError(ErrorParts{.problem = problem}) {}
  /// what() is "FILE: PLACE: PROBLEM, expected EXPECTED", without what is empty.
  explicit LocatedError(const ErrorParts& parts)
      : LocatedError(before(parts.file) + before(parts.place) + parts.reason(), parts) {}
  /// For a line of another form.
  LocatedError(const std::string& line, ErrorParts parts) : std::runtime_error(line), parts_(std::move(parts)) {}

  [[nodiscard]] const ErrorParts& parts() const { return parts_; }
  [[nodiscard]] const std::string& file() const { return parts_.file; }
  [[nodiscard]] const std::string& place() const { return parts_.place; }
  [[nodiscard]] const std::string& problem() const { return parts_.problem; }
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

}  // namespace epsnet::certify
