#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "kernel/plane.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/nets/triangulations.h"
#include "tests/support/polygons.h"
#include "triangulation/mesh/operations.h"

/// What is done at once instead of step by step: many turns around a short closed curve, and paths that turn far around
/// a vertex of many corners.
namespace epsnet::twist_test {
namespace {

/// Octagons with a closed geodesic of the length in their names, around which their sides and diagonals turn 58, 702
/// and 70,000 times.
Surface twisted_octagon(const std::string& length) {
  return test::imported(std::string(EPSNET_TEST_DATA) + "/twisted/octagon-" + length + ".txt");
}

/// The lengths of the edges, in order, as sinh² of half of them.
std::vector<double> edges(Triangulation& triangulation) {
  std::vector<double> result;
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto lifted = [&](std::uint32_t k) {
        const Corner c = triangulation.corner(t, k);
        return triangulation.lift_in<Mp1024>(c);
      };
      result.push_back(static_cast<double>(sinh2_half_distance(lifted(i), lifted(next(i)))));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Flips one after the other until all edges are Delaunay; their number.
int flip_one_by_one(Triangulation& triangulation) {
  int flips = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const TriangleId t : triangulation.triangles()) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        if (!triangulation.is_delaunay(make_dart(t, i))) {
          (void)flip(triangulation, make_dart(t, i));
          ++flips;
          changed = true;
        }
      }
    }
  }
  return flips;
}

TEST(Untwisting, GivesTheDelaunayTriangulationThatFlipsGive) {
  const Surface surface = twisted_octagon("1e-2");
  Triangulation flipped(surface);
  EXPECT_GE(flip_one_by_one(flipped), 100);
  Triangulation untwisted(surface);
  EXPECT_LE(make_delaunay(untwisted), 20U);
  EXPECT_EQ(problem(untwisted), "");
  EXPECT_THAT(edges(untwisted), testing::Pointwise(testing::DoubleNear(1e-9), edges(flipped)));
}

TEST(Untwisting, TakesFewFlipsAndFewPredicatesInMultiprecision) {
  // Flip by flip: 1,404 flips, 2,805 predicates, 1,979,676 factors: words of up to 700 letters for each.
  const Surface surface = twisted_octagon("1e-4");
  Triangulation triangulation(surface);
  EXPECT_LE(make_delaunay(triangulation), 20U);
  EXPECT_LE(triangulation.multiprecision_count(), 50U);
  EXPECT_LE(triangulation.atlas().factor_count(), 20'000U);
  EXPECT_EQ(problem(triangulation), "");
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_TRUE(triangulation.is_delaunay(make_dart(t, i)));
  }
}

TEST(Untwisting, NetsOfTwistedOctagonsAreVerified) {
  for (const char* length : {"1e-2", "1e-4"}) {
    const CertifiedNet net = certified_net(twisted_octagon(length), Length("0.5"));
    EXPECT_EQ(net.certificate.verdict, certify::Verdict::verified) << length;
  }
}

TEST(Untwisting, ManyMoreTurnsThanWordsMayHaveLettersAreAnError) {
  try {
    (void)certified_net(twisted_octagon("1e-6"), Length("0.5"));
    FAIL() << "70,000 turns are no label that can be written down";
  } catch (const LimitError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("turn 7e+04 times around a closed curve of length 1e-06"));
  }
}

TEST(AtlasPower, IsTheRepeatedProduct) {
  const Surface surface = Surface::regular(2);
  Atlas atlas(surface);
  (void)atlas.add_chart({TileId(0), {0, 0}});
  const LabelId f = atlas.label(ChartId(0), ChartId(0), word_of_letters({3, 5}));
  LabelId product = kIdentity;
  for (std::uint64_t n = 0; n < 40; ++n) {
    EXPECT_EQ(atlas.power(f, n), product) << n;
    product = atlas.product(f, product);
  }
}

/// A word of one tile that turns around its vertex by that many crossings, from a side on, and back or forth.
Word turn(const Surface& surface, SideId side, std::uint32_t crossings, bool counterclockwise) {
  Word word{side};
  while (word.size() < crossings) {
    const SideId partner = surface.partner(word.back());
    word.push_back(counterclockwise ? surface.next_side(partner) : surface.previous_side(partner));
  }
  return word;
}

/// Whether the label of a word, computed in T, is the product of crossings, given with more bits.
template <class T>
void expect_value(Atlas& atlas, const ById<SideId, Isometry<Mp4096>>& crossings, const Word& word, int bits) {
  Isometry<Mp4096> expected;
  for (const SideId s : word) expected = crossings[s] * expected;
  const Isometry<Mp4096> value = convert<Mp4096>(atlas.isometry_in<T>(atlas.label(ChartId(0), ChartId(0), word)));
  const auto difference = [&](int sign) {
    return norm(value.a - Mp4096(sign) * expected.a) + norm(value.b - Mp4096(sign) * expected.b);
  };
  // Relative to the entries; the sign of the pair is free.
  EXPECT_LT(std::min(difference(1), difference(-1)), ldexp(norm(expected.a), -2 * bits));
}

TEST(AtlasTurns, AreEvaluatedAsExactlyAsCrossingsOneByOne) {
  for (const Surface& surface :
       {Surface::regular(16), test::imported(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-g10-rnd0.txt")}) {
    ASSERT_EQ(surface.vertex_class_count(), 1U);
    Atlas atlas(surface);
    (void)atlas.add_chart({TileId(0), {0, 0}});
    const std::uint32_t all = surface.side_count();
    ById<SideId, Isometry<Mp4096>> crossings;
    for (const SideId s : surface.side_ids()) crossings.push_back(surface.crossing_as<Mp4096>(s));
    for (std::uint32_t side = 0; side < all; side += 13) {
      for (const std::uint32_t length : {16U, all / 2, all - 1}) {
        for (const bool counterclockwise : {true, false}) {
          Word word = turn(surface, SideId(side), length, counterclockwise);
          expect_value<Mp256>(atlas, crossings, word, 140);
          expect_value<Mp1024>(atlas, crossings, word, 600);
          // Turns in a longer path.
          word.emplace_back((word.back().number() + 2) % all);
          const Word other = turn(surface, SideId((side + 5) % all), 17, !counterclockwise);
          word.insert(word.end(), other.begin(), other.end());
          expect_value<Mp256>(atlas, crossings, word, 140);
        }
      }
    }
  }
}

TEST(AtlasTurns, AreOneFactorInNetsOfRegularPolygons) {
  // Crossing by crossing: 383,351 factors, and the more per label the larger the genus.
  const Surface surface = Surface::regular(100);
  const TriangulatedNet net = triangulated_net(surface, Length("0.5"));
  EXPECT_LE(net.triangulation.atlas().factor_count(), 100'000U);
}

}  // namespace
}  // namespace epsnet::twist_test
