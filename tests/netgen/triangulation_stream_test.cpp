#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certify/file/file.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"
#include "tests/support/triangulations.h"
#include "triangulation/surface/exact_polygons.h"

namespace epsnet::triangulation_stream_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string sample_text(const std::string& name) {
  return test::file_text(std::string(EPSNET_TEST_DATA) + "/triangulations/triangulation-" + name + ".txt");
}
TriangulationStream sample(const std::string& name = "g2-e0.2") {
  return read_triangulation_stream(sample_text(name), name);
}

std::string text_of(const TriangulationStream& stream) {
  std::ostringstream out;
  write_triangulation_stream(stream, out);
  return out.str();
}

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(develop(read_triangulation_stream(text, "f.txt"), "f.txt"));
  } catch (const ExchangeError& error) {
    return error.what();
  }
  return "accepted";
}
std::string complaint(const TriangulationStream& stream) { return complaint(text_of(stream)); }

/// The text with one of its lines replaced, counted from 1.
std::string with_line(const std::string& text, std::size_t line, const std::string& replacement) {
  std::istringstream in(text);
  std::string result;
  std::string old;
  for (std::size_t i = 1; std::getline(in, old); ++i) result += (i == line ? replacement : old) + "\n";
  return result;
}

/// The triangulation with these triangles (dart 3t + i is side i of triangle t), and cross-ratios by the book: the
/// triangle across is moved beside the edge. Nothing is checked.
TriangulationStream glued(const std::vector<Tile>& triangles,
                          const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges) {
  TriangulationStream stream;
  stream.anchors = {{0, {triangles[0][0], triangles[0][1], triangles[0][2]}}};
  for (std::uint32_t t = 0; t < triangles.size(); ++t) stream.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  const auto point = [&](std::uint32_t dart, std::uint32_t k) { return triangles[dart / 3][(dart % 3 + k) % 3]; };
  for (const auto& [d, e] : edges) {
    const auto z0 = point(d, 0);
    const auto z2 = point(d, 1);
    const auto z3 = point(d, 2);
    const auto z1 = segment_to_segment(point(e, 1), point(e, 0), z0, z2)(point(e, 2));
    stream.edges.push_back({d, e, ((z3 - z1) * (z2 - z0)) / ((z3 - z0) * (z2 - z1))});
  }
  return stream;
}

/// A polygon cut by the diagonals from its vertex 0.
TriangulationStream fan(const test::PairedPolygon& polygon) {
  const auto n = static_cast<std::uint32_t>(polygon.vertices.size());
  std::vector<Tile> triangles;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::uint32_t t = 0; t + 2 < n; ++t) {
    triangles.push_back({polygon.vertices[0], polygon.vertices[t + 1], polygon.vertices[t + 2]});
    if (t > 0) edges.emplace_back(3 * t - 1, 3 * t);
  }
  const auto dart = [&](std::uint32_t side) {
    return side == 0 ? 0 : side + 1 == n ? 3 * (n - 3) + 2 : 3 * (side - 1) + 1;
  };
  for (std::uint32_t s = 0; s < n; ++s) {
    if (s < polygon.partner[s]) edges.emplace_back(dart(s), dart(polygon.partner[s]));
  }
  return glued(triangles, edges);
}

/// Cross-ratios by darts, whatever the order of edges.
std::vector<Complex<Rational>> ratios(const TriangulationStream& stream) {
  std::vector<Complex<Rational>> result(3 * stream.triangles.size());
  for (const auto& edge : stream.edges) result[edge.dart] = result[edge.opposite] = edge.cross_ratio;
  return result;
}

/// Largest number of digits of a coordinate.
std::size_t height(const Surface& surface) {
  std::size_t result = 0;
  for (const Tile& tile : surface.tiles()) {
    for (const auto& z : tile) result = std::max({result, z.x.str().size(), z.y.str().size()});
  }
  return result;
}

TEST(TriangulationStream, AllSamplesAreAccepted) {
  const auto files = test::data_files("triangulations");
  ASSERT_EQ(files.size(), 6U);
  for (const auto& path : files) {
    const std::string name = path.stem().string();  // triangulation-gN-…
    const std::string text = test::file_text(path);
    const TriangulationStream stream = read_triangulation_stream(text, name);
    const Surface surface = test::imported(path);
    EXPECT_EQ(surface.genus(), std::stoul(name.substr(name.find("-g") + 2))) << name;
    EXPECT_EQ(surface.tiles().size(), stream.triangles.size()) << name;
    EXPECT_EQ(triangulation_stream(surface), stream) << name;
    EXPECT_EQ(text_of(stream), text) << name;
    EXPECT_LT(height(surface), 300U) << name;
  }
}

