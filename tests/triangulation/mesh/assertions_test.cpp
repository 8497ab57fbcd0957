#include <cassert>
#include <gtest/gtest.h>

#include "kernel/predicates.h"
#include "tests/support/triangulations.h"
#include "triangulation/mesh/insertion.h"
#include "triangulation/mesh/operations.h"

/// What the headers require of their callers is asserted in debug and sanitizer builds.
namespace epsnet::assertions_test {
namespace {

TEST(Assertions, AreOnInDebugAndSanitizerBuildsAlone) {
  bool on = false;
  assert((on = true));
  EXPECT_EQ(on, EPSNET_ASSERTIONS == 1);
}

#ifndef NDEBUG

Triangulation octagon() {
  Triangulation result(test::gallery()[0].surface);
  make_delaunay(result);
  return result;
}

TEST(AssertionsDeathTest, ADartHasATriangleAndACornerOfThree) {
  std::uint32_t three = 3;
  EXPECT_DEATH((void)make_dart(TriangleId(0), three), "corner < 3");
  EXPECT_DEATH((void)make_dart(TriangleId(kLargestTriangle.number() + three), 0), "kLargestTriangle");
  EXPECT_DEATH((void)corner_of(Dart{three}), "corner < 3");
  EXPECT_DEATH((void)next(three), "i < 3");
  EXPECT_DEATH((void)previous(three), "i < 3");
}

TEST(AssertionsDeathTest, ALabelIsThereAndNotTheIdentity) {
  const Triangulation triangulation = octagon();
  const Atlas& atlas = triangulation.atlas();
  for (const LabelId l : {kIdentity, atlas.labels().count(), kUnknownLabel}) {
    EXPECT_DEATH((void)atlas.labels()[l].from, "has");
    EXPECT_DEATH((void)atlas.labels()[l].to, "has");
    EXPECT_DEATH((void)atlas.labels()[l].word, "has");
    EXPECT_DEATH((void)atlas.isometry(l), "has");
    EXPECT_DEATH((void)atlas.error(l), "has");
  }
  EXPECT_DEATH((void)atlas.known_inverse(kUnknownLabel), "has");
  EXPECT_DEATH((void)atlas.charts()[ChartId(atlas.charts().count())], "count");
}

TEST(AssertionsDeathTest, ALabelLeadsWhereTheNextOneStarts) {
  const Surface& surface = test::gallery()[0].surface;
  Atlas atlas(surface);
  const ChartId corner = atlas.add_chart({TileId(0), surface.tiles()[0][0]});
  const ChartId middle = atlas.add_chart({TileId(0), {}});
  const LabelId g = atlas.label(corner, middle, {});
  EXPECT_DEATH((void)atlas.product(g, g), "to == .*from");
  EXPECT_DEATH((void)atlas.known_product(g, g), "to == .*from");
  EXPECT_DEATH((void)atlas.power(g, 2), "from == .*to");
  EXPECT_DEATH((void)atlas.label(corner, middle, {SideId(surface.side_count())}), "is_path");
  EXPECT_DEATH((void)atlas.add_chart({TileId(1), {}}), "tiles");
  EXPECT_DEATH((void)atlas.add_chart({TileId(0), {Rational(1), Rational(0)}}), "norm");
}

TEST(AssertionsDeathTest, ASurfaceHasTheSide) {
  const Surface& surface = test::gallery()[0].surface;
  EXPECT_DEATH((void)surface.side_number(TileId(1), 0), "tiles");
  EXPECT_DEATH((void)surface.side_number(TileId(0), surface.side_count()), "tiles");
  EXPECT_DEATH((void)surface.partner(SideId(surface.side_count())), "side_count");
  EXPECT_DEATH((void)surface.crossing(SideId(surface.side_count())), "side_count");
}

TEST(AssertionsDeathTest, ATriangulationHasTheElement) {
  const Triangulation triangulation = octagon();
  EXPECT_DEATH((void)triangulation.opposite(kOutside), "triangle_count");
  EXPECT_DEATH((void)triangulation.triangle(TriangleId(triangulation.triangle_count())), "triangle_count");
  EXPECT_DEATH((void)triangulation.corner(TriangleId(0), 3), "i < 3");
  EXPECT_DEATH((void)triangulation.vertex(VertexId(triangulation.vertex_count())), "vertex_count");
  EXPECT_DEATH((void)triangulation.triangle(TriangleId(0)).label(3), "corner < 3");
  EXPECT_DEATH((void)Triangle::packed(kLargestLabel + 1, kIdentity), "kLargestLabel");
}

TEST(AssertionsDeathTest, AFlipNeedsAConvexQuadrilateral) {
  // Around a vertex inside of a triangle the two triangles beside each edge make a corner of more than π.
  Triangulation triangulation = octagon();
  const LiftedPoint place = test::weighted_point(triangulation, TriangleId(0), {1, 1, 1});
  const VertexId v = add_vertex(triangulation, {place.z, place.chart});
  const TriangleId t = split_face(triangulation, TriangleId(0), v, place.label)[0];
  EXPECT_DEATH((void)flip(triangulation, make_dart(t, 0)), "may_be_left");
}

TEST(AssertionsDeathTest, AVertexIsInsertedWhereItIs) {
  // A point of triangle 0, as if it lay in the triangle beside it.
  Triangulation triangulation = octagon();
  const LiftedPoint place = test::weighted_point(triangulation, TriangleId(0), {1, 1, 1});
  const VertexId v = add_vertex(triangulation, {place.z, place.chart});
  const TriangleId t = triangle_of(triangulation.opposite(make_dart(TriangleId(0), 0)));
  const LabelId across = triangulation.transition(triangulation.opposite(make_dart(TriangleId(0), 0)));
  const LabelId label = triangulation.product(across, place.label);
  EXPECT_DEATH((void)split_face(triangulation, t, v, label), "may_be_left");
}

TEST(AssertionsDeathTest, AThresholdIsOfAPositiveNumber) {
  EXPECT_DEATH((void)Threshold(Rational(0)), "x_ > 0");
  EXPECT_DEATH((void)Threshold(Rational(-1, 2)), "x_ > 0");
}

TEST(AssertionsDeathTest, TheStageWithoutDivisionsIsForPointsNearTheOrigin) {
  const Complex<double> near{0, 0};
  const Complex<double> far{0.76, 0};
  EXPECT_DEATH((void)distance_stage_near_origin(near, far, 0.5), "is_near_origin");
  EXPECT_DEATH((void)circumradius_stage_near_origin(near, far, Complex<double>{0, 0.1}, 0.5), "is_near_origin");
  EXPECT_DEATH((void)distance_stage<double>(near, far, 0.6, 0.5, 0), "s_high");
}

#endif

}  // namespace
}  // namespace epsnet::assertions_test
