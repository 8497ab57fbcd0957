#include "triangulation/surface/atlas.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>
#include <set>

#include "kernel/plane.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"

namespace epsnet::atlas_test {
namespace {

using test::any_index;
using test::any_share;
using test::any_surface;
using test::any_word;
using test::gallery;

/// The chart of a tile whose origin is a vertex of the tile.
Chart corner_chart(const Surface& surface, TileId tile, std::uint32_t k) { return {tile, surface.tile(tile)[k]}; }

/// An atlas of three charts of tile 0: at two of its corners and at 0.
Atlas three_charts(const Surface& surface) {
  Atlas atlas(surface);
  (void)atlas.add_chart(corner_chart(surface, TileId(0), 0));
  (void)atlas.add_chart(corner_chart(surface, TileId(0), 3));
  (void)atlas.add_chart({TileId(0), {}});
  return atlas;
}

/// The value of a word of one tile over Q(i), up to a real factor.
Isometry<Rational> exact_value(const Surface& surface, const Word& word) {
  Isometry<Rational> result;
  for (const SideId s : word) {
    result = surface.crossing(s) * result;
  }
  return result;
}

/// Two isometries are equal if they agree at two points.
bool equal(const Isometry<Rational>& f, const Isometry<Rational>& g) {
  const Complex<Rational> half{Rational(1, 2), Rational(0)};
  return f({}) == g({}) && f(half) == g(half);
}

Complex<double> any_point_of_disk(double radius) {
  const double r = radius * std::sqrt(any_share());
  const double angle = 6.28 * any_share();
  return {r * std::cos(angle), r * std::sin(angle)};
}

template <class T>
T separation(const Complex<T>& z, const Complex<T>& w) {
  return sqrt(T(norm(z - w)));
}

TEST(Atlas, TheEmptyWordIsTheIdentityOfAChartOnly) {
  const Surface& surface = gallery()[0].surface;
  Atlas atlas = three_charts(surface);
  EXPECT_EQ(atlas.label(ChartId(1), ChartId(1), {}), kIdentity);
  EXPECT_NE(atlas.label(ChartId(0), ChartId(1), {}), kIdentity);
  EXPECT_NE(atlas.label(ChartId(0), ChartId(1), {}), atlas.label(ChartId(1), ChartId(0), {}));
  EXPECT_EQ(atlas.inverse(atlas.label(ChartId(0), ChartId(1), {})), atlas.label(ChartId(1), ChartId(0), {}));
}

TEST(Atlas, RelatorsAreTheIdentity) {
  for (const auto& [name, surface] : gallery()) {
    Atlas atlas = three_charts(surface);
    for (const SideId side : surface.side_ids()) {
      Word word = surface.corner_cycle(side);
      EXPECT_EQ(atlas.label(ChartId(0), ChartId(0), word), kIdentity) << name << ", side " << side.number();
      EXPECT_EQ(atlas.label(ChartId(1), ChartId(1), reversed(surface, word)), kIdentity)
          << name << ", side " << side.number();
      word.pop_back();
      EXPECT_NE(atlas.label(ChartId(0), ChartId(0), word), kIdentity) << name << ", side " << side.number();
    }
  }
}

TEST(Atlas, EverySideIsAnotherLabelAndKnowsItsCharts) {
  for (const auto& [name, surface] : gallery()) {
    Atlas atlas = three_charts(surface);
    std::set<LabelId> labels;
    for (const SideId side : surface.side_ids()) {
      const LabelId l = atlas.label(ChartId(2), ChartId(1), {side});
      EXPECT_EQ(atlas.labels()[l].from, ChartId(2));
      EXPECT_EQ(atlas.labels()[l].to, ChartId(1));
      EXPECT_EQ(atlas.labels()[l].word, Word{side});
      labels.insert(l);
    }
    EXPECT_EQ(labels.size(), surface.side_count()) << name;
    EXPECT_EQ(atlas.labels().to(ChartId(1)).size(), labels.size()) << name;
    EXPECT_EQ(atlas.labels().count(), labels.size() + 1) << name;
  }
}

TEST(Atlas, LabelsOfASurfaceOfManyTiles) {
  // The crossing of one diagonal of an octagon cut into tiles, there and back again.
  const Surface octagon = random_octagon(123);
  const Tile& v = octagon.tiles()[0];
  const Surface surface({{v[0], v[1], v[2], v[3], v[4]}, {v[4], v[5], v[6], v[7], v[0]}},
                        {{0, 0, 1, 0}, {0, 1, 1, 1}, {0, 2, 1, 2}, {0, 3, 1, 3}, {0, 4, 1, 4}});
  Atlas atlas(surface);
  (void)atlas.add_chart({TileId(0), {}});
  (void)atlas.add_chart({TileId(1), {}});
  const LabelId across = atlas.label(ChartId(0), ChartId(1), {SideId(4)});
  EXPECT_NE(across, kIdentity) << "another chart, though the same coordinates";
  EXPECT_EQ(atlas.inverse(across), atlas.label(ChartId(1), ChartId(0), {SideId(9)}));
  EXPECT_EQ(atlas.product(atlas.inverse(across), across), kIdentity);
  const Complex<double> z{0.25, -0.5};
  EXPECT_EQ(atlas.lift<Mp256>(across, z), convert<Mp256>(z));
}

TEST(Atlas, RefusesClosedGeodesicsThatAreTooShort) {
  const Surface surface = load_surface(EPSNET_TEST_DATA "/surfaces/cuff-1e-28.json");
  try {
    const Atlas atlas(surface);
    ADD_FAILURE() << "no error";
  } catch (const LimitError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("tile 0 is too thin: closed geodesics through it may be as short as 5.0e-29"));
  }
}

TEST(Atlas, PathsThatLeadFarAreFollowedUpToALength) {
  // Side 0 of a pair of pants leads around a cuff, here of length 1.
  const Surface surface = fenchel_nielsen_surface({PantsGraph::parse("0-0 0-1 1-1"), {1, 1, 1}, {0, 0, 0}});
  Atlas atlas(surface);
  (void)atlas.add_chart({TileId(0), {}});
  EXPECT_NE(atlas.label(ChartId(0), ChartId(0), Word(500, SideId(0))), kIdentity);
  EXPECT_THROW((void)atlas.label(ChartId(0), ChartId(0), Word(900, SideId(0))), LimitError);
}

TEST(Word, ReversedAndConcatenatedUndoEachOther) {
  const Surface& surface = gallery()[1].surface;
  const Word word = word_of_letters({0, 3, 3, 6, 1});
  EXPECT_EQ(reversed(surface, reversed(surface, word)), word);
  EXPECT_EQ(concatenated(surface, word, reversed(surface, word)), Word{});
  EXPECT_EQ(concatenated(surface, word_of_letters({0, 3}), {surface.partner(SideId(3)), SideId(5)}),
            word_of_letters({0, 5}));
}

RC_GTEST_PROP(AtlasProperty, EqualWordsAreOneLabel, ()) {
  const Surface& surface = any_surface().surface;
  Atlas atlas = three_charts(surface);
  const Word word = any_word(surface, TileId(0), 6);
  const ChartId from(any_index(3u));
  const ChartId to(any_index(3u));
  const LabelId label = atlas.label(from, to, word);
  // A detour around a vertex, or over a side and back, anywhere on the way.
  Word longer = word;
  const SideId side(any_index(surface.side_count()));
  const Word detour = any_index(2u) == 0 ? Word{side, surface.partner(side)} : surface.corner_cycle(side);
  longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(any_index(word.size() + 1)), detour.begin(), detour.end());
  RC_ASSERT(atlas.label(from, to, longer) == label);
}

