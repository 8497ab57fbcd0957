#include "netgen/curves/local_maximum.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "netgen/curves/balance.h"
#include "netgen/surfaces/surfaces.h"

/// Local maxima of the systole at exact surfaces, and what is said where there is none.
namespace epsnet::local_maximum_test {
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

}  // namespace
}  // namespace epsnet::local_maximum_test
