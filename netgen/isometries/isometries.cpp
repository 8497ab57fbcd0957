#include "netgen/isometries/isometries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include "certify/base/interval.h"
#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/numbers/parallel.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/exact_conjugacy.h"
#include "netgen/isometries/invariants.h"
#include "netgen/isometries/lifted_tiles.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/group.h"

namespace epsnet {
namespace {

using Number = LiftedTiles::Number;
using Vector = LiftedTiles::Vector;

constexpr std::uint64_t kMostTiles = 2'000'000;

/// Whether two numbers of 256 bits are equal but for the errors of some operations.
bool agree(const Number& x, const Number& y) {
  return abs(x - y) <= boost::multiprecision::ldexp(Number(1 + abs(x)), -100);
}

/// A closed geodesic: an element in the coordinates of a tile. Re a > 0.
struct Line {
  TileId tile;
  Word word;
  Isometry<Number> element;
  Number length;

  /// The point of the axis that is `along` farther than the one next to a point.
  [[nodiscard]] Vector point(const Vector& near, const Number& along) const {
    const Vector normal = axis_normal(element);
    const Vector unit = Number(1 / sqrt(lorentz_product(normal, normal))) * normal;
    const Vector foot = near + Number(-lorentz_product(unit, near)) * unit;
    const Vector start = Number(1 / sqrt(-lorentz_product(foot, foot))) * foot;
    return Number(cosh(along)) * start + Number(sinh(along)) * lorentz_cross(start, unit);
  }
};

/// How many points of a closed geodesic are tried, at equal distances of about 1 at most.
std::uint32_t point_count(const Number& length) { return static_cast<std::uint32_t>(ceil(length)); }

/// The sum of (Re a)(Re a') and so on: half the trace of f ∘ g.
template <class T>
T half_trace_of_product(const Isometry<T>& f, const Isometry<T>& g) {
  return f.a.x * g.a.x - f.a.y * g.a.y + f.b.x * g.b.x + f.b.y * g.b.y;
}

/// The primitive closed geodesics of a surface up to some length.
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

/// A closed geodesic x, and an element y of which the axis has no end in common with that of x.
struct Pair {
  Line x;
  Isometry<Number> y;
  Word y_word;
  double displacement;  ///< By how much y moves a point of the axis of x.

  [[nodiscard]] double cost(std::size_t geodesics) const {
    return static_cast<double>(geodesics * point_count(x.length)) *
           std::exp(displacement + static_cast<double>(x.length) / point_count(x.length));
  }
};

/// Whether an element takes a line through 0 to itself or to one that has an end in common with it.
bool keeps_line(const Isometry<double>& element, const LorentzVector<double>& normal) {
  const LorentzVector<double> other = axis_normal(element);
  const double size = std::sqrt(std::abs(lorentz_product(other, other)));
  const LorentzVector<double> across = lorentz_cross(normal, other);
  return std::abs(lorentz_product(across, across)) < 1e-6 * size * size;
}

/// Returns a pair of a closed geodesic and the element that moves one of its points least, by at most `radius`, among
/// those that do not keep the axis.
std::optional<Pair> pair_of(const LiftedTiles& tiles, const Line& x, double radius) {
  std::optional<Pair> best;
  const std::uint32_t count = point_count(x.length);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector point = x.point(tiles.centre(x.tile), x.length * i / count);
    const Isometry<Number> base = normalized(Isometry<Number>::translation(in_disk(point)));
    const LorentzVector<double> n = axis_normal(convert<double>(inverse(base) * x.element * base));
    const LorentzVector<double> normal = (1 / std::sqrt(lorentz_product(n, n))) * n;
    const auto near = tiles.elements(x.tile, point, radius, kMostTiles);
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
Pair cheapest_pair(const LiftedTiles& tiles, const std::vector<Line>& lines) {
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
      std::optional<Pair> pair = pair_of(tiles, *one.line, radius);
      if (!pair) continue;
      one.line = nullptr;
      if (const double cost = pair->cost(one.count); cost < least) {
        least = cost;
        best = std::move(pair);
      }
    }
  }
  return *std::move(best);
}

/// A pair of elements to which an isometry may take another pair, in the coordinates of a tile.
struct Match {
  TileId tile;
  Isometry<Number> x;
  Isometry<Number> y;
  Word x_word;
  Word y_word;
};

/// Returns the pairs (x', y') of which x', y' and x'y' have the traces of x, y and xy: x' is `line` in one of its two
/// directions, and y' moves a point of its axis by no more than y moves one of the axis of x. Up to powers of x', every
/// such pair is among them, perhaps more than once.
std::vector<Match> matches(const LiftedTiles& tiles, const Line& line, const Pair& pair) {
  std::vector<Match> result;
  if (!agree(line.element.a.x, pair.x.element.a.x)) return result;
  const Number half_trace = half_trace_of_product(pair.x.element, pair.y);
  const auto is_near = [](double x, double y) { return std::abs(x - y) <= 1e-5 * (1 + std::abs(y)); };
  const std::uint32_t count = point_count(line.length);
  const double radius = pair.displacement + static_cast<double>(line.length) / count + 1e-6;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector point = line.point(tiles.centre(line.tile), line.length * i / count);
    const auto near = tiles.elements(line.tile, point, radius, kMostTiles);
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
        if (!agree(y2.a.x, pair.y.a.x) || !agree(half_trace_of_product(x2, y2), half_trace)) continue;
        Word x_word = forward ? line.word : reversed(tiles.surface(), line.word);
        result.push_back({line.tile, x2, y2, std::move(x_word), std::move(word)});
      }
    }
  }
  return result;
}

