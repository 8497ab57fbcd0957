#include "certify/claims/isometries/frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "certify/net/rules.h"
#include "tests/certify/claim_files.h"
#include "tests/certify/lifted_reference.h"

/// Crossing points of closed geodesics, and the frames that isometries may take to each other.
namespace epsnet::certify::frames_test {
namespace {

constexpr double kStep =
    0x1p-10;  ///< Places and cosines are multiples of it, and lengths are integers: sums are exact.

Ball around(double x, double radius) {
  Ball result = Ball::exactly(x);
  arb_add_error(result.get(), Ball::exactly(radius).get());
  return result;
}

/// Two geodesics cross, or one itself.
void cross(CrossingGeodesics& list, std::uint32_t i, std::uint32_t j, std::array<int, 2> places, int cosine, int turn) {
  const auto first = static_cast<std::uint32_t>(list.points[i].size());
  const auto second = static_cast<std::uint32_t>(list.points[j].size()) + (i == j ? 1 : 0);
  const Ball c = Ball::exactly(kStep * cosine);
  list.points[i].push_back({Ball::exactly(kStep * places[0]), c, j, second, 0, turn});
  list.points[j].push_back({Ball::exactly(kStep * places[1]), -c, i, first, 0, -turn});
}

/// Some geodesics, two of each length, that cross each other and themselves anywhere.
CrossingGeodesics any_list(std::mt19937& random) {
  CrossingGeodesics list;
  list.points.resize(4);
  for (const double length : {3, 3, 5, 5}) list.lengths.push_back(Ball::exactly(length));
  const auto any = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
  // Each crosses the next one, so that crossings join them all.
  for (int k = 0; k < 10; ++k) {
    const auto i = static_cast<std::uint32_t>(k % 4);
    const auto j = k < 4 ? (i + 1) % 4 : static_cast<std::uint32_t>(any(4));
    cross(list, i, j, {any(3072), any(3072)}, any(2046) - 1023, any(2) == 0 ? 1 : -1);
  }
  return list;
}

struct Image {
  CrossingGeodesics list;
  std::vector<std::uint32_t> geodesic;            ///< By geodesic of the other list.
  std::vector<std::vector<std::uint32_t>> point;  ///< By its crossing points.
};

/// What an isometry makes of a list: in any order, from any beginnings, in any directions.
Image image_of(const CrossingGeodesics& list, int orientation, std::mt19937& random) {
  const std::size_t count = list.points.size();
  Image image{{}, std::vector<std::uint32_t>(count), std::vector<std::vector<std::uint32_t>>(count)};
  const auto shuffle = [&](std::vector<std::uint32_t>& numbers, std::size_t size) {
    numbers.resize(size);
    std::iota(numbers.begin(), numbers.end(), 0U);
    std::shuffle(numbers.begin(), numbers.end(), random);
  };
  shuffle(image.geodesic, count);
  std::vector<int> direction(count);
  for (std::size_t i = 0; i < count; ++i) {
    shuffle(image.point[i], list.points[i].size());
    direction[i] = random() % 2 == 0 ? 1 : -1;
  }
  image.list.lengths.resize(count);
  image.list.points.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t to = image.geodesic[i];
    image.list.lengths[to] = list.lengths[i];
    image.list.points[to].resize(list.points[i].size());
    const Ball beginning = Ball::exactly(kStep * static_cast<double>(random() % 3072));
    for (std::size_t k = 0; k < list.points[i].size(); ++k) {
      const CrossingPoint& x = list.points[i][k];
      const Ball turns = static_cast<int>(random() % 3) * list.lengths[i];
      image.list.points[to][image.point[i][k]] = {direction[i] * (x.along - beginning) + turns,
                                                  orientation * x.cosine,
                                                  image.geodesic[x.other],
                                                  image.point[x.other][x.place],
                                                  0,
                                                  orientation * direction[i] * direction[x.other] * x.turn};
    }
  }
  return image;
}

/// The list, of which each number is known to within the radius.
CrossingGeodesics blurred(CrossingGeodesics list, double radius, std::mt19937& random) {
  const auto blur = [&](Ball& x) {
    const double shift = radius * (static_cast<double>(random() % 2049) / 1024 - 1);
    x = x + around(shift, radius);
  };
  for (auto& points : list.points) {
    for (CrossingPoint& x : points) {
      blur(x.along);
      blur(x.cosine);
    }
  }
  return list;
}

CrossingGeodesics together(CrossingGeodesics list, const CrossingGeodesics& other) {
  const auto count = static_cast<std::uint32_t>(list.points.size());
  list.lengths.insert(list.lengths.end(), other.lengths.begin(), other.lengths.end());
  for (auto points : other.points) {
    for (CrossingPoint& x : points) x.other += count;
    list.points.push_back(std::move(points));
  }
  return list;
}

/// Work is paid for at the precision of any plane.
class Frames : public testing::Test {
 protected:
  Precision precision_{64};
  LiftedNet net_{read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/octagon-1-vertex.json"), 64};
  const LiftedPlane& plane_ = net_.plane();
  std::mt19937 random_{7};
};

TEST_F(Frames, OfAnIsometryAreNotLostHoweverWellTheNumbersAreKnown) {
  for (int trial = 0; trial < 200; ++trial) {
    const CrossingGeodesics list = any_list(random_);
    for (const int orientation : {1, -1}) {
      const Image image = image_of(list, orientation, random_);
      for (const double radius : {0.0, 0x1p-10, 0x1p-5, 0x1p-3, 0x1p-1}) {
        const CrossingGeodesics here = blurred(list, radius, random_);
        const CrossingGeodesics there = blurred(image.list, radius, random_);
        EXPECT_FALSE(no_isometry(plane_, here, there)) << trial << ", " << orientation << ", " << radius;
        const CrossingGeodesics both = together(here, there);
        EXPECT_GE(followed_frames(plane_, both, 0), 2U);
        for (std::size_t k = 0; k < both.points[0].size(); ++k) EXPECT_GE(possible_frames(plane_, both, 0, k), 2U);
      }
    }
  }
}

TEST_F(Frames, OfNoIsometryAreDroppedWhereNumbersTell) {
  for (int trial = 0; trial < 50; ++trial) {
    const CrossingGeodesics list = any_list(random_);
    EXPECT_EQ(followed_frames(plane_, list, 0), 1U);
    const Image image = image_of(list, trial % 2 == 0 ? 1 : -1, random_);
    EXPECT_EQ(followed_frames(plane_, together(list, image.list), 0), 2U);
    // Another angle, another place, the other direction of one that crosses.
    const std::uint32_t i = image.geodesic[static_cast<std::size_t>(trial % 4)];
    const auto partner = [](CrossingGeodesics& of, CrossingPoint& x) -> CrossingPoint& {
      return of.points[x.other][x.place];
    };
    CrossingGeodesics other = image.list;
    CrossingPoint* x = &other.points[i][0];
    x->cosine += Ball::exactly(kStep);
    partner(other, *x).cosine = -x->cosine;
    EXPECT_TRUE(no_isometry(plane_, list, other)) << trial;
    other = image.list;
    other.points[i][0].along += Ball::exactly(kStep);
    EXPECT_TRUE(no_isometry(plane_, list, other)) << trial;
    other = image.list;
    x = &other.points[i][0];
    if (x->other == i) continue;
    x->turn = -x->turn;
    partner(other, *x).turn = -x->turn;
    EXPECT_TRUE(no_isometry(plane_, list, other)) << trial;
  }
}

TEST_F(Frames, AreAsManyForEachCrossingPointOfAGeodesic) {
  for (int trial = 0; trial < 50; ++trial) {
    const CrossingGeodesics list = any_list(random_);
    const CrossingGeodesics both = together(list, image_of(list, trial % 2 == 0 ? 1 : -1, random_).list);
    for (std::size_t i = 0; i < both.points.size(); ++i) {
      const std::uint64_t frames = possible_frames(plane_, both, i, 0);
      for (std::size_t k = 1; k < both.points[i].size(); ++k) EXPECT_EQ(possible_frames(plane_, both, i, k), frames);
    }
  }
}

// Crossing points.

GeodesicsDocument list_of(const std::string& name) {
  return read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) + "/geodesics/" + name + ".json");
}

