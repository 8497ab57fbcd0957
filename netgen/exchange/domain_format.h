#pragma once

#include <cstddef>
#include <string_view>

#include "netgen/exchange/exchange.h"
#include "triangulation/surface/surface.h"

/// CGAL's text format for fundamental polygons of closed hyperbolic surfaces.
///
/// The format has the number of sides n; then for every side k the index of the side that it is paired with; then the n
/// vertices "x y" counterclockwise, points of the Poincaré disk with rational coordinates `p/q` or `p`. Side k goes
/// from vertex k to vertex k + 1. White space separates all of these.
namespace epsnet {

/// The largest number of sides of a polygon that is not convex. Finding out whether it intersects itself takes
/// quadratic time.
inline constexpr std::size_t kMaxNonConvexSides = 4096;

/// Reads a polygon of any genus and with any number of vertex classes, and checks it completely (see `Surface`).
///
/// A strictly convex polygon becomes the one tile of the surface. Any other simple counterclockwise polygon, with
/// reflex or straight angles, is triangulated exactly, by diagonals; the tiles are the triangles, in the coordinates of
/// the polygon. `name` stands for the text in messages. Throws ExchangeError. Whatever numbers the text contains,
/// memory is linear in its length; for convex polygons time is too, up to logarithmic factors: about a second per
/// megabyte in the worst case (coordinates of 10^6 digits).
[[nodiscard]] Surface read_domain(std::string_view text, std::string_view name);

}  // namespace epsnet