/// The generators of a surface's group.
struct Generators {
  std::vector<Word> words;
  std::vector<Isometry<Number>> elements;

  explicit Generators(const LiftedTiles& tiles) {
    const FundamentalPolygon polygon = fundamental_polygon(tiles.surface());
    for (std::uint32_t k = 0; k < polygon.sides.size(); ++k) {
      if (k > polygon.sides[k].partner) continue;
      words.push_back(polygon.sides[k].word);
      elements.push_back(tiles.value(words.back()));
    }
  }
};

/// A word from tile 0 to itself for one from another tile to itself.
Word from_tile_0(const Surface& surface, TileId tile, const Word& word) {
  const Word way = path_between_tiles(surface, TileId(0), tile);
  return concatenated(surface, concatenated(surface, way, word), reversed(surface, way));
}

/// Returns the word of an element of the group, from tile 0 to itself; nothing, if the isometry is none.
std::optional<Word> word_of(const LiftedTiles& tiles, const Isometry<Number>& element) {
  Word way = tiles.walk(TileId(0), image(element, tiles.centre(TileId(0))));
  if (!way.empty() && tiles.surface().tile_of_side(tiles.surface().partner(way.back())) != TileId(0))
    return std::nullopt;
  const Isometry<Number> rest = tiles.value(way) * element;
  if (!agree(rest.a.y, 0) || !agree(rest.b.x, 0) || !agree(rest.b.y, 0)) return std::nullopt;
  return concatenated(tiles.surface(), {}, reversed(tiles.surface(), way));
}

/// Returns an isometry of the plane, given in the coordinates of tiles 0, as one of surfaces; nothing, if it is none.
std::optional<SurfaceIsometry> surface_isometry(const Generators& generators, const LiftedTiles& to,
                                                const Motion<Number>& f) {
  SurfaceIsometry result{.preserves_orientation = preserves_orientation(f), .images = {}};
  for (const Isometry<Number>& generator : generators.elements) {
    std::optional<Word> image = word_of(to, conjugated(f, generator));
    if (!image) return std::nullopt;
    result.images.push_back(*std::move(image));
  }
  return result;
}

/// What is common to all isometries from one surface: where they are told from.
struct Source {
  LiftedTiles tiles;
  Generators generators;
  Pair pair;

