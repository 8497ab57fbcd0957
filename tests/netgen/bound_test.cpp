#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/file/file.h"
#include "kernel/plane.h"
#include "netgen/distances/distances.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"

namespace epsnet::bound_test {
namespace {

using certify::BoundDocument;
using certify::Interval;
using test::any_index;
using test::any_share;
using testing::HasSubstr;
using testing::MatchesRegex;

/// Returns the outcome of the checker: "VERIFIED", or the reason for another verdict.
std::string verdict(const BoundDocument& document) {
  return certify::verdict_line(certify::check(document, {.threads = 1, .max_work = std::uint64_t{1} << 50}));
}

/// Returns a random point strictly inside a random tile.
BasePoint any_place(const Surface& surface) {
  const TileId tile(any_index(surface.tiles().size()));
  const Complex<Rational> centre = centre_of_tile(surface, tile).z;
  const Tile& corners = surface.tile(tile);
  // Towards a corner, in the Klein model, where tiles are convex.
  const Complex<double> corner = to_klein(convert<double>(corners[any_index(corners.size())]));
  const auto share = 0.95 * any_share();
  const Complex<double> place = from_klein((1 - share) * to_klein(convert<double>(centre)) + share * corner);
  BasePoint point{tile, {Rational(place.x), Rational(place.y)}};
  try {
    require_inside(surface, point);
  } catch (const SurfaceError&) {
    point.z = centre;  // A tile as thin as that.
  }
  return point;
}

/// The enclosures at a point p, by the certificate of the net whose one vertex is p.
struct AtPoint {
  Interval eccentricity;
  Interval injectivity_radius;
};

AtPoint at_point(const Surface& surface, const BasePoint& p) {
  const certify::Certificate certificate = certify::check(unproved::eccentricity_net(surface, p), {.threads = 1});
  EXPECT_EQ(certify::verdict_line(certificate), "VERIFIED");
  const Interval loop = *certificate.enclosures->shortest_loop;
  return {certificate.enclosures->largest_circumradius, {loop.lower / 2, loop.upper / 2}};
}

bool overlap(Interval a, Interval b) { return a.lower <= b.upper && b.lower <= a.upper; }

/// The same surface, its octagon turned by an angle whose half has the tangent 1/2.
Surface turned(const Surface& octagon) {
  Tile tile;
  const Complex<Rational> turn{Rational(3, 5), Rational(4, 5)};
  for (const Complex<Rational>& z : octagon.tiles()[0]) tile.push_back(turn * z);
  return Surface({tile}, {{0, 0, 0, 4}, {0, 1, 0, 5}, {0, 2, 0, 6}, {0, 3, 0, 7}});
}

/// The octagon cut into a quadrilateral, a pentagon and a triangle.
Surface in_three_tiles(const Surface& octagon) {
  const Tile& z = octagon.tiles()[0];
  return Surface({{z[0], z[1], z[2], z[3]}, {z[0], z[3], z[4], z[5], z[6]}, {z[0], z[6], z[7]}},
                 {{0, 3, 1, 0},  // The diagonals,
                  {1, 4, 2, 0},
                  {0, 0, 1, 2},  // and sides k and k + 4.
                  {0, 1, 1, 3},
                  {0, 2, 2, 1},
                  {1, 1, 2, 2}});
}

/// The distance from the centre of a regular 4g-gon to its corner, which is the diameter of the regular surface.
double regular_diameter(std::uint32_t genus) {
  return std::acosh(std::pow(std::tan(std::numbers::pi / (4 * genus)), -2));
}

/// Bavard's bound: cosh r ≤ 1/(2 sin(π/(12g − 6))).
double bavard(std::uint32_t genus) { return std::acosh(1 / (2 * std::sin(std::numbers::pi / (12 * genus - 6)))); }

TEST(Diameter, OfARegularSurfaceIsFromTheCentreToTheCorner) {
  for (const std::uint32_t genus : {2u, 3u, 5u}) {
    const BoundDocument document = unproved::diameter(Surface::regular(genus));
    EXPECT_EQ(document.claim, BoundDocument::Claim::diameter);
    EXPECT_EQ(verdict(document), "VERIFIED") << genus;
    EXPECT_LT(document.value.lower, regular_diameter(genus));
    EXPECT_GT(document.value.upper, regular_diameter(genus));
    EXPECT_LE(document.value.upper - document.value.lower, 1e-6);
  }
}

/// Two one-holed tori joined along a cuff, the second length, that separates them.
Surface two_handles(const std::vector<Rational>& lengths) {
  return fenchel_nielsen_surface({PantsGraph({{0, 0}, {0, 1}, {1, 1}}), lengths, {0, Rational(1, 2), 1}});
}

TEST(Diameter, GoesFromOneSideOfAShortCurveToTheOther) {
  const Rational small(1, 100'000'000);
  for (const std::vector<Rational>& lengths : {std::vector<Rational>{1, Rational(1, 1000), 2},
                                               {1, Rational(1, 10'000), 2},
                                               {1, small, 2},
                                               {small, small, small}}) {
    const BoundDocument document = unproved::diameter(two_handles(lengths), {.width = 1e-4});
    EXPECT_EQ(verdict(document), "VERIFIED") << lengths[1];
    EXPECT_LE(document.value.upper - document.value.lower, 1e-4);
    // The collar of a geodesic of length l reaches arsinh(1/sinh(l/2)) to both sides.
    EXPECT_GT(document.value.lower, 2 * std::asinh(1 / std::sinh(static_cast<double>(lengths[1]) / 2)));
    EXPECT_LE(unproved::largest_embedded_disk(two_handles(lengths), {.width = 1e-2}).value.upper, bavard(2) + 1e-2);
  }
}

TEST(Radius, IsBetweenHalfOfTheDiameterAndEveryEccentricity) {
  for (const Surface& surface :
       {test::gallery()[0].surface, test::gallery()[1].surface, two_handles({1, Rational(1, 100'000'000), 2})}) {
    const BoundDocument document = unproved::radius(surface, {.width = 0.05});
    EXPECT_EQ(document.claim, BoundDocument::Claim::radius);
    EXPECT_EQ(verdict(document), "VERIFIED");
    EXPECT_LE(document.value.upper - document.value.lower, 0.05);
    EXPECT_GE(document.value.upper, unproved::diameter(surface, {.width = 0.05}).value.lower / 2);
    const certify::Certificate net = certify::check(document.net);
    EXPECT_NEAR(net.enclosures->largest_circumradius.upper, document.value.upper, 1e-12);
    for (const TileId tile : surface.tile_ids()) {
      EXPECT_GE(at_point(surface, centre_of_tile(surface, tile)).eccentricity.upper, document.value.lower);
    }
  }
}

/// Where many points are as far as possible from all others, by symmetry, a search once ended without an enclosure.
/// 0.01 is what programs ask unless they are told.
TEST(Radius, OfSymmetricSurfacesIsFoundByDefault) {
  for (const char* name : {"klein", "bring"}) {
    const Certified<BoundDocument> found = radius(named_surface(name), {.width = 1e-2});
    EXPECT_LE(found.document.value.upper - found.document.value.lower, 1e-2) << name;
    EXPECT_EQ(found.certificate.verdict, certify::Verdict::verified) << name;
  }
}

TEST(Radius, HasATieAtTheCentreOfARegularSurface) {
  const BoundDocument document = unproved::radius(Surface::regular(2), {.width = 0.1});
  EXPECT_EQ(verdict(document), "VERIFIED");
  // The least of the eccentricities of many points is 1.94031.
  EXPECT_LT(document.value.lower, 1.9404);
  EXPECT_GT(document.value.upper, 1.9403);
}

TEST(Radius, IsNotLostForCellsThatWouldOnlyImproveThePlaceOfItsNet) {
  // With enough cells for the width, and not for the better place that is sought first.
  const Surface bolza = Surface::regular(2);
  const BoundDocument document = unproved::radius(bolza, {.width = 0.05, .most_cells = 5000});
  EXPECT_EQ(verdict(document), "VERIFIED");
  EXPECT_LE(document.value.upper - document.value.lower, 0.05);
}

TEST(Diameter, TheLowerBoundIsTheEccentricityOfItsVertex) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Surface& surface = test::gallery()[i].surface;
    const BoundDocument document = unproved::diameter(surface, {.width = 1e-3});
    EXPECT_EQ(verdict(document), "VERIFIED");
    const certify::Certificate net = certify::check(document.net);
    EXPECT_GE(net.enclosures->largest_circumradius.upper, document.value.lower);
    EXPECT_NEAR(net.enclosures->largest_circumradius.lower, document.value.lower, 1e-12);
    EXPECT_LE(document.value.upper - document.value.lower, 1e-3);
  }
}

TEST(Bound, WhateverTheWidthItIsVerifiedAndHoldsTheSame) {
  const Surface& surface = test::gallery()[0].surface;
  for (const auto make : {&unproved::diameter, &unproved::radius, &unproved::largest_embedded_disk}) {
    const bool is_slow = make == &unproved::radius;
    const BoundDocument close = make(surface, {.width = is_slow ? 0.1 : 1e-5});
    for (const double width :
         {is_slow ? 0.05 : 1e-3, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, std::numeric_limits<double>::infinity()}) {
      const BoundDocument document = make(surface, {.width = width});
      EXPECT_EQ(verdict(document), "VERIFIED") << width;
      EXPECT_LE(document.value.upper - document.value.lower, width);
      EXPECT_TRUE(overlap(document.value, close.value)) << width;
    }
  }
}

TEST(Bound, IsTheSameFileForAnyNumberOfThreads) {
  const auto text = [](const BoundDocument& document) {
    std::ostringstream out;
    certify::write_file(document, out);
    return out.str();
  };
  for (const std::size_t i : {0u, 6u}) {
    for (const auto make : {&unproved::diameter, &unproved::radius, &unproved::largest_embedded_disk}) {
      const double width = make == &unproved::radius ? 0.1 : 1e-4;
      const std::string alone = text(make(test::gallery()[i].surface, {.width = width, .threads = 1}));
      for (const unsigned threads : {2u, 5u}) {
        EXPECT_EQ(text(make(test::gallery()[i].surface, {.width = width, .threads = threads})), alone) << threads;
      }
    }
  }
}

/// Errors too: where a search ends for want of cells does not depend on threads.
TEST(Bound, TheLimitOfCellsIsTheSameForAnyNumberOfThreads) {
  const auto message = [](std::uint64_t most_cells, unsigned threads) -> std::string {
    try {
      (void)unproved::diameter(test::gallery()[0].surface,
                               {.width = 1e-6, .most_cells = most_cells, .threads = threads});
    } catch (const NetError& error) {
      return error.what();
    }
    return "enclosed";
  };
  for (const std::uint64_t most_cells : {1u, 20u, 101u, 250u}) {
    EXPECT_NE(message(most_cells, 1), "enclosed");
    EXPECT_EQ(message(most_cells, 3), message(most_cells, 1));
  }
}

TEST(Bound, IsThatOfTheSurfaceWhateverItsTiles) {
  const Surface& surface = test::gallery()[0].surface;
  for (const auto make : {&unproved::diameter, &unproved::radius, &unproved::largest_embedded_disk}) {
    const double width = make == &unproved::radius ? 0.1 : 1e-5;
    const BoundDocument document = make(surface, {.width = width});
    for (const Surface& other : {turned(surface), in_three_tiles(surface)}) {
      const BoundDocument same = make(other, {.width = width});
      EXPECT_EQ(verdict(same), "VERIFIED");
      EXPECT_TRUE(overlap(document.value, same.value)) << to_string(document.value) << " and " << to_string(same.value);
    }
  }
}

/// Where the surface has isometries, one domain of them is enough.
TEST(Bound, OfASurfaceWithIsometriesIsOfADomain) {
  const auto sides = [](const BoundDocument& document) {
    EXPECT_EQ(verdict(document), "VERIFIED");
    return document.symmetry ? document.symmetry->isometries.size() : 0;
  };
  // The triangles of mirrors of regular polygons, and of Klein's quartic; every surface of genus 2 has an involution.
  for (const auto make : {&unproved::diameter, &unproved::radius, &unproved::largest_embedded_disk}) {
    for (const std::uint32_t genus : {2u, 3u, 4u}) EXPECT_EQ(sides(make(Surface::regular(genus), {.width = 0.1})), 3U);
    EXPECT_EQ(sides(make(named_surface("klein"), {.width = 0.1})), 3U);
    EXPECT_GE(sides(make(test::gallery()[0].surface, {.width = 0.1})), 3U);
    EXPECT_EQ(sides(make(fenchel_nielsen_surface(random_coordinates(PantsGraph::random(3, 1), 1)), {.width = 0.5})),
              0U);
  }
}

TEST(Bound, IsVerifiedForThinSurfacesAndForGenus3To5) {
  for (const std::size_t i : {3u, 4u, 5u, 6u, 7u, 8u}) {
    const test::NamedSurface& named = test::gallery()[i];
    const BoundDocument wide = unproved::diameter(named.surface, {.width = 0.2});
    EXPECT_EQ(verdict(wide), "VERIFIED") << named.name;
    const BoundDocument disk = unproved::largest_embedded_disk(named.surface, {.width = 0.05});
    EXPECT_EQ(verdict(disk), "VERIFIED") << named.name;
    // The radius of an embedded disk is at most the diameter of the surface.
    EXPECT_LE(disk.value.lower, wide.value.upper);
  }
}

/// Edges of its net are 23 long, and hundreds of flips and splits lead to a base whose edges are 2 long.
TEST(Bound, OfGenus10IsVerifiedByBothCheckers) {
  const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::random(10, 1), 1));
  const BoundDocument document = unproved::diameter(surface, {.width = 0.1});
  EXPECT_EQ(verdict(document), "VERIFIED");
  std::ostringstream text;
  certify::write_file(document, text);
  const exact::Result second = exact::check(text.str());
  EXPECT_EQ(second.verdict, exact::Verdict::verified) << second.message;
}

