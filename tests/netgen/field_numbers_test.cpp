
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "netgen/isometries/isometries.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"
#include "netgen/surfaces/triangle_group.h"
#include "tests/netgen/matrix_texts.h"

namespace epsnet::field_numbers_test {
namespace {

using test::made_of;
using test::problem;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Kind = MatricesError::Kind;

/// The exact number of a text, as a double, and whether the exact number is 0.
std::pair<double, bool> read(std::string_view text, RegularTile tile = {8, 8}) {
  const TriangleGroup group(tile);
  const RingNumber x = parse_ring_number(text, group);
  return {static_cast<double>(x.rounded), certify::sign(x.numerator) == 0};
}

bool is_zero(const std::string& text, RegularTile tile = {8, 8}) {
  const auto [rounded, zero] = read(text, tile);
  EXPECT_EQ(zero, std::abs(rounded) < 1e-13) << text;
  return zero;
}

std::string problem_of_number(std::string_view text) {
  try {
    (void)read(text);
  } catch (const SurfaceError& error) {
    return error.what();
  }
  return "no problem";
}

TEST(RingNumber, IsThatOfItsText) {
  EXPECT_EQ(read("-3/4").first, -0.75);
  EXPECT_EQ(read("2-3-4").first, -5);
  EXPECT_EQ(read("1/2/2+2*3").first, 6.25);
  EXPECT_EQ(read("-(1-0.5)*-2").first, 1);
  EXPECT_TRUE(is_zero("sqrt(2)*sqrt(2)-2"));
  EXPECT_TRUE(is_zero("2*cos(pi/4)-sqrt(2)"));
  EXPECT_TRUE(is_zero("cos(3*pi/8)-sin(pi/8)"));
  EXPECT_TRUE(is_zero("sin(-pi/4)+cos(7*pi/4)"));
  EXPECT_TRUE(is_zero("cos(pi)+sqrt(4)-1"));
  EXPECT_TRUE(is_zero("sqrt(9/8)-3/4*sqrt(2)"));
  EXPECT_TRUE(is_zero("s*s-4*(sqrt(2)-1)"));
  EXPECT_TRUE(is_zero("sqrt(sqrt(2)-1)-s/2"));
  EXPECT_FALSE(is_zero("s-1.2871885058"));
}

TEST(RingNumber, MayBeAnyRootOfTheField) {
  EXPECT_TRUE(is_zero("sqrt(3)-2*cos(pi/6)", {12, 12}));
  EXPECT_TRUE(is_zero("(1+sqrt(5))/2-2*cos(pi/5)", {5, 4}));
  EXPECT_TRUE(is_zero("sqrt(7)*sqrt(7)-7", {7, 3}));
  EXPECT_TRUE(is_zero("sqrt(21)-sqrt(3)*sqrt(7)", {7, 3}));
  EXPECT_TRUE(is_zero("sqrt(13)-sqrt(26)/sqrt(4)*cos(pi/4)*2", {8, 13}));
  EXPECT_TRUE(is_zero("sqrt(0)"));
}

TEST(RingNumber, ThatIsNoneIsNamed) {
  EXPECT_THAT(problem_of_number("sqrt(3)"), StartsWith("sqrt(3) is not a number of these tiles"));
  EXPECT_THAT(problem_of_number("1+cos(2*pi/7)"), StartsWith("cos(2*pi/7) is not a number of these tiles"));
  EXPECT_THAT(problem_of_number("sqrt(1+sqrt(2))"), StartsWith("sqrt(1+sqrt(2)) is not a number of these tiles"));
  EXPECT_THAT(problem_of_number("1/sqrt(2)"), HasSubstr("a rational number other than 0"));
  EXPECT_THAT(problem_of_number("1/(2-2)"), HasSubstr("a rational number other than 0"));
  EXPECT_THAT(problem_of_number("sqrt(-1)"), HasSubstr("from 0 to 1000000"));
  for (const char* text : {"", "1+", "(1", "1)", "cos(1)", "cos(pi/)", "cos(pi/0)", "2pi", "x", "1..2", "nan", "1e5",
                           "sqrt", "cos(12345678901*pi)"})
    EXPECT_THAT(problem_of_number(text), HasSubstr("expected")) << text;
  for (const char* token : {"(", "-", "sqrt("}) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += token;
    EXPECT_THAT(problem_of_number(text), HasSubstr("fewer parentheses")) << token;
  }
}

TEST(RingNumber, TextsAreReadBack) {
  const TriangleGroup group({7, 3});
  const RingNumber x = parse_ring_number("3-sqrt(21)*s+cos(3*pi/7)*2", group);
  const std::vector<std::string> texts =
      field_texts({x.numerator, mpz_class(2) * x.numerator, x.numerator - x.numerator});
  ASSERT_EQ(texts.size(), 3U);
  EXPECT_EQ(texts[2], "0");
  EXPECT_TRUE(is_zero("2*(" + texts[0] + ")-(" + texts[1] + ")", {7, 3}));
  // Up to a factor, which is a rational number.
  const auto ratio = static_cast<double>(parse_ring_number(texts[0], group).rounded / x.rounded);
  EXPECT_DOUBLE_EQ(ratio * 2, std::round(ratio * 2));
}

/// A walk is found again from its element, rounded.
RC_GTEST_PROP(TriangleGroupProperty, ElementsAreKnownAsWalks, ()) {
  const RegularTile tile = *rc::gen::element(RegularTile{8, 8}, RegularTile{7, 3}, RegularTile{3, 7}, RegularTile{5, 4},
                                             RegularTile{4, 6}, RegularTile{14, 7});
  const TriangleGroup group(tile);
  TileWalk walk;
  walk.turns = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, tile.p));
  walk.last_turn = *rc::gen::inRange<std::uint32_t>(0, tile.p);
  const TriangleGroup::ExactElement element = group.element(walk);
  const std::vector<std::string> parts =
      field_texts({certify::twice_real(element.a), certify::twice_imaginary(element.a), certify::twice_real(element.b),
                   certify::twice_imaginary(element.b)});
  std::vector<TriangleGroup::Number> numbers;
  for (const std::string& part : parts) numbers.push_back(parse_ring_number(part, group).rounded);
  const auto found =
      group.walk(normalized(Isometry<TriangleGroup::Number>{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}}));
  RC_ASSERT(found.has_value());
  RC_ASSERT(TriangleGroup::same(group.element(*found), element));
}