RC_GTEST_PROP(AtlasProperty, LabelsAreEqualIfAndOnlyIfTheirIsometriesAre, ()) {
  const Surface& surface = any_surface().surface;
  Atlas atlas = three_charts(surface);
  const Word word = any_word(surface, TileId(0), 3);
  Word other = any_word(surface, TileId(0), 3);
  // Half of the time the rest of a relator, so that short words can be equal.
  if (any_index(2u) == 0) {
    const Word around = surface.corner_cycle(SideId(any_index(surface.side_count())));
    other = concatenated(surface, word, around);
    const auto last = std::min<std::size_t>(other.size(), any_index<std::size_t>(2));
    other.resize(other.size() - last);
  }
  const bool same = equal(exact_value(surface, word), exact_value(surface, other));
  RC_CLASSIFY(same);
  RC_ASSERT((atlas.label(ChartId(1), ChartId(2), word) == atlas.label(ChartId(1), ChartId(2), other)) == same);
}

RC_GTEST_PROP(AtlasProperty, ProductsAndInversesAreThoseOfTheGroup, ()) {
  const Surface& surface = any_surface().surface;
  Atlas atlas = three_charts(surface);
  const Word u = any_word(surface, TileId(0), 4);
  const Word v = any_word(surface, TileId(0), 4);
  const Word w = any_word(surface, TileId(0), 4);
  const LabelId f = atlas.label(ChartId(2), ChartId(0), u);
  const LabelId g = atlas.label(ChartId(1), ChartId(2), v);
  const LabelId h = atlas.label(ChartId(0), ChartId(1), w);
  RC_ASSERT(atlas.product(f, g) == atlas.label(ChartId(1), ChartId(0), concatenated(surface, v, u)));
  RC_ASSERT(atlas.product(atlas.product(f, g), h) == atlas.product(f, atlas.product(g, h)));
  RC_ASSERT(atlas.inverse(atlas.inverse(f)) == f);
  RC_ASSERT(atlas.inverse(f) == atlas.label(ChartId(0), ChartId(2), reversed(surface, u)));
  RC_ASSERT(atlas.product(f, atlas.inverse(f)) == kIdentity);
  RC_ASSERT(atlas.product(atlas.inverse(f), f) == kIdentity);
  RC_ASSERT(atlas.inverse(atlas.product(f, g)) == atlas.product(atlas.inverse(g), atlas.inverse(f)));
  RC_ASSERT(atlas.product(f, kIdentity) == f);
  RC_ASSERT(atlas.product(kIdentity, f) == f);
}