TEST(TriangulationStream, CrossRatiosAreThoseOfTheDefinition) {
  for (const auto& path : test::data_files("triangulations")) {
    const Surface surface = test::imported(path);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const SideId s : surface.side_ids()) {
      if (s < surface.partner(s)) edges.emplace_back(s.number(), surface.partner(s).number());
    }
    EXPECT_EQ(glued(surface.tiles(), edges), read_triangulation_stream(test::file_text(path), "sample")) << path;
  }
}

TEST(TriangulationStream, APolygonKeepsItsSurfaceAsATriangulation) {
  for (const auto& path : test::data_files("polygons")) {
    const Surface polygon = test::imported(path);
    const TriangulationStream stream = triangulation_stream(polygon);
    EXPECT_EQ(ratios(stream), ratios(fan(test::paired_polygon(polygon)))) << path;
    const Surface surface = develop(stream, "polygon");
    EXPECT_EQ(surface.genus(), polygon.genus()) << path;
    EXPECT_EQ(surface.vertex_class_count(), polygon.vertex_class_count()) << path;
    EXPECT_EQ(triangulation_stream(surface), stream) << path;
    EXPECT_LT(height(surface), 8 * height(polygon)) << path;
  }
}

TEST(TriangulationStream, TheNumberOfDartsIsAPositiveMultipleOf6) {
  EXPECT_THAT(complaint(""), StartsWith("f.txt:1: the text ends here, expected the number of darts"));
  EXPECT_THAT(complaint("thirty"), StartsWith("f.txt:1: \"thirty\" found, expected the number of darts"));
  EXPECT_THAT(complaint("0 no"), HasSubstr("0 darts found, expected a positive multiple of 6"));
  EXPECT_THAT(complaint("-6 no"), HasSubstr("\"-6\" found"));
  EXPECT_THAT(complaint("\n32 yes"), StartsWith("f.txt:2: 32 darts found, expected a positive multiple of 6"));
  EXPECT_THAT(complaint("4294967296 no"), HasSubstr("expected the number of darts"));
}

TEST(TriangulationStream, ThereAreNoMoreDartsThanBytes) {
  const std::string text = with_line(sample_text("g2-e0.2"), 1, "1000000002");
  EXPECT_THAT(complaint(text), StartsWith("f.txt:1: the text claims 1000000002 darts, but has only "));
  EXPECT_THAT(complaint(with_line(sample_text("g2-e0.2"), 1, "36")),
              StartsWith("f.txt:37: dart 0 belongs to triangle 0 and to triangle 10"));
}

TEST(TriangulationStream, AnAnchorIsADartAndACounterclockwiseTriangleOfTheDisk) {
  const std::string good = sample_text("g2-e0.2");
  EXPECT_EQ(complaint(good), "accepted");
  EXPECT_THAT(complaint(with_line(good, 2, "maybe")),
              StartsWith("f.txt:2: \"maybe\" found, expected \"yes\" or \"no\""));
  EXPECT_THAT(complaint(with_line(good, 3, "30")),
              StartsWith("f.txt:3: 30 found, expected the dart of the anchor, from 0 to 29"));
  EXPECT_THAT(complaint(with_line(good, 4, "0 1/0")),
              StartsWith("f.txt:4: \"1/0\" found, expected the y coordinate of point 0 of the anchor: a rational"));
  EXPECT_THAT(complaint(with_line(good, 4, "0.5 0")), HasSubstr("\"0.5\" found, expected the x coordinate of point 0"));
  EXPECT_THAT(complaint(with_line(good, 5, "3/5 4/5")),
              StartsWith("f.txt: point 1 of the anchor, (0.6, 0.8), lies outside of the open unit disk"));
  EXPECT_THAT(complaint(with_line(good, 5, "-1/2 0")), HasSubstr("the points of the anchor are not counterclockwise"));
  EXPECT_THAT(complaint(with_line(good, 5, "0 0")), HasSubstr("the points of the anchor are not counterclockwise"));
  TriangulationStream stream = sample();
  stream.anchors.clear();
  EXPECT_EQ(read_triangulation_stream(text_of(stream), "copy"), stream);
  EXPECT_EQ(complaint(stream), "accepted");  // It is found.
}

