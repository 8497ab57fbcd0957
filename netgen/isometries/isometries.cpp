#include "netgen/isometries/isometries.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/numbers/parallel.h"
#include "netgen/base/disjoint_sets.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/invariants.h"
#include "netgen/isometries/lifted_tiles.h"
#include "netgen/isometries/matches.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet {
namespace {

using Number = LiftedTiles::Number;

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

/// Looks for an isometry from one surface to another, and returns whether there is one, perhaps one that cannot be
/// decided. Requires: their spectra, which do not certainly differ.
bool search(const Surface& first, const Surface& second, const std::vector<certify::GeodesicsDocument>& spectra,
            const IsometryOptions& options, IsometricAnswer& answer) {
  if (spectra[1].geodesics.empty()) return false;
  const Source source(first, spectra[0]);
  const ElementSearch elements(second, spectra[1].geodesics.front().length.lower);
  const LiftedTiles& tiles = elements.tiles();
  // One that preserves the orientation is the better answer.
  std::optional<SurfaceIsometry> reversing;
  bool reversing_is_exact = false;
  const auto answer_is = [&](SurfaceIsometry isometry, bool exact) {
    answer.kind = exact ? IsometricAnswer::Kind::yes : IsometricAnswer::Kind::undecided;
    answer.isometry = std::move(isometry);
    if (!exact)
      answer.reason = "the exact numbers of the two surfaces are too large, or in no number field of degree at most 64";
    return true;
  };
  for (const Line& line : lines(tiles, spectra[1])) {
    for (const Match& match : matches(elements, line, source.pair, certify::thread_count(options.threads))) {
      const Motion<Number> f = source.motion_of(match, tiles);
      const bool preserves = preserves_orientation(f);
      if (!preserves && reversing) continue;
      std::optional<std::vector<Word>> images = source.images(tiles, f);
      if (!images) continue;
      const std::optional<bool> exact = source.is_exact(match, tiles, *images);
      if (exact && !*exact) continue;
      SurfaceIsometry isometry{.preserves_orientation = preserves, .images = *std::move(images)};
      if (preserves) return answer_is(std::move(isometry), exact.has_value());
      reversing = std::move(isometry);
      reversing_is_exact = exact.has_value();
    }
  }
  return reversing && answer_is(*std::move(reversing), reversing_is_exact);
}

/// By how much traces of generators, and of products of two, differ from those of their images; nothing, if the images
/// do not satisfy the relations.
std::optional<double> difference_of(const Source& source, const LiftedTiles& tiles, const std::vector<Word>& images) {
  std::vector<Isometry<Number>> there;
  there.reserve(images.size());
  for (const Word& word : images) there.push_back(normalized(tiles.value(word)));
  const FundamentalPolygon polygon = fundamental_polygon(source.tiles().surface());
  std::vector<Isometry<Number>> by_side(polygon.sides.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < by_side.size(); ++k) {
    const std::size_t partner = polygon.sides[k].partner;
    by_side[k] = k < partner ? there[next++] : inverse(by_side[partner]);
  }
  for (const std::vector<std::uint32_t>& relation : polygon.relations) {
    Isometry<Number> product;
    for (const std::uint32_t k : relation) product = product * by_side[k];
    for (const Number& part : {product.a.y, product.b.x, product.b.y}) {
      if (!agree(part, 0)) return std::nullopt;
    }
  }
  const auto differ = [](const Isometry<Number>& f, const Isometry<Number>& g) {
    return static_cast<double>(abs(Number(2 * (abs(f.a.x) - abs(g.a.x)))));
  };
  double result = 0;
  for (std::size_t i = 0; i < there.size(); ++i) {
    const Isometry<Number> x = normalized(source.generators.elements[i]);
    result = std::max(result, differ(x, there[i]));
    for (std::size_t j = 0; j < i; ++j) {
      const Isometry<Number> y = normalized(source.generators.elements[j]);
      result = std::max(result, differ(x * y, there[i] * there[j]));
    }
  }
  return result;
}

/// Looks for an isomorphism of the groups that hardly changes traces: the nearest one of those that a pair of elements
/// tells. Requires: spectra.
std::optional<NearIsometry> near_isometry(const Surface& first, const Surface& second,
                                          const std::vector<certify::GeodesicsDocument>& spectra,
                                          const IsometryOptions& options) {
  constexpr double kTolerance = 1e-3;  // Of half the traces of the pair.
  constexpr double kMostRest = 0.05;   // Of the images of generators: elements of the group are farther apart.
  constexpr int kMostMatches = 200;
  if (spectra[0].geodesics.empty() || spectra[1].geodesics.empty()) return std::nullopt;
  const Source source(first, spectra[0]);
  const ElementSearch elements(second, spectra[1].geodesics.front().length.lower);
  const LiftedTiles& tiles = elements.tiles();
  std::optional<NearIsometry> best;
  int tried = 0;
  for (const Line& line : lines(tiles, spectra[1])) {
    for (const Match& match :
         matches(elements, line, source.pair, certify::thread_count(options.threads), kTolerance)) {
      if (++tried > kMostMatches) return best;
      const Motion<Number> f = source.motion_of(match, tiles);
      std::optional<std::vector<Word>> images = source.images(tiles, f, kMostRest);
      const auto difference = images ? difference_of(source, tiles, *images) : std::nullopt;
      if (!difference || *difference > 10 * kTolerance || (best && best->difference <= *difference)) continue;
      best =
          NearIsometry{{.preserves_orientation = preserves_orientation(f), .images = *std::move(images)}, *difference};
    }
  }
  return best;
}

/// The match of an automorphism.
Match match_of(const LiftedTiles& tiles, const Pair& pair, const MapAutomorphism& automorphism) {
  Word x_word = image_of(automorphism, pair.x.word);
  Word y_word = image_of(automorphism, pair.y_word);
  const Isometry<Number> x = normalized(tiles.value(x_word));
  const Isometry<Number> y = normalized(tiles.value(y_word));
  return {image_of(tiles.surface(), automorphism, pair.x.tile), x, y, std::move(x_word), std::move(y_word)};
}

}  // namespace

