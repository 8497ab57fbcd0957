#include "netgen/curves/maximal_systole.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "netgen/geodesics/geodesics.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::maximal_systole_test {
namespace {

double middle(certify::Interval x) { return (x.lower + x.upper) / 2; }

Surface of_coordinates(const EnclosedCoordinates& coordinates) {
  FenchelNielsen made{coordinates.graph, {}, {}};
  const std::size_t edges = coordinates.values.size() / 2;
  for (std::size_t e = 0; e < edges; ++e) {
    made.lengths.emplace_back(middle(coordinates.values[e]));
    made.twists.emplace_back(middle(coordinates.values[edges + e]));
  }
  return fenchel_nielsen_surface(made);
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
  // A systole that is less than that of the surface leaves room for a longer one.
  EXPECT_FALSE(near_maximum(found.coordinates, {found.systole.lower - 0.1, found.systole.upper}, all));
  // Beside the maximum some curves are longer than the systole.
  EnclosedCoordinates beside = found.coordinates;
  beside.values[0] = {beside.values[0].lower + 0.1, beside.values[0].upper + 0.1};
  const certify::Interval systole = unproved::systole(of_coordinates(beside)).geodesics[0].length;
  EXPECT_FALSE(near_maximum(beside, systole, all));
}

TEST(MaximalSystole, ItStopsWhenItIsTold) {
  const SystoleMaximum found = maximize_systole(random_octagon(5), {.steps = 2});
  EXPECT_LE(found.steps, 4U);
  EXPECT_FALSE(found.proof);
}

}  // namespace
}  // namespace epsnet::maximal_systole_test
