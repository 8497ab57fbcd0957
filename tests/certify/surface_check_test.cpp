#include "certify/surface_check.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "certify/file/reader.h"

namespace epsnet::certify {
namespace {

SurfaceDocument::Tile tile(std::initializer_list<std::pair<mpq_class, mpq_class>> vertices) {
  SurfaceDocument::Tile result;
  for (const auto& [x, y] : vertices) result.push_back({x, y});
  return result;
}

SurfaceDocument octagon() {
  return read_net(std::string(EPSNET_TEST_DATA) + "/certify/verified/octagon-1-vertex.json").surface;
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
  EXPECT_GT(outer_interval(disk->sinh_radius.get()).lower, 0.3);
  EXPECT_LT(outer_interval(disk->sinh_radius.get()).upper, 0.58);
}

TEST(SurfaceCheck, ASliverHasAnInscribedDisk) {
  const mpq_class tiny(1, mpz_class("1000000000000000000000000000000000000000000000000"));
  const SurfaceDocument::Tile sliver = tile({{mpq_class(-1, 2), 0}, {mpq_class(1, 2), 0}, {0, tiny}});
  const auto disk = inscribed_disk(sliver, 8192);
  ASSERT_TRUE(disk.has_value());
  EXPECT_GT(outer_interval(disk->sinh_radius.get()).lower, 0);
}

}  // namespace
}  // namespace epsnet::certify
