#include "triangulation/surface/surface.h"

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cassert>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "kernel/plane.h"
#include "kernel/predicates.h"
#include "triangulation/surface/exact_polygons.h"

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

namespace {

void require_tile(const Surface& surface, TileId tile) {
  const std::size_t tiles = surface.tiles().size();
  if (tile.number() < tiles) return;
  throw SurfaceError("the point is in tile " + to_string(tile) + ", the surface has " + std::to_string(tiles) +
                     (tiles == 1 ? " tile" : " tiles"));
}

/// The first side that the point is not strictly left of.
std::optional<std::size_t> side_not_left_of(const Tile& tile, const Complex<Rational>& z) {
  for (std::size_t k = 0; k < tile.size(); ++k) {
    if (norm(z) >= 1 || orientation_determinant(tile[k], tile[(k + 1) % tile.size()], z) <= 0) {
      return k;
    }
  }
  return std::nullopt;
}

constexpr int kMostTiles = 10'000;

[[noreturn]] void too_far(const BasePoint& point) {
  throw SurfaceError("the point is more than " + std::to_string(kMostTiles) + " tiles away from tile " +
                     to_string(point.tile));
}

/// Leads from tile to tile across the first side beyond which the point lies, as 1,024 bits say, until there is none.
/// Not for a point so near to the unit circle that these are too few.
std::vector<SideId> sides_on_the_way(const Surface& surface, const BasePoint& point) {
  std::vector<SideId> sides;
  TileId tile = point.tile;
  Complex<Mp1024> z = convert<Mp1024>(point.z);
  const Mp1024 slack = ldexp(Mp1024(1), -500);
  if (1 - norm(z) < slack) return sides;
  const auto first_beyond = [&]() -> std::optional<SideId> {
    const Tile& corners = surface.tile(tile);
    for (const SideId s : surface.sides_of(tile)) {
      const std::uint32_t k = surface.place_in_tile(s);
      const auto corner = [&](std::size_t i) { return convert<Mp1024>(corners[i % corners.size()]); };
      if (orientation_determinant(corner(k), corner(k + 1), z) < -slack) return s;
    }
    return std::nullopt;
  };
  while (const std::optional<SideId> beyond = first_beyond()) {
    if (sides.size() == kMostTiles) too_far(point);
    sides.push_back(*beyond);
    z = surface.crossing_as<Mp1024>(*beyond)(z);
    tile = surface.tile_of_side(surface.partner(*beyond));
  }
  return sides;
}

/// The crossing of one side after the other: a tree of products, whose numbers are long at the end only.
Isometry<Rational> crossing_of(const Surface& surface, std::span<const SideId> sides) {
  if (sides.size() == 1) return surface.crossing(sides[0]);
  const std::size_t half = sides.size() / 2;
  return crossing_of(surface, sides.subspan(half)) * crossing_of(surface, sides.first(half));
}

/// A point, and a walk from it across sides of tiles.
///
/// It is n/d for Gaussian integers n and d, as crossings are made of these: around a short curve its coordinates get
/// thousands of digits, and are reduced once, when they are asked for.
class TileWalk {
 public:
  TileWalk(const Surface& surface, const BasePoint& start)
      : surface_(surface), tile_(start.tile), d_{Rational(denominator(start.z.x) * denominator(start.z.y)), 0} {
    n_ = d_ * start.z;
  }

  [[nodiscard]] BasePoint point() const { return {tile_, n_ / d_}; }

  /// At least one side.
  void cross(std::span<const SideId> sides) {
    const Isometry<Rational> g = crossing_of(surface_, sides);
    const Complex<Rational> n = g.a * n_ + g.b * d_;
    d_ = conj(g.b) * n_ + conj(g.a) * d_;
    n_ = n;
    tile_ = surface_.tile_of_side(surface_.partner(sides.back()));
  }