/// Collects isometries and counts what they generate.
class IsometryGroup::Builder {
 public:
  Builder(const Surface& surface, std::shared_ptr<IsometryLifts> lifts)
      : lifts_(std::move(lifts)), homology_(surface), class_(homology_.dimension()) {
    // Isometries are told apart by where they take a class of the homology: none but the identity fixes a random one.
    std::mt19937 random;
    for (std::uint64_t& x : class_) x = random() % Homology::kPrime;
    close();
  }

  [[nodiscard]] std::size_t size() const { return images_.size(); }

  /// What tells an isometry from the others, given by the images of the surface's generators.
  [[nodiscard]] Homology::Vector key(const std::vector<Word>& images) const { return map_of(images)(class_); }
  /// Whether an isometry of this key is in the group.
  [[nodiscard]] bool contains(const Homology::Vector& key) const { return numbers_.count(key) != 0; }

  /// Adds a generator. O(order × generators × genus²).
  void add(const Motion<Number>& f, const std::vector<Word>& images) {
    lifts_->generators.push_back(f);
    maps_.push_back(map_of(images));
    preserves_.push_back(epsnet::preserves_orientation(f));
    close();
  }

  [[nodiscard]] IsometryGroup group(certify::GeodesicsDocument geodesics) const {
    IsometryGroup result;
    result.lifts_ = lifts_;
    result.geodesics_ = std::move(geodesics);
    result.action_ = action_;
    result.steps_ = steps_;
    for (const auto& action : action_) result.generators_.push_back(action[0]);
    result.preserves_ = {true};
    for (std::size_t i = 1; i < steps_.size(); ++i) {
      result.preserves_.push_back(preserves_[steps_[i].generator] == result.preserves_[steps_[i].then]);
    }
    result.fixed_points_ = fixed_points(result);
    return result;
  }

 private:
  [[nodiscard]] HomologyMap map_of(const std::vector<Word>& images) const {
    return {homology_, lifts_->source.generators.words, images};
  }

  void close() {
    numbers_ = {{class_, 0}};
    images_ = {&numbers_.begin()->first};
    steps_ = {{0, 0}};
    action_.assign(maps_.size(), {});
    for (std::uint32_t j = 0; j < images_.size(); ++j) {
      for (std::uint32_t g = 0; g < maps_.size(); ++g) {
        const auto [place, is_new] =
            numbers_.emplace(maps_[g](*images_[j]), static_cast<std::uint32_t>(images_.size()));
        action_[g].push_back(place->second);
        if (!is_new) continue;
        images_.push_back(&place->first);
        steps_.push_back({g, j});
      }
    }
  }

