#include "certify/net/structure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/net/numbering.h"

/// What docs/format.md says of the members of nets and surfaces together, clause by clause: the last value that is
/// allowed, and the first that is not.
namespace epsnet::certify::structure_test {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

constexpr std::uint32_t kLargest = std::numeric_limits<std::uint32_t>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const double kNan = std::nan("");

/// A triangle with the sides 0, 1, 2 and a pentagon with the sides 3 to 7. Nobody asks here whether they fit.
SurfaceDocument tiles() {
  SurfaceDocument surface;
  surface.tiles = {SurfaceDocument::Tile(3), SurfaceDocument::Tile(5)};
  surface.gluing = {{0, 0, 1, 0}, {0, 1, 0, 2}, {1, 1, 1, 3}, {1, 2, 1, 4}};
  return surface;
}

SurfaceDocument regular(std::uint32_t genus) {
  SurfaceDocument surface;
  surface.regular_genus = genus;
  return surface;
}

/// Of every kind of index it has the largest that is allowed.
NetDocument net() {
  NetDocument document;
  document.surface = tiles();
  document.epsilon = "1";
  document.charts = {
      {0, {0, 0}}, {1, {mpq_class(1, 2), mpq_class(-1, 2)}}, {0, {mpq_class(3, 5), mpq_class(3999, 5000)}}};
  document.labels = {{1, 0, {3}}, {0, 1, {0}}, {2, 0, {1}}, {2, 1, {1, 0}}, {1, 1, {7, 5, 4}}};
  document.vertices = {{0.25, -0.5, 0}, {0.125, 0, 1}, {-0.75, 0.5, 2}, {0, 0.75, 0}};
  document.triangles = {{{0, 1, 2}, {3, 4, 5}, {1, 3}},
                        {{1, 0, 2}, {0, 1, 2}, {2, 4}},
                        {{0, 3, 3}, {9, 10, 11}, {0, 0}},
                        {{1, 1, 1}, {6, 7, 8}, {5, 5}}};
  document.collars = {{{0, 3}, {0.5, 1}, {0, 2}, {0, 1}}, {{7, 5, 4}, {0, 0}, {1, 3}, {3, 2}}};
  return document;
}

/// What is wrong with a document after a change; "" if nothing is.
std::string problem(const std::function<void(NetDocument&)>& change) {
  NetDocument document = net();
  change(document);
  return structure_problem(document).value_or("");
}

std::string problem_of_tiles(const std::function<void(SurfaceDocument&)>& change) {
  SurfaceDocument surface = tiles();
  change(surface);
  return structure_problem(surface).value_or("");
}

TEST(Structure, ATrueOneHasIt) {
  EXPECT_EQ(structure_problem(net()), std::nullopt);
  EXPECT_EQ(structure_problem(tiles()), std::nullopt);
  EXPECT_EQ(structure_problem(regular(2)), std::nullopt);
  EXPECT_EQ(structure_problem(regular(1000)), std::nullopt);
}

/// `index` gives the place of an index, which must be less than `size`.
void expect_below(const std::function<std::uint32_t&(NetDocument&)>& index, std::uint32_t size,
                  const std::string& place) {
  SCOPED_TRACE(place);
  for (const std::uint32_t wrong : {size, size + 1, kLargest}) {
    EXPECT_THAT(problem([&](NetDocument& d) { index(d) = wrong; }), StartsWith(place)) << wrong;
    EXPECT_THAT(problem([&](NetDocument& d) { index(d) = wrong; }), testing::HasSubstr("does not exist")) << wrong;
  }
}

TEST(Structure, IndicesAreInRange) {
  using D = NetDocument;
  expect_below(
      [](D & d) -> auto& { return d.surface.gluing[0].tile; }, 2, "surface.gluing[0]: tile ");
  expect_below(
      [](D & d) -> auto& { return d.surface.gluing[3].other_tile; }, 2, "surface.gluing[3]: tile ");
  expect_below(
      [](D & d) -> auto& { return d.surface.gluing[1].side; }, 3, "surface.gluing[1]: side ");
  expect_below(
      [](D & d) -> auto& { return d.surface.gluing[0].other_side; }, 5, "surface.gluing[0]: side ");
  expect_below(
      [](D & d) -> auto& { return d.charts[2].tile; }, 2, "charts[2]: tile ");
  expect_below(
      [](D & d) -> auto& { return d.labels[0].from; }, 3, "labels[0]: chart ");
  expect_below(
      [](D & d) -> auto& { return d.labels[4].to; }, 3, "labels[4]: chart ");
  expect_below(
      [](D & d) -> auto& { return d.labels[0].word[0]; }, 8, "labels[0]: side ");
  expect_below(
      [](D & d) -> auto& { return d.labels[4].word[2]; }, 8, "labels[4]: side ");
  expect_below(
      [](D & d) -> auto& { return d.vertices[3].chart; }, 3, "vertices[3]: chart ");
  for (std::size_t row = 0; row < 4; ++row) {
    const std::string place = "triangles[" + std::to_string(row) + "]: ";
    for (std::size_t i = 0; i < 3; ++i) {
      expect_below(
          [&](D & d) -> auto& { return d.triangles[row].vertex[i]; }, 4, place + "vertex ");
      expect_below(
          [&](D & d) -> auto& { return d.triangles[row].opposite[i]; }, 12, place + "dart ");
    }
    for (std::size_t i = 0; i < 2; ++i) {
      expect_below(
          [&](D & d) -> auto& { return d.triangles[row].label[i]; }, 6, place + "label number ");
    }
  }
  for (std::size_t row = 0; row < 2; ++row) {
    const std::string place = "collars[" + std::to_string(row) + "]: ";
    for (std::size_t i = 0; i < 2; ++i) {
      expect_below(
          [&](D & d) -> auto& { return (*d.collars)[row].vertices[i]; }, 4, place + "vertex ");
      expect_below(
          [&](D & d) -> auto& { return (*d.collars)[row].triangles[i]; }, 4, place + "triangle ");
    }
    expect_below(
        [&](D & d) -> auto& { return (*d.collars)[row].core[1]; }, 8, place + "side ");
  }
}

TEST(Structure, LabelsLeadFromTheirCornersChartToThatOfTheTriangle) {
  const auto with_label = [](std::size_t row, std::size_t i, std::uint32_t number) {
    return problem([&](NetDocument& d) { d.triangles[row].label[i] = number; });
  };
  // The charts that labels 0 to 5 lead from and to, the first one in the triangle's own chart.
  constexpr std::array<std::array<std::uint32_t, 2>, 6> kEnds{{{9, 9}, {1, 0}, {0, 1}, {2, 0}, {2, 1}, {1, 1}}};
  for (std::size_t row = 0; row < 4; ++row) {
    const NetDocument document = net();
    const NetDocument::Triangle& triangle = document.triangles[row];
    const std::uint32_t chart = chart_of_triangle(document, static_cast<std::uint32_t>(row));
    for (std::size_t i = 0; i < 2; ++i) {
      const std::uint32_t own = document.vertices[triangle.vertex[i + 1]].chart;
      for (std::uint32_t number = 0; number < 6; ++number) {
        const bool fits = number == 0 ? own == chart : kEnds[number][0] == own && kEnds[number][1] == chart;
        EXPECT_EQ(with_label(row, i, number).empty(), fits) << row << ' ' << i << ' ' << number;
      }
    }
  }
}

TEST(Structure, WordsLeadFromTileToTile) {
  const auto with_word = [](std::size_t label, const std::vector<std::uint32_t>& word) {
    return problem([&](NetDocument& d) { d.labels[label].word = word; });
  };
  EXPECT_EQ(with_word(0, {3, 0, 4, 3}), "");
  EXPECT_EQ(with_word(0, {}), "labels[0]: the word ends in tile 1, expected the tile 0 of chart 0");
  EXPECT_EQ(with_word(1, {}), "labels[1]: the word ends in tile 0, expected the tile 1 of chart 1");
  EXPECT_EQ(with_word(2, {}), "");
  EXPECT_EQ(with_word(0, {0}), "labels[0]: letter 0 is side 0 of tile 0, expected a side of tile 1");
  EXPECT_EQ(with_word(1, {3}), "labels[1]: letter 0 is side 3 of tile 1, expected a side of tile 0");
  EXPECT_EQ(with_word(3, {1, 0, 0}), "labels[3]: letter 2 is side 0 of tile 0, expected a side of tile 1");
  const auto with_core = [](std::size_t collar, const std::vector<std::uint32_t>& word) {
    return problem([&](NetDocument& d) { (*d.collars)[collar].core = word; });
  };
  EXPECT_EQ(with_core(0, {}), "");
  EXPECT_EQ(with_core(0, {0}), "collars[0]: the word ends in tile 1, expected the tile 0 of vertex 0");
  EXPECT_EQ(with_core(1, {3}), "collars[1]: the word ends in tile 0, expected the tile 1 of vertex 1");
  EXPECT_EQ(with_core(1, {0}), "collars[1]: letter 0 is side 0 of tile 0, expected a side of tile 1");
}

TEST(Structure, EverySideOfATileIsGluedOnce) {
  using S = SurfaceDocument;
  EXPECT_EQ(problem_of_tiles([](S& s) { s.gluing.pop_back(); }),
            "surface.gluing: 6 of 8 sides occur, expected every side once");
  EXPECT_EQ(problem_of_tiles([](S& s) { s.gluing.clear(); }),
            "surface.gluing: 0 of 8 sides occur, expected every side once");
  EXPECT_EQ(problem_of_tiles([](S& s) {
              s.gluing[0] = {0, 0, 0, 0};
            }),
            "surface.gluing[0]: side 0 of tile 0 occurs twice, expected every side once");
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_THAT(problem_of_tiles([&](S& s) { s.gluing.push_back(s.gluing[row]); }),
                StartsWith("surface.gluing[4]: side "));
  }
  // Every side of one row in the place of every one of another.
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t other = 0; other < 4; ++other) {
      if (row == other) continue;
      const std::string place = "surface.gluing[" + std::to_string(std::max(row, other)) + "]: side ";
      const auto expect_twice = [&](const std::function<void(S&)>& change) {
        EXPECT_THAT(problem_of_tiles(change), StartsWith(place)) << row << ' ' << other;
      };
      expect_twice([&](S& s) {
        s.gluing[row].tile = s.gluing[other].tile;
        s.gluing[row].side = s.gluing[other].side;
      });
      expect_twice([&](S& s) {
        s.gluing[row].other_tile = s.gluing[other].tile;
        s.gluing[row].other_side = s.gluing[other].side;
      });
      expect_twice([&](S& s) {
        s.gluing[row].other_tile = s.gluing[other].other_tile;
        s.gluing[row].other_side = s.gluing[other].other_side;
      });
    }
  }
}

