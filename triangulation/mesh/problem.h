#pragma once

#include <string>

#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Empty if the triangulation is sound: opposite is an involution that matches vertices and lifts, triangles are
/// counterclockwise, the triangles at a vertex make one cycle, V − E + F = 2 − 2g. Otherwise what is wrong first. O(n),
/// in exact or staged arithmetic.
[[nodiscard]] std::string problem(Triangulation& triangulation);

}  // namespace epsnet
