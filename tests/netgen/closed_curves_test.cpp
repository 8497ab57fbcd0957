#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <rapidcheck/gtest.h>
#include <vector>

#include "certify/claims/curves/fields.h"
#include "netgen/curves/curves.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::closed_curves_test {
namespace {

std::vector<ClosedCurve> curves_up_to(const Surface& surface, const CurveTopology& topology, const char* length) {
  std::vector<ClosedCurve> result;
  for (const auto& geodesic : unproved::spectrum(surface, Length(length)).geodesics) {
    result.push_back(topology.curve(word_of_letters(geodesic.word)));
  }
  return result;
}

Surface surface_of(std::uint32_t genus, std::uint64_t seed) {
  return fenchel_nielsen_surface(random_coordinates(PantsGraph::random(genus, seed), seed));
}

TEST(CurveTopology, TheHomologyBasisIsSymplectic) {
  for (const Surface& surface : {random_octagon(5), Surface::regular(4), named_surface("klein"), surface_of(5, 2)}) {
    const CurveTopology topology(surface);
    std::vector<ClosedCurve> basis;
    for (const Word& word : topology.homology_basis()) basis.push_back(topology.curve(word));
    ASSERT_EQ(basis.size(), 2 * surface.genus());
    for (std::size_t i = 0; i < basis.size(); ++i) {
      for (std::size_t j = 0; j < basis.size(); ++j) {
        const int expected = i % 2 == 0 && j == i + 1 ? 1 : j % 2 == 0 && i == j + 1 ? -1 : 0;
        EXPECT_EQ(topology.intersections(basis[i], basis[j]).algebraic, expected) << i << ' ' << j;
        EXPECT_EQ(basis[i].homology[j], i == j ? 1 : 0);
      }
    }
  }
}

TEST(CurveTopology, SimpleGeodesicsOfASpectrumHaveNoSelfIntersections) {
  const Surface surface = random_octagon(5);
  const CurveTopology topology(surface);
  const auto document = unproved::spectrum(surface, Length("7"));
  std::size_t simple = 0;
  for (const auto& geodesic : document.geodesics) {
    const ClosedCurve curve = topology.curve(word_of_letters(geodesic.word));
    EXPECT_EQ(curve.power, 1U);
    EXPECT_EQ(curve.is_simple(), geodesic.simple);
    simple += geodesic.simple ? 1 : 0;
  }
  EXPECT_GT(simple, 0U);
  EXPECT_LT(simple, document.geodesics.size());
}

TEST(CurveTopology, PowersHaveTheirIntersections) {
  const Surface surface = random_octagon(5);
  const CurveTopology topology(surface);
  const std::vector<ClosedCurve> curves = curves_up_to(surface, topology, "6");
  const auto power = [&](const ClosedCurve& curve, int k) {
    const Word once = topology.word(curve);
    Word word;
    for (int i = 0; i < std::abs(k); ++i) word.insert(word.end(), once.begin(), once.end());
    return topology.curve(k < 0 ? reversed(surface, word) : word);
  };
  for (const ClosedCurve& curve : curves) {
    const ClosedCurve cube = power(curve, 3);
    const ClosedCurve back = power(curve, -2);
    EXPECT_EQ(cube.root, curve.root);
    EXPECT_EQ(cube.power, 3U);
    EXPECT_EQ(cube.self_intersections, 9 * curve.self_intersections + 2);
    EXPECT_EQ(topology.same_geodesic(cube, back), -1);
    EXPECT_EQ(topology.intersections(cube, back).geometric, 12 * curve.self_intersections);
    EXPECT_EQ(topology.intersections(cube, back).algebraic, 0);
    const auto once = topology.intersections(curve, curves[0]);
    if (topology.same_geodesic(curve, curves[0]) != 0) continue;
    EXPECT_EQ(topology.intersections(back, curves[0]).geometric, 2 * once.geometric);
    EXPECT_EQ(topology.intersections(back, curves[0]).algebraic, -2 * once.algebraic);
  }
}

TEST(CurveTopology, AJoinOfThePantsGraphHasItsGenusOnTheLeft) {
  std::size_t separating = 0;
  for (const std::uint32_t genus : {2U, 3U, 5U}) {
    for (std::uint64_t seed = 1; seed < 12; ++seed) {
      const PantsGraph graph = PantsGraph::random(genus, seed);
      const Surface surface = fenchel_nielsen_surface(random_coordinates(graph, seed));
      const CurveTopology topology(surface);
      const PantsDecomposition pants = pants_decomposition(surface);
      ASSERT_TRUE(pants.own);
      for (std::size_t e = 0; e < pants.cuffs.size(); ++e) {
        const ClosedCurve cuff = topology.curve(pants.cuffs[e].curve);
        EXPECT_TRUE(cuff.is_simple());
        // What is reached from the pants on its left without crossing it.
        std::vector<bool> reached(2 * genus - 2);
        std::vector<std::uint32_t> to_go{pants.graph.edges()[e][0].pants};
        std::uint32_t count = 0;
        while (!to_go.empty()) {
          const std::uint32_t p = to_go.back();
          to_go.pop_back();
          if (reached[p]) continue;
          reached[p] = true;
          ++count;
          for (std::size_t f = 0; f < pants.cuffs.size(); ++f) {
            const auto& [first, second] = pants.graph.edges()[f];
            if (f == e) continue;
            if (first.pants == p) to_go.push_back(second.pants);
            if (second.pants == p) to_go.push_back(first.pants);
          }
        }
        EXPECT_EQ(cuff.is_separating(), !reached[pants.graph.edges()[e][1].pants]);
        if (!cuff.is_separating()) continue;
        ++separating;
        // Of n pairs of pants and one boundary: −n = 2 − 2h − 1.
        EXPECT_EQ(*cuff.genus_on_the_left, (count + 1) / 2);
      }
    }
  }
  EXPECT_GT(separating, 3U);
}

TEST(CurveTopology, AChainOfTwiceTheGenusFillsAndAShorterOneDoesNot) {
  const Surface surface = random_octagon(5);
  const CurveTopology topology(surface);
  std::vector<ClosedCurve> simple;
  for (const ClosedCurve& curve : curves_up_to(surface, topology, "7")) {
    if (curve.is_simple()) simple.push_back(curve);
  }
  std::size_t chains = 0;
  std::vector<ClosedCurve> chain;
  const std::function<void()> go_on = [&] {
    if (chain.size() == 4) {
      ++chains;
      EXPECT_TRUE(topology.fill(chain));
      EXPECT_FALSE(topology.fill(std::span(chain).first(3)));
      EXPECT_FALSE(topology.fill(std::span(chain).first(1)));
      return;
    }
    for (const ClosedCurve& next : simple) {
      bool fits = chains < 20;
      for (std::size_t k = 0; k < chain.size() && fits; ++k) {
        const std::uint64_t expected = k + 1 == chain.size() ? 1 : 0;
        fits =
            topology.same_geodesic(chain[k], next) == 0 && topology.intersections(chain[k], next).geometric == expected;
      }
      if (!fits) continue;
      chain.push_back(next);
      go_on();
      chain.pop_back();
    }
  };
  go_on();
  EXPECT_EQ(chains, 20U);
}

TEST(CurveTopology, ShortestGeodesicsOfBolzasSurfaceFill) {
  // Each passes through two of the six fixed points of the hyperelliptic involution, and four of the twelve through
  // each of these points. They meet nowhere else, so six pairs of them cross at each.
  const Surface bolza = Surface::regular(2);
  const CurveTopology topology(bolza);
  const std::vector<ClosedCurve> shortest = curves_up_to(bolza, topology, "3.1");
  ASSERT_EQ(shortest.size(), 12U);
  EXPECT_TRUE(topology.fill(shortest));
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_TRUE(shortest[i].is_simple());
    for (std::size_t j = 0; j < i; ++j) {
      const std::uint64_t number = topology.intersections(shortest[i], shortest[j]).geometric;
      EXPECT_LE(number, 1U);
      sum += number;
    }
  }
  EXPECT_EQ(sum, 36U);
}

