#include <gtest/gtest.h>

#include "netgen/isometries/isometries.h"
#include "netgen/surfaces/maps_and_covers.h"

namespace epsnet::slow_isometries_test {
namespace {

TEST(Isometries, OfTheFrickeMacbeathCurve) {
  const Surface surface = named_surface("fricke-macbeath");
  const IsometryGroup group = isometries(surface);
  EXPECT_EQ(group.orientation_preserving(), 504U);
  EXPECT_EQ(group.size(), 1008U);
  EXPECT_EQ(certified_isometries(surface, group).certificate.verdict, certify::Verdict::verified);
}

TEST(Isometries, OfARegularPolygonOfHigherGenus) {
  const Surface surface = Surface::regular(10);
  const IsometryGroup group = isometries(surface);
  EXPECT_EQ(group.orientation_preserving(), 80U);
  EXPECT_EQ(group.size(), 160U);
  EXPECT_EQ(certified_isometries(surface, group).certificate.verdict, certify::Verdict::verified);
}

}  // namespace
}  // namespace epsnet::slow_isometries_test
