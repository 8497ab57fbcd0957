#include "netgen/isometries/lifted_tiles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include "triangulation/surface/surface.h"

namespace epsnet {
namespace {

using Number = LiftedTiles::Number;
using Vector = LiftedTiles::Vector;

/// Lifts of points, as points of the hyperboloid seen from above. Those of one cell that agree to `distance` are the
/// same.
class SeenPoints {
 public:
  explicit SeenPoints(double distance) : distance_(distance) {}

  /// Whether the point is new.
  bool insert(std::uint32_t cell, const LorentzVector<double>& point) {
    // Boxes are larger, so most points are far from the edge of one, and one look-up is enough.
    for (std::int64_t i = box(point.x - distance_); i <= box(point.x + distance_); ++i) {
      for (std::int64_t j = box(point.y - distance_); j <= box(point.y + distance_); ++j) {
        const auto [first, last] = points_.equal_range(key(cell, i, j));
        for (auto other = first; other != last; ++other) {
          const auto& [other_cell, x, y] = other->second;
          if (other_cell == cell && std::hypot(x - point.x, y - point.y) < distance_) return false;
        }
      }
    }
    points_.emplace(key(cell, box(point.x), box(point.y)), Point{cell, point.x, point.y});
    return true;
  }

 private:
  struct Point {
    std::uint32_t cell;
    double x;
    double y;
  };
  [[nodiscard]] std::int64_t box(double x) const { return static_cast<std::int64_t>(std::floor(x / (8 * distance_))); }
  static std::uint64_t key(std::uint32_t cell, std::int64_t column, std::int64_t row) {
    constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15;
    std::uint64_t result = cell;
    for (const std::int64_t part : {column, row}) result = (result ^ static_cast<std::uint64_t>(part)) * kFactor;
    return result ^ (result >> 29);
  }

  double distance_;
  std::unordered_multimap<std::uint64_t, Point> points_;
};

Isometry<DoubleDouble> to_double_double(const Isometry<Number>& f) { return convert<DoubleDouble>(convert<Mp256>(f)); }

std::vector<Vector> corners_of(const Surface& surface, TileId tile) {
  std::vector<Vector> result;
  for (const auto& corner : surface.tile(tile)) result.push_back(on_hyperboloid(convert<Number>(corner)));
  return result;
}

/// The unit normal of the line through two points, positive on its left.
Vector line_through(const Vector& start, const Vector& end) {
  const Vector normal = lorentz_cross(start, end);
  return Number(1 / sqrt(lorentz_product(normal, normal))) * normal;
}

double longest_side(const std::vector<Vector>& corners) {
  double cosh_length = 1;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Number product = -lorentz_product(corners[k], corners[(k + 1) % corners.size()]);
    cosh_length = std::max(cosh_length, static_cast<double>(product));
  }
  return std::acosh(cosh_length);
}

}  // namespace

LiftedTiles::LiftedTiles(const Surface& surface) : surface_(surface) {
  for (const TileId tile : surface_.tile_ids()) {
    const std::vector<Vector> corners = corners_of(surface_, tile);
    Vector sum;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vector line = line_through(corners[k], corners[(k + 1) % corners.size()]);
      const SideId s = surface_.side_number(tile, static_cast<std::uint32_t>(k));
      sides_.push_back(
          {.line = line, .rounded_line = rounded(line), .crossing = convert<Number>(surface_.crossing_as<Mp1024>(s))});
      sum = sum + (1 / corners[k].t) * corners[k];
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

ElementSearch::ElementSearch(const Surface& surface, double shortest)
    : tiles_(surface), shortest_(std::clamp(shortest, 1e-5, 1.0)) {
  find_domain();
  if (!domain_) add_tiles();
}

void ElementSearch::add_cell(const Vector& centre, const std::vector<Vector>& corners) {
  const auto first_side = static_cast<std::uint32_t>(cell_sides_.size());
  const auto end_side = static_cast<std::uint32_t>(first_side + corners.size());
  cells_.push_back({rounded(centre), first_side, end_side});
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vector& start = corners[k];
    const Vector& end = corners[(k + 1) % corners.size()];
    CellSide& side = cell_sides_.emplace_back();
    side.line = rounded(line_through(start, end));
    side.start = rounded(start);
    side.cosh_length = static_cast<double>(-lorentz_product(start, end));
  }
}

void ElementSearch::add_tiles() {
  for (const TileId tile : tiles_.surface().tile_ids()) {
    add_cell(tiles_.centre(tile), corners_of(tiles_.surface(), tile));
    for (const SideId s : tiles_.surface().sides_of(tile)) {
      CellSide& side = cell_sides_[s.number()];
      side.across = tiles_.surface().tile_of_side(tiles_.surface().partner(s)).number();
      side.back = to_double_double(inverse(tiles_.crossing(s)));
      side.way = {s};
    }
  }
}

void ElementSearch::find_domain() {
  constexpr double kLong = 8;
  const Surface& surface = tiles_.surface();
  double longest = 0;
  for (const TileId tile : surface.tile_ids()) longest = std::max(longest, longest_side(corners_of(surface, tile)));
  if (longest < kLong) return;
  try {
    const DirichletPolygon polygon = dirichlet_polygon(surface, std::nullopt);
    DomainFrame domain(surface, polygon);
    std::vector<Vector> corners;
    Number cosh_radius(1);
    for (const Complex<Mp1024>& z : domain.vertices()) {
      corners.push_back(on_hyperboloid(convert<Number>(z)));
      cosh_radius = std::max(cosh_radius, corners.back().t);
    }
    // Where curves are short the domain is long, too.
    if (longest < 4 * std::acosh(static_cast<double>(cosh_radius))) return;
    add_cell({Number(0), Number(0), Number(1)}, corners);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      cell_sides_[k].back = to_double_double(convert<Number>(domain.pairings()[k]));
      cell_sides_[k].way = reversed(surface, polygon.sides[k].word);
    }
    domain_ = std::move(domain);
  } catch (const Error&) {  // Tiles do as well, in more time.
  }
}

