#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <rapidcheck/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "netgen/curves/curves.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/isometries.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::mapping_class_test {
namespace {

Surface surface_of(std::uint32_t genus, std::uint64_t seed) {
  return fenchel_nielsen_surface(random_coordinates(PantsGraph::random(genus, seed), seed));
}

/// A product of up to so many twists along generators.
MappingClass any_class(const MappingClassGroup& group, std::size_t most) {
  MappingClass result;
  const auto count = *rc::gen::inRange<std::size_t>(0, most + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto which = *rc::gen::inRange<std::size_t>(0, group.generators().size());
    const auto power = *rc::gen::element(-2, -1, 1, 2);
    result.push_back({group.generators()[which].curve, power});
  }
  return result;
}

ClosedCurve any_curve(const Surface& surface, const CurveTopology& topology) {
  Word word;
  const auto count = *rc::gen::inRange<std::size_t>(1, 6);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& basis = topology.homology_basis();
    const Word& next = basis[*rc::gen::inRange<std::size_t>(0, basis.size())];
    word = concatenated(surface, std::move(word), *rc::gen::element(false, true) ? next : reversed(surface, next));
  }
  return topology.curve(word);
}

double length(const Surface& surface, const Word& word) {
  const EnclosedNumber a = enclosed_isometry(surface, word, 100).a_re;
  return 2 * std::acosh(std::abs(static_cast<double>(a.lower)));
}

/// A word of the surface of triangles into which the diagonals from corner 0 cut the tiles, for the surface itself.
Word through_tiles(const Surface& surface, const Word& word) {
  std::vector<std::optional<SideId>> side_of;  // By side of a triangle; none for a diagonal.
  for (const TileId tile : surface.tile_ids()) {
    const auto count = static_cast<std::uint32_t>(surface.tile(tile).size());
    for (std::uint32_t k = 1; k + 1 < count; ++k) {
      side_of.push_back(k == 1 ? std::optional(surface.side_number(tile, 0)) : std::nullopt);
      side_of.emplace_back(surface.side_number(tile, k));
      side_of.push_back(k + 2 == count ? std::optional(surface.side_number(tile, k + 1)) : std::nullopt);
    }
  }
  Word result;
  for (const SideId s : word) {
    if (const auto side = side_of[s.number()]) result.push_back(*side);
  }
  return result;
}

bool same(const ClosedCurve& x, const ClosedCurve& y) { return x.root == y.root && x.power == y.power; }

TEST(MappingClassGroup, GeneratorsMeetAsTheirNamesSay) {
  for (const Surface& surface : {random_octagon(5), Surface::regular(4), named_surface("klein"), surface_of(5, 2)}) {
    const MappingClassGroup group(surface);
    const auto& generators = group.generators();
    ASSERT_EQ(generators.size(), 3 * surface.genus() - 1);
    std::vector<ClosedCurve> curves;
    for (const NamedCurve& one : generators) curves.push_back(group.topology().curve(one.curve));
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_TRUE(curves[i].is_simple()) << generators[i].name;
      EXPECT_FALSE(curves[i].is_separating()) << generators[i].name;
      for (std::size_t j = 0; j < i; ++j) {
        const std::string& x = generators[j].name;
        const std::string& y = generators[i].name;
        const int m = std::stoi(x.substr(1));
        const int n = std::stoi(y.substr(1));
        const bool meet =
            (x[0] == 'a' && y[0] == 'b' && m == n) || (x[0] == 'b' && y[0] == 'c' && (m == n || m == n + 1));
        EXPECT_EQ(group.topology().intersections(curves[i], curves[j]).geometric, meet ? 1U : 0U) << x << ' ' << y;
      }
    }
  }
}

// The relations of Dehn twists (Farb and Margalit, sections 3.3, 3.5 and 4.4).
TEST(MappingClassGroup, RelationsOfTwistsAreTheIdentityAndNearlyRelationsAreNot) {
  for (const Surface& surface : {random_octagon(5), named_surface("klein"), surface_of(4, 2)}) {
    const MappingClassGroup group(surface);
    const auto is_identity = [&](const std::string& text) { return group.is_identity(group.parse(text)); };
    EXPECT_TRUE(is_identity(""));
    EXPECT_TRUE(is_identity("a1 A1"));
    EXPECT_TRUE(is_identity("a1 b2 A1 B2"));
    EXPECT_TRUE(is_identity("a1 b1 a1 B1 A1 B1"));
    EXPECT_TRUE(is_identity("b1 c1 b1 C1 B1 C1"));
    EXPECT_FALSE(is_identity("a1"));
    EXPECT_FALSE(is_identity("a1 b1 A1 B1"));
    EXPECT_FALSE(is_identity("b1 c1 b1 c1 B1 C1"));
  }
}

