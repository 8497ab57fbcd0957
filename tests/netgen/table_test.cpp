#include <gtest/gtest.h>

#include "epsnet/netgen/certified_net.h"
#include "epsnet/netgen/domain_format.h"
#include "epsnet/netgen/octagon.h"

namespace epsnet {
namespace {

/// Thesis Table IV.3 as the thesis has it: the mean number of vertices over 180 octagons.
void expect_mean(const char* epsilon, double thesis, double tolerance) {
  constexpr std::int32_t kOctagons = 180;
  double vertices = 0;
  for (std::int32_t seed = 1; seed <= kOctagons; ++seed) {
    vertices += static_cast<double>(compute_net(random_octagon(seed), Epsilon(epsilon)).net.vertices.size());
  }
  std::cout << "epsilon " << epsilon << ": " << vertices / kOctagons << " vertices, thesis " << thesis << '\n';
  EXPECT_NEAR(vertices / kOctagons, thesis, tolerance * thesis);
}

TEST(TableIV3, EpsilonFourTenths) { expect_mean("0.4", 54, 0.02); }
TEST(TableIV3, EpsilonThreeTenths) { expect_mean("0.3", 96, 0.02); }
TEST(TableIV3, EpsilonOneFifth) { expect_mean("0.2", 216, 0.01); }
TEST(TableIV3, EpsilonOneTenth) { expect_mean("0.1", 865, 0.01); }
TEST(TableIV3, EpsilonOneTwentieth) { expect_mean("0.05", 3454, 0.01); }
TEST(TableIV3, EpsilonOneHundredth) { expect_mean("0.01", 86314, 0.01); }

TEST(LargeGenus, IsVerified) {
  for (const char* name : {"g20-rnd0", "g50-small"}) {
    const Surface surface = load_domain(std::string(EPSNET_TEST_DATA) + "/polygons/polygon-" + name + ".txt");
    for (const char* epsilon : {"3", "0.5", "0.2"}) {
      EXPECT_EQ(certified_net(surface, Epsilon(epsilon)).certificate.verdict, certify::Verdict::verified) << name;
    }
  }
}

}  // namespace
}  // namespace epsnet
