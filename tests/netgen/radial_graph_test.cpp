#include "netgen/curves/radial_graph.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <utility>
#include <vector>

#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/lifted_tiles.h"
#include "netgen/pants/curve_system.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"

/// Closed curves from their words alone, beside their geodesics.
namespace epsnet::radial_graph_test {
namespace {

using Vector = CurveSystem::Vector;

struct CrossingCount {
  std::uint64_t geometric = 0;
  std::int64_t algebraic = 0;
};

CrossingCount count(const std::vector<WalkCrossing>& crossings) {
  CrossingCount result;
  for (const WalkCrossing& crossing : crossings) {
    ++result.geometric;
    result.algebraic += crossing.sign;
  }
  return result;
}

/// Closed geodesics with the chords that they are in tiles: crossings are counted where they are.
class Chords {
 public:
  Chords(const Surface& surface, const std::vector<Word>& words)
      : surface_(surface), tiles_(surface), system_(surface) {
    for (const Word& word : words) {
      const TileId tile = surface.tile_of_side(word.front());
      chords_.push_back(system_.chords(system_.add({tile, word})));
    }
  }

  /// Of two geodesics, or of one with itself.
  [[nodiscard]] CrossingCount crossings(std::size_t i, std::size_t j) const {
    CrossingCount result;
    for (std::size_t a = 0; a < chords_[i].size(); ++a) {
      for (std::size_t b = i == j ? a + 1 : 0; b < chords_[j].size(); ++b) {
        const int sign = crossing(chords_[i][a], chords_[j][b]);
        result.geometric += sign == 0 ? 0 : 1;
        result.algebraic += sign;
      }
    }
    return result;
  }

 private:
  /// 1 if the second chord crosses the first one in their tile from right to left, −1 if from left to right.
  [[nodiscard]] int crossing(const CurveSystem::Chord& first, const CurveSystem::Chord& second) const {
    if (first.tile != second.tile) return 0;
    Vector point = lorentz_cross(first.normal, second.normal);
    if (lorentz_product(point, point) >= 0) return 0;
    const bool up = point.t > 0;
    if (!up) point = CurveSystem::Number(-1) * point;
    for (std::uint32_t k = 0; k < surface_.tile(first.tile).size(); ++k) {
      if (lorentz_product(tiles_.line(surface_.side_number(first.tile, k)), point) < 0) return 0;
    }
    // Normals of the real axis and of the imaginary one, directed to the right and up, are (0, 1, 0) and (−1, 0, 0).
    return up ? -1 : 1;
  }

  const Surface& surface_;
  LiftedTiles tiles_;
  CurveSystem system_;
  std::vector<std::vector<CurveSystem::Chord>> chords_;
};

/// Words of all closed geodesics up to a length.
std::vector<Word> short_words(const Surface& surface, const char* up_to) {
  const certify::GeodesicsDocument document = unproved::spectrum(surface, Length(up_to));
  std::vector<Word> words;
  for (const auto& geodesic : document.geodesics) words.push_back(word_of_letters(geodesic.word));
  return words;
}

std::int64_t value(const std::vector<std::vector<std::int64_t>>& form, const std::vector<std::int64_t>& x,
                   const std::vector<std::int64_t>& y) {
  std::int64_t result = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) result += x[i] * form[i][j] * y[j];
  }
  return result;
}

/// A surface of which no sides of tiles are on short geodesics or meet where these cross, as a Dehn twist moves them.
Surface generic_surface(std::uint32_t genus, std::uint64_t seed) {
  const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::random(genus, seed), seed));
  return dehn_twisted(surface, short_words(surface, "4").back());
}

void expect_words_and_geodesics_agree(const Surface& surface, const char* up_to) {
  const std::vector<Word> words = short_words(surface, up_to);
  const RadialGraph graph(surface);
  const Chords chords(surface, words);
  const auto form = graph.intersection_form();
  std::vector<ClosedWalk> walks;
  for (const Word& word : words) walks.push_back(graph.walk_of(word));
  for (std::size_t i = 0; i < walks.size(); ++i) {
    EXPECT_EQ(RadialGraph::power_of(walks[i]), 1U);
    EXPECT_EQ(graph.self_crossings(walks[i]).size(), chords.crossings(i, i).geometric) << i;
    for (std::size_t j = 0; j < i; ++j) {
      const CrossingCount here = count(graph.crossings(walks[i], walks[j]));
      const CrossingCount there = chords.crossings(i, j);
      ASSERT_EQ(here.geometric, there.geometric) << i << ' ' << j;
      ASSERT_EQ(here.algebraic, there.algebraic) << i << ' ' << j;
      ASSERT_EQ(here.algebraic, value(form, graph.homology(walks[i]), graph.homology(walks[j]))) << i << ' ' << j;
    }
  }
}

