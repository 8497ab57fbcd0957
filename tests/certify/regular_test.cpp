#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <map>

#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/lifted_triangle.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"

/// Regular 4g-gons, above all the net of one vertex, the tile's centre: around a corner of the tile its 4g lifts are
/// the corners of a regular polygon, the dual one, so every triangulation of that is Delaunay and all its diagonals are
/// ties.
namespace epsnet::certify::regular_test {
namespace {

/// The distance of the corners from the centre, which is also the circumradius of all triangles below.
double circumradius(std::uint32_t genus) { return std::acosh(std::pow(std::tan(M_PI / 4 / genus), -2)); }

std::string decimal(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10f", x);
  return text;
}

/// The dual polygon cut into triangles that all have its corner 0. Corner j is the centre of copy j of the tile; copy j
/// + 1 is the one behind the side `crossed[j]` of copy j, which leaves the common corner. So the copies are clockwise.
class Fan {
 public:
  explicit Fan(std::uint32_t genus) : sides_(4 * genus) {
    document_.surface.regular_genus = genus;
    document_.epsilon = decimal(circumradius(genus) + 1e-9);
    document_.charts = {{0, {0, 0}}};
    document_.vertices = {{0, 0, 0}};
    const SurfaceSides sides(document_.surface);
    partner_ = sides.partner;
    std::uint32_t side = 0;
    for (std::uint32_t j = 0; j < sides_; ++j, side = sides.next_around(side)) crossed_.push_back(side);
    EXPECT_EQ(side, 0U);
    for (std::uint32_t k = 1; k + 1 < sides_; ++k) {
      document_.triangles.push_back({{0, 0, 0}, {}, {label(k + 1), label(k)}});
      const std::uint32_t first = 3 * (k - 1);
      darts_[{0, k + 1}] = first;
      darts_[{k + 1, k}] = first + 1;
      darts_[{k, 0}] = first + 2;
    }
    for (const auto& [ends, dart] : darts_) document_.triangles[dart / 3].opposite[dart % 3] = opposite(ends);
  }

  NetDocument document() && { return std::move(document_); }

 private:
  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  /// From copy j's coordinates to those of copy 0: back over the sides crossed, or on around the corner if that is
  /// shorter.
  std::uint32_t label(std::uint32_t j) {
    NetDocument::Label label{0, 0, {}};
    if (2 * j <= sides_) {
      for (std::uint32_t i = j; i > 0; --i) label.word.push_back(partner_[crossed_[i - 1]]);
    } else {
      label.word.assign(crossed_.begin() + j, crossed_.end());
    }
    const auto found = std::find(document_.labels.begin(), document_.labels.end(), label);
    if (found != document_.labels.end()) return static_cast<std::uint32_t>(found - document_.labels.begin()) + 1;
    document_.labels.push_back(label);
    return static_cast<std::uint32_t>(document_.labels.size());
  }

  /// A diagonal has its two triangles in the fan. The edge from copy j + 1 to copy j crosses one side, `crossed[j]` of
  /// copy j; on the surface it is the edge that crosses its partner, in the other direction.
  std::uint32_t opposite(Ends ends) const {
    const auto twin = darts_.find({ends.second, ends.first});
    if (twin != darts_.end()) return twin->second;
    const auto other = std::find(crossed_.begin(), crossed_.end(), partner_[crossed_[ends.second]]);
    const auto j = static_cast<std::uint32_t>(other - crossed_.begin());
    return darts_.at({(j + 1) % sides_, j});
  }

