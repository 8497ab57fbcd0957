#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "netgen/surfaces/pants_graph.h"
#include "triangulation/surface.h"

namespace epsnet {

/// Fenchel–Nielsen coordinates: for every edge of a pants graph the hyperbolic length of the cuff and the twist with
/// which the two sides are glued, a hyperbolic length too.
///
/// Twist 0: on cuff k of a pair of pants the foot of its common perpendicular with cuff k + 1 (modulo 3) is a mark; the
/// marks of the two sides meet. A positive twist moves the other side's mark to the left as seen from either side. A
/// twist by the length of the cuff is a Dehn twist: another marking of the same surface.
struct FenchelNielsen {
  PantsGraph graph;
  std::vector<Rational> lengths;
  std::vector<Rational> twists;
};

/// A length or a twist out of range; what() names its edge.
class CoordinateError : public SurfaceError {
 public:
  /// Of a member, with what is wrong.
  CoordinateError(std::string member, const std::string& problem) : SurfaceError(problem), member_(std::move(member)) {}
  /// "lengths" or "twists".
  [[nodiscard]] const std::string& member() const { return member_; }

 private:
  std::string member_;
};

/// The surface with these coordinates, made of 2g − 2 convex heptagons with rational vertices (a pair of pants cut
/// open), exact: its lengths differ from the ones asked for by a factor within 1 ± 2⁻⁵⁰, its twists, taken modulo the
/// lengths, by at most 2⁻⁵⁰ lengths.
///
/// Scheme: r = exp(length/2) is made rational; then the axes of the cuffs have rational ends, and every pair of pants
/// and every gluing is a rational matrix. docs/fenchel-nielsen.md derives it. Linear in the genus.
/// Throws SurfaceError: not as many lengths and twists as edges; CoordinateError: a length outside of [1e-25, 100].
[[nodiscard]] Surface fenchel_nielsen_surface(const FenchelNielsen& coordinates);

/// Random coordinates on a graph, the same for a seed on every machine: lengths uniform in [1, 4], twists uniform in
/// [0, length).
[[nodiscard]] FenchelNielsen random_coordinates(PantsGraph graph, std::uint64_t seed);

}  // namespace epsnet
