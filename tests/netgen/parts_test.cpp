#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <rapidcheck/gtest.h>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/check.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/mesh/insertion.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"

namespace epsnet::parts_test {
namespace {

using test::any_index;
using test::any_share;

/// A net of a surface for a multiple of ε, in which the triangles too large for ε are marked; parts start from it.
struct CoarseNet {
  CoarseNet(const Surface& surface, double epsilon, double coarser)
      : triangulation(triangulated_net(surface, Length(epsilon * coarser)).triangulation),
        apart(Length(epsilon).value() / 2),
        large(Length(epsilon).value()) {
    for (const TriangleId t : triangulation.triangles()) {
      if (triangulation.compare_circumradius(t, large) > 0) {
        mark(triangulation, t);
        pending.push_back(t);
      }
    }
  }

  /// Unless another number is given, expects as many vertices as give about 33 parts.
  [[nodiscard]] PartResult refine(unsigned threads, double expected = 1 << 20) {
    return refine_in_parts(triangulation, pending, apart, large, {expected, threads, report});
  }
  void make_room(std::size_t vertices) { triangulation.reserve(vertices); }

  Triangulation triangulation;
  Threshold apart;
  Threshold large;
  std::vector<TriangleId> pending;
  std::function<void(std::size_t)> report = [](std::size_t) {};
};

void require_delaunay(Triangulation& triangulation) {
  RC_ASSERT(problem(triangulation) == "");
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) RC_ASSERT(triangulation.is_delaunay(make_dart(t, i)));
  }
}

/// The nearest other vertex is a Delaunay neighbour.
void require_apart(Triangulation& triangulation, const Threshold& apart) {
  for (const TriangleId t : triangulation.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Corner a = triangulation.corner(t, i);
      const Corner b = triangulation.corner(t, next(i));
      RC_ASSERT(a.vertex == b.vertex || triangulation.compare_distance(a, b, apart) > 0);
    }
  }
}

/// Exactly the large triangles are marked and pending.
void require_that_nothing_large_is_forgotten(CoarseNet& net, const PartResult& result) {
  std::map<TriangleId, bool> pending;
  for (const TriangleId t : result.pending) pending[t] = true;
  for (const TriangleId t : net.triangulation.triangles()) {
    const bool is_large = net.triangulation.compare_circumradius(t, net.large) > 0;
    RC_ASSERT(is_large == pending.contains(t));
    RC_ASSERT(is_large == net.triangulation.triangle(t).marked());
  }
}

RC_GTEST_PROP(PartsProperty, LeaveADelaunayTriangulationOfPointsThatAreApart, ()) {
  CoarseNet net(test::any_tiled_surface().surface, 0.1 + 0.1 * any_share(), 2 + 4 * any_share());
  const std::uint32_t before = net.triangulation.vertex_count();
  net.make_room(20'000);
  const PartResult result = net.refine(1 + any_index(4U));
  RC_CLASSIFY(result.insertions > 0, "inserted");
  RC_ASSERT(net.triangulation.vertex_count() == before + result.insertions);
  require_delaunay(net.triangulation);
  require_apart(net.triangulation, net.apart);
  require_that_nothing_large_is_forgotten(net, result);
}

// Parts are written back while others are refined, so the arrays may not move: a part without room is discarded.
RC_GTEST_PROP(PartsProperty, LeaveASoundTriangulationWhereThereIsNoRoom, ()) {
  CoarseNet net(test::any_tiled_surface().surface, 0.1, 3);
  net.make_room(net.triangulation.vertex_count() + any_index(300U));
  const PartResult result = net.refine(1 + any_index(4U));
  require_delaunay(net.triangulation);
  require_apart(net.triangulation, net.apart);
  require_that_nothing_large_is_forgotten(net, result);
}

// Only places where labels are not known, or where the next chart begins, are left.
TEST(Parts, InsertNearlyAllWhereThereIsOne) {
  CoarseNet net(random_octagon(1), 0.02, 8);
  net.make_room(40'000);
  const PartResult result = net.refine(2, 21'000);
  EXPECT_GT(result.insertions, 20'000U);
  EXPECT_LT(result.pending.size(), 1'000U);
}

std::string bytes(const Triangulation& triangulation) {
  const Mesh& mesh = triangulation.mesh();
  const auto raw = [](const auto& values) {
    return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof *values.data());
  };
  return raw(mesh.points) + raw(mesh.charts) + raw(mesh.triangles);
}

TEST(Parts, GiveTheSameBytesForAnyNumberOfThreads) {
  for (const auto& [name, surface] : test::tiled_gallery()) {
    std::string first;
    for (const unsigned threads : {1U, 2U, 8U, 64U}) {
      CoarseNet net(surface, 0.05, 4);
      net.make_room(100'000);
      (void)net.refine(threads);
      if (threads == 1) first = bytes(net.triangulation);
      EXPECT_TRUE(bytes(net.triangulation) == first) << name << ", " << threads << " threads";
    }
  }
}

// The net is large enough to be made in parts without being asked to.
TEST(Parts, MakeNetsThatAreVerified) {
  const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::random(20, 7), 7));
  const VariantNet one = compute_variant(surface, Length("0.04"), {}, {.threads = 1});
  EXPECT_EQ(certify::check(one.document).verdict, certify::Verdict::verified);
  EXPECT_GT(one.document.vertices.size(), 100'000U);
  const VariantNet three = compute_variant(surface, Length("0.04"), {}, {.threads = 3});
  EXPECT_EQ(one.statistics.insertions, three.statistics.insertions);
  EXPECT_EQ(one.statistics.flips, three.statistics.flips);
  ASSERT_EQ(one.document.vertices.size(), three.document.vertices.size());
  for (std::size_t v = 0; v < one.document.vertices.size(); ++v) {
    ASSERT_EQ(one.document.vertices[v].x, three.document.vertices[v].x);
    ASSERT_EQ(one.document.vertices[v].y, three.document.vertices[v].y);
  }
}

TEST(Parts, MakePseudoNetsThatAreVerified) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(3, 5), 5);
  coordinates.lengths[2] = Rational(1, 1'000'000);
  const CertifiedNet net =
      certified_net(fenchel_nielsen_surface(coordinates), Length("0.0125"), {.pseudo = true, .threads = 2});
  EXPECT_GT(net.document.vertices.size(), 90'000U);
}

TEST(Parts, HandOnWhatTheCallerThrows) {
  CoarseNet net(random_octagon(1), 0.05, 8);
  net.make_room(40'000);
  net.report = [](std::size_t) { throw std::runtime_error("interrupted"); };
  EXPECT_THROW((void)net.refine(1), std::runtime_error);
}

}  // namespace
}  // namespace epsnet::parts_test
