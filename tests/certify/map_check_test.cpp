#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"

/// Rule `map` alone: each defect is named, where it is first in the file.
namespace epsnet::certify::map_check_test {
namespace {

NetDocument load(const std::string& name) {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/" + name);
}

bool says(const RuleReport& report, const std::string& text) {
  return report.verdict == Verdict::refuted && report.text.find(text) != std::string::npos;
}

/// The first dart that is its own opposite, is not the opposite of its opposite, or does not start where that ends.
std::string first_culprit(const NetDocument& document) {
  for (std::uint32_t dart = 0; dart < 3 * document.triangles.size(); ++dart) {
    const std::uint32_t other = opposite(document, dart);
    if (other == dart)
      return "dart " + std::to_string(dart) + " (triangle " + std::to_string(dart / 3) + ", edge " +
             std::to_string(dart % 3) + ") is its own opposite";
    if (opposite(document, other) != dart || start(document, dart) != start(document, next_dart(other))) {
      return "dart " + std::to_string(dart) + " (triangle " + std::to_string(dart / 3) + ", edge " +
             std::to_string(dart % 3) + ") " +
             (opposite(document, other) != dart ? "has the opposite dart" : "starts at vertex");
    }
  }
  return "";
}

TEST(MapCheck, TheFirstWrongOppositeIsNamed) {
  for (const char* file : {"octagon-9-vertices.json", "octagon-1-vertex.json"}) {
    const NetDocument good = load(file);
    const auto darts = static_cast<std::uint32_t>(3 * good.triangles.size());
    for (std::uint32_t dart = 0; dart < darts; ++dart) {
      for (const std::uint32_t wrong : {0U, dart, darts / 2, darts - 1}) {
        // One way only, and both ways.
        NetDocument document = good;
        document.triangles[dart / 3].opposite[dart % 3] = wrong;
        const std::string one_way = first_culprit(document);
        if (!one_way.empty()) {
          EXPECT_TRUE(says(check_map(document, 2), one_way)) << one_way << '\n' << check_map(document, 2).text;
        }
        document.triangles[wrong / 3].opposite[wrong % 3] = dart;
        const std::string both_ways = first_culprit(document);
        if (!both_ways.empty()) {
          EXPECT_TRUE(says(check_map(document, 2), both_ways)) << both_ways << '\n' << check_map(document, 2).text;
        }
      }
      // An edge folded on itself: both its darts are their own opposites.
      NetDocument document = good;
      const std::uint32_t other = opposite(good, dart);
      document.triangles[dart / 3].opposite[dart % 3] = dart;
      document.triangles[other / 3].opposite[other % 3] = other;
      EXPECT_TRUE(says(check_map(document, 2), first_culprit(document))) << check_map(document, 2).text;
    }
  }
}

TEST(MapCheck, TheFirstWrongCornerIsNamed) {
  const NetDocument good = load("octagon-9-vertices.json");
  for (std::uint32_t dart = 0; dart < 66; ++dart) {
    for (const std::uint32_t wrong : {0U, 8U}) {
      NetDocument document = good;
      document.triangles[dart / 3].vertex[dart % 3] = wrong;
      if (start(good, dart) != wrong) {
        EXPECT_TRUE(says(check_map(document, 2), first_culprit(document))) << check_map(document, 2).text;
      }
    }
  }
}

TEST(MapCheck, ACycleOfOneDartIsACycle) {
  // A sphere of two triangles, each a cone over a loop at B: the two tips are one vertex A of the file. The lonely dart
  // of each tip is each of the three of its triangle.
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (std::uint32_t j = 0; j < 3; ++j) {
      NetDocument document;
      document.vertices.resize(2);
      document.triangles.resize(2);
      for (const auto& [t, k, other] : {std::array{0U, i, 3 + (j + 1) % 3}, std::array{1U, j, (i + 1) % 3}}) {
        NetDocument::Triangle& triangle = document.triangles[t];
        triangle.vertex = {1, 1, 1};
        triangle.vertex[k] = 0;
        triangle.opposite[k] = 3 * t + (k + 2) % 3;
        triangle.opposite[(k + 2) % 3] = 3 * t + k;
        triangle.opposite[(k + 1) % 3] = other;
      }
      EXPECT_TRUE(says(check_map(document, 0), "vertex 0 form more than one cycle")) << check_map(document, 0).text;
      // With a vertex for each tip it is a sphere.
      document.vertices.resize(3);
      document.triangles[1].vertex[j] = 2;
      EXPECT_EQ(check_map(document, 0).verdict, Verdict::verified) << check_map(document, 0).text;
      for (const std::uint64_t genus : {1U, 2U})
        EXPECT_TRUE(says(check_map(document, genus), "V - E + F = 3 - 3 + 2 = 2"));
    }
  }
}

TEST(MapCheck, EveryVertexIsInATriangle) {
  const NetDocument good = load("octagon-9-vertices.json");
  for (std::uint32_t idle = 0; idle <= 9; ++idle) {
    NetDocument document = good;
    document.vertices.push_back(document.vertices.front());
    for (NetDocument::Triangle& triangle : document.triangles) {
      for (std::uint32_t& vertex : triangle.vertex) vertex += vertex >= idle;
    }
    EXPECT_TRUE(says(check_map(document, 2), "vertex " + std::to_string(idle) + " belongs to no triangle"));
  }
}

TEST(MapCheck, TwoNetsAreNotConnected) {
  const NetDocument one = load("octagon-1-vertex.json");
  const auto triangles = static_cast<std::uint32_t>(one.triangles.size());
  NetDocument two = one;
  two.vertices.push_back(one.vertices[0]);
  for (NetDocument::Triangle triangle : one.triangles) {
    triangle.vertex = {1, 1, 1};
    for (std::uint32_t& dart : triangle.opposite) dart += 3 * triangles;
    two.triangles.push_back(triangle);
  }
  EXPECT_TRUE(says(check_map(two, 2), "from triangle 0 to triangle " + std::to_string(triangles)));
  // The Euler characteristic of both together is that of genus 3.
  EXPECT_TRUE(says(check_map(two, 3), "not connected"));
}

/// A torus of 2n² triangles: every cell (i, j) of a grid has one at its corner (i, j) and one at (i + 1, j + 1).
NetDocument torus(std::uint32_t n) {
  NetDocument document;
  document.vertices.resize(std::size_t{n} * n);
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return (i % n) * n + j % n; };
  const auto dart = [&](std::uint32_t i, std::uint32_t j, std::uint32_t which, std::uint32_t edge) {
    return 3 * (2 * vertex(i, j) + which) + edge;
  };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      document.triangles.push_back({.vertex = {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)},
                                    .opposite = {dart(i, j + n - 1, 1, 0), dart(i, j, 1, 1), dart(i + n - 1, j, 1, 2)},
                                    .label = {}});
      document.triangles.push_back({.vertex = {vertex(i + 1, j + 1), vertex(i, j + 1), vertex(i + 1, j)},
                                    .opposite = {dart(i, j + 1, 0, 0), dart(i, j, 0, 1), dart(i + 1, j, 0, 2)},
                                    .label = {}});
    }
  }
  return document;
}

