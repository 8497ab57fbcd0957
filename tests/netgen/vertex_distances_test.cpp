#include <algorithm>
#include <bit>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/net/numbering.h"
#include "kernel/plane.h"
#include "netgen/distances/distances.h"
#include "netgen/exchange/exchange.h"
#include "netgen/lifts/lifts.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/triangulations.h"

namespace epsnet::vertex_distances_test {
namespace {

using certify::Interval;
using certify::NetDocument;
using testing::HasSubstr;

std::vector<std::uint32_t> all_vertices(const NetDocument& net) {
  std::vector<std::uint32_t> result(net.vertices.size());
  std::iota(result.begin(), result.end(), 0U);
  return result;
}

NetDocument octagon_net() { return compute_net(random_octagon(123), Length("0.5")).document; }

/// Genus 2, a cuff of the length given between two tori, ε = 0.34.
NetDocument thin_pseudo_net(const Rational& cuff) {
  const FenchelNielsen coordinates{
      PantsGraph::parse("0-0 0-1 1-1"), {1, cuff, 2}, {Rational(1, 10), cuff / 3, Rational(1, 2)}};
  return compute_net(fenchel_nielsen_surface(coordinates), Length("0.34"), {.pseudo = true}).document;
}

/// Ordinary ones, a pseudo net, and one of a regular surface, where distances have exact ties.
const std::vector<NetDocument>& nets() {
  static const std::vector<NetDocument> result{octagon_net(), thin_pseudo_net(Rational(1, 100'000'000)),
                                               compute_net(Surface::regular(2), Length("0.6")).document,
                                               compute_net(test::tiled_gallery()[10].surface, Length("1.5")).document};
  return result;
}

TEST(VertexDistances, ContainWhatDistanceProves) {
  for (const test::NamedSurface& named : test::tiled_gallery()) {
    const NetDocument net = compute_net(named.surface, Length("0.9")).document;
    const auto last = static_cast<std::uint32_t>(net.vertices.size() - 1);
    const DistanceTable table = vertex_distances(net, {0, last / 2}, {last, last / 3});
    for (std::size_t row = 0; row < 2; ++row) {
      for (std::size_t column = 0; column < 2; ++column) {
        const BasePoint p = point_of_vertex(named.surface, net, table.from[row]);
        const BasePoint q = point_of_vertex(named.surface, net, table.to[column]);
        Interval proved{};
        try {
          proved = unproved::distance(named.surface, p, q).distance;
        } catch (const SurfaceError&) {
          continue;  // Both are on the boundary of their tiles.
        }
        const Interval& x = table.enclosure(row, column);
        EXPECT_LE(x.lower, proved.upper) << named.name;
        EXPECT_GE(x.upper, proved.lower) << named.name;
        EXPECT_LT(x.upper - x.lower, 1e-12) << named.name;
      }
    }
  }
}

TEST(VertexDistances, AreSymmetricAndSatisfyTheTriangleInequality) {
  for (const NetDocument& net : nets()) {
    const DistanceTable table = distances_from(net, all_vertices(net));
    const std::size_t n = net.vertices.size();
    ASSERT_EQ(table.enclosures.size(), n * n);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(table.enclosure(i, i), (Interval{0, 0}));
      for (std::size_t k = 0; k < n; ++k) {
        const Interval& x = table.enclosure(i, k);
        const Interval& y = table.enclosure(k, i);
        EXPECT_TRUE(x.lower <= y.upper && y.lower <= x.upper) << i << ' ' << k;
        EXPECT_LE(x.upper - x.lower, 2 * table.error());
        for (std::size_t between = 0; between < n; ++between) {
          EXPECT_LE(x.lower, table.enclosure(i, between).upper + table.enclosure(between, k).upper);
        }
      }
    }
    EXPECT_LT(table.error(), 1e-12);
  }
}

/// No distance changes by more than the length of an edge along it; and no edge is shorter than the distance of its
/// ends.
TEST(VertexDistances, AreLipschitzAlongEdges) {
  for (const NetDocument& net : nets()) {
    const NetGeometry geometry(net);
    const DistanceTable table = distances_from(net, all_vertices(net));
    for (std::uint32_t d = 0; d < 3 * net.triangles.size(); ++d) {
      const auto corner = [&](std::uint32_t dart) {
        const NetDocument::Vertex& v = net.vertices[certify::start(net, dart)];
        return geometry.label(certify::corner_label(net, dart)).precise({Mp256(v.x), Mp256(v.y)});
      };
      const auto length = static_cast<double>(distance(corner(d), corner(certify::next_dart(d))));
      const std::uint32_t u = certify::start(net, d);
      const std::uint32_t v = certify::start(net, certify::next_dart(d));
      EXPECT_LE(table.enclosure(u, v).lower, length + 1e-9);
      for (std::size_t p = 0; p < net.vertices.size(); ++p) {
        EXPECT_LE(std::abs(table.distance(p, u) - table.distance(p, v)), length + 1e-9);
      }
    }
  }
}

/// The nearest other vertex is a neighbour in the Delaunay triangulation (docs/proof.md, Lemma 6).
TEST(VertexDistances, TheLeastIsTheShortestEdge) {
  const CertifiedNet result = certified_net(random_octagon(1), Length("0.4"));
  const DistanceTable table = distances_from(result.document, all_vertices(result.document));
  double least = 100;
  for (std::size_t i = 0; i < result.document.vertices.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) least = std::min(least, table.distance(i, k));
  }
  EXPECT_NEAR(least, result.certificate.enclosures->shortest_edge->lower, table.error());
}

