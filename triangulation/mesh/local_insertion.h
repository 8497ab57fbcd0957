#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/known_labels.h"

namespace epsnet {

/// The triangles that insert_locally made; those known to be large, and those that binary64 cannot classify.
struct NewTriangles {
  static constexpr std::size_t kMost = 26;
  std::uint32_t count = 0;
  std::uint32_t large_count = 0;
  std::uint32_t unsure_count = 0;
  std::array<TriangleId, kMost> slots;
  std::array<TriangleId, kMost> large_slots;
  std::array<TriangleId, kMost> unsure_slots;
};

/// In a mesh that is a part of a triangulation: the dart across from every edge of its boundary.
inline constexpr Dart kOutside = make_dart(kLargestTriangle, 0);

/// insert_in_cavity for a new vertex in triangle t's circle, whose label leads to t's chart, where binary64 decides
/// everything: the way of nearly all insertions of a refinement, with every coordinate loaded once and nothing
/// allocated but the new vertex and triangles. False, with nothing changed, if a predicate is unsure, if a triangle is
/// met twice, if a label is not known, if it is not certainly at a distance d with sinh²(d/2) > apart from all other
/// vertices, or if the mesh is a part and the cavity reaches to its boundary. `made` is memory of the caller. Triangles
/// with sinh²R > large are marked. Reads nothing but the mesh, `labels` and its atlas, and the binary64 ends of the
/// thresholds.
[[nodiscard]] bool insert_locally(Mesh& mesh, KnownLabels& labels, TriangleId t, const LiftedPoint& point,
                                  const Threshold& apart, const Threshold& large, NewTriangles& made);

}  // namespace epsnet
