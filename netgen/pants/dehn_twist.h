#pragma once

#include <cstdint>
#include <vector>

#include "netgen/pants/pants.h"
#include "triangulation/surface/surface.h"

/// Dehn twists: a surface with another marking, and the flow of twists. docs/fenchel-nielsen.md has the conventions.
namespace epsnet {

/// The greatest power of a Dehn twist.
inline constexpr std::int32_t kMostTwists = 1000;

/// Returns by side s a path with the ends of the path that crosses s: what the Dehn twist along a simple closed curve
/// makes of it. That of a path is the product of those of its letters. A path that meets the curve turns left, as often
/// around it as `power` says; right, if it is negative. Throws CurveError for a curve that is not simple, LimitError
/// for a power beyond kMostTwists.
[[nodiscard]] std::vector<Word> dehn_twist_words(const Surface& surface, const Word& curve, std::int32_t power = 1);

/// Returns the surface with another marking. Its tiles are triangles: those into which the diagonals from corner 0 cut
/// the tiles, in this order, glued alike, but each is as long and thin as the Dehn twist makes it, and vertices are
/// moved so that no triangle turns over. There is an isometry f to the given surface that takes the path across a side
/// to its image under the twist: words stand for other elements, and the surface is the same.
///
/// Exact. Throws CurveError as above, SurfaceError for `is_regular` surfaces, whose numbers are not rational, and
/// LimitError if no such triangles are found.
[[nodiscard]] Surface dehn_twisted(const Surface& surface, const Word& curve, std::int32_t power = 1);

/// Returns the surface after a twist by a length along a simple closed curve: cut along its geodesic and glued anew,
/// the other side moved to the left by `by`, as seen from either side. It is one of fenchel_nielsen_surface, with its
/// rounding. Throws as pants_decomposition and fenchel_nielsen_surface.
[[nodiscard]] Surface twisted(const Surface& surface, const Word& curve, const Rational& by,
                              const PantsOptions& options = {});

}  // namespace epsnet
