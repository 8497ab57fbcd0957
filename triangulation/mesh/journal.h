#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Everything an operation overwrote, so that it can be undone.
struct Journal {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::vector<std::pair<std::uint32_t, Triangle>> overwritten;
};

/// Starts to record for `undo`.
[[nodiscard]] Journal open_journal(const Triangulation& triangulation);
/// Takes back everything since the journal was opened; vertices, triangles and their order are as they were.
void undo(Triangulation& triangulation, const Journal& journal);

}  // namespace epsnet