/// What is wrong is the same for any number of threads, which share large maps out.
std::string text_of_map(const NetDocument& document, std::uint64_t genus) {
  const RuleReport report = check_map(document, genus, 1);
  for (const unsigned threads : {2U, 5U}) {
    EXPECT_EQ(check_map(document, genus, threads).verdict, report.verdict);
    EXPECT_EQ(check_map(document, genus, threads).text, report.text);
  }
  return std::string(name(report.verdict)) + ": " + report.text;
}

TEST(SlowMapCheck, LargeMapsAreCheckedInBlocks) {
  const NetDocument good = torus(200);
  EXPECT_EQ(text_of_map(good, 1).substr(0, 8), "VERIFIED");
  EXPECT_NE(text_of_map(good, 2).find("expected -2 for genus 2"), std::string::npos);
  // Wrong darts in several blocks: the first one is named.
  for (const std::uint32_t wrong : {0U, 40'000U, 100'001U, 239'999U}) {
    NetDocument document = good;
    for (std::uint32_t dart = wrong; dart < 240'000; dart += 50'000)
      document.triangles[dart / 3].opposite[dart % 3] = dart;
    EXPECT_NE(text_of_map(document, 1).find(first_culprit(document)), std::string::npos);
  }
  // One vertex for two: two cycles there, and a vertex without a triangle.
  for (const std::uint32_t gone : {1U, 20'000U, 39'999U}) {
    NetDocument document = good;
    for (NetDocument::Triangle& triangle : document.triangles) {
      for (std::uint32_t& v : triangle.vertex) v = v == gone ? 777 : v;
    }
    EXPECT_EQ(text_of_map(document, 1), "REFUTED: the darts leaving vertex 777 form more than one cycle");
    NetDocument idle = good;
    idle.vertices.push_back({});
    for (NetDocument::Triangle& triangle : idle.triangles) {
      for (std::uint32_t& v : triangle.vertex) v += v >= gone ? 1 : 0;
    }
    EXPECT_EQ(text_of_map(idle, 1), "REFUTED: vertex " + std::to_string(gone) + " belongs to no triangle");
  }
  // Two of them, the triangles of one between those of the other.
  NetDocument two;
  two.vertices.resize(2 * good.vertices.size());
  for (const NetDocument::Triangle& triangle : good.triangles) {
    for (const std::uint32_t copy : {0U, 1U}) {
      NetDocument::Triangle& added = two.triangles.emplace_back(triangle);
      for (std::uint32_t& v : added.vertex) v = 2 * v + copy;
      for (std::uint32_t& dart : added.opposite) dart = 3 * (2 * (dart / 3) + copy) + dart % 3;
    }
  }
  EXPECT_EQ(text_of_map(two, 1), "REFUTED: not connected: no path of edges leads from triangle 0 to triangle 1");
}

TEST(MapCheck, EmptyOnesAreNone) {
  NetDocument document;
  EXPECT_TRUE(says(check_map(document, 2), "there is no vertex"));
  document.vertices.resize(1);
  EXPECT_TRUE(says(check_map(document, 2), "there is no triangle"));
}

TEST(MapCheck, TheGenusIsExact) {
  for (std::uint64_t genus = 0; genus < 5; ++genus) {
    EXPECT_EQ(check_map(load("octagon-9-vertices.json"), genus).verdict,
              genus == 2 ? Verdict::verified : Verdict::refuted);
  }
}

/// The definition, clause by clause (docs/proof.md, section 3).
bool is_map(const NetDocument& document, std::int64_t euler) {
  const auto darts = static_cast<std::uint32_t>(3 * document.triangles.size());
  std::vector<std::uint32_t> leaving(document.vertices.size(), 0);
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    const std::uint32_t other = opposite(document, dart);
    if (other == dart || opposite(document, other) != dart ||
        start(document, other) != start(document, next_dart(dart)))
      return false;
    ++leaving[start(document, dart)];
  }
  for (std::uint32_t dart = 0; dart < darts; ++dart) {
    std::uint32_t cycle = 1;
    for (std::uint32_t d = opposite(document, previous_dart(dart)); d != dart; d = opposite(document, previous_dart(d)))
      ++cycle;
    if (cycle != leaving[start(document, dart)]) return false;
  }
  std::vector<std::uint32_t> piece(document.triangles.size());
  std::iota(piece.begin(), piece.end(), 0U);
  for (std::size_t round = 0; round < piece.size(); ++round) {
    for (std::uint32_t dart = 0; dart < darts; ++dart)
      piece[dart / 3] = std::min(piece[dart / 3], piece[opposite(document, dart) / 3]);
  }
  const auto vertices = static_cast<std::int64_t>(leaving.size());
  return std::count(leaving.begin(), leaving.end(), 0U) == 0 &&
         std::count(piece.begin(), piece.end(), 0U) * 3 == std::ptrdiff_t{darts} &&
         vertices - darts / 2 + darts / 3 == euler;
}

