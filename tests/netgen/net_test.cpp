#include <algorithm>
#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "netgen/exchange/exchange.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/refine.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"
#include "tests/support/scale.h"
#include "tests/support/triangulations.h"

namespace epsnet::net_test {
namespace {

using certify::Verdict;
using test::any_index;
using test::any_share;

const NetOptions kOneThread{.check = {.threads = 1}};

std::string text_of(const certify::NetDocument& net) {
  std::ostringstream out;
  certify::write_file(net, out);
  return out.str();
}

std::int32_t any_seed() { return any_index<std::int32_t>(100'000); }

/// Between `least` and `most`, logarithmically uniform, with few digits.
std::string any_epsilon(double least, double most) {
  std::ostringstream text;
  text.precision(4);
  text << least * std::pow(most / least, any_share());
  return text.str();
}

/// The length of the shortest closed curve that crosses at most four sides: the systole or a little more.
double short_curve(const Surface& surface) {
  std::vector<Isometry<double>> generators;
  for (const SideId s : surface.side_ids()) {
    generators.push_back(normalized(convert<double>(surface.crossing(s))));
  }
  double least = HUGE_VAL;
  std::vector<Isometry<double>> words{{}};
  for (int length = 1; length <= 4; ++length) {
    std::vector<Isometry<double>> longer;
    for (const Isometry<double>& word : words) {
      for (const Isometry<double>& g : generators) {
        longer.push_back(g * word);
        const double half_trace = std::abs(longer.back().a.x);  // cosh of half the translation length
        if (half_trace > 1 + 1e-9) {
          least = std::min(least, 2 * std::acosh(half_trace));
        }
      }
    }
    words = std::move(longer);
  }
  return least;
}

void expect_verified(const Surface& surface, const std::string& epsilon, const Variant& variant = {}) {
  try {
    const VariantNet net = compute_variant(surface, Length(epsilon), variant);
    const certify::Certificate certificate = certify::check(net.document);
    EXPECT_EQ(certificate.verdict, Verdict::verified);
    EXPECT_EQ(certificate.counts.genus, surface.genus());
    const double lower = (surface.genus() - 1) / std::pow(std::sinh(std::stod(epsilon) / 2), 2);
    EXPECT_GE(static_cast<double>(net.document.vertices.size()), lower) << "Theorem III.2";
  } catch (const NetError& error) {
    ADD_FAILURE() << "epsilon " << epsilon << ": " << error.what();
  }
}

TEST(Net, OfAnEpsilonBeyondTheDiameterIsOneVertex) {
  for (const std::int32_t seed : {1, 123, 321}) {
    for (const char* epsilon : {"8", "20", "300"}) {
      const CertifiedNet net = certified_net(random_octagon(seed), Length(epsilon));
      EXPECT_EQ(net.document.vertices.size(), 1U);
      EXPECT_EQ(net.document.triangles.size(), 6U);
      EXPECT_EQ(net.statistics.insertions, 0U);
      EXPECT_EQ(net.certificate.verdict, Verdict::verified);
    }
  }
}

TEST(Net, DoubleEpsilonIsItsShortestDecimal) {
  const CertifiedNet net = certified_net(random_octagon(123), 0.5);
  EXPECT_EQ(net.document.epsilon, "0.5");
  EXPECT_EQ(text_of(net.document), text_of(certified_net(random_octagon(123), Length("0.5")).document));
}

TEST(Net, UncertifiedIsTheSameNet) {
  const Surface surface = random_octagon(5);
  const UncertifiedNet net = compute_net(surface, Length("0.4"));
  EXPECT_EQ(text_of(net.document), text_of(certified_net(surface, Length("0.4")).document));
}

TEST(Net, FileReadsBackTheSame) {
  const CertifiedNet net = certified_net(random_octagon(7), 0.3);
  EXPECT_EQ(certify::parse_file<certify::NetDocument>(text_of(net.document), "net"), net.document);
}

TEST(Variant, HasTheNamesOfTheThesis) {
  EXPECT_EQ(name_in(kInsertionNames, Insertion::flips), "flips");
  EXPECT_EQ(name_in(kWalkNames, Walk::straight), "straight");
  // The letters of the thesis' Table IV.2.
  EXPECT_EQ(name_in(kTriangleListNames, TriangleList::all_back), "A");
  EXPECT_EQ(name_in(kTriangleListNames, TriangleList::all_front), "B");
  EXPECT_EQ(name_in(kTriangleListNames, TriangleList::large_back), "C");
  EXPECT_EQ(name_in(kTriangleListNames, TriangleList::largest_first), "D");
}

TEST(Net, StatisticsAreConsistent) {
  const Surface surface = random_octagon(9);
  const VariantNet by_flips =
      compute_variant(surface, Length("0.2"), {.insertion = Insertion::flips, .walk = Walk::visibility});
  const RefinementStatistics& flips = by_flips.statistics;
  EXPECT_EQ(flips.located, flips.insertions);
  EXPECT_LE(flips.located_at_start, flips.located);
  EXPECT_GE(flips.walk_steps, flips.located - flips.located_at_start);
  EXPECT_LE(flips.longest_walk, flips.walk_steps);
  EXPECT_GE((flips.located - flips.located_at_start) * flips.longest_walk, flips.walk_steps);
  EXPECT_EQ(flips.charts, by_flips.document.charts.size());
  const VariantNet cavity = compute_variant(surface, Length("0.2"), {});
  EXPECT_EQ(cavity.statistics.insertions + 1, cavity.document.vertices.size());
  EXPECT_EQ(cavity.statistics.located, 0U);
  EXPECT_EQ(cavity.statistics.charts, cavity.document.charts.size());
  EXPECT_EQ(cavity.statistics.labels, cavity.document.labels.size());
  EXPECT_LT(cavity.statistics.multiprecision, cavity.statistics.insertions) << "binary64 decides nearly all predicates";
}

TEST(Net, ProgressGrows) {
  std::vector<double> shares;
  std::vector<std::uint64_t> vertices;
  const NetOptions options{.progress = [&](std::string_view what, double share) {
    std::uint64_t n = 0;
    ASSERT_EQ(std::sscanf(std::string(what).c_str(), "net: %" SCNu64 " vertices", &n), 1) << what;
    vertices.push_back(n);
    shares.push_back(share);
  }};
  (void)compute_net(random_octagon(3), Length("0.012"), options);
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::is_sorted(vertices.begin(), vertices.end()));
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.front(), 0);
  EXPECT_LE(shares.back(), 1);
}

TEST(Net, EpsilonsThatNeedTooMuchMemoryAreRefused) {
  const Surface surface = random_octagon(1);
  for (const char* epsilon : {"1e-6", "1e-100", "1e-9999"}) {
    EXPECT_THROW((void)compute_net(surface, Length(epsilon)), NetError) << epsilon;
  }
}

TEST(Net, StartingVerticesThatAreTooCloseAreRemoved) {
  // A second vertex of the surface, in the middle of side 0.
  const test::PairedPolygon polygon =
      test::with_vertex_on_side(test::paired_polygon(random_octagon(123)), 0, Rational(1, 2));
  const Surface surface = read_domain(test::domain_text(polygon), "two vertices");
  ASSERT_EQ(surface.vertex_class_count(), 2U);
  expect_verified(surface, "6");
  expect_verified(surface, "0.5");
  expect_verified(surface, "0.1");
}

TEST(Net, BasePointIsTheStart) {
  const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::ring(3), 1));
  Complex<Rational> base;  // Inside of this tile, if not of every one.
  for (const Complex<Rational>& z : surface.tiles()[3]) {
    base = base + Rational(1, 7) * z;
  }
  const NetOptions options{.base = BasePoint{TileId(3), base}};
  const CertifiedNet far = certified_net(surface, Length("9"), options);
  EXPECT_EQ(far.document.vertices.size(), 1U);
  EXPECT_EQ(far.statistics.removed, surface.vertex_class_count());
  for (const certify::NetDocument& net : {far.document, certified_net(surface, Length("0.5"), options).document}) {
    // Vertex 0 is the base point itself.
    const certify::NetDocument::Vertex& vertex = net.vertices[0];
    EXPECT_EQ(vertex.x, 0);
    EXPECT_EQ(vertex.y, 0);
    EXPECT_EQ(net.charts[vertex.chart].tile, 3U);
    EXPECT_EQ(net.charts[vertex.chart].centre.x, mpq_class(base.x.backend().data()));
    EXPECT_EQ(net.charts[vertex.chart].centre.y, mpq_class(base.y.backend().data()));
  }
  EXPECT_THROW((void)compute_net(surface, Length("1"), {.base = BasePoint{TileId(0), {1, 0}}}), SurfaceError);
}

