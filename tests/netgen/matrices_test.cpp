#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/netgen/matrix_texts.h"

namespace epsnet::matrices_test {
namespace {

using Kind = MatricesError::Kind;
using test::made_of;
using test::problem;
using ::testing::HasSubstr;

Surface pants_surface(std::uint32_t genus) {
  return fenchel_nielsen_surface(random_coordinates(PantsGraph::chain(genus), 1));
}

/// Whether two pairs are real multiples of each other.
bool same(const Isometry<Rational>& f, const Isometry<Rational>& g) {
  const Isometry<Rational> one = f * inverse(g);
  return one.a.y == 0 && one.b == Complex<Rational>{};
}

/// Whether the group of the surface has each of the matrices, where its word says.
bool has_generators(const MatrixSurface& made, const MatrixGenerators& matrices) {
  for (std::size_t k = 0; k < matrices.generators.size(); ++k) {
    if (!is_path(made.surface, TileId(0), TileId(0), made.words[k])) return false;
    if (!same(exact_isometry(made.surface, made.words[k]), matrices.generators[k])) return false;
  }
  return made.words.size() == matrices.generators.size();
}

TEST(Matrices, OfASurfaceMakeTheSameSurface) {
  for (const Surface& surface : {random_octagon(3), pants_surface(3)}) {
    for (const MatrixModel model : {MatrixModel::sl2r, MatrixModel::su11}) {
      const MatrixGenerators matrices = parse_matrices(write_matrices(surface, model));
      EXPECT_EQ(matrices.model, model);
      EXPECT_EQ(matrices.generators.size(), 2 * surface.genus());
      EXPECT_EQ(matrices.relation.size(), 4 * surface.genus());
      const MatrixSurface made = surface_of_matrices(matrices);
      EXPECT_TRUE(made.is_exact);
      EXPECT_EQ(made.distance, 0);
      EXPECT_EQ(made.surface.genus(), surface.genus());
      EXPECT_TRUE(has_generators(made, matrices));
      EXPECT_EQ(isometric(surface, made.surface).kind, IsometricAnswer::Kind::yes);
    }
  }
}

TEST(Matrices, OfAnOctagonAreItsSidePairings) {
  EXPECT_EQ(parse_matrices(write_matrices(random_octagon(3))).relation,
            (std::vector<std::int32_t>{1, -2, 3, -4, -1, 2, -3, 4}));
}

TEST(Matrices, NeedNoRelation) {
  MatrixGenerators matrices = parse_matrices(write_matrices(random_octagon(5)));
  matrices.relation.clear();
  const MatrixSurface made = surface_of_matrices(matrices);
  EXPECT_TRUE(made.is_exact);
  EXPECT_TRUE(has_generators(made, matrices));
}

TEST(Matrices, MayHaveAFarDomain) {
  MatrixGenerators matrices = parse_matrices(write_matrices(random_octagon(5)));
  const auto far = Isometry<Rational>::translation({Rational(999, 1000), Rational(1, 50)});
  for (Isometry<Rational>& f : matrices.generators) f = far * f * inverse(far);
  EXPECT_TRUE(has_generators(surface_of_matrices(matrices), matrices));
}

RC_GTEST_PROP(MatricesProperty, GeneratorsMayBeAny, ()) {
  const auto seed = *rc::gen::inRange<std::int32_t>(0, 1000);
  const auto moves = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 4), rc::gen::inRange(0, 4)));
  MatrixGenerators matrices = parse_matrices(write_matrices(random_octagon(seed)));
  matrices.relation.clear();
  for (std::size_t m = 0; m < std::min<std::size_t>(moves.size(), 6); ++m) {
    const auto [i, j] = moves[m];
    auto& f = matrices.generators[static_cast<std::size_t>(i)];
    if (i != j) f = f * matrices.generators[static_cast<std::size_t>(j)];
  }
  const MatrixSurface made = surface_of_matrices(matrices);
  RC_ASSERT(made.is_exact);
  RC_ASSERT(made.surface.genus() == 2U);
  RC_ASSERT(has_generators(made, matrices));
}