/// The side pairings of the regular octagon: (a, b) = (1 + √2, (2 + √2) √(√2 − 1) e^{ikπ/4}).
constexpr const char* kBolza = R"(model su11
tiles 8 8
1+sqrt(2)  0   (2+sqrt(2))*sqrt(sqrt(2)-1)            0
1+sqrt(2)  0   (2+sqrt(2))*sqrt(sqrt(2)-1)*sqrt(1/2)  (2+sqrt(2))*sqrt(sqrt(2)-1)*sqrt(1/2)
1+sqrt(2)  0   0                                      (2+sqrt(2))*sqrt(sqrt(2)-1)
1+sqrt(2)  0  -(2+sqrt(2))*sqrt(sqrt(2)-1)*sqrt(1/2)  (2+sqrt(2))*sqrt(sqrt(2)-1)*sqrt(1/2)
relation aBcDAbCd
)";

TEST(FieldMatrices, OfTheRegularOctagonMakeTheBolzaSurface) {
  const MatrixSurface made = made_of(kBolza);
  EXPECT_TRUE(made.is_exact);
  EXPECT_TRUE(made.surface.is_regular_polygon());
  EXPECT_EQ(made.surface.genus(), 2U);
  ASSERT_EQ(made.words.size(), 4U);
  for (const Word& word : made.words) EXPECT_EQ(word.size(), 1U);
}

