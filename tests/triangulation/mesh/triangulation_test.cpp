#include "triangulation/mesh/triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <rapidcheck/gtest.h>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "netgen/nets/triangulations.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"
#include "triangulation/mesh/insertion.h"
#include "triangulation/mesh/operations.h"

namespace epsnet::triangulation_test {
namespace {

using test::any_dart;
using test::any_delaunay;
using test::any_index;
using test::any_point;
using test::any_surface;
using test::area_of;
using test::gallery;
using test::insert_in_cavity;
using test::snapshot;
using test::tessellation_of;
using test::total_area;
using test::triangles_of;

constexpr auto kAcceptAll = [](Corner) { return true; };

/// How many edges of d's triangle lead to the triangle across d.
int shared_edges(const Triangulation& triangulation, Dart d) {
  int count = 0;
  for (const Dart side : {d, next_dart(d), previous_dart(d)}) {
    count += triangle_of(triangulation.opposite(side)) == triangle_of(triangulation.opposite(d)) ? 1 : 0;
  }
  return count;
}

/// The corner of an existing vertex as seen from a triangle, by some path.
LabelId some_label(Triangulation& triangulation, VertexId vertex, TriangleId t, const Word& word) {
  return Editor(triangulation).atlas().label(triangulation.vertex(vertex).chart, triangulation.chart_of(t), word);
}

/// The point p, given in the chart of the walk's start, lies where the location says.
bool lies_there(Triangulation& triangulation, Corner p, const Location& location) {
  const TriangleId t = triangle_of(location.dart);
  const auto lifted = [&](std::uint32_t i) {
    const Corner c = triangulation.corner(t, i);
    return Corner{c.vertex, triangulation.product(location.transition, c.label)};
  };
  const std::uint32_t first = corner_of(location.dart);
  const auto sign = [&](std::uint32_t i) { return triangulation.orientation(lifted(i), lifted(next(i)), p); };
  const int along = sign(first);
  const int after = sign(next(first));
  const int before = sign(previous(first));
  switch (location.type) {
    case Location::Type::face:
      return along > 0 && after > 0 && before > 0;
    case Location::Type::edge:
      return along == 0 && after > 0 && before > 0;
    case Location::Type::vertex:
      return along == 0 && after > 0 && before == 0;
    case Location::Type::not_found:
      break;
  }
  return false;
}

/// A triangulation of a symmetric octagon, symmetric with respect to its centre, which thus lies exactly on an edge: no
/// triangle is its own image. The vertices are the octagon's and pairs of opposite points.
struct Symmetric {
  Surface surface;
  Triangulation triangulation;
  ChartId chart;

  Symmetric(std::int32_t seed, const std::vector<Complex<double>>& points)
      : surface(random_octagon(seed)),
        triangulation(surface),
        chart(Editor(triangulation).atlas().add_chart({TileId(0), {}})) {
    make_delaunay(triangulation);
    for (const Complex<double>& z : points) {
      insert(z);
      insert(-z);
    }
  }
  Symmetric(const Symmetric&) = delete;
  Symmetric& operator=(const Symmetric&) = delete;

