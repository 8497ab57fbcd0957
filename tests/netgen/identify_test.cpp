#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "certify/check.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"
#include "netgen/surfaces/triangle_group.h"

namespace epsnet::identify_test {
namespace {

using Kind = IsometricAnswer::Kind;
using Names = std::vector<std::string>;

/// The names of a surface; none if it has none, and "undecided" if that is so.
Names names_of(const Surface& surface) {
  const std::vector<NamedAnswer> answers = identify(surface);
  if (!answers.empty() && answers.back().answer.kind == Kind::yes) return answers.back().names;
  for (const NamedAnswer& answer : answers) {
    if (answer.answer.kind != Kind::no) return {"undecided"};
  }
  return {};
}

bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The same map with its darts in another order: with another tile 0, another side 0, or the roles of faces and
/// vertices exchanged, or its mirror image.
DartMap other_presentation(DartMap map, std::mt19937& random) {
  if (random() % 2 != 0) map = dual(map);
  if (random() % 2 != 0) map = mirror_image(map);
  Permutation number(map.edges.size());
  std::iota(number.begin(), number.end(), 0U);
  for (std::size_t i = number.size(); i > 1; --i) std::swap(number[i - 1], number[random() % i]);
  DartMap result = map;
  for (std::uint32_t d = 0; d < map.edges.size(); ++d) {
    result.rotation[number[d]] = number[map.rotation[d]];
    result.edges[number[d]] = number[map.edges[d]];
  }
  return result;
}

/// A short simple closed geodesic.
Word some_curve(const Surface& surface, std::mt19937& random) {
  const double systole = unproved::systole(surface).geodesics.front().length.upper;
  std::vector<Word> curves;
  for (const auto& geodesic : unproved::spectrum(surface, Length(systole + 0.5)).geodesics) {
    if (geodesic.simple) curves.push_back(word_of_letters(geodesic.word));
  }
  return curves[random() % curves.size()];
}

/// The surface of the group that the images of generators under a Dehn twist generate, by its tiles.
Surface after_dehn_twist(const Surface& surface, std::mt19937& random) {
  const ById<SideId, Word> images = dehn_twist_words(surface, some_curve(surface, random), random() % 2 != 0 ? 1 : -1);
  std::vector<TileWalk> walks;
  for (const Word& generator : generator_words(surface)) {
    Word image;
    for (const SideId s : generator) image.insert(image.end(), images[s].begin(), images[s].end());
    walks.push_back(walk_of(surface, image));
  }
  return Surface::map(*surface.regular_tile(), subgroup_tiles(*surface.regular_tile(), walks).value().gluing);
}

/// A presentation of a surface of a map: its group has other generators, and another base point.
Surface random_presentation(const Surface& surface, std::mt19937& random) {
  return after_dehn_twist(surface_of_map(other_presentation(map_of_surface(surface), random)), random);
}

/// The Bolza surface over a number field, by triangles.
Surface bolza_over_a_field() {
  return surface_of_matrices(parse_matrices("model su11\n1+sqrt(2) 0 sqrt(2+2*sqrt(2)) 0\n"
                                            "1+sqrt(2) 0 sqrt(1+sqrt(2)) sqrt(1+sqrt(2))\n"
                                            "1+sqrt(2) 0 0 sqrt(2+2*sqrt(2))\n"
                                            "1+sqrt(2) 0 -sqrt(1+sqrt(2)) sqrt(1+sqrt(2))\n"))
      .surface;
}

void expect_recognized(const std::string& name, int count) {
  std::mt19937 random(1);
  const Surface surface = named_surface(name);
  for (int i = 0; i < count; ++i) {
    EXPECT_TRUE(has(names_of(random_presentation(surface, random)), name)) << name << ", presentation " << i;
  }
}

TEST(KnownSurfaces, HaveAllTheirNames) {
  EXPECT_EQ(known_surfaces(3), (std::vector<Names>{{"klein", "R3.1"},
                                                   {"fermat-quartic", "R3.2", "R3.5-6a", "R3.10-11b"},
                                                   {"wiman-3", "R3.9"},
                                                   {"accola-maclachlan-3", "R3.5-6b", "R3.10-11a"},
                                                   {"R3.3"},
                                                   {"R3.4", "R3.8"},
                                                   {"R3.7", "R3.12"}}));
  EXPECT_EQ(known_surfaces(11), (std::vector<Names>{{"wiman-11"}, {"accola-maclachlan-11"}}));
}

TEST(Identify, FindsAllNames) {
  EXPECT_EQ(names_of(Surface::regular(2)), (Names{"bolza", "R2.1", "R2.3", "R2.6"}));
  EXPECT_EQ(names_of(named_surface("R3.10-11b")), (Names{"fermat-quartic", "R3.2", "R3.5-6a", "R3.10-11b"}));
  EXPECT_EQ(names_of(named_surface("wiman-11")), (Names{"wiman-11"}));
}

TEST(Identify, FindsAnIsometry) {
  const Surface surface = bolza_over_a_field();
  const std::vector<NamedAnswer> answers = identify(surface);
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].names.front(), "bolza");
  EXPECT_EQ(answers[0].compared, "bolza");
  ASSERT_TRUE(answers[0].answer.isometry);
  EXPECT_EQ(answers[0].answer.isometry->images.size(), generator_words(surface).size());
}

