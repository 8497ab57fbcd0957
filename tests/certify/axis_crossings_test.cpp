#include "certify/claims/geodesics/axis_crossings.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <utility>
#include <vector>

#include "certify/claims/geodesics/sequences.h"
#include "tests/certify/lifted_reference.h"

/// Walks along axes, and what follows from them for single geodesics.
namespace epsnet::certify::axis_crossings_test {
namespace {

using Word = std::vector<std::uint32_t>;

NetDocument net_of(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}

std::vector<GeodesicsDocument::ClosedGeodesic> at_vertex(std::uint32_t vertex, const std::vector<Word>& words) {
  std::vector<GeodesicsDocument::ClosedGeodesic> result;
  result.reserve(words.size());
  for (const Word& word : words) result.push_back({vertex, word, {1, 6}, true});
  return result;
}

/// A net with its vertices moved, and words.
struct Moved {
  Moved(const std::string& name, std::uint32_t vertex, const std::vector<Word>& words, slong precision = 128)
      : lifted(net_of(name), at_vertex(vertex, words), precision),
        net(lifted.plane()),
        first(first_darts(lifted.net())[vertex]) {
    EXPECT_TRUE(net.valid());
  }
  [[nodiscard]] std::optional<AxisCrossings> crossings(const BallIsometry& element) const {
    return axis_crossings(net, first, element);
  }
  LiftedNet lifted;
  MovedNet net;
  std::uint32_t first;
};

const std::vector<Word> kWords{{0}, {0, 1}, {5, 3, 0}, {2, 1, 4, 6}, {0, 0, 1}, {7, 4, 2, 7, 4, 1, 0, 3}};
constexpr const char* kBolza = "regular-2-10-vertices.json";

/// From every vertex of the net, and from far away, the walk finds the same cyclic sequence.
TEST(AxisCrossings, AreTheSameFromEverywhere) {
  std::optional<std::vector<LeastSequence>> expected;
  const NetDocument net = net_of(kBolza);
  std::size_t walks = 0;
  for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
    if (net.charts[net.vertices[v].chart].centre.x != 0 || net.charts[net.vertices[v].chart].centre.y != 0) continue;
    for (const std::size_t detour : {0U, 2U, 20U}) {
      std::vector<Word> words = kWords;
      for (Word& word : words) {
        for (std::size_t k = 0; k < detour; ++k) {
          const auto side = static_cast<std::uint32_t>(k % 3);
          word.insert(word.begin(), side);
          word.push_back((side + 4) % 8);
        }
      }
      const Moved moved(kBolza, v, words, 512);
      std::vector<LeastSequence> found;
      for (std::size_t i = 0; i < words.size(); ++i) {
        const auto crossings = moved.crossings(moved.lifted.element(i));
        ASSERT_TRUE(crossings) << "vertex " << v << ", word " << i << ", " << detour;
        found.push_back(least_sequence(crossings->darts));
        ++walks;
      }
      if (!expected) expected = found;
      for (std::size_t i = 0; i < words.size(); ++i) {
        // Codes of opposite darts differ by one only in an order of darts: compare the sets of edges.
        const auto edges = [&](const LeastSequence& sequence) {
          std::vector<std::uint32_t> result;
          for (const std::uint32_t dart : sequence.root) result.push_back(std::min(dart, opposite(net, dart)));
          std::sort(result.begin(), result.end());
          return result;
        };
        EXPECT_EQ(edges(found[i]), edges((*expected)[i])) << "vertex " << v << ", word " << i << ", " << detour;
      }
    }
  }
  EXPECT_GT(walks, 9 * kWords.size());
}

/// Each dart is crossed from the right to the left of it, and the next one is in the triangle beyond.
TEST(AxisCrossings, FollowEachOther) {
  for (const char* name : {kBolza, "octagon-9-vertices.json", "octagon-1-vertex.json"}) {
    const Moved moved(name, 0, {{0}, {0, 1}, {5, 3, 0}}, 256);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = moved.crossings(moved.lifted.element(i));
      ASSERT_TRUE(found) << name << ", word " << i;
      ASSERT_EQ(found->axes.size(), found->darts.size());
      for (std::size_t k = 0; k < found->darts.size(); ++k) {
        const std::uint32_t dart = found->darts[k];
        EXPECT_EQ(opposite(moved.lifted.net(), dart) / 3, found->darts[(k + 1) % found->darts.size()] / 3);
        Ball left, right;
        dot(left, found->axes[k], moved.net.corner(next_dart(dart)), 256);
        dot(right, found->axes[k], moved.net.corner(dart), 256);
        EXPECT_EQ(certain_sign(left), 1);
        EXPECT_EQ(certain_sign(right), -1);
      }
    }
  }
}

