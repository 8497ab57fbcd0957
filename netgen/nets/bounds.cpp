#include "netgen/nets/bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epsnet {

double least_vertices(std::uint32_t genus, double epsilon) {
  const double s = std::sinh(epsilon / 2);
  return (static_cast<double>(genus) - 1) / (s * s);
}

double most_vertices(std::uint32_t genus, double epsilon) {
  return 16 * (static_cast<double>(genus) - 1) / (epsilon * epsilon);
}

double systole_lower_bound(double epsilon, double shortest_loop) {
  // Ratios, as sinh and cosh of a large ε overflow: sinh(ε/2)/cosh ε < 1.
  const double at_thin_loops = std::numbers::sqrt2 * std::sinh(epsilon / 2);
  const double at_loops =
      std::isinf(shortest_loop) ? at_thin_loops : std::min(at_thin_loops, std::sinh(shortest_loop / 2));
  const double bound = 2 * std::asinh(at_loops / std::cosh(epsilon));
  return std::isfinite(bound) ? bound : 0;
}

}  // namespace epsnet
