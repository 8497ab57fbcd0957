#include <array>
#include <cmath>
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <random>

#include "certify/claims/eigenvalues/forms.h"

/// Entries in binary64 are within their errors of all numbers that they may stand for, as rationals tell.
namespace epsnet::certify::matrix_entries_test {
namespace {

class MatrixEntries : public testing::Test {
 protected:
  /// Of a size from 2⁻ˢ to 2ˢ.
  double any(int s) {
    const int exponent = static_cast<int>(random_() % static_cast<unsigned>(2 * s + 1)) - s;
    return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random_())) * 0x1p-63, exponent);
  }

  /// A ball, and its ends and middle, exactly.
  struct Numbers {
    Ball ball;
    std::array<mpq_class, 3> points;
  };
  Numbers any_ball(double size) {
    const double middle = size * any(1);
    // Often no number of binary64: between two of them if the radius is small.
    const double beside = random_() % 3 == 0 ? 0 : std::ldexp(any(0), std::ilogb(middle) - 52);
    // A radius with few bits, which a ball keeps as it is; or none.
    const double radius = random_() % 3 == 0 ? 0 : std::ldexp(1, std::ilogb(size)) * std::abs(any(0)) * power(60);
    const double kept = std::ldexp(std::floor(std::ldexp(radius, 20 - std::ilogb(radius + 0x1p-1000))),
                                   std::ilogb(radius + 0x1p-1000) - 20);
    Numbers result{Ball::exactly(middle) + Ball::exactly(beside), {}};
    arb_add_error(result.ball.get(), Ball::exactly(kept).get());
    const mpq_class m(mpq_class(middle) + mpq_class(beside));
    const mpq_class r(kept);
    result.points = {m, mpq_class(m - r), mpq_class(m + r)};
    return result;
  }

  static bool is_within(const mpq_class& exact, double value, double error) {
    const mpq_class distance(exact - mpq_class(value));
    return abs(distance) <= mpq_class(error);
  }

  double power(int most) { return std::ldexp(1, -static_cast<int>(random_() % static_cast<unsigned>(most + 1))); }

  std::mt19937_64 random_{11};
  Precision precision_{128};
};

TEST_F(MatrixEntries, ABallIsWithinItsError) {
  for (int trial = 0; trial < 20000; ++trial) {
    const Numbers x = any_ball(any(40));
    const Rounded rounded(x.ball);
    for (const mpq_class& point : x.points) {
      EXPECT_TRUE(is_within(point, rounded.value, rounded.error)) << trial;
    }
    // Not much more than that.
    const mpq_class width(x.points[2] - x.points[1]);
    EXPECT_LE(rounded.error, width.get_d() * 1.001 + std::abs(rounded.value) * 0x1p-50 + 0x1p-1000) << trial;
  }
}

TEST_F(MatrixEntries, ADifferenceIsWithinItsError) {
  for (int trial = 0; trial < 20000; ++trial) {
    const Numbers x = any_ball(any(30));
    const Numbers y = any_ball(any(30));
    const double sigma = std::abs(any(10));
    const MatrixEntry entry = difference_entry(3, 5, Rounded(x.ball), sigma, Rounded(y.ball));
    EXPECT_EQ(entry.row, 5U);
    EXPECT_EQ(entry.column, 3U);
    for (const mpq_class& p : x.points) {
      for (const mpq_class& q : y.points) {
        EXPECT_TRUE(is_within(mpq_class(p - mpq_class(sigma) * q), entry.value, entry.error)) << trial;
      }
    }
  }
}

TEST_F(MatrixEntries, AMultipleIsWithinItsError) {
  for (int trial = 0; trial < 20000; ++trial) {
    const Numbers factor = any_ball(0.25 * power(10));
    const MatrixEntry entry{7, 2, any(30), std::abs(any(30)) * power(60)};
    const MatrixEntry found = multiple_of(entry, Rounded(factor.ball));
    EXPECT_EQ(found.row, 7U);
    EXPECT_EQ(found.column, 2U);
    for (const mpq_class& p : factor.points) {
      for (const int end : {-1, 0, 1}) {
        const mpq_class x(mpq_class(entry.value) + end * mpq_class(entry.error));
        EXPECT_TRUE(is_within(mpq_class(p * x), found.value, found.error)) << trial;
      }
    }
  }
}

}  // namespace
}  // namespace epsnet::certify::matrix_entries_test
