#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tuple>
#include <utility>
#include <vector>

#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/nets/triangulations.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/mesh/operations.h"
#include "triangulation/mesh/triangulation.h"

/// Net documents as triangulations.
namespace epsnet::net_document_test {
namespace {

using certify::NetDocument;
using testing::HasSubstr;

/// Returns the document of the triangulation of a document.
NetDocument there_and_back(const NetDocument& net) { return net_document(triangulation_of(net), Length(net.epsilon)); }

std::vector<Surface> surfaces() {
  return {random_octagon(123), Surface::regular(2), Surface::regular(3), test::tiled_gallery()[10].surface,
          fenchel_nielsen_surface(random_coordinates(PantsGraph::random(5, 3), 3))};
}

TEST(TriangulationOfANet, GivesTheSameDocument) {
  for (const Surface& surface : surfaces()) {
    const NetDocument net = compute_net(surface, Length("0.6")).document;
    EXPECT_EQ(there_and_back(net), net);
  }
}

TEST(TriangulationOfANet, HasTheNetsVerticesAndTriangles) {
  TriangulatedNet net = triangulated_net(random_octagon(123), Length("0.6"));
  Triangulation again = triangulation_of(net_document(net.triangulation, Length("0.6")));
  EXPECT_EQ(problem(again), "");
  EXPECT_EQ(again.vertex_count(), net.triangulation.vertex_count());
  EXPECT_EQ(again.surface().tiles(), net.triangulation.surface().tiles());
  for (const VertexId v : again.vertices()) EXPECT_EQ(again.point(v), net.triangulation.point(v));
  for (const TriangleId t : again.triangles()) {
    EXPECT_EQ(again.triangle(t).vertex, net.triangulation.triangle(t).vertex);
    EXPECT_EQ(again.triangle(t).opposite, net.triangulation.triangle(t).opposite);
  }
  // The triangulation can be changed, too.
  EXPECT_EQ(make_delaunay(again), 0U);
}

TEST(TriangulationOfANet, FlipsNothing) {
  Triangulation triangulation = triangulated_net(random_octagon(1), Length("0.6")).triangulation;
  TriangleId t(0);
  while (!test::flippable(triangulation, make_dart(t, 0))) ++t;
  const Dart d = make_dart(t, 0);
  (void)flip(triangulation, d);
  ASSERT_TRUE(test::not_delaunay(triangulation).has_value());
  const NetDocument net = net_document(triangulation, Length("0.6"));
  EXPECT_EQ(there_and_back(net), net);
}

TEST(TriangulationOfANet, OfAPseudoNetLeavesOutTheCollars) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(2, 1), 1);
  test::set_cuff_length(coordinates, 0, Rational(1, 10));
  NetDocument net = compute_net(fenchel_nielsen_surface(coordinates), Length("0.25"), {.pseudo = true}).document;
  ASSERT_EQ(net.collars.value().size(), 1U);
  const NetDocument back = there_and_back(net);
  EXPECT_FALSE(back.collars.has_value());
  net.collars.reset();
  EXPECT_EQ(back, net);
}

struct Fault {
  const char* message;
  std::function<void(NetDocument&)> make;
};

TEST(TriangulationOfANet, SaysWhatIsWrongWithADocument) {
  const NetDocument good = compute_net(random_octagon(123), Length("0.6")).document;
  ASSERT_GE(good.labels.size(), 2U);
  const std::vector<Fault> faults{
      {"chart 0 is in tile 1, the surface has 1", [](NetDocument& n) { n.charts[0].tile = 1; }},
      {"chart 0 has its centre outside of the unit disk", [](NetDocument& n) { n.charts[0].centre.x = 2; }},
      {"label 1 names chart 1000", [](NetDocument& n) { n.labels[0].from = 1000; }},
      {"label 2 crosses side 8, which tile 0 does not have", [](NetDocument& n) { n.labels[1].word = {8}; }},
      {"vertex 1 is in chart 1000", [](NetDocument& n) { n.vertices[1].chart = 1000; }},
      {"vertex 1 is far from the origin", [](NetDocument& n) { n.vertices[1].x = 0.71; }},
      {"vertex 1 is far from the origin", [](NetDocument& n) { n.vertices[1].x = std::nan(""); }},
      {"triangle 2, corner 1 is vertex 4294967295", [](NetDocument& n) { n.triangles[2].vertex[1] = ~0u; }},
      {"triangle 3 has label 4294967295", [](NetDocument& n) { n.triangles[3].label[1] = ~0u; }},
      {"triangle 3 is glued to dart 4294967295", [](NetDocument& n) { n.triangles[3].opposite[1] = ~0u; }},
      {"opposite is not an involution", [](NetDocument& n) { n.triangles[3].opposite[1] = 10; }},
      {"vertices on the two sides differ",
       [](NetDocument& n) { n.triangles[0].vertex[1] = (n.triangles[0].vertex[1] + 1) % 10; }},
      {"not counterclockwise", [](NetDocument& n) { std::tie(n.vertices[1].x, n.vertices[1].y) = std::pair(0.69, 0); }},
      {"V - E + F is",
       [](NetDocument& n) {
         n.triangles.clear();
         n.vertices.clear();
       }},
  };
  for (const Fault& fault : faults) {
    NetDocument net = good;
    fault.make(net);
    try {
      (void)triangulation_of(net);
      ADD_FAILURE() << "accepted: " << fault.message;
    } catch (const TriangulationError& error) {
      EXPECT_THAT(error.what(), HasSubstr(fault.message));
    }
  }
  NetDocument net = good;
  net.surface.gluing.pop_back();
  EXPECT_THROW((void)triangulation_of(net), SurfaceError);
}

TEST(TriangulationOfANet, LabelsMustFitAcrossEveryEdge) {
  const NetDocument good = compute_net(random_octagon(123), Length("0.9")).document;
  ASSERT_FALSE(good.labels.empty());
  for (std::size_t t = 0; t < good.triangles.size(); ++t) {
    for (const std::size_t i : {0U, 1U}) {
      for (std::uint32_t label = 0; label <= good.labels.size(); ++label) {
        if (label == good.triangles[t].label[i]) continue;
        NetDocument net = good;
        net.triangles[t].label[i] = label;
        EXPECT_THROW((void)triangulation_of(net), TriangulationError) << t << ' ' << i << ' ' << label;
      }
    }
  }
}

}  // namespace
}  // namespace epsnet::net_document_test
