#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <vector>

#include "netgen/nets/triangulations.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/mesh/operations.h"

/// Contraction of edges, moves of vertices, and the start that they make.
namespace epsnet::contraction_test {
namespace {

using test::any_index;
using test::any_share;

VertexId start_of(const Triangulation& t, Dart d) { return t.corner(d).vertex; }
VertexId end_of(const Triangulation& t, Dart d) { return start_of(t, next_dart(d)); }

Dart any_dart(const Triangulation& t) { return make_dart(test::any_triangle(t), any_index(3u)); }

/// A triangulation of a surface, flipped at random.
Triangulation any_triangulation(const Surface& surface) {
  Triangulation result = test::any_delaunay(surface, any_index(8u));
  for (std::uint32_t flips = any_index(6u); flips > 0; --flips) {
    const Dart d = any_dart(result);
    if (test::flippable(result, d)) (void)flip(result, d);
  }
  return result;
}

std::string problem_of(Triangulation triangulation) { return problem(triangulation); }

TEST(Star, IsTheDartsThatLeaveAVertex) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const Triangulation t(named.surface);
    for (const VertexId v : t.vertices()) {
      std::vector<Dart> leaving;
      for (const TriangleId s : t.triangles()) {
        for (std::uint32_t i = 0; i < 3; ++i) {
          if (start_of(t, make_dart(s, i)) == v) {
            leaving.push_back(make_dart(s, i));
          }
        }
      }
      std::vector<Dart> star = t.star(leaving.front());
      std::sort(star.begin(), star.end());
      EXPECT_EQ(star, leaving) << named.name;
    }
  }
}

RC_GTEST_PROP(ContractionProperty, LeavesATriangulationOrEverything, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  Triangulation t = any_triangulation(surface);
  const Dart d = any_dart(t);
  const VertexId v = start_of(t, d);
  const VertexId w = end_of(t, d);
  const Vertex end = t.vertex(w);
  const auto vertices = t.vertex_count();
  const auto before = test::snapshot(t);
  const auto merged = contract(t, d);
  RC_CLASSIFY(merged.has_value(), "contracted");
  RC_CLASSIFY(v == w, "loop");
  if (!merged) {
    RC_ASSERT(test::snapshot(t) == before);
    return;
  }
  RC_ASSERT(v != w);
  RC_ASSERT(t.vertex_count() == vertices - 1);
  RC_ASSERT(problem(t) == "");
  RC_ASSERT(std::abs(test::total_area(t) - test::area_of(surface)) < 1e-9);
  // The end is where it was.
  const Vertex left = t.vertex(start_of(t, *merged));
  RC_ASSERT(left.z == end.z);
  RC_ASSERT(left.chart == end.chart);
}

RC_GTEST_PROP(ContractionProperty, AllAtOnceLeaveATriangulation, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  Triangulation t = test::any_delaunay(surface, any_index(40u));
  const auto vertices = t.vertex_count();
  const std::uint32_t kept = any_index(3u);
  std::uint32_t asked = 0;
  const auto goes = [&](Dart d) { return start_of(t, d).number() % 3 != kept && ++asked % 2 == 0; };
  const auto before = test::snapshot(t);
  const auto removed = contract_all(t, goes);
  RC_CLASSIFY(removed > 1, "several removed");
  RC_ASSERT(t.vertex_count() == vertices - removed);
  RC_ASSERT(removed > 0 || test::snapshot(t) == before);
  RC_ASSERT(problem(t) == "");
  RC_ASSERT(std::abs(test::total_area(t) - test::area_of(surface)) < 1e-9);
}

RC_GTEST_PROP(ContractionProperty, MovesKeepTheTriangulation, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  Triangulation t = any_triangulation(surface);
  const Dart d = any_dart(t);
  const VertexId v = start_of(t, d);
  const Vertex old = t.vertex(v);
  const Complex<double> step =
      std::ldexp(any_share() - 0.5, -static_cast<int>(any_index(8u))) * Complex<double>{1, any_share()};
  const Complex<double> target = old.z + step;
  RC_PRE(norm(target) < kChartRadius * kChartRadius);
  const auto before = test::snapshot(t);
  const bool moved = move_vertex(t, d, {old.chart, target, kIdentity});
  RC_CLASSIFY(moved, "moved");
  if (!moved) {
    RC_ASSERT(test::snapshot(t) == before);
    return;
  }
  RC_ASSERT(problem(t) == "");
  RC_ASSERT(t.vertex(v).z == target);
  RC_ASSERT(std::abs(test::total_area(t) - test::area_of(surface)) < 1e-9);
}

bool is_delaunay(Triangulation& t) {
  for (const TriangleId s : t.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (!t.is_delaunay(make_dart(s, i))) {
        return false;
      }
    }
  }
  return true;
}

