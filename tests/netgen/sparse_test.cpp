#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "netgen/base/gmp.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/mesh/operations.h"

/// Nets with few points, and the relaxation that they are made with.
namespace epsnet::sparse_test {
namespace {

using test::any_index;
using test::any_share;

const NetOptions kSparse{.sparse = true, .check = {.threads = 1}};

std::string text_of(const certify::NetDocument& net) {
  std::ostringstream out;
  certify::write_file(net, out);
  return out.str();
}

double times_lower_bound(const certify::NetDocument& net, std::uint32_t genus) {
  return static_cast<double>(net.vertices.size()) / least_vertices(genus, std::stod(net.epsilon));
}

bool is_delaunay(Triangulation& t) {
  for (const TriangleId s : t.triangles()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (!t.is_delaunay(make_dart(s, i))) return false;
    }
  }
  return true;
}

/// The largest of the circumradii, as sinh²R, by halving.
double largest_sinh2(Triangulation& t, double least, double most) {
  for (int halvings = 0; halvings < 30; ++halvings) {
    const double middle = (least + most) / 2;
    const Threshold threshold{Rational(std::asinh(std::sqrt(middle)))};
    bool any = false;
    for (const TriangleId s : t.triangles()) any = any || t.compare_circumradius(s, threshold) > 0;
    (any ? least : most) = middle;
  }
  return most;
}

/// The Delaunay triangulation of a net of a surface.
Triangulation net_triangulation(const Surface& surface, const char* epsilon) {
  return triangulated_net(surface, Length(epsilon)).triangulation;
}

RC_GTEST_PROP(RelaxationProperty, LeavesADelaunayTriangulation, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  Triangulation t = test::any_delaunay(surface, any_index(40u));
  const auto vertices = t.vertex_count();
  // The steps may also be far too long, so that triangles would turn over and vertices leave their charts.
  const RelaxationSweep sweep{any_index(20u), std::ldexp(any_share(), static_cast<int>(any_index(5u))), any_share()};
  const std::vector<RelaxationSweep> sweeps(1 + any_index(4u), sweep);
  (void)relax(t, Threshold(Rational(1, 1 + any_index(10))), sweeps);
  RC_ASSERT(t.vertex_count() == vertices);
  RC_ASSERT(problem(t) == "");
  RC_ASSERT(is_delaunay(t));
  RC_ASSERT(std::abs(test::total_area(t) - test::area_of(surface)) < 1e-9);
}

RC_GTEST_PROP(RelaxationProperty, KeepsAVertexInItsPlace, ()) {
  Triangulation t = test::any_delaunay(test::any_tiled_surface().surface, 1 + any_index(20u));
  const VertexId kept = test::any_vertex(t);
  const Vertex before = t.vertex(kept);
  const std::array<RelaxationSweep, 2> sweeps{{{2, 0.5, 0}, {2, 0.5, 0.5}}};
  (void)relax(t, Threshold(Rational(1, 4)), sweeps, kept);
  RC_ASSERT(t.vertex(kept).z == before.z);
  RC_ASSERT(t.vertex(kept).chart == before.chart);
}

TEST(Relaxation, NothingMovesWithoutAStep) {
  Triangulation t = net_triangulation(random_octagon(1), "0.2");
  const auto before = test::snapshot(t);
  const std::vector<RelaxationSweep> sweeps(3, {4, 0, 0});
  EXPECT_EQ(relax(t, Threshold(Rational(1, 5)), sweeps), 0U);
  EXPECT_EQ(test::snapshot(t), before);
}

TEST(Relaxation, MakesTheLargestCircleSmaller) {
  for (const test::NamedSurface& named : {test::gallery()[0], test::gallery()[8]}) {
    Triangulation t = net_triangulation(named.surface, "0.2");
    const double before = largest_sinh2(t, 0, 1);
    const std::vector<RelaxationSweep> sweeps(20, {8, 0.2, 0.5});
    (void)relax(t, Threshold(Rational(1, 5)), sweeps);
    EXPECT_LT(largest_sinh2(t, 0, 1), 0.9 * before) << named.name;
  }
}

RC_GTEST_PROP(RenumberingProperty, ChangesNumbersAlone, ()) {
  const Surface& surface = test::any_tiled_surface().surface;
  Triangulation t = test::any_delaunay(surface, any_index(40u));
  const Vertex first = t.vertex(VertexId(0));
  const auto vertices = t.vertex_count();
  renumber_by_neighbours(t);
  RC_ASSERT(t.vertex_count() == vertices);
  RC_ASSERT(problem(t) == "");
  RC_ASSERT(is_delaunay(t));
  RC_ASSERT(t.vertex(VertexId(0)).z == first.z);
  RC_ASSERT(t.vertex(VertexId(0)).chart == first.chart);
  // Each triangle but the first has a neighbour before it.
  for (const TriangleId s : t.triangles()) {
    if (s == TriangleId(0)) continue;
    TriangleId least = s;
    for (const Dart d : t.triangle(s).opposite) least = std::min(least, triangle_of(d));
    RC_ASSERT(least < s);
  }
}

TEST(SparseNet, HasAtMostOneAndAHalfTimesTheLowerBound) {
  for (const std::int32_t seed : {1, 2, 3, 123, 321}) {
    const CertifiedNet net = certified_net(random_octagon(seed), 0.1, kSparse);
    EXPECT_LE(times_lower_bound(net.document, 2), 1.5) << "seed " << seed;
  }
  EXPECT_LE(times_lower_bound(certified_net(random_octagon(5), 0.04, kSparse).document, 2), 1.5);
  const Surface genus_3 = fenchel_nielsen_surface(random_coordinates(PantsGraph::random(3, 1), 1));
  EXPECT_LE(times_lower_bound(certified_net(genus_3, 0.1, kSparse).document, 3), 1.5);
}

TEST(SparseNet, HasNoMoreVerticesThanTheOrdinaryNet) {
  for (const test::NamedSurface& named : test::gallery()) {
    for (const char* epsilon : {"0.6", "1", "3"}) {
      EXPECT_LE(compute_net(named.surface, Length(epsilon), kSparse).document.vertices.size(),
                compute_net(named.surface, Length(epsilon)).document.vertices.size())
          << named.name << ", " << epsilon;
    }
  }
}

TEST(SparseNet, ProgressGrows) {
  std::vector<double> shares;
  NetOptions options = kSparse;
  options.progress = [&](std::string_view what, double share) {
    EXPECT_TRUE(what.starts_with("net: ")) << what;
    shares.push_back(share);
  };
  (void)compute_net(random_octagon(1), Length("0.02"), options);
  EXPECT_GE(shares.size(), 3U);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GE(shares.front(), 0);
  EXPECT_LE(shares.back(), 1);
}

TEST(SparseNet, IsTheSameEachTime) {
  const Surface surface = random_octagon(7);
  EXPECT_EQ(text_of(compute_net(surface, Length("0.1"), kSparse).document),
            text_of(compute_net(surface, Length("0.1"), kSparse).document));
}

TEST(SparseNet, IsANetForEveryEpsilon) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    for (const char* epsilon : {"0.4", "0.7", "1.5", "8"}) {
      EXPECT_NO_THROW((void)certified_net(named.surface, Length(epsilon), kSparse)) << named.name << ", " << epsilon;
    }
  }
}

