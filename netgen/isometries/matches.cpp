#include "netgen/isometries/matches.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "certify/numbers/parallel.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

using Number = LiftedTiles::Number;
using Vector = LiftedTiles::Vector;

constexpr std::uint64_t kMostTiles = 2'000'000;

}  // namespace

bool agree(const Number& x, const Number& y, double tolerance) { return abs(x - y) <= tolerance * Number(1 + abs(x)); }

bool agree(const Vector& u, const Vector& v) { return agree(u.x, v.x) && agree(u.y, v.y) && agree(u.t, v.t); }

Vector Line::point(const Vector& near, const Number& along) const {
  const Vector normal = axis_normal(element);
  const Vector unit = Number(1 / sqrt(lorentz_product(normal, normal))) * normal;
  const Vector foot = near + Number(-lorentz_product(unit, near)) * unit;
  const Vector start = Number(1 / sqrt(-lorentz_product(foot, foot))) * foot;
  return Number(cosh(along)) * start + Number(sinh(along)) * lorentz_cross(start, unit);
}

namespace {

/// How many points of a closed geodesic are tried, at equal distances of about 1 at most.
std::uint32_t point_count(const Number& length) { return static_cast<std::uint32_t>(ceil(length)); }

/// The sum of (Re a)(Re a') and so on: half the trace of f ∘ g.
template <class T>
T half_trace_of_product(const Isometry<T>& f, const Isometry<T>& g) {
  return f.a.x * g.a.x - f.a.y * g.a.y + f.b.x * g.b.x + f.b.y * g.b.y;
}

}  // namespace

std::vector<Line> lines(const LiftedTiles& tiles, const certify::GeodesicsDocument& document) {
  std::vector<Line> result;
  for (const auto& geodesic : document.geodesics) {
    const TileId tile(document.net.charts[document.net.vertices[geodesic.vertex].chart].tile);
    Word word = word_of_letters(geodesic.word);
    const Isometry<Number> element = normalized(tiles.value(word));
    result.push_back({tile, std::move(word), element, displacement_length(element)});
  }
  return result;
}

namespace {

/// Of telling isometries by a pair, if so many geodesics are as long as x.
double cost_of(const Pair& pair, std::size_t geodesics) {
  return static_cast<double>(geodesics * point_count(pair.x.length)) *
         std::exp(pair.displacement + static_cast<double>(pair.x.length) / point_count(pair.x.length));
}

/// Whether an element takes a line through 0 to itself or to one that has an end in common with it.
bool keeps_line(const Isometry<double>& element, const LorentzVector<double>& normal) {
  const LorentzVector<double> other = axis_normal(element);
  const double size = std::sqrt(std::abs(lorentz_product(other, other)));
  const LorentzVector<double> across = lorentz_cross(normal, other);
  return std::abs(lorentz_product(across, across)) < 1e-6 * size * size;
}

/// Returns a pair of a closed geodesic and the element that moves one of its points least, by at most `radius`, among
/// those that do not keep the axis.
std::optional<Pair> pair_of(const ElementSearch& search, const Line& x, double radius) {
  const LiftedTiles& tiles = search.tiles();
  std::optional<Pair> best;
  const std::uint32_t count = point_count(x.length);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector point = x.point(tiles.centre(x.tile), x.length * i / count);
    const Isometry<Number> base = normalized(Isometry<Number>::translation(in_disk(point)));
    const LorentzVector<double> n = axis_normal(convert<double>(inverse(base) * x.element * base));
    const LorentzVector<double> normal = (1 / std::sqrt(lorentz_product(n, n))) * n;
    const auto near = search.elements(x.tile, point, radius, kMostTiles);
    for (const auto& element : near.list()) {
      const double displacement = 2 * std::asinh(std::sqrt(norm(element.isometry.b)));
      if (displacement < 1e-6 || (best && displacement >= best->displacement - 1e-9)) continue;
      if (keeps_line(element.isometry, normal)) continue;
      Word word = near.word(element);
      const Isometry<Number> y = normalized(tiles.value(word));
      best = Pair{x, y, std::move(word), displacement};
    }
  }
  return best;
}

