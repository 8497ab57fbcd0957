#include "epsnet/triangulation/surface.h"

#include <utility>

#include "epsnet/triangulation/glued_polygons.h"

namespace epsnet {

Surface::Surface(std::vector<Tile> tiles, std::vector<Gluing> gluing)
    : tiles_(std::move(tiles)), gluing_(std::move(gluing)) {
  GluedPolygons polygons(tiles_, gluing_);
  polygons.check_vertices();
  polygons.check_convex();
  polygons.check_lengths();
  polygons.check_angles();
  const std::vector<ScaledPoint>& points = polygons.points();
  crossing_.resize(polygons.partner.size());
  for (std::uint32_t s = 0; s < crossing_.size(); ++s) {
    const std::uint32_t other = polygons.partner[s];
    if (other < s) continue;
    crossing_[s] = integral_crossing(points[s], points[polygons.next(s)], points[polygons.next(other)], points[other]);
    crossing_[other] = inverse(crossing_[s]);
  }
  genus_ = polygons.genus();
  first_side_ = std::move(polygons.first_side);
  side_tile_ = std::move(polygons.side_tile);
  partner_ = std::move(polygons.partner);
  vertex_class_ = std::move(polygons.vertex_class);
  vertex_class_count_ = polygons.vertex_class_count;
}

}  // namespace epsnet
