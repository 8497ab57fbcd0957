#include "triangulation/surface/surface.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"
#include "triangulation/surface/exact_polygons.h"

namespace epsnet::surface_test {
namespace {

using test::PairedPolygon;
using testing::HasSubstr;

PairedPolygon octagon() { return test::paired_polygon(random_octagon(123)); }

template <class... Arguments>
std::string complaint(const Arguments&... arguments) {
  try {
    static_cast<void>(Surface(arguments...));
  } catch (const SurfaceError& error) {
    return error.what();
  }
  return "accepted";
}

std::string complaint(const PairedPolygon& polygon) {
  return complaint(std::vector<Tile>{polygon.vertices}, polygon.gluing());
}

Rational ratio(long p, long q) { return {p, q}; }

TEST(Surface, OctagonHasGenusTwoAndOneVertex) {
  const Surface surface = octagon().surface();
  EXPECT_EQ(surface.genus(), 2U);
  EXPECT_EQ(surface.side_count(), 8U);
  EXPECT_EQ(surface.vertex_class_count(), 1U);
  EXPECT_EQ(surface.partner(SideId(1)), SideId(5));
  EXPECT_EQ(surface.partner(SideId(5)), SideId(1));
}

TEST(Surface, CrossingTakesASideToItsPartnerReversed) {
  for (const auto& path : test::data_files("polygons")) {
    const Surface surface = test::imported(path);
    ASSERT_EQ(surface.tiles().size(), 1U);
    const Tile& tile = surface.tiles()[0];
    for (std::uint32_t s = 0; s < surface.side_count(); ++s) {
      const std::uint32_t other = surface.partner(SideId(s)).number();
      EXPECT_EQ(surface.crossing(SideId(s))(tile[s]), tile[(other + 1) % tile.size()]) << path << " side " << s;
      EXPECT_EQ(surface.crossing(SideId(s))(tile[(s + 1) % tile.size()]), tile[other]) << path << " side " << s;
      EXPECT_GT(surface.crossing(SideId(s)).determinant(), 0);
    }
  }
}

TEST(Surface, CrossingBetweenOppositeSidesIsATranslation) {
  // In a symmetric octagon the crossing of opposite sides commutes with z ↦ −z; its axis passes through 0 and its a is
  // real.
  const Surface surface = octagon().surface();
  for (std::uint32_t s = 0; s < 8; ++s) EXPECT_EQ(surface.crossing(SideId(s)).a.y, 0);
}

TEST(Surface, EveryVertexIsInTheOpenDisk) {
  PairedPolygon polygon = octagon();
  polygon.vertices[3] = {ratio(-3, 2), 1};
  EXPECT_THAT(complaint(polygon),
              HasSubstr("vertex 3 lies outside of the unit circle, expected |z| < 1, found |z| = 1.8"));
  polygon.vertices[3] = {ratio(-3, 5), ratio(4, 5)};
  EXPECT_THAT(complaint(polygon), HasSubstr("vertex 3 lies on the unit circle"));
}

TEST(Surface, AClockwiseTileIsRefused) {
  const PairedPolygon polygon = octagon();
  PairedPolygon reversed = polygon;
  std::reverse(reversed.vertices.begin(), reversed.vertices.end());
  EXPECT_THAT(complaint(reversed), HasSubstr("clockwise"));
}

TEST(Surface, TilesAreStrictlyConvex) {
  PairedPolygon polygon = octagon();
  polygon.vertices[2] = {ratio(1, 100), ratio(1, 10)};
  EXPECT_THAT(complaint(polygon), HasSubstr("the polygon is not strictly convex at its vertex 2 (interior angle "));
  polygon = test::with_vertex_on_side(octagon(), 2, ratio(1, 3));
  EXPECT_THAT(complaint(polygon), HasSubstr("not strictly convex at its vertex 3 (interior angle 3.14159"));
}

TEST(Surface, ATileThatWindsSeveralTimesIsRefused) {
  PairedPolygon star = octagon();
  const Tile vertices = star.vertices;
  for (std::size_t k = 0; k < 8; ++k) star.vertices[k] = vertices[3 * k % 8];
  EXPECT_THAT(complaint(star), HasSubstr("winds around 3 times"));
}

TEST(Surface, ASideOfLengthZeroIsRefused) {
  PairedPolygon polygon = octagon();
  polygon.vertices[5] = polygon.vertices[4];
  EXPECT_THAT(complaint(polygon), HasSubstr("side 4 has length 0"));
}

TEST(Surface, PairedSidesHaveExactlyEqualLengths) {
  PairedPolygon polygon = octagon();
  polygon.vertices[3].x += ratio(1, 1000);
  EXPECT_THAT(complaint(polygon),
              testing::MatchesRegex("side 2 \\(length .*\\) and side 6 \\(length .*\\) are paired but differ"));
  polygon = octagon();
  polygon.vertices[3].x += Rational(1) / Rational("1" + std::string(100, '0'));
  EXPECT_THAT(complaint(polygon), HasSubstr("are paired but differ in later digits"));
}

TEST(Surface, AnglesAroundAVertexAddUpToExactly2Pi) {
  // CGAL's code calls a net of this one certified.
  for (const Rational& step : {ratio(1, 1000), ratio(-1, 1000), Rational(1) / Rational("1" + std::string(200, '0'))}) {
    PairedPolygon polygon = octagon();
    polygon.vertices[3].x += step;
    polygon.vertices[7].x -= step;
    EXPECT_THAT(complaint(polygon), HasSubstr("the 8 angles around vertex 0 add up to 6.2"));
    EXPECT_THAT(complaint(polygon), HasSubstr("not to 2*pi"));
  }
}

TEST(Surface, AConePointOfTwoFullTurnsIsRefused) {
  // The double cover of a surface with two vertices that swaps the sheets across one edge between them: every product
  // around a vertex is the identity, but the two vertices have angle 4π.
  const Surface base = read_domain(test::domain_text(test::with_vertex_on_side(octagon(), 2, ratio(1, 3))), "test");
  ASSERT_EQ(base.vertex_class_count(), 2U);
  std::vector<Tile> tiles = base.tiles();
  tiles.insert(tiles.end(), base.tiles().begin(), base.tiles().end());
  const auto sheet = static_cast<std::uint32_t>(base.tiles().size());
  bool branched = false;
  std::vector<Gluing> gluing;
  for (const auto& [t, s, other_t, other_s] : base.gluing()) {
    const bool joins = base.vertex_class(base.side_number(TileId(t), s)) !=
                       base.vertex_class(base.side_number(TileId(t), (s + 1) % 3));
    const std::uint32_t swap = joins && !branched ? sheet : 0;
    branched = branched || joins;
    gluing.push_back({t, s, other_t + swap, other_s});
    gluing.push_back({t + sheet, s, other_t + sheet - swap, other_s});
  }
  ASSERT_TRUE(branched);
  EXPECT_THAT(complaint(tiles, gluing), HasSubstr("add up to 2 full turns, expected one"));
}

TEST(Surface, EverySideIsPairedOnceWithAnotherOne) {
  const std::vector<Tile> tiles{octagon().vertices};
  const std::vector<Gluing> good = octagon().gluing();
  EXPECT_THAT(complaint(tiles, std::vector<Gluing>(good.begin(), good.end() - 1)), HasSubstr("side 3 is not paired"));
  auto gluing = good;
  gluing[1].other_side = 4;
  EXPECT_THAT(complaint(tiles, gluing), HasSubstr("side 4 occurs twice"));
  gluing = good;
  gluing[1].other_side = 1;
  EXPECT_THAT(complaint(tiles, gluing), HasSubstr("side 1 is paired with itself"));
  gluing[1].other_side = 8;
  EXPECT_THAT(complaint(tiles, gluing), HasSubstr("pair 1 of the gluing names side 8"));
  gluing[1].other_tile = 4'000'000'000;
  EXPECT_THAT(complaint(tiles, gluing), HasSubstr("pair 1 of the gluing names tile 4000000000"));
}

TEST(Surface, TheGenusIsAtLeast2) {
  PairedPolygon polygon = octagon();
  polygon.partner = {1, 0, 3, 2, 5, 4, 7, 6};
  EXPECT_THAT(complaint(polygon), HasSubstr("sphere (genus 0)"));
  polygon.partner = {2, 3, 0, 1, 5, 4, 7, 6};
  EXPECT_THAT(complaint(polygon), HasSubstr("torus (genus 1)"));
}

TEST(Surface, APairingOfUnequalSidesIsRefused) {
  PairedPolygon polygon = octagon();
  polygon.partner = {2, 3, 0, 1, 6, 7, 4, 5};
  EXPECT_THAT(complaint(polygon), HasSubstr("are paired but differ"));
}

TEST(Surface, ThereIsATileAndEachHasThreeVertices) {
  EXPECT_THAT(complaint(std::vector<Tile>{}, std::vector<Gluing>{}), HasSubstr("there is no tile"));
  EXPECT_THAT(complaint(std::vector<Tile>{{{0, 0}, {ratio(1, 2), 0}}}, std::vector<Gluing>{{0, 0, 0, 1}}),
              HasSubstr("has 2 vertices, expected at least 3"));
}

TEST(Surface, TilesAreConnected) {
  const Tile tile = octagon().vertices;
  std::vector<Gluing> gluing = octagon().gluing();
  for (std::uint32_t s = 0; s < 4; ++s) gluing.push_back({1, s, 1, s + 4});
  EXPECT_THAT(complaint(std::vector<Tile>{tile, tile}, gluing),
              HasSubstr("no path of glued sides leads from tile 0 to tile 1"));
}

TEST(Surface, EveryTileHasItsOwnCoordinates) {
  // The double cover of the octagon's surface that swaps the sheets across one pair of sides has genus 3.
  const Tile tile = octagon().vertices;
  const auto frame = Isometry<Rational>::translation({ratio(1, 3), ratio(-1, 4)});
  std::vector<Gluing> gluing{{0, 0, 1, 4}, {1, 0, 0, 4}};
  for (std::uint32_t s = 1; s < 4; ++s) {
    gluing.push_back({0, s, 0, s + 4});
    gluing.push_back({1, s, 1, s + 4});
  }
  const Surface surface({tile, test::moved(frame, tile)}, gluing);
  EXPECT_EQ(surface.genus(), 3U);
  EXPECT_EQ(surface.vertex_class_count(), 2U);
  EXPECT_EQ(surface.tile_of_side(SideId(9)), TileId(1));
  EXPECT_EQ(surface.side_number(TileId(1), 4), SideId(12));
  EXPECT_EQ(surface.partner(SideId(0)), SideId(12));
  EXPECT_EQ(surface.crossing(SideId(0))(tile[0]), frame(tile[5]));
}

TEST(Surface, CoordinatesOfAThousandDigitsAreExact) {
  PairedPolygon polygon =
      test::paired_polygon(test::imported(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-g5-rnd0.txt"));
  // An isometry whose centre has numerators and denominators of 600 digits.
  const Integer power = pow(Integer(10), 600);
  polygon.vertices =
      test::moved(Isometry<Rational>::translation({Rational(power / 7, power + 9), Rational(power / 11, power + 1)}),
                  polygon.vertices);
  ASSERT_GT(numerator(polygon.vertices[0].x).str().size(), 1000U);
  const Surface surface = read_domain(test::domain_text(polygon), "polygon");
  EXPECT_EQ(surface.genus(), 5U);
  EXPECT_EQ(surface.vertex_class_count(), test::paired_polygon(surface).surface().vertex_class_count());
  EXPECT_EQ(surface.tiles()[0], polygon.vertices);
}

TEST(Surface, CopiesShareTheirDataAndNotTheirText) {
  Surface surface = octagon().surface();
  surface.set_about("the first");
  Surface copy = surface;
  EXPECT_EQ(&copy.tiles(), &surface.tiles());
  EXPECT_EQ(copy.about(), "the first");
  copy.set_about("the second");
  EXPECT_EQ(surface.about(), "the first");
}

TEST(Surface, IsThereAfterItWasMovedFrom) {
  Surface surface = octagon().surface();
  const Surface moved = std::move(surface);
  EXPECT_EQ(surface.genus(), 2U);  // NOLINT(bugprone-use-after-move): that is the test.
  EXPECT_EQ(moved.genus(), 2U);
}

TEST(Surface, SidesAroundATile) {
  for (const auto& path : test::data_files("polygons")) {
    const Surface surface = test::imported(path);
    for (const TileId tile : surface.tile_ids()) {
      const auto n = static_cast<std::uint32_t>(surface.tile(tile).size());
      for (std::uint32_t k = 0; k < n; ++k) {
        EXPECT_EQ(surface.next_side(surface.side_number(tile, k)), surface.side_number(tile, (k + 1) % n)) << path;
        EXPECT_EQ(surface.previous_side(surface.side_number(tile, (k + 1) % n)), surface.side_number(tile, k)) << path;
      }
    }
  }
}

TEST(Surface, CornerCyclesGoOnceAroundAVertex) {
  for (const auto& path : test::data_files("polygons")) {
    const Surface surface = test::imported(path);
    for (const SideId corner : surface.side_ids()) {
      Word cycle = surface.corner_cycle(corner);
      EXPECT_EQ(cycle.front(), corner) << path;
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        // Across side cycle[i] lies the tile of the corner that follows, and its start is where that side's start goes.
        const SideId following = cycle[(i + 1) % cycle.size()];
        const auto start = [&](SideId s) { return surface.tile(surface.tile_of_side(s))[surface.place_in_tile(s)]; };
        EXPECT_EQ(surface.tile_of_side(following), surface.tile_of_side(surface.partner(cycle[i]))) << path;
        EXPECT_EQ(surface.crossing(cycle[i])(start(cycle[i])), start(following)) << path;
      }
      std::sort(cycle.begin(), cycle.end());
      Word members;
      for (const SideId other : surface.side_ids()) {
        if (surface.vertex_class(other) == surface.vertex_class(corner)) members.push_back(other);
      }
      EXPECT_EQ(cycle, members) << path;
      EXPECT_EQ(members.size(), surface.corners_around(corner)) << path;
    }
  }
}

TEST(Surface, CrossingsOfARegularSurfaceAreNotRational) {
  EXPECT_THROW((void)Surface::regular(2).crossing(SideId(0)), std::logic_error);
}

TEST(GluedPolygons, ARowOfTilesThatEndsAtOnceIsNoInput) {
  static_assert(std::is_constructible_v<GluedPolygons, const std::vector<Tile>&, const std::vector<Gluing>&>);
  static_assert(!std::is_constructible_v<GluedPolygons, std::vector<Tile>, const std::vector<Gluing>&>);
}

RC_GTEST_PROP(SurfaceProperty, RelabelledOrMovedPolygonIsTheSameSurface, ()) {
  const auto files = test::data_files("polygons");
  PairedPolygon polygon = test::paired_polygon(test::imported(files[*rc::gen::inRange<std::size_t>(0, files.size())]));
  const Surface before = polygon.surface();
  polygon = test::rotated(polygon, *rc::gen::inRange<std::uint32_t>(0, before.side_count()));
  polygon.vertices = test::moved(*test::isometries(), polygon.vertices);
  const Surface after = polygon.surface();
  RC_ASSERT(after.genus() == before.genus());
  RC_ASSERT(after.vertex_class_count() == before.vertex_class_count());
}

RC_GTEST_PROP(SurfaceProperty, ChangedCoordinateIsRejected, (std::int32_t seed)) {
  PairedPolygon polygon = test::paired_polygon(random_octagon(seed));
  const auto step = *rc::gen::nonZero<std::int32_t>();
  auto& vertex = polygon.vertices[*rc::gen::inRange<std::size_t>(0, 8)];
  (*rc::gen::arbitrary<bool>() ? vertex.x : vertex.y) += Rational(step) / Rational("10000000000000000000000000");
  RC_ASSERT(complaint(polygon) != "accepted");
}

RC_GTEST_PROP(SurfaceProperty, ChangedPairingIsRejected, (std::int32_t seed)) {
  // Sides of different lengths; a random octagon has no others.
  PairedPolygon polygon = test::paired_polygon(random_octagon(seed));
  std::vector<std::uint32_t> sides =
      *rc::gen::map(rc::gen::container<std::vector<std::uint32_t>>(8, rc::gen::arbitrary<std::uint32_t>()),
                    [](const std::vector<std::uint32_t>& keys) {
                      std::vector<std::uint32_t> order{0, 1, 2, 3, 4, 5, 6, 7};
                      std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return keys[i] < keys[j]; });
                      return order;
                    });
  for (std::size_t k = 0; k < 8; k += 2) {
    polygon.partner[sides[k]] = sides[k + 1];
    polygon.partner[sides[k + 1]] = sides[k];
  }
  RC_PRE(polygon.partner != test::paired_polygon(random_octagon(seed)).partner);
  RC_ASSERT(complaint(polygon) != "accepted");
}

}  // namespace
}  // namespace epsnet::surface_test
