#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>

#include "netgen/exchange/text_formats.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"

namespace epsnet::octagon_test {
namespace {

TEST(Octagon, IsWhatCgalPrintsForTheSeed) {
  const auto files = test::data_files("octagons");
  ASSERT_EQ(files.size(), 62U);
  for (const auto& path : files) {
    const std::string name = path.stem().string();
    const auto seed = static_cast<std::int32_t>(std::stol(name.substr(name.rfind('-') + 1)));
    EXPECT_EQ(write_domain(random_octagon(seed)), test::file_text(path)) << path;
  }
}

TEST(Octagon, EveryExtremeSeedGivesASurface) {
  EXPECT_EQ(random_octagon(0).genus(), 2U);
  EXPECT_EQ(random_octagon(std::numeric_limits<std::int32_t>::max()).genus(), 2U);
  EXPECT_EQ(random_octagon(std::numeric_limits<std::int32_t>::min()).genus(), 2U);
}

TEST(Octagon, ASymmetricOctagonOfAnotherAreaIsRefused) {
  const Surface surface = random_octagon(321);
  std::array<Complex<Rational>, 4> half;
  std::copy_n(surface.tiles()[0].begin(), 4, half.begin());
  EXPECT_EQ(symmetric_octagon(half).tiles(), surface.tiles());
  half[3].x += Rational(1, 1000);
  EXPECT_THROW(static_cast<void>(symmetric_octagon(half)), SurfaceError);
}

TEST(Octagon, ClosesUpWhereTheLastVertexIsMoved) {
  const Surface surface = random_octagon(321);
  std::array<Complex<Rational>, 4> half;
  std::copy_n(surface.tiles()[0].begin(), 4, half.begin());
  EXPECT_EQ(closed_up(half), half);
  // Along the line through −z0 and z3, and turned: z0 need not be real.
  const Isometry<Rational> there = Isometry<Rational>::translation(-half[0]);
  std::array<Complex<Rational>, 4> moved = half;
  moved[3] = there(Rational(9, 10) * inverse(there)(half[3]));
  EXPECT_EQ(closed_up(moved), half);
  const Complex<Rational> turn{Rational(3, 5), Rational(4, 5)};
  for (auto* points : {&half, &moved}) {
    for (Complex<Rational>& z : *points) z = turn * z;
  }
  EXPECT_EQ(closed_up(moved), half);
  EXPECT_EQ(symmetric_octagon(half).genus(), 2U);
  // Nothing on the line through −z0 and z3 if they are one point.
  moved[3] = -moved[0];
  EXPECT_FALSE(closed_up(moved).has_value());
}

RC_GTEST_PROP(OctagonProperty, EverySeedGivesTheSameSurfaceOfGenusTwoTwice, (std::int32_t seed)) {
  const Surface surface = random_octagon(seed);
  RC_ASSERT(surface.genus() == 2U);
  RC_ASSERT(surface.vertex_class_count() == 1U);
  RC_ASSERT(random_octagon(seed).tiles() == surface.tiles());
}

}  // namespace
}  // namespace epsnet::octagon_test