  [[nodiscard]] LiftedPoint place(const Complex<double>& z, TriangleId t) {
    return {chart, z, Editor(triangulation).atlas().label(chart, triangulation.chart_of(t), {})};
  }
  void insert(const Complex<double>& z) {
    static_cast<void>(test::insert_by_flips(triangulation, TriangleId(0), place(z, TriangleId(0))));
  }
};

std::vector<Complex<double>> any_points(std::size_t less_than = 12) {
  std::vector<Complex<double>> points(any_index(less_than));
  for (Complex<double>& z : points) {
    z = {0.9 * (test::any_share() - 0.5), 0.9 * (test::any_share() - 0.5)};
  }
  return points;
}

TEST(Triangulation, OfAllPolygonsIsSoundBeforeAndAfterDelaunay) {
  for (const auto& [name, surface] : gallery()) {
    Triangulation triangulation(surface);
    EXPECT_EQ(problem(triangulation), "") << name;
    EXPECT_EQ(triangulation.vertex_count(), surface.vertex_class_count()) << name;
    EXPECT_NEAR(total_area(triangulation), area_of(surface), 1e-9) << name;
    (void)make_delaunay(triangulation);
    EXPECT_EQ(problem(triangulation), "") << name;
    EXPECT_NEAR(total_area(triangulation), area_of(surface), 1e-9) << name;
    EXPECT_FALSE(test::not_delaunay(triangulation).has_value()) << name;
    EXPECT_EQ(make_delaunay(triangulation), 0U) << name;
  }
}

TEST(Triangulation, ThirtyOctagonsAreSound) {
  for (std::int32_t seed = 1; seed <= 30; ++seed) {
    const Surface surface = random_octagon(seed);
    Triangulation triangulation(surface);
    EXPECT_EQ(problem(triangulation), "") << seed;
    (void)make_delaunay(triangulation);
    EXPECT_EQ(problem(triangulation), "") << seed;
    EXPECT_NEAR(total_area(triangulation), area_of(surface), 1e-9) << seed;
  }
}

TEST(Triangulation, OfAnOctagonHasOneVertexAndLoopsOnly) {
  Triangulation triangulation(gallery()[0].surface);
  (void)make_delaunay(triangulation);
  EXPECT_EQ(triangulation.vertex_count(), 1U);
  EXPECT_EQ(triangulation.triangle_count(), 6U);
  for (const TriangleId t : Ids<TriangleId>(6)) {
    EXPECT_EQ(triangulation.triangle(t).vertex, (std::array<VertexId, 3>{VertexId(0), VertexId(0), VertexId(0)}));
    EXPECT_NE(triangulation.triangle(t).label(1), kIdentity);
    EXPECT_NE(triangulation.triangle(t).label(2), kIdentity);
    EXPECT_NE(triangulation.triangle(t).label(1), triangulation.triangle(t).label(2));
  }
}

TEST(Triangulation, IsAsLargeHoweverTheSurfaceIsCutIntoTiles) {
  // The octagon as two pentagons, and as a hexagon and two triangles.
  const Surface octagon = random_octagon(123);
  const Tile& v = octagon.tiles()[0];
  const std::vector<Surface> surfaces{
      Surface({{v[0], v[1], v[2], v[3], v[4]}, {v[4], v[5], v[6], v[7], v[0]}},
              {{0, 0, 1, 0}, {0, 1, 1, 1}, {0, 2, 1, 2}, {0, 3, 1, 3}, {0, 4, 1, 4}}),
      Surface({{v[0], v[1], v[2]}, {v[4], v[5], v[6]}, {v[0], v[2], v[3], v[4], v[6], v[7]}},
              {{0, 0, 1, 0}, {0, 1, 1, 1}, {2, 1, 2, 4}, {2, 2, 2, 5}, {0, 2, 2, 0}, {1, 2, 2, 3}})};
  Triangulation whole(octagon);
  (void)make_delaunay(whole);
  for (const Surface& surface : surfaces) {
    Triangulation triangulation(surface);
    EXPECT_EQ(problem(triangulation), "");
    (void)make_delaunay(triangulation);
    EXPECT_EQ(problem(triangulation), "");
    EXPECT_EQ(triangulation.triangle_count(), whole.triangle_count());
    EXPECT_NEAR(total_area(triangulation), area_of(octagon), 1e-9);
  }
}

TEST(Triangulation, EdgesOfTwoTrianglesThatShareTwoAreFlipped) {
  int flips = 0;
  std::mt19937 random(1);
  for (const auto& [name, surface] : gallery()) {
    Triangulation triangulation(surface);
    (void)make_delaunay(triangulation);
    for (int i = 0; i < 60; ++i) {
      const Dart d =
          make_dart(TriangleId(random() % triangulation.triangle_count()), static_cast<std::uint32_t>(random() % 3));
      if (shared_edges(triangulation, d) < 2) {
        continue;
      }
      if (test::flippable(triangulation, d)) {
        const auto before = triangles_of(triangulation);
        const Dart f = flip(triangulation, d);
        EXPECT_EQ(problem(triangulation), "") << name;
        (void)flip(triangulation, f);
        EXPECT_EQ(triangles_of(triangulation), before) << name;
        ++flips;
      }
    }
  }
  EXPECT_GT(flips, 10);
}

TEST(Triangulation, KeepsTheSurfaceItIsMadeOf) {
  Triangulation triangulation(random_octagon(123));  // A temporary: what is used below is the triangulation's copy.
  EXPECT_EQ(triangulation.surface().genus(), 2U);
  EXPECT_EQ(triangulation.surface().tiles(), random_octagon(123).tiles());
  (void)make_delaunay(triangulation);
  EXPECT_EQ(problem(triangulation), "");
  Triangulation copy = [] { return Triangulation(random_octagon(123)).clone(); }();
  (void)make_delaunay(copy);
  EXPECT_EQ(snapshot(copy), snapshot(triangulation));
  Atlas atlas(random_octagon(123));
  (void)atlas.add_chart({TileId(0), {}});
  EXPECT_EQ(atlas.label(ChartId(0), ChartId(0), atlas.surface().corner_cycle(SideId(0))), kIdentity);
}

TEST(Triangulation, CloneIsApart) {
  Triangulation triangulation(gallery()[1].surface);
  Triangulation copy = triangulation.clone();
  EXPECT_EQ(snapshot(copy), snapshot(triangulation));
  for (std::uint32_t i = 0; i < 9; ++i) {
    if (test::flippable(triangulation, make_dart(TriangleId(i / 3), i % 3))) {
      (void)flip(triangulation, make_dart(TriangleId(i / 3), i % 3));
    }
  }
  EXPECT_FALSE(snapshot(copy) == snapshot(triangulation));
  EXPECT_EQ(problem(copy), "");
}

TEST(Triangulation, ProblemsAreSeen) {
  for (const auto& [name, surface] : gallery()) {
    Triangulation triangulation(surface);
    (void)add_vertex(triangulation, {{0, 0}, ChartId(0)});
    EXPECT_NE(problem(triangulation), "") << "a vertex without a triangle";
    pop_vertex(triangulation);
    EXPECT_EQ(problem(triangulation), "");
    // The three edges of a vertex of degree three have no strictly convex quadrilateral; to flip one all the same turns
    // a triangle over.
    const LiftedPoint place = test::weighted_point(triangulation, TriangleId(0), {1, 1, 1});
    const auto around =
        split_face(triangulation, TriangleId(0), add_vertex(triangulation, {place.z, place.chart}), place.label);
    EXPECT_EQ(problem(triangulation), "") << name;
    for (const TriangleId t : around) {
      EXPECT_FALSE(test::flippable(triangulation, make_dart(t, 0))) << name;
#ifdef NDEBUG  // Else an assertion sees it before.
      Triangulation broken = triangulation.clone();
      (void)flip(broken, make_dart(t, 0));
      EXPECT_NE(problem(broken), "") << name;
#endif
    }
  }
}

TEST(Id, IsATypeOfItsOwnForEveryKind) {
  static_assert(!std::is_convertible_v<std::uint32_t, VertexId> && !std::is_convertible_v<VertexId, std::uint32_t>);
  static_assert(!std::is_convertible_v<VertexId, TriangleId> && !std::is_constructible_v<VertexId, TriangleId>);
  static_assert(!std::is_convertible_v<VertexId, ChartId> && !std::is_constructible_v<VertexId, ChartId>);
  static_assert(sizeof(VertexId) == sizeof(std::uint32_t) && std::is_trivially_copyable_v<VertexId>);
  std::vector<std::uint32_t> numbers;
  for (const VertexId v : Ids<VertexId>(3)) numbers.push_back(v.number());
  EXPECT_EQ(numbers, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Dart, IsATypeOfItsOwn) {
  static_assert(!std::is_convertible_v<std::uint32_t, Dart>);
  static_assert(!std::is_convertible_v<Dart, std::uint32_t>);
  for (const TriangleId t : Ids<TriangleId>(5)) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Dart d = make_dart(t, i);
      EXPECT_EQ(triangle_of(d), t);
      EXPECT_EQ(corner_of(d), i);
      EXPECT_EQ(next_dart(d), make_dart(t, (i + 1) % 3));
      EXPECT_EQ(previous_dart(d), make_dart(t, (i + 2) % 3));
      EXPECT_EQ(triangulation_dart(document_dart(d)), d);
      EXPECT_EQ(document_dart(d), 3 * t.number() + i);
    }
  }
}

TEST(Locate, TheCentreOfASymmetricOctagonIsOnAnEdge) {
  for (const std::int32_t seed : {1, 2, 3, 123, 321}) {
    Symmetric s(seed, {});
    Triangulation& triangulation = s.triangulation;
    const VertexId v = add_vertex(triangulation, {{0, 0}, s.chart});
    for (const TriangleId start : triangulation.triangles()) {
      const Corner p{v, some_label(triangulation, v, start, {})};
      for (const Location& location :
           {locate_visibility(triangulation, start, p), locate_straight(triangulation, start, p)}) {
        EXPECT_EQ(location.type, Location::Type::edge) << seed;
        EXPECT_TRUE(lies_there(triangulation, p, location)) << seed;
      }
    }
  }
}

TEST(Locate, VerticesAreFoundFromEverywhere) {
  for (const auto& [name, surface] : gallery()) {
    Triangulation triangulation(surface);
    (void)make_delaunay(triangulation);
    const VertexId v = add_vertex(triangulation, triangulation.vertex(VertexId(0)));
    for (const TriangleId start : triangulation.triangles()) {
      for (const Word& word : {Word{}, Word{start.number()}}) {
        const Corner p{v, some_label(triangulation, v, start, word)};
        for (const Location& location :
             {locate_visibility(triangulation, start, p), locate_straight(triangulation, start, p)}) {
          EXPECT_EQ(location.type, Location::Type::vertex) << name;
          const Corner found = triangulation.corner(triangle_of(location.dart), corner_of(location.dart));
          EXPECT_EQ(found.vertex, VertexId(0));
          EXPECT_EQ(triangulation.product(location.transition, found.label), p.label) << name;
        }
      }
    }
  }
}

TEST(Locate, APointOfTheFirstTriangleNeedsNoStep) {
  for (const auto& [name, surface] : gallery()) {
    Triangulation triangulation(surface);
    (void)make_delaunay(triangulation);
    for (const TriangleId t : triangulation.triangles()) {
      const LiftedPoint place = test::weighted_point(triangulation, t, {1, 1, 1});
      const VertexId v = add_vertex(triangulation, {place.z, place.chart});
      for (const Location& location : {locate_visibility(triangulation, t, {v, place.label}),
                                       locate_straight(triangulation, t, {v, place.label})}) {
        EXPECT_EQ(location.type, Location::Type::face) << name;
        EXPECT_EQ(triangle_of(location.dart), t) << name;
        EXPECT_EQ(location.transition, kIdentity) << name;
        EXPECT_EQ(location.steps, 0U) << name;
      }
      pop_vertex(triangulation);
    }
  }
}

TEST(Insert, APointOnAnEdgeGivesTheSameBothWays) {
  // The diagonal through the centre of the octagon is a straight line in the central chart: (x, 0) between the pair of
  // (1/4, 0) is exactly on the edge between these two.
  Symmetric s(123, {{0.25, 0}, {0.1, 0.35}, {-0.125, 0.25}, {0.3, 0.3}});
  Triangulation& triangulation = s.triangulation;
  ASSERT_EQ(problem(triangulation), "");
  for (const double x : {0.0, 0.0625, -0.1875, 0x1p-30, 1.0 / 3}) {
    Triangulation by_flips = triangulation.clone();
    const LiftedPoint place = s.place({x, 0}, TriangleId(0));
    const VertexId v = add_vertex(triangulation, {place.z, place.chart});
    const Location location = locate_straight(triangulation, TriangleId(0), {v, place.label});
    EXPECT_EQ(location.type, Location::Type::edge) << x;
    const LabelId label = triangulation.product(triangulation.inverse(location.transition), place.label);
    ASSERT_TRUE(insert_in_cavity(triangulation, triangle_of(location.dart), v, label, kAcceptAll).has_value()) << x;
    EXPECT_EQ(problem(triangulation), "") << x;
    EXPECT_TRUE(test::insert_by_flips(by_flips, TriangleId(0), place)) << x;
    EXPECT_EQ(problem(by_flips), "") << x;
    EXPECT_EQ(tessellation_of(by_flips, triangulation), tessellation_of(triangulation)) << x;
  }
}

TEST(Insert, ACavityThatIsNotAcceptedChangesNothing) {
  Triangulation triangulation = [] {
    Triangulation result(gallery()[1].surface);
    (void)make_delaunay(result);
    return result;
  }();
  std::mt19937 random(7);
  for (int i = 0; i < 30; ++i) {
    const TriangleId t(random() % triangulation.triangle_count());
    static_cast<void>(test::insert_by_flips(triangulation, t, test::weighted_point(triangulation, t, {1, 1.25, 1.5})));
  }
  int calls = 0;
  for (const TriangleId t : triangulation.triangles()) {
    const LiftedPoint place = test::weighted_point(triangulation, t, {1, 1, 1});
    const VertexId v = add_vertex(triangulation, {place.z, place.chart});
    const auto before = snapshot(triangulation);
    const auto refuse = [&](Corner c) {
      ++calls;
      return c.vertex != triangulation.triangle(t).vertex[2];
    };
    Journal journal = open_journal(triangulation);
    EXPECT_FALSE(insert_in_cavity(triangulation, t, v, place.label, refuse, &journal).has_value());
    EXPECT_EQ(snapshot(triangulation), before);
    EXPECT_TRUE(journal.overwritten.empty());
    pop_vertex(triangulation);
  }
  EXPECT_GT(calls, 0);
}

RC_GTEST_PROP(TriangulationProperty, FlipsAndDelaunayGiveTheSameTessellation, ()) {
  Triangulation triangulation = any_delaunay(any_surface().surface, any_index(8u));
  const auto tessellation = tessellation_of(triangulation);
  const auto triangles = triangles_of(triangulation);
  const bool ties = tessellation.size() != 3 * triangles.size();
  RC_CLASSIFY(ties, "ties");
  int flips = 0;
  const auto tries = any_index(25u);
  for (std::uint32_t i = 0; i < tries; ++i) {
    const Dart d = any_dart(triangulation);
    if (test::flippable(triangulation, d)) {
      (void)flip(triangulation, d);
      ++flips;
    }
  }
  RC_CLASSIFY(flips == 0, "no flip");
  RC_ASSERT(problem(triangulation) == "");
  (void)make_delaunay(triangulation);
  RC_ASSERT(problem(triangulation) == "");
  RC_ASSERT(!test::not_delaunay(triangulation));
  RC_ASSERT(tessellation_of(triangulation) == tessellation);
  RC_ASSERT(ties || triangles_of(triangulation) == triangles);
}

RC_GTEST_PROP(TriangulationProperty, TwoFlipsUndoEachOther, ()) {
  Triangulation triangulation = any_delaunay(any_surface().surface, any_index(5u));
  const Dart d = any_dart(triangulation);
  RC_PRE(test::flippable(triangulation, d));
  const auto before = triangles_of(triangulation);
  const Dart f = flip(triangulation, d);
  RC_ASSERT(problem(triangulation) == "");
  RC_ASSERT(triangles_of(triangulation) != before);
  RC_ASSERT(test::flippable(triangulation, f));
  const Dart g = flip(triangulation, f);
  RC_ASSERT(triangles_of(triangulation) == before);
  // Four flips of one edge are the identity of darts as well.
  const auto once = snapshot(triangulation);
  const Dart h = flip(triangulation, flip(triangulation, flip(triangulation, flip(triangulation, g))));
  RC_ASSERT(triangulation.opposite(h) == triangulation.opposite(g));
  for (const TriangleId t : triangulation.triangles()) {
    RC_ASSERT(triangulation.triangle(t).vertex == once.triangles[t.number()].vertex);
    RC_ASSERT(triangulation.triangle(t).opposite == once.triangles[t.number()].opposite);
  }
}

RC_GTEST_PROP(TriangulationProperty, CavityAndFlipsInsertTheSame, ()) {
  Triangulation triangulation = any_delaunay(any_surface().surface, any_index(25u));
  const TriangleId t = test::any_triangle(triangulation);
  const LiftedPoint place = any_point(triangulation, t);
  Triangulation by_flips = triangulation.clone();
  const VertexId v = add_vertex(triangulation, {place.z, place.chart});
  const Corner p{v, place.label};
  RC_PRE(triangulation.in_circle(triangulation.corner(t, 0), triangulation.corner(t, 1), triangulation.corner(t, 2),
                                 p) > 0);
  const auto before = snapshot(triangulation);
  const auto inserted = insert_in_cavity(triangulation, t, v, place.label, kAcceptAll);
  RC_CLASSIFY(!inserted, "the cavity meets itself");
  if (!inserted) {
    RC_ASSERT(snapshot(triangulation) == before);
    return;
  }
  RC_ASSERT(problem(triangulation) == "");
  RC_ASSERT(!test::not_delaunay(triangulation));
  RC_ASSERT(test::insert_by_flips(by_flips, t, place));
  RC_ASSERT(problem(by_flips) == "");
  RC_ASSERT(tessellation_of(by_flips, triangulation) == tessellation_of(triangulation));
  // The new triangles are a fan around the vertex.
  for (const TriangleId s : *inserted) {
    RC_ASSERT(triangulation.triangle(s).vertex[0] == v);
    RC_ASSERT(triangle_of(triangulation.opposite(make_dart(s, 0))) != s);
  }
  // One triangle more than the cavity had, twice; the fan is all that the vertex has.
  std::size_t corners = 0;
  for (const TriangleId s : triangulation.triangles()) {
    for (const VertexId w : triangulation.triangle(s).vertex) {
      corners += w == v ? 1 : 0;
    }
  }
  RC_ASSERT(corners == inserted->size());
}

RC_GTEST_PROP(TriangulationProperty, TheNearestChartIsThatOfACorner, ()) {
  Symmetric s(any_index<std::int32_t>(200), any_points(30));
  Triangulation& triangulation = s.triangulation;
  const TriangleId t = test::any_triangle(triangulation);
  const double angle = any_index(360u) * std::numbers::pi / 180;
  const double radius = 0.75 * test::any_share();
  const Complex<double> z{radius * std::cos(angle), radius * std::sin(angle)};
  const LiftedPoint place = in_nearest_chart(triangulation.mesh(), triangulation.atlas(), t, z);
  RC_CLASSIFY(place.label != kIdentity, "not the chart of the triangle");
  std::set<LabelId> labels;
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Corner c = triangulation.corner(t, i);
    labels.insert(c.label);
    const Complex<double> w = c.label == kIdentity ? z : inverse(triangulation.atlas().isometry(c.label))(z);
    RC_ASSERT(norm(place.z) <= norm(w));
    if (c.label == place.label) RC_ASSERT(triangulation.vertex(c.vertex).chart == place.chart);
  }
  RC_ASSERT(labels.count(place.label) == 1u);
  const Complex<double> back =
      place.label == kIdentity ? place.z : triangulation.atlas().isometry(place.label)(place.z);
  RC_ASSERT(norm(back - z) < 1e-24);
}