/// An embedded disk of radius r has the area 2π(cosh r − 1), the surface 4π(g − 1); and Bavard's bound is less.
TEST(EmbeddedDisk, IsSmallerThanTheSurfaceAndThanBavardsBound) {
  std::vector<Surface> surfaces{Surface::regular(2), Surface::regular(3)};
  for (const std::size_t i : {0u, 1u, 2u, 3u, 6u}) surfaces.push_back(test::gallery()[i].surface);
  for (const Surface& surface : surfaces) {
    const BoundDocument document = unproved::largest_embedded_disk(surface, {.width = 1e-3});
    EXPECT_EQ(document.claim, BoundDocument::Claim::embedded_disk);
    EXPECT_EQ(verdict(document), "VERIFIED");
    EXPECT_LE(document.value.upper - document.value.lower, 1e-3);
    EXPECT_LT(2 * std::numbers::pi * (std::cosh(document.value.lower) - 1),
              4 * std::numbers::pi * (surface.genus() - 1));
    EXPECT_LE(document.value.lower, bavard(surface.genus()));
    // The regular surface has an embedded disk at the centre whose radius is half the distance of opposite sides.
    if (!surface.is_regular()) continue;
    const double pi = std::numbers::pi;
    EXPECT_GE(document.value.upper, std::acosh(1 / std::tan(pi / (4 * surface.genus()))) * (1 - 1e-14));
  }
}