  Source(const Surface& surface, const certify::GeodesicsDocument& geodesics)
      : tiles(surface, geodesics.geodesics.front().length.lower),
        generators(tiles),
        pair(cheapest_pair(tiles, lines(tiles, geodesics))) {}

  /// The isometry of the plane that a match tells, from the coordinates of tile 0 to those of tile 0.
  [[nodiscard]] Motion<Number> motion_of(const Match& match, const LiftedTiles& to) const {
    const Motion<Number> f = motion_of_pairs(pair.x.element, pair.y, match.x, match.y);
    // By the paths of from_tile_0: between two tiles there may be several shortest ones.
    return motion(to.value(reversed(to.surface(), path_between_tiles(to.surface(), TileId(0), match.tile)))) * f *
           motion(tiles.value(path_between_tiles(tiles.surface(), TileId(0), pair.x.tile)));
  }

  /// Whether an isometry that agrees with the numbers is one: exactly.
  [[nodiscard]] std::optional<bool> is_exact(const Match& match, const LiftedTiles& to,
                                             const SurfaceIsometry& isometry) const {
    const Surface& from = tiles.surface();
    std::vector<ElementPair> pairs;
    pairs.push_back({from_tile_0(from, pair.x.tile, pair.x.word), from_tile_0(to.surface(), match.tile, match.x_word)});
    pairs.push_back({from_tile_0(from, pair.x.tile, pair.y_word), from_tile_0(to.surface(), match.tile, match.y_word)});
    for (std::size_t k = 0; k < generators.words.size(); ++k) {
      pairs.push_back({generators.words[k], isometry.images[k]});
    }
    return are_conjugate(from, to.surface(), pairs);
  }
};

/// All matches of a pair on a surface, in the order of its closed geodesics.
std::vector<Match> all_matches(const LiftedTiles& tiles, const certify::GeodesicsDocument& geodesics, const Pair& pair,
                               const IsometryOptions& options) {
  const std::vector<Line> all = lines(tiles, geodesics);
  std::vector<std::vector<Match>> found(all.size());
  certify::for_each_parallel(all.size(), certify::thread_count(options.threads), [&](unsigned worker, std::size_t i) {
    found[i] = matches(tiles, all[i], pair);
    if (worker == 0 && options.progress) {
      options.progress("comparing geodesics", static_cast<double>(i) / static_cast<double>(all.size()));
    }
  });
  std::vector<Match> result;
  for (std::vector<Match>& some : found) {
    result.insert(result.end(), std::make_move_iterator(some.begin()), std::make_move_iterator(some.end()));
  }
  return result;
}

GeodesicsOptions geodesics_options(const IsometryOptions& options) {
  GeodesicsOptions result;
  result.threads = options.threads;
  result.progress = options.progress;
  return result;
}

/// A length a little above that of the systole, and at least 4, where even thin surfaces have closed geodesics that do
/// not go along their thin parts. Throws LimitError if the systole is too short.
Length list_length(const Surface& surface, const IsometryOptions& options) {
  // Across thin parts ways are long, and the tiles near them too many.
  constexpr double kLeastSystole = 0.0099;
  const double systole_length = unproved::systole(surface, geodesics_options(options)).geodesics.front().length.upper;
  if (systole_length < kLeastSystole) {
    throw LimitError("isometries are found on surfaces with a systole of at least 0.01; this one has " +
                     certify::decimal_above(systole_length));
  }
  return Length(std::max(4.0, systole_length * (1 + 1e-9)));
}

/// Whether the certifier verifies spectra.
bool are_verified(const std::vector<certify::GeodesicsDocument>& spectra, const IsometryOptions& options) {
  return std::all_of(spectra.begin(), spectra.end(), [&](const certify::GeodesicsDocument& spectrum) {
    certify::CheckOptions check = own_check(spectrum, options.threads, options.progress);
    check.max_precision = 1024;
    return certify::check(spectrum, check).verdict == certify::Verdict::verified;
  });
}

