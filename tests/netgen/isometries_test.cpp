#include "netgen/isometries/isometries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "kernel/plane.h"
#include "netgen/isometries/invariants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::isometries_test {
namespace {

using Kind = IsometricAnswer::Kind;

double middle(const EnclosedNumber& x) { return static_cast<double>(Rational((x.lower + x.upper) / 2)); }

/// |Re a| of the value of a word: half the trace.
double half_trace(const Surface& surface, const Word& word) {
  return std::abs(middle(enclosed_isometry(surface, word, 100).a_re));
}

/// Checks, by a way of its own, that an isometry keeps relations and lengths: those of all products of at most three
/// generators.
void expect_isometry(const Surface& from, const Surface& to, const SurfaceIsometry& isometry) {
  const std::vector<Word> words = generator_words(from);
  ASSERT_EQ(isometry.images.size(), words.size());
  const auto expect_same = [&](const Word& word, const Word& image) {
    const double expected = half_trace(from, word);
    EXPECT_NEAR(half_trace(to, image), expected, 1e-9 * expected);
  };
  const std::size_t count = std::min<std::size_t>(words.size(), 6);
  for (std::size_t i = 0; i < count; ++i) {
    expect_same(words[i], isometry.images[i]);
    for (std::size_t j = 0; j < i; ++j) {
      const Word word = concatenated(from, words[i], words[j]);
      const Word image = concatenated(to, isometry.images[i], isometry.images[j]);
      expect_same(word, image);
      for (std::size_t k = 0; k < j; ++k) {
        expect_same(concatenated(from, word, words[k]), concatenated(to, image, isometry.images[k]));
      }
    }
  }
  const FundamentalPolygon polygon = fundamental_polygon(from);
  std::vector<std::size_t> pair(polygon.sides.size());
  for (std::size_t k = 0, number = 0; k < pair.size(); ++k) {
    if (k < polygon.sides[k].partner) pair[k] = pair[polygon.sides[k].partner] = number++;
  }
  for (const std::vector<std::uint32_t>& relation : polygon.relations) {
    // γ₁γ₂… applies the last one first, and a word its first letter.
    Word word;
    for (auto k = relation.rbegin(); k != relation.rend(); ++k) {
      const Word& image = isometry.images[pair[*k]];
      word = concatenated(to, word, *k < polygon.sides[*k].partner ? image : reversed(to, image));
    }
    const EnclosedIsometry product = enclosed_isometry(to, word, 100);
    EXPECT_NEAR(std::abs(middle(product.a_re)), 1, 1e-9);
    EXPECT_NEAR(middle(product.b_re), 0, 1e-9);
  }
}

/// Checks that the permutations are a group, and that the orders and numbers of fixed points fit: by Hurwitz's formula
/// the surface has 2g − 2 = n(2h − 2) + Σ fixed points, summed over all f ≠ 1 that preserve the orientation, for n of
/// them and a quotient of genus h.
void expect_group(const Surface& surface, const IsometryGroup& group) {
  const auto count = static_cast<std::uint32_t>(group.size());
  std::int64_t fixed = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Permutation p = group.permutation(i);
    Permutation sorted = p;
    std::sort(sorted.begin(), sorted.end());
    for (std::uint32_t j = 0; j < count; ++j) ASSERT_EQ(sorted[j], j);
    EXPECT_EQ(p[0], i);
    fixed += static_cast<std::int64_t>(group.fixed_points(i).value_or(0));
    const std::uint32_t j = (7 * i + 3) % count;
    EXPECT_EQ(group.preserves_orientation(p[j]), group.preserves_orientation(i) == group.preserves_orientation(j));
  }
  const auto preserving = static_cast<std::int64_t>(group.orientation_preserving());
  const std::int64_t rest = 2 * std::int64_t{surface.genus()} - 2 - fixed;
  EXPECT_EQ(rest % (2 * preserving), 0);
  EXPECT_GE(rest / preserving, -2);
}

/// That they are proved, by a file of so many isometries.
void expect_proof(const Surface& surface, const IsometryGroup& group) {
  const auto [document, certificate] = certified_isometries(surface, group);
  EXPECT_EQ(certificate.verdict, certify::Verdict::verified) << certify::verdict_line(certificate);
  EXPECT_EQ(document.order, group.size());
}

struct Expected {
  std::string name;
  std::size_t preserving;
  std::size_t all;
};

class KnownGroup : public testing::TestWithParam<Expected> {};

