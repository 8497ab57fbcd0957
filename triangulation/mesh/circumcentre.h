#pragma once

#include <cstdint>
#include <optional>

#include "triangulation/mesh/triangulation.h"

namespace epsnet {

/// Returns the circumcentre of triangle t in its chart, in binary64; nullopt if binary64 cannot place it inside the
/// circle.
[[nodiscard]] std::optional<Complex<double>> circumcentre_fast(const Mesh& mesh, const Atlas& atlas, TriangleId t);

/// Returns a point of t's chart as a vertex, in whichever corner chart has the nearest origin. So charts meet along
/// lines instead of mixing, and only triangles beside these lines have labels.
[[nodiscard]] LiftedPoint in_nearest_chart(const Mesh& mesh, const Atlas& atlas, TriangleId t,
                                           const Complex<double>& z);

/// The circumcentre of t from lifts in T (Mp256, Mp1024), if there is one.
template <class T>
[[nodiscard]] std::optional<Complex<Mp1024>> circumcentre_precise(Triangulation& triangulation, TriangleId t);

}  // namespace epsnet
