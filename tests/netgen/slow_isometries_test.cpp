#include <gtest/gtest.h>

#include "netgen/isometries/isometries.h"
#include "netgen/surfaces/named_maps.h"

namespace epsnet {
namespace {

TEST(Isometries, OfTheFrickeMacbeathCurve) {
  const IsometryGroup group = isometries(named_surface("fricke-macbeath"));
  EXPECT_EQ(group.orientation_preserving(), 504U);
  EXPECT_EQ(group.size(), 1008U);
}

TEST(Isometries, OfARegularPolygonOfHigherGenus) {
  const IsometryGroup group = isometries(Surface::regular(10));
  EXPECT_EQ(group.orientation_preserving(), 80U);
  EXPECT_EQ(group.size(), 160U);
}

}  // namespace
}  // namespace epsnet
