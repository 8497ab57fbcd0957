#include "netgen/isometries/line_places.h"

#include <algorithm>
#include <cmath>

#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

using Number = LiftedTiles::Number;
using Vector = LiftedTiles::Vector;

/// Two lines of one tile of which the numbers to look them up by differ by more are different.
constexpr double kNear = 1e-9;

Vector unit(const Vector& normal) { return Number(1 / sqrt(lorentz_product(normal, normal))) * normal; }

/// The point that is `along` farther on a line with a unit normal.
Vector farther(const Vector& point, const Vector& normal, const Number& along) {
  const Vector moved = Number(cosh(along)) * point + Number(sinh(along)) * lorentz_cross(point, normal);
  return Number(1 / sqrt(-lorentz_product(moved, moved))) * moved;
}

}  // namespace

LinePlaces::LinePlaces(const LiftedTiles& tiles, const std::vector<Line>& lines)
    : tiles_(tiles), from_tile_0_(polygon_paths(tiles.surface())) {
  for (std::uint32_t i = 0; i < lines.size(); ++i) follow(lines[i], i);
}

void LinePlaces::add(TileId tile, const Vector& normal, std::uint32_t number) {
  known_[tile].emplace(std::abs(static_cast<double>(normal.x)), Known{normal, number});
}

std::optional<std::uint32_t> LinePlaces::find(TileId tile, const Vector& normal) const {
  const auto known = known_.find(tile);
  if (known == known_.end()) return std::nullopt;
  const double key = std::abs(static_cast<double>(normal.x));
  const Vector other_side = Number(-1) * normal;
  const auto last = known->second.upper_bound(key + kNear);
  for (auto place = known->second.lower_bound(key - kNear); place != last; ++place) {
    const Vector& other = place->second.normal;
    if (agree(normal, other) || agree(other_side, other)) return place->second.line;
  }
  return std::nullopt;
}

void LinePlaces::follow(const Line& line, std::uint32_t number) {
  // The next part begins so far behind the side where one ends; shorter parts, near corners, are left out.
  const Number step = boost::multiprecision::ldexp(Number(1), -40);
  const Number nothing = boost::multiprecision::ldexp(Number(1), -80);
  TileId tile = line.tile;
  Vector normal = unit(axis_normal(line.element));
  Vector point = line.point(tiles_.centre(tile), 0);
  Number followed = 0;
  Number longest = 0;
  middle_.push_back({tile, normal, point});
  while (followed < line.length) {
    const Word way = tiles_.walk(tile, point);
    const Isometry<Number> moved = tiles_.value(way);
    tile = tiles_.end_of(tile, way);
    normal = unit(epsnet::image(moved, normal));
    point = epsnet::image(moved, point);
    add(tile, normal, number);
    const Vector direction = lorentz_cross(point, normal);
    std::optional<Number> tanh_to_end;
    for (const SideId s : tiles_.surface().sides_of(tile)) {
      const Number slope = lorentz_product(tiles_.line(s), direction);
      const Number depth = lorentz_product(tiles_.line(s), point);
      if (slope < -nothing) {
        const Number tanh_to_side = std::max(Number(0), Number(-depth / slope));
        if (!tanh_to_end || tanh_to_side < *tanh_to_end) tanh_to_end = tanh_to_side;
      } else if (slope <= nothing && abs(depth) <= nothing) {
        // It runs along a side.
        const SideId across = tiles_.surface().partner(s);
        add(tiles_.surface().tile_of_side(across), epsnet::image(tiles_.crossing(s), normal), number);
      }
    }
    if (!tanh_to_end || *tanh_to_end >= 1) return;
    const Number length = atanh(*tanh_to_end);
    if (length > longest) {
      longest = length;
      // Not the half, where a symmetry may have a corner.
      middle_.back() = {tile, normal, farther(point, normal, length * 0.4142)};
    }
    followed += length + step;
    point = farther(point, normal, length + step);
  }
}

std::optional<std::uint32_t> LinePlaces::image(const Motion<Number>& f, std::uint32_t i) const {
  const Place& place = middle_[i];
  const Motion<Number> g = f * motion(tiles_.value(reversed(tiles_.surface(), from_tile_0_[place.tile])));
  const Word way = tiles_.walk(TileId(0), g(place.point));
  return find(tiles_.end_of(TileId(0), way), unit(epsnet::image(tiles_.value(way), g(place.normal))));
}

}  // namespace epsnet
