#include "netgen/isometries/lifted_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

using Number = LiftedTiles::Number;

/// Lifts of points, as points of the hyperboloid seen from above. Those of one tile that agree to `distance` are the
/// same.
class SeenPoints {
 public:
  explicit SeenPoints(double distance) : distance_(distance) {}

  /// Whether the point is new.
  bool insert(TileId tile, const LorentzVector<double>& point) {
    // Cells are larger, so most points are far from the edge of one, and one look-up is enough.
    for (std::int64_t i = cell(point.x - distance_); i <= cell(point.x + distance_); ++i) {
      for (std::int64_t j = cell(point.y - distance_); j <= cell(point.y + distance_); ++j) {
        const auto [first, last] = points_.equal_range(key(tile, i, j));
        for (auto other = first; other != last; ++other) {
          const auto& [other_tile, x, y] = other->second;
          if (other_tile == tile && std::hypot(x - point.x, y - point.y) < distance_) return false;
        }
      }
    }
    points_.emplace(key(tile, cell(point.x), cell(point.y)), Point{tile, point.x, point.y});
    return true;
  }

 private:
  struct Point {
    TileId tile;
    double x;
    double y;
  };
  [[nodiscard]] std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / (8 * distance_))); }
  static std::uint64_t key(TileId tile, std::int64_t column, std::int64_t row) {
    constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15;
    std::uint64_t result = tile.number();
    for (const std::int64_t part : {column, row}) result = (result ^ static_cast<std::uint64_t>(part)) * kFactor;
    return result ^ (result >> 29);
  }

  double distance_;
  std::unordered_multimap<std::uint64_t, Point> points_;
};

LorentzVector<double> rounded(const LiftedTiles::Vector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.t)};
}

}  // namespace

LiftedTiles::LiftedTiles(const Surface& surface, double shortest)
    : surface_(surface), shortest_(std::clamp(shortest, 1e-5, 1.0)) {
  for (const TileId tile : surface_.tile_ids()) {
    const Tile& corners = surface_.tile(tile);
    const auto corner = [&](std::size_t k) { return on_hyperboloid(convert<Number>(corners[k % corners.size()])); };
    Vector sum;
    for (const SideId s : surface_.sides_of(tile)) {
      const std::size_t k = surface_.place_in_tile(s);
      const Vector start = corner(k);
      const Vector end = corner(k + 1);
      const Vector normal = lorentz_cross(start, end);
      const Number scale = 1 / sqrt(lorentz_product(normal, normal));
      const Isometry<Number> crossing = surface_.crossing_as<Number>(s);
      sides_.push_back({.line = scale * normal,
                        .rounded_line = rounded(scale * normal),
                        .crossing = crossing,
                        .back = convert<DoubleDouble>(inverse(crossing)),
                        .start = rounded(start),
                        .cosh_length = static_cast<double>(-lorentz_product(start, end))});
      sum = sum + (1 / start.t) * start;
    }
    centres_.push_back(Number(1 / sqrt(-lorentz_product(sum, sum))) * sum);
  }
}

Isometry<Number> LiftedTiles::value(const Word& word) const {
  Isometry<Number> result;
  for (const SideId s : word) result = sides_[s].crossing * result;
  return result;
}

Word LiftedTiles::walk(TileId tile, Vector point) const {
  constexpr std::size_t kMostSteps = 100'000;
  constexpr std::size_t kSteps = 1000;  // So many go across the side that is farthest away; others may go in circles.
  const Number nothing = boost::multiprecision::ldexp(Number(-1), -100);
  Word word;
  std::vector<SideId> beyond;
  while (word.size() < kMostSteps) {
    beyond.clear();
    double least = 0;
    SideId farthest(0);
    const LorentzVector<double> rounded_point = rounded(point);
    const double error = 1e-12 * rounded_point.t;
    for (const SideId s : surface_.sides_of(tile)) {
      const double depth = lorentz_product(sides_[s].rounded_line, rounded_point);
      const double size = error * sides_[s].rounded_line.t * sides_[s].rounded_line.t + error;
      if (depth > size || (depth > -size && lorentz_product(sides_[s].line, point) >= nothing)) continue;
      beyond.push_back(s);
      if (depth <= least) {
        least = depth;
        farthest = s;
      }
    }
    if (beyond.empty()) return word;
    const SideId s = word.size() < kSteps && least < 0 ? farthest : beyond[word.size() * 7919 % beyond.size()];
    word.push_back(s);
    point = image(sides_[s].crossing, point);
    tile = surface_.tile_of_side(surface_.partner(s));
  }
  throw LimitError("a walk across more than " + std::to_string(kMostSteps) + " sides does not find its tile");
}