TEST(Structure, TilesHaveThreeVerticesOrMore) {
  using S = SurfaceDocument;
  for (const std::size_t size : {0U, 1U, 2U}) {
    EXPECT_EQ(problem_of_tiles([&](S& s) { s.tiles[0].resize(size); }),
              "surface.tiles[0]: has " + std::to_string(size) + " vertices, expected at least 3");
    EXPECT_EQ(problem_of_tiles([&](S& s) { s.tiles[1].resize(size); }),
              "surface.tiles[1]: has " + std::to_string(size) + " vertices, expected at least 3");
  }
  EXPECT_EQ(structure_problem(SurfaceDocument()), "surface.tiles: no tile, expected at least one");
}

TEST(Structure, RegularSurfacesHaveAGenusAndNothingElse) {
  EXPECT_EQ(structure_problem(regular(1)), "surface.genus: the genus is 1, expected at least 2");
  EXPECT_EQ(structure_problem(regular(1001)), "surface.genus: the genus 1001 is more than the limit of 1000");
  EXPECT_TRUE(structure_problem(regular(kLargest)).has_value());
  EXPECT_TRUE(regular_genus_problem(0).has_value());
  EXPECT_EQ(regular_genus_problem(2), std::nullopt);
  SurfaceDocument surface = regular(2);
  surface.tiles = tiles().tiles;
  EXPECT_EQ(structure_problem(surface), "surface.tiles: a regular surface has none");
  surface = regular(2);
  surface.gluing = tiles().gluing;
  EXPECT_EQ(structure_problem(surface), "surface.gluing: a regular surface has none");
}