TEST(AxisCrossings, OfAPowerAreThoseOfItsRootAgain) {
  const Moved moved(kBolza, 0, {{5, 3, 0}, {5, 3, 0, 5, 3, 0, 5, 3, 0}});
  const auto root = moved.crossings(moved.lifted.element(0));
  const auto power = moved.crossings(moved.lifted.element(1));
  ASSERT_TRUE(root && power);
  EXPECT_EQ(power->darts.size(), 3 * root->darts.size());
  EXPECT_EQ(least_sequence(power->darts).exponent, 3U);
}

TEST(AxisCrossings, AreThoseOfTheElementOrNoneHoweverWellItIsKnown) {
  const Moved moved(kBolza, 0, kWords);
  std::mt19937 random(1);
  int found = 0;
  int none = 0;
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    const BallIsometry element = moved.lifted.element(i);
    const auto expected = moved.crossings(element);
    ASSERT_TRUE(expected);
    for (int trial = 0; trial < 300; ++trial) {
      const auto crossings = moved.crossings(blurred_somehow(element, trial % 60, random));
      ++(crossings ? found : none);
      if (crossings) {
        EXPECT_EQ(crossings->darts, expected->darts) << "word " << i << ", trial " << trial;
      }
    }
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(none, 100);
}

TEST(AxisCrossings, OfOtherDartsNoneIsCertainHoweverWellTheElementIsKnown) {
  // As far as a dart, and there the other way: one end of it is on the wrong side of the axis.
  const Moved moved(kBolza, 0, kWords);
  const NetDocument& net = moved.lifted.net();
  std::mt19937 random(1);
  int refused = 0;
  int open = 0;
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    const auto expected = moved.crossings(moved.lifted.element(i));
    ASSERT_TRUE(expected);
    const BallIsometry element = element_across(moved.lifted.plane(), expected->darts);
    for (std::size_t k = 1; k < expected->darts.size(); ++k) {
      const std::vector<std::uint32_t> right(expected->darts.begin(),
                                             expected->darts.begin() + static_cast<std::ptrdiff_t>(k + 1));
      std::vector<std::uint32_t> wrong = right;
      const std::uint32_t back = opposite(net, wrong[k - 1]);
      wrong[k] = wrong[k] == next_dart(back) ? previous_dart(back) : next_dart(back);
      for (int bits = 2; bits < 40; ++bits) {
        const BallIsometry blurred = blurred_somehow(element, bits, random);
        EXPECT_NE(crosses(moved.net, blurred, right), Tri::no) << i << ", " << k << ", " << bits;
        const Tri crosses_wrong = crosses(moved.net, blurred, wrong);
        EXPECT_NE(crosses_wrong, Tri::yes) << i << ", " << k << ", " << bits;
        ++(crosses_wrong == Tri::no ? refused : open);
      }
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(open, 100);
}

TEST(AxisCrossings, AreNotFoundForWhatHasNoAxis) {
  const Moved moved(kBolza, 0, kWords);
  EXPECT_FALSE(moved.crossings(identity_isometry()));
  BallIsometry element = moved.lifted.element(0);
  EXPECT_TRUE(moved.crossings(element));
  mag_set_d(arb_radref(element.a.re()), 5);
  EXPECT_FALSE(moved.crossings(element)) << "no sign is chosen";
}

TEST(Meetings, AreOfGeodesicsWithThemselvesAndWithOthers) {
  // Sides 0 and 1 of the octagon: simple, and their axes meet in the centre; {0, 0, 1} crosses itself.
  const Moved moved(kBolza, 0, {{0}, {1}, {0, 0, 1, 1, 0}, {5, 3, 0}});
  std::vector<AxisCrossings> all;
  for (std::size_t i = 0; i < 4; ++i) all.push_back(*moved.crossings(moved.lifted.element(i)));
  const auto alone = [&](std::size_t i) { return find_meetings(moved.lifted.plane(), {&all[i], 1}).at(0); };
  for (const std::size_t i : {0U, 1U, 3U}) EXPECT_EQ(alone(i).itself, Tri::no) << i;
  EXPECT_EQ(alone(2).itself, Tri::yes);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(alone(i).another, Tri::no);
  const std::vector<AxisCrossings> pair{all[0], all[1]};
  for (const Meetings& meetings : find_meetings(moved.lifted.plane(), pair)) {
    EXPECT_EQ(meetings.itself, Tri::no);
    EXPECT_EQ(meetings.another, Tri::yes);
  }
  // Of the same geodesic twice nothing is known.
  const std::vector<AxisCrossings> twins{all[3], all[3]};
  for (const Meetings& meetings : find_meetings(moved.lifted.plane(), twins)) {
    EXPECT_EQ(meetings.itself, Tri::no);
    EXPECT_EQ(meetings.another, Tri::unknown);
  }
  EXPECT_TRUE(find_meetings(moved.lifted.plane(), {}).empty());
}

TEST(Meetings, AreOfAnyTwoChordsOfATriangle) {
  // Two lines that cross at a right angle, and one that is far from both: whichever of the three comes first.
  const Moved moved(kBolza, 0, {{0}});
  const auto line = [](double x, double y, double z) {
    return BallVector{Ball::exactly(x), Ball::exactly(y), Ball::exactly(z)};
  };
  std::vector<std::pair<int, BallVector>> lines{{0, line(0, 1, 0)}, {1, line(1, 0, 0)}, {2, line(2, 2, std::sqrt(7))}};
  do {
    AxisCrossings together;
    std::vector<AxisCrossings> alone;
    for (const auto& [number, axis] : lines) {
      together.darts.push_back(3);
      together.axes.push_back(axis);
      alone.push_back({{3}, {axis}});
    }
    EXPECT_EQ(find_meetings(moved.lifted.plane(), {&together, 1}).at(0).itself, Tri::yes);
    const auto meetings = find_meetings(moved.lifted.plane(), alone);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(meetings[i].another, lines[i].first == 2 ? Tri::no : Tri::yes) << i;
    // In another triangle it meets nothing.
    alone[0].darts = {0};
    const auto apart = find_meetings(moved.lifted.plane(), alone);
    EXPECT_EQ(apart[0].another, Tri::no);
    EXPECT_EQ(apart[1].another, lines[0].first == 2 ? Tri::yes : Tri::no);
  } while (std::next_permutation(lines.begin(), lines.end(),
                                 [](const auto& x, const auto& y) { return x.first < y.first; }));
}

TEST(FirstDarts, LeaveTheirVertices) {
  for (const char* name : {kBolza, "octagon-1-vertex.json"}) {
    const NetDocument net = net_of(name);
    const auto darts = first_darts(net);
    ASSERT_EQ(darts.size(), net.vertices.size());
    for (std::uint32_t v = 0; v < darts.size(); ++v) {
      EXPECT_EQ(start(net, darts[v]), v);
      for (std::uint32_t dart = 0; dart < darts[v]; ++dart) EXPECT_NE(start(net, dart), v);
    }
  }
}

TEST(TranslationLength, IsRoundedOutward) {
  BallIsometry f = identity_isometry();
  for (const int sign : {1, -1}) {
    arb_set_d(f.a.re(), sign * std::cosh(1.5));
    const Interval length = translation_length(f, 128);
    EXPECT_NEAR(length.lower, 3, 1e-14);
    EXPECT_NEAR(length.upper, 3, 1e-14);
    EXPECT_LT(length.lower, length.upper);
  }
  arb_set_d(f.a.re(), 1.5);
  mag_set_d(arb_radref(f.a.re()), 0.25);
  EXPECT_LE(translation_length(f, 128).lower, 2 * std::acosh(1.25));
  EXPECT_GT(translation_length(f, 128).lower, 1);
  EXPECT_GE(translation_length(f, 128).upper, 2 * std::acosh(1.75));
  EXPECT_LT(translation_length(f, 128).upper, 3);
  mag_set_d(arb_radref(f.a.re()), 1);
  const Interval unknown = translation_length(f, 128);
  EXPECT_EQ(unknown.lower, 0);
  EXPECT_EQ(unknown.upper, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace epsnet::certify::axis_crossings_test