TEST(Net, RegularSurfacesAreVerified) {
  for (const std::uint32_t genus : {2u, 3u, 4u, 7u}) {
    const Surface surface = Surface::regular(genus);
    const CertifiedNet centre = certified_net(surface, Length("20"));
    EXPECT_EQ(centre.document.vertices.size(), 1U);
    EXPECT_EQ(centre.certificate.counts.exact_ties, 4 * genus - 3) << "all diagonals of the dual polygon";
    for (const char* epsilon : {"1.5", "0.5", "0.2"}) {
      expect_verified(surface, epsilon);
      expect_verified(surface, epsilon, {.insertion = Insertion::flips});
    }
  }
}

TEST(Net, ARegularSurfaceOfGenusTwentyIsVerified) { expect_verified(Surface::regular(20), "0.5"); }

TEST(Net, ShortCuffsAreVerified) {
  for (const char* graph : {"0-0 0-1 1-1", "0-1 0-1 0-1"}) {
    for (const int digits : {2, 4, 8, 12}) {
      // One short cuff, separating in the first graph; then two and three.
      FenchelNielsen coordinates = random_coordinates(PantsGraph::parse(graph), 3);
      for (const std::size_t edge : {1u, 0u, 2u}) {
        coordinates.lengths[edge] = Rational(1, pow(boost::multiprecision::mpz_int(10), static_cast<unsigned>(digits)));
        coordinates.twists[edge] = 0;
        SCOPED_TRACE(graph + std::string(" 1e-") + std::to_string(digits));
        expect_verified(fenchel_nielsen_surface(coordinates), "0.5");
      }
    }
  }
}