/// Triangles whose edges are glued at random, with a vertex for each cycle of darts.
NetDocument random_map(std::uint32_t triangles, std::mt19937& random) {
  NetDocument document;
  document.triangles.resize(triangles);
  std::vector<std::uint32_t> darts(std::size_t{3} * triangles);
  std::iota(darts.begin(), darts.end(), 0U);
  std::shuffle(darts.begin(), darts.end(), random);
  for (std::size_t k = 0; k < darts.size(); ++k)
    document.triangles[darts[k] / 3].opposite[darts[k] % 3] = darts[k ^ 1U];
  std::vector<bool> met(darts.size());
  for (const std::uint32_t first : darts) {
    if (met[first]) continue;
    for (std::uint32_t dart = first; !met[dart]; dart = opposite(document, previous_dart(dart))) {
      met[dart] = true;
      document.triangles[dart / 3].vertex[dart % 3] = static_cast<std::uint32_t>(document.vertices.size());
    }
    document.vertices.emplace_back();
  }
  return document;
}

TEST(MapCheck, IsTheDefinition) {
  std::mt19937 random(1);
  const auto any = [&](std::size_t count) { return static_cast<std::uint32_t>(random() % count); };
  std::map<bool, int> met;
  for (int trial = 0; trial < 60'000; ++trial) {
    NetDocument document = random_map(2 + 2 * any(4), random);
    const auto darts = static_cast<std::uint32_t>(3 * document.triangles.size());
    // Nothing, or one or two defects.
    for (std::uint32_t defects = any(3); defects > 0; --defects) {
      auto& triangles = document.triangles;
      const std::uint32_t u = any(document.vertices.size());
      const std::uint32_t dart = any(darts);
      switch (any(5)) {
        case 0:  // Another number for a vertex: two are one, and one is left without triangles.
          for (auto& triangle : triangles) {
            std::replace(triangle.vertex.begin(), triangle.vertex.end(), u, any(document.vertices.size()));
          }
          break;
        case 1:  // The last vertex is another one.
          for (auto& triangle : triangles) {
            const auto last = static_cast<std::uint32_t>(document.vertices.size() - 1);
            std::replace(triangle.vertex.begin(), triangle.vertex.end(), last, last == 0 ? 0 : u % last);
          }
          if (document.vertices.size() > 1) document.vertices.pop_back();
          break;
        case 2:
          triangles[dart / 3].opposite[dart % 3] = any(darts);
          break;
        case 3:
          triangles[dart / 3].vertex[dart % 3] = u;
          break;
        default:
          document.vertices.emplace_back();
          break;
      }
    }
    // The genus for which the numbers are right, if there is one.
    const auto euler = static_cast<std::int64_t>(document.vertices.size()) - darts / 2 + darts / 3;
    const std::int64_t genus = (2 - euler) / 2;
    const bool expected = is_map(document, 2 - 2 * genus);
    const RuleReport report = check_map(document, static_cast<std::uint64_t>(genus));
    ASSERT_EQ(report.verdict, expected ? Verdict::verified : Verdict::refuted) << report.text;
    ++met[expected];
  }
  EXPECT_GT(met[true], 10'000);
  EXPECT_GT(met[false], 10'000);
}

}  // namespace
}  // namespace epsnet::certify::map_check_test