TEST(Bound, AWidthBelowTheLeastIsRefusedAndTooFewCellsAreAnErrorWithBounds) {
  const Surface bolza = Surface::regular(2);
  for (const auto make : {&unproved::diameter, &unproved::radius, &unproved::largest_embedded_disk}) {
    for (const double width : {0.0, -1.0, 9e-13, std::nan("")}) {
      EXPECT_THROW((void)make(bolza, {.width = width}), std::invalid_argument) << width;
    }
    if (make != &unproved::radius) {
      EXPECT_NO_THROW((void)make(bolza, {.width = kLeastBoundWidth}));
    }
    try {
      (void)make(test::gallery()[0].surface, {.width = 1e-6, .most_cells = 20});
      ADD_FAILURE() << "enclosed";
    } catch (const NetError& error) {
      const std::string text = error.what();
      ASSERT_THAT(text, MatchesRegex("not enclosed to the width wanted with 20 cells and [0-9]+ edges of "
                                     "triangulations, only by \\[.*"));
      double lower = 0;
      double upper = 0;
      char comma = 0;
      std::istringstream(text.substr(text.find('[') + 1)) >> lower >> comma >> upper;
      EXPECT_LT(0, lower) << text;
      EXPECT_LT(lower, upper) << text;
    }
  }
}

