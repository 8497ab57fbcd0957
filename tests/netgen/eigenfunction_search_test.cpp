#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/file/reader.h"
#include "netgen/eigenvalues/eigenfunction.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/octagon.h"

/// Approximate eigenfunctions are found in dense matrices, which takes seconds for each.
namespace epsnet::eigenfunction_search_test {
namespace {

using certify::EigenvaluesDocument;

EigenvaluesDocument file(const char* name) {
  return certify::read_file<EigenvaluesDocument>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/" + name);
}

TEST(DeepEigenfunctionSearch, FindsTheNearestEigenvalue) {
  const EigenvaluesDocument document = file("octagon-5-to-8.json");
  const EigenfunctionSearch search(document, 2);
  // Of the octagon of seed 5: λ_1 is in [2.77505, 2.77509], and λ_2 in [3.639, 4.029].
  for (const auto& [guess, lower, upper] :
       {std::tuple{2.76, 2.77505, 2.77509}, {2.8, 2.77505, 2.77509}, {3.7, 3.639, 4.029}}) {
    const auto function = search.near(guess);
    ASSERT_TRUE(function) << guess;
    EXPECT_GT(function->in.lower, lower);
    EXPECT_LT(function->in.upper, upper);
    EXPECT_LT(function->in.upper - function->in.lower, 5e-9);
    EXPECT_LT(function->in.lower, function->lambda);
    EXPECT_LT(function->lambda, function->in.upper);
  }
}

/// λ_1 and λ_4 of the Bolza surface (A. Strohmaier, V. Uski).
TEST(DeepEigenfunctionSearch, AgreesWithTheLiterature) {
  const EigenvaluesDocument document = file("bolza-to-9.json");
  const EigenfunctionSearch search(document, 2);
  for (const auto& [known, width] : {std::pair{3.8388872588421995, 1e-8}, {5.353601341189, 2e-8}}) {
    const auto function = search.near(known + 0.01);
    ASSERT_TRUE(function);
    EXPECT_LT(function->in.lower, known);
    EXPECT_LT(known, function->in.upper);
    EXPECT_LT(function->in.upper - function->in.lower, width);
    EXPECT_NEAR(function->lambda, known, 1e-11);
  }
}

/// Of the same authors; of the multiplicities four, three and three. Between many waves, steps lead astray.
TEST(DeepEigenfunctionSearch, FindsGreaterEigenvalues) {
  const EigenvaluesDocument document = file("bolza-to-9.json");
  const EigenfunctionSearch search(document, 2);
  for (const double known : {14.726216787789, 15.048916133267, 18.658819627260}) {
    const auto function = search.near(known - 0.002);
    ASSERT_TRUE(function) << known;
    EXPECT_LT(function->in.lower, known);
    EXPECT_LT(known, function->in.upper);
    EXPECT_LT(function->in.upper - function->in.lower, 1e-6);
  }
}

/// What proves an eigenvalue only as roughly as the trace formula does is of no use.
TEST(DeepEigenfunctionSearch, LeavesRoughFunctionsOut) {
  const EigenvaluesDocument document = file("bolza-to-9.json");
  const EigenfunctionSearch search(document, 2);
  for (const double guess : {10.0, 12.0, 30.0, 50.0}) {
    const auto function = search.near(guess);
    EXPECT_TRUE(!function || function->in.upper - function->in.lower < 2.1e-3) << guess;
  }
}

/// Counted by the trace formula, enclosed by eigenfunctions.
TEST(DeepEigenvalues, ThatAreCountedAreEnclosedToNineDigits) {
  for (const Surface& surface : {random_octagon(3), Surface::regular(2),
                                 fenchel_nielsen_surface(random_coordinates(PantsGraph::random(3, 1), 1))}) {
    const EigenvaluesDocument document = eigenvalues(surface, {.up_to = Length("9"), .count = 1});
    EXPECT_EQ(certify::check(document, {.threads = 2}).verdict, certify::Verdict::verified) << surface.genus();
    const auto& first = document.windows.front();
    ASSERT_EQ(first.least, first.most);
    EXPECT_LT(std::abs(first.smallest.upper - first.greatest.lower), 1e-8) << first.most;
  }
}

/// A curve that separates becomes short. The constant functions, of the eigenvalue 0, are near.
TEST(DeepEigenvalues, ThatAreSmallAreEnclosedToo) {
  FenchelNielsenRequest request;
  request.graph = "0-0 0-1 1-1";
  request.lengths = {"2", "1/16", "2"};
  request.twists = {"0.3", "0", "0.7"};
  const Surface surface = fenchel_nielsen_surface(resolve(request));
  const EigenvaluesDocument document = eigenvalues(surface, {.up_to = Length("10"), .count = 1});
  EXPECT_EQ(certify::check(document, {.threads = 2}).verdict, certify::Verdict::verified);
  const auto& first = document.windows.front();
  EXPECT_EQ(first.most, 1U);
  EXPECT_LT(first.smallest.upper, 0.007);
  EXPECT_LT(first.smallest.upper - first.greatest.lower, 1e-7);
}

/// The trace formula alone proves one eigenvalue from so few geodesics.
TEST(DeepEigenvalues, FunctionsShowTheGapsBetweenThem) {
  const EigenvaluesDocument document = eigenvalues(random_octagon(5), {.up_to = Length("8")});
  EXPECT_EQ(certify::check(document, {.threads = 2}).verdict, certify::Verdict::verified);
  ASSERT_GE(document.windows.size(), 4U);
  double last = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& window = document.windows[i];
    EXPECT_EQ(window.least, 1U) << i;
    EXPECT_EQ(window.most, 1U) << i;
    EXPECT_LT(window.in.upper - window.in.lower, 1e-8) << i;
    EXPECT_GT(window.in.lower, last + 0.1) << i;
    last = window.in.upper;
  }
}

TEST(DeepEigenvalues, TheFirstTenAreSimple) {
  const EigenvaluesDocument document = eigenvalues(random_octagon(5), {.up_to = Length("10"), .count = 10});
  EXPECT_EQ(certify::check(document, {.threads = 2}).verdict, certify::Verdict::verified);
  ASSERT_GE(document.windows.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    const auto& window = document.windows[i];
    EXPECT_EQ(window.least, 1U) << i;
    EXPECT_EQ(window.most, 1U) << i;
    EXPECT_LT(window.smallest.upper - window.greatest.lower, 1e-6) << i;
  }
}

TEST(DeepEigenfunctionSearch, GuessesAreNearEigenvalues) {
  const EigenvaluesDocument document = file("octagon-5-to-8.json");
  const EigenfunctionSearch search(document, 2);
  const std::vector<double> guesses = search.around(2.8);
  ASSERT_FALSE(guesses.empty());
  EXPECT_NEAR(guesses.front(), 2.775068, 1e-3);
  for (std::size_t i = 1; i < guesses.size(); ++i)
    EXPECT_LE(std::abs(guesses[i - 1] - 2.8), std::abs(guesses[i] - 2.8));
}

TEST(DeepEigenvalues, WithEigenfunctionsAreTheSameForAnyNumberOfThreads) {
  const Surface surface = random_octagon(2);
  EXPECT_EQ(eigenvalues(surface, {.up_to = Length("7"), .count = 1, .threads = 1}),
            eigenvalues(surface, {.up_to = Length("7"), .count = 1, .threads = 3}));
}

}  // namespace
}  // namespace epsnet::eigenfunction_search_test
