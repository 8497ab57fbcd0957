#pragma once

#include <stdexcept>

namespace epsnet {

/// What all exceptions of this library have in common that say, in what(), why something cannot be done: input that is
/// not what it should be, files that cannot be read or written, nets that are not found. A program ends with that text.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace epsnet