TEST(Structure, FreeTextHasALimit) {
  for (SurfaceDocument surface : {tiles(), regular(2)}) {
    surface.about.assign(std::size_t{1} << 20U, 'a');
    EXPECT_EQ(structure_problem(surface), std::nullopt);
    surface.about += 'a';
    EXPECT_EQ(structure_problem(surface), "surface.about: more than the limit of 1 MiB");
  }
}

TEST(Structure, TheSurfaceOfANetIsOne) {
  EXPECT_THAT(problem([](NetDocument& d) { d.surface.gluing.pop_back(); }), StartsWith("surface.gluing: "));
}

TEST(Structure, EpsilonIsAPositiveDecimal) {
  const auto with_epsilon = [](const char* epsilon) { return problem([&](NetDocument& d) { d.epsilon = epsilon; }); };
  for (const char* epsilon : {"1", "0.001", "1e-9999", "1/1000000", "9e999"}) EXPECT_EQ(with_epsilon(epsilon), "");
  for (const char* epsilon : {"0", "-1", "-0.001", "0e5", "0/3", "-0", "-1/2"}) {
    EXPECT_EQ(with_epsilon(epsilon), "epsilon: \"" + std::string(epsilon) + "\" is not positive");
  }
  for (const char* epsilon : {"", "x", "1/0", "1.", "1e", "1 "}) {
    EXPECT_THAT(with_epsilon(epsilon), testing::HasSubstr("is not a decimal")) << epsilon;
  }
}

