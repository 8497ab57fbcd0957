#include "certify/claims/geodesics/local_maximum.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "tests/certify/lifted_reference.h"

/// Derivatives along twists from lines with known normals, and weights from known matrices.
namespace epsnet::certify::local_maximum_test {
namespace {

const LiftedNet& lifted() {
  static const LiftedNet net(
      read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/regular-2-10-vertices.json"), 64);
  return net;
}

Ball ball(double middle, double radius = 0) {
  Ball result = Ball::exactly(middle);
  arb_add_error(result.get(), Ball::exactly(radius).get());
  return result;
}

/// One that crosses a dart, with the normal (x, y, z).
AxisCrossings line(std::uint32_t dart, const Ball& x, const Ball& y, const Ball& z) { return {{dart}, {{x, y, -z}}}; }

/// Through 0, in the direction of an angle.
AxisCrossings through_origin(double angle) { return line(0, ball(-std::sin(angle)), ball(std::cos(angle)), ball(0)); }

std::optional<std::vector<std::vector<Ball>>> derivatives(const std::vector<AxisCrossings>& geodesics) {
  const std::vector<std::uint32_t> about{0, 1};
  return twist_derivatives(lifted().plane(), geodesics, about);
}

TEST(TwistDerivatives, AreCosinesOfTheAngleFromOneLineToTheOther) {
  for (const double first : {0.1, 1.3, 2.9, 4.5}) {
    for (const double angle : {0.2, 1.0, 1.5, 2.0, 3.0}) {
      for (const double turned : {0.0, M_PI}) {  // A line has no direction.
        const auto found = derivatives({through_origin(first), through_origin(first + angle + turned)});
        ASSERT_TRUE(found);
        const auto middle = [&](std::size_t i, std::size_t j) { return upper_end((*found)[i][j]); };
        EXPECT_NEAR(middle(0, 1), std::cos(angle), 1e-12);
        EXPECT_NEAR(middle(1, 0), -std::cos(angle), 1e-12);
        EXPECT_TRUE(is_exactly_zero((*found)[0][0]) && is_exactly_zero((*found)[1][1]));
      }
    }
  }
}

TEST(TwistDerivatives, ContainThoseOfAllLinesInTheBalls) {
  const auto found = derivatives({line(0, ball(0), ball(1), ball(0)), line(0, ball(-0.5), ball(0.8, 0.01), ball(0))});
  ASSERT_TRUE(found);
  EXPECT_LE(lower_end((*found)[0][1]), 0.79);
  EXPECT_GE(upper_end((*found)[0][1]), 0.81);
  EXPECT_LE(lower_end((*found)[1][0]), -0.81);
  EXPECT_GE(upper_end((*found)[1][0]), -0.79);
}

TEST(TwistDerivatives, LinesAreMovedByIsometries) {
  // Along the real axis by r: the same lines through another point.
  const double r = 1.2;
  const auto moved = [&](double angle) {
    const double x = -std::sin(angle);
    return line(0, ball(x * std::cosh(r)), ball(std::cos(angle)), ball(x * std::sinh(r)));
  };
  const auto found = derivatives({moved(0.4), moved(1.1)});
  ASSERT_TRUE(found);
  EXPECT_NEAR(upper_end((*found)[0][1]), std::cos(0.7), 1e-12);
}

TEST(TwistDerivatives, OfLinesThatDoNotCrossAre0) {
  for (const double sign : {1, -1}) {
    const auto found = derivatives(
        {line(0, ball(1), ball(0), ball(0)), line(1, ball(sign * std::cosh(1)), ball(0), ball(sign * std::sinh(1)))});
    ASSERT_TRUE(found);
    EXPECT_TRUE(is_exactly_zero((*found)[0][1]) && is_exactly_zero((*found)[1][0]));
  }
  // In different triangles lines are those of different charts.
  AxisCrossings elsewhere = through_origin(1);
  elsewhere.darts = {5};
  const auto found = derivatives({through_origin(0), elsewhere});
  ASSERT_TRUE(found);
  EXPECT_TRUE(is_exactly_zero((*found)[0][1]) && is_exactly_zero((*found)[1][0]));
}

TEST(TwistDerivatives, AreNothingUnlessItIsKnownWhatCrosses) {
  const AxisCrossings first = line(0, ball(1), ball(0), ball(0));
  EXPECT_FALSE(derivatives({first, line(0, ball(1, 1e-3), ball(0.5), ball(0.5))}));
  // They cross, from a side that is not known.
  EXPECT_FALSE(derivatives({first, line(0, ball(0.5), ball(0, 1e-3), ball(0))}));
  // A pair of chords that is not known does not matter beside one that is.
  AxisCrossings two = through_origin(1);
  two.darts.push_back(1);
  two.axes.push_back(line(0, ball(1, 1e-3), ball(0.5), ball(0.5)).axes[0]);
  const auto found = derivatives({first, two});
  ASSERT_TRUE(found);
  EXPECT_NEAR(upper_end((*found)[1][0]), -lower_end((*found)[0][1]), 1e-12);
}

std::vector<std::vector<Ball>> rows(const std::vector<std::vector<double>>& numbers) {
  std::vector<std::vector<Ball>> result;
  for (const auto& row : numbers) {
    result.emplace_back();
    for (const double x : row) result.back().push_back(ball(x));
  }
  return result;
}

TEST(WeightsOfABasis, MakeTheSum0) {
  // Geodesics 0 and 2 are the basis: 2 x_2 + 3 w_1 + 4 w_3 = 0 and -2 x_0 + w_1 - 5 w_3 = 0.
  const auto found = weights_of_basis(lifted().plane(), rows({{0, 3, 2, 4}, {-2, 1, 0, -5}}), {0, 2}, {10, 3});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->size(), 2);
  EXPECT_NEAR(upper_end((*found)[0]), -2.5, 1e-12);
  EXPECT_NEAR(upper_end((*found)[1]), -21, 1e-12);
}

/// With derivatives that are known roughly: 3 ± 0.2 divided by 2 ± 0.1, in one and in two equations.
TEST(WeightsOfABasis, ContainThoseOfAllNumbersInTheBalls) {
  const std::vector<Ball> row{ball(-2, 0.1), ball(3, 0.2)};
  const std::vector<std::vector<Ball>> two{{row[0], ball(0), row[1]}, {ball(0), ball(-1), ball(5)}};
  for (const auto& found :
       {weights_of_basis(lifted().plane(), {row}, {0}, {1}), weights_of_basis(lifted().plane(), two, {0, 1}, {1})}) {
    ASSERT_TRUE(found);
    EXPECT_LE(lower_end((*found)[0]), 2.8 / 2.1);
    EXPECT_GE(upper_end((*found)[0]), 3.2 / 1.9);
  }
}

TEST(WeightsOfABasis, AreNothingUnlessTheMatrixHasAnInverse) {
  EXPECT_FALSE(weights_of_basis(lifted().plane(), rows({{1, 2, 1}, {2, 4, 1}}), {0, 1}, {1}));
  auto wide = rows({{1, 2, 1}, {2, 3, 1}});
  EXPECT_TRUE(weights_of_basis(lifted().plane(), wide, {0, 1}, {1}));
  wide[1][1] = ball(3, 1);
  EXPECT_FALSE(weights_of_basis(lifted().plane(), wide, {0, 1}, {1}));
}

}  // namespace
}  // namespace epsnet::certify::local_maximum_test
