#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "certify/net/document.h"
#include "triangulation/surface/surface.h"

/// Location of points in the triangles of a net.
namespace epsnet {

/// A triangle that contains a point, and the position of the point in it.
struct PointLocation {
  /// Inside the triangle, on a side, or at a corner. A point on a side lies in several triangles.
  enum class Place { inside, side, corner };
  Place place;
  std::uint32_t triangle;
  /// The number of the side (from this corner to the next one) or of the corner; 0 if the point is inside.
  std::uint32_t number;
  /// The lift of the triangle that contains the point, as a path from the tile of the point to the tile of the
  /// triangle's chart.
  Word word;
  /// By corner: the weights of point_of_triangle, scaled to the sum 1; rounded.
  std::array<double, 3> weights;
  /// By corner: its hyperbolic distance from the point, within the triangle; rounded. If a triangle is obtuse, a vertex
  /// of another triangle may be nearer.
  std::array<double, 3> distances;

  /// Returns the nearest corner.
  [[nodiscard]] std::uint32_t nearest_corner() const;
};

/// Locates points in a net. Construct it once for many points.
class Locator {
 public:
  /// Evaluates all labels. Throws the exceptions of triangulation_of.
  explicit Locator(const certify::NetDocument& net);
  Locator(Locator&&) noexcept;
  Locator& operator=(Locator&&) noexcept;
  ~Locator();

  /// Returns a triangle that contains a point, which may be anywhere in the disk of its tile. Proved signs, in binary64
  /// and up to 4096 bits, decide the triangle and the position; a sign that is still unknown counts as "on a side". The
  /// search is a straight walk from a triangle near the point's tile, which ends in every triangulation. Throws
  /// SurfaceError if it is no point of the surface, LimitError if it is too far from all triangles.
  [[nodiscard]] PointLocation locate(const BasePoint& point);

 private:
  class Triangles;
  std::unique_ptr<Triangles> triangles_;
};

}  // namespace epsnet