TEST(Matrices, ThatAreDecimalsAndExactAreExact) {
  MatrixGenerators matrices = parse_matrices(write_matrices(random_octagon(3)));
  matrices.digits = 2;
  EXPECT_TRUE(surface_of_matrices(matrices).is_exact);
}

/// The sum of the squares of the differences of all numbers of matrices.
Mp256 square_of_difference(const std::vector<Isometry<Mp256>>& some, const std::vector<Isometry<Mp256>>& others) {
  Mp256 sum(0);
  for (std::size_t k = 0; k < some.size(); ++k) {
    sum += norm(some[k].a - others[k].a) + norm(some[k].b - others[k].b);
  }
  return sum;
}

std::vector<Isometry<Mp256>> rounded(const std::vector<Isometry<Rational>>& exact) {
  std::vector<Isometry<Mp256>> result;
  for (const Isometry<Rational>& f : exact) result.push_back(normalized(convert<Mp256>(f)));
  return result;
}

TEST(Matrices, ThatAreRoundedMeanTheNearestSurface) {
  // The surface from which they are rounded is one of those that might be the nearest one.
  const Surface surface = pants_surface(2);
  const MatrixGenerators exact = parse_matrices(write_matrices(surface));
  MatrixGenerators given = exact;
  given.digits = 12;
  given.generators.clear();
  for (const Isometry<Mp256>& f : rounded(exact.generators)) {
    const auto decimal = [](const Mp256& x) { return Rational(Mp256(round(x * Mp256("1e12")) / Mp256("1e12"))); };
    given.generators.push_back({{decimal(f.a.x), decimal(f.a.y)}, {decimal(f.b.x), decimal(f.b.y)}});
  }
  const MatrixSurface made = surface_of_matrices(given);
  EXPECT_FALSE(made.is_exact);
  EXPECT_GT(made.distance, 1e-14);
  EXPECT_LT(made.distance, 1e-9);
  std::vector<Isometry<Rational>> found;
  for (const Word& word : made.words) found.push_back(exact_isometry(made.surface, word));
  const Mp256 least = square_of_difference(rounded(found), rounded(given.generators));
  const Mp256 other = square_of_difference(rounded(exact.generators), rounded(given.generators));
  EXPECT_LT(least, other);
  EXPECT_GT(least, 0);
}

/// Of the matrices of a surface, with so many decimals.
MatrixGenerators cut(const MatrixGenerators& exact, const std::vector<Isometry<Mp256>>& generators, int decimals) {
  MatrixGenerators given;
  given.model = MatrixModel::su11;
  given.digits = static_cast<unsigned>(decimals) + 1;  // All numbers that are not 0 are 1 or more, but few.
  given.relation = exact.relation;
  const Mp256 scale = pow(Mp256(10), decimals);
  const auto decimal = [&](const Mp256& x) { return Rational(Mp256(round(Mp256(x * scale)) / scale)); };
  for (const Isometry<Mp256>& f : generators) {
    given.generators.push_back({{decimal(f.a.x), decimal(f.a.y)}, {decimal(f.b.x), decimal(f.b.y)}});
  }
  return given;
}

/// The generators of fundamental_polygon, in the disk, rounded to 256 bits.
std::vector<Isometry<Mp256>> generators_of(const Surface& surface) {
  std::vector<Isometry<Mp256>> result;
  std::vector<bool> seen;
  const FundamentalPolygon polygon = fundamental_polygon(surface);
  seen.resize(polygon.sides.size());
  for (std::size_t k = 0; k < polygon.sides.size(); ++k) {
    if (seen[polygon.sides[k].partner]) continue;
    seen[k] = true;
    Isometry<Mp256> f{{Mp256(1), Mp256(0)}, {Mp256(0), Mp256(0)}};
    for (const SideId s : polygon.sides[k].word) f = normalized(surface.crossing_as<Mp256>(s) * f);
    result.push_back(f);
  }
  return result;
}

