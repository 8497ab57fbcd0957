#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <string>

#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"

namespace epsnet::certify::surface_check_test {
namespace {

SurfaceDocument::Tile tile(std::initializer_list<std::pair<mpq_class, mpq_class>> vertices) {
  SurfaceDocument::Tile result;
  for (const auto& [x, y] : vertices) result.push_back({x, y});
  return result;
}

SurfaceDocument octagon() {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/octagon-1-vertex.json").surface;
}

TEST(SurfaceCheck, OctagonHasGenusTwo) {
  const SurfaceOutcome outcome = check_surface(octagon());
  EXPECT_EQ(outcome.report.verdict, Verdict::verified) << outcome.report.text;
  EXPECT_EQ(outcome.genus, 2U);
  EXPECT_EQ(std::get<RationalCrossings>(outcome.crossings).size(), 8U);
}

TEST(SurfaceCheck, OneCoordinateChangedInTheLastDigitIsRefuted) {
  for (std::size_t k = 0; k < 8; ++k) {
    SurfaceDocument surface = octagon();
    surface.tiles[0][k].x += mpq_class(1, mpz_class("1000000000000000000000000000000000000000"));
    EXPECT_EQ(check_surface(surface).report.verdict, Verdict::refuted);
  }
}

TEST(SurfaceCheck, PolygonThatWindsTwiceIsRefuted) {
  // Left turns everywhere, but a pentagram: turning number 2.
  SurfaceDocument surface = octagon();
  surface.tiles = {tile({{mpq_class(1, 2), 0},
                         {mpq_class(-2, 5), mpq_class(3, 10)},
                         {mpq_class(3, 20), mpq_class(-12, 25)},
                         {mpq_class(3, 20), mpq_class(12, 25)},
                         {mpq_class(-2, 5), mpq_class(-3, 10)},
                         {mpq_class(1, 2), mpq_class(1, 100)},
                         {mpq_class(-2, 5), mpq_class(31, 100)},
                         {mpq_class(1, 10), mpq_class(-1, 2)}})};
  const SurfaceOutcome outcome = check_surface(surface);
  EXPECT_EQ(outcome.report.verdict, Verdict::refuted);
  EXPECT_NE(outcome.report.text.find("strictly convex"), std::string::npos);
}

TEST(SurfaceCheck, ThreeCornersOnALineAreRefuted) {
  SurfaceDocument surface = octagon();
  surface.tiles[0][1] = {0, 0};
  surface.tiles[0][0] = {mpq_class(1, 2), 0};
  surface.tiles[0][2] = {mpq_class(-1, 2), 0};
  EXPECT_EQ(check_surface(surface).report.verdict, Verdict::refuted);
}

TEST(SurfaceCheck, SplitOctagonIsTheSameSurface) {
  // Cut along the diagonal from corner 0 to corner 4: two pentagons, one more pair of sides.
  const SurfaceDocument whole = octagon();
  const SurfaceDocument::Tile& v = whole.tiles[0];
  SurfaceDocument cut;
  cut.tiles = {SurfaceDocument::Tile{v[0], v[1], v[2], v[3], v[4]},
               SurfaceDocument::Tile{v[4], v[5], v[6], v[7], v[0]}};
  cut.gluing = {{0, 4, 1, 4}};
  for (std::uint32_t k = 0; k < 4; ++k) cut.gluing.push_back({0, k, 1, k});
  const SurfaceOutcome outcome = check_surface(cut);
  EXPECT_EQ(outcome.report.verdict, Verdict::verified) << outcome.report.text;
  EXPECT_EQ(outcome.genus, 2U);
}

TEST(SurfaceCheck, ConeAngleOfThreeFullTurnsIsRefuted) {
  // Three copies of the octagon, glued so that going round the vertex once leads to the next copy: a branched cover.
  // All lengths agree and the crossings around its one vertex multiply to the identity; only the angle tells.
  const SurfaceDocument octagon_surface = octagon();
  SurfaceDocument cover;
  cover.tiles.assign(3, octagon_surface.tiles[0]);
  const std::array<std::array<std::uint32_t, 3>, 4> sheet{{{1, 0, 2}, {0, 2, 1}, {0, 1, 2}, {0, 1, 2}}};
  for (std::uint32_t side = 0; side < 4; ++side) {
    for (std::uint32_t t = 0; t < 3; ++t) cover.gluing.push_back({t, side, sheet[side][t], side + 4});
  }
  const SurfaceOutcome outcome = check_surface(cover);
  EXPECT_EQ(outcome.report.verdict, Verdict::refuted);
  EXPECT_NE(outcome.report.text.find("3 full turns"), std::string::npos) << outcome.report.text;
}

TEST(SurfaceCheck, ANearlyIdealTriangleHasAnInscribedDisk) {
  // Corners at distance 1e-14 of the circle.
  const mpq_class r(mpz_class("99999999999999"), mpz_class("100000000000000"));
  const SurfaceDocument::Tile thin =
      tile({{r, 0}, {mpq_class(-3, 5) * r, mpq_class(4, 5) * r}, {mpq_class(-3, 5) * r, mpq_class(-4, 5) * r}});
  const auto disk = inscribed_disk(thin, 8192);
  ASSERT_TRUE(disk.has_value());
  // The radius of the circle inscribed in an ideal triangle is ln(3)/2, so sinh of it is 1/√3; the centre is not far.
  EXPECT_GT(outer_interval(disk->sinh_radius).lower, 0.3);
  EXPECT_LT(outer_interval(disk->sinh_radius).upper, 0.58);
}

TEST(SurfaceCheck, ASliverHasAnInscribedDisk) {
  const mpq_class tiny(1, mpz_class("1000000000000000000000000000000000000000000000000"));
  const SurfaceDocument::Tile sliver = tile({{mpq_class(-1, 2), 0}, {mpq_class(1, 2), 0}, {0, tiny}});
  const auto disk = inscribed_disk(sliver, 8192);
  ASSERT_TRUE(disk.has_value());
  EXPECT_GT(outer_interval(disk->sinh_radius).lower, 0);
}

// Each clause of convexity alone, at each corner, in a tile that need not fit to its gluing: the clause is named.

/// The octagon's surface with another first tile: what is said of it.
std::string said_of(const SurfaceDocument::Tile& first) {
  SurfaceDocument surface = octagon();
  surface.tiles[0] = first;
  surface.gluing.clear();
  for (std::uint32_t k = 0; k < first.size() / 2; ++k) {
    surface.gluing.push_back({0, k, 0, k + static_cast<std::uint32_t>(first.size() / 2)});
  }
  const RuleReport said = check_surface(surface).report;
  EXPECT_EQ(said.verdict, Verdict::refuted);
  return said.text;
}

SurfaceDocument::Tile rotated(const SurfaceDocument::Tile& tile, std::size_t first) {
  SurfaceDocument::Tile result = tile;
  std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(first), result.end());
  return result;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SurfaceCheck, EveryVertexOfATileIsInsideTheDisk) {
  for (const mpq_class& bad : {mpq_class(4, 5), mpq_class(9, 10)}) {  // On the circle, with 3/5, and outside.
    for (std::size_t k = 0; k < 8; ++k) {
      SurfaceDocument::Tile tile = octagon().tiles[0];
      tile[k] = {mpq_class(3, 5), bad};
      EXPECT_TRUE(has(said_of(tile), "vertex " + std::to_string(k) + " of tile 0 is not inside the unit disk"));
    }
  }
}

TEST(SurfaceCheck, EveryCornerOfATileIsALeftTurn) {
  // Vertex 1 on the line from vertex 0 to vertex 2, and beyond it.
  for (const mpq_class& y : {mpq_class(0), mpq_class(1, 100)}) {
    const SurfaceDocument::Tile hexagon = tile({{mpq_class(-1, 2), 0},
                                                {0, y},
                                                {mpq_class(1, 2), 0},
                                                {mpq_class(2, 5), mpq_class(2, 5)},
                                                {0, mpq_class(1, 2)},
                                                {mpq_class(-2, 5), mpq_class(2, 5)}});
    for (std::size_t first = 0; first < 6; ++first) {
      EXPECT_TRUE(
          has(said_of(rotated(hexagon, first)), "no left turn at its vertex " + std::to_string((7 - first) % 6)));
    }
  }
}

TEST(SurfaceCheck, VerticesAreLeftOfSideZero) {
  // Once and a quarter around vertex 0, to the left at every corner: vertex 3 is on the line of side 0.
  const mpq_class r(1, 2), s(9, 20);
  const SurfaceDocument::Tile spiral =
      tile({{0, 0}, {r, 0}, {0, r}, {-r, 0}, {0, -r}, {s, 0}, {0, s}, {mpq_class(-1, 1000), mpq_class(1, 5)}});
  EXPECT_TRUE(has(said_of(spiral), "vertex 3 is right of side 0")) << said_of(spiral);
  SurfaceDocument::Tile beyond = spiral;
  beyond[3].y = mpq_class(-1, 100);
  EXPECT_TRUE(has(said_of(beyond), "vertex 3 is right of side 0")) << said_of(beyond);
}

TEST(SurfaceCheck, VerticesFollowEachOtherAroundVertexZero) {
  // A pentagram and one side more; every corner turns left.
  const SurfaceDocument::Tile star = tile({{mpq_class(1, 2), 0},
                                           {mpq_class(-2, 5), mpq_class(3, 10)},
                                           {mpq_class(3, 20), mpq_class(-12, 25)},
                                           {mpq_class(3, 20), mpq_class(12, 25)},
                                           {mpq_class(-2, 5), mpq_class(-3, 10)},
                                           {mpq_class(2, 5), mpq_class(-1, 10)}});
  EXPECT_TRUE(has(said_of(star), "vertex 3 does not follow vertex 2 around vertex 0")) << said_of(star);
  // Vertex 3 on the line from vertex 0 to vertex 2.
  const mpq_class u(1, 100);
  const SurfaceDocument::Tile line = tile({{0, 0},
                                           {4 * u, 0},
                                           {0, 4 * u},
                                           {0, 2 * u},
                                           {u, 2 * u},
                                           {u, 3 * u},
                                           {-2 * u, 3 * u},
                                           {-2 * u, -2 * u},
                                           {2 * u, -2 * u},
                                           {3 * u, u}});
  EXPECT_TRUE(has(said_of(line), "vertex 3 does not follow vertex 2 around vertex 0")) << said_of(line);
}

TEST(SurfaceCheck, OnlyTheLastOfSeveralTilesIsNotConvex) {
  SurfaceDocument surface = octagon();
  for (std::uint32_t t = 1; t < 5; ++t) {
    surface.tiles.push_back(surface.tiles[0]);
    for (std::uint32_t k = 0; k < 4; ++k) surface.gluing.push_back({t, k, t, k + 4});
  }
  std::swap(surface.tiles[4][2], surface.tiles[4][3]);
  for (const unsigned threads : {1U, 3U}) {
    EXPECT_TRUE(has(check_surface(surface, threads).report.text, "tile 4 is not strictly convex"));
  }
}

TEST(SurfaceCheck, TilesAreConnectedThroughTheirLastSides) {
  // Pentagons whose first four sides are glued among themselves: only the last one leads to the other. Whatever their
  // lengths are, they are connected.
  const SurfaceDocument::Tile v = octagon().tiles[0];
  SurfaceDocument surface;
  surface.tiles.assign(2, {v[0], v[1], v[2], v[3], v[4]});
  surface.gluing = {{0, 0, 0, 2}, {0, 1, 0, 3}, {1, 0, 1, 2}, {1, 1, 1, 3}, {0, 4, 1, 4}};
  EXPECT_FALSE(has(check_surface(surface).report.text, "not connected")) << check_surface(surface).report.text;
  surface = octagon();
  surface.tiles.push_back(surface.tiles[0]);
  for (std::uint32_t k = 0; k < 4; ++k) surface.gluing.push_back({1, k, 1, k + 4});
  EXPECT_TRUE(has(check_surface(surface).report.text, "no path of glued sides leads from tile 0 to tile 1"));
}

TEST(SurfaceCheck, SidesOfUnequalLengthAreNamed) {
  // A corner moved, in and out, changes two sides; the first of the pairs is named.
  for (std::size_t k = 0; k < 8; ++k) {
    for (const int sign : {-1, 1}) {
      SurfaceDocument surface = octagon();
      const mpq_class factor = 1 + sign * mpq_class(1, mpz_class("1000000000000000000000000000000000000000"));
      surface.tiles[0][k].x *= factor;
      surface.tiles[0][k].y *= factor;
      const std::size_t side = std::min((k + 7) % 4, k % 4);
      EXPECT_TRUE(has(check_surface(surface).report.text,
                      "side " + std::to_string(side) + " of tile 0 is glued to side " + std::to_string(side + 4) +
                          " of tile 0, which is not of equal length"))
          << check_surface(surface).report.text;
    }
  }
}

TEST(SurfaceCheck, SpheresAndToriAreNamed) {
  const auto text = [](const char* name) {
    return check_surface(read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/refuted/" + name).surface)
        .report.text;
  };
  EXPECT_TRUE(has(text("surface-sphere.json"), "is a sphere")) << text("surface-sphere.json");
  EXPECT_TRUE(has(text("surface-torus.json"), "is a torus")) << text("surface-torus.json");
}

TEST(SurfaceCheck, ConeAnglesAreSeenBehindVerticesThatAreRight) {
  // The octagon cut into triangles at a point inside, and of that the cover of three sheets as above: its first vertex,
  // the point, is right, and so are those of the other sheets.
  const SurfaceDocument::Tile v = octagon().tiles[0];
  SurfaceDocument surface;
  for (std::uint32_t t = 0; t < 3; ++t) {
    for (std::size_t k = 0; k < 8; ++k) surface.tiles.push_back({{0, 0}, v[k], v[(k + 1) % 8]});
    for (std::uint32_t k = 0; k < 8; ++k) surface.gluing.push_back({8 * t + k, 2, 8 * t + (k + 1) % 8, 0});
  }
  SurfaceDocument flat = surface;
  for (std::uint32_t t = 0; t < 3; ++t) {
    for (std::uint32_t k = 0; k < 4; ++k) flat.gluing.push_back({8 * t + k, 1, 8 * ((t + (k == 0)) % 3) + k + 4, 1});
  }
  EXPECT_EQ(check_surface(flat).report.verdict, Verdict::verified) << check_surface(flat).report.text;
  EXPECT_EQ(check_surface(flat).genus, 4U);
  const std::array<std::array<std::uint32_t, 3>, 4> sheet{{{1, 0, 2}, {0, 2, 1}, {0, 1, 2}, {0, 1, 2}}};
  for (std::uint32_t side = 0; side < 4; ++side) {
    for (std::uint32_t t = 0; t < 3; ++t) surface.gluing.push_back({8 * t + side, 1, 8 * sheet[side][t] + side + 4, 1});
  }
  EXPECT_TRUE(has(check_surface(surface).report.text, "add up to 3 full turns")) << check_surface(surface).report.text;
}

/// The octagon cut into triangles by its centre and an octagon half as large, in so many sheets. Crossing side k leads
/// from sheet s to sheet lead(k, s). The triangles that have no corner of the octagon come first, sheet by sheet.
SurfaceDocument in_sheets(std::uint32_t sheets,
                          const std::function<std::uint32_t(std::uint32_t, std::uint32_t)>& lead) {
  const SurfaceDocument::Tile v = octagon().tiles[0];
  SurfaceDocument::Tile w = v;
  for (RationalPoint& z : w) z = {z.x / 2, z.y / 2};
  SurfaceDocument surface;
  for (std::uint32_t s = 0; s < sheets; ++s) {
    for (std::size_t k = 0; k < 8; ++k) surface.tiles.push_back({{0, 0}, w[k], w[(k + 1) % 8]});
  }
  for (std::uint32_t s = 0; s < sheets; ++s) {
    for (std::size_t k = 0; k < 8; ++k) {
      surface.tiles.push_back({w[k], v[k], w[(k + 1) % 8]});
      surface.tiles.push_back({w[(k + 1) % 8], v[k], v[(k + 1) % 8]});
    }
  }
  const auto ring = [&](std::uint32_t s, std::uint32_t k) { return 8 * sheets + 16 * s + 2 * (k % 8); };
  for (std::uint32_t s = 0; s < sheets; ++s) {
    for (std::uint32_t k = 0; k < 8; ++k) {
      surface.gluing.push_back({8 * s + k, 2, 8 * s + (k + 1) % 8, 0});
      surface.gluing.push_back({8 * s + k, 1, ring(s, k), 2});
      surface.gluing.push_back({ring(s, k), 1, ring(s, k) + 1, 0});
      surface.gluing.push_back({ring(s, k) + 1, 2, ring(s, k + 1), 0});
      if (k < 4) surface.gluing.push_back({ring(s, k) + 1, 1, ring(lead(k, s), k + 4) + 1, 1});
    }
  }
  return surface;
}

/// The only cone point has the angle 6π. It is seen wherever it is among the vertices, and as the last of many.
TEST(SlowSurfaceCheck, AConeAngleIsSeenAtTheLastVertexOfAll) {
  for (const std::uint32_t sheets : {3U, 4U, 10U, 30U}) {
    int last = 0;
    for (std::uint32_t exchanged = 0; exchanged < sheets; ++exchanged) {
      // A cycle of all sheets and an exchange of two: their commutator is a cycle of three.
      const std::uint32_t other = (exchanged + 1) % sheets;
      const SurfaceDocument branched = in_sheets(sheets, [&](std::uint32_t side, std::uint32_t s) {
        if (side == 0) return (s + 1) % sheets;
        return side > 1 || (s != exchanged && s != other) ? s : exchanged + other - s;
      });
      const RuleReport said = check_surface(branched).report;
      EXPECT_EQ(said.verdict, Verdict::refuted) << sheets << " " << exchanged;
      EXPECT_TRUE(has(said.text, "add up to 3 full turns, not to one")) << said.text;
      const SurfaceSides sides(branched);
      const std::uint32_t side = sides.vertices().back();
      last += has(said.text, "the angles around vertex " + std::to_string(sides.corner[side]) + " of tile " +
                                 std::to_string(sides.tile[side]) + " add");
    }
    EXPECT_GT(last, 0) << sheets;
    // Without the exchange there is no cone point.
    const auto cyclic = [&](std::uint32_t side, std::uint32_t s) { return side == 0 ? (s + 1) % sheets : s; };
    const SurfaceOutcome flat = check_surface(in_sheets(sheets, cyclic));
    EXPECT_EQ(flat.report.verdict, Verdict::verified) << flat.report.text;
    EXPECT_EQ(flat.genus, sheets + 1);
  }
}

TEST(SurfaceCheck, RegularSurfacesHaveAGenusOfAtLeastTwo) {
  SurfaceDocument surface;
  surface.regular_genus = 1;
  EXPECT_EQ(check_surface(surface).report.verdict, Verdict::refuted);
  surface.regular_genus = 2;
  EXPECT_EQ(check_surface(surface).report.verdict, Verdict::verified);
}

TEST(SurfaceCheck, TheInscribedDiskTouchesTheNearestSideWhereverTheFileBegins) {
  // A quadrilateral one of whose sides is nearer to its middle than the others.
  const SurfaceDocument::Tile kite = tile({{mpq_class(1, 2), mpq_class(-1, 10)},
                                           {mpq_class(1, 2), mpq_class(3, 5)},
                                           {mpq_class(-1, 2), mpq_class(3, 5)},
                                           {mpq_class(-1, 2), mpq_class(-1, 10)}});
  for (std::size_t first = 0; first < 4; ++first) {
    const SurfaceDocument::Tile turned = rotated(kite, first);
    const auto disk = inscribed_disk(turned, 8192);
    ASSERT_TRUE(disk.has_value());
    // sinh of the distance of a point of the disk from the line through p and q, in binary64.
    const double x = mpq_class(disk->centre.n.re, disk->centre.m).get_d();
    const double y = mpq_class(disk->centre.n.im, disk->centre.m).get_d();
    double least = 10;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto vector = [](double a, double b) { return std::array{2 * a, 2 * b, 1 + a * a + b * b}; };
      const auto p = vector(turned[k].x.get_d(), turned[k].y.get_d());
      const auto q = vector(turned[(k + 1) % 4].x.get_d(), turned[(k + 1) % 4].y.get_d());
      const auto z = vector(x, y);
      const std::array<double, 3> n{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
      least = std::min(least, (n[0] * z[0] + n[1] * z[1] + n[2] * z[2]) /
                                  std::sqrt(n[0] * n[0] + n[1] * n[1] - n[2] * n[2]) / (1 - x * x - y * y));
    }
    EXPECT_NEAR(outer_interval(disk->sinh_radius).lower, least, 1e-12);
    EXPECT_NEAR(outer_interval(disk->sinh_radius).upper, least, 1e-12);
  }
}

}  // namespace
}  // namespace epsnet::certify::surface_check_test