RC_GTEST_PROP(TriangulationProperty, TheFastInsertionIsTheCavity, ()) {
  // Small triangles in few charts, so that it often applies.
  Symmetric s(any_index<std::int32_t>(200), any_points(60));
  Triangulation& triangulation = s.triangulation;
  const TriangleId t = test::any_triangle(triangulation);
  const LiftedPoint place = any_point(triangulation, t);
  const Threshold apart(Rational(1 + any_index(20u), 200));
  const Threshold large(Rational(1, 1 + any_index(10u)));
  Triangulation by_cavity = triangulation.clone();
  const auto before = snapshot(triangulation);

  NewTriangles made;
  KnownLabels labels(triangulation.atlas());
  const bool inserted = insert_locally(Editor(triangulation).mesh(), labels, t, place, apart, large, made);
  RC_CLASSIFY(inserted, "inserted");
  if (!inserted) {
    RC_ASSERT(snapshot(triangulation) == before);
    return;
  }
  const bool labelled = std::any_of(made.slots.begin(), made.slots.begin() + made.count,
                                    [&](TriangleId slot) { return !triangulation.triangle(slot).all_identity(); });
  RC_CLASSIFY(labelled, "with labels");
  RC_ASSERT(problem(triangulation) == "");
  const VertexId v = add_vertex(by_cavity, {place.z, place.chart});
  const auto accept = [&](Corner c) { return by_cavity.compare_distance(c, {v, place.label}, apart) > 0; };
  const auto around = insert_in_cavity(by_cavity, t, v, place.label, accept);
  RC_ASSERT(around.has_value());
  RC_ASSERT(triangles_of(by_cavity, triangulation) == triangles_of(triangulation));
  // Slot for slot; the same triangles are large, and marked.
  RC_ASSERT(std::equal(made.slots.begin(), made.slots.begin() + made.count, around->begin(), around->end()));
  std::vector<TriangleId> large_slots;
  for (const TriangleId slot : *around) {
    if (by_cavity.compare_circumradius(slot, large) > 0) {
      mark(by_cavity, slot);
      large_slots.push_back(slot);
    }
    const Triangle& expected = by_cavity.triangle(slot);
    const Triangle& got = triangulation.triangle(slot);
    RC_ASSERT(got.vertex == expected.vertex);
    RC_ASSERT(got.opposite == expected.opposite);
    RC_ASSERT(got.marked() == expected.marked());
  }
  RC_ASSERT(std::equal(made.large_slots.begin(), made.large_slots.begin() + made.large_count, large_slots.begin(),
                       large_slots.end()));
}

