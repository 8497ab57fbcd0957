#pragma once

namespace epsnet {

/// The walk that finds the triangle containing a point (thesis Chapter II, IV.4.3).
enum class Walk {
  visibility,  ///< Crosses any edge behind which the point lies; ends in a Delaunay triangulation (Theorem II.1).
  straight,    ///< Follows the geodesic from a corner; ends in every triangulation.
};

}  // namespace epsnet
