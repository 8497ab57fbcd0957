#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "netgen/surfaces/pants_graph.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// Fenchel–Nielsen coordinates: for every edge of a pants graph the hyperbolic length of its cuff, and the twist with
/// which the two sides are glued, which is also a hyperbolic length.
///
/// On cuff k of a pair of pants, the foot of its common perpendicular with cuff k + 1 (modulo 3) is a mark. With twist
/// 0 the marks of the two sides meet. A positive twist moves the other side's mark to the left, as seen from either
/// side. A twist by the length of the cuff is a Dehn twist: another marking of the same surface.
struct FenchelNielsen {
  PantsGraph graph;
  std::vector<Rational> lengths;
  std::vector<Rational> twists;
};

/// A length or a twist is out of range; what() names its edge.
class CoordinateError : public SurfaceError {
 public:
  /// An error in a member, with the problem.
  CoordinateError(std::string member, const std::string& problem) : SurfaceError(problem), member_(std::move(member)) {}
  /// "lengths" or "twists".
  [[nodiscard]] const std::string& member() const { return member_; }

 private:
  std::string member_;
};

/// Returns the exact surface with these coordinates. It has 2g − 2 convex heptagons with rational vertices, each a pair
/// of pants cut open. Its lengths differ from the given ones by a factor within 1 ± 2⁻⁵⁰. Its twists, taken modulo the
/// lengths, differ by at most 2⁻⁵⁰ lengths.
///
/// Scheme: r = exp(length/2) is rounded to a rational number. Then the axes of the cuffs have rational ends, and every
/// pair of pants and every gluing is a rational matrix. docs/fenchel-nielsen.md derives it. Linear in the genus. Throws
/// SurfaceError unless there are as many lengths and twists as edges. Throws CoordinateError for a length outside
/// [1e-25, 100].
[[nodiscard]] Surface fenchel_nielsen_surface(const FenchelNielsen& coordinates);

/// Returns random coordinates on a graph: lengths uniform in [1, 4], twists uniform in [0, length). A seed gives the
/// same coordinates on every machine.
[[nodiscard]] FenchelNielsen random_coordinates(PantsGraph graph, std::uint64_t seed);

}  // namespace epsnet