  /// The sides of its tile on which the point lies (sign 0), or beyond which (-1); inside of the others.
  [[nodiscard]] std::vector<SideId> sides_where(int sign) const {
    const Complex<Mp256> rounded = convert<Mp256>(n_) / convert<Mp256>(d_);
    const Mp256 error = ldexp(Mp256(1), -250);  // Of the quotient of numbers that are rounded to 256 bits.
    const Tile& tile = surface_.tile(tile_);
    std::vector<SideId> result;
    for (const SideId s : surface_.sides_of(tile_)) {
      const Complex<Rational>& a = tile[surface_.place_in_tile(s)];
      const Complex<Rational>& b = tile[(surface_.place_in_tile(s) + 1) % tile.size()];
      const StageSign stage = orientation_stage(convert<Mp256>(a), convert<Mp256>(b), rounded, error);
      const int own = stage.certain ? stage.sign : epsnet::sign(orientation_determinant(a, b, point().z));
      if (own == sign) result.push_back(s);
    }
    return result;
  }

 private:
  const Surface& surface_;
  TileId tile_;
  Complex<Rational> d_;
  Complex<Rational> n_;
};

}  // namespace

void require_inside(const Surface& surface, const BasePoint& base) {
  require_tile(surface, base.tile);
  if (const auto side = side_not_left_of(surface.tile(base.tile), base.z)) {
    throw SurfaceError("the base point is not strictly inside of tile " + to_string(base.tile) + ": not left of side " +
                       std::to_string(*side));
  }
}

BasePoint centre_of_tile(const Surface& surface, TileId tile) {
  if (surface.is_regular()) {
    return {tile, {0, 0}};
  }
  require_tile(surface, tile);
  const Tile& vertices = surface.tile(tile);
  Complex<Mp1024> sum;
  for (const Complex<Rational>& vertex : vertices) sum = sum + to_klein(convert<Mp1024>(vertex));
  const Complex<Mp1024> centre = from_klein(Mp1024(Mp1024(1) / vertices.size()) * sum);
  // As few bits as are enough.
  for (int bits = 8;; bits *= 2) {
    const Mp1024 scale = ldexp(Mp1024(1), bits);
    const Complex<Rational> z{Rational(Mp1024(round(Mp1024(centre.x * scale)) / scale)),
                              Rational(Mp1024(round(Mp1024(centre.y * scale)) / scale))};
    if (!side_not_left_of(vertices, z) || bits > 1024) {
      return {tile, z};
    }
  }
}

void require_on_surface(const Surface& surface, const BasePoint& point) {
  require_tile(surface, point.tile);
  if (norm(point.z) >= 1) throw SurfaceError("the point is not inside of the unit disk");
}

BasePoint in_its_tile(const Surface& surface, const BasePoint& point) {
  require_on_surface(surface, point);
  if (!surface.is_rational()) return point;
  // A walk along a line would need more care; this one leads nearer to the tile's inside with each step.
  const std::vector<SideId> sides = sides_on_the_way(surface, point);
  TileWalk walk(surface, point);
  if (!sides.empty()) walk.cross(sides);
  // Exactly: where 1,024 bits were not enough there are more.
  for (std::size_t tiles = sides.size();; ++tiles) {
    const std::vector<SideId> beyond = walk.sides_where(-1);
    if (beyond.empty()) return tiles == 0 ? point : walk.point();
    if (tiles > kMostTiles) too_far(point);
    walk.cross(std::span(beyond).first(1));
  }
}

bool is_same_point(const Surface& surface, const BasePoint& p, const BasePoint& q) {
  const auto equal = [](const BasePoint& a, const BasePoint& b) { return a.tile == b.tile && a.z == b.z; };
  const BasePoint goal = in_its_tile(surface, q);
  // All places that p has in closed tiles: several if it is on a side or a corner.
  std::vector<BasePoint> places{in_its_tile(surface, p)};
  for (std::size_t i = 0; i < places.size() && surface.is_rational(); ++i) {
    const TileWalk here(surface, places[i]);
    for (const SideId s : here.sides_where(0)) {
      TileWalk walk = here;
      walk.cross({&s, 1});
      const BasePoint place = walk.point();
      if (std::none_of(places.begin(), places.end(), [&](const BasePoint& known) { return equal(place, known); })) {
        places.push_back(place);
      }
    }
  }
  return std::any_of(places.begin(), places.end(), [&](const BasePoint& place) { return equal(place, goal); });
}

}  // namespace epsnet
