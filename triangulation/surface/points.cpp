#include "triangulation/surface/points.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/plane.h"
#include "kernel/predicates.h"

namespace epsnet {
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
