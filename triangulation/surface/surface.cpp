#include "triangulation/surface/surface.h"

#include <boost/math/constants/constants.hpp>
#include <cassert>
#include <future>
#include <stdexcept>
#include <utility>

#include "triangulation/surface/glued_polygons.h"

namespace epsnet {

Surface::Surface(std::vector<Tile> tiles, std::vector<Gluing> gluing)
    : Surface(checked(std::move(tiles), std::move(gluing))) {}

Surface::Data Surface::checked(std::vector<Tile> tiles, std::vector<Gluing> gluing) {
  Data data;
  data.tiles = std::move(tiles);
  data.gluing = std::move(gluing);
  GluedPolygons polygons(data.tiles, data.gluing);
  polygons.check_vertices();
  polygons.check_convex();
  polygons.check_lengths();
  // Angles take as long as all crossings: side by side with them where there are many.
  constexpr std::size_t kMany = 100;
  const std::vector<std::uint32_t>& partner = polygons.sides().partner;
  std::future<void> angles = std::async(partner.size() > kMany ? std::launch::async : std::launch::deferred,
                                        [&polygons] { polygons.check_angles(); });
  const std::vector<ScaledPoint>& points = polygons.points();
  data.crossing.resize(partner.size());
  for (std::uint32_t s = 0; s < data.crossing.size(); ++s) {
    const std::uint32_t other = partner[s];
    if (other < s) continue;
    data.crossing[s] =
        integral_crossing(points[s], points[polygons.next(s)], points[polygons.next(other)], points[other]);
    data.crossing[other] = inverse(data.crossing[s]);
  }
  angles.get();
  data.genus = polygons.genus();
  data.sides = std::move(polygons).sides();
  return data;
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
  Data data;
  data.regular = true;
  data.genus = genus;
  Tile tile;
  for (std::uint32_t k = 0; k < n; ++k) {
    const Mp1024 angle = half_angle * (2 * Mp1024(k) - 1);
    tile.push_back({Rational(Mp256(radius * cos(angle))), Rational(Mp256(radius * sin(angle)))});
    data.sides.side_tile.push_back(0);
    data.sides.partner.push_back((k + n / 2) % n);
    data.sides.vertex_class.push_back(0);
    if (k < n / 2) {
      data.gluing.push_back({0, k, 0, k + n / 2});
    }
  }
  data.tiles.push_back(std::move(tile));
  data.sides.first_side.push_back(0);
  data.sides.vertex_class_sizes = {n};
  return Surface(std::move(data));
}

const Isometry<Rational>& Surface::crossing(std::uint32_t s) const {
  assert(s < side_count());
  if (is_regular()) {
    throw std::logic_error("the crossings of a regular surface are not rational");
  }
  return data_->crossing[s];
}

Word Surface::corner_cycle(std::uint32_t corner) const {
  Word cycle;
  std::uint32_t s = corner;
  do {
    cycle.push_back(s);
    s = next_side(partner(s));
  } while (s != corner);
  return cycle;
}

template <class T>
Isometry<T> Surface::crossing_as(std::uint32_t s) const {
  assert(s < side_count());
  if (!is_regular()) {
    return normalized(convert<T>(crossing(s)));
  }
  // The translation by twice the apothem ρ, cosh ρ = cot(π/4g), against the direction of the midpoint of side s.
  const T half_angle = boost::math::constants::pi<T>() / (4 * genus());
  const T cosine = 1 / tan(half_angle);
  const T sine = -sqrt(T(cosine * cosine - 1));
  const T direction = 2 * half_angle * s;
  return {{cosine, T(0)}, {sine * cos(direction), sine * sin(direction)}};
}

template Isometry<Mp256> Surface::crossing_as<Mp256>(std::uint32_t) const;
template Isometry<Mp1024> Surface::crossing_as<Mp1024>(std::uint32_t) const;
template Isometry<Mp4096> Surface::crossing_as<Mp4096>(std::uint32_t) const;

}  // namespace epsnet
