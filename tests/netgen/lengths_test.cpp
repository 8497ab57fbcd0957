#include "netgen/curves/lengths.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <span>
#include <vector>

#include "netgen/curves/closed_curves.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

/// Derivatives of lengths, and the greatest systoles.
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
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
      const auto [coordinates, surface] = made(PantsGraph::parse(graph), seed);
      for (const Word& word : geodesics_up_to(surface, "6"))
        EXPECT_NEAR(middle(length_derivatives(coordinates, word).length), length_of(surface, word), 1e-12);
    }
  }
}

TEST(LengthDerivatives, DerivativesAreDifferenceQuotients) {
  constexpr double kStep = 1e-6;
  std::size_t compared = 0;
  for (const char* graph : {"0-1 0-1 0-1", "0-0 0-1 1-1", "0-1 0-2 0-3 1-2 1-3 2-3"}) {
    const Made surface = made(PantsGraph::parse(graph), 7);
    const EnclosedCoordinates& coordinates = surface.coordinates;
    for (const Word& word : geodesics_up_to(surface.surface, "5")) {
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

TEST(LengthDerivatives, OtherTilesAreRefused) {
  EXPECT_THROW((void)enclosed_coordinates(pants_decomposition(random_octagon(5))), SurfaceError);
}

Surface of_coordinates(const EnclosedCoordinates& coordinates) {
  FenchelNielsen made{coordinates.graph, {}, {}};
  const std::size_t edges = coordinates.values.size() / 2;
  for (std::size_t e = 0; e < edges; ++e) {
    made.lengths.emplace_back(middle(coordinates.values[e]));
    made.twists.emplace_back(middle(coordinates.values[edges + e]));
  }
  return fenchel_nielsen_surface(made);
}

using Gradients = std::vector<std::vector<certify::Interval>>;

/// e_1, …, e_d and −share · Σ e_j, each time `factor`, and so wide.
Gradients simplex(std::size_t dimension, double share = 0.5, double factor = 1, double width = 0) {
  Gradients result(dimension + 1, std::vector<certify::Interval>(dimension, {-width, width}));
  for (std::size_t i = 0; i < dimension; ++i) {
    result[i][i] = {factor - width, factor + width};
    result[dimension][i] = {-share * factor - width, -share * factor + width};
  }
  return result;
}

// −u_i ≤ m for all i and share · Σ u_j ≤ m, where some |u_j| is 1: u = (1, −m, …, −m) and share (1 − (d − 1)m) = m.
TEST(SlopeOfLeast, OfASimplexIsExact) {
  for (std::size_t dimension = 1; dimension <= 6; ++dimension) {
    for (const double share : {0.1, 0.25}) {
      for (const double factor : {1.0, 3.0, 0.01}) {
        const double greatest = factor * share / (1 + share * static_cast<double>(dimension - 1));
        const auto slope = slope_of_least(simplex(dimension, share, factor));
        ASSERT_TRUE(slope);
        EXPECT_LE(*slope, greatest * (1 + 1e-15)) << dimension << ' ' << share << ' ' << factor;
        EXPECT_GE(*slope, greatest * (1 - 1e-9)) << dimension << ' ' << share << ' ' << factor;
      }
    }
  }
}

TEST(SlopeOfLeast, HoldsForAllGradientsInTheIntervals) {
  // In one dimension the gradients ±(1 − w) are the flattest ones.
  for (const double width : {1e-3, 0.1}) {
    const auto slope = slope_of_least(simplex(1, 1, 1, width));
    ASSERT_TRUE(slope);
    EXPECT_LE(*slope, 1 - width);
  }
  // The last gradient may be on the side of the others: as it is, in one coordinate alone, and a hundredth of it all.
  EXPECT_FALSE(slope_of_least(simplex(2, 0.05, 1, 0.1)));
  Gradients in_one_coordinate = simplex(2, 0.05);
  in_one_coordinate[2][0] = {-0.15, 0.05};
  EXPECT_FALSE(slope_of_least(in_one_coordinate));
  EXPECT_FALSE(slope_of_least(simplex(2, 0.05, 0.01, 0.001)));
  EXPECT_TRUE(slope_of_least(simplex(2, 0.05, 0.01, 0.00001)));
  // Gradients that may all be on one side.
  EXPECT_FALSE(slope_of_least(simplex(1, 1, 1, 1)));
  EXPECT_FALSE(slope_of_least(simplex(3, 1, 1, 0.5)));
}

TEST(SlopeOfLeast, IsNothingUnlessZeroIsInside) {
  EXPECT_FALSE(slope_of_least({}));
  Gradients open = simplex(3);
  open.pop_back();
  EXPECT_FALSE(slope_of_least(open));
  Gradients flat = simplex(3);
  for (auto& gradient : flat) gradient[2] = {0, 0};
  EXPECT_FALSE(slope_of_least(flat));
  Gradients on_one_side = simplex(2);
  on_one_side[2] = {{-1, -1}, {1, 1}};
  EXPECT_FALSE(slope_of_least(on_one_side));
}

RC_GTEST_PROP(SlopeOfLeastProperty, SomeGradientFallsSoFastInAnyDirection, ()) {
  const auto dimension = *rc::gen::inRange<std::size_t>(1, 6);
  const auto number = [] { return *rc::gen::inRange(-1000, 1000) / 500.0; };
  Gradients gradients(dimension + *rc::gen::inRange<std::size_t>(1, 6));
  for (auto& gradient : gradients) {
    for (std::size_t j = 0; j < dimension; ++j) {
      const double x = number();
      gradient.push_back({x, x});
    }
  }
  const auto slope = slope_of_least(gradients);
  if (!slope) return;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> u;
    double size = 0;
    for (std::size_t j = 0; j < dimension; ++j) size = std::max(size, std::abs(u.emplace_back(number())));
    double steepest = -HUGE_VAL;
    for (const auto& gradient : gradients) {
      double product = 0;
      for (std::size_t j = 0; j < dimension; ++j) product += gradient[j].lower * u[j];
      steepest = std::max(steepest, -product);
    }
    RC_ASSERT(steepest >= *slope * size - 1e-12);
  }
}

// P. Schmutz, Riemann surfaces with shortest geodesic of maximal length (1993): in genus 2 it is the surface of Bolza,
// with 12 systoles of length 2 arcosh(1 + √2).
TEST(MaximalSystole, AllStartsInGenus2EndAtBolzasSurface) {
  for (std::int32_t seed = 1; seed <= 10; ++seed) {
    const SystoleMaximum found = maximize_systole(random_octagon(seed));
    EXPECT_NEAR(middle(found.systole), 2 * std::acosh(1 + std::sqrt(2.0)), 1e-12) << seed;
    EXPECT_EQ(found.systoles.size(), 12U) << seed;
    ASSERT_TRUE(found.proof) << seed;
    EXPECT_LT(found.proof->distance, 1e-11);
    EXPECT_GT(found.proof->slope, 0.01);
  }
}

TEST(MaximalSystole, KleinsQuarticIsFoundFromASurfaceNearIt) {
  const PantsDecomposition pants = pants_decomposition(named_surface("klein"));
  FenchelNielsen coordinates = pants.coordinates();
  for (std::size_t e = 0; e < coordinates.lengths.size(); ++e) {
    coordinates.lengths[e] += Rational(static_cast<int>(e % 3) - 1, 50);
    coordinates.twists[e] += Rational(static_cast<int>(e % 2), 40);
  }
  const SystoleMaximum found = maximize_systole(fenchel_nielsen_surface(coordinates));
  EXPECT_NEAR(middle(found.systole), 3.93594624883, 1e-10);
  EXPECT_EQ(found.systoles.size(), 21U);
  EXPECT_TRUE(found.proof);
}

/// The proof says that the systole is less wherever a coordinate is changed by the distance.
TEST(MaximalSystole, TheSystoleIsLessAroundAMaximum) {
  const SystoleMaximum found = maximize_systole(random_octagon(5));
  ASSERT_TRUE(found.proof);
  constexpr double kStep = 1e-3;
  for (std::size_t i = 0; i < found.coordinates.values.size(); ++i) {
    for (const double by : {-kStep, kStep}) {
      EnclosedCoordinates moved = found.coordinates;
      moved.values[i] = {moved.values[i].lower + by, moved.values[i].upper + by};
      const double there = middle(unproved::systole(of_coordinates(moved)).geodesics[0].length);
      EXPECT_LT(there, found.systole.lower - 0.9 * found.proof->slope * kStep) << i;
    }
  }
}

TEST(MaximalSystole, NothingIsProvedOfFewerOrOtherCurves) {
  const SystoleMaximum found = maximize_systole(random_octagon(5));
  const std::vector<Word>& all = found.systoles;
  ASSERT_EQ(all.size(), 12U);
  // The curves that are left do not hold the surface in all directions, or span too few.
  for (std::size_t count = 0; count <= 7; ++count)
    EXPECT_FALSE(near_maximum(found.coordinates, found.systole, std::span(all).first(count))) << count;
  // A systole that is less than that of the surface leaves room for a longer one, farther away; and where that is far,
  // second derivatives count.
  for (const double less : {1e-12, 1e-11}) {
    const auto farther = near_maximum(found.coordinates, {found.systole.lower - less, found.systole.upper}, all);
    ASSERT_TRUE(farther) << less;
    EXPECT_GT(farther->distance * farther->slope, less);
  }
  for (const double less : {1e-6, 1e-1})
    EXPECT_FALSE(near_maximum(found.coordinates, {found.systole.lower - less, found.systole.upper}, all)) << less;
  // Beside the maximum some curves are longer than the systole.
  EnclosedCoordinates beside = found.coordinates;
  beside.values[0] = {beside.values[0].lower + 0.1, beside.values[0].upper + 0.1};
  const certify::Interval systole = unproved::systole(of_coordinates(beside)).geodesics[0].length;
  EXPECT_FALSE(near_maximum(beside, systole, all));
}

TEST(MaximalSystole, ItStopsWhenItIsTold) {
  const SystoleMaximum found = maximize_systole(random_octagon(5), {.steps = 2});
  EXPECT_EQ(found.steps, 2U);
  EXPECT_FALSE(found.proof);
}

}  // namespace
}  // namespace epsnet::lengths_test
