#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "kernel/plane.h"
#include "netgen/distances/distances.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/surface/surface.h"

namespace epsnet::locate_test {
namespace {

using certify::NetDocument;
using Place = PointLocation::Place;

TEST(Locate, FindsVerticesMidpointsAndCentroids) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const NetDocument net = compute_net(named.surface, Length("0.9")).document;
    Locator locator(net);
    for (std::uint32_t t = 0; t < net.triangles.size(); t += 31) {
      const PointLocation inside = locator.locate(point_of_triangle(named.surface, net, t, {1, 1, 1}));
      EXPECT_EQ(inside.triangle, t) << named.name;
      EXPECT_EQ(inside.place, Place::inside) << named.name;
      for (const double weight : inside.weights) EXPECT_NEAR(weight, 1.0 / 3, 1e-12) << named.name;

      // As the point is rounded, it need not be on the side itself.
      const PointLocation beside = locator.locate(point_of_triangle(named.surface, net, t, {0, 1, 1}));
      EXPECT_TRUE(beside.triangle == t || beside.triangle == net.triangles[t].opposite[1] / 3) << named.name;

      const std::uint32_t v = net.triangles[t].vertex[2];
      const PointLocation corner = locator.locate(point_of_triangle(named.surface, net, t, {0, 0, 5}));
      EXPECT_EQ(corner.place, Place::corner) << named.name;
      EXPECT_EQ(net.triangles[corner.triangle].vertex[corner.number], v) << named.name;
      EXPECT_EQ(corner.nearest_corner(), corner.number) << named.name;
      EXPECT_EQ(corner.distances[corner.number], 0) << named.name;
    }
  }
}

/// The weights of a point, used again, give the point; a covering has a corner within ε.
TEST(Locate, GivesWeightsAndANearCorner) {
  const Surface surface = random_octagon(123);
  const NetDocument net = compute_net(surface, Length("0.4")).document;
  Locator locator(net);
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      const BasePoint point{TileId(0), {Rational(x, 20), Rational(y, 20)}};
      const PointLocation found = locator.locate(point);
      EXPECT_LT(found.distances[found.nearest_corner()], 0.4);
      EXPECT_NEAR(found.weights[0] + found.weights[1] + found.weights[2], 1, 1e-14);
      std::array<Rational, 3> weights;
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GE(found.weights[i], 0);
        weights[i] = Rational(found.weights[i]);
      }
      const BasePoint again = point_of_triangle(surface, net, found.triangle, weights);
      EXPECT_EQ(again.tile, TileId(0));
      EXPECT_LT(distance(convert<Mp256>(again.z), convert<Mp256>(point.z)), 1e-13);
    }
  }
}

TEST(Locate, APointBeyondASideOfItsTileIsThatOfTheNeighbour) {
  const Surface surface = random_octagon(123);
  Locator locator(compute_net(surface, Length("0.8")).document);
  const BasePoint outside{TileId(0), {Rational(9, 10), Rational(3, 10)}};
  const BasePoint point = in_its_tile(surface, outside);
  EXPECT_THROW(require_inside(surface, outside), SurfaceError);
  EXPECT_NO_THROW(require_inside(surface, point));
  EXPECT_EQ(locator.locate(outside).triangle, locator.locate(point).triangle);
  EXPECT_NEAR(locator.locate(outside).weights[0], locator.locate(point).weights[0], 1e-12);
}

TEST(Locate, WhatIsNoPointOfTheSurfaceIsAnError) {
  Locator locator(compute_net(random_octagon(123), Length("0.8")).document);
  EXPECT_THROW((void)locator.locate({TileId(0), {1, 0}}), SurfaceError);
  EXPECT_THROW((void)locator.locate({TileId(1), {0, 0}}), SurfaceError);
}

TEST(Locate, PointsOfTrianglesThatThereAreNot) {
  const Surface surface = random_octagon(123);
  const NetDocument net = compute_net(surface, Length("0.8")).document;
  const auto count = static_cast<std::uint32_t>(net.triangles.size());
  EXPECT_THROW((void)point_of_triangle(surface, net, count, {1, 1, 1}), NetError);
  EXPECT_THROW((void)point_of_triangle(surface, net, 0, {0, 0, 0}), NetError);
  EXPECT_THROW((void)point_of_triangle(surface, net, 0, {1, 1, -1}), NetError);
}

/// Given points are the first vertices, exactly where they are, and the net is verified.
TEST(GivenPoints, AreVertices) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    std::vector<BasePoint> points;
    for (const TileId tile : named.surface.tile_ids()) {
      points.push_back(centre_of_tile(named.surface, tile));
    }
    points[0].z = points[0].z + Complex<Rational>{Rational(1, 1'000'003), 0};
    const Length epsilon("0.05");
    const auto made = [&]() -> std::optional<CertifiedNet> {
      try {
        return certified_net(named.surface, epsilon, {.points = points});
      } catch (const ClosePointsError&) {
        return std::nullopt;  // Tiles as thin as that.
      }
    };
    if (named.surface.genus() > 3) continue;  // Time.
    const auto net = made();
    if (!net) continue;
    for (std::uint32_t v = 0; v < points.size(); ++v) {
      const BasePoint vertex = point_of_vertex(named.surface, net->document, v);
      EXPECT_EQ(vertex.tile, points[v].tile) << named.name;
      EXPECT_EQ(vertex.z, points[v].z) << named.name;
    }
  }
}

TEST(GivenPoints, MayNotBeTooClose) {
  const Surface surface = random_octagon(123);
  const auto error = [&](const NetOptions& options) -> std::pair<std::uint32_t, std::uint32_t> {
    try {
      (void)compute_net(surface, Length("0.3"), options);
    } catch (const ClosePointsError& close) {
      return {close.first(), close.second()};
    }
    return {0, 0};
  };
  const BasePoint a{TileId(0), {0, 0}};
  const BasePoint b{TileId(0), {Rational(1, 3), 0}};
  const BasePoint near_b{TileId(0), {Rational(1, 3), Rational(1, 10)}};
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  EXPECT_EQ(error({.points = {a, b}}), Pair(0, 0));
  EXPECT_EQ(error({.points = {a, b, near_b}}), Pair(1, 2));
  EXPECT_EQ(error({.points = {a, b, a}}), Pair(0, 2));
  EXPECT_EQ(error({.base = a, .points = {b, near_b}}), Pair(1, 2));
  EXPECT_EQ(error({.base = b, .points = {near_b}}), Pair(0, 1));
  EXPECT_THROW((void)compute_net(surface, Length("0.3"), {.points = {{TileId(0), {1, 0}}}}), SurfaceError);
  EXPECT_THROW((void)compute_net(surface, Length("0.3"), {.points = {a}, .pseudo = true}), std::invalid_argument);
}

}  // namespace
}  // namespace epsnet::locate_test