  /// By isometry. Conjugate ones have equally many, so one of each class is asked.
  [[nodiscard]] std::vector<std::optional<std::uint64_t>> fixed_points(const IsometryGroup& group) const {
    std::vector<std::uint32_t> inverses;
    for (const std::uint32_t g : group.generators()) {
      std::uint32_t inverse = 0;
      for (std::uint32_t power = g; power != 0; power = group.product(g, power)) inverse = power;
      inverses.push_back(inverse);
    }
    std::vector<std::optional<std::uint64_t>> result(group.size());
    std::vector<bool> seen(group.size());
    for (std::uint32_t i = 1; i < group.size(); ++i) {
      if (seen[i] || !group.preserves_orientation(i)) continue;
      const std::int64_t trace = map_of(group.isometry(i).images).trace();
      std::vector<std::uint32_t> conjugates{i};
      seen[i] = true;
      for (std::size_t k = 0; k < conjugates.size(); ++k) {
        result[conjugates[k]] = static_cast<std::uint64_t>(2 - trace);
        for (std::size_t g = 0; g < inverses.size(); ++g) {
          const std::uint32_t conjugate = group.product(action_[g][conjugates[k]], inverses[g]);
          if (seen[conjugate]) continue;
          seen[conjugate] = true;
          conjugates.push_back(conjugate);
        }
      }
    }
    return result;
  }

  std::shared_ptr<IsometryLifts> lifts_;
  Homology homology_;
  Homology::Vector class_;
  std::vector<HomologyMap> maps_;  ///< By generator,
  std::vector<bool> preserves_;    ///< and whether it preserves the orientation.
  std::map<Homology::Vector, std::uint32_t> numbers_;
  std::vector<const Homology::Vector*> images_;  ///< By isometry: the image of the class.
  std::vector<std::vector<std::uint32_t>> action_;
  std::vector<Step> steps_;
};

std::vector<Word> generator_words(const Surface& surface) {
  std::vector<Word> result;
  const FundamentalPolygon polygon = fundamental_polygon(surface);
  for (std::uint32_t k = 0; k < polygon.sides.size(); ++k) {
    if (k < polygon.sides[k].partner) result.push_back(polygon.sides[k].word);
  }
  return result;
}

std::size_t IsometryGroup::orientation_preserving() const {
  return static_cast<std::size_t>(std::count(preserves_.begin(), preserves_.end(), true));
}

SurfaceIsometry IsometryGroup::isometry(std::uint32_t i) const {
  Motion<Number> f;
  for (const std::uint32_t g : factors(i)) f = lifts_->near(lifts_->generators[g] * f);
  std::optional<std::vector<Word>> images = lifts_->source.images(lifts_->tiles(), f);
  // The numbers of a product may be worse than those of the isometries that are multiplied.
  if (!images) throw LimitError("the numbers of the surface are too large to follow all of its isometries");
  return {.preserves_orientation = preserves_[i], .images = *std::move(images)};
}

std::vector<std::uint32_t> IsometryGroup::factors(std::uint32_t i) const {
  std::vector<std::uint32_t> result;
  for (; i != 0; i = steps_[i].then) result.push_back(steps_[i].generator);
  std::reverse(result.begin(), result.end());
  return result;
}

std::uint32_t IsometryGroup::product(std::uint32_t i, std::uint32_t j) const {
  for (const std::uint32_t g : factors(i)) j = action_[g][j];
  return j;
}