RC_GTEST_PROP(TriangulationProperty, SplitFacesAreSound, ()) {
  const Surface& surface = any_surface().surface;
  Triangulation triangulation = any_delaunay(surface, any_index(6u));
  const TriangleId t = test::any_triangle(triangulation);
  const LiftedPoint place = any_point(triangulation, t);
  const VertexId v = add_vertex(triangulation, {place.z, place.chart});
  const Location location = locate_visibility(triangulation, t, {v, place.label});
  RC_PRE(location.type == Location::Type::face && triangle_of(location.dart) == t);
  const auto around = split_face(triangulation, t, v, place.label);
  RC_ASSERT(problem(triangulation) == "");
  RC_ASSERT(around.size() == 3U);
  RC_ASSERT(std::abs(total_area(triangulation) - area_of(surface)) < 1e-9);
}

RC_GTEST_PROP(TriangulationProperty, SplitEdgesAreSound, ()) {
  Symmetric s(any_index<std::int32_t>(200), any_points());
  Triangulation& triangulation = s.triangulation;
  const LiftedPoint place = s.place({0, 0}, TriangleId(0));
  const VertexId v = add_vertex(triangulation, {place.z, place.chart});
  const Location location = locate_visibility(triangulation, TriangleId(0), {v, place.label});
  RC_ASSERT(location.type == Location::Type::edge);
  const LabelId label = triangulation.product(triangulation.inverse(location.transition), place.label);
  const auto before = snapshot(triangulation);
  Journal journal = open_journal(triangulation);
  const auto around = split_edge(triangulation, location.dart, v, label, &journal);
  RC_ASSERT(problem(triangulation) == "");
  RC_ASSERT(around.size() == 4U);
  RC_ASSERT(std::abs(total_area(triangulation) - area_of(s.surface)) < 1e-9);
  std::vector<Dart> pending;
  for (const TriangleId t : around) {
    pending.push_back(make_dart(t, 1));
  }
  (void)restore_delaunay(triangulation, pending, &journal);
  RC_ASSERT(problem(triangulation) == "");
  RC_ASSERT(!test::not_delaunay(triangulation));
  undo(triangulation, journal);
  RC_ASSERT(snapshot(triangulation) == before);
}