Word LiftedTiles::Elements::word(const Element& element) const {
  Word out = start_;
  const std::size_t length = out.size();
  for (std::uint32_t lift = element.lift; lift != 0; lift = lifts_[lift].before) out.push_back(lifts_[lift].side);
  std::reverse(out.begin() + static_cast<std::ptrdiff_t>(length), out.end());
  // The path out leads to the lift; its value leads back.
  return reversed(*surface_, concatenated(*surface_, out, reversed(*surface_, start_)));
}

LiftedTiles::Elements LiftedTiles::elements(TileId tile, const Vector& point, double radius, std::uint64_t most) const {
  Elements result;
  result.surface_ = &surface_;
  result.start_ = walk(tile, point);
  const TileId home = end_of(tile, result.start_);
  const Isometry<Number> to_point = normalized(Isometry<Number>::translation(in_disk(point)));
  const Isometry<Number> home_frame = value(result.start_) * to_point;
  const auto to_home = convert<DoubleDouble>(home_frame);
  // Two lifts of a centre are farther apart than this, also as seen from above.
  SeenPoints seen(shortest_ / 4);
  const double cosh_radius = std::cosh(radius) * (1 + 1e-9) + 1e-9;
  ById<TileId, LorentzVector<double>> centres;
  for (const Vector& c : centres_) centres.push_back(rounded(c));
  const auto add = [&](const Isometry<DoubleDouble>& frame, TileId of, std::uint32_t before, SideId side) {
    if (!seen.insert(of, image(convert<double>(frame), centres[of]))) return;
    if (result.lifts_.size() >= most) {
      throw LimitError("more than " + std::to_string(most) + " tiles are nearer than " + std::to_string(radius) +
                       " to a point");
    }
    const auto number = static_cast<std::uint32_t>(result.lifts_.size());
    result.lifts_.push_back({frame, of, before, side});
    if (of != home) return;
    const auto element = convert<double>(frame * to_home);
    if (norm(element.a) + norm(element.b) <= cosh_radius) result.list_.push_back({element, number});
  };
  add(convert<DoubleDouble>(inverse(home_frame)), home, 0, SideId(0));
  for (std::size_t i = 0; i < result.lifts_.size(); ++i) {
    const Elements::Lift lift = result.lifts_[i];
    const auto frame = convert<double>(lift.frame);
    const double height = norm(frame.a) + norm(frame.b);
    // The t of the image of a vector. Of a point it is the cosh of its distance from 0, of a normal the sinh.
    const auto height_of = [&](const LorentzVector<double>& v) {
      return height * v.t + 2 * dot(frame.b, frame.a * Complex<double>{v.x, v.y});
    };
    const auto is_near = [&](const Side& side, double start, double end) {
      if (std::min(start, end) <= cosh_radius) return true;
      // The line is nearer than both ends only if its foot is between them.
      if (end >= side.cosh_length * start || start >= side.cosh_length * end) return false;
      return std::hypot(1, height_of(side.rounded_line)) <= cosh_radius;
    };
    const SideId first = surface_.side_number(lift.tile, 0);
    const double first_height = height_of(sides_[first].start);
    double start = first_height;
    for (const SideId s : surface_.sides_of(lift.tile)) {
      const SideId next = surface_.next_side(s);
      const double end = next != first ? height_of(sides_[next].start) : first_height;
      const Side& side = sides_[s];
      if (is_near(side, start, end)) {
        const TileId across = surface_.tile_of_side(surface_.partner(s));
        add(lift.frame * side.back, across, static_cast<std::uint32_t>(i), s);
      }
      start = end;
    }
  }
  return result;
}

}  // namespace epsnet