RC_GTEST_PROP(AtlasProperty, LiftsAgreeAtAllPrecisionsWithinTheirErrors, ()) {
  const Surface& surface = any_surface().surface;
  Atlas atlas = three_charts(surface);
  const LabelId l = atlas.label(ChartId(any_index(3u)), ChartId(any_index(3u)), any_word(surface, TileId(0), 5));
  RC_PRE(l != kIdentity);
  const Complex<double> z = any_point_of_disk(0.75);
  const Complex<double> rounded = atlas.isometry(l)(z);
  const Complex<Mp256> at_256 = atlas.lift<Mp256>(l, z);
  const Complex<Mp1024> at_1024 = atlas.lift<Mp1024>(l, z);
  const Complex<Mp4096> at_4096 = atlas.lift<Mp4096>(l, z);
  RC_ASSERT(norm(at_4096) < 1);
  RC_ASSERT(separation(convert<Mp256>(rounded), at_256) <= Mp256(atlas.error(l)));
  RC_ASSERT(separation(convert<Mp1024>(at_256), at_1024) <= Mp1024(Atlas::lift_error<Mp256>()));
  RC_ASSERT(separation(convert<Mp4096>(at_1024), at_4096) <= Mp4096(Atlas::lift_error<Mp1024>()));
}

RC_GTEST_PROP(AtlasProperty, ProductsAreRoundedAsTheirWordsAre, ()) {
  // However long the chain of products that a label comes from.
  const Surface& surface = any_surface().surface;
  Atlas atlas = three_charts(surface);
  LabelId product = atlas.label(ChartId(any_index(3u)), ChartId(0), any_word(surface, TileId(0), 2));
  for (int i = 0; i < 12; ++i) {
    const ChartId to(any_index(3u));
    const ChartId at = product == kIdentity ? to : atlas.labels()[product].to;
    const LabelId step = atlas.label(at, to, any_word(surface, TileId(0), 1));
    product = any_index(4u) == 0 ? atlas.inverse(atlas.product(step, product)) : atlas.product(step, product);
    if (product == kIdentity) continue;
    const Isometry<double> rounded = atlas.isometry(product);
    Isometry<Mp256> precise = atlas.isometry_in<Mp256>(product);
    if (norm(convert<double>(precise.a) - rounded.a) > 1) precise = {-precise.a, -precise.b};
    const double size = std::sqrt(norm(rounded.a)) + std::sqrt(norm(rounded.b));
    const auto off = [&](const Mp256& exact, double x) {
      return static_cast<double>(abs(Mp256(exact - x))) > kUnitRoundoff * std::abs(x) + 0x1p-63 * size;
    };
    RC_ASSERT(!off(precise.a.x, rounded.a.x) && !off(precise.a.y, rounded.a.y));
    RC_ASSERT(!off(precise.b.x, rounded.b.x) && !off(precise.b.y, rounded.b.y));
  }
}