TEST(SparseNet, DoesNotTwistAroundAVeryShortCurve) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(2, 1), 1);
  test::set_cuff_length(coordinates, 1, Rational(1, 1'000'000'000'000));
  const Surface surface = fenchel_nielsen_surface(coordinates);
  for (const char* epsilon : {"0.4", "2"}) {
    const CertifiedNet net = certified_net(surface, Length(epsilon), kSparse);
    EXPECT_LE(net.document.vertices.size(), compute_net(surface, Length(epsilon)).document.vertices.size()) << epsilon;
  }
}

TEST(SparseNet, KeepsTheBasePoint) {
  NetOptions options = kSparse;
  options.base = BasePoint{TileId(0), {Rational(1, 5), Rational(-1, 7)}};
  const Surface surface = random_octagon(11);
  const Triangulation start(surface, options.base);
  for (const char* epsilon : {"0.15", "0.5", "2"}) {
    const CertifiedNet net = certified_net(surface, Length(epsilon), options);
    const auto& vertex = net.document.vertices.front();
    EXPECT_EQ(vertex.x, start.vertex(VertexId(0)).z.x);
    EXPECT_EQ(vertex.y, start.vertex(VertexId(0)).z.y);
    EXPECT_EQ(net.document.charts[vertex.chart].centre.x,
              to_gmp(start.atlas().charts()[start.vertex(VertexId(0)).chart].centre).x);
  }
}

TEST(SparseNet, IsMadeWithEveryListAndByFlips) {
  const Surface surface = random_octagon(3);
  const auto made = [&](const Variant& variant) {
    VariantNet net = compute_variant(surface, Length("0.15"), variant, kSparse);
    EXPECT_EQ(certify::check(net.document, kSparse.check).verdict, certify::Verdict::verified);
    return net;
  };
  for (const TriangleList list : {TriangleList::all_back, TriangleList::all_front, TriangleList::largest_first}) {
    EXPECT_LE(times_lower_bound(made({.list = list}).document, 2), 1.7) << name_in(kTriangleListNames, list);
  }
  const RefinementStatistics by_flips = made({.insertion = Insertion::flips}).statistics;
  EXPECT_EQ(by_flips.located, by_flips.insertions);
}

TEST(SparseNet, IsNoPseudoNet) {
  NetOptions options = kSparse;
  options.pseudo = true;
  EXPECT_THROW((void)compute_net(random_octagon(1), Length("0.2"), options), std::invalid_argument);
}

}  // namespace
}  // namespace epsnet::sparse_test
