#pragma once

#include <cstdint>

#include "triangulation/mesh/editor.h"

/// What the refinement alone needs of a triangulation: marks of triangles, and memory that is asked for early.
namespace epsnet {

/// Sets and takes back the mark of a triangle (`Triangle::marked`).
inline void mark(Triangulation& triangulation, TriangleId t) {
  Editor(triangulation).triangles()[t].labels_and_mark |= 1;
}
inline void unmark(Triangulation& triangulation, TriangleId t) {
  Editor(triangulation).triangles()[t].labels_and_mark &= ~std::uint64_t{1};
}

// Asks the memory for what an insertion at triangle t is going to touch, one step of indirection after the other.
inline void prefetch_triangle(const Triangulation& triangulation, TriangleId t) {
  __builtin_prefetch(&triangulation.triangle(t));
}
inline void prefetch_neighbours(const Triangulation& triangulation, TriangleId t) {
  const Triangle& triangle = triangulation.triangle(t);
  for (std::uint32_t i = 0; i < 3; ++i) {
    __builtin_prefetch(&triangulation.point(triangle.vertex[i]));
    __builtin_prefetch(&triangulation.triangle(triangle_of(triangle.opposite[i])));
  }
}
inline void prefetch_second_neighbours(const Triangulation& triangulation, TriangleId t) {
  for (const Dart d : triangulation.triangle(t).opposite) {
    const Triangle& neighbour = triangulation.triangle(triangle_of(d));
    const std::uint32_t i = corner_of(d);
    __builtin_prefetch(&triangulation.point(neighbour.vertex[previous(i)]));
    __builtin_prefetch(&triangulation.triangle(triangle_of(neighbour.opposite[next(i)])));
    __builtin_prefetch(&triangulation.triangle(triangle_of(neighbour.opposite[previous(i)])));
  }
}

}  // namespace epsnet
