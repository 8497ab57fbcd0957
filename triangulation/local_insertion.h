#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "triangulation/triangulation.h"

namespace epsnet {

/// The triangles that insert_locally made, and those of them that are large.
struct NewTriangles {
  static constexpr std::size_t kMost = 26;
  std::uint32_t count = 0;
  std::uint32_t large_count = 0;
  std::array<std::uint32_t, kMost> slots;
  std::array<std::uint32_t, kMost> large_slots;
};

/// insert_in_cavity for a new vertex at the point p of t's chart, where binary64 decides everything: the way of nearly
/// all insertions of a refinement, with every coordinate loaded once and nothing allocated but the new vertex and
/// triangles. False, with nothing changed, if a predicate is unsure, if a triangle is met twice, or if p is not
/// certainly at a distance d with sinh²(d/2) > apart from all other vertices. `made` is memory of the caller. Triangles
/// with sinh²R > large are marked.
[[nodiscard]] bool insert_locally(Triangulation& triangulation, std::uint32_t t, const Complex<double>& p,
                                  const Threshold& apart, const Threshold& large, NewTriangles& made);

}  // namespace epsnet