/// The length of the closed geodesic of a word.
double length_of(const Surface& surface, const Word& word) {
  Isometry<Mp1024> value;
  for (const SideId s : word) value = surface.crossing_as<Mp1024>(s) * value;
  return static_cast<double>(displacement_length(value));
}

TEST(CurveTopology, TwistDerivativesAreDifferenceQuotients) {
  const Rational step(1, 1'000'000);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const FenchelNielsen coordinates = random_coordinates(PantsGraph::random(2, seed), seed);
    const Surface surface = fenchel_nielsen_surface(coordinates);
    const CurveTopology topology(surface);
    const PantsDecomposition pants = pants_decomposition(surface);
    for (std::size_t e = 0; e < 3; ++e) {
      FenchelNielsen left = coordinates;
      FenchelNielsen right = coordinates;
      left.twists[e] += step;
      right.twists[e] -= step;
      const Surface after = fenchel_nielsen_surface(left);
      const Surface before = fenchel_nielsen_surface(right);
      const ClosedCurve cuff = topology.curve(pants.cuffs[e].curve);
      for (const auto& geodesic : unproved::spectrum(surface, Length("6")).geodesics) {
        const Word word = word_of_letters(geodesic.word);
        const certify::Interval derivative = topology.twist_derivative(topology.curve(word), cuff);
        const double quotient = (length_of(after, word) - length_of(before, word)) / (2 * static_cast<double>(step));
        EXPECT_LT(derivative.upper - derivative.lower, 1e-13);
        EXPECT_NEAR(quotient, derivative.lower, 1e-6);
      }
    }
  }
}