/// Returns the pair from which isometries are told with the least work.
Pair cheapest_pair(const ElementSearch& search, const std::vector<Line>& lines) {
  constexpr std::size_t kMostTried = 12;
  constexpr double kStep = 0.5;
  const Number kShort(0.25);
  // Geodesics of equal lengths are often equivalent, so one of each length is tried.
  struct Tried {
    const Line* line;
    std::size_t count;  ///< Of geodesics of this length.
  };
  std::vector<Tried> tried;
  for (const Line& line : lines) {
    // Loops across thin parts are long.
    if (line.length < kShort && lines.back().length >= kShort) continue;
    if (!tried.empty() && agree(tried.back().line->length, line.length)) {
      ++tried.back().count;
    } else if (tried.size() < kMostTried) {
      tried.push_back({&line, 1});
    } else {
      break;
    }
  }
  std::optional<Pair> best;
  double least = std::numeric_limits<double>::infinity();
  // A pair that is found later costs more than e^radius.
  for (double radius = 1; std::exp(radius) < least; radius += kStep) {
    for (Tried& one : tried) {
      if (one.line == nullptr) continue;
      std::optional<Pair> pair = pair_of(search, *one.line, radius);
      if (!pair) continue;
      one.line = nullptr;
      if (const double cost = cost_of(*pair, one.count); cost < least) {
        least = cost;
        best = std::move(pair);
      }
    }
  }
  return *std::move(best);
}

}  // namespace

namespace {

/// The matches whose y' moves one of the `count` points of a line.
std::vector<Match> matches_near(const ElementSearch& search, const Line& line, const Pair& pair, std::uint32_t i,
                                std::uint32_t count, double tolerance) {
  const LiftedTiles& tiles = search.tiles();
  std::vector<Match> result;
  const Number half_trace = half_trace_of_product(pair.x.element, pair.y);
  const double rough = 1e-5 + 2 * tolerance;
  const auto is_near = [&](double x, double y) { return std::abs(x - y) <= rough * (1 + std::abs(y)); };
  const double radius = pair.displacement + static_cast<double>(line.length) / count + 1e-6 + 10 * tolerance;
  const Vector point = line.point(tiles.centre(line.tile), line.length * i / count);
  const auto near = search.elements(line.tile, point, radius, kMostTiles);
  const Isometry<Number> base = Isometry<Number>::translation(in_disk(point));
  const Isometry<double> x = convert<double>(normalized(inverse(base) * line.element * base));
  for (const auto& element : near.list()) {
    const Isometry<double>& y = element.isometry;
    if (!is_near(std::abs(y.a.x), static_cast<double>(pair.y.a.x))) continue;
    const double sign = y.a.x < 0 ? -1 : 1;
    for (const bool forward : {true, false}) {
      if (!is_near(sign * half_trace_of_product(forward ? x : inverse(x), y), static_cast<double>(half_trace))) {
        continue;
      }
      const Isometry<Number> x2 = forward ? line.element : inverse(line.element);
      Word word = near.word(element);
      const Isometry<Number> y2 = normalized(tiles.value(word));
      if (!agree(y2.a.x, pair.y.a.x, tolerance) || !agree(half_trace_of_product(x2, y2), half_trace, tolerance)) {
        continue;
      }
      Word x_word = forward ? line.word : reversed(tiles.surface(), line.word);
      result.push_back({line.tile, x2, y2, std::move(x_word), std::move(word)});
    }
  }
  return result;
}

}  // namespace

