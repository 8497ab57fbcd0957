#pragma once

#include <array>
#include <optional>
#include <vector>

#include "certify/claims/isometries/document.h"
#include "kernel/numbers.h"
#include "kernel/plane.h"
#include "netgen/isometries/isometries.h"
#include "triangulation/surface/words.h"

namespace epsnet {

/// The points of the plane that are not farther from a centre than from its images under all lifts of the isometries of
/// a surface: a point of every orbit, and of few orbits two. In the coordinates of a chart.
struct FundamentalDomain {
  std::array<double, 2> centre;  ///< In the Poincaré disk.
  /// By side, counterclockwise: an isometry of which the image of the centre is as far from the side as the centre.
  certify::IsometryRows rows;
  std::vector<LorentzVector<Mp1024>> corners;  ///< Unit vectors; corner i is between the sides i and i + 1.
};

/// Returns a domain whose centre is near a point of a chart, the least wide one of some; nothing, if its numbers do not
/// agree with the area that it must have, or are too large. Nothing is proved of it. Time is about that of a walk
/// through the tiles for each isometry.
[[nodiscard]] std::optional<FundamentalDomain> fundamental_domain(const Surface& surface, const IsometryGroup& group,
                                                                  const Chart& chart,
                                                                  const LorentzVector<Mp1024>& point);

}  // namespace epsnet