TEST(CrossingPoints, AreOnBothGeodesicsThatCross) {
  const GeodesicsDocument document = list_of("octagon-5-to-6");
  const LabelParts parts = label_parts(check_surface(document.net.surface, 1).crossings, document.net.charts, {});
  const GeodesicsInNet geodesics(document, parts);
  const Precision precision(128);
  const LiftedPlane plane = geodesics.plane(128, 1024, 1);
  const auto found = geodesics.crossings(plane, 1);
  ASSERT_TRUE(found);
  std::size_t of_itself = 0;
  for (std::uint32_t i = 0; i < found->points.size(); ++i) {
    bool crosses_itself = false;
    for (std::uint32_t k = 0; k < found->points[i].size(); ++k) {
      const CrossingPoint& x = found->points[i][k];
      const CrossingPoint& y = found->points.at(x.other).at(x.place);
      EXPECT_EQ(y.other, i);
      EXPECT_EQ(y.place, k);
      EXPECT_EQ(y.turn, -x.turn);
      EXPECT_TRUE(arb_contains_zero((x.cosine + y.cosine).get()));
      crosses_itself = crosses_itself || x.other == i;
    }
    EXPECT_EQ(crosses_itself, !document.geodesics[i].simple) << i;
    if (crosses_itself) ++of_itself;
  }
  EXPECT_GT(of_itself, 0U);
}