TEST(Net, TheShortestCuffIsVerified) {
  for (const char* graph : {"0-0 0-1 1-1", "0-1 0-1 0-1"}) {
    FenchelNielsen coordinates = random_coordinates(PantsGraph::parse(graph), 3);
    coordinates.lengths[1] = Rational(1, pow(boost::multiprecision::mpz_int(10), 25));
    expect_verified(fenchel_nielsen_surface(coordinates), "0.5");
  }
}

TEST(Net, LongCuffsWithManyTurnsAreVerified) {
  FenchelNielsen coordinates = random_coordinates(PantsGraph::random(3, 2), 2);
  for (std::size_t edge = 0; edge < coordinates.lengths.size(); ++edge) {
    coordinates.lengths[edge] = 30;
    coordinates.twists[edge] = 1200 + Rational(static_cast<int>(edge), 3);
    expect_verified(fenchel_nielsen_surface(coordinates), "0.5");
    expect_verified(fenchel_nielsen_surface(coordinates), "4");
  }
}

TEST(Net, EveryImportedTriangulationIsVerified) {
  for (const auto& path : test::data_files("triangulations")) {
    SCOPED_TRACE(path.filename().string());
    const Surface surface = test::imported(path);
    expect_verified(surface, "0.5");
    expect_verified(surface, "3");
  }
}

TEST(Net, EveryImportedPolygonIsVerified) {
  // The larger ones are in table_test.cpp.
  for (const auto& path : test::data_files("polygons")) {
    const Surface surface = test::imported(path);
    if (surface.genus() <= 10) {
      SCOPED_TRACE(path.filename().string());
      expect_verified(surface, "0.5");
    }
  }
}

constexpr std::array kLists{TriangleList::all_back, TriangleList::all_front, TriangleList::large_back,
                            TriangleList::largest_first};

