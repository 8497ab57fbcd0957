#pragma once

#include <string>
#include <utility>

#include "netgen/surfaces/group.h"

namespace epsnet::test {

inline MatrixSurface made_of(const std::string& text) { return surface_of_matrices(parse_matrices(text)); }

/// What is said of a text, and of which kind that is.
inline std::pair<MatricesError::Kind, std::string> problem(const std::string& text) {
  try {
    (void)made_of(text);
  } catch (const MatricesError& error) {
    return {error.kind(), error.what()};
  }
  return {MatricesError::Kind::text, "no problem"};
}

}  // namespace epsnet::test
