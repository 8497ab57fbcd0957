#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "certify/file/file.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"

namespace epsnet::domain_format_test {
namespace {

// What keeps a reference cannot be made from a temporary.
static_assert(std::is_constructible_v<TokenReader, const std::string&, std::string>);
static_assert(!std::is_constructible_v<TokenReader, std::string, std::string>);

using test::PairedPolygon;
using testing::HasSubstr;
using testing::StartsWith;

PairedPolygon octagon() { return test::paired_polygon(random_octagon(123)); }

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(read_domain(text, "f.txt"));
  } catch (const ExchangeError& error) {
    return error.what();
  }
  return "accepted";
}

std::string complaint(const PairedPolygon& polygon) { return complaint(test::domain_text(polygon)); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(DomainFormat, AllPolygonsAreAccepted) {
  const auto files = test::data_files("polygons");
  ASSERT_EQ(files.size(), 21U);
  for (const auto& path : files) {
    const std::string name = path.stem().string();  // polygon-gN-…
    const Surface surface = test::imported(path);
    EXPECT_EQ(surface.genus(), std::stoul(name.substr(name.find("-g") + 2))) << path;
    EXPECT_EQ(surface.tiles().size(), 1U) << path;
    EXPECT_EQ(read_domain(write_domain(surface), "copy").tiles(), surface.tiles()) << path;
  }
}

TEST(DomainFormat, TheNumberOfSidesIsEvenAndAtLeast8) {
  EXPECT_THAT(complaint(""), StartsWith("f.txt:1: the text ends here, expected the number of sides"));
  EXPECT_THAT(complaint("eight"), StartsWith("f.txt:1: \"eight\" found, expected the number of sides"));
  EXPECT_THAT(complaint("-8 "), HasSubstr("\"-8\" found"));
  EXPECT_THAT(complaint("8.0"), HasSubstr("\"8.0\" found"));
  EXPECT_THAT(complaint("99999999999999999999"), HasSubstr("expected the number of sides"));
  EXPECT_THAT(complaint("4 2 3 0 1"), HasSubstr("4 sides found, expected an even number, at least 8"));
  EXPECT_THAT(complaint("9"), HasSubstr("9 sides found"));
}

TEST(DomainFormat, MemoryDoesNotGrowWithTheNumberOfSidesClaimed) {
  EXPECT_THAT(complaint("1000000000\n1\n0\n"), StartsWith("f.txt:4: the text ends here, expected the index of the side "
                                                          "paired with side 2, from 0 to 999999999 (the text claims "));
}

TEST(DomainFormat, ThePairingIsAnInvolutionWithoutFixedSides) {
  EXPECT_THAT(complaint("8\n4 5 6 7\n0 1 2 8\n"),
              StartsWith("f.txt:3: 8 found, expected the index of the side paired with side 7"));
  EXPECT_THAT(complaint("8\n4 -5 6 7\n0 1 2 3\n"),
              StartsWith("f.txt:2: \"-5\" found, expected the index of the side paired with side 1"));
  EXPECT_THAT(complaint("8\n4 5 2 7\n0 1 2 3\n"), StartsWith("f.txt:2: side 2 is paired with itself"));
  EXPECT_THAT(complaint("8\n4\n5\n6\n7\n0\n1\n2\n1\n"),
              StartsWith("f.txt:5: side 3 is paired with side 7, but side 7 with side 1"));
}

TEST(DomainFormat, CoordinatesAreRationalsInTheOpenDisk) {
  const std::string good = test::domain_text(octagon());
  EXPECT_EQ(complaint(good), "accepted");
  EXPECT_EQ(complaint(replaced(good, "3769/5000", "0003769000/0005000000")), "accepted");
  for (const std::string bad : {"0.7538", "7.538e-1", "nan", "NaN", "inf", "3769/0", "3769/-5000", "3769/", "/5000",
                                "+3769/5000", "0x1p-1", "--1", "3769/5000/1", "3769 /5000"}) {
    EXPECT_THAT(complaint(replaced(good, "3769/5000", bad)), StartsWith("f.txt:10: ")) << bad;
  }
  EXPECT_THAT(complaint(replaced(good, "3769/5000", "0.7538")),
              HasSubstr("\"0.7538\" found, expected the x coordinate of vertex 0: a rational number p/q or p of at "
                        "most 10^6 digits (decimals are not accepted)"));
  EXPECT_THAT(complaint(replaced(good, "3769/5000", std::string(1'000'001, '1'))), HasSubstr("of at most 10^6 digits"));
  EXPECT_THAT(complaint(replaced(good, "3769/5000", std::string(1'000'000, '1'))),
              HasSubstr("vertex 0 lies outside of the open unit disk"));
  EXPECT_THAT(complaint(replaced(good, "3769/5000", "1")),
              StartsWith("f.txt:10: vertex 0 lies outside of the open unit disk, expected |z| < 1, found |z|^2 = 1"));
  EXPECT_THAT(complaint(good + " 7"), StartsWith("f.txt:18: \"7\" follows the last vertex"));
  EXPECT_THAT(complaint(good + std::string(1, '\0')), HasSubstr("follows the last vertex"));
  EXPECT_EQ(complaint(good + " \r\n\t\v\f\n"), "accepted");
}

TEST(DomainFormat, NoTruncatedTextIsAccepted) {
  const std::string good = test::domain_text(octagon());
  for (std::size_t length = 0; length + 1 < good.size(); ++length) {
    EXPECT_NE(complaint(good.substr(0, length)), "accepted") << length;
  }
}

TEST(DomainFormat, PolygonsThatGiveNoSurfaceAreRefusedWithTheReason) {
  PairedPolygon polygon = octagon();
  polygon.vertices[3].x += Rational(1, 1000);
  EXPECT_THAT(complaint(polygon),
              testing::MatchesRegex("f.txt: side 2 \\(length .*\\) and side 6 \\(length .*\\) are paired but differ"));
  polygon.vertices[7].x -= Rational(1, 1000);
  EXPECT_THAT(complaint(polygon), HasSubstr("f.txt: the 8 angles around vertex 0 add up to 6.2"));
  polygon = octagon();
  std::reverse(polygon.vertices.begin(), polygon.vertices.end());
  EXPECT_THAT(complaint(polygon), HasSubstr("f.txt: the polygon is clockwise"));
  polygon = octagon();
  polygon.partner = {1, 0, 3, 2, 5, 4, 7, 6};
  EXPECT_THAT(complaint(polygon), HasSubstr("sphere"));
  polygon.partner = {2, 3, 0, 1, 5, 4, 7, 6};
  EXPECT_THAT(complaint(polygon), HasSubstr("torus"));
}

TEST(DomainFormat, PolygonsThatIntersectThemselvesAreRefused) {
  const PairedPolygon good = octagon();
  PairedPolygon polygon = good;
  std::swap(polygon.vertices[2], polygon.vertices[3]);
  EXPECT_THAT(complaint(polygon), HasSubstr("the polygon intersects itself: side 1 meets side 3"));
  polygon = good;
  for (std::size_t k = 0; k < 8; ++k) polygon.vertices[k] = good.vertices[3 * k % 8];
  EXPECT_THAT(complaint(polygon), HasSubstr("the polygon intersects itself"));
  polygon = good;
  polygon.vertices[4] = polygon.vertices[0];
  EXPECT_THAT(complaint(polygon), HasSubstr("the polygon intersects itself"));
  polygon.vertices[1] = polygon.vertices[0];
  EXPECT_THAT(complaint(polygon), HasSubstr("side 0 has length 0"));
}

TEST(DomainFormat, LengthsAndAnglesOfNonConvexPolygonsAreChecked) {
  PairedPolygon polygon = octagon();
  polygon.vertices[2] = {Rational(1, 100), Rational(1, 10)};
  EXPECT_THAT(complaint(polygon), HasSubstr("are paired but differ"));
  polygon.vertices[6] = -polygon.vertices[2];
  EXPECT_THAT(complaint(polygon), HasSubstr("add up to"));
}

TEST(DomainFormat, NonConvexPolygonsHaveAtMost4096Sides) {
  const std::uint32_t n = 5000;
  PairedPolygon polygon;
  for (std::uint32_t k = 0; k < n; ++k) {
    polygon.partner.push_back((k + n / 2) % n);
    polygon.vertices.push_back({Rational(k, 2 * n), Rational(k % 2, 2 * n)});
  }
  EXPECT_THAT(complaint(polygon), HasSubstr("polygons that are not convex may have at most 4096 sides"));
}

TEST(DomainFormat, StraightAnglesBecomeVerticesOfTheSurface) {
  PairedPolygon polygon = test::with_vertex_on_side(octagon(), 2, Rational(1, 3));
  polygon = test::with_vertex_on_side(polygon, 3, Rational(2, 5));
  polygon = test::with_vertex_on_side(polygon, 0, Rational(1, 2));
  const Surface surface = read_domain(test::domain_text(polygon), "test");
  EXPECT_EQ(surface.genus(), 2U);
  EXPECT_EQ(surface.vertex_class_count(), 4U);
  EXPECT_EQ(surface.tiles().size(), 12U);
  EXPECT_THROW(static_cast<void>(write_domain(surface)), ExchangeError);
}

TEST(DomainFormat, StraightAnglesOfManySidesBecomeVerticesOfTheSurface) {
  PairedPolygon polygon =
      test::paired_polygon(test::imported(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-g50-small.txt"));
  for (std::uint32_t added = 0; added < 30; ++added)
    polygon = test::with_vertex_on_side(polygon, 7 * added, Rational(1, 2));
  ASSERT_EQ(polygon.partner.size(), 260U);
  const Surface surface = read_domain(test::domain_text(polygon), "test");
  EXPECT_EQ(surface.genus(), 50U);
  EXPECT_EQ(surface.vertex_class_count(), 31U);
  EXPECT_EQ(surface.tiles().size(), 258U);
}

TEST(DomainFormat, AnEmptyTextIsAnError) {
  EXPECT_THROW(static_cast<void>(import_surface("", "empty", ExchangeFormat::domain)), ExchangeError);
}

TEST(EarClipping, NoTriangleIsDegenerateAndContactsAreCrossings) {
  // A square with straight angles, a spike that points at it, in Klein coordinates over 10.
  const auto at = [](int x, int y) { return KleinVector{x, y, 10}; };
  const std::vector<KleinVector> polygon{at(-4, -4), at(0, -4), at(4, -4), at(4, 0),  at(4, 4),
                                         at(1, 4),   at(0, 0),  at(-1, 4), at(-4, 4), at(-4, 0)};
  EXPECT_FALSE(crossing_sides(polygon));
  const PolygonTriangulation triangulation = clip_ears(polygon);
  EXPECT_EQ(triangulation.triangles.size(), 8U);
  EXPECT_EQ(triangulation.diagonals.size(), 7U);
  for (const auto& [a, b, c] : triangulation.triangles) EXPECT_GT(orientation(polygon[a], polygon[b], polygon[c]), 0);
  // The spike reaches the opposite side.
  std::vector<KleinVector> touching = polygon;
  touching[6] = at(0, -4);
  EXPECT_TRUE(crossing_sides(touching));
  touching[6] = at(2, -4);
  EXPECT_TRUE(crossing_sides(touching));
  touching[6] = at(2, -3);
  EXPECT_FALSE(crossing_sides(touching));
  // Closer to the side than doubles can tell.
  const Integer scale("1" + std::string(40, '0'));
  for (const int below : {0, 1}) {
    touching[6] = {2 * scale, -4 * scale + 1 - below, 10 * scale};
    EXPECT_EQ(crossing_sides(touching).has_value(), below == 1);
  }
  touching[6] = at(2, -3);
  // The spike has no width.
  touching[7] = at(1, 4);
  EXPECT_TRUE(crossing_sides(touching));
}

RC_GTEST_PROP(DomainFormatProperty, NonConvexPolygonIsTheSameSurface, ()) {
  const auto files = test::data_files("polygons");
  PairedPolygon polygon = test::paired_polygon(test::imported(files[*rc::gen::inRange<std::size_t>(0, files.size())]));
  const Surface before = polygon.surface();
  const auto k = *rc::gen::inRange<std::uint32_t>(0, before.side_count());
  RC_PRE(before.partner(SideId(k)) != before.next_side(SideId(k)));
  polygon = test::cut_and_pasted(polygon, k);
  polygon = test::rotated(polygon, *rc::gen::inRange<std::uint32_t>(0, before.side_count()));
  polygon.vertices = test::moved(*test::isometries(), polygon.vertices);
  std::uint32_t vertices = before.vertex_class_count();
  if (*rc::gen::arbitrary<bool>()) {
    polygon =
        test::with_vertex_on_side(polygon, *rc::gen::inRange<std::uint32_t>(0, before.side_count()), Rational(1, 3));
    ++vertices;
  }
  const Surface after = read_domain(test::domain_text(polygon), "test");
  RC_ASSERT(after.genus() == before.genus());
  RC_ASSERT(after.vertex_class_count() == vertices);
  RC_CLASSIFY(after.tiles().size() > 1, "not convex");
  RC_ASSERT(after.tiles().size() == 1 || after.tiles().size() == polygon.partner.size() - 2);
}

RC_GTEST_PROP(DomainFormatProperty, ChangedByteIsAnErrorOrAnotherSurface, (std::uint8_t byte)) {
  std::string text = test::domain_text(octagon());
  text[*rc::gen::inRange<std::size_t>(0, text.size())] = static_cast<char>(byte);
  try {
    RC_ASSERT(read_domain(text, "test").genus() == 2U);
  } catch (const ExchangeError& error) {
    RC_ASSERT(std::string(error.what()).find('\n') == std::string::npos);
  }
}

}  // namespace
}  // namespace epsnet::domain_format_test