  std::uint32_t sides_;
  std::vector<std::uint32_t> partner_;
  std::vector<std::uint32_t> crossed_;
  std::map<Ends, std::uint32_t> darts_;
  NetDocument document_;
};

NetDocument fan(std::uint32_t genus) { return Fan(genus).document(); }

std::string outcome(const NetDocument& document) {
  const Certificate certificate = check(document, {.threads = 1});
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

TEST(Regular, SurfaceIsOneByTheorem) {
  for (const std::uint32_t genus : {2U, 3U, 1000U}) {
    SurfaceDocument surface;
    surface.regular_genus = genus;
    const SurfaceOutcome outcome = check_surface(surface);
    EXPECT_EQ(outcome.report.verdict, Verdict::verified);
    EXPECT_EQ(outcome.genus, genus);
    EXPECT_NE(outcome.report.text.find("regular " + std::to_string(4 * genus) + "-gon"), std::string::npos);
    const auto disk = inscribed_disk(surface, 0, 64);
    ASSERT_TRUE(disk.has_value());
    const double apothem = std::acosh(1 / std::tan(M_PI / 4 / genus));
    EXPECT_NEAR(outer_interval(disk->sinh_radius).lower, std::sinh(apothem), 1e-9 * std::sinh(apothem));
  }
}

TEST(Regular, AllCornersAreOneCycle) {
  for (std::uint32_t genus = 2; genus <= 100; ++genus) {
    SurfaceDocument surface;
    surface.regular_genus = genus;
    const SurfaceSides sides(surface);
    std::uint32_t corners = 0;
    std::uint32_t side = 0;
    do {
      side = sides.next_around(side);
      ++corners;
    } while (side != 0);
    EXPECT_EQ(corners, 4 * genus);
  }
}

TEST(Regular, CentresAreVerifiedAndAllDiagonalsAreTies) {
  for (std::uint32_t genus = 2; genus <= 20; ++genus) {
    SCOPED_TRACE(genus);
    const NetDocument document = fan(genus);
    ASSERT_EQ(document.triangles.size(), 4 * genus - 2);
    const Certificate certificate = check(document);
    EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.rule << ": " << certificate.message;
    EXPECT_EQ(certificate.counts.genus, genus);
    EXPECT_EQ(certificate.counts.tiles, 1U);
    EXPECT_EQ(certificate.counts.exact_ties, 4 * genus - 3);
    ASSERT_EQ(certificate.ties.size(), 4 * genus - 3);
    for (std::uint32_t k = 0; k < certificate.ties.size(); ++k) EXPECT_EQ(certificate.ties[k], 3 * k);
    ASSERT_TRUE(certificate.enclosures.has_value());
    EXPECT_NEAR(certificate.enclosures->largest_circumradius.upper, circumradius(genus), 1e-6);
    ASSERT_TRUE(certificate.enclosures->shortest_loop.has_value());
    // The sides of the dual polygon are twice the apothem long.
    EXPECT_NEAR(certificate.enclosures->shortest_loop->lower, 2 * std::acosh(1 / std::tan(M_PI / 4 / genus)), 1e-6);
    EXPECT_EQ(certificate.enclosures->shortest_edge, std::nullopt);
  }
}

TEST(Regular, GenusTwoIsTheBolzaSurface) {
  // Its shortest closed geodesics have the length 2 arcosh(1 + √2), and the loops that cross one side are such.
  const Certificate certificate = check(fan(2));
  ASSERT_TRUE(certificate.enclosures && certificate.enclosures->shortest_loop);
  const double systole = 2 * std::acosh(1 + std::sqrt(2.0));
  EXPECT_NEAR(certificate.enclosures->shortest_loop->lower, systole, 1e-14);
  EXPECT_NEAR(certificate.enclosures->shortest_loop->upper, systole, 1e-14);
  EXPECT_NE(certificate.rules[0].text.find("the Bolza surface"), std::string::npos);
}

TEST(Regular, EpsilonBelowTheCircumradiusIsRefuted) {
  for (const std::uint32_t genus : {2U, 3U, 8U, 20U}) {
    NetDocument document = fan(genus);
    document.epsilon = decimal(circumradius(genus) - 1e-9);
    EXPECT_EQ(outcome(document), "REFUTED: covering");
  }
}

TEST(Regular, TiesDoNotDependOnCharts) {
  // The same net in a chart with another centre c: the vertex has the coordinate −c there, and no polynomial is as
  // simple as before.
  for (const std::uint32_t genus : {2U, 3U, 6U}) {
    for (const auto& [x, y] : {std::pair{0.25, 0.0}, std::pair{-0.375, 0.4375}, std::pair{0.1, 0.7}}) {
      NetDocument document = fan(genus);
      document.charts[0].centre = {mpq_class(x), mpq_class(y)};
      document.vertices[0] = {-x, -y, 0};
      const Certificate certificate = check(document);
      EXPECT_EQ(certificate.verdict, Verdict::verified) << certificate.rule << ": " << certificate.message;
      EXPECT_EQ(certificate.counts.exact_ties, 4 * genus - 3);
    }
  }
}

TEST(Regular, VertexMovedALittleIsRefuted) {
  for (const std::uint32_t genus : {2U, 5U}) {
    for (const auto& [x, y] :
         {std::pair{1e-9, 0.0}, std::pair{0.0, 1e-9}, std::pair{-1e-9, 1e-9}, std::pair{5e-324, 0.0}}) {
      NetDocument document = fan(genus);
      document.vertices[0] = {x, y, 0};
      const Certificate certificate = check(document);
      EXPECT_EQ(certificate.verdict, Verdict::refuted);
      EXPECT_EQ(certificate.rule, "delaunay") << x << ' ' << y;
    }
  }
}

TEST(Regular, EveryLabelReplacedIsRefuted) {
  const NetDocument good = fan(2);
  for (std::size_t corner = 0; corner < 2 * good.triangles.size(); ++corner) {
    for (std::uint32_t wrong = 0; wrong <= good.labels.size(); ++wrong) {
      NetDocument document = good;
      std::uint32_t& number = document.triangles[corner / 2].label[corner % 2];
      if (number == wrong) continue;
      number = wrong;
      EXPECT_EQ(outcome(document), "REFUTED: gluing") << corner << ' ' << wrong;
    }
  }
}

TEST(Regular, EveryLetterReplacedIsRefuted) {
  const NetDocument good = fan(3);
  for (std::size_t l = 0; l < good.labels.size(); ++l) {
    for (std::size_t i = 0; i < good.labels[l].word.size(); ++i) {
      NetDocument document = good;
      std::uint32_t& letter = document.labels[l].word[i];
      letter = (letter + 1) % 12;
      EXPECT_EQ(outcome(document), "REFUTED: gluing");
    }
  }
}

TEST(Regular, EveryPairOfOppositesSwappedIsRefuted) {
  const NetDocument good = fan(2);
  const auto darts = static_cast<std::uint32_t>(3 * good.triangles.size());
  const auto of = [](NetDocument& document, std::uint32_t dart) -> std::uint32_t& {
    return document.triangles[dart / 3].opposite[dart % 3];
  };
  for (std::uint32_t a = 0; a < darts; ++a) {
    for (std::uint32_t b = 0; b < darts; ++b) {
      NetDocument document = good;
      const std::uint32_t other_a = of(document, a);
      const std::uint32_t other_b = of(document, b);
      if (a >= other_a || b >= other_b || a == b) continue;
      // a and b exchange partners: still an involution.
      of(document, a) = other_b;
      of(document, other_b) = a;
      of(document, b) = other_a;
      of(document, other_a) = b;
      const std::string found = outcome(document);
      EXPECT_TRUE(found == "REFUTED: map" || found == "REFUTED: gluing") << found << ' ' << a << ' ' << b;
      of(document, other_a) = a;
      EXPECT_EQ(outcome(document), "REFUTED: map");
    }
  }
}

TEST(Regular, ReversedFanIsRefuted) {
  NetDocument document = fan(4);
  for (NetDocument::Triangle& t : document.triangles) {
    std::swap(t.label[0], t.label[1]);
    std::swap(t.opposite[0], t.opposite[2]);
    for (std::uint32_t& dart : t.opposite) dart = dart / 3 * 3 + (2 - dart % 3);
  }
  EXPECT_EQ(outcome(document), "REFUTED: orientation");
}

TEST(Regular, ThreePointsOnALineAreFoundExactly) {
  // Labels are the translation of side 0 and its square, so three lifts of the centre are on its axis, in every chart;
  // the least step off the axis is seen.
  for (const std::uint32_t genus : {2U, 3U, 20U}) {
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, std::pair{0.3125, -0.5}}) {
      NetDocument document = fan(genus);
      document.charts[0].centre = {mpq_class(x), mpq_class(y)};
      document.vertices = {{-x, -y, 0}, {-x, std::nextafter(-y, 1.0), 0}};
      document.labels = {{0, 0, {0}}, {0, 0, {0, 0}}};
      const RegularTile tile{4 * genus, 4 * genus};
      LabelParts parts{RegularCrossings(tile, SurfaceSides(document.surface).partner),
                       {translation_to(exact_point(x, y))}};
      const LabelEvaluator evaluator(document, parts);
      document.triangles[0].label = {1, 2};
      EXPECT_EQ(exact_orientation(document, evaluator, 0), 0);
      // The axis runs from right to left: corners 0 and 2 are on it, corner 1 is above it, then below.
      document.triangles[0].vertex = {0, 1, 0};
      EXPECT_EQ(exact_orientation(document, evaluator, 0), 1);
      document.vertices[1].y = std::nextafter(-y, -1.0);
      EXPECT_EQ(exact_orientation(document, evaluator, 0), -1);
    }
  }
}

NetDocument file(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/" + name);
}

TEST(Regular, TiesOfSymmetricVerticesAreFound) {
  // z and iz are exact in binary64: squares around the centre and around the corner of the tile.
  EXPECT_EQ(check(file("verified/regular-2-4-rotated-vertices.json")).counts.exact_ties, 2U);
  EXPECT_EQ(check(file("verified/regular-2-10-vertices.json")).counts.exact_ties, 4U);
  // With the mirror images: two octagons and four trapezoids.
  EXPECT_EQ(check(file("refuted/packing-regular-8-symmetric-vertices.json")).counts.exact_ties, 14U);
}

TEST(Regular, NearTiesOfSymmetricVerticesAreDecidedEitherWay) {
  // A vertex of the two squares moved by one unit in the last place: each diagonal is right or wrong, and if it is
  // right for one direction it is wrong for the opposite one.
  std::size_t verified = 0;
  std::size_t refuted = 0;
  for (std::size_t v = 0; v < 4; ++v) {
    for (const double direction : {-1.0, 1.0}) {
      NetDocument document = file("verified/regular-2-4-rotated-vertices.json");
      document.vertices[v].x = std::nextafter(document.vertices[v].x, direction);
      const Certificate certificate = check(document);
      EXPECT_EQ(certificate.counts.exact_ties, 0U);
      verified += certificate.verdict == Verdict::verified;
      refuted += certificate.verdict == Verdict::refuted && certificate.rule == "delaunay";
    }
  }
  EXPECT_EQ(verified + refuted, 8U);
  EXPECT_GE(refuted, 4U);
}

TEST(Regular, WrongGenusIsRefuted) {
  NetDocument document = fan(3);
  document.surface.regular_genus = 4;
  EXPECT_EQ(outcome(document), "REFUTED: map");
}

TEST(Regular, DocumentsThatAreNoneAreMalformed) {
  NetDocument document = fan(2);
  document.surface.gluing = {{0, 0, 0, 4}};
  EXPECT_EQ(outcome(document), "MALFORMED: structure");
  document = fan(2);
  document.surface.tiles = {{{0, 0}, {mpq_class(1, 2), 0}, {0, mpq_class(1, 2)}}};
  EXPECT_EQ(outcome(document), "MALFORMED: structure");
  for (const std::uint32_t genus : {1U, 1001U, 0xffffffffU}) {
    document = fan(2);
    document.surface.regular_genus = genus;
    EXPECT_EQ(outcome(document), "MALFORMED: structure");
  }
  document = fan(2);
  document.surface.about.assign((std::size_t{1} << 20) + 1, ' ');
  EXPECT_EQ(outcome(document), "MALFORMED: structure");
  document.surface.about.pop_back();
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Regular, ThreadsDoNotMatter) {
  const NetDocument document = fan(7);
  const Certificate single = check(document, {.threads = 1});
  const Certificate several = check(document, {.threads = 5});
  EXPECT_EQ(single.verdict, several.verdict);
  EXPECT_EQ(single.counts.exact_ties, several.counts.exact_ties);
  for (std::size_t i = 0; i < single.rules.size(); ++i) EXPECT_EQ(single.rules[i].text, several.rules[i].text);
}

}  // namespace
}  // namespace epsnet::certify::regular_test