/// By brute force: over the images of a point under all words of at most six crossings.
TEST(VertexDistances, AreTheLeastThatWordsGive) {
  const Surface surface = random_octagon(123);
  const NetDocument net = compute_net(surface, Length("0.8")).document;
  std::vector<Isometry<double>> elements{Isometry<double>{}};
  std::set<std::pair<long, long>> seen;
  for (std::size_t done = 0, level = 0; level < 6; ++level) {
    for (const std::size_t end = elements.size(); done < end; ++done) {
      for (const SideId s : surface.side_ids()) {
        const auto crossing = convert<double>(surface.crossing_as<Mp256>(s));
        const Isometry<double> element = normalized(crossing * elements[done]);
        const Complex<double> place = element({0.01, 0.02});
        if (seen.emplace(std::lround(place.x * 1e9), std::lround(place.y * 1e9)).second) elements.push_back(element);
      }
    }
  }
  std::vector<Complex<double>> points;
  for (std::uint32_t v = 0; v < net.vertices.size(); ++v) {
    points.push_back(convert<double>(point_of_vertex(surface, net, v).z));
  }
  const DistanceTable table = distances_from(net, all_vertices(net));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      double least = 100;
      for (const Isometry<double>& element : elements) {
        least = std::min(least, sinh2_half_distance(element(points[i]), points[k]));
      }
      EXPECT_NEAR(table.distance(i, k), 2 * std::asinh(std::sqrt(least)), 1e-9) << i << ' ' << k;
    }
  }
}

/// The same triangulation with its triangles as tiles, every vertex in a chart of its own.
TEST(VertexDistances, DoNotDependOnTheTiles) {
  const NetDocument net = octagon_net();
  std::ostringstream text;
  write_triangulation(net, text);
  const NetDocument other = net_of_tiles(import_surface(text.str(), "net"), Length("0.5"));
  ASSERT_EQ(other.vertices.size(), net.vertices.size());
  const auto sorted = [](const NetDocument& document) {
    const DistanceTable table = distances_from(document, all_vertices(document));
    std::vector<double> distances;
    for (std::size_t i = 0; i < table.enclosures.size(); ++i) {
      distances.push_back(table.distance(i / table.to.size(), i % table.to.size()));
    }
    std::sort(distances.begin(), distances.end());
    return distances;
  };
  const std::vector<double> here = sorted(net);
  const std::vector<double> there = sorted(other);
  for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], there[i], 1e-12);
}

TEST(VertexDistances, AreTheSameForAnyNumberOfThreads) {
  for (const NetDocument& net : nets()) {
    const DistanceTable one = distances_from(net, all_vertices(net), {.threads = 1});
    const DistanceTable five = distances_from(net, all_vertices(net), {.threads = 5});
    EXPECT_EQ(one.enclosures, five.enclosures);
  }
}

