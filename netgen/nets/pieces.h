#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "triangulation/mesh/threshold.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// What a refinement in pieces is asked for.
struct PieceOptions {
  double expected_vertices;                          ///< Of the whole net, about.
  unsigned threads;                                  ///< 0: as many as there are cores.
  std::function<void(std::size_t vertices)> report;  ///< Called by the calling thread alone: how many there are so far.
};

/// What it did.
struct PieceResult {
  std::uint64_t insertions = 0;
  std::uint64_t flips = 0;             ///< As NetStatistics counts them.
  std::vector<std::uint32_t> pending;  ///< Triangles still marked; some may turn out not to be large.
};

/// Inserts the circumcentres of large triangles in many pieces of a Delaunay triangulation at the same time, by
/// insert_locally alone: whatever that leaves open, and what is near the boundary of a piece, is left `pending`.
/// `pending` are the large triangles, all marked. The result depends on the triangulation only, not on `threads`
/// (docs/design.md, "On all cores"). Throws LimitError and what `report` throws; the triangulation is lost then.
[[nodiscard]] PieceResult refine_in_pieces(Triangulation& triangulation, std::vector<std::uint32_t> pending,
                                           const Threshold& apart, const Threshold& large, const PieceOptions& options);

}  // namespace epsnet
