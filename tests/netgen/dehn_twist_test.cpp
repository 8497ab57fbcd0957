#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"
#include "triangulation/surface/surface.h"

namespace epsnet::dehn_twist_test {
namespace {

/// The image of a path, by those of its letters.
Word image_of(const Surface& surface, const ById<SideId, Word>& images, const Word& word) {
  Word result;
  for (const SideId s : word) result = concatenated(surface, std::move(result), images[s]);
  return result;
}

/// Whether two paths with the same ends are homotopic, exactly.
bool same(const Surface& surface, const Word& a, const Word& b) {
  Word word = a;
  const Word back = reversed(surface, b);
  word.insert(word.end(), back.begin(), back.end());
  const Isometry<Rational> f = exact_isometry(surface, word);
  return f.b == Complex<Rational>{} && f.a.y == 0;
}

double length(const Surface& surface, const Word& word) {
  const EnclosedNumber a = enclosed_isometry(surface, word, 100).a_re;
  return 2 * std::acosh(std::abs(static_cast<double>(a.lower)));
}

/// The paths from tile 0 to itself that pair the sides of the fundamental polygon.
std::vector<Word> generators(const Surface& surface) {
  std::vector<Word> result;
  for (const auto& side : fundamental_polygon(surface).sides) result.push_back(side.word);
  return result;
}

/// An octagon, or a surface of pants of genus 2 or 3.
Surface any_surface() {
  const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1000);
  const auto kind = *rc::gen::inRange<std::uint32_t>(1, 4);
  if (kind == 1) return random_octagon(static_cast<std::int32_t>(seed));
  return fenchel_nielsen_surface(random_coordinates(PantsGraph::random(kind, seed), seed));
}

// Geodesics that pass through vertices of tiles, the middles of sides, and along them.
TEST(DehnTwist, RespectsTheRelationsWhereAGeodesicMeetsTheTilesSymmetrically) {
  for (const Surface& surface : {named_surface("bolza"), named_surface("klein"), named_surface("bring")}) {
    const auto document = unproved::systole(surface);
    for (const auto& geodesic : document.geodesics) {
      const ById<SideId, Word> images = dehn_twist_words(surface, word_of_letters(geodesic.word));
      for (const SideId s : surface.side_ids()) {
        const Word cycle = surface.corner_cycle(s);
        const Word image = image_of(surface, images, cycle);
        if (!image.empty()) {
          EXPECT_LT(length(surface, image), 1e-9) << s.number();
        }
      }
    }
  }
}

RC_GTEST_PROP(DehnTwistProperty, IsAnAutomorphismThatIsUndone, ()) {
  const Surface surface = any_surface();
  PantsOptions options;
  options.own = false;
  const PantsDecomposition pants = pants_decomposition(surface, options);
  const auto number = *rc::gen::inRange<std::size_t>(0, pants.cuffs.size());
  const Word curve = pants.cuffs[number].curve;
  const auto power = *rc::gen::inRange<std::int32_t>(1, 4);
  const ById<SideId, Word> there = dehn_twist_words(surface, curve, power);
  const ById<SideId, Word> back = dehn_twist_words(surface, curve, -power);
  bool changed = false;
  for (const SideId s : surface.side_ids()) {
    RC_ASSERT(same(surface, image_of(surface, back, there[s]), {s}));
    RC_ASSERT(same(surface, there[surface.partner(s)], reversed(surface, there[s])));
    RC_ASSERT(same(surface, image_of(surface, there, surface.corner_cycle(s)), surface.corner_cycle(s)));
    changed = changed || !same(surface, there[s], {s});
  }
  RC_ASSERT(changed);
  // All cuffs keep their lengths, as they are disjoint from the curve.
  for (const auto& cuff : pants.cuffs) {
    RC_ASSERT(std::abs(length(surface, image_of(surface, there, cuff.curve)) - cuff.length.lower) < 1e-9);
  }
}

RC_GTEST_PROP(DehnTwistProperty, TheSurfaceIsTheSameByOtherTiles, ()) {
  const Surface surface = any_surface();
  const PantsDecomposition pants = pants_decomposition(surface);
  const auto number = *rc::gen::inRange<std::size_t>(0, pants.cuffs.size());
  const Word curve = pants.cuffs[number].curve;
  const auto power = *rc::gen::element(-2, -1, 1, 3);
  // Triangles, with words that stand for the same elements.
  const Surface start = dehn_twisted(surface, curve, 0);
  const PantsDecomposition again = pants_decomposition(start);
  const Word& along = again.cuffs[0].curve;
  const Surface twisted = dehn_twisted(start, along, power);
  RC_ASSERT(twisted.gluing() == start.gluing());
  const ById<SideId, Word> images = dehn_twist_words(start, along, power);
  const Surface back = dehn_twisted(twisted, along, -power);
  for (const Word& word : generators(start)) {
    RC_ASSERT(std::abs(length(twisted, word) - length(start, image_of(start, images, word))) < 1e-9);
    RC_ASSERT(std::abs(length(back, word) - length(start, word)) < 1e-9);
  }
  RC_ASSERT(std::abs(length(twisted, along) - length(start, along)) < 1e-9);
}

TEST(DehnTwist, TheTwistedSurfaceIsIsometric) {
  for (const std::int32_t seed : {5, 123}) {
    const Surface surface = random_octagon(seed);
    const Word curve = pants_decomposition(surface).cuffs[0].curve;
    for (const std::int32_t power : {-1, 1, 2}) {
      const Surface twisted = dehn_twisted(surface, curve, power);
      EXPECT_EQ(twisted.tiles().size(), 6U);
      EXPECT_EQ(isometric(surface, twisted).kind, IsometricAnswer::Kind::yes);
    }
  }
}

TEST(DehnTwist, SurfacesOverAFieldAreTwistedOverTheField) {
  const Surface surface = fenchel_nielsen_surface(
      resolve({"theta", std::nullopt, std::nullopt, {"2*arcosh(3/2)", "2*log(3)", "arcosh(1+sqrt(2))"}, {"0"}}));
  ASSERT_TRUE(surface.field_tiles());
  // Over two cuffs, along seams: it meets both of them, and what goes around one of them.
  const Word curve{surface.side_number(TileId(0), 6), surface.side_number(TileId(1), 1)};
  const Surface twisted = dehn_twisted(surface, curve, 2);
  EXPECT_EQ(twisted.tiles().size(), 10U);
  EXPECT_EQ(isometric(surface, twisted).kind, IsometricAnswer::Kind::yes);
  const Surface start = dehn_twisted(surface, curve, 0);
  EXPECT_EQ(start.gluing(), twisted.gluing());
  const ById<SideId, Word> images = dehn_twist_words(surface, curve, 2);
  // Sides of heptagons are sides 0, 1 and 2 of the first, the middle ones and the last triangle.
  const auto side_of_triangle = [&](SideId s) {
    const std::uint32_t k = surface.place_in_tile(s);
    const std::uint32_t first = 5 * surface.tile_of_side(s).number();
    return k == 0   ? start.side_number(TileId(first), 0)
           : k == 6 ? start.side_number(TileId(first + 4), 2)
                    : start.side_number(TileId(first + k - 1), 1);
  };
  for (const SideId s : surface.side_ids()) {
    // There and back through one tile, as far as a path closes up.
    if (surface.tile_of_side(s) != surface.tile_of_side(surface.partner(s))) continue;
    const SideId t = side_of_triangle(s);
    // From the triangle beyond back to that before, over diagonals.
    Word path{t};
    const auto triangle = [&](SideId side) { return start.tile_of_side(side).number(); };
    for (std::uint32_t i = triangle(start.partner(t)); i != triangle(t);) {
      const bool up = i < triangle(t);
      path.push_back(start.side_number(TileId(i), up ? 2 : 0));
      i = up ? i + 1 : i - 1;
    }
    EXPECT_NEAR(length(twisted, path), length(surface, images[s]), 1e-9) << s.number();
  }
}

TEST(DehnTwist, TurnsLeftAsTwistsDo) {
  // The tiles of a surface are those of the twist modulo the length, between −½ and ½ of it.
  const Rational nearly(999'999'999, 2'000'000'000);
  const auto surface = [&](const Rational& turns) {
    return fenchel_nielsen_surface({PantsGraph::parse("0-1 0-1 0-1"), {2, 2, 2}, {2 * turns, 0, 0}});
  };
  const Surface before = surface(nearly);
  const Surface after = surface(-nearly);
  const Word curve = pants_decomposition(after).cuffs[0].curve;
  // Into the other pants through one cuff, and back through another one.
  const Word across{SideId(6), after.partner(SideId(1))};
  const ById<SideId, Word> left = dehn_twist_words(after, curve, 1);
  const ById<SideId, Word> right = dehn_twist_words(after, curve, -1);
  const double expected = length(before, across);
  EXPECT_NEAR(length(after, image_of(after, left, across)), expected, 1e-7);
  EXPECT_GT(length(after, image_of(after, right, across)), expected + 0.1);
}

TEST(DehnTwist, TwistsFlow) {
  const Surface surface = random_octagon(5);
  const PantsDecomposition pants = pants_decomposition(surface);
  const Word& curve = pants.cuffs[0].curve;
  const Surface moved = twisted(surface, curve, Rational(1, 10));
  const PantsDecomposition after = pants_decomposition(moved);
  EXPECT_NEAR(after.cuffs[0].length.lower, pants.cuffs[0].length.lower, 1e-12);
  PantsOptions along;
  along.curves = {curve};
  EXPECT_NEAR(after.cuffs[0].twist.lower, pants_decomposition(surface, along).cuffs[0].twist.lower + 0.1, 1e-12);
  // Once around, and the surface is the same but for rounding.
  const PantsDecomposition around = pants_decomposition(twisted(surface, curve, Rational(pants.cuffs[0].length.lower)));
  EXPECT_NEAR(around.cuffs[0].twist.lower, pants_decomposition(twisted(surface, curve, 0)).cuffs[0].twist.lower, 1e-12);
}

TEST(DehnTwist, Refusals) {
  const Surface surface = random_octagon(5);
  const Word curve = pants_decomposition(surface).cuffs[0].curve;
  EXPECT_THROW(static_cast<void>(dehn_twisted(surface, {})), CurveError);
  EXPECT_THROW(static_cast<void>(dehn_twist_words(surface, {SideId(0), surface.partner(SideId(0))})), CurveError);
  EXPECT_THROW(static_cast<void>(dehn_twist_words(surface, curve, kMostTwists + 1)), LimitError);
  const Surface bolza = Surface::regular(2);
  EXPECT_THROW(static_cast<void>(dehn_twisted(bolza, {SideId(0)})), SurfaceError);
  EXPECT_EQ(dehn_twist_words(bolza, {SideId(0)}).size(), 8U);
}

}  // namespace
}  // namespace epsnet::dehn_twist_test