TEST_P(KnownGroup, HasTheOrderOfTheLiterature) {
  const Surface surface = named_surface(GetParam().name);
  const IsometryGroup group = isometries(surface);
  EXPECT_EQ(group.orientation_preserving(), GetParam().preserving);
  EXPECT_EQ(group.size(), GetParam().all);
  expect_group(surface, group);
  expect_proof(surface, group);
  for (const std::uint32_t g : group.generators()) expect_isometry(surface, surface, group.isometry(g));
}

INSTANTIATE_TEST_SUITE_P(Isometries, KnownGroup,
                         testing::Values(Expected{"bolza", 48, 96}, Expected{"klein", 168, 336},
                                         Expected{"bring", 120, 240}, Expected{"fermat-quartic", 96, 192},
                                         Expected{"wiman-2", 10, 20}, Expected{"wiman-3", 14, 28},
                                         Expected{"accola-maclachlan-3", 32, 64},
                                         Expected{"accola-maclachlan-4", 40, 80}),
                         [](const auto& row) {
                           std::string name = row.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Isometries, OfRegularPolygonsTurnAndReflectThem) {
  // The rotations of the 4g-gon and the hyperelliptic involution, which is among them; in genus 2 there are more.
  for (const std::uint32_t genus : {3U, 5U}) {
    const Surface surface = Surface::regular(genus);
    const IsometryGroup group = isometries(surface);
    EXPECT_EQ(group.orientation_preserving(), 8 * genus);
    EXPECT_EQ(group.size(), 16 * genus);
    expect_group(surface, group);
    expect_proof(surface, group);
  }
}

TEST(Isometries, OfARandomOctagonAreTheHyperellipticInvolution) {
  for (int seed = 0; seed < 100; ++seed) {
    const Surface surface = random_octagon(seed);
    const IsometryGroup group = isometries(surface);
    ASSERT_EQ(group.size(), 2U) << "seed " << seed;
    EXPECT_TRUE(group.preserves_orientation(1));
    EXPECT_EQ(group.fixed_points(1), 6U);
    EXPECT_EQ(group.name(), "C2");
    if (seed < 20) expect_proof(surface, group);
  }
}

TEST(Isometries, AreTheSameForAnyNumberOfThreads) {
  const Surface surface = named_surface("bring");
  const IsometryGroup one = isometries(surface, {.threads = 1, .progress = {}});
  const IsometryGroup three = isometries(surface, {.threads = 3, .progress = {}});
  ASSERT_EQ(one.size(), three.size());
  for (std::uint32_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one.isometry(i).images, three.isometry(i).images);
    EXPECT_EQ(one.permutation(i), three.permutation(i));
  }
}

TEST(Isometries, HaveNames) {
  EXPECT_EQ(isometries(named_surface("wiman-3")).name(), "D14");
  EXPECT_EQ(isometries(named_surface("klein")).name(), "");
}

TEST(Isometries, OfThinSurfacesAreFound) {
  const Surface thin =
      fenchel_nielsen_surface(resolve({"0-1 0-1 0-1", {}, {}, {"1/50", "1", "1"}, {"1/8", "1/4", "1/2"}}));
  const IsometryGroup group = isometries(thin);
  EXPECT_EQ(group.size(), 2U);
  expect_proof(thin, group);
}

TEST(Isometries, OfMostSurfacesOfHigherGenusAreTheIdentity) {
  for (const std::uint32_t genus : {3U, 4U}) {
    // On one of genus 4 the closed geodesics of length at most 4 do not tell that.
    const Surface surface = fenchel_nielsen_surface(resolve({"", genus, 2, {}, {}}));
    const IsometryGroup group = isometries(surface);
    EXPECT_EQ(group.size(), 1U);
    expect_proof(surface, group);
  }
}

TEST(Isometries, OfAMapOfManyTilesAreProved) {
  const Surface surface = named_surface("bring");
  const auto [document, certificate] = certified_isometries(surface, isometries(surface));
  ASSERT_EQ(certificate.verdict, certify::Verdict::verified);
  EXPECT_EQ(certificate.claim, "the surface has exactly 240 isometries, half of which preserve the orientation");
}

TEST(Isometries, OfAChiralMapAndOfCoversAreProved) {
  const Surface chiral = load_surface(std::string(EPSNET_TEST_DATA) + "/isometries/chiral-11.json");
  const IsometryGroup group = isometries(chiral);
  EXPECT_EQ(group.size(), 160U);
  EXPECT_EQ(group.orientation_preserving(), 160U);
  expect_group(chiral, group);
  expect_proof(chiral, group);
  const Surface base = named_surface("bolza");
  for (const std::uint64_t seed : {1U, 4U, 5U}) {
    const Surface surface = cover(base, random_sheets(base, 5, seed));
    expect_proof(surface, isometries(surface));
  }
}