TEST(Eccentricity, OfTheCentreOfARegularSurfaceIsTheDistanceToItsCorner) {
  for (const std::uint32_t genus : {2u, 3u, 5u}) {
    const Interval found = at_point(Surface::regular(genus), {TileId(0), {0, 0}}).eccentricity;
    EXPECT_NEAR(found.lower, regular_diameter(genus), 1e-13);
    EXPECT_NEAR(found.upper, regular_diameter(genus), 1e-13);
  }
}

TEST(Eccentricity, IsOfAnyPointOfTheSurface) {
  const Surface bolza = Surface::regular(2);
  EXPECT_THROW((void)unproved::eccentricity_net(bolza, {TileId(1), {0, 0}}), SurfaceError);
  EXPECT_THROW((void)unproved::eccentricity_net(bolza, {TileId(0), {1, 0}}), SurfaceError);
  // Beyond a side of the octagon.
  EXPECT_EQ(certify::check(unproved::eccentricity_net(bolza, {TileId(0), {Rational(9, 10), 0}})).verdict,
            certify::Verdict::verified);
}

struct Bounded {
  Surface surface;
  BoundDocument diameter;
  BoundDocument disk;
};

/// Random octagons with both bounds, made once.
const std::vector<Bounded>& bounded_octagons() {
  static const std::vector<Bounded> all = [] {
    std::vector<Bounded> result;
    for (std::int32_t seed = 1; seed <= 12; ++seed) {
      const Surface surface = random_octagon(seed);
      result.push_back({surface, unproved::diameter(surface, {.width = 0.02}),
                        unproved::largest_embedded_disk(surface, {.width = 0.02})});
      EXPECT_EQ(verdict(result.back().diameter), "VERIFIED") << seed;
      EXPECT_EQ(verdict(result.back().disk), "VERIFIED") << seed;
    }
    return result;
  }();
  return all;
}

