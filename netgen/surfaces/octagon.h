#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "triangulation/surface/surface.h"

namespace epsnet {

/// Returns the genus-2 surface of the symmetric octagon z0, z1, z2, z3, −z0, −z1, −z2, −z3 with opposite sides glued
/// (side k to side k + 4).
///
/// Throws SurfaceError unless the octagon is strictly convex, counterclockwise, in the unit disk, and of area 4π, so
/// that its angles add up to 2π. The area is 4π if Im[(1−z0 z̄1)(1−z1 z̄2)(1−z2 z̄3)(1+z3 z̄0)] = 0 (Aigon-Dupuy,
/// Buser, Cibils, Künzle, Steiner, "Hyperbolic octagons and Teichmüller space in genus 2", 2005).
[[nodiscard]] Surface symmetric_octagon(const std::array<Complex<Rational>, 4>& half);

/// Returns the points with z3 moved along the line through z3 and −z0 so that the octagon has the area 4π; nullopt if
/// that is impossible. The new z3 may lie outside the disk, and the octagon may fail to be convex.
[[nodiscard]] std::optional<std::array<Complex<Rational>, 4>> closed_up(const std::array<Complex<Rational>, 4>& half);

/// Returns the random symmetric octagon of the thesis (IV.2.1) for a seed, with rational vertices.
///
/// The surface is exactly the one that `Hyperbolic_fundamental_domain_factory_2` of CGAL 6.1 makes for the same seed
/// when built with GCC for x86-64: the thesis' seeds 123 and 321 are these surfaces. Takes about a
/// millisecond.
[[nodiscard]] Surface random_octagon(std::int32_t seed);

}  // namespace epsnet