/// An octagon cut along the diagonal between corners 0 and 4, both halves moved, and tile 1 named first.
Surface cut_octagon(const Surface& octagon) {
  const Tile& corners = octagon.tiles()[0];
  const auto moved = [](const Isometry<Rational>& f, std::vector<Complex<Rational>> points) {
    for (Complex<Rational>& z : points) z = f(z);
    return points;
  };
  const auto by = [](int x, int y) { return Isometry<Rational>::translation({Rational(x) / 7, Rational(y) / 5}); };
  const Tile first = moved(by(1, 1), {corners[4], corners[5], corners[6], corners[7], corners[0]});
  const Tile second = moved(by(-1, 2), {corners[0], corners[1], corners[2], corners[3], corners[4]});
  // Side k of the octagon is side k − 4 of the first tile, or side k of the second one; side 4 of both is the diagonal.
  std::vector<Gluing> gluing{{0, 4, 1, 4}};
  for (std::uint32_t k = 0; k < 4; ++k) gluing.push_back({1, k, 0, k});
  return Surface({first, second}, gluing);
}

TEST(Isometric, IsASurfaceThatIsCutAndGluedAnew) {
  const Surface octagon = random_octagon(5);
  const Surface cut = cut_octagon(octagon);
  for (const auto& [from, to] : {std::pair(octagon, cut), std::pair(cut, octagon)}) {
    const IsometricAnswer answer = isometric(from, to);
    ASSERT_EQ(answer.kind, Kind::yes);
    expect_isometry(from, to, *answer.isometry);
  }
}

TEST(Isometric, IsAMirrorImage) {
  const Surface octagon = random_octagon(5);
  Tile mirrored;
  for (std::size_t k = 8; k-- > 0;) mirrored.push_back(conj(octagon.tiles()[0][k]));
  std::vector<Gluing> gluing;
  for (std::uint32_t k = 0; k < 4; ++k) gluing.push_back({0, k, 0, k + 4});
  const Surface mirror({mirrored}, gluing);
  const IsometricAnswer answer = isometric(octagon, mirror);
  ASSERT_EQ(answer.kind, Kind::yes);
  EXPECT_FALSE(answer.isometry->preserves_orientation);
  expect_isometry(octagon, mirror, *answer.isometry);
}

Surface pants(const std::string& length, const std::string& twist) {
  return fenchel_nielsen_surface(resolve({"0-1 0-1 0-1", {}, {}, {length, "2.5", "3"}, {twist, "0.2", "0.3"}}));
}

TEST(Isometric, IsASurfaceWithADehnTwist) {
  const IsometricAnswer answer = isometric(pants("2", "0.125"), pants("2", "2.125"));
  ASSERT_EQ(answer.kind, Kind::yes);
  expect_isometry(pants("2", "0.125"), pants("2", "2.125"), *answer.isometry);
}

TEST(Isometric, AreNotSurfacesThatDifferALittle) {
  EXPECT_EQ(isometric(pants("2", "0.125"), pants("2.000000001", "0.125")).kind, Kind::no);
  EXPECT_EQ(isometric(pants("2", "0.125"), pants("2", "0.125000001")).kind, Kind::no);
  EXPECT_EQ(isometric(random_octagon(1), random_octagon(2)).kind, Kind::no);
}

TEST(Isometric, TheAnswerIsAFileThatIsVerified) {
  using Relation = certify::ComparisonDocument::Relation;
  const IsometricAnswer no = isometric(pants("2", "0.125"), pants("2.000000001", "0.125"));
  ASSERT_TRUE(no.proof);
  EXPECT_EQ(no.proof->document.relation, Relation::different);
  EXPECT_EQ(certify::check(no.proof->document).verdict, certify::Verdict::verified);
  EXPECT_EQ(certain_difference(no.proof->document, no.proof->document.other), no.reason);
  const IsometricAnswer yes = isometric(pants("2", "0.125"), pants("2", "2.125"));
  ASSERT_TRUE(yes.proof);
  EXPECT_EQ(yes.proof->document.relation, Relation::isometric);
  EXPECT_EQ(certify::check(yes.proof->document).verdict, certify::Verdict::verified);
}

