#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certify/numbers/ball.h"

/// Triangulations with one vertex at a point, by numbers alone: the sinh²(d/2) of their edges (docs/proof.md, section
/// 15). Balls round to the precision of the caller.
namespace epsnet::certify {

/// sinh²(d/2) of the three sides of a triangle.
using Sides = std::span<const Ball, 3>;

/// Whether a triangle certainly lies in a disk of radius r, `most` its sinh²: its circumcircle is not larger, or it is
/// not acute and the disk with the longest side as diameter is not. `no` if it certainly does not.
[[nodiscard]] Tri fits(Sides sides, const Ball& most);

/// The measures of a triangle with a circumcircle.
struct TriangleMeasures {
  Ball k;  ///< K = 4ab − (a + b − c)²: positive if there is a circumcircle.
  std::array<Ball, 3>
      cotangent;  ///< Of the angle opposite to each side in the Euclidean triangle with sides √a, √b, √c.
  Ball area;
};

/// Returns the measures of a triangle. Unless K is certainly positive, all other members are non-finite.
[[nodiscard]] TriangleMeasures measures(Sides sides);

/// Whether F triangles with one vertex, of these areas, that cover a closed surface once, if clockwise ones count
/// negatively, certainly are all counterclockwise: ΣA < A + π(F − 2) for each.
[[nodiscard]] Tri all_counterclockwise(std::span<const Ball> areas);

/// Whether the triangulation is Delaunay at the point, all edges certainly locally so (docs/proof.md, Lemma 25), and
/// its largest circumradius is at least r, `least` its sinh². What is across each dart, and sinh²(d/2) of each.
[[nodiscard]] Tri is_delaunay_and_wide(std::span<const std::uint32_t> opposite, std::span<const Ball> h,
                                       const Ball& least);

}  // namespace epsnet::certify