TEST(FieldMatrices, OfASurfaceMakeTheSameSurface) {
  for (const char* name :
       {"bolza", "klein", "bring", "fermat-quartic", "fricke-macbeath", "wiman-5", "accola-maclachlan-3"}) {
    const Surface surface = named_surface(name);
    for (const MatrixModel model : {MatrixModel::sl2r, MatrixModel::su11}) {
      const MatrixGenerators matrices = parse_matrices(write_matrices(surface, model));
      EXPECT_EQ(matrices.tile, surface.regular_tile());
      EXPECT_EQ(matrices.numbers.size(), 2 * surface.genus());
      const MatrixSurface made = surface_of_matrices(matrices);
      EXPECT_EQ(made.surface.regular_tile(), surface.regular_tile()) << name;
      EXPECT_EQ(made.surface.gluing().size(), surface.gluing().size()) << name;
      if (surface.genus() < 5) {
        EXPECT_EQ(isometric(surface, made.surface).kind, IsometricAnswer::Kind::yes) << name;
      }
      for (const Word& word : made.words) EXPECT_TRUE(is_path(made.surface, TileId(0), TileId(0), word)) << name;
    }
  }
}

/// The matrices of words are those that were given.
TEST(FieldMatrices, AreThoseOfTheirWords) {
  const MatrixGenerators matrices = parse_matrices(write_matrices(named_surface("klein"), MatrixModel::su11));
  const MatrixSurface made = surface_of_matrices(matrices);
  const TriangleGroup group(*matrices.tile);
  for (std::size_t k = 0; k < made.words.size(); ++k) {
    Isometry<Mp1024> f;
    for (const SideId s : made.words[k]) f = made.surface.crossing_as<Mp1024>(s) * f;
    std::vector<Mp1024> e;
    for (const std::string& text : matrices.numbers[k]) e.push_back(parse_ring_number(text, group).rounded);
    const Isometry<Mp1024> given{{e[0], e[1]}, {e[2], e[3]}};
    const Isometry<Mp1024> rest = normalized(inverse(f) * given);
    EXPECT_LT(norm(rest.b) + rest.a.y * rest.a.y, 1e-100) << k;
  }
}

/// Covers have fewer symmetries than tiles.
TEST(FieldMatrices, OfCoversMakeTheSameSurface) {
  const Surface base = Surface::regular(2);
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Surface surface = cover(base, random_sheets(base, 2 + seed % 3, seed));
    const MatrixSurface made = made_of(write_matrices(surface));
    EXPECT_EQ(made.surface.genus(), surface.genus()) << seed;
    EXPECT_EQ(isometric(surface, made.surface).kind, IsometricAnswer::Kind::yes) << seed;
  }
}

std::string problem_of_walks(const std::vector<TileWalk>& walks) {
  try {
    (void)subgroup_tiles({8, 8}, walks);
  } catch (const SurfaceError& error) {
    return error.what();
  }
  return "no problem";
}

TEST(SubgroupTiles, HaveNoTorsion) {
  EXPECT_EQ(problem_of_walks({{{}, 1}}), "the group has torsion: a turn about the centre of a tile");
  // Each side of one tile is glued to itself: half a turn about its midpoint.
  std::vector<TileWalk> walks;
  for (std::uint32_t k = 0; k < 8; ++k) walks.push_back({{k}, 8 - k});
  for (TileWalk& walk : walks) walk.last_turn %= 8;
  EXPECT_EQ(problem_of_walks(walks), "the group has torsion: half a turn about the midpoint of a side");
  // Side 2k is glued to side 2k + 1: a turn about the vertex between them.
  walks.clear();
  for (std::uint32_t k = 0; k < 8; k += 2) walks.push_back({{k}, 7 - k});
  EXPECT_EQ(problem_of_walks(walks), "the group has torsion: a turn about a vertex of the tiles");
}

TEST(SubgroupTiles, AreThoseOfTheGluing) {
  // Opposite sides: the Bolza surface.
  std::vector<TileWalk> walks;
  for (std::uint32_t k = 0; k < 4; ++k) walks.push_back({{k}, 4 - k});
  const auto tiles = subgroup_tiles({8, 8}, walks);
  ASSERT_TRUE(tiles);
  EXPECT_EQ(tiles->gluing, (std::vector<Gluing>{{0, 0, 0, 4}, {0, 1, 0, 5}, {0, 2, 0, 6}, {0, 3, 0, 7}}));
  EXPECT_EQ(tiles->paths, (std::vector<std::vector<std::uint32_t>>{{0}, {1}, {2}, {3}}));
  EXPECT_FALSE(subgroup_tiles({8, 8}, {walks[0]}));
}

