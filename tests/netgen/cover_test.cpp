#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <rapidcheck/gtest.h>
#include <set>

#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::cover_test {
namespace {

using Sheets = std::vector<Permutation>;

Surface pants_surface(std::uint32_t genus) {
  return fenchel_nielsen_surface(random_coordinates(PantsGraph::chain(genus), 1));
}

/// What `cover` of the octagon of seed 1 says of permutations that it refuses.
std::string problem(const Sheets& sheets) {
  try {
    (void)cover(random_octagon(1), sheets);
  } catch (const CoverError& error) {
    return error.what();
  }
  return "";
}

TEST(Cover, OfDegree1IsTheSurface) {
  for (const Surface& base : {random_octagon(1), pants_surface(3)}) {
    const Surface same = cover(base, random_sheets(base, 1, 0));
    EXPECT_EQ(same.tiles(), base.tiles());
    EXPECT_EQ(same.gluing(), base.gluing());
  }
}

TEST(Cover, IsCopiesOfTheTilesGluedAsTheBaseIs) {
  const Surface base = pants_surface(3);
  const Surface three = cover(base, random_sheets(base, 3, 7));
  const auto tiles = static_cast<std::uint32_t>(base.tiles().size());
  ASSERT_EQ(three.tiles().size(), 3 * tiles);
  for (std::uint32_t t = 0; t < 3 * tiles; ++t) EXPECT_EQ(three.tiles()[t], base.tiles()[t % tiles]);
  for (const SideId s : three.side_ids()) {
    const auto of_base = [&](SideId side) { return SideId(side.number() % base.side_count()); };
    EXPECT_EQ(of_base(three.partner(s)), base.partner(of_base(s)));
  }
}

TEST(Cover, LeadsFromSheetToSheetAsThePermutationsSay) {
  // The octagon's side k is glued to side k + 4, and side 0 is the first of pair 0.
  const Surface two = cover(random_octagon(1), {{1, 0}, {0, 1}, {0, 1}, {0, 1}});
  EXPECT_EQ(two.partner(SideId(0)), SideId(8 + 4));
  EXPECT_EQ(two.partner(SideId(8)), SideId(4));
  EXPECT_EQ(two.partner(SideId(1)), SideId(5));
  EXPECT_EQ(two.genus(), 3);
}

RC_GTEST_PROP(CoverProperty, HasTheGenusOfItsArea, ()) {
  const auto genus = *rc::gen::inRange<std::uint32_t>(2, 5);
  const auto degree = *rc::gen::inRange<std::uint32_t>(1, 9);
  const Surface base = genus == 2 ? random_octagon(1) : pants_surface(genus);
  const Sheets sheets = random_sheets(base, degree, *rc::gen::arbitrary<std::uint64_t>());
  RC_ASSERT(cover(base, sheets).genus() == degree * (genus - 1) + 1);
}

TEST(Cover, OfAMapIsAMap) {
  const Surface bolza = Surface::regular(2);
  const Surface three = cover(bolza, random_sheets(bolza, 3, 1));
  EXPECT_EQ(three.genus(), 4);
  EXPECT_EQ(three.regular_tile(), bolza.regular_tile());
  EXPECT_EQ(three.tiles().size(), 3);
}

TEST(Cover, OfACoverIsACover) {
  const Surface base = random_octagon(5);
  const Surface two = cover(base, random_sheets(base, 2, 1));
  EXPECT_EQ(cover(two, random_sheets(two, 5, 2)).genus(), 11);
}

TEST(Cover, IsRefusedByTheConditionThatFails) {
  const Permutation one{0, 1};
  EXPECT_THAT(problem({one, one, one}), testing::HasSubstr("3 permutations found, expected 4"));
  EXPECT_THAT(problem({one, one, one, {0}}), testing::HasSubstr("permutation 3: 1 sheets found, expected 2"));
  EXPECT_THAT(problem({one, one, one, {0, 2}}), testing::HasSubstr("permutation 3: sheet 2 found, expected 0 to 1"));
  EXPECT_THAT(problem({one, {1, 1}, one, one}), testing::HasSubstr("permutation 1: sheet 1 is the image of two"));
  EXPECT_THAT(problem({{}, {}, {}, {}}), testing::HasSubstr("permutation 0 is empty"));
  EXPECT_THAT(problem({one, one, one, one}), testing::HasSubstr("not connected: from sheet 0 one gets to 1 of 2"));
  EXPECT_THAT(problem({{1, 2, 0}, {0, 2, 1}, {0, 1, 2}, {0, 1, 2}}), testing::HasSubstr("expected to itself"));
  Permutation many(1U << 18);
  for (std::uint32_t i = 0; i < many.size(); ++i) many[i] = i;
  EXPECT_THAT(problem({many, many, many, many}), testing::HasSubstr("at most 2^20 sides"));
}

TEST(RandomSheets, AreTheSameForASeed) {
  const Surface base = pants_surface(3);
  EXPECT_EQ(random_sheets(base, 8, 3), random_sheets(base, 8, 3));
  EXPECT_NE(random_sheets(base, 8, 3), random_sheets(base, 8, 4));
  EXPECT_THROW((void)random_sheets(base, 0, 3), CoverError);
  EXPECT_THROW((void)random_sheets(base, kMostRandomSheets + 1, 3), CoverError);
}

// A group of genus 2 has 16, 486 homomorphisms to S₂, S₃ (Frobenius); 15 and 486 − 16 − 2·15 = 440 are transitive.
TEST(RandomSheets, OfDegree2AreEquallyLikely) {
  const Surface base = random_octagon(1);
  std::map<Sheets, int> drawn;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) ++drawn[random_sheets(base, 2, seed)];
  EXPECT_EQ(drawn.size(), 15);
  // Of means of 100, with standard deviation 10.
  for (const auto& [sheets, times] : drawn) {
    EXPECT_GT(times, 60);
    EXPECT_LT(times, 140);
  }
}

TEST(RandomSheets, OfDegree3AreAll) {
  for (const Surface& base : {random_octagon(1), pants_surface(2)}) {
    std::set<Sheets> drawn;
    for (std::uint64_t seed = 0; seed < 6000; ++seed) {
      // On a surface with several vertices the relations are not those of the octagon, but homomorphisms are as many.
      drawn.insert(random_sheets(base, 3, seed));
    }
    EXPECT_EQ(drawn.size(), 440);
  }
}

TEST(ParsePermutations, ReadsArraysAndNothingElse) {
  EXPECT_EQ(parse_permutations("[[1, 0, 2], [0, 2, 1]]\n"), (Sheets{{1, 0, 2}, {0, 2, 1}}));
  for (const char* text : {"", "[", "{}", "[1]", "[[1.5]]", "[[-1]]", "[[1e3]]", "[[\"1\"]]", "[[1]] 2", "[[1],]",
                           "[[123456789]]", "[[]", "[[null]]"}) {
    EXPECT_THROW((void)parse_permutations(text), CoverError) << text;
  }
}

}  // namespace
}  // namespace epsnet::cover_test
