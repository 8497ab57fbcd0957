#pragma once

#include <cstdint>
#include <optional>

#include "triangulation/triangulation.h"

namespace epsnet {

/// The circumcentre of triangle t in its chart, in binary64 where that is accurate enough to be inside of the circle.
[[nodiscard]] std::optional<Complex<double>> circumcentre_fast(const Mesh& mesh, const Atlas& atlas, std::uint32_t t);

/// The same from lifts in T (Mp256, Mp1024), if there is one.
template <class T>
[[nodiscard]] std::optional<Complex<Mp1024>> circumcentre_precise(Triangulation& triangulation, std::uint32_t t);

}  // namespace epsnet
