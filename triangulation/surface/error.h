#pragma once

#include "certify/base/error.h"

namespace epsnet {

/// The base class of the library's exceptions for tasks that cannot be done: invalid input, files that cannot be read
/// or written, nets that are not found. what() gives the reason, and a program ends with that text.
class Error : public certify::LocatedError {
 public:
  using LocatedError::LocatedError;
};

/// A surface or a triangulation is beyond a limit: too many triangles or labels, a path too long to be evaluated.
class LimitError : public Error {
 public:
  using Error::Error;
};

/// A file could not be written. what() is one line: the path and the reason ("No space left on device").
class WriteError : public Error {
 public:
  using Error::Error;
};

/// Vertices and triangles are not a triangulation; what() names the first wrong element.
class TriangulationError : public Error {
 public:
  using Error::Error;
};

}  // namespace epsnet