TEST(Isometric, AreNotSurfacesWhoseLengthsAgreeToAllDigits) {
  // The surface nearest to matrices of 30 digits: lengths are enclosed to some 16 digits, but crossings to more.
  const Surface octagon = random_octagon(3);
  MatrixGenerators matrices = parse_matrices(write_matrices(octagon));
  matrices.digits = 30;
  for (Isometry<Rational>& f : matrices.generators) {
    const auto decimal = [](const Mp256& x) { return Rational(Mp256(round(x * Mp256("1e28")) / Mp256("1e28"))); };
    const Isometry<Mp256> g = normalized(convert<Mp256>(f));
    f = {{decimal(g.a.x), decimal(g.a.y)}, {decimal(g.b.x), decimal(g.b.y)}};
  }
  const MatrixSurface near = surface_of_matrices(matrices);
  ASSERT_FALSE(near.is_exact);
  const IsometricAnswer answer = isometric(octagon, near.surface);
  EXPECT_EQ(answer.kind, Kind::no);
  EXPECT_FALSE(answer.isometry);
  EXPECT_NE(answer.reason.find("no isometry takes the points where closed geodesics"), std::string::npos)
      << answer.reason;
  ASSERT_TRUE(answer.near);
  EXPECT_LT(answer.near->difference, 1e-25);
}

TEST(Isometric, SurfacesThatAreNearlySoHaveAMarkingThatHardlyChangesTraces) {
  const Surface surface = pants("2", "0.125");
  for (const char* twist : {"0.125001", "0.12500001"}) {
    const Surface other = pants("2", twist);
    const IsometricAnswer answer = isometric(surface, other);
    EXPECT_EQ(answer.kind, Kind::no);
    ASSERT_TRUE(answer.near);
    const double moved = std::stod(twist) - 0.125;
    EXPECT_GT(answer.near->difference, moved / 100);
    EXPECT_LT(answer.near->difference, moved * 100);
    EXPECT_EQ(answer.near->marking.images.size(), generator_words(surface).size());
  }
  EXPECT_FALSE(isometric(surface, pants("2", "0.5")).near);
  EXPECT_FALSE(isometric(random_octagon(1), random_octagon(2)).near);
  EXPECT_FALSE(isometric(surface, surface).near);
}

certify::GeodesicsDocument lengths(const std::vector<certify::Interval>& intervals, const std::string& up_to) {
  certify::GeodesicsDocument result;
  result.claim = certify::GeodesicsDocument::Claim::spectrum;
  result.up_to = up_to;
  for (const certify::Interval& length : intervals) result.geodesics.push_back({0, {}, length, true});
  return result;
}

TEST(CertainDifference, IsOneOfNumbersAndNotOfOverlappingIntervals) {
  const auto some = lengths({{1, 1.25}, {2, 2.25}}, "3");
  EXPECT_FALSE(certain_difference(some, some));
  EXPECT_FALSE(certain_difference(some, lengths({{1.25, 1.5}, {2.25, 2.5}}, "3")));
  EXPECT_EQ(
      certain_difference(some, lengths({{1.5, 1.75}, {2, 2.25}}, "3")),
      "the first surface has at least 1 primitive closed geodesics of length at most 1.25, the second one at most "
      "0");
  EXPECT_EQ(
      certain_difference(some, lengths({{1, 1.25}, {1, 1.25}}, "3")),
      "the second surface has at least 2 primitive closed geodesics of length at most 1.25, the first one at most "
      "1");
  // A list says nothing about longer ones than those that it has all of.
  EXPECT_FALSE(certain_difference(some, lengths({{1, 1.25}}, "2")));
  EXPECT_FALSE(certain_difference(some, lengths({{1, 1.25}}, "2.2499999999999999999")));
  EXPECT_TRUE(certain_difference(some, lengths({{1, 1.25}}, "2.25")));
  EXPECT_TRUE(certain_difference(lengths({{1, 1.25}}, "2.25"), some));
  EXPECT_FALSE(certain_difference(lengths({}, "1"), some));
}

TEST(Isometric, AreNotSurfacesOfDifferentGenera) {
  const IsometricAnswer answer = isometric(Surface::regular(2), Surface::regular(3));
  EXPECT_EQ(answer.kind, Kind::no);
  EXPECT_EQ(answer.reason, "the genera are 2 and 3");
}