/// As CGAL's Delaunay class writes it: every triangle with the coordinates of its tile, from its dart i on.
TriangulationStream with_all_anchors(TriangulationStream stream, std::uint32_t i) {
  const Surface surface = develop(stream, "stream");
  stream.anchors.clear();
  for (std::uint32_t t = 0; t < stream.triangles.size(); ++t) {
    const Tile& tile = surface.tiles()[t];
    stream.anchors.push_back({stream.triangles[t][i], {tile[i], tile[(i + 1) % 3], tile[(i + 2) % 3]}});
  }
  return stream;
}

TEST(TriangulationStream, AnAnchorForEachTriangleGivesTheSameSurface) {
  for (const auto& path : test::data_files("triangulations")) {
    const TriangulationStream stream = read_triangulation_stream(test::file_text(path), "sample");
    for (const std::uint32_t i : {0U, 1U, 2U}) {
      const TriangulationStream anchored = with_all_anchors(stream, i);
      const std::string text = text_of(anchored);
      EXPECT_TRUE(is_triangulation_stream(text)) << path;
      EXPECT_EQ(read_triangulation_stream(text, "anchored"), anchored) << path;
      EXPECT_EQ(import_surface(text, "anchored", ExchangeFormat::automatic).tiles(), develop(stream, "s").tiles())
          << path;
      EXPECT_EQ(import_surface(text, "anchored", ExchangeFormat::triangulation).tiles(), develop(stream, "s").tiles());
    }
  }
}

