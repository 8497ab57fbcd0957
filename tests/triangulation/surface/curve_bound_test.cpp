#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <utility>
#include <vector>

#include "tests/support/triangulations.h"
#include "triangulation/surface/atlas.h"

namespace epsnet::curve_bound_test {
namespace {

double curve_bound(const Surface& surface) {
  double bound = 1e300;
  for (const Tile& tile : surface.tiles()) {
    bound = std::min(bound, curve_bound(tile));
  }
  return bound;
}

Surface with_cuffs(const char* graph, std::vector<Rational> lengths, const Rational& twist) {
  return fenchel_nielsen_surface({PantsGraph::parse(graph), std::move(lengths), {twist, twist, twist}});
}

TEST(CurveBound, NearTheLengthOfAShortCuff) {
  Rational length(1, 100);
  for (int power = 2; power <= 25; ++power, length /= 10) {
    for (const char* graph : {"0-0 0-1 1-1", "0-1 0-1 0-1"}) {
      const double bound = curve_bound(with_cuffs(graph, {1, length, 2}, Rational(3, 10)));
      EXPECT_LE(bound, static_cast<double>(length)) << graph << ", 1e-" << power;
      EXPECT_GE(bound, static_cast<double>(length) / 3) << graph << ", 1e-" << power;
    }
  }
}

TEST(CurveBound, OfAShortGeodesicThatIsNoSide) {
  // It leads from side to side through the middle of the polygon.
  for (const auto& [name, surface] : test::gallery()) {
    if (name == "g2-thin-1e-4") {
      EXPECT_LE(curve_bound(surface), 1.0001e-4);
      EXPECT_GE(curve_bound(surface), 0.9e-4);
    }
  }
}

TEST(CurveBound, LongCuffsAreNotTakenForShortOnes) {
  for (const Rational& twist : {Rational(0), Rational(3, 10), Rational(20), Rational(50)}) {
    EXPECT_GE(curve_bound(with_cuffs("0-1 0-1 0-1", {100, 100, 100}, twist)), 1e-25);
    EXPECT_GE(curve_bound(with_cuffs("0-0 0-1 1-1", {40, 50, 60}, twist)), 1e-20);
  }
}

TEST(CurveBound, SaysWhatIsTooShortToBeSeen) {
  const Rational far = 1 - Rational(1, boost::multiprecision::pow(boost::multiprecision::mpz_int(10), 99));
  EXPECT_EQ(curve_bound(Tile{{far, 0}, {0, far}, {-far, 0}}), 1e-90);
}

RC_GTEST_PROP(CurveBoundProperty, NoClosedGeodesicIsShorter, ()) {
  const auto& surfaces = test::tiled_gallery();
  const Surface& surface = surfaces[test::any_index(surfaces.size())].surface;
  // A path until it is back in its first tile.
  const TileId start(test::any_index(surface.tiles().size()));
  Isometry<Mp1024> value;
  TileId tile = start;
  do {
    const SideId side =
        surface.side_number(tile, test::any_index(static_cast<std::uint32_t>(surface.tile(tile).size())));
    value = surface.crossing_as<Mp1024>(side) * value;
    tile = surface.tile_of_side(surface.partner(side));
  } while (tile != start);
  const Mp1024 half_trace = abs(value.a.x);
  RC_PRE(half_trace > 1 + Mp1024(1e-100));  // Not the identity.
  RC_ASSERT(2 * acosh(half_trace) >= curve_bound(surface));
}

}  // namespace
}  // namespace epsnet::curve_bound_test