/// Looks for an isometry from one surface to another, and returns whether there is one, perhaps one that cannot be
/// decided. Requires: their spectra, which do not certainly differ.
bool search(const Surface& first, const Surface& second, const std::vector<certify::GeodesicsDocument>& spectra,
            const IsometryOptions& options, IsometricAnswer& answer) {
  if (spectra[1].geodesics.empty()) return false;
  const Source source(first, spectra[0]);
  const LiftedTiles tiles(second, spectra[1].geodesics.front().length.lower);
  const std::vector<Match> found = all_matches(tiles, spectra[1], source.pair, options);
  std::vector<std::pair<const Match*, Motion<Number>>> motions;
  motions.reserve(found.size());
  for (const Match& match : found) motions.emplace_back(&match, source.motion_of(match, tiles));
  // One that preserves the orientation is the better answer.
  std::stable_partition(motions.begin(), motions.end(),
                        [](const auto& entry) { return preserves_orientation(entry.second); });
  for (const auto& [match, f] : motions) {
    std::optional<SurfaceIsometry> isometry = surface_isometry(source.generators, tiles, f);
    if (!isometry) continue;
    const std::optional<bool> exact = source.is_exact(*match, tiles, *isometry);
    if (exact && !*exact) continue;
    answer.kind = exact ? IsometricAnswer::Kind::yes : IsometricAnswer::Kind::undecided;
    answer.isometry = std::move(isometry);
    if (!exact)
      answer.reason = "the exact numbers of the two surfaces are too large, or in no number field of degree at most 64";
    return true;
  }
  return false;
}

/// Isometries of a surface modulo its group, told by where they take a frame: each is known by the tile in which the
/// image of a point is, and by the isometry from the coordinates of tile 0 to those of this tile.
class Classes {
 public:
  explicit Classes(const LiftedTiles& tiles) : tiles_(tiles) {
    // No symmetry fixes a point like this, nor takes it to a side of a tile.
    const Complex<Number> offset{Number("0.01234567890123456789"), Number("0.0298765432109876543")};
    point_ = image(normalized(Isometry<Number>::translation(in_disk(tiles.centre(TileId(0))))), on_hyperboloid(offset));
  }

  /// Returns the number of an isometry, given in the coordinates of tile 0; if it is unknown, and `add`, it gets one.
  std::optional<std::uint32_t> find(const Motion<Number>& f, bool add) {
    const Word way = tiles_.walk(TileId(0), f(point_));
    const TileId tile = way.empty() ? TileId(0) : tiles_.surface().tile_of_side(tiles_.surface().partner(way.back()));
    const Motion<Number> reduced = motion(tiles_.value(way)) * f;
    const Vector place = reduced(point_);
    auto& known = known_[tile];
    const double key = static_cast<double>(place.x);
    for (auto other = known.lower_bound(key - 1e-9); other != known.end() && other->first < key + 1e-9; ++other) {
      const Motion<Number>& g = reduced_[other->second];
      const auto same = [](const Vector& u, const Vector& v) {
        return agree(u.x, v.x) && agree(u.y, v.y) && agree(u.t, v.t);
      };
      if (same(g.x, reduced.x) && same(g.y, reduced.y) && same(g.t, reduced.t)) return other->second;
    }
    if (!add) return std::nullopt;
    const auto number = static_cast<std::uint32_t>(reduced_.size());
    known.emplace(key, number);
    reduced_.push_back(reduced);
    motions_.push_back(motion(tiles_.value(path_between_tiles(tiles_.surface(), tile, TileId(0)))) * reduced);
    return number;
  }

  [[nodiscard]] std::size_t size() const { return reduced_.size(); }
  /// In the coordinates of tile 0.
  [[nodiscard]] const Motion<Number>& motion_of(std::uint32_t number) const { return motions_[number]; }

 private:
  const LiftedTiles& tiles_;
  Vector point_;
  std::vector<Motion<Number>> reduced_;
  std::vector<Motion<Number>> motions_;
  std::map<TileId, std::multimap<double, std::uint32_t>> known_;  ///< By tile and first coordinate.
};

}  // namespace

