#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <vector>

#include "certify/lifted/lifted_plane.h"

namespace epsnet::certify::interval_index_test {
namespace {

using Items = std::vector<std::uint32_t>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

IntervalIndex index_of(const std::vector<Interval>& intervals) {
  IntervalIndex index;
  for (std::uint32_t i = 0; i < intervals.size(); ++i) index.insert(intervals[i], i);
  return index;
}

TEST(IntervalIndex, FindsIntervalsThatMeetInOnePoint) {
  const IntervalIndex index = index_of({{1, 2}, {2, 3}, {2, 2}, {-5, 2}, {2, 7}});
  EXPECT_EQ(index.near({2, 2}), (Items{0, 1, 2, 3, 4}));
  EXPECT_EQ(index.near({0, 1}).front(), 0U);
}

TEST(IntervalIndex, FindsThePowersOfTwoAtWhichWidthsChangeTheirExponent) {
  for (int e = -1074; e < 1023; ++e) {
    const double width = std::ldexp(1.0, e);
    const IntervalIndex index =
        index_of({{0, width}, {0, std::nextafter(width, 0.0)}, {0, std::nextafter(width, kInfinity)}});
    const double least = std::nextafter(width, 0.0);
    EXPECT_EQ(index.near({least, least}), (Items{0, 1, 2})) << e;
    EXPECT_EQ(index.near({0, 0}), (Items{0, 1, 2})) << e;
  }
}

TEST(IntervalIndex, RoundsWidthsUp) {
  // 2 + 2⁻⁶⁰ is 2 in binary64, which is not the width.
  EXPECT_EQ(index_of({{-0x1p-60, 2}}).near({2, 2}), (Items{0}));
  EXPECT_EQ(index_of({{-0x1p-600, 1}}).near({1, 3}), (Items{0}));
}

TEST(IntervalIndex, KnowsNothingOfIntervalsWithoutEnds) {
  constexpr double kGreatest = std::numeric_limits<double>::max();
  const IntervalIndex index =
      index_of({{-kInfinity, kInfinity}, {0, kInfinity}, {-kInfinity, 0}, {-kGreatest, kGreatest}, {5, 6}});
  EXPECT_EQ(index.near({5, 5}), (Items{0, 1, 2, 3, 4}));
  EXPECT_EQ(index.near({-kInfinity, kInfinity}), (Items{0, 1, 2, 3, 4}));
  EXPECT_EQ(index.near({kGreatest, kInfinity}), (Items{0, 1, 2, 3}));
}

RC_GTEST_PROP(IntervalIndex, MissesNoIntervalThatMeetsTheGivenOne, ()) {
  // Few ends, so that many are equal, and widths of all sizes.
  const auto end = rc::gen::map(rc::gen::pair(rc::gen::inRange(-8, 9), rc::gen::inRange(-60, 3)),
                                [](const auto& x) { return std::ldexp(x.first, x.second); });
  const auto interval = rc::gen::map(rc::gen::pair(end, end), [](const auto& x) {
    return Interval{std::min(x.first, x.second), std::max(x.first, x.second)};
  });
  const auto intervals = *rc::gen::container<std::vector<Interval>>(interval);
  const Interval x = *interval;
  const Items found = index_of(intervals).near(x);
  RC_ASSERT(std::is_sorted(found.begin(), found.end()));
  for (std::uint32_t i = 0; i < intervals.size(); ++i) {
    if (intervals[i].lower <= x.upper && x.lower <= intervals[i].upper) {
      RC_ASSERT(std::binary_search(found.begin(), found.end(), i));
    }
  }
}

TEST(IntervalIndex, LooksAtFewOfManyNarrowOnesThoughSomeAreWide) {
  constexpr std::uint32_t kMany = 10'000;
  std::vector<Interval> intervals;
  for (std::uint32_t i = 0; i < kMany; ++i) intervals.push_back({i + 0.0, i + 0x1p-30});
  intervals.push_back({-1, kMany});
  const IntervalIndex index = index_of(intervals);
  for (std::uint32_t i = 0; i < kMany; ++i) EXPECT_EQ(index.near({i + 0.0, i + 0.0}), (Items{i, kMany}));
}

}  // namespace
}  // namespace epsnet::certify::interval_index_test