TEST(CurveTopology, AnglesAreThoseOfTheGeodesics) {
  // Opposite sides' midpoints of the regular octagon are joined by geodesics through its centre, at multiples of 45°.
  const Surface bolza = Surface::regular(2);
  const CurveTopology topology(bolza);
  const ClosedCurve first = topology.curve({bolza.side_number(TileId(0), 0)});
  for (std::uint32_t k = 1; k < 8; ++k) {
    if (k == 4) continue;
    const ClosedCurve second = topology.curve({bolza.side_number(TileId(0), k)});
    const auto crossings = topology.crossings(first, second);
    ASSERT_EQ(crossings.size(), 1U);
    const double expected = std::remainder(k * std::numbers::pi / 4, 2 * std::numbers::pi);
    EXPECT_LE(crossings[0].angle.lower, expected + 1e-15);
    EXPECT_GE(crossings[0].angle.upper, expected - 1e-15);
    EXPECT_LT(crossings[0].angle.upper - crossings[0].angle.lower, 1e-13);
    EXPECT_EQ(topology.intersections(first, second).algebraic, k < 4 ? 1 : -1);
  }
}

TEST(CurveTopology, WordsThatAreNoClosedPathsAreRefused) {
  const Surface surface = random_octagon(5);
  const CurveTopology topology(surface);
  EXPECT_THROW((void)topology.curve({SideId(8)}), SurfaceError);
  EXPECT_TRUE(topology.curve({}).is_null_homotopic());
  EXPECT_TRUE(topology.curve({SideId(0), surface.partner(SideId(0))}).is_null_homotopic());
  EXPECT_THROW((void)topology.twist_derivative(topology.curve({SideId(0)}), topology.curve({})), SurfaceError);
}

TEST(Curves, TheDocumentHasTheGivenCurvesAndABasis) {
  const Surface surface = surface_of(3, 4);
  const auto document = unproved::spectrum(surface, Length("4"));
  std::vector<Word> words;
  for (const auto& geodesic : document.geodesics) words.push_back(word_of_letters(geodesic.word));
  ASSERT_GE(words.size(), 3U);
  words.push_back(words[0]);
  words.back().insert(words.back().end(), words[0].begin(), words[0].end());
  const certify::CurvesDocument curves = unproved::curves(surface, words);
  ASSERT_EQ(curves.curves.size(), words.size() + 6);
  ASSERT_EQ(curves.basis.size(), 6U);
  EXPECT_EQ(curves.basis.front(), words.size());
  EXPECT_EQ(curves.pairs.size(), curves.curves.size() * (curves.curves.size() - 1) / 2);
  EXPECT_EQ(curves.curves[words.size() - 1].power, 2U);
  EXPECT_FALSE(structure_problem(curves).has_value());
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    EXPECT_LE(curves.curves[i].length.lower, document.geodesics[i].length.upper);
    EXPECT_GE(curves.curves[i].length.upper, document.geodesics[i].length.lower);
  }
  const std::vector<Word> trivial{words[0], {words[0][0], surface.partner(words[0][0])}};
  try {
    (void)unproved::curves(surface, trivial);
    FAIL();
  } catch (const CurveError& error) {
    EXPECT_STREQ(error.what(), "curve 1: null-homotopic");
  }
}

}  // namespace
}  // namespace epsnet::closed_curves_test