TEST(RadialGraph, WordsAndGeodesicsAgree) {
  for (const std::uint32_t genus : {2U, 3U, 4U}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      expect_words_and_geodesics_agree(generic_surface(genus, seed), "6");
    }
  }
}

// ---- walks of free homotopy classes ----

/// Surfaces of one tile and of several, with one vertex and with many.
const std::vector<Surface>& surfaces() {
  static const std::vector<Surface> result{
      random_octagon(5),      Surface::regular(3),
      named_surface("klein"), named_surface("bring"),
      generic_surface(2, 3),  fenchel_nielsen_surface(random_coordinates(PantsGraph::random(3, 1), 1))};
  return result;
}

const RadialGraph& graph_of(std::size_t number) {
  static const std::vector<RadialGraph> graphs(surfaces().begin(), surfaces().end());
  return graphs[number];
}

/// A number below another one, in the first cases as in the last: of small ones too many words are trivial, or powers.
rc::Gen<std::size_t> any_below(std::size_t end) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, end));
}

rc::Gen<std::size_t> any_surface() { return any_below(surfaces().size()); }

SideId any_side_of(const Surface& surface, TileId tile) {
  return surface.side_number(tile, static_cast<std::uint32_t>(*any_below(surface.tile(tile).size())));
}

/// A closed path from a tile.
Word any_loop(const Surface& surface, TileId start) {
  Word word;
  TileId tile = start;
  for (std::size_t i = *any_below(12); i > 0; --i) {
    word.push_back(any_side_of(surface, tile));
    tile = surface.tile_of_side(surface.partner(word.back()));
  }
  const Word home = path_between_tiles(surface, tile, start);
  word.insert(word.end(), home.begin(), home.end());
  return word;
}

