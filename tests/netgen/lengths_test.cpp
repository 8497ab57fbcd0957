#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <span>
#include <utility>
#include <vector>

#include "netgen/curves/curves.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

/// Derivatives of lengths.
namespace epsnet::lengths_test {
namespace {

double middle(certify::Interval x) { return (x.lower + x.upper) / 2; }

std::vector<Word> geodesics_up_to(const Surface& surface, const char* length) {
  std::vector<Word> result;
  for (const auto& geodesic : unproved::spectrum(surface, Length(length)).geodesics)
    result.push_back(word_of_letters(geodesic.word));
  return result;
}

/// The length of a closed geodesic of the surface itself.
double length_of(const Surface& surface, const Word& word) {
  const EnclosedNumber a = enclosed_isometry(surface, word, 120).a_re;
  return 2 * static_cast<double>(acosh(abs(Mp1024(a.lower))));
}

/// Coordinates and the surface of them.
struct Made {
  EnclosedCoordinates coordinates;
  Surface surface;
};

Made made(const PantsGraph& graph, std::uint64_t seed) {
  const Surface surface = fenchel_nielsen_surface(random_coordinates(graph, seed));
  return {enclosed_coordinates(pants_decomposition(surface)), surface};
}

TEST(LengthDerivatives, TheLengthIsThatOfTheSurface) {
  for (const char* graph : {"0-1 0-1 0-1", "0-0 0-1 1-1", "0-1 0-2 0-3 1-2 1-3 2-3"}) {
    for (std::uint64_t seed = 1; seed < 3; ++seed) {
      const auto [coordinates, surface] = made(PantsGraph::parse(graph), seed);
      for (const Word& word : geodesics_up_to(surface, "6"))
        EXPECT_NEAR(middle(length_derivatives(coordinates, word).length), length_of(surface, word), 1e-12);
    }
  }
}

TEST(LengthDerivatives, DerivativesAreDifferenceQuotients) {
  constexpr double kStep = 1e-6;
  std::size_t compared = 0;
  for (const auto& [graph, length] :
       {std::pair("0-1 0-1 0-1", "5"), std::pair("0-0 0-1 1-1", "5"), std::pair("0-1 0-2 0-3 1-2 1-3 2-3", "4")}) {
    const Made surface = made(PantsGraph::parse(graph), 7);
    const EnclosedCoordinates& coordinates = surface.coordinates;
    for (const Word& word : geodesics_up_to(surface.surface, length)) {
      const LengthDerivatives at = length_derivatives(coordinates, word, true);
      const LengthDerivatives first_order = length_derivatives(coordinates, word);
      for (std::size_t i = 0; i < at.gradient.size(); ++i) {
        const auto moved = [&](double by) {
          EnclosedCoordinates result = coordinates;
          result.values[i] = {result.values[i].lower + by, result.values[i].upper + by};
          return length_derivatives(result, word);
        };
        const LengthDerivatives more = moved(kStep);
        const LengthDerivatives less = moved(-kStep);
        EXPECT_NEAR(middle(at.gradient[i]), middle(first_order.gradient[i]), 1e-12);
        EXPECT_NEAR((middle(more.length) - middle(less.length)) / (2 * kStep), middle(at.gradient[i]), 1e-7);
        for (std::size_t j = 0; j < at.gradient.size(); ++j) {
          EXPECT_NEAR((middle(more.gradient[j]) - middle(less.gradient[j])) / (2 * kStep), middle(at.second[i][j]),
                      1e-6);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 1000U);
}

// The surface is made anew of other coordinates: what moves is what the coordinates mean.
TEST(LengthDerivatives, AreThoseOfSurfacesThatAreMadeOfOtherCoordinates) {
  const FenchelNielsen base = random_coordinates(PantsGraph::parse("0-1 0-1 0-1"), 3);
  const Surface surface = fenchel_nielsen_surface(base);
  const EnclosedCoordinates coordinates = enclosed_coordinates(pants_decomposition(surface));
  const Rational step(1, 100000);
  for (const Word& word : geodesics_up_to(surface, "5")) {
    const LengthDerivatives at = length_derivatives(coordinates, word);
    for (std::size_t i = 0; i < 6; ++i) {
      const auto moved = [&](const Rational& by) {
        FenchelNielsen result = base;
        (i < 3 ? result.lengths[i] : result.twists[i - 3]) += by;
        return length_of(fenchel_nielsen_surface(result), word);
      };
      EXPECT_NEAR((moved(step) - moved(-step)) / 2e-5, middle(at.gradient[i]), 1e-6);
    }
  }
}

TEST(LengthDerivatives, TwistsAgreeWithWolpertsFormula) {
  const auto [coordinates, surface] = made(PantsGraph::parse("0-0 0-1 1-1"), 4);
  const CurveTopology topology(surface);
  const PantsDecomposition pants = pants_decomposition(surface);
  for (const Word& word : geodesics_up_to(surface, "6")) {
    const LengthDerivatives at = length_derivatives(coordinates, word);
    for (std::size_t e = 0; e < 3; ++e) {
      const certify::Interval by_cosines =
          topology.twist_derivative(topology.curve(word), topology.curve(pants.cuffs[e].curve));
      EXPECT_NEAR(middle(by_cosines), middle(at.gradient[3 + e]), 1e-12);
    }
  }
}

TEST(LengthDerivatives, ATwistOfHalfTheLengthIsUnderstoodAsTheSurfaceIsGlued) {
  FenchelNielsen half = random_coordinates(PantsGraph::parse("0-1 0-1 0-1"), 3);
  half.lengths = {2, 2, 2};
  half.twists = {1, 1, 1};
  const Surface surface = fenchel_nielsen_surface(half);
  const EnclosedCoordinates coordinates = enclosed_coordinates(pants_decomposition(surface));
  for (const Word& word : geodesics_up_to(surface, "5"))
    EXPECT_NEAR(middle(length_derivatives(coordinates, word).length), length_of(surface, word), 1e-12);
}

TEST(LengthDerivatives, OverABoxErrorsOfALongPathAreAdded) {
  constexpr int kTimes = 8;
  auto [coordinates, surface] = made(PantsGraph::parse("0-1 0-1 0-1"), 3);
  for (certify::Interval& x : coordinates.values) x = {x.lower - 1e-9, x.upper + 1e-9};
  for (const Word& word : geodesics_up_to(surface, "5")) {
    Word power;
    for (int i = 0; i < kTimes; ++i) power.insert(power.end(), word.begin(), word.end());
    const LengthDerivatives once = length_derivatives(coordinates, word, true);
    const LengthDerivatives around = length_derivatives(coordinates, power, true);
    for (std::size_t i = 0; i < coordinates.values.size(); ++i) {
      for (std::size_t j = 0; j < coordinates.values.size(); ++j) {
        const certify::Interval& x = once.second[i][j];
        const certify::Interval& y = around.second[i][j];
        EXPECT_LT(y.upper - y.lower, 10);
        EXPECT_LE(std::max(kTimes * x.lower, y.lower), std::min(kTimes * x.upper, y.upper));
      }
    }
  }
}

// The surface is cut along a cuff and glued anew: lengths of what crosses it change, of any tiles.
TEST(LengthDerivatives, OnOtherTilesTheyAreThoseOfTheSurface) {
  for (const auto& [surface, length] : {std::pair(random_octagon(5), "3.5"), std::pair(named_surface("bolza"), "3.5"),
                                        std::pair(named_surface("klein"), "4")}) {
    const PantsDecomposition pants = pants_decomposition(surface);
    EXPECT_FALSE(pants.own);
    const std::size_t cuffs = pants.cuffs.size();
    const CurveTopology topology(surface);
    std::vector<Word> words = geodesics_up_to(surface, length);
    ASSERT_GE(words.size(), 4U);
    words.resize(4);
    for (const Word& word : words) {
      const LengthDerivatives at = length_derivatives(surface, pants, word, true);
      EXPECT_NEAR(middle(at.length), length_of(surface, word), 1e-9);
      ASSERT_EQ(at.gradient.size(), 2 * cuffs);
      for (std::size_t e = 0; e < cuffs; ++e) {
        const certify::Interval by_cosines =
            topology.twist_derivative(topology.curve(word), topology.curve(pants.cuffs[e].curve));
        EXPECT_NEAR(middle(by_cosines), middle(at.gradient[cuffs + e]), 1e-9);
      }
    }
    // Of a cuff: 1 for its own length, 0 for all others and all twists.
    for (std::size_t e = 0; e < cuffs; ++e) {
      const LengthDerivatives at = length_derivatives(surface, pants, pants.cuffs[e].curve);
      for (std::size_t i = 0; i < 2 * cuffs; ++i) EXPECT_NEAR(middle(at.gradient[i]), i == e ? 1 : 0, 1e-9);
    }
  }
}

// The surface that its own coordinates make is it again, but for rounding. Geodesics correspond by their lengths.
TEST(LengthDerivatives, OnOtherTilesTheyAreThoseOfTheHeptagonsOfTheirCoordinates) {
  for (const auto& [surface, length] : {std::pair(random_octagon(5), "4"), std::pair(named_surface("bolza"), "3.5")}) {
    const PantsDecomposition pants = pants_decomposition(surface);
    const Surface heptagons = fenchel_nielsen_surface(pants.coordinates());
    const EnclosedCoordinates coordinates = enclosed_coordinates(pants_decomposition(heptagons));
    std::vector<LengthDerivatives> there;
    for (const Word& word : geodesics_up_to(heptagons, length)) there.push_back(length_derivatives(coordinates, word));
    for (const Word& word : geodesics_up_to(surface, length)) {
      const LengthDerivatives at = length_derivatives(surface, pants, word);
      const auto is_the_same = [&](const LengthDerivatives& other) {
        double difference = std::abs(middle(other.length) - middle(at.length));
        for (std::size_t i = 0; i < at.gradient.size(); ++i)
          difference = std::max(difference, std::abs(middle(other.gradient[i]) - middle(at.gradient[i])));
        return difference < 1e-9;
      };
      EXPECT_TRUE(std::any_of(there.begin(), there.end(), is_the_same)) << middle(at.length);
    }
  }
}

TEST(LengthDerivatives, OfPathsThatAreNotClosedAreErrors) {
  const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::parse("0-1 0-1 0-1"), 3));
  const PantsDecomposition pants = pants_decomposition(surface);
  EXPECT_THROW((void)length_derivatives(surface, pants, {}), SurfaceError);
  EXPECT_THROW((void)length_derivatives(surface, pants, Word{SideId(6)}), SurfaceError);
  EXPECT_THROW((void)length_derivatives(surface, pants, Word{SideId(6), SideId(99)}), SurfaceError);
}

TEST(LengthDerivatives, CoordinatesOfOtherTilesAreRefused) {
  EXPECT_THROW((void)enclosed_coordinates(pants_decomposition(random_octagon(5))), SurfaceError);
}

}  // namespace
}  // namespace epsnet::lengths_test
