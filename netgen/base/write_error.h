#pragma once

#include "triangulation/surface/error.h"

namespace epsnet {

/// A file could not be written. what() is one line: the path and the reason ("No space left on device").
class WriteError : public Error {
 public:
  using Error::Error;
};

}  // namespace epsnet