TEST(Structure, CentresAreInsideTheDisk) {
  const auto with_centre = [](const mpq_class& x, const mpq_class& y) {
    return problem([&](NetDocument& d) { d.charts[1].centre = {x, y}; });
  };
  const mpq_class tiny(mpz_class(1), mpz_class(1) << 1000U);
  const mpq_class below = 1 - tiny;
  for (const int sign : {1, -1}) {
    EXPECT_EQ(with_centre(sign * below, 0), "");
    EXPECT_EQ(with_centre(0, sign * below), "");
    EXPECT_EQ(with_centre(sign * below, tiny), "");
    for (const auto& [x, y] : {std::pair<mpq_class, mpq_class>{sign, 0},
                               {0, sign},
                               {mpq_class(3 * sign, 5), mpq_class(4, 5)},
                               {mpq_class(4, 5), mpq_class(4 * sign, 5)},
                               {mpq_class(9 * sign, 10), mpq_class(9, 10)},
                               {mpq_class(3 * sign, 5) + tiny, mpq_class(4, 5)},
                               {2 * sign, 0},
                               {below * sign, mpq_class(1, 10)}}) {
      const bool inside = x * x + y * y < 1;
      EXPECT_EQ(with_centre(x, y), inside ? "" : "charts[1]: the centre is not inside the unit disk") << x << ' ' << y;
    }
  }
}