TEST(MappingClassGroup, AChainHasTheOrderOfItsRelation) {
  for (const Surface& surface : {random_octagon(5), named_surface("klein"), surface_of(4, 2)}) {
    const MappingClassGroup group(surface);
    const std::uint32_t g = surface.genus();
    std::string chain = "a1";
    for (std::uint32_t i = 1; i <= g; ++i) {
      if (i > 1) chain += " c" + std::to_string(i - 1);
      chain += " b" + std::to_string(i);
    }
    const MappingClass f = group.parse(chain);
    EXPECT_EQ(group.order(f), 4 * g + 2);
    EXPECT_EQ(group.order(product(f, f)), 2 * g + 1);
    EXPECT_EQ(group.order(inverse(f)), 4 * g + 2);
    EXPECT_EQ(group.order({}), 1U);
    EXPECT_EQ(group.order(group.parse("a1")), std::nullopt);
    EXPECT_EQ(group.order(group.parse("a1 b1^2")), std::nullopt);
    // A twist along a separating curve does nothing to homology.
    const Word& a = group.topology().homology_basis()[0];
    const Word& b = group.topology().homology_basis()[1];
    Word commutator = a;
    for (const Word& next : {b, reversed(surface, a), reversed(surface, b)}) {
      commutator.insert(commutator.end(), next.begin(), next.end());
    }
    const MappingClass separating{{commutator, 1}};
    EXPECT_EQ(group.homology(separating), group.homology({}));
    EXPECT_FALSE(group.is_identity(separating));
    EXPECT_EQ(group.order(separating), std::nullopt);
  }
}

TEST(MappingClassGroup, TheHyperellipticInvolutionOfGenus2ReversesTheChain) {
  const Surface surface = random_octagon(5);
  const MappingClassGroup group(surface);
  const MappingClass f = group.parse("a1 b1 c1 b2 a2 a2 b2 c1 b1 a1");
  EXPECT_EQ(group.order(f), 2U);
  for (const NamedCurve& one : group.generators()) {
    const ClosedCurve curve = group.topology().curve(one.curve);
    EXPECT_TRUE(same(group.image(f, curve), group.topology().curve(reversed(surface, one.curve)))) << one.name;
  }
}

RC_GTEST_PROP(MappingClassGroupProperty, ImagesHaveTheIntersectionsAndClassesThatTheyShould, ()) {
  const Surface surface = *rc::gen::element(1, 2) == 1 ? random_octagon(5) : surface_of(3, 1);
  const MappingClassGroup group(surface);
  const CurveTopology& topology = group.topology();
  const MappingClass f = any_class(group, 4);
  const ClosedCurve x = any_curve(surface, topology);
  const ClosedCurve y = any_curve(surface, topology);
  const ClosedCurve fx = group.image(f, x);
  const ClosedCurve fy = group.image(f, y);
  const ClosedCurve again = topology.curve(topology.word(fx));
  RC_ASSERT(same(again, fx));
  RC_ASSERT(again.self_intersections == fx.self_intersections);
  RC_ASSERT(again.homology == fx.homology);
  RC_ASSERT(again.genus_on_the_left == fx.genus_on_the_left);
  RC_ASSERT(fx.power == x.power);
  RC_ASSERT(fx.self_intersections == x.self_intersections);
  RC_ASSERT(topology.intersections(fx, fy).geometric == topology.intersections(x, y).geometric);
  RC_ASSERT(topology.intersections(fx, fy).algebraic == topology.intersections(x, y).algebraic);
  RC_ASSERT(same(group.image(inverse(f), fx), x));
}

RC_GTEST_PROP(MappingClassGroupProperty, AConjugateOfATwistIsTheTwistAlongTheImage, ()) {
  const Surface surface = *rc::gen::element(1, 2) == 1 ? random_octagon(5) : surface_of(3, 1);
  const MappingClassGroup group(surface);
  const MappingClass f = any_class(group, 3);
  const Word curve = group.generators()[*rc::gen::inRange<std::size_t>(0, group.generators().size())].curve;
  const ClosedCurve image = group.image(f, group.topology().curve(curve));
  const MappingClass conjugate = product(product(f, {{curve, 1}}), inverse(f));
  RC_ASSERT(group.is_identity(product(conjugate, {{group.topology().word(image), -1}})));
}

