#pragma once

#include <cstdint>
#include <gmpxx.h>

/// What files say of tiles: the corners of a polygon, or the type of a regular one.
namespace epsnet::certify {

/// A point x + iy of the Poincaré disk with rational coordinates.
struct RationalPoint {
  mpq_class x;
  mpq_class y;
  bool operator==(const RationalPoint&) const = default;
};

/// The regular p-gon whose interior angles are 2π/q: q of them meet at a vertex.
struct RegularTile {
  std::uint32_t p = 0;
  std::uint32_t q = 0;
  bool operator==(const RegularTile&) const = default;

  /// Whether there is one in the hyperbolic plane: 1/p + 1/q < 1/2.
  [[nodiscard]] bool is_hyperbolic() const {
    return p > 2 && q > 2 && (std::uint64_t{p} - 2) * (std::uint64_t{q} - 2) > 4;
  }
};

}  // namespace epsnet::certify
