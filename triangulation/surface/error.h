#pragma once

#include <stdexcept>

namespace epsnet {

/// The base class of the library's exceptions for tasks that cannot be done: invalid input, files that cannot be read
/// or written, nets that are not found. what() gives the reason, and a program ends with that text.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace epsnet
