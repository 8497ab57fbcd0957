#pragma once

#include <cstdint>
#include <optional>

#include "triangulation/triangulation.h"

namespace epsnet {

/// The circumcentre of triangle t in its chart, in binary64 where that is accurate enough to be inside of the circle.
[[nodiscard]] std::optional<Complex<double>> circumcentre_fast(const Mesh& mesh, const Atlas& atlas, std::uint32_t t);

/// A point of t's chart as a vertex, in that one of the charts of t's corners whose origin is nearest. So charts meet
/// along lines, beside which alone triangles have labels, and do not mix.
[[nodiscard]] Atlas::Place in_nearest_chart(const Mesh& mesh, const Atlas& atlas, std::uint32_t t,
                                            const Complex<double>& z);

/// The circumcentre of t from lifts in T (Mp256, Mp1024), if there is one.
template <class T>
[[nodiscard]] std::optional<Complex<Mp1024>> circumcentre_precise(Triangulation& triangulation, std::uint32_t t);

}  // namespace epsnet