std::vector<Word> generator_words(const Surface& surface) {
  std::vector<Word> result;
  const FundamentalPolygon polygon = fundamental_polygon(surface);
  for (std::uint32_t k = 0; k < polygon.sides.size(); ++k) {
    if (k < polygon.sides[k].partner) result.push_back(polygon.sides[k].word);
  }
  return result;
}

std::size_t IsometryGroup::orientation_preserving() const {
  return static_cast<std::size_t>(std::count_if(isometries_.begin(), isometries_.end(),
                                                [](const SurfaceIsometry& f) { return f.preserves_orientation; }));
}

std::uint32_t IsometryGroup::product(std::uint32_t i, std::uint32_t j) const {
  std::vector<std::uint32_t> factors;
  for (; i != 0; i = steps_[i].then) factors.push_back(steps_[i].generator);
  for (; !factors.empty(); factors.pop_back()) j = action_[factors.back()][j];
  return j;
}

Permutation IsometryGroup::permutation(std::uint32_t i) const {
  Permutation result(size());
  for (std::uint32_t j = 0; j < size(); ++j) result[j] = j;
  std::vector<std::uint32_t> factors;
  for (; i != 0; i = steps_[i].then) factors.push_back(steps_[i].generator);
  for (; !factors.empty(); factors.pop_back()) {
    for (std::uint32_t& j : result) j = action_[factors.back()][j];
  }
  return result;
}

std::uint32_t IsometryGroup::order(std::uint32_t i) const {
  std::uint32_t result = 1;
  for (std::uint32_t power = i; power != 0; power = product(i, power)) ++result;
  return result;
}

std::string IsometryGroup::name() const {
  const auto count = static_cast<std::uint32_t>(size());
  std::vector<std::uint32_t> orders;
  for (std::uint32_t i = 0; i < count; ++i) orders.push_back(order(i));
  const std::uint32_t largest = *std::max_element(orders.begin(), orders.end());
  if (largest == count) return "C" + std::to_string(count);
  bool commutes = true;
  for (const std::uint32_t g : generators_) {
    for (const std::uint32_t h : generators_) commutes = commutes && product(g, h) == product(h, g);
  }
  if (commutes && count == 2 * largest) return "C2 x C" + std::to_string(largest);
  if (count % 2 != 0) return "";
  // Dihedral: a cyclic half, of which every element outside has order 2.
  for (std::uint32_t i = 0; i < count; ++i) {
    if (orders[i] != count / 2) continue;
    std::vector<bool> inside(count);
    std::uint32_t power = 0;
    do {
      inside[power] = true;
      power = product(i, power);
    } while (power != 0);
    bool dihedral = true;
    for (std::uint32_t j = 0; j < count; ++j) dihedral = dihedral && (inside[j] || orders[j] == 2);
    if (dihedral) return "D" + std::to_string(count / 2);
  }
  return "";
}