Permutation IsometryGroup::permutation(std::uint32_t i) const {
  Permutation result(size());
  std::iota(result.begin(), result.end(), 0U);
  for (const std::uint32_t g : factors(i)) {
    for (std::uint32_t& j : result) j = action_[g][j];
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
  certify::GeodesicsDocument geodesics =
      unproved::spectrum(surface, list_length(surface, options), geodesics_options(options));
  const auto lifts = std::make_shared<IsometryLifts>(IsometryLifts{Source(surface, geodesics), {}});
  const Source& source = lifts->source;
  const LiftedTiles& tiles = source.tiles();
  std::vector<Line> as_long;
  for (Line& line : lines(tiles, geodesics)) {
    if (agree(line.length, source.pair.x.length)) as_long.push_back(std::move(line));
  }
  const LinePlaces places(tiles, as_long);
  DisjointSets orbits(as_long.size());
  IsometryGroup::Builder builder(surface, lifts);
  const auto add = [&](const Motion<Number>& f, const std::vector<Word>& images) {
    builder.add(f, images);
    for (std::uint32_t i = 0; i < as_long.size(); ++i) {
      if (const auto image = places.image(f, i)) orbits.join(i, *image);
    }
  };
  for (const MapAutomorphism& automorphism : map_automorphisms(surface)) {
    const Motion<Number> f = source.motion_of(match_of(tiles, source.pair, automorphism), tiles);
    const auto images = source.images(tiles, f);
    if (!images) throw LimitError("the numbers of the surface are too large to follow its isometries");
    add(f, *images);
  }

  // Where one that is found is not in the group of those before, it is examined, and becomes a generator. Of lines that
  // the group takes to each other one is enough: the others give products of what it gives.
  std::map<std::uint32_t, std::set<Homology::Vector>> found;
  for (std::uint32_t i = 0; i < as_long.size(); ++i) {
    if (options.progress) {
      options.progress("comparing geodesics", static_cast<double>(i) / static_cast<double>(as_long.size()));
    }
    if (orbits.find(i) < i) continue;
    for (const Match& match : matches(source.search, as_long[i], source.pair, certify::thread_count(options.threads))) {
      const Motion<Number> f = source.motion_of(match, tiles);
      const auto images = source.images(tiles, f);
      if (!images) continue;
      Homology::Vector key = builder.key(*images);
      if (!builder.contains(key)) {
        const std::optional<bool> exact = source.is_exact(match, tiles, *images);
        if (!exact) throw LimitError("the numbers of the surface are too large to decide exactly what is an isometry");
        if (!*exact) continue;
        add(f, *images);
      }
      found[i].insert(std::move(key));
    }
  }
  // The search and the products have to agree. As many take x to one line of an orbit as to another.
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < as_long.size(); ++i) count += found[orbits.find(i)].size();
  if (count != builder.size()) {
    throw LimitError("the search for isometries finds " + std::to_string(count) + " of a group of " +
                     std::to_string(builder.size()));
  }
  return builder.group(std::move(geodesics));
}

namespace {

/// Proves the isometry that was found, which may decide whether it is one.
void prove_isometry(const Surface& first, const Surface& second, std::vector<certify::GeodesicsDocument> spectra,
                    const IsometryOptions& options, IsometricAnswer& answer) {
  try {
    answer.proof =
        proved(isometry_document(first, second, *answer.isometry, std::move(spectra[0].net), std::move(spectra[1].net)),
               options.threads, options.progress);
  } catch (const NotCertifiedError&) {
    return;
  }
  answer.kind = IsometricAnswer::Kind::yes;
  answer.reason.clear();
}

}  // namespace

IsometricAnswer isometric(const Surface& first, const Surface& second, const IsometryOptions& options) {
  constexpr int kMostTries = 5;
  constexpr double kStep = 0.5;
  IsometricAnswer answer;
  // Lists that are empty prove that genera differ.
  constexpr double kNoLength = 1e-9;
  const bool genera_differ = first.genus() != second.genus();
  Length length = genera_differ ? Length(kNoLength) : list_length(first, options);
  for (int tries = 1;; ++tries) {
    std::vector<certify::GeodesicsDocument> spectra;
    for (const Surface* surface : {&first, &second}) {
      spectra.push_back(unproved::spectrum(*surface, length, geodesics_options(options)));
    }
    std::optional<std::string> difference;
    if (genera_differ) {
      difference = "the genera are " + std::to_string(first.genus()) + " and " + std::to_string(second.genus());
    } else {
      difference = certain_difference(spectra[0], spectra[1]);
    }
    // The search for an isometry needs the first lists alone; its answer does not depend on them.
    if (!difference && tries == 1 && search(first, second, spectra, options, answer)) {
      prove_isometry(first, second, std::move(spectra), options, answer);
      return answer;
    }
    if (!genera_differ && tries == 1) answer.near = near_isometry(first, second, spectra, options);
    answer.proof = proved_difference(spectra[0], spectra[1], options.threads, options.progress);
    if (answer.proof) {
      answer.kind = IsometricAnswer::Kind::no;
      answer.reason = difference.value_or(answer.proof->certificate.rules.back().text);
      return answer;
    }
    if (difference) {
      answer.reason = *difference + "; but certify does not verify this";
      return answer;
    }
    if (tries == kMostTries) break;
    length = Length(static_cast<double>(length.value()) + kStep);
  }
  answer.reason =
      "with 512 bits no two elements of the second group have the traces of two elements of the first one, and of "
      "their product, and extend to the group; but there are as many closed geodesics of the same lengths up to " +
      length.text() + ", which perhaps cross in the same way";
  return answer;
}