RC_GTEST_PROP(TriangulationProperty, UndoRestoresEverything, ()) {
  Triangulation triangulation = any_delaunay(any_surface().surface, any_index(20u));
  const auto before = snapshot(triangulation);
  Journal journal = open_journal(triangulation);
  const auto operations = 1 + any_index(6u);
  for (std::uint32_t i = 0; i < operations; ++i) {
    const TriangleId t = test::any_triangle(triangulation);
    switch (any_index(3u)) {
      case 0: {
        const Dart d = any_dart(triangulation);
        if (test::flippable(triangulation, d)) {
          (void)flip(triangulation, d, &journal);
        }
        break;
      }
      case 1:
        (void)test::insert_by_flips(triangulation, t, any_point(triangulation, t), &journal);
        break;
      default: {
        // From Delaunay, as the cavity requires.
        std::vector<Dart> pending;
        for (const TriangleId s : triangulation.triangles()) {
          pending.insert(pending.end(), {make_dart(s, 0), make_dart(s, 1), make_dart(s, 2)});
        }
        (void)restore_delaunay(triangulation, pending, &journal);
        const LiftedPoint place = any_point(triangulation, t);
        const VertexId v = add_vertex(triangulation, {place.z, place.chart});
        if (!insert_in_cavity(triangulation, t, v, place.label, kAcceptAll, &journal)) {
          pop_vertex(triangulation);
        }
      }
    }
  }
  RC_ASSERT(problem(triangulation) == "");
  undo(triangulation, journal);
  RC_ASSERT(snapshot(triangulation) == before);
  RC_ASSERT(problem(triangulation) == "");
}