TEST(Net, ThinSurfacesAreVerifiedByEveryList) {
  for (const char* name : {"g2-thin-1e-4", "g2-thinsep-1e-4", "g3-thin-1e-4"}) {
    const Surface surface = test::imported(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-" + name + ".txt");
    for (const TriangleList list : kLists) {
      for (const Insertion insertion : {Insertion::cavity, Insertion::flips}) {
        SCOPED_TRACE(name);
        expect_verified(surface, "0.2", {.insertion = insertion, .list = list});
      }
    }
  }
}

TEST(Net, ThinSurfacesAreVerifiedByEveryWay) {
  for (const char* name : {"g2-thin-1e-2", "g2-thin-1e-4", "g2-thin-1e-8", "g2-thinsep-1e-4", "g3-thin-1e-4"}) {
    const Surface surface = test::imported(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-" + name + ".txt");
    for (const char* epsilon : {"0.2", "1", "3"}) {
      for (const Insertion insertion : {Insertion::cavity, Insertion::flips}) {
        for (const Walk walk : {Walk::visibility, Walk::straight}) {
          SCOPED_TRACE(name);
          expect_verified(surface, epsilon, {.insertion = insertion, .walk = walk});
        }
      }
    }
  }
}

TEST(Net, FenchelNielsenGenusFiveReadFromATextIsVerified) {
  // Cross-ratios have many digits, so the tiles get coordinates other than those that they were made in.
  std::ostringstream text;
  write_triangulation(fenchel_nielsen_surface(random_coordinates(PantsGraph::random(5, 1), 1)), text);
  const Surface surface = import_surface(text.str(), "genus 5");
  ASSERT_EQ(surface.genus(), 5U);
  for (const char* epsilon : {"0.5", "0.25", "0.1"}) {
    expect_verified(surface, epsilon);
    expect_verified(surface, epsilon, {.insertion = Insertion::flips, .walk = Walk::straight});
  }
}

/// The mean over the octagons 1 to `octagons`.
struct Means {
  double vertices = 0;
  double flips_per_insertion = 0;
  double steps_of_walks = 0;  ///< Of those that do not end where they start.
  double share_at_start = 0;
};

Means means(int octagons, const char* epsilon, const Variant& variant = {}) {
  Means sum;
  for (std::int32_t seed = 1; seed <= octagons; ++seed) {
    const VariantNet net = compute_variant(random_octagon(seed), Length(epsilon), variant);
    const RefinementStatistics& s = net.statistics;
    sum.vertices += static_cast<double>(net.document.vertices.size());
    sum.flips_per_insertion += static_cast<double>(s.flips) / static_cast<double>(s.insertions);
    sum.steps_of_walks += static_cast<double>(s.walk_steps) / static_cast<double>(s.located - s.located_at_start);
    sum.share_at_start += static_cast<double>(s.located_at_start) / static_cast<double>(s.located);
  }
  return {sum.vertices / octagons, sum.flips_per_insertion / octagons, sum.steps_of_walks / octagons,
          sum.share_at_start / octagons};
}

TEST(SlowThesis, TableIV3MeanNumberOfVertices) {
  const auto expect_mean = [](const char* epsilon, double thesis, double tolerance) {
    const double mean = means(60, epsilon).vertices;
    std::cout << "epsilon " << epsilon << ": " << mean << " vertices, thesis " << thesis << '\n';
    EXPECT_NEAR(mean, thesis, tolerance * thesis) << "epsilon " << epsilon;
  };
  expect_mean("0.4", 54, 0.02);
  expect_mean("0.3", 96, 0.02);
  expect_mean("0.2", 216, 0.01);
  expect_mean("0.1", 865, 0.01);
  expect_mean("0.05", 3454, 0.01);
}

TEST(SlowThesis, TableIV3ByFlipsAsWell) {
  for (const Walk walk : {Walk::visibility, Walk::straight}) {
    EXPECT_NEAR(means(60, "0.2", {.insertion = Insertion::flips, .walk = walk}).vertices, 216, 0.01 * 216);
  }
}

TEST(SlowThesis, FiguresIV11AndIV12FlipsAndWalks) {
  const auto print = [](const char* what, const Means& m) {
    std::cout << what << ": " << m.flips_per_insertion << " flips per insertion, " << m.steps_of_walks
              << " steps of walks that leave the first triangle, " << m.share_at_start << " stay\n";
  };
  const Means at_half = means(60, "0.5", {.insertion = Insertion::flips});
  print("epsilon 0.5", at_half);
  EXPECT_NEAR(at_half.flips_per_insertion, 3.41, 0.341);
  const Means at_tenth = means(60, "0.1", {.insertion = Insertion::flips});
  print("epsilon 0.1", at_tenth);
  EXPECT_LT(at_tenth.flips_per_insertion, at_half.flips_per_insertion);
  EXPECT_NEAR(at_tenth.steps_of_walks, 1.028, 0.1);
  EXPECT_NEAR(at_tenth.share_at_start, 0.68, 0.068);
  const Means straight = means(60, "0.1", {.insertion = Insertion::flips, .walk = Walk::straight});
  print("epsilon 0.1, straight", straight);
  EXPECT_NEAR(straight.steps_of_walks, 1.026, 0.1);
}

/// Table IV.2: on 60 surfaces the thesis' variants differ in flips and in points.
TEST(SlowThesis, TheListOfTrianglesMatters) {
  const auto by_list = [](TriangleList list) {
    return means(60, "0.1", {.insertion = Insertion::flips, .list = list});
  };
  const Means a = by_list(TriangleList::all_back);
  const Means b = by_list(TriangleList::all_front);
  const Means c = by_list(TriangleList::large_back);
  const Means d = by_list(TriangleList::largest_first);
  EXPECT_NEAR(a.vertices, 865, 0.01 * 865);
  EXPECT_NEAR(c.vertices, a.vertices, 0.002 * a.vertices) << "small triangles on the list change next to nothing";
  EXPECT_GT(b.flips_per_insertion, 1.03 * a.flips_per_insertion);
  EXPECT_LT(b.share_at_start, 0.9 * a.share_at_start) << "the newest triangles are the least round ones";
  EXPECT_GT(d.share_at_start, 1.01 * a.share_at_start) << "the largest ones are rounder";
}

RC_GTEST_PROP(NetProperty, FenchelNielsenSurfacesAreVerified, ()) {
  const std::uint32_t genus = 2 + any_index(4u);
  const Surface surface = fenchel_nielsen_surface(test::any_coordinates(genus, 1e-10, 30));
  const std::string epsilon = any_epsilon(0.4, 5);
  const CertifiedNet net = certified_net(surface, Length(epsilon), kOneThread);
  RC_ASSERT(net.certificate.verdict == Verdict::verified);
  RC_ASSERT(net.certificate.counts.genus == genus);
}

RC_GTEST_PROP(NetProperty, IsVerifiedAndItsSizeLiesBetweenTheBounds, ()) {
  const Surface surface = random_octagon(any_seed());
  const std::string epsilon = any_epsilon(0.15, 5);
  const CertifiedNet net = certified_net(surface, Length(epsilon), kOneThread);
  RC_ASSERT(net.certificate.verdict == Verdict::verified);
  RC_ASSERT(net.certificate.rules.size() == 7U);
  const auto vertices = static_cast<double>(net.document.vertices.size());
  const double e = std::stod(epsilon);
  const double systole = short_curve(surface);
  RC_ASSERT(vertices >= 1 / std::pow(std::sinh(e / 2), 2));                             // Theorem III.2
  RC_ASSERT(vertices <= 16 / (e * e) + (e <= systole ? 0 : 16 / (systole * systole)));  // Theorem III.1
  // What the certificate encloses is what the net claims.
  RC_ASSERT(net.certificate.enclosures->largest_circumradius.lower <= e * (1 + 1e-15));
  if (const auto shortest = net.certificate.enclosures->shortest_edge) {
    RC_ASSERT(shortest->upper >= e * (1 - 1e-15));
  }
}

RC_GTEST_PROP(NetProperty, IsVerifiedWhateverTheWay, ()) {
  const Surface surface = random_octagon(any_seed());
  const std::string epsilon = any_epsilon(0.3, 3);
  for (const Insertion insertion : {Insertion::cavity, Insertion::flips}) {
    for (const Walk walk : {Walk::visibility, Walk::straight}) {
      for (const TriangleList list : kLists) {
        const Variant variant{.insertion = insertion, .walk = walk, .list = list};
        const VariantNet net = compute_variant(surface, Length(epsilon), variant, kOneThread);
        RC_ASSERT(certify::check(net.document, kOneThread.check).verdict == Verdict::verified);
      }
    }
  }
}

RC_GTEST_PROP(NetProperty, OfAMovedAndRelabelledPolygonIsVerified, ()) {
  test::PairedPolygon polygon = test::paired_polygon(random_octagon(any_seed()));
  polygon = test::rotated(polygon, any_index(8u));
  polygon.vertices = test::moved(*test::isometries(), polygon.vertices);
  const CertifiedNet net = certified_net(polygon.surface(), Length(any_epsilon(0.3, 2)), kOneThread);
  RC_ASSERT(net.certificate.verdict == Verdict::verified);
  RC_ASSERT(net.certificate.counts.genus == 2U);
}

RC_GTEST_PROP(NetProperty, OfTheSurfaceCutDifferentlyIsVerified, ()) {
  const test::PairedPolygon octagon = test::paired_polygon(random_octagon(any_seed()));
  const Surface surface = read_domain(test::domain_text(test::cut_and_pasted(octagon, any_index(8u))), "cut");
  const CertifiedNet net = certified_net(surface, Length(any_epsilon(0.4, 2)), kOneThread);
  RC_ASSERT(net.certificate.verdict == Verdict::verified);
}

RC_GTEST_PROP(NetProperty, IsTheSameBytesEveryTime, ()) {
  const std::int32_t seed = any_seed();
  const std::string epsilon = any_epsilon(0.3, 3);
  const CertifiedNet one = certified_net(random_octagon(seed), Length(epsilon), kOneThread);
  NetOptions many;
  many.check.threads = 2 + any_index(4u);
  const CertifiedNet other = certified_net(random_octagon(seed), Length(epsilon), many);
  RC_ASSERT(text_of(one.document) == text_of(other.document));
  for (std::size_t i = 0; i < one.certificate.rules.size(); ++i) {
    RC_ASSERT(one.certificate.rules[i].text == other.certificate.rules[i].text);
  }
}

}  // namespace
}  // namespace epsnet::net_test
