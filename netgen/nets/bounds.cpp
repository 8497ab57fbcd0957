#include "netgen/nets/bounds.h"

#include <algorithm>
#include <cmath>

#include "kernel/numbers.h"

namespace epsnet {

double least_vertices(std::uint32_t genus, double epsilon) {
  const double s = std::sinh(epsilon / 2);
  return (static_cast<double>(genus) - 1) / (s * s);
}

double most_vertices(std::uint32_t genus, double epsilon) {
  return 16 * (static_cast<double>(genus) - 1) / (epsilon * epsilon);
}

double systole_lower_bound(double epsilon, double shortest_loop) {
  // In these numbers sinh and cosh of a large ε do not overflow and are as accurate as binary64.
  const Mp256 at_thin_loops = sqrt(Mp256(2)) * sinh(Mp256(epsilon) / 2);
  const Mp256 at_loops =
      std::isinf(shortest_loop) ? at_thin_loops : std::min(at_thin_loops, Mp256(sinh(Mp256(shortest_loop) / 2)));
  const auto bound = static_cast<double>(2 * asinh(Mp256(at_loops / cosh(Mp256(epsilon)))));
  return std::isfinite(bound) ? std::nextafter(bound, 0.0) : 0;
}

}  // namespace epsnet