/// The numbers of maps {4, 22} and {22, 22} are in no common field of degree 64.
TEST(Identify, ComparesWithTheMapOfTheSameTiles) {
  const std::vector<NamedAnswer> answers = identify(named_surface("R10.23"));
  EXPECT_EQ(answers.back().names, (Names{"accola-maclachlan-10", "R10.11", "R10.23"}));
  EXPECT_EQ(answers.back().compared, "R10.23");
  EXPECT_EQ(answers.back().answer.kind, Kind::yes);
}

TEST(Identify, ProvesThatASurfaceIsNoneOfThem) {
  const std::vector<NamedAnswer> answers = identify(random_octagon(5));
  EXPECT_EQ(answers.size(), known_surfaces(2).size());
  for (const NamedAnswer& other : answers) {
    EXPECT_EQ(other.answer.kind, Kind::no) << other.names.front();
    ASSERT_TRUE(other.answer.proof);
    EXPECT_EQ(certify::check(other.answer.proof->document).verdict, certify::Verdict::verified);
  }
}

/// Cut along a systole and glued again after a move by 0 the surface is nearly the same one: its numbers are rounded.
TEST(Identify, GivesNoNameToASurfaceNearby) {
  const Surface bolza = bolza_over_a_field();
  std::mt19937 random;
  const Surface near = twisted(bolza, some_curve(bolza, random), Rational(0));
  EXPECT_FALSE(has(names_of(near), "bolza"));
}

TEST(Identify, RecognizesAllRegularMapsOfSmallGenus) {
  for (const RegularMap& map : regular_maps()) {
    if (map.genus > 3) continue;
    EXPECT_TRUE(has(names_of(surface_of_map(dual(darts(map)))), map.name)) << map.name;
  }
}

class RandomPresentations : public ::testing::TestWithParam<const char*> {};

TEST_P(RandomPresentations, AreRecognized) { expect_recognized(GetParam(), 2); }
INSTANTIATE_TEST_SUITE_P(Identify, RandomPresentations,
                         ::testing::Values("bolza", "klein", "fermat-quartic", "bring", "wiman-3",
                                           "accola-maclachlan-4"));

class AHundredRandomPresentations : public ::testing::TestWithParam<const char*> {};

TEST_P(AHundredRandomPresentations, AreRecognized) { expect_recognized(GetParam(), 100); }
INSTANTIATE_TEST_SUITE_P(DeepIdentify, AHundredRandomPresentations,
                         ::testing::Values("bolza", "klein", "fermat-quartic", "bring", "fricke-macbeath", "wiman-3",
                                           "accola-maclachlan-4"));

TEST(DeepIdentify, RecognizesDehnTwistsOverANumberField) {
  std::mt19937 random(2);
  for (int i = 0; i < 20; ++i) {
    Surface surface = bolza_over_a_field();
    for (int twists = 0; twists < 2; ++twists) surface = dehn_twisted(surface, some_curve(surface, random));
    EXPECT_TRUE(has(names_of(surface), "bolza")) << i;
  }
}

TEST(DeepIdentify, RecognizesAllRegularMaps) {
  for (const RegularMap& map : regular_maps()) {
    EXPECT_TRUE(has(names_of(surface_of_map(dual(darts(map)))), map.name)) << map.name;
  }
}

}  // namespace
}  // namespace epsnet::identify_test
