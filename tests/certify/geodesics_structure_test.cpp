#include "certify/document/geodesics_structure.h"

#include <functional>
#include <gtest/gtest.h>
#include <string>

#include "certify/file/reader.h"
#include "certify/geodesics/geodesics_check.h"

/// Members that a claim has or has not, and words, as docs/format.md says: each is malformed by itself.
namespace epsnet::certify {
namespace {

GeodesicsDocument three_cuffs() { return read_geodesics(EPSNET_TEST_DATA "/geodesics/three-cuffs.json"); }

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
  const Certificate certificate = check_geodesics(document, {.threads = 1});
  EXPECT_EQ(certificate.verdict, Verdict::malformed);
  EXPECT_EQ(certificate.rule, "structure");
}

TEST(GeodesicsStructure, TrueFilesHaveIt) {
  EXPECT_EQ(structure_problem(three_cuffs()), std::nullopt);
  EXPECT_EQ(structure_problem(systole()), std::nullopt);
}

TEST(GeodesicsStructure, AWordEndsInTheTileWhereItStarts) {
  GeodesicsDocument document = three_cuffs();
  document.geodesics[0].word = {1};  // To the other pair of pants.
  expect_malformed(document, "geodesics[0]: the word ends in tile 1, expected the tile where it starts, 0");
  document.geodesics[0].word = {1, 1};
  expect_malformed(document, "geodesics[0]: letter 1 of the word, 1, is no side of tile 1");
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
  expect_malformed(document, "up_to: only a spectrum has it");
}

TEST(GeodesicsStructure, OnlyAThickThinDecompositionHasPieces) {
  GeodesicsDocument document = three_cuffs();
  document.claim = GeodesicsDocument::Claim::spectrum;
  document.up_to = "1.5";
  expect_malformed(document, "pieces: only a thick-thin decomposition has them");
}

TEST(GeodesicsStructure, EverySideOfEveryGeodesicBoundsAPiece) {
  GeodesicsDocument document = three_cuffs();
  document.pieces[1].boundaries.pop_back();
  expect_malformed(document, "pieces: 5 of 6 sides of geodesics occur");
}

}  // namespace
}  // namespace epsnet::certify