Word ElementSearch::way_to_domain(TileId tile, const Complex<Mp1024>& point) const {
  Word way = path_between_tiles(tiles_.surface(), tile, domain_->tile());
  const auto sides = domain_->walk(domain_->from_tile()(isometry_of(tiles_.surface(), way)(point)));
  if (!sides) throw LimitError("a point is too far from the Dirichlet domain");
  for (const std::uint32_t k : *sides) way = concatenated(tiles_.surface(), std::move(way), cell_sides_[k].way);
  return way;
}

Word ElementSearch::Elements::way(std::uint32_t lift) const {
  std::vector<std::uint32_t> crossed;
  for (; lift != 0; lift = lifts_[lift].before) crossed.push_back(lifts_[lift].side);
  Word out = start_;
  for (auto side = crossed.rbegin(); side != crossed.rend(); ++side) {
    out = concatenated(search_->tiles().surface(), std::move(out), search_->cell_sides_[*side].way);
  }
  return out;
}

Word ElementSearch::Elements::word(const Element& element) const {
  const Surface& surface = search_->tiles().surface();
  // The path out leads to the lift; its value leads back.
  return reversed(surface, concatenated(surface, way(element.lift), reversed(surface, start_)));
}

std::optional<ById<TileId, std::vector<ElementSearch::Elements::TileLift>>> ElementSearch::Elements::tile_lifts()
    const {
  if (search_->domain_) return std::nullopt;
  ById<TileId, std::vector<TileLift>> result(search_->cells_.size());
  for (std::uint32_t i = 0; i < lifts_.size(); ++i) {
    result[TileId(lifts_[i].cell)].push_back({convert<double>(lifts_[i].frame), i});
  }
  return result;
}

ElementSearch::Elements ElementSearch::elements(TileId tile, const Vector& point, double radius,
                                                std::uint64_t most) const {
  Elements result;
  result.search_ = this;
  std::uint32_t home = 0;
  Isometry<Number> to_home;
  if (domain_) {
    result.start_ = way_to_domain(tile, convert<Mp1024>(in_disk(point)));
    to_home = convert<Number>(domain_->from_tile()) * tiles_.value(result.start_);
  } else {
    result.start_ = tiles_.walk(tile, point);
    home = tiles_.end_of(tile, result.start_).number();
    to_home = tiles_.value(result.start_);
  }
  const Isometry<Number> home_frame = to_home * normalized(Isometry<Number>::translation(in_disk(point)));
  const auto rounded_home_frame = to_double_double(home_frame);
  // Two lifts of a centre are farther apart than this, also as seen from above.
  SeenPoints seen(shortest_ / 4);
  const double cosh_radius = std::cosh(radius) * (1 + 1e-9) + 1e-9;
  const auto add = [&](const Isometry<DoubleDouble>& frame, std::uint32_t of, std::uint32_t before,
                       std::uint32_t side) {
    if (!seen.insert(of, image(convert<double>(frame), cells_[of].centre))) return;
    if (result.lifts_.size() >= most) {
      throw LimitError("more than " + std::to_string(most) + " tiles are nearer than " + std::to_string(radius) +
                       " to a point");
    }
    const auto number = static_cast<std::uint32_t>(result.lifts_.size());
    result.lifts_.push_back({frame, of, before, side});
    if (of != home) return;
    const auto element = convert<double>(frame * rounded_home_frame);
    if (norm(element.a) + norm(element.b) <= cosh_radius) result.list_.push_back({element, number});
  };
  add(to_double_double(inverse(home_frame)), home, 0, 0);
  for (std::size_t i = 0; i < result.lifts_.size(); ++i) {
    const Elements::Lift lift = result.lifts_[i];
    const auto frame = convert<double>(lift.frame);
    const double height = norm(frame.a) + norm(frame.b);
    // The t of the image of a vector. Of a point it is the cosh of its distance from 0, of a normal the sinh.
    const auto height_of = [&](const LorentzVector<double>& v) {
      return height * v.t + 2 * dot(frame.b, frame.a * Complex<double>{v.x, v.y});
    };
    const auto is_near = [&](const CellSide& side, double start, double end) {
      if (std::min(start, end) <= cosh_radius) return true;
      // The line is nearer than both ends only if its foot is between them.
      if (end >= side.cosh_length * start || start >= side.cosh_length * end) return false;
      return std::hypot(1, height_of(side.line)) <= cosh_radius;
    };
    const Cell& cell = cells_[lift.cell];
    const double first_height = height_of(cell_sides_[cell.first_side].start);
    double start = first_height;
    for (std::uint32_t s = cell.first_side; s != cell.end_side; ++s) {
      const double end = s + 1 != cell.end_side ? height_of(cell_sides_[s + 1].start) : first_height;
      const CellSide& side = cell_sides_[s];
      if (is_near(side, start, end)) add(lift.frame * side.back, side.across, static_cast<std::uint32_t>(i), s);
      start = end;
    }
  }
  return result;
}

}  // namespace epsnet