namespace {

/// A known surface and its closed geodesics that are not longer than the systole of the given surface.
struct KnownSurface {
  std::vector<std::string> names;
  Surface surface;
  certify::GeodesicsDocument systoles;
};

/// The name of the surface of a regular map: that of its map with the most rotations.
std::optional<std::string_view> surface_of_regular_map(const Surface& surface) {
  const DartMap map = standard_form(map_of_surface(surface));
  for (const RegularMap& known : regular_maps()) {
    if (known.genus != surface.genus() || rotations(known) != map.edges.size()) continue;
    const DartMap known_map = darts(known);
    for (const DartMap& form : {known_map, dual(known_map)}) {
      if (standard_form(form) == map || standard_form(mirror_image(form)) == map) return known.surface;
    }
  }
  return std::nullopt;
}

/// As `isometric`, with any of the maps of a surface: with some the numbers may be too large to be compared. They are
/// small if the tiles are the same.
NamedAnswer isometric_to_any(const Surface& surface, const std::vector<std::string>& names,
                             const IsometryOptions& options) {
  std::vector<std::pair<std::string, Surface>> maps;
  maps.reserve(names.size());
  for (const std::string& name : names) maps.emplace_back(name, named_surface(name));
  std::stable_partition(maps.begin(), maps.end(),
                        [&](const auto& map) { return map.second.regular_tile() == surface.regular_tile(); });
  NamedAnswer result;
  result.names = names;
  for (const auto& [name, map] : maps) {
    result.compared = name;
    result.answer = isometric(surface, map, options);
    if (result.answer.kind != IsometricAnswer::Kind::undecided || !result.answer.isometry) break;
  }
  return result;
}

}  // namespace

std::vector<std::vector<std::string>> known_surfaces(std::uint32_t genus) {
  std::vector<std::vector<std::string>> result;
  std::map<std::string_view, std::size_t> place;
  const auto add = [&](std::optional<std::string_view> surface, std::string name) {
    if (!surface) {
      result.push_back({std::move(name)});
      return;
    }
    const auto [known, is_new] = place.emplace(*surface, result.size());
    if (is_new) result.emplace_back();
    result[known->second].push_back(std::move(name));
  };
  std::vector<const RegularMap*> maps;
  for (const RegularMap& map : regular_maps()) {
    if (map.genus == genus) maps.push_back(&map);
  }
  for (std::string& name : names_of_genus(genus)) {
    const auto surface = maps.empty() ? std::nullopt : surface_of_regular_map(named_surface(name));
    add(surface, std::move(name));
  }
  std::stable_sort(maps.begin(), maps.end(),
                   [](const RegularMap* a, const RegularMap* b) { return rotations(*a) > rotations(*b); });
  for (const RegularMap* map : maps) add(map->surface, std::string(map->name));
  return result;
}

std::vector<NamedAnswer> identify(const Surface& surface, const IsometryOptions& options) {
  GeodesicsOptions of_geodesics;
  of_geodesics.threads = options.threads;
  of_geodesics.progress = options.progress;
  // A little more than the systole, up to which lists show it and how many closed geodesics are as short.
  const Length length(unproved::systole(surface, of_geodesics).geodesics.front().length.upper * (1 + 1e-9));
  const certify::GeodesicsDocument systoles = unproved::spectrum(surface, length, of_geodesics);
  of_geodesics.progress = {};
  std::vector<KnownSurface> similar;
  std::vector<KnownSurface> others;
  const std::vector<std::vector<std::string>> known = known_surfaces(surface.genus());
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (options.progress) {
      options.progress("comparing systoles", static_cast<double>(i) / static_cast<double>(known.size()));
    }
    const Surface named = named_surface(known[i].front());
    certify::GeodesicsDocument list = unproved::spectrum(named, length, of_geodesics);
    const bool differs = certain_difference(systoles, list).has_value();
    (differs ? others : similar).push_back({known[i], named, std::move(list)});
  }
  if (similar.size() > 1) {
    const std::size_t order = isometries(surface, options).size();
    std::stable_partition(similar.begin(), similar.end(), [&](const KnownSurface& other) {
      return isometries(other.surface, options).size() == order;
    });
  }

  std::vector<NamedAnswer> result;
  for (const KnownSurface& other : similar) {
    result.push_back(isometric_to_any(surface, other.names, options));
    if (result.back().answer.kind == IsometricAnswer::Kind::yes) return result;
  }
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (options.progress) {
      options.progress("proving that systoles differ", static_cast<double>(i) / static_cast<double>(others.size()));
    }
    IsometricAnswer answer;
    answer.reason = certain_difference(systoles, others[i].systoles).value();
    answer.proof = proved_difference(systoles, others[i].systoles, options.threads);
    if (answer.proof) {
      answer.kind = IsometricAnswer::Kind::no;
    } else {
      answer.reason += "; but certify does not verify these lists";
    }
    std::string compared = others[i].names.front();
    result.push_back({std::move(others[i].names), std::move(compared), std::move(answer)});
  }
  return result;
}

