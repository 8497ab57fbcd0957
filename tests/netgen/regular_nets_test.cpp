#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "netgen/nets/certified_net.h"

/// Nets of the regular 4g-gons, whose first triangulations are full of ties.
namespace epsnet::regular_nets_test {
namespace {

void expect_net(std::uint32_t genus, const char* epsilon) {
  SCOPED_TRACE("genus " + std::to_string(genus) + ", epsilon " + epsilon);
  const CertifiedNet net = certified_net(Surface::regular(genus), Length(epsilon));
  EXPECT_EQ(net.certificate.verdict, certify::Verdict::verified);
  EXPECT_EQ(net.certificate.counts.genus, genus);
  // Theorem III.2 of the thesis; what refinement gives is 2.2 times as many.
  const double least = (genus - 1.0) / std::pow(std::sinh(std::stod(epsilon) / 2), 2);
  EXPECT_GE(static_cast<double>(net.document.vertices.size()), least);
  EXPECT_LE(static_cast<double>(net.document.vertices.size()), 3 * least);
}

TEST(RegularNets, AreVerifiedForEveryGenusUpTo20) {
  for (std::uint32_t genus = 2; genus <= 20; ++genus) {
    for (const char* epsilon : {"0.5", "0.25", "0.1"}) expect_net(genus, epsilon);
  }
}

TEST(RegularNets, AreVerifiedForGenus100) { expect_net(100, "0.5"); }

TEST(RegularNets, AllDiagonalsAreTiesWithOneVertex) {
  const CertifiedNet net = certified_net(Surface::regular(1000), Length("20"));
  EXPECT_EQ(net.document.vertices.size(), 1U);
  EXPECT_EQ(net.certificate.counts.exact_ties, 3997U) << "all diagonals of the dual polygon";
}

}  // namespace
}  // namespace epsnet::regular_nets_test
