#include "netgen/pants/pants.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::pants_test {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

FenchelNielsen coordinates(const std::string& graph, std::vector<Rational> lengths, std::vector<Rational> twists) {
  return {PantsGraph::parse(graph), std::move(lengths), std::move(twists)};
}

PantsOptions found() {
  PantsOptions result;
  result.own = false;
  return result;
}

/// What is wrong with intervals that should contain a number, but for the rounding of fenchel_nielsen_surface; empty if
/// nothing is.
std::string problem(const PantsDecomposition& pants, const FenchelNielsen& expected) {
  if (pants.graph.edges() != expected.graph.edges()) return "the graph is " + graph_text(pants.graph);
  for (std::size_t e = 0; e < pants.cuffs.size(); ++e) {
    const auto length = static_cast<double>(expected.lengths[e]);
    const double rounding = std::ldexp(length, -49);
    const auto& [lower, upper] = pants.cuffs[e].length;
    if (!(lower <= length + rounding && upper >= length - rounding && upper - lower <= rounding)) {
      return "length " + std::to_string(e) + ": " + to_string(pants.cuffs[e].length);
    }
    const certify::Interval twist = pants.cuffs[e].twist;
    const double turns = std::nearbyint((static_cast<double>(expected.twists[e]) - twist.lower) / length);
    const double nearest = static_cast<double>(Rational(expected.twists[e] - Rational(turns) * expected.lengths[e]));
    if (!(twist.lower <= nearest + rounding && twist.upper >= nearest - rounding &&
          twist.upper - twist.lower <= rounding)) {
      return "twist " + std::to_string(e) + ": " + to_string(twist);
    }
    if (std::max(std::abs(twist.lower), std::abs(twist.upper)) > length / 2 + rounding) return "a twist too large";
  }
  return "";
}

/// The lengths of the spectrum up to 4.
std::vector<double> lengths(const Surface& surface) {
  std::vector<double> result;
  for (const auto& geodesic : unproved::spectrum(surface, Length("4")).geodesics)
    result.push_back(geodesic.length.lower);
  return result;
}

RC_GTEST_PROP(PantsProperty, CoordinatesAreReadBack, ()) {
  const auto genus = *rc::gen::inRange<std::uint32_t>(2, 5);
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const FenchelNielsen given = random_coordinates(PantsGraph::random(genus, seed), seed);
  const PantsDecomposition pants = pants_decomposition(fenchel_nielsen_surface(given));
  RC_ASSERT(pants.own);
  RC_ASSERT(problem(pants, given) == "");
  for (const auto& cuff : pants.cuffs) RC_ASSERT(cuff.exact_root.has_value());
}

RC_GTEST_PROP(PantsProperty, ShortCurvesGiveTheSurfaceAgain, ()) {
  const auto genus = *rc::gen::inRange<std::uint32_t>(2, 4);
  const auto seed = *rc::gen::inRange<std::uint32_t>(0, 1000);
  const Surface surface = genus == 2 ? random_octagon(static_cast<std::int32_t>(seed))
                                     : fenchel_nielsen_surface(random_coordinates(PantsGraph::random(3, seed), seed));
  const PantsDecomposition pants = pants_decomposition(surface, found());
  RC_ASSERT(!pants.own);
  const Surface again = fenchel_nielsen_surface(pants.coordinates());
  RC_ASSERT(problem(pants_decomposition(again), pants.coordinates()) == "");
  const std::vector<double> expected = lengths(surface);
  const std::vector<double> actual = lengths(again);
  RC_ASSERT(actual.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) RC_ASSERT(std::abs(actual[i] - expected[i]) < 1e-9);
}

TEST(Pants, ThePathsOfPantsAreThoseOfItsCuffs) {
  const Surface surface = random_octagon(5);
  const PantsDecomposition pants = pants_decomposition(surface);
  ASSERT_THAT(pants.pants, SizeIs(2));
  for (const auto& paths : pants.pants) {
    const Word all = concatenated(surface, concatenated(surface, paths[0], paths[1]), paths[2]);
    const Isometry<Rational> f = exact_isometry(surface, all);
    EXPECT_EQ(f.b, Complex<Rational>{});
    EXPECT_EQ(f.a.y, 0);
  }
  for (std::size_t e = 0; e < pants.cuffs.size(); ++e) {
    const EnclosedIsometry f = enclosed_isometry(surface, pants.cuffs[e].curve, 100);
    const double length = 2 * std::acosh(std::abs(static_cast<double>(f.a_re.lower)));
    EXPECT_NEAR(length, pants.cuffs[e].length.lower, 1e-12);
  }
}

