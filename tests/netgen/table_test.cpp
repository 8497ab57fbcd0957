#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

#include "certify/check.h"
#include "netgen/exchange/text_formats.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/support/polygons.h"

namespace epsnet::table_test {
namespace {

/// Thesis Table IV.3 as the thesis has it: the mean number of vertices over 180 octagons.
void expect_mean(const char* epsilon, double thesis, double tolerance) {
  constexpr std::int32_t kOctagons = 180;
  double vertices = 0;
  for (std::int32_t seed = 1; seed <= kOctagons; ++seed) {
    vertices += static_cast<double>(compute_net(random_octagon(seed), Length(epsilon)).document.vertices.size());
  }
  std::cout << "epsilon " << epsilon << ": " << vertices / kOctagons << " vertices, thesis " << thesis << '\n';
  EXPECT_NEAR(vertices / kOctagons, thesis, tolerance * thesis);
}

TEST(DeepTableIV3, EpsilonFourTenths) { expect_mean("0.4", 54, 0.02); }
TEST(DeepTableIV3, EpsilonThreeTenths) { expect_mean("0.3", 96, 0.02); }
TEST(DeepTableIV3, EpsilonOneFifth) { expect_mean("0.2", 216, 0.01); }
TEST(DeepTableIV3, EpsilonOneTenth) { expect_mean("0.1", 865, 0.01); }
TEST(DeepTableIV3, EpsilonOneTwentieth) { expect_mean("0.05", 3454, 0.01); }
TEST(DeepTableIV3, EpsilonOneHundredth) { expect_mean("0.01", 86314, 0.01); }

/// The 180 octagons of the thesis' generator are expected to have long systoles (thesis IV.6.2: 173 of its 180 have
/// more than 0.5, the others more than 0.21, by bounds). Of these 180, with a proof for each.
TEST(DeepSystoles, Of179Of180OctagonsAreAboveOneHalf) {
  int above_half = 0;
  double least = HUGE_VAL;
  for (std::int32_t seed = 1; seed <= 180; ++seed) {
    const certify::GeodesicsDocument document = unproved::systole(random_octagon(seed));
    ASSERT_EQ(certify::check(document).verdict, certify::Verdict::verified) << "seed " << seed;
    above_half += document.geodesics[0].length.lower > 0.5 ? 1 : 0;
    least = std::min(least, document.geodesics[0].length.lower);
  }
  std::cout << above_half << " of 180 octagons have a systole above 0.5; the least is " << least << '\n';
  EXPECT_EQ(above_half, 179);
  EXPECT_NEAR(least, 0.35945670306318783, 1e-15);
}

/// Thesis Table IV.4: one surface of genus 2 with a cuff of length 1e-4. Here the mean over twenty, proved, also where
/// the thesis' doubles fail (0.2 and 0.1: the model 0.5383(16/ε² + w/ε), w the width of the collar).
TEST(DeepTableIV4, MeansOfThinSurfacesAgreeWithTheThesis) {
  const std::vector<std::pair<const char*, double>> table{{"0.5", 58},  {"0.45", 64},  {"0.4", 75},  {"0.35", 108},
                                                          {"0.3", 137}, {"0.25", 179}, {"0.2", 260}, {"0.1", 943.1}};
  for (const auto& [epsilon, thesis] : table) {
    double mean = 0;
    constexpr std::uint64_t kSurfaces = 20;
    for (std::uint64_t seed = 1; seed <= kSurfaces; ++seed) {
      FenchelNielsen coordinates = random_coordinates(PantsGraph::ring(2), seed);
      coordinates.lengths[0] = Rational(1, 10'000);
      coordinates.twists[0] = 0;
      const CertifiedNet net = certified_net(fenchel_nielsen_surface(coordinates), Length(epsilon));
      mean += static_cast<double>(net.document.vertices.size()) / kSurfaces;
    }
    std::cout << "epsilon " << epsilon << ": " << mean << " vertices, thesis or model " << thesis << '\n';
    EXPECT_NEAR(mean, thesis, 0.06 * thesis);
  }
}

/// Thesis Table IV.5: means over three surfaces of genus 3.
TEST(DeepTableIV5, MeansOfGenus3AgreeWithTheThesis) {
  const std::vector<std::pair<const char*, double>> table{
      {"0.5", 70}, {"0.4", 108}, {"0.3", 193}, {"0.2", 428}, {"0.1", 1727}};
  for (const auto& [epsilon, thesis] : table) {
    double mean = 0;
    constexpr std::uint64_t kSurfaces = 50;
    for (std::uint64_t seed = 1; seed <= kSurfaces; ++seed) {
      const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::random(3, seed), seed));
      mean += static_cast<double>(compute_net(surface, Length(epsilon)).document.vertices.size()) / kSurfaces;
    }
    std::cout << "epsilon " << epsilon << ": " << mean << " vertices, thesis " << thesis << '\n';
    EXPECT_NEAR(mean, thesis, 0.03 * thesis);
  }
}

TEST(DeepLargeGenus, FenchelNielsenSurfacesAreVerified) {
  for (const auto& [genus, epsilon] : {std::pair{30u, "0.5"}, {100u, "0.25"}, {300u, "0.5"}}) {
    const Surface surface = fenchel_nielsen_surface(random_coordinates(PantsGraph::random(genus, 1), 1));
    EXPECT_EQ(certified_net(surface, Length(epsilon)).certificate.counts.genus, genus);
  }
}

TEST(DeepLargeGenus, PolygonsAreVerified) {
  for (const char* name : {"g20-rnd0", "g50-small"}) {
    const Surface surface = test::imported(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-" + name + ".txt");
    for (const char* epsilon : {"3", "0.5", "0.2"}) {
      EXPECT_EQ(certified_net(surface, Length(epsilon)).certificate.verdict, certify::Verdict::verified) << name;
    }
  }
}

}  // namespace
}  // namespace epsnet::table_test