RC_GTEST_PROP(TriangulationProperty, WalksFindTheSameTriangleFromEverywhere, ()) {
  const Surface& surface = any_surface().surface;
  Triangulation triangulation = any_delaunay(surface, any_index(25u));
  const TriangleId t = test::any_triangle(triangulation);
  const LiftedPoint place = any_point(triangulation, t);
  const VertexId v = add_vertex(triangulation, {place.z, place.chart});
  std::set<std::pair<TriangleId, LabelId>> found;
  for (int i = 0; i < 3; ++i) {
    const TriangleId start = test::any_triangle(triangulation);
    const Corner p{v, some_label(triangulation, v, start, test::any_word(surface, TileId(0), 2))};
    const Location visible = locate_visibility(triangulation, start, p);
    const Location straight = locate_straight(triangulation, start, p);
    RC_ASSERT(lies_there(triangulation, p, visible));
    RC_ASSERT(lies_there(triangulation, p, straight));
    RC_ASSERT(visible.type == Location::Type::face);
    RC_ASSERT(straight.type == Location::Type::face);
    RC_ASSERT(triangle_of(visible.dart) == triangle_of(straight.dart));
    RC_ASSERT(visible.transition == straight.transition);
    // The point in the coordinates of the triangle that contains it is one, whatever the way there.
    found.insert(
        {triangle_of(visible.dart), triangulation.product(triangulation.inverse(visible.transition), p.label)});
  }
  RC_ASSERT(found.size() == 1U);
}