TEST(Structure, VerticesAreInsideTheDisk) {
  const auto accepts = [](double x, double y) {
    const std::string found = problem([&](NetDocument& d) {
      d.vertices[1].x = x;
      d.vertices[1].y = y;
    });
    EXPECT_TRUE(found.empty() || found.find("is not inside the unit disk") != std::string::npos) << found;
    return found.empty();
  };
  const double last = std::nextafter(1.0, 0.0);
  for (const double x : {0.0, 5e-324, 1e-160, 1e-8, 2e-8, 0.1, 0.5, 0.6, 0.8, 0.99, 1 - 1e-14, last, 1.0, 1.5, 1e200,
                         std::numeric_limits<double>::max()}) {
    for (const double y : {0.0, 5e-324, 1e-160, 1e-8, 2e-8, 1e-7, 0.1, 0.5, 0.6, std::nextafter(0.6, 0.0), 0.8,
                           std::nextafter(0.8, 0.0), 0.99, last, 1.0, 1.5, 1e200}) {
      const bool inside = mpq_class(x) * mpq_class(x) + mpq_class(y) * mpq_class(y) < 1;
      for (const double sign : {1.0, -1.0}) {
        EXPECT_EQ(accepts(x, sign * y), inside) << x << ' ' << y;
        EXPECT_EQ(accepts(-sign * y, x), inside) << x << ' ' << y;
      }
    }
  }
  for (const double none : {kInfinity, -kInfinity, kNan}) {
    EXPECT_FALSE(accepts(none, 0));
    EXPECT_FALSE(accepts(0, none));
    EXPECT_FALSE(accepts(none, none));
  }
}

TEST(Structure, LengthsOfCollarsAreIntervals) {
  const auto with_length = [](double lower, double upper) {
    return problem([&](NetDocument& d) { (*d.collars)[1].length = {lower, upper}; });
  };
  for (const auto& [lower, upper] :
       {std::pair{0.0, 0.0}, {0.0, 0.5}, {0.5, 0.5}, {0.5, 2.0}, {1e-300, 1e-300}, {3.0, 4.0}}) {
    EXPECT_EQ(with_length(lower, upper), "") << lower << ' ' << upper;
  }
  for (const auto& [lower, upper] : {std::pair{-1.0, 1.0},
                                     {-1e-300, 0.0},
                                     {2.0, 1.0},
                                     {1.0, 0.0},
                                     {std::nextafter(1.0, 2.0), 1.0},
                                     {0.0, kInfinity},
                                     {kInfinity, kInfinity},
                                     {-kInfinity, 1.0},
                                     {kNan, 1.0},
                                     {0.0, kNan}}) {
    EXPECT_THAT(with_length(lower, upper), StartsWith("collars[1]: the length ")) << lower << ' ' << upper;
  }
}

TEST(Structure, ANetMayHaveNoCollarsAndNoRows) {
  EXPECT_EQ(problem([](NetDocument& d) { d.collars.reset(); }), "");
  EXPECT_EQ(problem([](NetDocument& d) { d.collars->clear(); }), "");
  NetDocument empty;
  empty.surface = regular(2);
  empty.epsilon = "1";
  EXPECT_EQ(structure_problem(empty), std::nullopt);
}

