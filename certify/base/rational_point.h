#pragma once

#include <gmpxx.h>

namespace epsnet::certify {

/// A point x + iy of the Poincaré disk with rational coordinates.
struct RationalPoint {
  mpq_class x;
  mpq_class y;
  bool operator==(const RationalPoint&) const = default;
};

}  // namespace epsnet::certify