RC_GTEST_PROP(TriangulationProperty, TheStraightWalkEndsInEveryTriangulation, ()) {
  const Surface& surface = any_surface().surface;
  Triangulation triangulation = any_delaunay(surface, any_index(10u));
  for (int i = 0; i < 10; ++i) {
    const Dart d = any_dart(triangulation);
    if (test::flippable(triangulation, d)) {
      (void)flip(triangulation, d);
    }
  }
  const TriangleId t = test::any_triangle(triangulation);
  const LiftedPoint place = any_point(triangulation, t);
  const VertexId v = add_vertex(triangulation, {place.z, place.chart});
  for (const TriangleId start : triangulation.triangles()) {
    const Corner p{v, some_label(triangulation, v, start, {})};
    RC_ASSERT(lies_there(triangulation, p, locate_straight(triangulation, start, p)));
  }
}

RC_GTEST_PROP(TriangulationProperty, WalksAgreeOnEdgesAndVertices, ()) {
  Symmetric s(any_index<std::int32_t>(200), any_points());
  Triangulation& triangulation = s.triangulation;
  // The centre of the octagon, or a vertex, seen from anywhere.
  const bool centre = any_index(2u) == 0;
  const Vertex vertex = centre ? Vertex{{0, 0}, s.chart} : triangulation.vertex(test::any_vertex(triangulation));
  const VertexId v = add_vertex(triangulation, vertex);
  const TriangleId start = test::any_triangle(triangulation);
  const Corner p{v, some_label(triangulation, v, start, test::any_word(s.surface, TileId(0), 1))};
  const Location visible = locate_visibility(triangulation, start, p);
  const Location straight = locate_straight(triangulation, start, p);
  RC_ASSERT(visible.type == (centre ? Location::Type::edge : Location::Type::vertex));
  RC_ASSERT(straight.type == visible.type);
  RC_ASSERT(lies_there(triangulation, p, visible));
  RC_ASSERT(lies_there(triangulation, p, straight));
}

}  // namespace
}  // namespace epsnet::triangulation_test