IsometryGroup isometries(const Surface& surface, const IsometryOptions& options) {
  IsometryGroup group;
  group.geodesics_ = unproved::spectrum(surface, list_length(surface, options), geodesics_options(options));
  const certify::GeodesicsDocument& geodesics = group.geodesics_;
  const Source source(surface, geodesics);
  const LiftedTiles& tiles = source.tiles;
  const std::vector<Match> found = all_matches(tiles, geodesics, source.pair, options);

  // Where one that is found is not in the group of those before, it is examined, and becomes a generator.
  std::vector<Motion<Number>> generators;
  std::optional<Classes> classes(std::in_place, tiles);
  (void)classes->find(Motion<Number>(), true);
  group.steps_ = {{0, 0}};
  std::size_t in_group = 0;
  for (const Match& match : found) {
    const Motion<Number> f = source.motion_of(match, tiles);
    if (classes->find(f, false)) continue;
    const std::optional<SurfaceIsometry> isometry = surface_isometry(source.generators, tiles, f);
    if (!isometry) continue;
    const std::optional<bool> exact = source.is_exact(match, tiles, *isometry);
    if (!exact) throw LimitError("the numbers of the surface are too large to decide exactly what is an isometry");
    if (!*exact) continue;
    generators.push_back(f);
    classes.emplace(tiles);
    (void)classes->find(Motion<Number>(), true);
    group.steps_ = {{0, 0}};
    group.action_.assign(generators.size(), {});
    for (std::uint32_t j = 0; j < classes->size(); ++j) {
      for (std::uint32_t g = 0; g < generators.size(); ++g) {
        const std::uint32_t number = *classes->find(generators[g] * classes->motion_of(j), true);
        group.action_[g].push_back(number);
        if (number == group.steps_.size()) group.steps_.push_back({g, j});
      }
    }
  }
  // The search and the products have to agree.
  std::vector<bool> seen(classes->size());
  for (const Match& match : found) {
    const std::optional<std::uint32_t> number = classes->find(source.motion_of(match, tiles), false);
    if (!number || seen[*number]) continue;
    seen[*number] = true;
    ++in_group;
  }
  if (in_group != classes->size()) {
    throw LimitError("the search for isometries finds " + std::to_string(in_group) + " of a group of " +
                     std::to_string(classes->size()));
  }

  for (const Motion<Number>& f : generators) group.generators_.push_back(*classes->find(f, false));
  group.isometries_.resize(classes->size());
  certify::for_each_parallel(classes->size(), certify::thread_count(options.threads), [&](unsigned, std::size_t i) {
    std::optional<SurfaceIsometry> isometry =
        surface_isometry(source.generators, tiles, classes->motion_of(static_cast<std::uint32_t>(i)));
    // The numbers of a product may be worse than those of the isometries that are multiplied.
    if (!isometry) throw LimitError("the numbers of the surface are too large to follow all of its isometries");
    group.isometries_[i] = *std::move(isometry);
  });
  const Homology homology(surface);
  for (std::size_t i = 0; i < group.size(); ++i) {
    const SurfaceIsometry& f = group.isometries_[i];
    group.fixed_points_.push_back(
        i != 0 && f.preserves_orientation
            ? std::optional(static_cast<std::uint64_t>(2 - homology.trace(source.generators.words, f.images)))
            : std::nullopt);
  }
  return group;
}

IsometricAnswer isometric(const Surface& first, const Surface& second, const IsometryOptions& options) {
  constexpr int kMostTries = 5;
  constexpr double kStep = 0.5;
  IsometricAnswer answer;
  if (first.genus() != second.genus()) {
    answer.kind = IsometricAnswer::Kind::no;
    answer.reason = "the genera are " + std::to_string(first.genus()) + " and " + std::to_string(second.genus());
    return answer;
  }
  Length length = list_length(first, options);
  for (int tries = 1;; ++tries) {
    std::vector<certify::GeodesicsDocument> spectra;
    for (const Surface* surface : {&first, &second}) {
      spectra.push_back(unproved::spectrum(*surface, length, geodesics_options(options)));
    }
    if (const auto difference = certain_difference(spectra[0], spectra[1])) {
      answer.reason = *difference;
      answer.kind = are_verified(spectra, options) ? IsometricAnswer::Kind::no : IsometricAnswer::Kind::undecided;
      if (answer.kind == IsometricAnswer::Kind::no) {
        answer.spectra = std::move(spectra);
      } else {
        answer.reason += "; but certify does not verify these lists";
      }
      return answer;
    }
    // The search for an isometry needs the first lists alone; its answer does not depend on them.
    if (tries == 1 && search(first, second, spectra, options, answer)) return answer;
    if (tries == kMostTries) break;
    length = Length(static_cast<double>(length.value()) + kStep);
  }
  answer.reason =
      "with 256 bits no two elements of the second group have the traces of two elements of the first one, and of "
      "their "
      "product, and extend to the group; but there are as many closed geodesics of the same lengths up to " +
      length.text();
  return answer;
}

}  // namespace epsnet
