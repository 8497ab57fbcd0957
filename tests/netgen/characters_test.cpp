#include "netgen/surfaces/characters.h"

#include <cstddef>
#include <cstdint>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

/// Phases of the sides of a surface that are a character of its group.
namespace epsnet::characters_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

Surface octagon() { return random_octagon(5); }
Surface bolza() { return Surface::regular(2); }
/// Of 24 heptagons, three of which meet at each vertex.
Surface klein() { return named_surface("klein"); }
Surface of_genus(std::uint32_t genus) {
  FenchelNielsenRequest request;
  request.genus = genus;
  request.seed = 1;
  return fenchel_nielsen_surface(resolve(request));
}

std::vector<Rational> point(const std::vector<std::string>& turns) {
  std::vector<Rational> result;
  for (const std::string& text : turns) result.push_back(parse_turns(text));
  return result;
}

const std::vector<std::pair<std::string, Surface>>& surfaces() {
  static const std::vector<std::pair<std::string, Surface>> result{
      {"octagon", octagon()},
      {"Bolza", bolza()},
      {"Klein", klein()},
      {"genus 4", of_genus(4)},
      {"cover", cover(octagon(), random_sheets(octagon(), 3, 1))}};
  return result;
}

std::vector<Rational> any_point(const Surface& surface) {
  std::vector<Rational> result;
  for (std::uint32_t i = 0; i < 2 * surface.genus(); ++i)
    result.push_back(Rational(*rc::gen::inRange(-40, 40)) / *rc::gen::inRange(1, 12));
  return result;
}

bool is_whole(const Rational& x) { return denominator(x) == 1; }

/// What makes phases of sides a homomorphism of the group: its relations are those of glued sides and of vertices.
RC_GTEST_PROP(Characters, ArePhasesWithWholeSumsOnGluedSidesAndAroundVertices, ()) {
  const auto& [name, surface] = surfaces()[*rc::gen::inRange<std::size_t>(0, surfaces().size())];
  const ById<SideId, Rational> phases = phases_of_sides(surface, any_point(surface));
  for (const SideId side : phases.ids()) {
    RC_ASSERT(is_whole(phases[side] + phases[surface.partner(side)]));
    RC_ASSERT(phases[side] > Rational(-1, 2) && phases[side] <= Rational(1, 2));
    Rational around = 0;
    for (const SideId crossed : surface.corner_cycle(side)) around += phases[crossed];
    RC_ASSERT(is_whole(around));
  }
}

/// And there are no others: 2g phases can be any, and determine all.
RC_GTEST_PROP(Characters, HaveTheGivenPhasesOnTheirSides, ()) {
  const auto& [name, surface] = surfaces()[*rc::gen::inRange<std::size_t>(0, surfaces().size())];
  const std::vector<Rational> turns = any_point(surface);
  const ById<SideId, Rational> phases = phases_of_sides(surface, turns);
  const std::vector<SideId> sides = character_sides(surface);
  RC_ASSERT(sides.size() == turns.size());
  for (std::size_t i = 0; i < sides.size(); ++i) RC_ASSERT(is_whole(phases[sides[i]] - turns[i]));
}

TEST(Characters, HaveTheFirstSidesOfThePairsOfAPolygonOfOneVertex) {
  EXPECT_THAT(character_sides(bolza()), ElementsAre(SideId(0), SideId(1), SideId(2), SideId(3)));
  const Surface surface = octagon();
  const PolygonSides polygon = polygon_sides(surface);
  ASSERT_EQ(polygon.relations.size(), 1U);
  std::vector<SideId> first;
  for (std::uint32_t k = 0; k < polygon.side.size(); ++k)
    if (k < polygon.partner[k]) first.push_back(polygon.side[k]);
  EXPECT_EQ(character_sides(surface), first);
}

TEST(Characters, HaveNoPhasesInsideOfThePolygon) {
  const Surface surface = klein();
  const PolygonSides polygon = polygon_sides(surface);
  ASSERT_GT(polygon.relations.size(), 1U);
  const std::set<SideId> outside(polygon.side.begin(), polygon.side.end());
  const ById<SideId, Rational> phases = phases_of_sides(surface, point({"1/3", "1/5", "1/7", "1/9", "1/11", "1/13"}));
  for (const SideId side : phases.ids()) {
    if (!outside.contains(side)) {
      EXPECT_EQ(phases[side], 0) << to_string(side);
    }
  }
}

TEST(Characters, AreReducedToHalfATurn) {
  const ById<SideId, Rational> phases = phases_of_sides(bolza(), point({"4/3", "-1/2", "-0.75", "7"}));
  const std::vector<Rational> expected{Rational(1, 3),  Rational(1, 2), Rational(1, 4),  Rational(0),
                                       Rational(-1, 3), Rational(1, 2), Rational(-1, 4), Rational(0)};
  EXPECT_EQ(std::vector<Rational>(phases.begin(), phases.end()), expected);
  EXPECT_EQ(phase_of_word(phases, {0, 0}), static_cast<double>(Rational(-1, 3)));
  EXPECT_EQ(phase_of_word(phases, {0, 2, 4}), 0.25);
  EXPECT_EQ(phase_of_word(phases, {}), 0);
}

TEST(Characters, OfAnotherNumberOfPhasesAreRefused) {
  EXPECT_THAT([] { (void)phases_of_sides(bolza(), point({"1/2"})); },
              ThrowsMessage<CharacterError>("1 phase found, expected 4, those of the sides 0, 1, 2, 3"));
  EXPECT_THAT(
      [] {
        (void)phases_of_sides(klein(), point({"0", "0", "0", "0"}));
      },
      ThrowsMessage<CharacterError>(HasSubstr("4 phases found, expected 6, those of the sides ")));
  EXPECT_EQ(phases_of_sides(bolza(), point({"1e-18", "0", "0.5", "0"}))[SideId(0)].str(), "1/1000000000000000000");
  for (const auto& turns : {point({"0", "1e-19", "0", "0"}), point({"1e-18", "1/3", "0", "0"})}) {
    EXPECT_THAT([&] { (void)phases_of_sides(bolza(), turns); },
                ThrowsMessage<CharacterError>("the phases are not multiples of 1/n for any n of at most 10^18"));
  }
  const std::vector<std::string> texts{"", "x", "1/0", "0,5", "inf", "1/3/4", " 1", std::string(41, '1')};
  for (const std::string& text : texts) {
    EXPECT_THAT([&] { (void)parse_turns(text); },
                ThrowsMessage<CharacterError>(HasSubstr("expected a phase in turns, a decimal or a fraction")));
  }
}

}  // namespace
}  // namespace epsnet::characters_test