RC_GTEST_PROP(AtlasProperty, LiftsAreTheWordsValues, ()) {
  // Against Q(i): frame, crossings, frame back.
  const Surface& surface = any_surface().surface;
  Atlas atlas = three_charts(surface);
  const Word word = any_word(surface, TileId(0), 3);
  const LabelId l = atlas.label(ChartId(0), ChartId(1), word);
  const Complex<double> z = any_point_of_disk(0.75);
  const auto frame = [&](ChartId c) { return Isometry<Rational>::translation(atlas.charts()[c].centre); };
  const Complex<Rational> exact =
      inverse(frame(ChartId(1)))(exact_value(surface, word)(frame(ChartId(0))(convert<Rational>(z))));
  RC_ASSERT(separation(atlas.lift<Mp1024>(l, z), convert<Mp1024>(exact)) <= Atlas::lift_error<Mp1024>());
}

RC_GTEST_PROP(AtlasProperty, PlaceKeepsThePoint, ()) {
  const Surface& surface = any_surface().surface;
  Atlas atlas = three_charts(surface);
  const ChartId c(any_index(3u));
  const Complex<Mp256> z = convert<Mp256>(any_point_of_disk(0.999));
  const bool exact = any_index(2u) == 1;
  const auto found =
      atlas.lifted_point(c, convert<Mp1024>(z), exact ? Atlas::Precision::bits_256 : Atlas::Precision::binary64);
  RC_ASSERT(found.has_value());
  const LiftedPoint& place = *found;
  RC_ASSERT(norm(place.z) <= kChartRadius * kChartRadius);
  RC_ASSERT((place.label == kIdentity ? c : atlas.labels()[place.label].from) == place.chart);
  RC_ASSERT((place.label == kIdentity ? c : atlas.labels()[place.label].to) == c);
  const Complex<Mp256> back = atlas.lift<Mp256>(place.label, place.z);
  // Hyperbolic distances: rounding to binary64 near the origin moves a point by some 2⁻⁵³; `bits_256` by nothing that
  // 256 bits lose on the way.
  const double moved = static_cast<double>(distance(back, z));
  RC_ASSERT(moved <= (exact ? 0x1p-130 : 0x1p-50));
}

/// The Bolza surface as six regular octagons, three around each corner: the map T2.1 of Conder's list.
Surface six_octagons() {
  return Surface::map({8, 3}, {{0, 0, 1, 0}, {1, 7, 2, 1}, {2, 0, 0, 1}, {0, 7, 4, 7}, {2, 7, 3, 0}, {3, 1, 5, 5},
                               {4, 0, 3, 2}, {0, 2, 3, 7}, {0, 3, 4, 3}, {0, 4, 1, 4}, {0, 5, 2, 4}, {0, 6, 3, 3},
                               {4, 6, 1, 1}, {4, 5, 5, 0}, {5, 1, 3, 5}, {2, 2, 5, 2}, {1, 2, 5, 7}, {1, 3, 2, 5},
                               {1, 5, 4, 2}, {1, 6, 5, 3}, {5, 4, 4, 1}, {2, 3, 3, 4}, {2, 6, 5, 6}, {3, 6, 4, 4}});
}