std::vector<Match> matches(const ElementSearch& search, const Line& line, const Pair& pair, unsigned threads,
                           double tolerance) {
  if (!agree(line.element.a.x, pair.x.element.a.x, tolerance)) return {};
  const std::uint32_t count = point_count(line.length);
  std::vector<std::vector<Match>> found(count);
  certify::for_each_parallel(count, threads, [&](unsigned, std::size_t i) {
    found[i] = matches_near(search, line, pair, static_cast<std::uint32_t>(i), count, tolerance);
  });
  std::vector<Match> result;
  for (std::vector<Match>& some : found) {
    result.insert(result.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  }
  return result;
}

Generators::Generators(const LiftedTiles& tiles) {
  const FundamentalPolygon polygon = fundamental_polygon(tiles.surface());
  for (std::uint32_t k = 0; k < polygon.sides.size(); ++k) {
    if (k > polygon.sides[k].partner) continue;
    words.push_back(polygon.sides[k].word);
    elements.push_back(tiles.value(words.back()));
  }
}

namespace {

/// A word from tile 0 to itself for one from another tile to itself.
Word from_tile_0(const Surface& surface, TileId tile, const Word& word) {
  const Word way = path_between_tiles(surface, TileId(0), tile);
  return concatenated(surface, concatenated(surface, way, word), reversed(surface, way));
}

}  // namespace

std::optional<Word> image_word(const LiftedTiles& to, const Motion<Number>& f, const Isometry<Number>& element,
                               double tolerance) {
  const Isometry<Number> image_of = conjugated(f, element);
  Word way = to.walk(TileId(0), image(image_of, to.centre(TileId(0))));
  if (to.end_of(TileId(0), way) != TileId(0)) return std::nullopt;
  const Isometry<Number> rest = to.value(way) * image_of;
  for (const Number& part : {rest.a.y, rest.b.x, rest.b.y}) {
    if (!agree(part, 0, tolerance)) return std::nullopt;
  }
  return concatenated(to.surface(), {}, reversed(to.surface(), way));
}

Source::Source(const Surface& surface, const certify::GeodesicsDocument& geodesics)
    : search(surface, geodesics.geodesics.front().length.lower),
      generators(tiles()),
      pair(cheapest_pair(search, lines(tiles(), geodesics))) {}

Motion<Number> Source::motion_of(const Match& match, const LiftedTiles& to) const {
  const Motion<Number> f = motion_of_pairs(pair.x.element, pair.y, match.x, match.y);
  // By the paths of from_tile_0: between two tiles there may be several shortest ones.
  return motion(to.value(reversed(to.surface(), path_between_tiles(to.surface(), TileId(0), match.tile)))) * f *
         motion(tiles().value(path_between_tiles(tiles().surface(), TileId(0), pair.x.tile)));
}

std::optional<std::vector<Word>> Source::images(const LiftedTiles& to, const Motion<Number>& f,
                                                double tolerance) const {
  std::vector<Word> result;
  for (const Isometry<Number>& element : generators.elements) {
    std::optional<Word> word = image_word(to, f, element, tolerance);
    if (!word) return std::nullopt;
    result.push_back(*std::move(word));
  }
  return result;
}

std::optional<bool> Source::is_exact(const Match& match, const LiftedTiles& to, const std::vector<Word>& images) const {
  const Surface& from = tiles().surface();
  std::vector<ElementPair> pairs;
  pairs.push_back({from_tile_0(from, pair.x.tile, pair.x.word), from_tile_0(to.surface(), match.tile, match.x_word)});
  pairs.push_back({from_tile_0(from, pair.x.tile, pair.y_word), from_tile_0(to.surface(), match.tile, match.y_word)});
  for (std::size_t k = 0; k < generators.words.size(); ++k) pairs.push_back({generators.words[k], images[k]});
  return are_conjugate(from, to.surface(), pairs);
}

Motion<Number> IsometryLifts::near(const Motion<Number>& f) const {
  const Word way = tiles().walk(TileId(0), f(tiles().centre(TileId(0))));
  const Word back = path_between_tiles(tiles().surface(), tiles().end_of(TileId(0), way), TileId(0));
  return motion(tiles().value(back) * tiles().value(way)) * f;
}

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