TEST(Structure, ANetMayHaveManyRows) {
  EXPECT_EQ(problem([](NetDocument& d) { d.triangles.resize(100'000, d.triangles[0]); }), "");
  EXPECT_EQ(problem([](NetDocument& d) { d.vertices.resize(100'000, d.vertices[0]); }), "");
}

TEST(Structure, IsWhatMalformationAsksOfAnyDocument) {
  NetDocument document = net();
  EXPECT_EQ(malformation(document), std::nullopt);
  EXPECT_EQ(malformation(ClaimDocument(document)), std::nullopt);
  document.vertices[0].x = 2;
  ASSERT_TRUE(malformation(document).has_value());
  EXPECT_EQ(malformation(document), structure_problem(document));
  EXPECT_EQ(malformation(ClaimDocument(document), 2), structure_problem(document));
  // A rule that fails is another thing.
  document = net();
  std::swap(document.triangles[0].opposite[0], document.triangles[0].opposite[1]);
  EXPECT_EQ(malformation(document), std::nullopt);
}

TEST(Structure, ThreadsFindTheFirstProblem) {
  NetDocument document = net();
  document.triangles.resize(100'000, document.triangles[0]);
  document.triangles[99'999].vertex[0] = 1'000'000;
  document.triangles[40'000].vertex[1] = 1'000'000;
  document.triangles[40'001].vertex[2] = 1'000'000;
  document.vertices.resize(100'000, document.vertices[0]);
  for (const unsigned threads : {1U, 2U, 5U}) {
    EXPECT_EQ(structure_problem(document, threads),
              "triangles[40000]: vertex 1000000 does not exist, expected less than 100000");
  }
  document.vertices[70'000].x = 2;
  for (const unsigned threads : {1U, 2U, 5U}) {
    EXPECT_TRUE(structure_problem(document, threads)->starts_with("vertices[70000]: (2, ")) << threads;
  }
}

TEST(SurfaceSides, AreNumberedInTheOrderOfTheFile) {
  const SurfaceSides sides(tiles());
  EXPECT_EQ(number_of_tiles(tiles()), 2U);
  EXPECT_THAT(sides.first, ElementsAre(0, 3));
  EXPECT_THAT(sides.tile, ElementsAre(0, 0, 0, 1, 1, 1, 1, 1));
  EXPECT_THAT(sides.corner, ElementsAre(0, 1, 2, 0, 1, 2, 3, 4));
  EXPECT_THAT(sides.partner, ElementsAre(3, 2, 1, 0, 6, 7, 4, 5));
  EXPECT_THAT(sides.next, ElementsAre(1, 2, 0, 4, 5, 6, 7, 3));
  EXPECT_THAT(sides.previous, ElementsAre(2, 0, 1, 7, 3, 4, 5, 6));
  EXPECT_EQ(sides.next_around(0), 4U);
  EXPECT_EQ(sides.next_around(7), 6U);
  EXPECT_THAT(sides.vertices(), ElementsAre(0, 2));
}

TEST(SurfaceSides, OppositeSidesOfRegularPolygonsAreGlued) {
  const SurfaceSides sides(regular(2));
  EXPECT_EQ(number_of_tiles(regular(2)), 1U);
  EXPECT_THAT(sides.first, ElementsAre(0));
  EXPECT_THAT(sides.tile, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(sides.corner, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(sides.partner, ElementsAre(4, 5, 6, 7, 0, 1, 2, 3));
  EXPECT_THAT(sides.next, ElementsAre(1, 2, 3, 4, 5, 6, 7, 0));
  EXPECT_THAT(sides.previous, ElementsAre(7, 0, 1, 2, 3, 4, 5, 6));
  EXPECT_THAT(sides.vertices(), ElementsAre(0));
  EXPECT_EQ(SurfaceSides(regular(3)).partner[5], 11U);
  EXPECT_EQ(SurfaceSides(regular(3)).partner.size(), 12U);
}

TEST(Darts, GoAroundTheirTriangles) {
  const NetDocument document = net();
  for (std::uint32_t t = 0; t < 4; ++t) {
    const NetDocument::Triangle& triangle = document.triangles[t];
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t dart = 3 * t + i;
      EXPECT_EQ(next_dart(dart), 3 * t + (i + 1) % 3);
      EXPECT_EQ(previous_dart(dart), 3 * t + (i + 2) % 3);
      EXPECT_EQ(opposite(document, dart), triangle.opposite[i]);
      EXPECT_EQ(start(document, dart), triangle.vertex[i]);
      EXPECT_EQ(corner_label(document, dart), i == 0 ? 0 : triangle.label[i - 1]);
    }
  }
  EXPECT_EQ(chart_of_triangle(document, 0), 0U);
  EXPECT_EQ(chart_of_triangle(document, 1), 1U);
}

}  // namespace
}  // namespace epsnet::certify::structure_test
