#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::fundamental_polygon_test {
namespace {

Surface pants_surface(std::uint32_t genus, std::uint64_t seed) {
  return fenchel_nielsen_surface(random_coordinates(PantsGraph::random(genus, seed), seed));
}

std::vector<Surface> surfaces() {
  return {random_octagon(123), pants_surface(2, 1), pants_surface(5, 3), Surface::regular(3)};
}

bool is_identity(const Isometry<Rational>& f) { return f.b == Complex<Rational>{} && f.a.y == 0; }

Isometry<Rational> gamma(const Surface& surface, const FundamentalPolygon& polygon, std::uint32_t side) {
  return exact_isometry(surface, polygon.sides[side].word);
}

TEST(FundamentalPolygon, SidesArePairedByTheirIsometries) {
  for (const Surface& surface : surfaces()) {
    const FundamentalPolygon polygon = fundamental_polygon(surface);
    const auto count = static_cast<std::uint32_t>(polygon.sides.size());
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t partner = polygon.sides[k].partner;
      EXPECT_EQ(polygon.sides[partner].partner, k);
      EXPECT_EQ(surface.partner(polygon.sides[k].side), polygon.sides[partner].side);
      if (surface.is_regular()) continue;
      const Isometry<Rational> back = inverse(gamma(surface, polygon, k));
      EXPECT_EQ(back(polygon.vertices[k]), polygon.vertices[(partner + 1) % count]);
      EXPECT_EQ(back(polygon.vertices[(k + 1) % count]), polygon.vertices[partner]);
    }
  }
}

TEST(FundamentalPolygon, RelationsHoldAndAreOneForEachVertex) {
  for (const Surface& surface : surfaces()) {
    const FundamentalPolygon polygon = fundamental_polygon(surface);
    // One polygon, half as many edges as sides.
    EXPECT_EQ(polygon.relations.size() + 1 + 2 * std::size_t{surface.genus()}, polygon.sides.size() / 2 + 2);
    for (const auto& relation : polygon.relations) {
      if (surface.is_regular()) continue;
      Isometry<Rational> product;
      for (const std::uint32_t side : relation) product = product * gamma(surface, polygon, side);
      EXPECT_TRUE(is_identity(product));
    }
  }
}

TEST(FundamentalPolygon, OneTileIsItsOwn) {
  const Surface surface = random_octagon(5);
  EXPECT_EQ(fundamental_polygon(surface).vertices, surface.tiles()[0]);
}

TEST(WordIsometry, ExactIsTheProductOfTheCrossings) {
  const Surface surface = random_octagon(123);
  const Isometry<Rational> product = surface.crossing(SideId(5)) * surface.crossing(SideId(2));
  const Isometry<Rational> found = exact_isometry(surface, word_of_letters({2, 5}));
  // Up to the common factor that is taken out.
  EXPECT_EQ(found.a * product.b, found.b * product.a);
  EXPECT_TRUE(is_identity(exact_isometry(surface, {SideId(3), surface.partner(SideId(3))})));
  EXPECT_TRUE(is_identity(exact_isometry(surface, surface.corner_cycle(SideId(0)))));
}

TEST(WordIsometry, WordsThatAreNoPathsAreRefused) {
  const Surface surface = pants_surface(2, 1);
  EXPECT_THROW((void)exact_isometry(surface, {SideId(99)}), SurfaceError);
  const TileId tile = surface.tile_of_side(surface.partner(SideId(0)));
  const SideId elsewhere = surface.side_number(TileId(1 - tile.number()), 0);
  EXPECT_THROW((void)enclosed_isometry(surface, {SideId(0), elsewhere}, 53), SurfaceError);
  EXPECT_THROW((void)exact_isometry(Surface::regular(2), {SideId(0)}), SurfaceError);
  EXPECT_THROW((void)enclosed_isometry(surface, {SideId(0)}, kMostEnclosureBits + 1), std::invalid_argument);
}

TEST(WordIsometry, RegularSurfacesHaveTheirAlgebraicNumbers) {
  // a = cot(pi/8) = 1 + sqrt 2.
  const EnclosedIsometry f = enclosed_isometry(Surface::regular(2), {SideId(0)}, 300);
  const auto beyond = [](const Rational& x) { return Rational((x - 1) * (x - 1) - 2); };
  EXPECT_LT(beyond(f.a_re.lower), 0);
  EXPECT_GT(beyond(f.a_re.upper), 0);
  EXPECT_LT(f.a_re.upper - f.a_re.lower, Rational(ldexp(Mp1024(1), -298)));
}

RC_GTEST_PROP(WordIsometryProperty, EnclosuresContainTheExactMatrix, ()) {
  const Surface surface = random_octagon(*rc::gen::inRange(0, 1000));
  const auto word = *rc::gen::container<Word>(rc::gen::inRange<std::uint32_t>(0, 8));
  const auto bits = *rc::gen::inRange(1U, 400U);
  const Isometry<Rational> exact = exact_isometry(surface, word);
  const EnclosedIsometry enclosed = enclosed_isometry(surface, word, bits);
  // x/sqrt(D) lies between two ends if the squares do, signs minded; (a, b) may have the other sign.
  const Rational determinant = exact.determinant();
  const auto square = [](const Rational& x) { return Rational(x < 0 ? -x * x : x * x); };
  const auto inside = [&](const Rational& x, const EnclosedNumber& ends) {
    return square(ends.lower) * determinant <= square(x) && square(x) <= square(ends.upper) * determinant;
  };
  const auto all_inside = [&](const Isometry<Rational>& f) {
    return inside(f.a.x, enclosed.a_re) && inside(f.a.y, enclosed.a_im) && inside(f.b.x, enclosed.b_re) &&
           inside(f.b.y, enclosed.b_im);
  };
  RC_ASSERT(all_inside(exact) || all_inside({-exact.a, -exact.b}));
}

}  // namespace
}  // namespace epsnet::fundamental_polygon_test
