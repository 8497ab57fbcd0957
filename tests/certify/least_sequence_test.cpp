#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "certify/base/error.h"
#include "certify/claims/geodesics/sequences.h"

namespace epsnet::certify::least_sequence_test {
namespace {

using Codes = std::vector<std::uint32_t>;

Codes way_back(Codes codes) {
  std::reverse(codes.begin(), codes.end());
  for (std::uint32_t& code : codes) code ^= 1U;
  return codes;
}

/// By the definition.
Codes least_of_all(const Codes& codes) {
  Codes least = codes;
  for (Codes way : {codes, way_back(codes)}) {
    for (std::size_t i = 0; i < codes.size(); ++i) {
      std::rotate(way.begin(), way.begin() + 1, way.end());
      least = std::min(least, way);
    }
  }
  return least;
}

TEST(LeastSequence, IsTheLeastOfAllRotations) {
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    Codes codes(1 + random() % 12);
    for (std::uint32_t& code : codes) code = static_cast<std::uint32_t>(random() % (2 + random() % 6));
    const LeastSequence least = least_sequence(codes);
    Codes repeated;
    for (std::uint32_t k = 0; k < least.exponent; ++k) {
      repeated.insert(repeated.end(), least.root.begin(), least.root.end());
    }
    ASSERT_EQ(repeated, least_of_all(codes));
    ASSERT_EQ(period_of(least.root), least.root.size());
  }
}

TEST(LeastSequence, KnowsHowManyTimesTheRootIsRunThrough) {
  EXPECT_EQ(least_sequence(Codes{4, 2, 4, 2, 4, 2}).exponent, 3U);
  EXPECT_EQ(least_sequence(Codes{4, 2, 4, 2, 4, 2}).root, (Codes{2, 4}));
  EXPECT_EQ(least_sequence(Codes{4, 2, 4, 2, 4}).exponent, 1U);
  EXPECT_EQ(least_sequence(Codes{7, 7}).root, Codes{6});
  EXPECT_THROW((void)least_sequence(Codes{}), Fault);
}

TEST(SequenceTable, FindsOthersOfWhichOneIsAPower) {
  const SequenceTable table({least_sequence(Codes{2, 4, 6}), least_sequence(Codes{8, 10, 8, 10}),
                             least_sequence(Codes{7, 5, 3, 7, 5, 3}), least_sequence(Codes{2, 6, 4}),
                             least_sequence(Codes{8, 10, 8, 10, 8, 10})});
  EXPECT_FALSE(table.find_other(0));
  const auto match = table.find_other(2);
  ASSERT_TRUE(match);
  EXPECT_EQ(match->geodesic, 0U);
  EXPECT_EQ(match->power, 2U);
  EXPECT_FALSE(table.find_other(3));
  // Powers 2 and 3 of what is not in the list.
  EXPECT_FALSE(table.find_other(1));
  EXPECT_FALSE(table.find_other(4));
  EXPECT_TRUE(table.contains({2, 4, 6}));
  EXPECT_TRUE(table.contains({2, 6, 4}));
  EXPECT_FALSE(table.contains({8, 10}));
  EXPECT_FALSE(table.contains({2, 4}));
  EXPECT_THROW((void)table.find_other(5), Fault);
}

TEST(SequenceTable, TheSameTwiceIsFoundEitherWay) {
  const SequenceTable table({least_sequence(Codes{2, 4, 6}), least_sequence(Codes{5, 3, 7})});
  for (const std::uint32_t i : {0U, 1U}) {
    const auto match = table.find_other(i);
    ASSERT_TRUE(match);
    EXPECT_EQ(match->geodesic, 1 - i);
    EXPECT_EQ(match->power, 1U);
  }
}

}  // namespace
}  // namespace epsnet::certify::least_sequence_test
