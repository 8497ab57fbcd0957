#include "triangulation/surface.h"

#include <boost/math/constants/constants.hpp>
#include <future>
#include <utility>

#include "triangulation/glued_polygons.h"

namespace epsnet {

Surface::Surface(std::vector<Tile> tiles, std::vector<Gluing> gluing)
    : tiles_(std::move(tiles)), gluing_(std::move(gluing)) {
  GluedPolygons polygons(tiles_, gluing_);
  polygons.check_vertices();
  polygons.check_convex();
  polygons.check_lengths();
  // Angles take as long as all crossings: side by side with them where there are many.
  constexpr std::size_t kMany = 100;
  std::future<void> angles = std::async(polygons.partner.size() > kMany ? std::launch::async : std::launch::deferred,
                                        [&polygons] { polygons.check_angles(); });
  const std::vector<ScaledPoint>& points = polygons.points();
  crossing_.resize(polygons.partner.size());
  for (std::uint32_t s = 0; s < crossing_.size(); ++s) {
    const std::uint32_t other = polygons.partner[s];
    if (other < s) continue;
    crossing_[s] = integral_crossing(points[s], points[polygons.next(s)], points[polygons.next(other)], points[other]);
    crossing_[other] = inverse(crossing_[s]);
  }
  angles.get();
  genus_ = polygons.genus();
  first_side_ = std::move(polygons.first_side);
  side_tile_ = std::move(polygons.side_tile);
  partner_ = std::move(polygons.partner);
  vertex_class_ = std::move(polygons.vertex_class);
  vertex_class_sizes_.resize(polygons.vertex_class_count);
  for (const std::uint32_t c : vertex_class_) {
    ++vertex_class_sizes_[c];
  }
}

Surface Surface::regular(std::uint32_t genus) {
  constexpr std::uint32_t kLargestGenus = 1000;
  if (genus < 2 || genus > kLargestGenus) {
    throw SurfaceError("the genus of a regular 4g-gon must be at least 2 and at most " + std::to_string(kLargestGenus) +
                       ", not " + std::to_string(genus));
  }
  const std::uint32_t n = 4 * genus;
  const Mp1024 half_angle = boost::math::constants::pi<Mp1024>() / n;
  const Mp1024 cot = 1 / tan(half_angle);
  // The circumradius R has cosh R = cot²(π/4g), and a vertex the Euclidean distance tanh(R/2) from 0.
  const Mp1024 radius = sqrt(Mp1024((cot * cot - 1) / (cot * cot + 1)));
  Surface surface;
  surface.regular_ = true;
  surface.genus_ = genus;
  Tile tile;
  for (std::uint32_t k = 0; k < n; ++k) {
    const Mp1024 angle = half_angle * (2 * Mp1024(k) - 1);
    tile.push_back({Rational(Mp256(radius * cos(angle))), Rational(Mp256(radius * sin(angle)))});
    surface.side_tile_.push_back(0);
    surface.partner_.push_back((k + n / 2) % n);
    surface.vertex_class_.push_back(0);
    if (k < n / 2) {
      surface.gluing_.push_back({0, k, 0, k + n / 2});
    }
  }
  surface.tiles_.push_back(std::move(tile));
  surface.first_side_.push_back(0);
  surface.vertex_class_sizes_ = {n};
  return surface;
}

template <class T>
Isometry<T> Surface::crossing_as(std::uint32_t s) const {
  if (!regular_) {
    return normalized(convert<T>(crossing_[s]));
  }
  // The translation by twice the apothem ρ, cosh ρ = cot(π/4g), against the direction of the midpoint of side s.
  const T half_angle = boost::math::constants::pi<T>() / (4 * genus_);
  const T cosine = 1 / tan(half_angle);
  const T sine = -sqrt(T(cosine * cosine - 1));
  const T direction = 2 * half_angle * s;
  return {{cosine, T(0)}, {sine * cos(direction), sine * sin(direction)}};
}

template Isometry<Mp256> Surface::crossing_as<Mp256>(std::uint32_t) const;
template Isometry<Mp1024> Surface::crossing_as<Mp1024>(std::uint32_t) const;
template Isometry<Mp4096> Surface::crossing_as<Mp4096>(std::uint32_t) const;

}  // namespace epsnet
