#include "netgen/eigenvalues/eigenfunctions.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <vector>

#include "certify/claims/eigenvalues/local_functions.h"

namespace epsnet::eigenfunctions_test {
namespace {

using Point = std::complex<double>;

double distance(const Point& z, const Point& w) { return 2 * std::atanh(std::abs((z - w) / (1.0 - std::conj(w) * z))); }

/// The points within ε + R of 0 of a set around it, no two of which are closer than ε, while few places are left.
std::vector<Point> random_net(std::mt19937& random, double epsilon, double radius) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double far = 2 * epsilon + radius;
  std::vector<Point> points{0};
  for (int failures = 0; failures < 2000;) {
    const double r = std::acosh(1 + uniform(random) * (std::cosh(far) - 1));
    const Point z = std::polar(std::tanh(r / 2), 2 * std::numbers::pi * uniform(random));
    if (std::any_of(points.begin(), points.end(), [&](const Point& w) { return distance(z, w) < epsilon; })) {
      ++failures;
    } else {
      points.push_back(z);
    }
  }
  std::erase_if(points, [&](const Point& z) { return distance(z, 0) > epsilon + radius; });
  return points;
}

TEST(PartitionSums, AreAboutWhatTheCheckerProves) {
  std::mt19937 random(1);
  for (const double epsilon : {0.05, 0.2, 0.6, 1.0}) {
    double sum = 0;
    double proved = 0;
    constexpr int kNets = 20;
    for (int i = 0; i < kNets; ++i) {
      const double radius = 1.3 * epsilon;
      const std::vector<Point> points = random_net(random, epsilon, radius);
      const PartitionSums sums = partition_sums(points, epsilon, radius);
      const certify::PartitionBounds bounds = certify::partition_bounds(points, epsilon, radius);
      EXPECT_GT(sums.laplacians, 0.8 * bounds.laplacians) << epsilon << ", " << i;
      EXPECT_LT(sums.laplacians, 1.6 * bounds.laplacians) << epsilon << ", " << i;
      EXPECT_GT(sums.gradients, 0.9 * bounds.gradients) << epsilon << ", " << i;
      EXPECT_LT(sums.gradients, 1.3 * bounds.gradients) << epsilon << ", " << i;
      sum += sums.laplacians;
      proved += bounds.laplacians;
    }
    // Intervals are made a tenth wider than is estimated.
    EXPECT_GT(sum, 0.95 * proved) << epsilon;
    EXPECT_LT(sum, 1.15 * proved) << epsilon;
  }
}

TEST(PartitionSums, AreFiniteWhereTheFunctionsCover) {
  const PartitionSums one = partition_sums({0}, 0.5, 0.9);
  EXPECT_TRUE(std::isfinite(one.laplacians));
  EXPECT_TRUE(std::isfinite(one.gradients));
  EXPECT_TRUE(std::isinf(partition_sums({}, 0.5, 0.9).laplacians));
  EXPECT_TRUE(std::isinf(partition_sums({std::tanh(0.3)}, 0.5, 0.9).gradients));
}

}  // namespace
}  // namespace epsnet::eigenfunctions_test