RC_GTEST_PROP(StartProperty, IsAPacking, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  Triangulation t = test::any_delaunay(surface, any_index(20u));
  const Rational epsilon(1 + any_index(60u), 20);
  const Threshold apart(epsilon / 2);
  const auto vertices = t.vertex_count();
  const auto removed = reduce_to_packing(t, apart);
  RC_CLASSIFY(removed > 0, "removed");
  RC_ASSERT(t.vertex_count() == vertices - removed);
  RC_ASSERT(t.vertex_count() >= 1U);
  RC_ASSERT(problem(t) == "");
  RC_ASSERT(is_delaunay(t));
  for (const TriangleId s : t.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (start_of(t, make_dart(s, i)) != end_of(t, make_dart(s, i))) {
        RC_ASSERT(t.compare_distance(t.corner(s, i), t.corner(s, next(i)), apart) > 0);
      }
    }
  }
}

RC_GTEST_PROP(StartProperty, OneVertexInItsPlace, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  Triangulation t = test::any_delaunay(surface, any_index(20u));
  const Vertex base = t.vertex(VertexId(0));
  (void)reduce_to_vertex_0(t);
  RC_ASSERT(t.vertex_count() == 1U);
  RC_ASSERT(t.triangle_count() == 4 * surface.genus() - 2);
  RC_ASSERT(t.vertex(VertexId(0)).z == base.z);
  RC_ASSERT(t.vertex(VertexId(0)).chart == base.chart);
  RC_ASSERT(problem(t) == "");
  RC_ASSERT(is_delaunay(t));
}

// ---- Base points ----

TEST(BasePoint, IsVertex0AndItsTileIsItsStar) {
  const Surface& surface = test::tiled_gallery().back().surface;
  Complex<Rational> centre{};
  for (const Complex<Rational>& z : surface.tiles()[2]) {
    centre = centre + Rational(1, 7) * z;
  }
  // The Euclidean mean of the vertices need not be inside of a hyperbolic polygon; here it is.
  Triangulation t(surface, BasePoint{TileId(2), centre});
  EXPECT_EQ(problem(t), "");
  EXPECT_EQ(t.vertex_count(), surface.vertex_class_count() + 1);
  EXPECT_EQ(t.atlas().charts()[t.vertex(VertexId(0)).chart].centre, centre);
  (void)make_delaunay(t);
  (void)reduce_to_vertex_0(t);
  EXPECT_EQ(t.vertex_count(), 1U);
  EXPECT_EQ(problem(t), "");
}

TEST(BasePoint, CentresOfTilesAreInside) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    for (const TileId tile : named.surface.tile_ids()) {
      EXPECT_EQ(problem_of(Triangulation(named.surface, centre_of_tile(named.surface, tile))), "") << named.name;
    }
    EXPECT_THROW((void)centre_of_tile(named.surface, TileId(1000)), SurfaceError);
  }
}

TEST(BasePoint, MustBeInsideOfItsTile) {
  const Surface octagon = random_octagon(1);
  EXPECT_EQ(problem_of(Triangulation(octagon, BasePoint{TileId(0), {0, 0}})), "");
  EXPECT_THROW(Triangulation(octagon, BasePoint{TileId(1), {0, 0}}), SurfaceError);
  EXPECT_THROW(Triangulation(octagon, BasePoint{TileId(0), {2, 0}}), SurfaceError);
  EXPECT_THROW(Triangulation(octagon, BasePoint{TileId(0), octagon.tiles()[0][0]}), SurfaceError);
}

TEST(RegularSurface, HasOneVertexAndNeedsNoFlip) {
  for (const std::uint32_t genus : {2u, 3u, 6u}) {
    const Surface surface = Surface::regular(genus);
    Triangulation t(surface);
    EXPECT_EQ(problem(t), "");
    EXPECT_EQ(t.vertex_count(), 1U);
    EXPECT_EQ(make_delaunay(t), 0U);
    EXPECT_EQ(problem_of(Triangulation(surface, BasePoint{TileId(0), {0, 0}})), "");
    EXPECT_EQ(Triangulation(surface, BasePoint{TileId(0), {0, Rational(1, 9)}}).vertex_count(), 2U)
        << "and the vertex class";
    EXPECT_THROW(Triangulation(surface, BasePoint{TileId(0), {0, Rational(99, 100)}}), SurfaceError);
  }
}

TEST(RegularSurface, CrossingsTakeSideToSide) {
  for (const std::uint32_t genus : {2u, 3u, 20u}) {
    const Surface surface = Surface::regular(genus);
    const Tile& tile = surface.tiles()[0];
    const auto n = static_cast<std::uint32_t>(tile.size());
    ASSERT_EQ(n, 4 * genus);
    for (std::uint32_t s = 0; s < n; ++s) {
      const std::uint32_t other = surface.partner(SideId(s)).number();
      EXPECT_EQ(other, (s + n / 2) % n);
      const auto g = surface.crossing_as<Mp1024>(SideId(s));
      const auto at = [&](std::uint32_t k) { return convert<Mp1024>(tile[k % n]); };
      EXPECT_LT(norm(g(at(s)) - at(other + 1)), Mp1024(1e-140));
      EXPECT_LT(norm(g(at(s + 1)) - at(other)), Mp1024(1e-140));
      EXPECT_LT(abs(g.determinant() - 1), Mp1024(1e-280));
    }
  }
  EXPECT_THROW((void)Surface::regular(1), SurfaceError);
  EXPECT_THROW((void)Surface::regular(1001), SurfaceError);
}

}  // namespace
}  // namespace epsnet::contraction_test
