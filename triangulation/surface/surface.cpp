#include "triangulation/surface/surface.h"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <cassert>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "triangulation/surface/glued_polygons.h"

namespace epsnet {

namespace {

/// Directions to the sides of regular tiles, computed once to each precision, which takes far longer than a product.
class RegularDirections {
 public:
  explicit RegularDirections(RegularTile tile) : tile_(tile) {}

  /// Those of a tile, for as long as no other tile is asked for.
  static std::shared_ptr<RegularDirections> of(RegularTile tile) {
    static std::mutex mutex;
    static std::shared_ptr<RegularDirections> last;
    const std::scoped_lock lock(mutex);
    if (!last || last->tile_ != tile) last = std::make_shared<RegularDirections>(tile);
    return last;
  }

  template <class T>
  struct Values {
    std::array<T, 2> sizes;  ///< cosh ρ and sinh ρ of the apothem ρ.
    Complex<T> first;
    Complex<T> second;
  };
  /// The apothem, and e^{iπm/2p} for two integers m. Threads may call it at the same time.
  template <class T>
  [[nodiscard]] Values<T> get(const std::array<std::int64_t, 2>& quarters) {
    const std::scoped_lock lock(mutex_);
    Known<T>& known = std::get<Known<T>>(known_);
    if (!known.sizes) {
      const T& pi = boost::math::constants::pi<T>();
      const T cosine = cos(T(pi / tile_.q)) / sin(T(pi / tile_.p));
      known.sizes = {cosine, sqrt(T(cosine * cosine - 1))};
    }
    return {*known.sizes, direction(known, quarters[0]), direction(known, quarters[1])};
  }

 private:
  template <class T>
  struct Known {
    std::optional<std::array<T, 2>> sizes;
    std::map<std::int64_t, Complex<T>> directions;
  };

  template <class T>
  [[nodiscard]] const Complex<T>& direction(Known<T>& known, std::int64_t quarters) const {
    const auto [place, is_new] = known.directions.try_emplace(quarters);
    if (!is_new) return place->second;
    const std::int64_t p = tile_.p;
    // Exact where it can be.
    if (quarters % (2 * p) == 0) return place->second = {quarters % (4 * p) == 0 ? T(1) : T(-1), T(0)};
    const T angle = boost::math::constants::pi<T>() * quarters / (2 * p);
    return place->second = {cos(angle), sin(angle)};
  }