TEST(CrossingPoints, AreAllOrNoneHoweverFewBitsThereAre) {
  GeodesicsDocument document = list_of("octagon-5-to-6");
  // One is given from far away, and takes more bits than the others.
  std::vector<std::uint32_t>& word = document.geodesics[1].word;
  std::vector<std::uint32_t> detour;
  for (std::uint32_t k = 0; k < 8; ++k) detour.push_back(k % 3);
  word = joined(joined(detour, word), reversed(document.net, detour));
  const LabelParts parts = label_parts(check_surface(document.net.surface, 1).crossings, document.net.charts, {});
  const GeodesicsInNet geodesics(document, parts);
  const auto at_precision = [&](slong bits) {
    const Precision precision(bits);
    const LiftedPlane plane = geodesics.plane(bits, 1024, 1);
    return geodesics.crossings(plane, 1);
  };
  const auto expected = at_precision(512);
  ASSERT_TRUE(expected);
  int found = 0;
  int none = 0;
  for (slong bits = 10; bits < 300; bits += bits < 80 ? 2 : 20) {
    const auto points = at_precision(bits);
    ++(points ? found : none);
    if (!points) continue;
    for (std::size_t i = 0; i < expected->points.size(); ++i) {
      EXPECT_TRUE(arb_overlaps(points->lengths[i].get(), expected->lengths[i].get()));
      ASSERT_EQ(points->points[i].size(), expected->points[i].size()) << bits;
      for (std::size_t k = 0; k < points->points[i].size(); ++k) {
        const CrossingPoint& x = points->points[i][k];
        const CrossingPoint& y = expected->points[i][k];
        EXPECT_TRUE(arb_contains(x.along.get(), y.along.get())) << bits;
        EXPECT_TRUE(arb_contains(x.cosine.get(), y.cosine.get())) << bits;
        EXPECT_EQ(std::pair(x.other, x.place), std::pair(y.other, y.place));
        EXPECT_EQ(x.turn, y.turn);
      }
    }
  }
  EXPECT_GT(found, 5);
  EXPECT_GT(none, 5);
}

}  // namespace
}  // namespace epsnet::certify::frames_test