namespace {

/// Side 0, or another one to which an automorphism takes it, and whether it preserves the orientation.
struct Flag {
  SideId side;
  bool preserves;
};

/// The automorphism that takes side 0 to a flag, if there is one.
std::optional<MapAutomorphism> automorphism_to(const Surface& surface, const Flag& flag) {
  const SideId unknown(surface.side_count());
  MapAutomorphism result{flag.preserves, ById<SideId, SideId>(surface.side_count(), unknown)};
  std::vector<SideId> known{SideId(0)};
  result.image[SideId(0)] = flag.side;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const SideId s = known[i];
    const SideId to = result.image[s];
    for (const auto& [next, image] :
         {std::pair(surface.next_side(s), flag.preserves ? surface.next_side(to) : surface.previous_side(to)),
          std::pair(surface.partner(s), surface.partner(to))}) {
      if (result.image[next] == unknown) {
        result.image[next] = image;
        known.push_back(next);
      } else if (result.image[next] != image) {
        return std::nullopt;
      }
    }
  }
  return result;
}

/// The flags that are reached from side 0, or from one of those, by products of automorphisms.
class ReachedFlags {
 public:
  explicit ReachedFlags(std::uint32_t sides) : sides_(sides), reached_(2 * std::size_t{sides}) {}

  [[nodiscard]] bool contains(const Flag& flag) const { return reached_[number(flag)]; }

  void add_orbit(const Flag& flag, const std::vector<MapAutomorphism>& automorphisms) {
    std::vector<Flag> found{flag};
    reached_[number(flag)] = true;
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const MapAutomorphism& f : automorphisms) {
        const Flag image{f.image[found[i].side], found[i].preserves == f.preserves_orientation};
        if (contains(image)) continue;
        reached_[number(image)] = true;
        found.push_back(image);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t number(const Flag& flag) const {
    return flag.side.number() + (flag.preserves ? 0 : std::size_t{sides_});
  }

  std::uint32_t sides_;
  std::vector<bool> reached_;
};

}  // namespace

std::vector<MapAutomorphism> map_automorphisms(const Surface& surface) {
  std::vector<MapAutomorphism> result;
  if (!surface.is_regular()) return result;
  const Flag first{SideId(0), true};
  ReachedFlags done(surface.side_count());
  done.add_orbit(first, result);
  for (const bool preserves : {true, false}) {
    for (const SideId s : surface.side_ids()) {
      const Flag flag{s, preserves};
      if (done.contains(flag)) continue;
      if (std::optional<MapAutomorphism> f = automorphism_to(surface, flag)) {
        // Flags to which none leads before are forgotten, as their orbits are larger now; those that count come later.
        result.push_back(*std::move(f));
        done = ReachedFlags(surface.side_count());
        done.add_orbit(first, result);
      } else {
        done.add_orbit(flag, result);
      }
    }
  }
  return result;
}

Word image_of(const MapAutomorphism& automorphism, const Word& word) {
  Word result;
  for (const SideId s : word) result.push_back(automorphism.image[s]);
  return result;
}

TileId image_of(const Surface& surface, const MapAutomorphism& automorphism, TileId tile) {
  return surface.tile_of_side(automorphism.image[surface.side_number(tile, 0)]);
}

}  // namespace epsnet
