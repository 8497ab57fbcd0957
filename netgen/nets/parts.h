#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Options of a refinement in parts.
struct PartOptions {
  double expected_vertices;                          ///< Approximately, of the whole net.
  unsigned threads;                                  ///< 0: as many as there are cores.
  std::function<void(std::size_t vertices)> report;  ///< Gets the number so far; called on the calling thread only.
};

/// The result of a refinement in parts.
struct PartResult {
  std::uint64_t insertions = 0;
  std::uint64_t flips = 0;          ///< As RefinementStatistics counts them.
  std::vector<TriangleId> pending;  ///< Triangles still marked; some may turn out not to be large.
};

/// Inserts the circumcentres of large triangles in many parts of a Delaunay triangulation concurrently, with
/// insert_locally only. Triangles that it cannot decide, or that are near the boundary of a part, stay `pending` in
/// the result. Requires: `pending` are all large triangles, and they are marked. The result depends on the
/// triangulation only, not on `threads` (docs/design.md, "On all cores"). Throws LimitError and what `report` throws;
/// the triangulation is then unusable.
[[nodiscard]] PartResult refine_in_parts(Triangulation& triangulation, std::vector<TriangleId> pending,
                                         const Threshold& apart, const Threshold& large, const PartOptions& options);

}  // namespace epsnet
