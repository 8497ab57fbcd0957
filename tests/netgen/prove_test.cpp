#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

#include "netgen/distances/distances.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/prove/certified.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet::prove_test {
namespace {

using certify::GeodesicsDocument;
using certify::Verdict;

TEST(Prove, AComputationReturnsItsDocumentWithTheCertificate) {
  const Surface surface = random_octagon(5);
  const auto [systole_document, systole_certificate] = systole(surface);
  EXPECT_EQ(systole_certificate.verdict, Verdict::verified);
  EXPECT_EQ(systole_document, unproved::systole(surface));
  const auto [bound_document, bound_certificate] = diameter(surface, {.width = 0.1});
  EXPECT_EQ(bound_certificate.verdict, Verdict::verified);
  EXPECT_EQ(bound_document, unproved::diameter(surface, {.width = 0.1}));
  const BasePoint centre = centre_of_tile(surface, TileId(0));
  EXPECT_EQ(eccentricity_net(surface, centre).document, unproved::eccentricity_net(surface, centre));
  EXPECT_EQ(distance(surface, centre, centre).document, unproved::distance(surface, centre, centre));
}

TEST(Prove, WhatIsNotVerifiedIsNotReturned) {
  GeodesicsDocument document = unproved::systole(random_octagon(5));
  document.geodesics[0].length = {1, 1.5};
  try {
    (void)proved(document);
    FAIL();
  } catch (const NotCertifiedError& error) {
    EXPECT_EQ(error.certificate().verdict, Verdict::refuted);
    EXPECT_EQ(error.what(), "not certified: " + certify::verdict_line(error.certificate()));
  }
}

TEST(Prove, TheLimitsAreThoseOfFiles) {
  const certify::CheckOptions of_files;
  const certify::CheckOptions own = own_check(3);
  EXPECT_EQ(own.max_work, of_files.max_work);
  EXPECT_EQ(own.max_visits, of_files.max_visits);
  EXPECT_EQ(own.max_triangles, of_files.max_triangles);
  EXPECT_EQ(own.max_precision, of_files.max_precision);
  EXPECT_EQ(own.threads, 3U);
}

TEST(Prove, ProgressNamesTheCertificateAndCancels) {
  struct Cancelled {};
  const GeodesicsDocument document = unproved::spectrum(random_octagon(5), Length("5"));
  std::vector<std::string> told;
  (void)proved(document, 1, [&](std::string_view what, double) { told.emplace_back(what); });
  EXPECT_THAT(told, testing::Each(testing::StartsWith("certificate: rule ")));
  EXPECT_THAT(told, testing::Contains("certificate: rule complete"));
  EXPECT_THROW((void)proved(document, 1, [](std::string_view, double) { throw Cancelled(); }), Cancelled);
}

}  // namespace
}  // namespace epsnet::prove_test
