#include <cmath>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/claims/geodesics/fields.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"

/// Members that a claim has or has not, and words, as docs/format.md says: each is malformed by itself.
namespace epsnet::certify::geodesics_structure_test {
namespace {

GeodesicsDocument three_cuffs() { return read_file<GeodesicsDocument>(EPSNET_TEST_DATA "/geodesics/three-cuffs.json"); }

GeodesicsDocument systole() {
  GeodesicsDocument document = three_cuffs();
  document.claim = GeodesicsDocument::Claim::systole;
  document.geodesics.resize(1);
  document.clusters.clear();
  document.pieces.clear();
  return document;
}

void expect_malformed(const GeodesicsDocument& document, const std::string& problem) {
  const auto found = structure_problem(document);
  ASSERT_TRUE(found.has_value()) << "expected: " << problem;
  EXPECT_NE(found->find(problem), std::string::npos) << *found;
  const Certificate certificate = check(document, {.threads = 1});
  EXPECT_EQ(certificate.verdict, Verdict::malformed);
  EXPECT_EQ(certificate.rule, "structure");
  EXPECT_EQ(malformation(document), found);
}

TEST(GeodesicsStructure, TrueFilesHaveIt) {
  EXPECT_EQ(structure_problem(three_cuffs()), std::nullopt);
  EXPECT_EQ(structure_problem(systole()), std::nullopt);
}

TEST(GeodesicsStructure, AWordEndsInTheTileWhereItStarts) {
  GeodesicsDocument document = three_cuffs();
  document.geodesics[0].word = {1};  // To the other pair of pants.
  expect_malformed(document, "geodesics[0]: the word ends in tile 1, expected the tile 0 of vertex ");
  document.geodesics[0].word = {1, 1};
  expect_malformed(document, "geodesics[0]: letter 1 is side 1 of tile 0, expected a side of tile 1");
}

TEST(GeodesicsStructure, ASystoleHasNothingOfAList) {
  const GeodesicsDocument full = three_cuffs();
  GeodesicsDocument document = systole();
  document.clusters = {full.clusters[0]};
  expect_malformed(document, "a systole has neither up_to nor clusters nor pieces");
  document = systole();
  document.pieces = full.pieces;
  expect_malformed(document, "a systole has neither up_to nor clusters nor pieces");
  document = systole();
  document.up_to = "1";
  expect_malformed(document, "a systole has neither up_to nor clusters nor pieces");
}

TEST(GeodesicsStructure, OnlyASpectrumHasABoundOfItsOwn) {
  GeodesicsDocument document = three_cuffs();
  document.up_to = "2";
  expect_malformed(document, "up_to: only a spectrum or a local maximum has it");
}

TEST(GeodesicsStructure, OnlyAThickThinDecompositionHasPieces) {
  GeodesicsDocument document = three_cuffs();
  document.claim = GeodesicsDocument::Claim::spectrum;
  document.up_to = "1.5";
  expect_malformed(document, "pieces: only a thick-thin decomposition has them");
}

/// Twelve shortest geodesics of a surface of genus 2, of which six are the basis.
GeodesicsDocument maximum() { return read_file<GeodesicsDocument>(EPSNET_TEST_DATA "/geodesics/bolza-maximum.json"); }

TEST(GeodesicsStructure, OnlyALocalMaximumHasABasisAndWeights) {
  for (const auto claim : {GeodesicsDocument::Claim::systole, GeodesicsDocument::Claim::thick_thin}) {
    for (const bool weights : {false, true}) {
      GeodesicsDocument document = claim == GeodesicsDocument::Claim::systole ? systole() : three_cuffs();
      (weights ? document.weights : document.basis) = {1};
      expect_malformed(document, claim == GeodesicsDocument::Claim::systole
                                     ? "a systole has neither up_to nor clusters nor pieces nor basis nor weights"
                                     : "basis: only a local maximum has it, and weights");
    }
  }
}

TEST(GeodesicsStructure, TheFirstClusterOfALocalMaximumIsOfEqualLengths) {
  GeodesicsDocument document = maximum();
  EXPECT_EQ(structure_problem(document), std::nullopt);
  document.clusters[0].equal = false;
  expect_malformed(document, "clusters: the first ones of a local maximum are of equal length");
  document.geodesics.clear();
  document.clusters.clear();
  expect_malformed(document, "clusters: the first ones of a local maximum are of equal length");
}

TEST(GeodesicsStructure, ABasisHas6gMinus6GeodesicsInOrder) {
  GeodesicsDocument document = maximum();
  document.basis.pop_back();
  document.weights.push_back(1);
  expect_malformed(document, "basis: 5 elements, expected 6g - 6");
  document = maximum();
  document.basis = {0, 1, 2, 3, 4, 5, 6};
  document.weights.pop_back();
  expect_malformed(document, "basis: 7 elements, expected 6g - 6");
  document = maximum();
  document.basis = {0, 2, 2, 3, 8, 9};
  expect_malformed(document, "basis[2]: 2 is not one of the first 12 geodesics after the one before");
  document.basis = {0, 1, 2, 3, 8, 12};
  expect_malformed(document, "basis[5]: 12 is not one of the first 12 geodesics after the one before");
  document.basis = {0, 1, 2, 3, 8, 11};
  EXPECT_EQ(structure_problem(document), std::nullopt);
}

TEST(GeodesicsStructure, EveryOtherShortestGeodesicHasAPositiveWeight) {
  GeodesicsDocument document = maximum();
  document.weights.pop_back();
  expect_malformed(document, "weights: 5 elements, expected one for each of the first 12 geodesics that is not in the");
  document.weights = {1, 1, 1, 1, 1, 1, 1};
  expect_malformed(document, "weights: 7 elements, expected one for each of the first 12 geodesics that is not in the");
  document.weights = {1, 1, 1, 0, 1, 1};
  expect_malformed(document, "weights[3]: 0, expected at least 1");
}

TEST(GeodesicsStructure, EverySideOfEveryGeodesicBoundsAPiece) {
  GeodesicsDocument document = three_cuffs();
  document.pieces[1].boundaries.pop_back();
  expect_malformed(document, "pieces: 5 of 6 sides of geodesics occur");
}

/// Loops around nothing with these lengths: what the lists say together is all that is asked here.
GeodesicsDocument listed(GeodesicsDocument::Claim claim, const std::vector<Interval>& lengths,
                         const std::vector<GeodesicsDocument::Cluster>& clusters) {
  GeodesicsDocument document = three_cuffs();
  document.claim = claim;
  document.geodesics.clear();
  for (const Interval length : lengths) document.geodesics.emplace_back().length = length;
  document.clusters = clusters;
  document.pieces.clear();
  if (claim == GeodesicsDocument::Claim::spectrum) document.up_to = "2.5";
  return document;
}

GeodesicsDocument spectrum(const std::vector<Interval>& lengths,
                           const std::vector<GeodesicsDocument::Cluster>& clusters) {
  return listed(GeodesicsDocument::Claim::spectrum, lengths, clusters);
}

GeodesicsDocument systole_of(const std::vector<Interval>& lengths) {
  return listed(GeodesicsDocument::Claim::systole, lengths, {});
}

TEST(GeodesicsStructure, TheNetHasItToo) {
  GeodesicsDocument document = three_cuffs();
  document.net.epsilon = "0";
  expect_malformed(document, "epsilon: \"0\" is not positive");
  document = three_cuffs();
  document.net.collars.emplace();
  expect_malformed(document, "net: collars, a pseudo net");
}

TEST(GeodesicsStructure, VerticesExist) {
  GeodesicsDocument document = spectrum({{1, 1}, {2, 2}}, {{0, 1}, {1, 1}});
  const auto vertices = static_cast<std::uint32_t>(document.net.vertices.size());
  for (std::size_t i = 0; i < 2; ++i) {
    GeodesicsDocument changed = document;
    changed.geodesics[i].vertex = vertices - 1;
    EXPECT_EQ(structure_problem(changed), std::nullopt);
    for (const std::uint32_t wrong : {vertices, vertices + 1, ~0U}) {
      changed.geodesics[i].vertex = wrong;
      expect_malformed(changed, "geodesics[" + std::to_string(i) + "]: vertex " + std::to_string(wrong) + " does not");
    }
  }
}

TEST(GeodesicsStructure, LettersAreSidesOfTheTileWhereTheyAre) {
  GeodesicsDocument document = spectrum({{1, 1}, {2, 2}}, {{0, 1}, {1, 1}});
  const NetDocument& net = document.net;
  const SurfaceSides sides(net.surface);
  const auto size = static_cast<std::uint32_t>(sides.partner.size());
  const auto tile_of = [&](std::uint32_t vertex) { return net.charts[net.vertices[vertex].chart].tile; };
  for (std::uint32_t here = 0; here < net.surface.tiles.size(); ++here) {
    std::uint32_t& vertex = document.geodesics[1].vertex;
    for (vertex = 0; tile_of(vertex) != here;) ++vertex;
    for (std::uint32_t side = 0; side < size; ++side) {
      const std::uint32_t partner = sides.partner[side];
      document.geodesics[1].word = {side, partner};
      EXPECT_EQ(structure_problem(document).has_value(), sides.tile[side] != here) << side;
      document.geodesics[1].word = {side};
      EXPECT_EQ(structure_problem(document).has_value(), sides.tile[side] != here || sides.tile[partner] != here);
      document.geodesics[1].word = {side, partner, side, side};
      EXPECT_EQ(structure_problem(document).has_value(), sides.tile[side] != here || sides.tile[partner] != here);
    }
    for (const std::uint32_t side : {size, size + 1, ~0U}) {
      document.geodesics[1].word = {side};
      expect_malformed(document, "geodesics[1]: side " + std::to_string(side) + " does not exist");
    }
  }
}

TEST(GeodesicsStructure, LengthsAreEnclosedByPositiveNumbers) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double none = std::nan("");
  for (const Interval length : {Interval{1, 1}, {0.5, 3}, {5e-324, 1}, {1, 1e308}}) {
    EXPECT_EQ(structure_problem(spectrum({length}, {{0, 1}})), std::nullopt);
  }
  for (const Interval length : {Interval{0, 1},
                                {-1, 1},
                                {0, 0},
                                {2, 1},
                                {std::nextafter(1, 2), 1},
                                {1, kInfinity},
                                {kInfinity, kInfinity},
                                {none, 1},
                                {1, none}}) {
    expect_malformed(spectrum({length}, {{0, 1}}), "geodesics[0]: the length ");
    expect_malformed(spectrum({{0.5, 0.5}, length}, {{0, 1}, {1, 1}}), "geodesics[1]: the length ");
  }
}

TEST(GeodesicsStructure, LowerEndsDoNotFall) {
  EXPECT_EQ(structure_problem(spectrum({{1, 3}, {1, 2}}, {{0, 2}})), std::nullopt);
  EXPECT_EQ(structure_problem(spectrum({{1, 3}, {1, 2}, {2, 2}}, {{0, 3}})), std::nullopt);
  expect_malformed(spectrum({{1, 3}, {std::nextafter(1, 0), 2}}, {{0, 2}}), "geodesics[1]: lo is less than that of");
  expect_malformed(spectrum({{1, 3}, {2, 2}, {1.5, 2}}, {{0, 3}}), "geodesics[2]: lo is less than that of");
}

TEST(GeodesicsStructure, ASystoleIsOneLengthThatIsEnclosed) {
  EXPECT_EQ(structure_problem(systole_of({{1, std::nextafter(2, 0)}})), std::nullopt);
  EXPECT_EQ(structure_problem(systole_of({{3, 3}})), std::nullopt);
  expect_malformed(systole_of({{1, 2}}), "geodesics[0]: the length is not enclosed, expected hi < 2 lo");
  expect_malformed(systole_of({{1, 5}}), "geodesics[0]: the length is not enclosed, expected hi < 2 lo");
  expect_malformed(systole_of({}), "geodesics: 0 elements, expected one, a systole");
  expect_malformed(systole_of({{1, 1}, {1, 1}}), "geodesics: 2 elements, expected one, a systole");
}

TEST(GeodesicsStructure, TheBoundOfASpectrumIsAPositiveDecimal) {
  GeodesicsDocument document = spectrum({}, {});
  for (const char* bound : {"1", "0.001", "1e-9999", "1/3"}) {
    document.up_to = bound;
    EXPECT_EQ(structure_problem(document), std::nullopt) << bound;
  }
  for (const char* bound : {"0", "-1", "-1e-9999", "0/3"}) {
    document.up_to = bound;
    expect_malformed(document, "up_to: \"" + document.up_to + "\" is not positive");
  }
  for (const char* bound : {"", "x", "1/0", "2.", " 2"}) {
    document.up_to = bound;
    expect_malformed(document, "up_to: \"" + document.up_to + "\" is not a decimal");
  }
}

TEST(GeodesicsStructure, ClustersAreTheRunsThatTheLengthsMake) {
  // The second touches the first, and the fourth the second, over the third.
  const std::vector<Interval> lengths{{1, 2}, {2, 3}, {2.5, 2.6}, {3, 3.1}, {3.5, 4}, {4.5, 5}, {4.5, 4.5}};
  const std::vector<GeodesicsDocument::Cluster> runs{{0, 4}, {4, 1}, {5, 2}};
  for (const bool equal : {false, true}) {
    std::vector<GeodesicsDocument::Cluster> rows = runs;
    for (auto& row : rows) row.equal = equal;
    EXPECT_EQ(structure_problem(spectrum(lengths, rows)), std::nullopt);
    EXPECT_EQ(structure_problem(spectrum({}, {})), std::nullopt);
  }
  const auto expect_wrong = [&](std::size_t row, const std::vector<GeodesicsDocument::Cluster>& rows) {
    expect_malformed(spectrum(lengths, rows), "clusters[" + std::to_string(row) + "]: is not the run");
  };
  for (std::size_t row = 0; row < runs.size(); ++row) {
    for (const std::uint32_t more : {1U, 4U, ~0U}) {
      auto rows = runs;
      rows[row].first += more;
      expect_wrong(row, rows);
      rows = runs;
      rows[row].count += more;
      expect_wrong(row, rows);
    }
  }
  expect_wrong(0, {});
  expect_wrong(1, {{0, 4}});
  expect_wrong(2, {{0, 4}, {4, 1}});
  expect_wrong(3, {{0, 4}, {4, 1}, {5, 2}, {7, 0}});
  expect_wrong(0, {{4, 1}, {0, 4}, {5, 2}});
  expect_malformed(spectrum({}, {{0, 0}}), "clusters[0]: is not the run that the lengths make, expected no more");
}

TEST(GeodesicsStructure, PiecesHaveEverySideOnce) {
  GeodesicsDocument document = listed(GeodesicsDocument::Claim::thick_thin, {{1, 1}, {2, 2}}, {{0, 1}, {1, 1}});
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> sides{{1, 1}, {0, 0}, {1, 0}, {0, 1}};
  document.pieces = {{0, {sides[0], sides[1]}}, {7, {}}, {1, {sides[2], sides[3]}}};
  EXPECT_EQ(structure_problem(document), std::nullopt);
  for (const std::size_t piece : {0U, 2U}) {
    for (const std::size_t i : {0U, 1U}) {
      const std::string place = "pieces[" + std::to_string(piece) + "]: side ";
      GeodesicsDocument changed = document;
      auto& boundary = changed.pieces[piece].boundaries[i];
      const auto side = boundary;
      for (const std::uint32_t geodesic : {2U, 3U, ~0U}) {
        boundary = {geodesic, side.second};
        expect_malformed(changed, place + std::to_string(side.second) + " of geodesic " + std::to_string(geodesic) +
                                      " does not exist");
      }
      for (const std::uint32_t number : {2U, 3U, ~0U}) {
        boundary = {side.first, number};
        expect_malformed(
            changed, place + std::to_string(number) + " of geodesic " + std::to_string(side.first) + " does not exist");
      }
      for (const auto& other : sides) {
        if (other == side) continue;
        boundary = other;
        expect_malformed(changed, " occurs twice");
      }
      changed = document;
      changed.pieces[piece].boundaries.erase(changed.pieces[piece].boundaries.begin() + static_cast<long>(i));
      expect_malformed(changed, "pieces: 3 of 4 sides of geodesics occur");
    }
  }
  document.pieces.clear();
  expect_malformed(document, "pieces: 0 of 4 sides of geodesics occur");
}

}  // namespace
}  // namespace epsnet::certify::geodesics_structure_test
