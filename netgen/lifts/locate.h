#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "certify/document/document.h"
#include "triangulation/base_point.h"
#include "triangulation/triangulation.h"

/// In which triangle of a net is a point of its surface?
namespace epsnet {

/// A triangle that contains a point, and where in it the point is.
struct PointLocation {
  /// Inside of the triangle, on a side, or a corner of it. Points on sides are in several triangles.
  enum class Place { inside, side, corner };
  Place place;
  std::uint32_t triangle;
  /// The side, from this corner to the next one, or the corner that the point is; 0 if it is inside.
  std::uint32_t number;
  /// The lift of the triangle that contains the point, as a path: from the tile of the point to that of the triangle's
  /// chart.
  Word word;
  /// By corner: as for point_of_triangle, with the sum 1; rounded.
  std::array<double, 3> weights;
  /// By corner: its hyperbolic distance from the point, within the triangle; rounded. Another vertex may be nearer,
  /// where a triangle is obtuse.
  std::array<double, 3> distances;

  /// The corner that is nearest.
  [[nodiscard]] std::uint32_t nearest_corner() const;
};

/// Finds points in a net: made once, asked many times.
class Locator {
 public:
  /// Evaluates all labels. Throws as triangulation_of.
  explicit Locator(const certify::NetDocument& net);

  /// A triangle that contains a point of a tile; on the sides of tiles, too. The triangle and the place are decided
  /// with proved signs, binary64 to 4096 bits; beyond that the point is said to be on a side. A straight walk from a
  /// triangle near the point's tile: it ends in every triangulation. Throws SurfaceError if the point is not in the
  /// closed tile, LimitError if it is too far from all triangles.
  [[nodiscard]] PointLocation locate(const BasePoint& point);

 private:
  /// A triangle, and the centre of its chart.
  struct Start {
    std::uint32_t triangle;
    Complex<double> centre;
  };

  Triangulation net_;
  Triangulation used_;  ///< Gets a chart and labels for each point; begun again when these are many.
  std::vector<std::vector<Start>> starts_;  ///< By tile.
};

}  // namespace epsnet
