#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <span>
#include <string>
#include <vector>

#include "netgen/curves/curves.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/group.h"
#include "netgen/surfaces/surfaces.h"

/// The greatest systoles: the climb, what is proved near its end, and local maxima at exact surfaces.
namespace epsnet::maximal_systoles_test {
namespace {

using certify::Interval;

std::vector<Interval> points(const std::vector<double>& numbers) {
  std::vector<Interval> result;
  for (const double x : numbers) result.push_back({x, x});
  return result;
}

TEST(Balance, IsASumWithPositiveWeightsThatIs0) {
  // A triangle around 0, with barycentric coordinates 1/2, 1/4, 1/4.
  const std::vector<std::vector<Interval>> around{points({1, 0}), points({-1, 1}), points({-1, -1})};
  const auto weights = balance(around);
  ASSERT_TRUE(weights);
  EXPECT_NEAR((*weights)[0], 0.5, 1e-9);
  EXPECT_NEAR((*weights)[1], 0.25, 1e-9);
  EXPECT_NEAR((*weights)[2], 0.25, 1e-9);
  // 0 on its side, and outside of it.
  const std::vector<std::vector<Interval>> on_a_side{points({1, 0}), points({-1, 0}), points({0, 1})};
  EXPECT_FALSE(balance(on_a_side));
  const std::vector<std::vector<Interval>> outside{points({1, 0}), points({2, 1}), points({2, -1})};
  EXPECT_FALSE(balance(outside));
}

TEST(Balance, IndependentOnesAreABasisOfTheSpan) {
  const std::vector<std::vector<Interval>> rows{points({1, 2, 3}), points({2, 4, 6}), points({0, 1, 0}),
                                                points({1, 3, 3})};
  const std::vector<std::size_t> basis = independent(rows);
  ASSERT_EQ(basis.size(), 2);
  // Of all pairs that of the first two is dependent.
  EXPECT_GT(basis[0] + basis[1], 1U);
}

TEST(LocalMaximum, OfNamedSurfacesIsProved) {
  struct Known {
    const char* name;
    std::size_t systoles;
    double systole;
  };
  for (const auto& [name, systoles, systole] : std::vector<Known>{{"bolza", 12, 3.057141838962},
                                                                  {"klein", 21, 3.935946248830},
                                                                  {"R3.3", 24, 3.983304782099},
                                                                  {"R4.1", 36, 4.624499325347}}) {
    const Surface surface = named_surface(name);
    const certify::GeodesicsDocument document = local_maximum(surface).document;
    EXPECT_EQ(document.claim, certify::GeodesicsDocument::Claim::local_maximum);
    EXPECT_EQ(document.clusters[0].count, systoles) << name;
    EXPECT_NEAR(document.geodesics[0].length.lower, systole, 1e-11) << name;
    EXPECT_EQ(document.basis.size(), 6 * surface.genus() - 6) << name;
    // The isometries of these surfaces exchange all of their systoles.
    EXPECT_EQ(document.weights, std::vector<std::uint32_t>(systoles - document.basis.size(), 1)) << name;
  }
}

std::string what_fails(const Surface& surface) {
  try {
    (void)unproved::local_maximum(surface);
  } catch (const NotMaximalError& error) {
    return error.what();
  }
  return "";
}

TEST(LocalMaximum, WhatFailsIsSaid) {
  const std::string not_proved = "not proved to be a local maximum of the systole: ";
  EXPECT_EQ(what_fails(named_surface("fermat-quartic")),
            not_proved + "the gradients of the 16 shortest closed geodesics span 6 of 6g - 6 = 12 dimensions");
  EXPECT_EQ(what_fails(named_surface("R2.2")), not_proved + "6 shortest closed geodesics, fewer than 6g - 5 = 7");
  EXPECT_EQ(what_fails(random_octagon(5)), not_proved + "1 shortest closed geodesic, fewer than 6g - 5 = 7");
}

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
}  // namespace epsnet::maximal_systoles_test
