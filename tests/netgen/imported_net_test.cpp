#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <optional>
#include <rapidcheck/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "netgen/base/gmp.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"
#include "tests/support/triangulations.h"

namespace epsnet::imported_net_test {
namespace {

using testing::HasSubstr;

certify::Certificate verdict_on(const TriangulationStream& stream, const std::string& epsilon) {
  return certify::check(net_of_tiles(develop(stream, "stream"), Length(epsilon)), {.threads = 1});
}

Surface pants(const std::string& seed) {
  FenchelNielsenRequest request;
  request.genus = 2;
  request.seed = std::stoull(seed);
  return fenchel_nielsen_surface(resolve(request));
}

/// The tiles with the edge at a side of tile t flipped; throws SurfaceError if the two triangles are no convex
/// quadrilateral.
Surface flipped(const Surface& surface, std::uint32_t side) {
  const std::uint32_t other = surface.partner(SideId(side)).number();
  const std::uint32_t t = side / 3;
  const std::uint32_t u = other / 3;
  const auto turned = [](std::uint32_t s, std::uint32_t k) { return s - s % 3 + (s + k) % 3; };
  const auto vertex = [&](std::uint32_t s) { return surface.tiles()[s / 3][s % 3]; };
  const auto a = vertex(side);
  const auto b = vertex(turned(side, 1));
  const auto c = vertex(turned(side, 2));
  const auto d = surface.crossing(SideId(other))(vertex(turned(other, 2)));
  std::vector<Tile> tiles = surface.tiles();
  tiles[t] = {c, a, d};
  tiles[u] = {d, b, c};
  const std::map<std::uint32_t, std::uint32_t> moved{
      {turned(side, 2), 3 * t}, {turned(other, 1), 3 * t + 1}, {turned(other, 2), 3 * u}, {turned(side, 1), 3 * u + 1}};
  const auto place = [&](std::uint32_t s) {
    const auto found = moved.find(s);
    return found == moved.end() ? s : found->second;
  };
  std::vector<Gluing> gluing{{t, 2, u, 2}};
  for (std::uint32_t s = 0; s < surface.side_count(); ++s) {
    const std::uint32_t p = surface.partner(SideId(s)).number();
    if (s < p && s != side && s != other) gluing.push_back({place(s) / 3, place(s) % 3, place(p) / 3, place(p) % 3});
  }
  return {std::move(tiles), std::move(gluing)};
}

TEST(ImportedNet, AnExportedNetIsTheSameNet) {
  for (const Surface& surface : {random_octagon(123), pants("7")}) {
    const CertifiedNet original = certified_net(surface, Length("0.3"));
    const TriangulationStream stream = triangulation_stream(original.document);
    const certify::NetDocument net = net_of_tiles(develop(stream, "stream"), Length("0.3"));
    const certify::Certificate certificate = certify::check(net);
    EXPECT_EQ(certificate.verdict, certify::Verdict::verified) << certificate.rule << ": " << certificate.message;
    EXPECT_EQ(certificate.counts.vertices, original.document.vertices.size());
    EXPECT_EQ(certificate.counts.triangles, original.document.triangles.size());
    // The same points: the enclosures of the two meet in the last digits.
    EXPECT_LT(certificate.enclosures->largest_circumradius.lower,
              original.certificate.enclosures->largest_circumradius.upper);
    EXPECT_GT(certificate.enclosures->largest_circumradius.upper,
              original.certificate.enclosures->largest_circumradius.lower);
    EXPECT_LT(certificate.enclosures->shortest_edge->lower, original.certificate.enclosures->shortest_edge->upper);
    EXPECT_GT(certificate.enclosures->shortest_edge->upper, original.certificate.enclosures->shortest_edge->lower);
    // And the same triangulation, exactly, darts in the same places.
    EXPECT_EQ(triangulation_stream(net).edges, stream.edges);
    EXPECT_EQ(triangulation_stream(net).triangles, stream.triangles);
  }
}

TEST(ImportedNet, VerticesAreTheGivenOnesExactly) {
  for (const auto& path : test::data_files("triangulations")) {
    const Surface surface = test::imported(path);
    const certify::NetDocument net = net_of_tiles(surface, Length("1"));
    ASSERT_EQ(net.vertices.size(), surface.vertex_class_count());
    for (const certify::NetDocument::Vertex& vertex : net.vertices) {
      const certify::NetDocument::Chart& chart = net.charts[vertex.chart];
      EXPECT_EQ(std::make_pair(vertex.x, vertex.y), std::make_pair(0., 0.));
      const Tile& tile = surface.tiles()[chart.tile];
      EXPECT_NE(std::find(tile.begin(), tile.end(), from_gmp(chart.centre)), tile.end());
    }
    EXPECT_EQ(triangulation_stream(net).edges, read_triangulation_stream(test::file_text(path), "sample").edges);
  }
}

TEST(ImportedNet, WrongEpsilonIsRefutedWithTheCulprit) {
  const TriangulationStream stream = triangulation_stream(certified_net(random_octagon(123), Length("0.3")).document);
  const certify::Certificate smaller = verdict_on(stream, "0.29");
  EXPECT_EQ(smaller.verdict, certify::Verdict::refuted);
  EXPECT_EQ(smaller.rule, "covering");
  EXPECT_THAT(smaller.message, HasSubstr("triangle "));
  const certify::Certificate larger = verdict_on(stream, "0.32");
  EXPECT_EQ(larger.verdict, certify::Verdict::refuted);
  EXPECT_EQ(larger.rule, "packing");
  EXPECT_THAT(larger.message, HasSubstr("dart "));
}

TEST(ImportedNet, AFlippedEdgeIsRefutedAndNamed) {
  const Surface surface = develop(triangulation_stream(certified_net(pants("7"), Length("0.5")).document), "net");
  std::size_t flips = 0;
  for (std::uint32_t side = 0; side < surface.side_count() && flips < 10; ++side) {
    std::optional<Surface> bad;
    try {
      bad = flipped(surface, side);
    } catch (const SurfaceError&) {
      continue;  // Not convex.
    }
    ++flips;
    const TriangulationStream stream = triangulation_stream(*bad);
    const certify::Certificate certificate = verdict_on(stream, "0.5");
    EXPECT_EQ(certificate.verdict, certify::Verdict::refuted);
    EXPECT_EQ(certificate.rule, "delaunay");
    const std::uint32_t culprit = std::min(3 * (side / 3) + 2, 3 * (surface.partner(SideId(side)).number() / 3) + 2);
    EXPECT_THAT(certificate.message, HasSubstr("dart " + std::to_string(culprit) + " "));
    EXPECT_EQ(certificate.counts.vertices, surface.vertex_class_count());
  }
  EXPECT_EQ(flips, 10U);
}

TEST(ImportedNet, TheDiagonalsOfAnOctagonAreRefutedAsNotDelaunay) {
  // Nothing flips the given diagonals.
  const certify::NetDocument net =
      net_of_tiles(develop(triangulation_stream(random_octagon(1)), "octagon"), Length("3"));
  ASSERT_EQ(net.vertices.size(), 1U);
  const certify::Certificate certificate = certify::check(net);
  EXPECT_EQ(certificate.verdict, certify::Verdict::refuted);
  EXPECT_EQ(certificate.rule, "delaunay");
}

TEST(ImportedNet, TilesMustBeTriangles) {
  EXPECT_THROW(static_cast<void>(net_of_tiles(random_octagon(1), Length("1"))), ExchangeError);
  EXPECT_THROW(static_cast<void>(net_of_tiles(Surface::regular(2), Length("1"))), ExchangeError);
}

RC_GTEST_PROP(ImportedNetProperty, WhateverIsImportedIsMadeOfTheGivenTriangles, ()) {
  const auto seed = *rc::gen::inRange<std::int32_t>(-1000, 1000);
  const std::string epsilon = *rc::gen::element<std::string>("0.4", "0.6", "1");
  const UncertifiedNet made = compute_net(random_octagon(seed), Length(epsilon));
  const TriangulationStream stream = triangulation_stream(made.document);
  const certify::NetDocument net = net_of_tiles(develop(stream, "stream"), Length(epsilon));
  RC_ASSERT(certify::check(net, {.threads = 1}).verdict == certify::Verdict::verified);
  RC_ASSERT(triangulation_stream(net).edges == stream.edges);
}

}  // namespace
}  // namespace epsnet::imported_net_test