TEST(TriangulationStream, AnchorsOfTrianglesAreChecked) {
  const TriangulationStream stream = with_all_anchors(sample(), 1);
  const std::string good =
      text_of(stream);  // Triangle t is on the lines 10t + 2 to 10t + 11, edge e on 4e + 102 to 105.
  EXPECT_THAT(
      complaint(with_line(good, 15, "0")),
      StartsWith("f.txt:15: dart 0 found, expected the dart of the anchor of triangle 1, one of this triangle"));
  EXPECT_THAT(complaint(with_line(good, 15, "30")),
              StartsWith("f.txt:15: 30 found, expected the dart of the anchor of triangle 1, from 0 to 29"));
  EXPECT_THAT(complaint(with_line(good, 16, "0.5")),
              StartsWith("f.txt:16: \"0.5\" found, expected the x coordinate of point 0 of the anchor of triangle 1"));
  EXPECT_THAT(complaint(with_line(good, 16, "1")), StartsWith("f.txt: point 0 of the anchor of triangle 1, (1, "));
  EXPECT_THAT(complaint(good.substr(0, good.size() / 2)), HasSubstr("the text ends here, expected the "));
  EXPECT_THAT(complaint(good + "1"), HasSubstr("follows the last edge"));
  for (std::size_t t = 0; t < stream.anchors.size(); ++t) {
    TriangulationStream bad = stream;
    bad.anchors[t].points[2].x += Rational(1, 1'000'000'000);
    EXPECT_THAT(complaint(bad), HasSubstr("not those of a closed hyperbolic surface")) << t;
    bad = stream;
    std::rotate(bad.anchors[t].points.begin(), bad.anchors[t].points.begin() + 1, bad.anchors[t].points.end());
    EXPECT_THAT(complaint(bad), HasSubstr("not those of a closed hyperbolic surface")) << t;
    bad = stream;
    std::swap(bad.anchors[t].points[0], bad.anchors[t].points[1]);
    EXPECT_THAT(complaint(bad),
                HasSubstr("the points of the anchor of triangle " + std::to_string(t) + " are not counterclockwise"));
  }
  for (std::size_t e = 0; e < stream.edges.size(); ++e) {
    TriangulationStream bad = stream;
    bad.edges[e].cross_ratio.y += Rational(1, 1'000'000'000);
    EXPECT_THAT(complaint(bad), HasSubstr(" by the text, and by the anchors (")) << e;
  }
}

TEST(TriangulationStream, PolygonsAreNotTakenForTriangulations) {
  for (const char* const folder : {"polygons", "octagons"}) {
    for (const auto& path : test::data_files(folder)) EXPECT_FALSE(is_triangulation_stream(test::file_text(path)));
  }
  EXPECT_FALSE(is_triangulation_stream(""));
  EXPECT_FALSE(is_triangulation_stream("18 0 2 1"));
  EXPECT_FALSE(is_triangulation_stream("18 3 4 5 0 1 2 9 10 11 6 7 8"));
  EXPECT_TRUE(is_triangulation_stream("18 0 2 1 0 0 0 1/2"));
}

TEST(TriangulationStream, EveryDartIsInOneTriangle) {
  const std::string good = sample_text("g2-e0.2");  // Triangle t is on the lines 3t + 7 to 3t + 9.
  EXPECT_THAT(complaint(with_line(good, 10, "30")),
              StartsWith("f.txt:10: 30 found, expected the first dart of triangle 1, from 0 to 29"));
  EXPECT_THAT(complaint(with_line(good, 11, "-1")),
              StartsWith("f.txt:11: \"-1\" found, expected the dart before the first one of triangle 1"));
  EXPECT_THAT(complaint(with_line(good, 12, "3")), StartsWith("f.txt:12: dart 3 occurs twice in triangle 1"));
  EXPECT_THAT(complaint(with_line(good, 12, "2")),
              StartsWith("f.txt:12: dart 2 belongs to triangle 0 and to triangle 1"));
  // With darts 0 and 1 exchanged the triangle is on the wrong side of its neighbours.
  TriangulationStream stream = sample();
  std::swap(stream.triangles[1][0], stream.triangles[1][1]);
  EXPECT_THAT(complaint(stream), HasSubstr("cross-ratio"));
}

TEST(TriangulationStream, EveryDartIsInOneEdgeWithARationalCrossRatio) {
  const std::string good = sample_text("g2-e0.2");  // Edge e is on the lines 4e + 37 to 4e + 40.
  EXPECT_THAT(complaint(with_line(good, 38, "99")),
              StartsWith("f.txt:38: 99 found, expected the second dart of edge 0, from 0 to 29"));
  EXPECT_THAT(complaint(with_line(good, 38, "0")), StartsWith("f.txt:38: dart 0 occurs twice in edge 0"));
  EXPECT_THAT(complaint(with_line(good, 41, "7")), StartsWith("f.txt:41: dart 7 belongs to edge 0 and to edge 1"));
  EXPECT_THAT(complaint(with_line(good, 39, "1/0")),
              StartsWith("f.txt:39: \"1/0\" found, expected the real part of the cross-ratio of edge 0: a rational"));
  EXPECT_THAT(complaint(with_line(good, 40, "i")), HasSubstr("the imaginary part of the cross-ratio of edge 0"));
  EXPECT_THAT(complaint(with_line(good, 40, std::string(1'000'001, '1'))), HasSubstr("of at most 10^6 digits"));
  EXPECT_THAT(complaint(good + "5"), StartsWith("f.txt:97: \"5\" follows the last edge, expected the end of the text"));
  EXPECT_THAT(complaint(good + std::string(1, '\0')), HasSubstr("follows the last edge"));
  EXPECT_EQ(complaint(good + " \r\n\t\v\f\n"), "accepted");
}

TEST(TriangulationStream, NoTruncatedTextIsAccepted) {
  const std::string good = sample_text("g2-e0.2");
  for (std::size_t length = 0; length + 1 < good.size(); ++length) {
    EXPECT_NE(complaint(good.substr(0, length)), "accepted") << length;
  }
}

TEST(TriangulationStream, NumbersHaveAtMostAMillionDigits) {
  const std::string nines(1'000'000, '9');
  const std::string almost_one = std::string(499'999, '9') + "/1" + std::string(499'999, '0');
  const std::string good = sample_text("g2-e0.2");
  EXPECT_THAT(complaint(with_line(good, 39, nines)), HasSubstr("more than 10^6 digits"));
  EXPECT_THAT(complaint(with_line(good, 39, almost_one)), HasSubstr("more than 10^6 digits"));
  EXPECT_THAT(complaint(with_line(good, 5, almost_one + " 0")), HasSubstr("cross-ratio"));
}

TEST(TriangulationStream, NumbersMayNotGrowWithoutEnd) {
  // Every cross-ratio is right to 400,000 digits, so no other error is found first.
  TriangulationStream stream = sample();
  Integer far = 1;
  far <<= 1'500'000;
  for (auto& edge : stream.edges) edge.cross_ratio.x += Rational(Integer(1), far);
  EXPECT_THAT(complaint(stream), HasSubstr(" has more than 10^6 digits, which no surface file can hold"));
}

TEST(TriangulationStream, EveryNumberCounts) {
  const TriangulationStream good = sample();
  const Rational little(1, 1'000'000'000);
  for (std::size_t e = 0; e < good.edges.size(); ++e) {
    TriangulationStream bad = good;
    bad.edges[e].cross_ratio.x += little;
    EXPECT_THAT(complaint(bad), HasSubstr("not those of a closed hyperbolic surface")) << e;
    bad = good;
    bad.edges[e].cross_ratio.y += little;
    EXPECT_THAT(complaint(bad), HasSubstr("not those of a closed hyperbolic surface")) << e;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    TriangulationStream bad = good;
    bad.anchors[0].points[i].x -= little;
    EXPECT_THAT(complaint(bad), HasSubstr("not those of a closed hyperbolic surface")) << i;
  }
  // Another circle of the plane as the unit circle.
  TriangulationStream bad = good;
  for (auto& z : bad.anchors[0].points) z = Rational(99, 100) * z;
  EXPECT_THAT(complaint(bad), HasSubstr("not those of a closed hyperbolic surface"));
}

TEST(TriangulationStream, MessagesNameEdges) {
  TriangulationStream stream = sample();
  stream.edges.back().cross_ratio.x += 1;
  EXPECT_THAT(complaint(stream), AllOf(StartsWith("f.txt: the edge of darts 25 and 28 has the cross-ratio ("),
                                       HasSubstr(" by the text, and by the other cross-ratios (")));
  stream = sample();
  stream.edges[0].cross_ratio.x += Rational(1, 1000);
  EXPECT_THAT(complaint(stream), testing::MatchesRegex("f.txt: the edge of darts .* and .* has length .* in triangle "
                                                       ".* and .* in triangle .*: these cross-ratios are .*"));
}

TEST(TriangulationStream, ThirdVerticesLieInTheDiskBeyondTheEdge) {
  const TriangulationStream good = sample();
  const Complex<Rational> a = good.anchors[0].points[0];  // Lambdas of clang 14 do not capture structured bindings.
  const Complex<Rational> b = good.anchors[0].points[1];
  const Complex<Rational> c = good.anchors[0].points[2];
  const auto with_third = [&](const Complex<Rational>& d) {
    TriangulationStream stream = good;
    stream.edges[0].cross_ratio = cross_ratio(a, d, b, c);  // The edge of darts 0 and 7, triangles 0 and 2.
    return complaint(stream);
  };
  const std::string third = "the third vertex of triangle 2, beyond the edge of darts 0 and 7, ";
  EXPECT_THAT(with_third(Rational(1, 3) * (a + b + c)),
              AllOf(StartsWith("f.txt: triangle 2 is not counterclockwise: " + third),
                    HasSubstr("expected a geometric triangulation")));
  EXPECT_THAT(with_third({Rational(3), Rational(1)}),
              StartsWith("f.txt: " + third + "lies outside of the open unit disk, at (3, 1) as seen from triangle 0"));
  EXPECT_THAT(with_third({Rational(0), Rational(1)}), HasSubstr(third + "lies outside of the open unit disk"));
  EXPECT_THAT(with_third(a), HasSubstr("triangle 2 is not counterclockwise"));
  TriangulationStream stream = good;
  stream.edges[0].cross_ratio = (b - a) / (c - a);
  EXPECT_THAT(complaint(stream), StartsWith("f.txt: " + third + "is the point at infinity"));
}

TEST(TriangulationStream, AConePointIsRefusedThoughAllCrossRatiosAreRight) {
  // Still with sides of equal lengths, but the angles do not add up to 2π: all cross-ratios are right.
  test::PairedPolygon polygon = test::paired_polygon(random_octagon(123));
  EXPECT_EQ(complaint(fan(polygon)), "accepted");
  polygon.vertices[3].x += Rational(1, 1000);
  polygon.vertices[7].x -= Rational(1, 1000);
  EXPECT_THAT(
      complaint(fan(polygon)),
      AllOf(StartsWith("f.txt: not a closed hyperbolic surface: the 18 angles around tile 0, vertex 0 add up to "
                       "6.2"),
            HasSubstr("tile t is triangle t of the text")));
}

TEST(TriangulationStream, ASphereAndTwoSurfacesAreRefused) {
  const Tile triangle{{Rational(0), Rational(0)}, {Rational(1, 2), Rational(0)}, {Rational(1, 5), Rational(1, 3)}};
  const Tile mirrored{triangle[1], triangle[0], conj(triangle[2])};
  EXPECT_THAT(complaint(glued({triangle, mirrored}, {{0, 3}, {1, 5}, {2, 4}})), HasSubstr("is a sphere (genus 0)"));
  TriangulationStream two = sample();
  const auto darts = static_cast<std::uint32_t>(3 * two.triangles.size());
  for (const auto& [a, b, c] : sample().triangles) two.triangles.push_back({a + darts, b + darts, c + darts});
  for (const auto& edge : sample().edges)
    two.edges.push_back({edge.dart + darts, edge.opposite + darts, edge.cross_ratio});
  EXPECT_THAT(complaint(two), StartsWith("f.txt: the surface is not connected: no path of edges leads from the anchor "
                                         "to triangle 10"));
}

TEST(TriangulationStream, TheFormatIsDetectedUnlessItIsGiven) {
  const std::string triangulation = sample_text("g2-e0.2");
  const std::string domain = test::domain_text(test::paired_polygon(random_octagon(123)));
  EXPECT_TRUE(is_triangulation_stream(triangulation));
  EXPECT_TRUE(is_triangulation_stream("\n x  no"));
  for (const std::string text : {"", " ", "8", "8 ", "8 nobody", "8 yesno", "yes no 1", "yes"}) {
    EXPECT_EQ(is_triangulation_stream(text), text == "yes no 1") << text;
  }
  EXPECT_FALSE(is_triangulation_stream(domain));
  const auto tiles = [](const std::string& text, ExchangeFormat format) -> std::string {
    try {
      return std::to_string(import_surface(text, "f.txt", format).tiles().size());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(tiles(triangulation, ExchangeFormat::automatic), "10");
  EXPECT_EQ(tiles(triangulation, ExchangeFormat::triangulation), "10");
  EXPECT_THAT(tiles(triangulation, ExchangeFormat::domain),
              StartsWith("f.txt:2: \"yes\" found, expected the index of"));
  EXPECT_EQ(tiles(domain, ExchangeFormat::automatic), "1");
  EXPECT_EQ(tiles(domain, ExchangeFormat::domain), "1");
  EXPECT_THAT(tiles(domain, ExchangeFormat::triangulation), HasSubstr("8 darts found, expected a positive"));
  EXPECT_THAT(tiles("8 4", ExchangeFormat::automatic),
              HasSubstr("(read as the domain format: the second token is nei"));
  EXPECT_THAT(tiles("8 4", ExchangeFormat::domain), testing::Not(HasSubstr("read as")));
}

TEST(TriangulationStream, AnEmptyTextIsAnError) {
  EXPECT_THROW((void)import_surface("", "empty", ExchangeFormat::triangulation), ExchangeError);
}

std::string net_complaint(const certify::NetDocument& net) {
  try {
    static_cast<void>(triangulation_stream(net));
  } catch (const ExchangeError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(TriangulationStream, ADocumentThatIsNoNetIsRefused) {
  const certify::NetDocument good = compute_net(random_octagon(123), Length("0.5")).document;
  EXPECT_EQ(net_complaint(good), "accepted");
  EXPECT_THAT(net_complaint({}), StartsWith("not a net: "));
  certify::NetDocument net = good;
  net.triangles[3].vertex[1] = 1'000'000;
  EXPECT_THAT(net_complaint(net), StartsWith("not a net: "));
  net = good;
  std::swap(net.triangles[3].opposite[0], net.triangles[3].opposite[1]);
  EXPECT_THAT(net_complaint(net), HasSubstr("and its opposite"));
  net = good;
  net.surface.tiles[0][3].x += mpq_class(1, 1000);
  EXPECT_THAT(net_complaint(net), StartsWith("not a net: side "));
  net = good;
  const auto moved = std::find_if(net.triangles.begin(), net.triangles.end(),
                                  [](const certify::NetDocument::Triangle& t) { return t.label[0] != 0; });
  ASSERT_NE(moved, net.triangles.end());
  net.labels[moved->label[0] - 1].word.clear();
  net.labels[moved->label[0] - 1].to = net.labels[moved->label[0] - 1].from;
  EXPECT_NE(net_complaint(net), "accepted");
}

RC_GTEST_PROP(TriangulationStreamProperty, NetThereAndBack, ()) {
  const auto seed = *rc::gen::inRange<std::int32_t>(-1000, 1000);
  const std::string epsilon = *rc::gen::element<std::string>("0.3", "0.5", "0.8", "2");
  const certify::NetDocument net = compute_net(random_octagon(seed), Length(epsilon)).document;
  const TriangulationStream stream = triangulation_stream(net);
  RC_ASSERT(stream.triangles.size() == net.triangles.size());
  // The README of the format: not Delaunay if and only if the imaginary part is positive.
  for (const auto& edge : stream.edges) RC_ASSERT(edge.cross_ratio.y <= 0);
  RC_ASSERT(read_triangulation_stream(text_of(stream), "net") == stream);
  const Surface surface = develop(stream, "net");
  RC_ASSERT(surface.genus() == 2U);
  RC_ASSERT(surface.vertex_class_count() == net.vertices.size());
  RC_ASSERT(triangulation_stream(surface) == stream);
}

RC_GTEST_PROP(TriangulationStreamProperty, AnyPlaceOfTheAnchorIsTheSameSurface, ()) {
  const auto files = test::data_files("triangulations");
  const auto& path = files[test::any_index(files.size())];
  TriangulationStream stream = read_triangulation_stream(test::file_text(path), "sample");
  const Surface before = develop(stream, "sample");
  const auto t = test::any_index(static_cast<std::uint32_t>(before.tiles().size()));
  const auto i = test::any_index(3U);
  const auto isometry = *test::isometries();
  stream.anchors[0].dart = stream.triangles[t][i];
  for (std::size_t k = 0; k < 3; ++k) stream.anchors[0].points[k] = isometry(before.tiles()[t][(i + k) % 3]);
  const Surface after = develop(stream, "moved");
  RC_ASSERT(triangulation_stream(after).edges == triangulation_stream(before).edges);
}

RC_GTEST_PROP(TriangulationStreamProperty, NumbersOfDartsDoNotMatter, ()) {
  const auto files = test::data_files("triangulations");
  TriangulationStream stream =
      read_triangulation_stream(test::file_text(files[test::any_index(files.size())]), "sample");
  const auto before = develop(stream, "sample");
  std::vector<std::uint32_t> number(3 * stream.triangles.size());
  std::iota(number.begin(), number.end(), 0U);
  for (std::size_t k = number.size(); k > 1; --k) std::swap(number[k - 1], number[test::any_index(k)]);
  stream.anchors[0].dart = number[stream.anchors[0].dart];
  for (auto& [a, b, c] : stream.triangles) {
    a = number[a];
    b = number[b];
    c = number[c];
  }
  for (auto& [dart, opposite, ratio] : stream.edges) {
    dart = number[dart];
    opposite = number[opposite];
    if (*rc::gen::arbitrary<bool>()) std::swap(dart, opposite);
  }
  std::reverse(stream.edges.begin(), stream.edges.end());
  const Surface after = develop(read_triangulation_stream(text_of(stream), "renumbered"), "renumbered");
  RC_ASSERT(after.tiles() == before.tiles());
  // The order of the triangles, and of the darts in them, does not matter either.
  std::rotate(stream.triangles.begin(), stream.triangles.begin() + 3, stream.triangles.end());
  for (auto& triangle : stream.triangles) {
    std::rotate(triangle.begin(), triangle.begin() + test::any_index(3), triangle.end());
  }
  const Surface again = develop(read_triangulation_stream(text_of(stream), "rotated"), "rotated");
  RC_ASSERT(again.genus() == before.genus());
  RC_ASSERT(again.vertex_class_count() == before.vertex_class_count());
}

RC_GTEST_PROP(TriangulationStreamProperty, ChangedByteIsAnErrorOrTheSame, (std::uint8_t byte)) {
  const std::string good = sample_text("g2-e0.2");
  std::string text = good;
  const auto i = test::any_index(text.size());
  text[i] = static_cast<char>(byte);
  try {
    const Surface surface = develop(read_triangulation_stream(text, "f"), "f");
    // White space, or a surface with another lift of the anchor: there is no other one close by.
    RC_ASSERT(ratios(triangulation_stream(surface)) == ratios(sample()));
  } catch (const ExchangeError& error) {
    RC_ASSERT(std::string(error.what()).find('\n') == std::string::npos);
  }
}

}  // namespace
}  // namespace epsnet::triangulation_stream_test
