#pragma once

#include "triangulation/surface/surface.h"

namespace epsnet {

/// A path that turns around a vertex crosses one side after the other of those that end there.
enum class Turn { counterclockwise, clockwise };

/// The crossing that continues a turn after side s: next to the partner of s in its tile.
[[nodiscard]] inline SideId next_crossing(const Surface& surface, SideId s, Turn turn) {
  const SideId partner = surface.partner(s);
  return turn == Turn::counterclockwise ? surface.next_side(partner) : surface.previous_side(partner);
}

}  // namespace epsnet