  RegularTile tile_;
  std::mutex mutex_;
  std::tuple<Known<Mp256>, Known<Mp1024>, Known<Mp4096>> known_;
};

}  // namespace

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
  // Angles take as long as all crossings: side by side with them where there are many, and threads.
  constexpr std::size_t kMany = 100;
  const ById<SideId, SideId>& partner = polygons.sides().partner;
  std::future<void> angles =
      std::async(partner.size() > kMany ? std::launch::async | std::launch::deferred : std::launch::deferred,
                 [&polygons] { polygons.check_angles(); });
  const ById<SideId, ScaledPoint>& points = polygons.points();
  data.crossing.resize(partner.size());
  for (const SideId s : partner.ids()) {
    const SideId other = partner[s];
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

Surface Surface::map(RegularTile tile, std::vector<Gluing> gluing) {
  constexpr std::uint32_t kMost = 10'000;
  const auto [p, q] = tile;
  const std::string type = "{" + std::to_string(p) + ", " + std::to_string(q) + "}";
  if (p < 3 || q < 3 || p > kMost || q > kMost) {
    throw SurfaceError("p and q must be at least 3 and at most " + std::to_string(kMost) + ", not " + type);
  }
  if ((p - 2) * (q - 2) <= 4) throw SurfaceError("there is no hyperbolic map of type " + type);
  if (gluing.empty() || 2 * gluing.size() % p != 0) {
    throw SurfaceError(std::to_string(2 * gluing.size()) +
                       " sides are glued, expected a multiple of p = " + std::to_string(p));
  }
  // The circumradius R has cosh R = cot(π/p) cot(π/q), and a vertex the Euclidean distance tanh(R/2) from 0.
  const Mp1024 half_angle = boost::math::constants::pi<Mp1024>() / p;
  const Mp1024 cosh = Mp1024(1 / tan(half_angle)) * Mp1024(1 / tan(Mp1024(boost::math::constants::pi<Mp1024>() / q)));
  const Mp1024 radius = sqrt(Mp1024((cosh - 1) / (cosh + 1)));
  Tile polygon;
  for (std::uint32_t k = 0; k < p; ++k) {
    const Mp1024 angle = half_angle * (2 * Mp1024(k) - 1);
    polygon.push_back({Rational(Mp256(radius * cos(angle))), Rational(Mp256(radius * sin(angle)))});
  }
  Data data;
  data.regular_tile = tile;
  data.tiles.assign(2 * gluing.size() / p, polygon);
  data.gluing = std::move(gluing);
  GluedPolygons polygons(data.tiles, data.gluing);
  data.genus = polygons.genus();
  data.sides = std::move(polygons).sides();
  for (const SideId corner : data.sides.partner.ids()) {
    const std::uint32_t corners = data.sides.vertex_class_sizes[data.sides.vertex_class[corner]];
    if (corners == q) continue;
    throw SurfaceError(std::to_string(corners) + " corners meet at vertex " +
                       std::to_string(data.sides.place_in_tile(corner)) + " of tile " +
                       to_string(data.sides.side_tile[corner]) + ", expected q = " + std::to_string(q));
  }
  return Surface(std::move(data));
}

Surface Surface::regular(std::uint32_t genus) {
  constexpr std::uint32_t kLargestGenus = 1000;
  if (genus < 2 || genus > kLargestGenus) {
    throw SurfaceError("the genus of a regular 4g-gon must be at least 2 and at most " + std::to_string(kLargestGenus) +
                       ", not " + std::to_string(genus));
  }
  std::vector<Gluing> gluing;
  for (std::uint32_t k = 0; k < 2 * genus; ++k) gluing.push_back({0, k, 0, k + 2 * genus});
  return map({4 * genus, 4 * genus}, std::move(gluing));
}

Surface Surface::over_field(std::shared_ptr<const FieldTiles> exact, std::vector<Tile> tiles,
                            std::vector<Gluing> gluing, ById<SideId, Isometry<Mp4096>> crossings) {
  Data data;
  data.field_tiles = std::move(exact);
  data.tiles = std::move(tiles);
  data.gluing = std::move(gluing);
  GluedPolygons polygons(data.tiles, data.gluing);
  polygons.check_vertices();
  polygons.check_convex();
  data.genus = polygons.genus();
  data.sides = std::move(polygons).sides();
  data.field_crossing = std::move(crossings);
  return Surface(std::move(data));
}

bool Surface::is_regular_polygon() const {
  const std::uint32_t sides = 4 * genus();
  if (!is_regular() || *regular_tile() != RegularTile{sides, sides}) return false;
  for (std::uint32_t k = 0; k < sides; ++k) {
    if (partner(SideId(k)) != SideId((k + sides / 2) % sides)) return false;
  }
  return true;
}

const Isometry<Rational>& Surface::crossing(SideId s) const {
  assert(s.number() < side_count());
  if (!is_rational()) throw std::logic_error("the crossings of these tiles are not rational");
  return data_->crossing[s];
}

Word Surface::corner_cycle(SideId corner) const {
  Word cycle;
  SideId s = corner;
  do {
    cycle.push_back(s);
    s = next_side(partner(s));
  } while (s != corner);
  return cycle;
}

template <class T>
Isometry<T> Surface::crossing_as(SideId s) const {
  assert(s.number() < side_count());
  if (is_rational()) return normalized(convert<T>(crossing(s)));
  if (field_tiles()) return convert<T>(data_->field_crossing[s]);
  // From side k to side l of regular tiles: the translation by twice the apothem ρ against the direction of the
  // midpoint of k, cosh ρ = cos(π/q)/sin(π/p); then the turn that takes this direction to that of l.
  const std::int64_t p = regular_tile()->p;
  const std::int64_t k = place_in_tile(s);
  const std::int64_t other = place_in_tile(partner(s));
  const std::int64_t l = other + (other < k ? p : 0);
  const auto [sizes, outward, around] =
      RegularDirections::of(*regular_tile())->get<T>({2 * l - 2 * k - p, 2 * l + 2 * k + p});
  return {sizes[0] * outward, sizes[1] * around};
}

template Isometry<Mp256> Surface::crossing_as<Mp256>(SideId) const;
template Isometry<Mp1024> Surface::crossing_as<Mp1024>(SideId) const;
template Isometry<Mp4096> Surface::crossing_as<Mp4096>(SideId) const;

}  // namespace epsnet