RC_GTEST_PROP(BoundProperty, NoPointOfARandomOctagonIsBeyondTheBounds, ()) {
  const Bounded& octagon = bounded_octagons()[any_index(bounded_octagons().size())];
  for (int i = 0; i < 5; ++i) {
    const AtPoint found = at_point(octagon.surface, any_place(octagon.surface));
    RC_ASSERT(found.eccentricity.lower <= octagon.diameter.value.upper);
    RC_ASSERT(found.injectivity_radius.lower <= octagon.disk.value.upper);
    RC_ASSERT(found.injectivity_radius.lower <= found.eccentricity.upper);
  }
}

/// The distance of two points is at most the eccentricity of either, and their eccentricities differ by at most that.
RC_GTEST_PROP(BoundProperty, EccentricityIsAtLeastEveryDistanceAndLipschitz, ()) {
  const Surface& surface = test::gallery()[any_index(7u)].surface;
  const BasePoint p = any_place(surface);
  const BasePoint q = any_place(surface);
  const AtPoint there = at_point(surface, p);
  const AtPoint here = at_point(surface, q);
  const Interval between = unproved::distance(surface, p, q).distance;
  RC_ASSERT(between.lower <= there.eccentricity.upper);
  RC_ASSERT(between.lower <= here.eccentricity.upper);
  RC_ASSERT(there.eccentricity.lower <= (here.eccentricity.upper + between.upper) * (1 + 1e-15));
  RC_ASSERT(there.injectivity_radius.lower <= (here.injectivity_radius.upper + between.upper) * (1 + 1e-15));
}

}  // namespace
}  // namespace epsnet::bound_test