TEST(Pants, ThreeShortestCurvesOfBolzasSurface) {
  const PantsDecomposition pants = pants_decomposition(Surface::regular(2));
  ASSERT_THAT(pants.cuffs, SizeIs(3));
  // The systole, cosh(l/2) = 1 + √2, and the second length of the spectrum, cosh(l/2) = 3 + 2√2.
  EXPECT_NEAR(pants.cuffs[0].length.lower, 2 * std::acosh(1 + std::sqrt(2)), 1e-12);
  EXPECT_NEAR(pants.cuffs[1].length.lower, 2 * std::acosh(1 + std::sqrt(2)), 1e-12);
  EXPECT_NEAR(pants.cuffs[2].length.lower, 2 * std::acosh(3 + 2 * std::sqrt(2)), 1e-12);
  EXPECT_FALSE(pants.cuffs[0].exact_root);
}

TEST(Pants, NamedSurfacesOfGenus3To5) {
  for (const char* name : {"klein", "wiman-3", "bring"}) {
    const Surface surface = named_surface(name);
    const PantsDecomposition pants = pants_decomposition(surface);
    EXPECT_EQ(pants.graph.genus(), surface.genus()) << name;
    EXPECT_EQ(pants_decomposition(fenchel_nielsen_surface(pants.coordinates())).graph.edges(), pants.graph.edges());
  }
}

TEST(DeepPants, RandomCoversOfGenus31And51) {
  for (const std::uint32_t degree : {30u, 50u}) {
    for (const std::int32_t seed : {1, 2, 3}) {
      const Surface octagon = random_octagon(seed);
      const auto sheets = random_sheets(octagon, degree, static_cast<std::uint64_t>(seed));
      const PantsDecomposition pants = pants_decomposition(cover(octagon, sheets));
      EXPECT_EQ(pants.graph.genus(), degree + 1) << seed;
      // Far below the 170 that 256 bits can tell from infinity.
      for (const auto& cuff : pants.cuffs) EXPECT_LT(cuff.length.upper, 80) << degree << ' ' << seed;
    }
  }
}

TEST(Pants, ThinSurfaces) {
  const FenchelNielsen given = coordinates("0-0 0-1 1-1", {Rational(1, 1'000'000), 2, Rational(1, 1000)},
                                           {Rational(1, 4'000'000), 1, Rational(-1, 4000)});
  const Surface surface = fenchel_nielsen_surface(given);
  EXPECT_EQ(problem(pants_decomposition(surface), given), "");
  const PantsDecomposition pants = pants_decomposition(surface, found());
  EXPECT_NEAR(pants.cuffs[0].length.lower, 1e-6, 1e-18);
  EXPECT_NEAR(pants.cuffs[0].twist.lower, 2.5e-7, 1e-18);
  EXPECT_NEAR(pants.cuffs[1].length.lower, 1e-3, 1e-15);
  EXPECT_NEAR(pants.cuffs[1].twist.lower, -2.5e-4, 1e-15);
}

TEST(Pants, GivenCurvesAreTheFirstCuffs) {
  const FenchelNielsen given = coordinates("0-1 0-1 0-1", {7, 5, 6}, {1, 2, 3});
  const Surface surface = fenchel_nielsen_surface(given);
  const PantsDecomposition own = pants_decomposition(surface);
  PantsOptions options;
  for (const auto& cuff : own.cuffs) options.curves.push_back(cuff.curve);
  const PantsDecomposition pants = pants_decomposition(surface, options);
  EXPECT_FALSE(pants.own);
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_EQ(pants.cuffs[e].length, own.cuffs[e].length);
    EXPECT_NEAR(std::abs(pants.cuffs[e].twist.lower), std::abs(own.cuffs[e].twist.lower), 1e-12);
  }
  options.curves.resize(1);
  EXPECT_EQ(pants_decomposition(surface, options).cuffs[0].length, own.cuffs[0].length);
}

/// The message for curves that are refused; empty if they are not.
std::string refusal(const Surface& surface, std::vector<Word> curves) {
  try {
    require_disjoint_curves(surface, curves);
  } catch (const CurveError& error) {
    return error.what();
  }
  return "";
}