TEST(Atlas, APointAtACornerOfRoundedTilesHasAPlace) {
  // Nearer to the corner than its rounding, the point may be beyond a side of every tile around it.
  for (const Surface& surface : {six_octagons(), Surface::regular(2)}) {
    for (const SideId s : surface.side_ids()) {
      const TileId tile = surface.tile_of_side(s);
      Atlas atlas(surface);
      const ChartId chart = atlas.add_chart({tile, {}});
      const auto corner = convert<Mp1024>(surface.tile(tile)[surface.place_in_tile(s)]);
      for (const int bits : {240, 256, 300, 900}) {
        const Mp1024 step = ldexp(Mp1024(1), -bits);
        for (const int x : {-1, 0, 1}) {
          for (const int y : {-1, 0, 1}) {
            const Complex<Mp1024> z{corner.x + x * step, corner.y + y * step};
            const auto place = atlas.lifted_point(chart, z, Atlas::Precision::binary64);
            ASSERT_TRUE(place.has_value()) << s.number() << ", " << bits << " bits";
            const Complex<Mp256> back = atlas.lift<Mp256>(place->label, place->z);
            EXPECT_LE(static_cast<double>(distance(back, convert<Mp256>(z))), 0x1p-50);
          }
        }
      }
    }
  }
}

TEST(Atlas, APointTooFarAwayHasNoPlace) {
  // Two units of length along a closed geodesic of length 1e-6 are millions of tiles.
  const Surface& surface = test::tiled_gallery().back().surface;
  Atlas atlas(surface);
  bool found = false;
  for (const SideId s : surface.side_ids()) {
    const TileId tile = surface.tile_of_side(s);
    const TileId beyond = surface.tile_of_side(surface.partner(s));
    for (const SideId then : surface.sides_of(beyond)) {
      if (found) break;
      const auto turn = normalized(convert<Mp1024>(surface.crossing(then) * surface.crossing(s)));
      const auto around = axis(turn);
      found = surface.tile_of_side(surface.partner(then)) == tile && around && displacement_length(turn) < 1e-5;
      if (!found) continue;
      const ChartId chart = atlas.add_chart({tile, {}});
      for (const double distance : {-3.0, 3.0}) {
        const LorentzVector<Mp1024> ends = LorentzVector<Mp1024>{around->from.x, around->from.y, 1} +
                                           exp(Mp1024(distance)) * LorentzVector<Mp1024>{around->to.x, around->to.y, 1};
        const Complex<Mp1024> z = in_disk(Mp1024(1 / sqrt(Mp1024(-lorentz_product(ends, ends)))) * ends);
        EXPECT_FALSE(atlas.lifted_point(chart, z, Atlas::Precision::binary64).has_value());
      }
    }
  }
  EXPECT_TRUE(found);
}

RC_GTEST_PROP(AtlasProperty, PlaceNearbyIsTheSamePoint, ()) {
  const Surface& surface = any_surface().surface;
  Atlas atlas = three_charts(surface);
  const ChartId c(any_index(3u));
  const Complex<double> z = any_point_of_disk(0.95);
  const auto known = atlas.lifted_point(c, convert<Mp1024>(z), Atlas::Precision::binary64);
  RC_ASSERT(known.has_value());
  const auto nearby = atlas.lifted_point_nearby(c, z);
  // By now there is a label that leads near enough, unless `place` found the chart itself.
  RC_ASSERT(nearby.has_value() || known->label == kIdentity);
  RC_PRE(nearby.has_value());
  RC_ASSERT(norm(nearby->z) <= kChartRadius * kChartRadius);
  RC_ASSERT(atlas.labels()[nearby->label].from == nearby->chart);
  RC_ASSERT(atlas.labels()[nearby->label].to == c);
  RC_ASSERT(separation(atlas.lift<Mp256>(nearby->label, nearby->z), convert<Mp256>(z)) <=
            Mp256(4 * atlas.error(nearby->label)));
}

}  // namespace
}  // namespace epsnet::atlas_test