Word joined(Word first, const Word& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

RC_GTEST_PROP(RadialGraph, AWalkIsThatOfTheFreeHomotopyClass, ()) {
  const std::size_t number = *any_surface();
  const Surface& surface = surfaces()[number];
  const RadialGraph& graph = graph_of(number);
  const Word word = any_loop(surface, TileId(0));
  const ClosedWalk walk = graph.walk_of(word);
  // Conjugated, with a spur and a way around a vertex in it.
  Word other = any_loop(surface, TileId(0));
  for (Word part : {word, epsnet::reversed(surface, other)}) other = joined(std::move(other), part);
  if (!other.empty()) {
    const std::size_t place = *rc::gen::inRange<std::size_t>(0, other.size());
    const Word cycle = surface.corner_cycle(other[place]);
    Word changed(other.begin(), other.begin() + static_cast<std::ptrdiff_t>(place));
    changed = joined(joined(std::move(changed), cycle), {cycle.front(), surface.partner(cycle.front())});
    other = joined(std::move(changed), Word(other.begin() + static_cast<std::ptrdiff_t>(place), other.end()));
    std::rotate(other.begin(), other.begin() + static_cast<std::ptrdiff_t>(place), other.end());
  }
  RC_ASSERT(graph.walk_of(other) == walk);
  RC_ASSERT(graph.walk_of(graph.path(graph.sides_of(walk))) == walk);
  RC_ASSERT(graph.reversed(walk) == graph.walk_of(epsnet::reversed(surface, word)));
  RC_ASSERT(graph.reversed(graph.reversed(walk)) == walk);
}

RC_GTEST_PROP(RadialGraph, AWordIsTrivialIfItsIsometryIs, ()) {
  const std::size_t number = *any_surface();
  const Surface& surface = surfaces()[number];
  const Word word = any_loop(surface, TileId(0));
  const LiftedTiles tiles(surface);
  RC_ASSERT(graph_of(number).walk_of(word).empty() == (isometry_discriminant(tiles.value(word)) < 1e-30));
}

RC_GTEST_PROP(RadialGraph, PowersAreFound, ()) {
  const std::size_t number = *any_surface();
  const RadialGraph& graph = graph_of(number);
  const Word word = any_loop(surfaces()[number], TileId(0));
  const ClosedWalk walk = graph.walk_of(word);
  RC_PRE(!walk.empty());
  Word power;
  const std::uint32_t exponent = *rc::gen::inRange(1U, 6U);
  for (std::uint32_t i = 0; i < exponent; ++i) power = joined(std::move(power), word);
  RC_ASSERT(RadialGraph::power_of(graph.walk_of(power)) == exponent * RadialGraph::power_of(walk));
}

RC_GTEST_PROP(RadialGraph, HomologyIsAdditiveAndTellsAlgebraicNumbers, ()) {
  const std::size_t number = *any_surface();
  const Surface& surface = surfaces()[number];
  const RadialGraph& graph = graph_of(number);
  const Word first = any_loop(surface, TileId(0));
  const Word second = any_loop(surface, TileId(0));
  const ClosedWalk a = graph.walk_of(first);
  const ClosedWalk b = graph.walk_of(second);
  std::vector<std::int64_t> sum = graph.homology(a);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += graph.homology(b)[i];
  RC_ASSERT(graph.homology(graph.walk_of(joined(first, second))) == sum);
  RC_PRE(!a.empty() && !b.empty() && a != b && graph.reversed(a) != b);
  RC_PRE(RadialGraph::power_of(a) == 1 && RadialGraph::power_of(b) == 1);
  const CrossingCount there = count(graph.crossings(a, b));
  const CrossingCount back = count(graph.crossings(b, a));
  RC_ASSERT(there.algebraic == value(graph.intersection_form(), graph.homology(a), graph.homology(b)));
  RC_ASSERT(there.geometric == back.geometric);
  RC_ASSERT(there.algebraic == -back.algebraic);
  const CrossingCount reversed = count(graph.crossings(graph.reversed(a), b));
  RC_ASSERT(reversed.geometric == there.geometric);
  RC_ASSERT(reversed.algebraic == -there.algebraic);
}

RC_GTEST_PROP(RadialGraph, LiftsThatCrossHaveAxesThatCross, ()) {
  const std::size_t number = *any_surface();
  const Surface& surface = surfaces()[number];
  const RadialGraph& graph = graph_of(number);
  const ClosedWalk a = graph.walk_of(any_loop(surface, TileId(0)));
  const ClosedWalk b = graph.walk_of(any_loop(surface, TileId(0)));
  RC_PRE(!a.empty() && !b.empty() && a != b && graph.reversed(a) != b);
  RC_PRE(RadialGraph::power_of(a) == 1 && RadialGraph::power_of(b) == 1);
  const LiftedTiles tiles(surface);
  for (const WalkCrossing& crossing : graph.crossings(a, b)) {
    const auto [first, second, way] = graph.crossing_paths(a, b, crossing);
    RC_ASSERT(is_path(surface, TileId(0), TileId(0), way));
    RC_ASSERT(graph.walk_of(first) == a);
    RC_ASSERT(graph.walk_of(second) == b);
    const Vector point = lorentz_cross(axis_normal(tiles.value(first)), axis_normal(tiles.value(second)));
    RC_ASSERT(lorentz_product(point, point) < 0);
  }
}

RC_GTEST_PROP(RadialGraph, EdgesAroundAQuadrilateralAreItsSides, ()) {
  // A walk around a quadrilateral is trivial: this is what `homology` and `across` rest on.
  const RadialGraph& graph = graph_of(*any_surface());
  const std::vector<std::uint32_t>& partner = graph.partners();
  const std::uint32_t k = *rc::gen::inRange<std::uint32_t>(0, graph.size());
  const ClosedWalk around{k, (partner[k] + 1) % graph.size(), partner[k], (k + 1) % graph.size()};
  RC_ASSERT(graph.homology(around) == std::vector<std::int64_t>(graph.basis().size()));
  RC_ASSERT(graph.reversed(around).empty());
}

}  // namespace
}  // namespace epsnet::radial_graph_test