/// All vertices are in the ε-thick part, so the cuff, of length l, is at least d from them: sinh(ε/2) = sinh(l/2) cosh
/// d. Paths across it that wind differently differ in length by less than binary64 can tell.
TEST(VertexDistances, AcrossAVeryShortCuffAreAtLeastTwiceTheWidthOfItsThinPart) {
  const NetDocument net = thin_pseudo_net(Rational(1, 1'000'000'000'000'000'000) / 10);
  const DistanceTable table = distances_from(net, {0}, {.threads = 1});
  double greatest = 0;
  for (std::size_t v = 0; v < net.vertices.size(); ++v) greatest = std::max(greatest, table.distance(0, v));
  EXPECT_GE(greatest, 2 * std::acosh(std::sinh(0.17) / std::sinh(0.5e-19)));
  EXPECT_LT(table.error(), 1e-12);
}

TEST(VertexDistances, ErrorsSayWhatIsWrong) {
  const NetDocument net = octagon_net();
  const auto complaint = [](const NetDocument& document, std::uint32_t v) -> std::string {
    try {
      (void)distances_from(document, {v});
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const auto count = static_cast<std::uint32_t>(net.vertices.size());
  EXPECT_THAT(complaint(net, count), HasSubstr("vertex " + std::to_string(count) + " does not exist, the net has"));
  NetDocument broken = net;
  std::swap(broken.triangles[0].opposite[0], broken.triangles[0].opposite[1]);
  EXPECT_THAT(complaint(broken, 0), HasSubstr("do not belong together"));
}

TEST(VertexDistances, AreWrittenAsNumPyAndAsATable) {
  const DistanceTable table{{0, 4}, {1, 2, 3}, {{1, 2}, {2, 3}, {0, 0.5}, {0.25, 0.25}, {8, 16}, {1, 1}}};
  EXPECT_EQ(table.error(), 4 * (1 + 0x1p-40));
  for (const bool bounds : {false, true}) {
    const TableEntries entries = bounds ? TableEntries::bounds : TableEntries::distances;
    std::ostringstream out;
    write_npy(table, entries, out);
    const std::string bytes = out.str();
    ASSERT_EQ(bytes.size(), 128 + 8 * 6 * (bounds ? 2U : 1U));
    EXPECT_EQ(bytes.substr(0, 10), std::string("\x93NUMPY\x01\x00\x76\x00", 10));
    const std::string header =
        std::string("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3") + (bounds ? ", 2" : "") + "), }";
    EXPECT_EQ(bytes.substr(10, header.size()), header);
    EXPECT_EQ(bytes[127], '\n');
    const auto number = [&](std::size_t i) {
      std::uint64_t bits = 0;
      for (std::size_t k = 8; k-- > 0;) bits = (bits << 8) | static_cast<unsigned char>(bytes[128 + 8 * i + k]);
      return std::bit_cast<double>(bits);
    };
    EXPECT_EQ(number(0), bounds ? 1 : 1.5);
    EXPECT_EQ(number(1), bounds ? 2 : 2.5);
    EXPECT_EQ(number(4), bounds ? 0 : 12);
  }
  std::ostringstream lines;
  write_csv(table, TableEntries::distances, lines);
  EXPECT_THAT(lines.str(), testing::StartsWith("from,to,distance\n0,1,1.5\n0,2,2.5\n0,3,0.25\n4,1,0.25\n"));
  std::ostringstream two;
  write_csv(table, TableEntries::bounds, two);
  EXPECT_THAT(two.str(), testing::StartsWith("from,to,lower,upper\n0,1,1,2\n"));
  // The shortest decimals of these, 37.69911184307752 and 37.699111843077524, do not enclose them.
  const DistanceTable narrow{{0}, {1}, {{37.699111843077517, 37.699111843077525}}};
  std::ostringstream outward;
  write_csv(narrow, TableEntries::bounds, outward);
  EXPECT_EQ(outward.str(), "from,to,lower,upper\n0,1,37.699111843077517,37.699111843077525\n");
}

}  // namespace
}  // namespace epsnet::vertex_distances_test