TEST(Matrices, OfFewDecimalsMeanTheSurfaceOrNeedMore) {
  const std::vector<Surface> surfaces{named_surface("bolza"), named_surface("klein"), random_octagon(5),
                                      random_octagon(123),    Surface::regular(3),    pants_surface(2)};
  for (const Surface& surface : surfaces) {
    const std::vector<Isometry<Mp256>> generators = generators_of(surface);
    int found = 0;
    for (int decimals = 2; decimals <= 12; ++decimals) {
      const MatrixGenerators given = cut({}, generators, decimals);
      try {
        const MatrixSurface made = surface_of_matrices(given);
        EXPECT_EQ(made.surface.genus(), surface.genus()) << decimals;
        EXPECT_LT(made.distance, 100 * std::pow(10.0, -decimals)) << decimals;
        ++found;
      } catch (const MatricesError& error) {
        EXPECT_EQ(error.kind(), Kind::undecided) << error.what();
        EXPECT_THAT(error.what(), HasSubstr("digits; about")) << decimals;
        EXPECT_EQ(found, 0) << decimals << " decimals do not do, but fewer did";
      }
    }
    EXPECT_GE(found, 3);
  }
}

TEST(Matrices, OfVeryFewDecimalsDoWithARelation) {
  const MatrixGenerators exact = parse_matrices(write_matrices(random_octagon(5), MatrixModel::su11));
  std::vector<Isometry<Mp256>> generators;
  for (const Isometry<Rational>& f : exact.generators) generators.push_back(normalized(convert<Mp256>(f)));
  for (int decimals = 2; decimals <= 12; ++decimals) {
    const MatrixSurface made = surface_of_matrices(cut(exact, generators, decimals));
    EXPECT_EQ(made.surface.genus(), 2U) << decimals;
    EXPECT_LT(made.distance, 10 * std::pow(10.0, -decimals)) << decimals;
  }
}

TEST(Matrices, OfManyDecimalsHaveListsThatAreVerified) {
  // Lengths of the surface that the decimals are rounded from are equal, and those of the nearest rational one are not.
  const MatrixSurface made = surface_of_matrices(cut({}, generators_of(named_surface("bolza")), 60));
  EXPECT_FALSE(made.is_exact);
  const auto list = spectrum(made.surface, Length("4"));
  EXPECT_EQ(list.document.geodesics.size(), 12U);
  for (const auto& cluster : list.document.clusters) EXPECT_FALSE(cluster.count > 1 && cluster.equal);
}

/// With the tiles they would be exact: field_numbers_test.cpp.
TEST(Matrices, OfRegularTilesMeanANearSurfaceIfTheyAreRounded) {
  std::string text = write_matrices(named_surface("bolza"));
  for (const char* name : {"\"tiles\"", "\"generators\""}) text.replace(text.find(name) + 1, 1, "-");
  text.replace(text.find("rounded"), 7, "generators");
  const MatrixSurface made = made_of(text);
  EXPECT_FALSE(made.is_exact);
  EXPECT_EQ(made.surface.genus(), 2U);
  EXPECT_LT(made.distance, 1e-48);
}

TEST(Matrices, ThatGenerateNoGroupOfAClosedSurfaceAreRefusedWithEvidence) {
  const std::vector<std::tuple<std::string, Kind, std::string>> cases = {
      {"1 1 0 1\n0 -1 1 0", Kind::torsion, "element b is elliptic, of order 2"},
      {"0 -1 1 1\n3 0 0 1", Kind::torsion, "element a is elliptic, of order 3"},
      {"3/5 4/5 -4/5 3/5\n2 0 0 1/2", Kind::not_discrete, "element a is elliptic, of infinite order"},
      {"11/10 0 0 10/11\n5/4 3/4 3/4 5/4", Kind::not_discrete, "violate Jorgensen's inequality"},
      {"1 2 0 1\n1 0 2 1", Kind::not_compact, "is parabolic"},
      {"2 1 1 1\n1 1 1 2", Kind::not_compact, "is parabolic"},
      {"3 0 0 1/3\n5/3 4/3 4/3 5/3", Kind::not_compact, "infinite area"},
      {"2 0 0 1/2", Kind::not_compact, "infinite area"},
      {"1 0 0 1", Kind::not_compact, "infinite area"},
      {"3.1 0 0 0.3225806451612903\n1.7 1.374772708 1.374772708 1.7", Kind::not_compact, "infinite area"},
      {"3.1 0 0 0.32258\n1.7 1.37477 1.37477 1.7", Kind::undecided, "infinite area"},
      {"2 0 0 1/2\n5/3 4/3 4/3 5/3\nrelation abAB", Kind::relation, "the relation abAB does not hold"},
  };
  for (const auto& [text, kind, message] : cases) {
    const auto [found, what] = problem(text);
    EXPECT_EQ(found, kind) << text << ": " << what;
    EXPECT_THAT(what, HasSubstr(message)) << text;
  }
}