TEST(MappingClassGroup, AnIsometryIsRecognized) {
  const Surface surface = named_surface("bolza");
  const MappingClassGroup group(surface);
  const IsometryGroup isometries = epsnet::isometries(surface);
  const std::vector<Word> sides = generator_words(surface);
  const MappingClass involution = group.parse("a1 b1 c1 b2 a2 a2 b2 c1 b1 a1");
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < isometries.size(); ++i) {
    if (!isometries.preserves_orientation(i)) continue;
    if (!group.is_isometry(involution, isometries.isometry(i))) continue;
    ++found;
    EXPECT_EQ(isometries.order(i), 2U);
    EXPECT_EQ(isometries.fixed_points(i), 6U);
  }
  EXPECT_EQ(found, 1U);
}

TEST(MappingClassGroup, AMarkingTakesWordsToTheirImages) {
  for (const Surface& surface : {random_octagon(5), surface_of(2, 3)}) {
    const MappingClassGroup group(surface);
    const MappingClass f = group.parse("a1 B1 c1^2");
    const Surface marked = with_marking(surface, f);
    const MappingClassGroup again(marked);
    for (const NamedCurve& one : again.generators()) {
      const ClosedCurve curve = again.topology().curve(one.curve);
      const Word original = through_tiles(surface, one.curve);
      const ClosedCurve image = group.image(f, group.topology().curve(original));
      EXPECT_NEAR(length(marked, again.topology().word(curve)), length(surface, group.topology().word(image)), 1e-9);
    }
  }
}

TEST(MappingClassGroup, ASurfaceWithAMarkingIsIsometricAlsoWhenItsTilesAreLong) {
  const Surface surface = surface_of(2, 1);
  const MappingClassGroup group(surface);
  const Surface marked = with_marking(surface, group.parse("a1 B1 c1"));
  // Sides are up to 55 long, the Dirichlet domain's radius is 3.
  const IsometricAnswer answer = isometric(surface, marked);
  EXPECT_EQ(answer.kind, IsometricAnswer::Kind::yes) << answer.reason;
}

TEST(MappingClassGroup, InAMarkingATwistAlongACuffAddsItsLength) {
  // Tiles that are triangles keep their gluing.
  const Surface base = random_octagon(5);
  const Surface surface = with_marking(base, MappingClassGroup(base).parse("a1 A1"));
  const PantsDecomposition pants = pants_decomposition(surface);
  const auto middle = [](certify::Interval x) { return (x.lower + x.upper) / 2; };
  for (std::size_t e = 0; e < pants.cuffs.size(); ++e) {
    for (const std::int32_t power : {0, 1, -3}) {
      const Surface twisted = power == 0 ? surface : dehn_twisted(surface, pants.cuffs[e].curve, power);
      const PantsDecomposition marked = marked_pants(twisted, pants.document);
      EXPECT_EQ(marked.certificate.verdict, certify::Verdict::verified);
      for (std::size_t f = 0; f < pants.cuffs.size(); ++f) {
        const double length = middle(pants.cuffs[f].length);
        EXPECT_NEAR(middle(marked.cuffs[f].length), length, 1e-12);
        const double turns = f == e ? power : 0;
        EXPECT_NEAR(middle(marked.cuffs[f].twist), middle(pants.cuffs[f].twist) + turns * length, 1e-10) << e << f;
      }
    }
  }
  EXPECT_THROW((void)marked_pants(base, pants.document), SurfaceError);
  certify::PantsDocument forged = pants.document;
  forged.cuffs[0].length = {1, 1};
  EXPECT_THROW((void)marked_pants(surface, forged), SurfaceError);
}

TEST(MappingClassGroup, TextsThatAreNoProductsAreRefused) {
  const MappingClassGroup group(random_octagon(5));
  const auto message = [&](const char* text) -> std::string {
    try {
      (void)group.parse(text);
    } catch (const MappingClassError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("a1 b1^-3 C1*(0 1,2)^2"), "");
  EXPECT_EQ(message("a1 d1"),
            "at character 4 of \"a1 d1\": expected a name from a1 to c1, in upper case for the inverse, or a word of "
            "sides in parentheses");
  EXPECT_EQ(message("a1^"), "at character 3 of \"a1^\": expected an exponent from -1000 to 1000");
  EXPECT_EQ(message("a1^2000"), "at character 3 of \"a1^2000\": expected an exponent from -1000 to 1000");
  EXPECT_EQ(message("(0 1"), "at character 1 of \"(0 1\": expected a word that ends with )");
  EXPECT_EQ(message("(0 x)"), "at character 4 of \"(0 x)\": expected the number of a side, or )");
  const ClosedCurve curve = group.topology().curve({SideId(0)});
  EXPECT_THROW((void)group.image(group.parse("(0 0)"), curve), CurveError);
  EXPECT_THROW((void)group.image(group.parse("(99)"), curve), CurveError);
}

}  // namespace
}  // namespace epsnet::mapping_class_test