TEST(Isometries, AreNotSearchedForNextToVeryShortGeodesics) {
  const Surface thin =
      fenchel_nielsen_surface(resolve({"0-1 0-1 0-1", {}, {}, {"1/200", "1/200", "1/200"}, {"0", "0", "0"}}));
  EXPECT_THROW(static_cast<void>(isometries(thin)), LimitError);
}

TEST(Isometric, AreMapsOfTheSameType) {
  const Surface klein = named_surface("klein");
  const IsometricAnswer answer = isometric(klein, klein);
  ASSERT_EQ(answer.kind, Kind::yes);
  expect_isometry(klein, klein, *answer.isometry);
}

// The Bolza surface as a map of type {8, 3}, by two generators of GL(2,3) as they permute the vectors other than 0.
Surface bolza_of_octagons() { return surface_of_map(map_of_group({3, 7, 0, 4, 5, 1, 2, 6}, {2, 5, 0, 3, 6, 1, 4, 7})); }

TEST(Isometric, AreSurfacesWhoseNumbersAreOfDifferentKinds) {
  EXPECT_EQ(isometries(bolza_of_octagons()).size(), 96U);
  const std::vector<Surface> bolza{
      Surface::regular(2), bolza_of_octagons(),
      surface_of_matrices(
          parse_matrices("model su11\n1+sqrt(2) 0 sqrt(2+2*sqrt(2)) 0\n1+sqrt(2) 0 sqrt(1+sqrt(2)) sqrt(1+sqrt(2))\n"
                         "1+sqrt(2) 0 0 sqrt(2+2*sqrt(2))\n1+sqrt(2) 0 -sqrt(1+sqrt(2)) sqrt(1+sqrt(2))\n"))
          .surface};
  ASSERT_FALSE(bolza[2].is_rational() || bolza[2].is_regular());
  // Regular heptagons, and F. Klein's polygon: one regular 14-gon.
  const std::vector<Surface> klein{
      named_surface("klein"), surface_of_map(parse_map(R"({"rotation": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 0],
        "edges": [5, 10, 7, 12, 9, 0, 11, 2, 13, 4, 1, 6, 3, 8]})"))};
  // The quartic x⁴ + y⁴ + z⁴ = 0 of octagons, and the surface of eight squares (F. Herrlich, G. Schmithüsen, An
  // extraordinary origami curve, Math. Nachr. 281, 2008) as the map of type {4, 8} that its squares make.
  const std::vector<Surface> fermat{named_surface("fermat-quartic"), Surface::map({4, 8}, {{0, 0, 6, 2},
                                                                                           {0, 1, 1, 3},
                                                                                           {0, 2, 2, 0},
                                                                                           {0, 3, 5, 1},
                                                                                           {1, 0, 7, 2},
                                                                                           {1, 1, 4, 3},
                                                                                           {1, 2, 3, 0},
                                                                                           {2, 1, 7, 3},
                                                                                           {2, 2, 4, 0},
                                                                                           {2, 3, 3, 1},
                                                                                           {3, 2, 5, 0},
                                                                                           {3, 3, 6, 1},
                                                                                           {4, 1, 5, 3},
                                                                                           {4, 2, 6, 0},
                                                                                           {5, 2, 7, 0},
                                                                                           {6, 3, 7, 1}})};
  for (const std::vector<Surface>& surfaces : {bolza, klein, fermat}) {
    for (const Surface& from : surfaces) {
      for (const Surface& to : surfaces) {
        if (&from == &to) continue;
        const IsometricAnswer answer = isometric(from, to);
        ASSERT_EQ(answer.kind, Kind::yes) << from.about() << ", " << to.about() << ": " << answer.reason;
        expect_isometry(from, to, *answer.isometry);
      }
    }
  }
}

TEST(DeepIsometries, OfTheFrickeMacbeathCurve) {
  const Surface surface = named_surface("fricke-macbeath");
  const IsometryGroup group = isometries(surface);
  EXPECT_EQ(group.orientation_preserving(), 504U);
  EXPECT_EQ(group.size(), 1008U);
  EXPECT_EQ(certified_isometries(surface, group).certificate.verdict, certify::Verdict::verified);
}

TEST(DeepIsometries, OfARegularPolygonOfHigherGenus) {
  const Surface surface = Surface::regular(10);
  const IsometryGroup group = isometries(surface);
  EXPECT_EQ(group.orientation_preserving(), 80U);
  EXPECT_EQ(group.size(), 160U);
  EXPECT_EQ(certified_isometries(surface, group).certificate.verdict, certify::Verdict::verified);
}

}  // namespace
}  // namespace epsnet::isometries_test