TEST(Pants, CurvesThatAreRefused) {
  // Sides 0 and 2 are the sides that cuff 1 crosses; 3 and 5 the others inside of the first pants.
  const Surface surface = fenchel_nielsen_surface(coordinates("0-1 0-1 0-1", {2, 2, 2}, {0, 0, 0}));
  const auto pants = pants_decomposition(surface).pants[0];
  const auto joined = [](Word first, const Word& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  };
  EXPECT_EQ(refusal(surface, {pants[0], pants[1], pants[2]}), "");
  EXPECT_EQ(refusal(surface, {pants[0], {}}), "curve 1: a path without letters is trivial");
  EXPECT_EQ(refusal(surface, {word_of_letters({0, 99})}), "curve 0: letter 1 is side 99, the surface has 14 sides");
  EXPECT_EQ(refusal(surface, {word_of_letters({0, 8})}),
            "curve 0: letter 1 is side 8, no side of tile 0, where the letters before it lead");
  EXPECT_EQ(refusal(surface, {word_of_letters({6})}),
            "curve 0: letter 0 is side 6, no side of tile 1, where the path ends");
  EXPECT_EQ(refusal(surface, {word_of_letters({0, 2})}), "curve 0: null-homotopic");
  EXPECT_EQ(refusal(surface, {joined(pants[1], pants[1])}), "curve 0: power 2 of another closed curve");
  EXPECT_EQ(refusal(surface, {joined(joined(pants[0], pants[0]), pants[0])}),
            "curve 0: power 3 of another closed curve");
  EXPECT_EQ(refusal(surface, {pants[0], reversed(surface, pants[0])}),
            "curve 1: homotopic to curve 0, or to a power of it");
  // A figure eight.
  EXPECT_EQ(refusal(surface, {joined(pants[0], reversed(surface, pants[1]))}),
            "curve 0: not simple: its geodesic crosses itself");
  // Into the other pants through one cuff, and back through another one.
  const Word across = joined({SideId(6)}, {surface.partner(SideId(1))});
  EXPECT_EQ(refusal(surface, {across}), "");
  EXPECT_EQ(refusal(surface, {pants[2], across, pants[1]}), "curve 2: its geodesic crosses that of curve 1");
}

TEST(Pants, FileSaysTheSame) {
  const PantsDecomposition pants = pants_decomposition(random_octagon(5));
  const certify::PantsDocument& document = pants.document;
  ASSERT_THAT(document.cuffs, SizeIs(pants.cuffs.size()));
  ASSERT_THAT(document.pants, SizeIs(pants.pants.size()));
  for (std::size_t e = 0; e < pants.cuffs.size(); ++e) {
    const auto& [first, second] = pants.graph.edges()[e];
    const certify::PantsDocument::Cuff& cuff = document.cuffs[e];
    EXPECT_EQ(cuff.ends[0], (certify::PantsDocument::End{first.pants, first.cuff}));
    EXPECT_EQ(cuff.ends[1], (certify::PantsDocument::End{second.pants, second.cuff}));
    EXPECT_EQ(cuff.length, pants.cuffs[e].length);
    EXPECT_EQ(cuff.twist, pants.cuffs[e].twist);
  }
  EXPECT_EQ(certify::check(document).verdict, certify::Verdict::verified);
}

TEST(Pants, SurfacesAreMadeFromFiles) {
  const PantsDecomposition pants = pants_decomposition(random_octagon(5));
  std::ostringstream file;
  certify::write_file(pants.document, file);
  const FenchelNielsen read = resolve(parse_fenchel_nielsen(file.str()));
  EXPECT_EQ(read.graph.edges(), pants.graph.edges());
  EXPECT_EQ(problem(pants_decomposition(fenchel_nielsen_surface(read)), pants.coordinates()), "");

  certify::PantsDocument document = pants.document;
  std::swap(document.cuffs[0], document.cuffs[1]);
  std::ostringstream other;
  certify::write_file(document, other);
  const auto reading = [&] { static_cast<void>(parse_fenchel_nielsen(other.str())); };
  EXPECT_THAT(reading, ::testing::ThrowsMessage<FenchelNielsenRequestError>(
                           HasSubstr("cuffs of a pair of pants are not in the order 0, 1, 2")));
  const auto part = [] { static_cast<void>(parse_fenchel_nielsen(R"({"format": "epsnet-pants"})")); };
  EXPECT_THAT(part, ::testing::ThrowsMessage<FenchelNielsenRequestError>(
                        ::testing::Eq("pants file: missing member \"version\"")));
}

TEST(Pants, GraphsAreWrittenAsTheyAreRead) {
  for (const PantsGraph& graph : {PantsGraph::ring(5), PantsGraph::tree(4), PantsGraph::random(6, 1)}) {
    EXPECT_EQ(PantsGraph::parse(graph_text(graph)).edges(), graph.edges());
  }
}

}  // namespace
}  // namespace epsnet::pants_test
