#include <algorithm>
#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "netgen/surfaces/coset_enumeration.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::regular_maps_test {
namespace {

/// The elements of ⟨x, y | xᵖ, y², (xy)^q, relators⟩, or 0 if there are more than `most`.
std::size_t order(RegularTile type, const std::vector<std::string>& relators, std::size_t most = 1000) {
  std::vector<RotationWord> all = triangle_relators(type);
  for (const std::string& relator : relators) all.push_back(parse_rotations(relator));
  const CosetTable table(all, most);
  return table.is_closed() ? table.size() : 0;
}

TEST(CosetTable, HasTheElementsOfGroups) {
  EXPECT_EQ(order({3, 3}, {}), 12U);
  EXPECT_EQ(order({3, 4}, {}), 24U);
  EXPECT_EQ(order({3, 5}, {}), 60U);
  EXPECT_EQ(order({5, 3}, {}), 60U);
  // The torus, of four squares.
  EXPECT_EQ(order({4, 4}, {"xyXyxyXy", "xxyxxy"}), 16U);
  // PSL(2,7) and PSL(2,8).
  EXPECT_EQ(order({3, 7}, {"xyXyxyXyxyXyxyXy"}), 168U);
  EXPECT_EQ(order({3, 7}, {"xyxyXyxyxyXyxyXyXyxyXyXyxyXy"}), 504U);
  // Relators that collapse the group: 3 and 7 are coprime, so an abelian quotient is trivial.
  EXPECT_EQ(order({3, 7}, {"xyXy"}), 1U);
}

TEST(CosetTable, OfAnInfiniteGroupIsNotClosed) {
  const CosetTable table(triangle_relators({3, 7}), 1000);
  EXPECT_FALSE(table.is_closed());
  EXPECT_GT(table.size(), 1000U);
  EXPECT_EQ(table.product(0, parse_rotations("xyX")),
            table.product(*table.product(0, Rotation::x), parse_rotations("yX")));
}

TEST(CosetTable, HasEveryRelatorFromEveryElementOn) {
  const std::vector<RotationWord> relators{parse_rotations("xxx"), parse_rotations("yy"),
                                           parse_rotations("xyxyxyxyxy")};
  const CosetTable table(relators, 100);
  ASSERT_TRUE(table.is_closed());
  for (std::uint32_t element = 0; element < table.size(); ++element) {
    for (const RotationWord& relator : relators) EXPECT_EQ(table.product(element, relator), element);
    EXPECT_EQ(table.product(*table.product(element, Rotation::x), Rotation::x_inverse), element);
  }
}

using Form = std::pair<Permutation, Permutation>;
Form form(const DartMap& map) {
  DartMap standard = standard_form(map);
  return {std::move(standard.rotation), std::move(standard.edges)};
}

/// The same map with another dart as dart 0.
DartMap seen_from(const DartMap& map, std::uint32_t dart) {
  const auto number = [dart](std::uint32_t d) { return d == 0 ? dart : d == dart ? 0 : d; };
  DartMap result = map;
  for (std::uint32_t d = 0; d < map.edges.size(); ++d) {
    result.rotation[number(d)] = number(map.rotation[d]);
    result.edges[number(d)] = number(map.edges[d]);
  }
  return result;
}

/// Those of the map, its mirror image and their duals.
std::set<Form> forms(const DartMap& map) {
  return {form(map), form(mirror_image(map)), form(dual(map)), form(mirror_image(dual(map)))};
}

TEST(RegularMaps, HaveTheirTypeAndGenus) {
  for (const RegularMap& map : regular_maps()) {
    SCOPED_TRACE(map.name);
    EXPECT_LE(map.type.p, map.type.q);
    const Surface surface = surface_of_map(darts(map));
    EXPECT_EQ(surface.genus(), map.genus);
    EXPECT_EQ(*surface.regular_tile(), map.type);
    EXPECT_EQ(surface.side_count(), rotations(map));
    EXPECT_EQ(map_of_surface(surface).edges.size(), rotations(map));
  }
}

/// There are rotations that take dart 0 to the next one around its face, and to the one across its edge: so there is
/// one that takes it to any dart.
TEST(RegularMaps, AreRegular) {
  for (const RegularMap& map : regular_maps()) {
    SCOPED_TRACE(map.name);
    const DartMap d = darts(map);
    EXPECT_EQ(form(seen_from(d, d.rotation[0])), form(d));
    EXPECT_EQ(form(seen_from(d, d.edges[0])), form(d));
    EXPECT_EQ(form(mirror_image(d)) == form(d), is_reflexible(map));
  }
}

TEST(RegularMaps, AreDifferent) {
  std::map<Form, std::string> known;
  for (const RegularMap& map : regular_maps()) {
    for (const Form& f : forms(darts(map))) {
      const auto [place, is_new] = known.emplace(f, map.name);
      EXPECT_TRUE(is_new) << map.name << " is " << place->second;
    }
  }
}

TEST(RegularMaps, HaveNamesInTheOrderOfConder) {
  std::map<std::string, std::uint32_t> last;
  std::set<std::string> names;
  for (const RegularMap& map : regular_maps()) {
    const std::string name(map.name);
    const std::string list = name.substr(0, name.find('.') + 1);
    EXPECT_EQ(list.substr(1), std::to_string(map.genus) + ".");
    const std::uint32_t number = ++last[list];
    EXPECT_TRUE(names.insert(name).second) << name;
    const std::string numbers = name.substr(list.size());
    if (numbers.find('-') == std::string::npos) {
      EXPECT_EQ(numbers, std::to_string(number));
      continue;
    }
    // "5-6b": the second one of the maps 5 and 6.
    const auto first = static_cast<std::uint32_t>(std::stoul(numbers));
    EXPECT_EQ(number - first, static_cast<std::uint32_t>(numbers.back() - 'a')) << name;
  }
}

/// Maps of one type, and only those, are told apart by a letter.
TEST(RegularMaps, HaveConderNumbersIfTheyAreTheOnlyOnesOfTheirType) {
  std::map<std::string, int> count;
  const auto kind = [](const RegularMap& map) {
    return std::string(map.name.substr(0, 1)) + std::to_string(map.genus) + "{" + std::to_string(map.type.p) + "," +
           std::to_string(map.type.q) + "}";
  };
  for (const RegularMap& map : regular_maps()) ++count[kind(map)];
  for (const RegularMap& map : regular_maps()) {
    EXPECT_EQ(map.name.find('-') == std::string_view::npos, count[kind(map)] == 1) << map.name;
  }
}

TEST(RegularMaps, AreAsManyAsThereAre) {
  std::map<std::uint32_t, std::array<int, 2>> count;
  for (const RegularMap& map : regular_maps()) ++count[map.genus][is_reflexible(map) ? 0 : 1];
  const std::map<std::uint32_t, std::array<int, 2>> expected{{2, {6, 0}},  {3, {12, 0}}, {4, {12, 0}},
                                                             {5, {16, 0}}, {6, {13, 0}}, {7, {12, 2}},
                                                             {8, {11, 1}}, {9, {32, 0}}, {10, {24, 3}}};
  EXPECT_EQ(count, expected);
}

TEST(RegularMaps, AreOnTheSurfaceOfTheirMapWithTheMostRotations) {
  std::map<std::string_view, const RegularMap*> by_name;
  for (const RegularMap& map : regular_maps()) by_name[map.name] = &map;
  for (const RegularMap& map : regular_maps()) {
    SCOPED_TRACE(map.name);
    ASSERT_EQ(by_name.count(map.surface), 1U);
    const RegularMap& first = *by_name[map.surface];
    EXPECT_EQ(first.surface, first.name);
    EXPECT_EQ(first.genus, map.genus);
    EXPECT_GE(rotations(first), rotations(map));
  }
}

/// Maps that others have described.
TEST(RegularMaps, AreThoseThatHaveNames) {
  for (const auto& [name, map] : std::vector<std::pair<std::string, std::string>>{{"bolza", "R2.6"},
                                                                                  {"klein", "R3.1"},
                                                                                  {"fermat-quartic", "R3.2"},
                                                                                  {"bring", "R4.2"},
                                                                                  {"fricke-macbeath", "R7.1"},
                                                                                  {"wiman-2", "R2.4"},
                                                                                  {"wiman-10", "R10.22"},
                                                                                  {"accola-maclachlan-2", "R2.2"},
                                                                                  {"accola-maclachlan-3", "R3.5-6b"},
                                                                                  {"accola-maclachlan-10", "R10.11"}}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(forms(map_of_surface(named_surface(name))), forms(map_of_surface(named_surface(map))));
  }
}

TEST(RegularMaps, HaveNamesOfSurfaces) {
  const Surface surface = named_surface("C7.1");
  EXPECT_EQ(surface.about(), "C7.1: A chiral map {6, 9} of genus 7 with 54 rotations and no reflection.");
  EXPECT_EQ(named_surface("R2.1", 2).about(),
            "R2.1: A regular map {3, 8} of genus 2 with 48 rotations and as many reflections.");
  for (const char* name : {"R2", "R2.7", "R2.0", "R11.1", "r2.1", "C2.1", "R3.5", "R2.1*"}) {
    EXPECT_THROW((void)named_surface(name), SurfaceError) << name;
  }
  EXPECT_THROW((void)named_surface("R2.1", 3), SurfaceError);
}

}  // namespace
}  // namespace epsnet::regular_maps_test
