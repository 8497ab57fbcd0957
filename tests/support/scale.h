#pragma once

#include <cmath>
#include <cstdlib>

namespace epsnet::test {

/// Returns the factor for the number of random cases, from the environment variable EPSNET_TEST_MULTIPLIER; 1 if it is
/// not set.
inline double multiplier() {
  const char* text = std::getenv("EPSNET_TEST_MULTIPLIER");
  if (text == nullptr || *text == '\0') return 1;
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (*end != '\0' || !(value > 0) || !(value <= 1e6)) std::abort();
  return value;
}

/// Returns `count`, a number of random cases, scaled by `multiplier`; at least 1.
inline int scaled(int count) {
  return static_cast<int>(std::fmin(1e9, std::fmax(1, std::round(count * multiplier()))));
}

}  // namespace epsnet::test
