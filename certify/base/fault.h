#pragma once

#include <stdexcept>
#include <string>

namespace epsnet::certify {

/// An invariant is broken, so this program has a bug, whatever the file. Handlers must not give a verdict.
class Fault : public std::logic_error {
 public:
  /// "a fault of this program: WHAT".
  explicit Fault(const std::string& what) : std::logic_error("a fault of this program: " + what) {}
};

}  // namespace epsnet::certify