TEST(Matrices, AFalseRelationOfARightGroupIsNamed) {
  MatrixGenerators matrices = parse_matrices(write_matrices(random_octagon(3)));
  std::swap(matrices.relation[1], matrices.relation[2]);
  EXPECT_THROW((void)surface_of_matrices(matrices), MatricesError);
}

TEST(Matrices, TextsAreReadAsTheyAreMeant) {
  const MatrixGenerators lines =
      parse_matrices("# a comment\nmodel su11\n5/3, 0, 4/3, 0 # a\n-1.5e0 0.5 1 0.25\nrelation aB bA\n");
  EXPECT_EQ(lines.model, MatrixModel::su11);
  ASSERT_EQ(lines.generators.size(), 2U);
  EXPECT_EQ(lines.generators[0].a, (Complex<Rational>{Rational(5, 3), 0}));
  EXPECT_EQ(lines.generators[1].b, (Complex<Rational>{1, Rational(1, 4)}));
  EXPECT_EQ(lines.relation, (std::vector<std::int32_t>{1, -2, 2, -1}));
  EXPECT_EQ(lines.digits, 2U);
  const MatrixGenerators json = parse_matrices(
      R"({"other": [1, {}], "relation": [1, -1], "generators": [[[2, "1/3"], ["3", 1]]], "model": "sl2r"})");
  EXPECT_EQ(json.relation, (std::vector<std::int32_t>{1, -1}));
  EXPECT_FALSE(json.digits);
  // w = (z − i)/(z + i): the trace stays.
  EXPECT_EQ(json.generators[0].a.x, 3);
}

TEST(Matrices, TextsThatAreWrongAreRefused) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "the text is empty"},
      {"{}", "no generators found"},
      {"1 2 3", "line 1: 3 words found, expected the four numbers"},
      {"1 2 3 nan", "line 1: \"nan\" found, expected an integer, a fraction, a decimal, or a number with sqrt(x)"},
      {"1 2 3 1/0", "\"1/0\" found"},
      {"1 0 0 1e99999", "line 1: "},
      {"1 2 3 4", "generator 1: the determinant is not positive"},
      {"2 0 0 1/2\nrelation 1 2", "relation: 2 found, expected generators 1 to 1"},
      {"2 0 0 1/2\nrelation 1 x", "\"x\" found, expected the number of a generator"},
      {"2 0 0 1/2\nrelation a1", "expected letters"},
      {"model so3\n2 0 0 1/2", "model: \"so3\" found, expected \"sl2r\" or \"su11\""},
      {R"({"generators": [[[1, 2]]]})", "generator 1: 1 rows found"},
      {R"({"generators": [[[1, 2, 3], [4]]]})", "generator 1: 3 numbers in a row, expected 2"},
      {R"({"generators": [7]})", "generator 1: "},
      {R"({"generators": [[[1, 0], [0, 1]]], "relation": [99999999999]})", "relation: "},
      {R"({"generators": )", "generators: "},
      {R"({"generators": [[[1, 0], [0, 1]]]} x)", "found after the object"},
      {R"({"model": 3})", "model: "},
  };
  for (const auto& [text, message] : cases) {
    try {
      (void)parse_matrices(text);
      ADD_FAILURE() << text << " was read";
    } catch (const MatricesError& error) {
      EXPECT_EQ(error.kind(), Kind::text);
      EXPECT_THAT(error.what(), HasSubstr(message)) << text;
    }
  }
}

}  // namespace
}  // namespace epsnet::matrices_test