TEST(FieldMatrices, WithTorsionAreNone) {
  const auto turn = problem("model su11\ntiles 8 8\ncos(pi/8) sin(pi/8) 0 0\n");
  EXPECT_EQ(turn.first, Kind::torsion);
  EXPECT_THAT(turn.second, HasSubstr("about the centre of a tile"));
  // And half a turn about the midpoint of side 0, 2i sin(2π/q) and −is.
  std::string more = kBolza;
  more.insert(more.find("relation"), "0 2*sin(pi/4) 0 -s\n");
  EXPECT_EQ(problem(more).first, Kind::torsion);
}

TEST(FieldMatrices, ThatAreNotOfTheTilesAreNotDecided) {
  const auto [kind, message] = problem("model su11\ntiles 8 8\n2 0 sqrt(2) 0\n");
  EXPECT_EQ(kind, Kind::undecided);
  EXPECT_THAT(message, HasSubstr("generator 1 does not take the tiles 8 8 to themselves"));
  // Near an element, and none.
  EXPECT_EQ(problem("model su11\ntiles 8 8\n1+sqrt(2)+1e-9 0 (2+sqrt(2))*s/2 0\n").first, Kind::text);
  EXPECT_EQ(problem("model su11\ntiles 8 8\n1+sqrt(2)+0.000000001 0 (2+sqrt(2))*s/2 0\n").first, Kind::undecided);
  std::string tiny = "0.";
  tiny += std::string(80, '0') + "1";
  EXPECT_THAT(problem("model su11\ntiles 8 8\n1+sqrt(2)+" + tiny + " 0 (2+sqrt(2))*s/2 0\n").second,
              HasSubstr("does not take the tiles 8 8 to themselves"));
  // To a point of a tile that is not its centre; and too far for 1,024 bits.
  EXPECT_EQ(problem("model su11\ntiles 8 8\n1+sqrt(2) 0 (2+sqrt(2))*s/2 1/2\n").first, Kind::undecided);
  EXPECT_EQ(problem("tiles 8 8\n1" + std::string(400, '0') + " 0 0 1\n").first, Kind::undecided);
  // One translation: not cocompact.
  EXPECT_EQ(problem("model su11\ntiles 8 8\n1+sqrt(2) 0 (2+sqrt(2))*s/2 0\n").first, Kind::undecided);
}

TEST(FieldMatrices, ThatAreWrittenWronglyAreNamed) {
  EXPECT_EQ(problem("tiles 8\n1 0 0 1\n").first, Kind::text);
  EXPECT_THAT(problem("tiles 8 x\n1 0 0 1\n").second, HasSubstr("\"x\" found"));
  EXPECT_THAT(problem("tiles 4 4\n1 0 0 1\n").second, HasSubstr("1/p + 1/q < 1/2"));
  EXPECT_THAT(problem("tiles 9973 9967\n1 0 0 1\n").second, HasSubstr("expected at most 100000"));
  EXPECT_THAT(problem("tiles 8 8\n1 0 0 foo\n").second, HasSubstr("generator 1: \"foo\""));
  EXPECT_THAT(problem("tiles 8 8\n1 0 0 -1\n").second, HasSubstr("the determinant is not positive"));
  EXPECT_THAT(problem("{\"tiles\":[8],\"generators\":[[[1,0],[0,1]]]}").second, HasSubstr("expected [p, q]"));
  EXPECT_EQ(problem("sqrt(2) 0 0 1\n").first, Kind::not_compact);
  std::string wrong = kBolza;
  wrong.replace(wrong.find("aBcD"), 4, "abcd");
  EXPECT_EQ(problem(wrong).first, Kind::relation);
}

}  // namespace
}  // namespace epsnet::field_numbers_test
