#include "netgen/eigenvalues/eigenvalues.h"

#include <cmath>
#include <complex>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "certify/check.h"
#include "certify/claims/eigenvalues/test_function.h"
#include "certify/claims/eigenvalues/trace_forms.h"
#include "certify/file/reader.h"
#include "certify/numbers/precision.h"
#include "netgen/eigenvalues/eigenfunction.h"
#include "netgen/eigenvalues/prover.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/pictures/pictures.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/maps_and_covers.h"
#include "netgen/surfaces/octagon.h"
#include "netgen/surfaces/surface_file.h"

/// The generator's side of eigenvalues. `certify` shares no code with it, so agreement with it is a test of both.
namespace epsnet::eigenvalues_test {
namespace {

using certify::EigenvaluesDocument;
using certify::Interval;
using testing::HasSubstr;

/// λ_1, of multiplicity 3, and λ_4, of multiplicity 4, of the Bolza surface (A. Strohmaier, V. Uski).
constexpr double kFirst = 3.8388872588421995;
constexpr double kFourth = 5.353601341189;

EigenvaluesDocument file(const char* name) {
  return certify::read_file<EigenvaluesDocument>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/" + name);
}
EigenvaluesDocument octagon() { return file("octagon-5-to-8.json"); }
EigenvaluesDocument bolza() { return file("bolza-to-9.json"); }

TestSpace space_of(const EigenvaluesDocument& document) {
  return {static_cast<Real>(Length(document.up_to).value()), document.order, document.degree};
}

std::vector<RealMatrix> matrices_of(const EigenvaluesDocument& document) {
  const Surface surface = from_document(document.net.surface);
  return trace_matrices(space_of(document), surface.genus(), lengths_of(surface, document));
}

Prover prover_of(const EigenvaluesDocument& document) { return {space_of(document), matrices_of(document)}; }

RealVector random_vector(std::size_t size, std::uint32_t seed) {
  std::mt19937 generator(seed);
  RealVector result;
  for (std::size_t i = 0; i < size; ++i) result.emplace_back(static_cast<double>(generator() % 2001) / 1000 - 1);
  return result;
}

Real form(const RealMatrix& matrix, const RealVector& c) {
  Real result = 0;
  for (std::size_t j = 0; j < c.size(); ++j) result += c[j] * dot(matrix[j], c);
  return result;
}

Real square(const TestSpace& space, const RealVector& c, double lambda) {
  const Real value = dot(c, space.values(Real(lambda)));
  return value * value;
}

RealVector exactly(const std::vector<double>& c) { return {c.begin(), c.end()}; }

bool is_verified(const EigenvaluesDocument& document) {
  return certify::check(document, {.threads = 2}).verdict == certify::Verdict::verified;
}

TEST(Solver, SolvesWhatItFactored) {
  constexpr std::size_t kSize = 9;
  RealMatrix matrix;
  for (std::uint32_t i = 0; i < kSize; ++i) matrix.push_back(random_vector(kSize, i));
  matrix[0][0] = 0;  // Rows must be exchanged.
  const RealVector right = random_vector(kSize, 77);
  const auto solver = Solver::of(matrix);
  ASSERT_TRUE(solver);
  const RealVector x = solver->solve(right);
  for (std::size_t i = 0; i < kSize; ++i)
    EXPECT_LT(std::abs(static_cast<double>(Real(dot(matrix[i], x) - right[i]))), 1e-70);
  matrix[3] = matrix[5];
  for (Real& entry : matrix[3]) entry *= 2;
  EXPECT_FALSE(Solver::of(matrix));
}

TEST(TestSpace, ValuesAreThoseOfItsFunctions) {
  const TestSpace space{Real(7), 8, 5};
  const double step = 7.0 / 14;
  EXPECT_EQ(static_cast<double>(space.step()), step);
  for (const double lambda : {0.0, 0.1, 0.25, 0.3, 2.0, 30.0}) {
    const RealVector values = space.values(Real(lambda));
    ASSERT_EQ(values.size(), 6U);
    const std::complex<double> r = std::sqrt(std::complex<double>(lambda - 0.25));
    const std::complex<double> x = step * r / 2.0;
    const std::complex<double> sinc = x == 0.0 ? 1.0 : std::sin(x) / x;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double expected = (std::pow(sinc, 4) * std::cos(static_cast<double>(k) * step * r)).real();
      EXPECT_NEAR(static_cast<double>(values[k]), expected, 1e-13) << lambda << ' ' << k;
    }
  }
}

TEST(TraceMatrices, LengthsAreThoseOfTheFile) {
  const EigenvaluesDocument document = octagon();
  const RealVector lengths = lengths_of(from_document(document.net.surface), document);
  ASSERT_EQ(lengths.size(), document.geodesics.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    EXPECT_LE(document.geodesics[i].length.lower, lengths[i]);
    EXPECT_GE(document.geodesics[i].length.upper, lengths[i]);
  }
}

TEST(TraceMatrices, AreTheFormsThatTheCheckerComputes) {
  const certify::Precision scope(256);
  for (const EigenvaluesDocument& document : {octagon(), bolza()}) {
    const Surface surface = from_document(document.net.surface);
    const std::vector<RealMatrix> matrices = matrices_of(document);
    ASSERT_EQ(matrices.size(), 3U);
    std::vector<certify::Ball> lengths;
    for (const Real& length : lengths_of(surface, document)) {
      // As two doubles: 2⁻¹⁰⁰ of the length.
      const auto first = static_cast<double>(length);
      lengths.push_back(certify::Ball::exactly(first) +
                        certify::Ball::exactly(static_cast<double>(Real(length - first))));
    }
    const auto forms = certify::TraceForms::of({mpq_class(document.up_to), document.order, document.degree},
                                               surface.genus(), lengths, certify::Budget());
    ASSERT_TRUE(forms);
    const RealVector c = random_vector(document.degree + 1, document.order);
    std::vector<double> rounded;
    for (const Real& x : c) rounded.push_back(static_cast<double>(x));
    const auto sums = (*forms)(rounded);
    for (std::size_t p = 0; p < 3; ++p) {
      const auto value = static_cast<double>(form(matrices[p], c));
      EXPECT_NEAR(certify::outer_interval(sums[p]).lower / value, 1, 1e-14) << p;
    }
  }
}

TEST(TraceMatrices, AreLinearInTheLengthsAndTheGenus) {
  const TestSpace space{Real(6), 8, 6};
  const RealVector c = random_vector(7, 3);
  const auto forms = [&](std::uint32_t genus, const RealVector& lengths) {
    std::vector<Real> result;
    for (const RealMatrix& matrix : trace_matrices(space, genus, lengths)) result.push_back(form(matrix, c));
    return result;
  };
  const auto both = forms(4, {Real(2), Real(5)});
  const auto one = forms(3, {Real(2)});
  const auto other = forms(3, {Real(5)});
  const auto none = forms(2, {});
  for (std::size_t p = 0; p < 3; ++p)
    EXPECT_NEAR(static_cast<double>(Real((one[p] + other[p] - none[p]) / both[p])), 1, 1e-60) << p;
}

/// All eigenvalues contribute, those that are known among them.
TEST(TraceMatrices, SumsAreMoreThanThoseOverSomeEigenvalues) {
  const EigenvaluesDocument document = bolza();
  const TestSpace space = space_of(document);
  const std::vector<RealMatrix> matrices = matrices_of(document);
  const auto known = [&](const RealVector& c, unsigned p) {
    return Real(3 * pow(Real(kFirst), p) * square(space, c, kFirst) +
                4 * pow(Real(kFourth), p) * square(space, c, kFourth));
  };
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const RealVector c = random_vector(document.degree + 1, seed);
    for (unsigned p = 0; p < 3; ++p) EXPECT_GT(form(matrices[p], c), known(c, p)) << seed << ' ' << p;
  }
  // And not by much for a function that is large at one of them alone.
  const RealVector best = exactly(prover_of(document).best_at(kFirst, {kFirst, kFirst}).coefficients);
  for (unsigned p = 0; p < 3; ++p) {
    const auto ratio = static_cast<double>(Real(form(matrices[p], best) / known(best, p)));
    EXPECT_GT(ratio, 1) << p;
    EXPECT_LT(ratio, 1 + 1e-2 * std::pow(10, p)) << p;
  }
}

TEST(Prover, TheBoundIsTheLeastSumOfSquares) {
  const EigenvaluesDocument document = octagon();
  Prover prover = prover_of(document);
  const std::vector<RealMatrix> matrices = matrices_of(document);
  for (const double lambda : {0.0, 0.25, 1.5, 2.8, 4.0}) {
    const Real least = prover.most_at(lambda);
    const Trial best = prover.best_at(lambda, {lambda, lambda});
    const RealVector c = exactly(best.coefficients);
    for (std::size_t p = 0; p < 3; ++p)
      EXPECT_NEAR(static_cast<double>(Real(best.sums[p] / form(matrices[p], c))), 1, 1e-12);
    EXPECT_NEAR(static_cast<double>(Real(best.sums[0] / square(prover.space(), c, lambda) / least)), 1, 1e-9) << lambda;
    for (std::uint32_t seed = 0; seed < 5; ++seed) {
      RealVector other = random_vector(c.size(), seed);
      for (std::size_t k = 0; k < c.size(); ++k) other[k] = c[k] + other[k] * 1e-9;
      EXPECT_GE(form(matrices[0], other) / square(prover.space(), other, lambda), least * (1 - 1e-12)) << lambda;
    }
  }
}

TEST(Prover, TheBoundIsAboutTheNumberAtAnEigenvalue) {
  const Prover prover = prover_of(bolza());
  EXPECT_NEAR(prover.most_at(kFirst), 3, 1e-2);
  EXPECT_GE(prover.most_at(kFirst), 3);
  EXPECT_NEAR(prover.most_at(kFourth), 4, 1e-1);
  EXPECT_GE(prover.most_at(kFourth), 4);
  EXPECT_LT(prover.most_at(4.5), 0.1);
}

TEST(Prover, AFlatFunctionHasOneValueAtAllPoints) {
  Prover prover = prover_of(octagon());
  const std::vector<double> points{2.76, 2.8, 2.86};
  const auto flat = prover.flat_on(points, {2.76, 2.86});
  ASSERT_TRUE(flat);
  const RealVector c = exactly(flat->coefficients);
  const Real first = square(prover.space(), c, points[0]);
  for (const double x : points) {
    EXPECT_NEAR(static_cast<double>(Real(square(prover.space(), c, x) / first)), 1, 1e-9) << x;
    EXPECT_GE(static_cast<double>(Real(flat->sums[0] / first)), prover.most_at(x) * (1 - 1e-9)) << x;
  }
  EXPECT_FALSE(prover.flat_on({2.8, 2.8}, {2.8, 2.8}));
}

/// The least and the greatest of many values.
std::pair<double, double> sampled(Interval in, const std::function<double(double)>& function) {
  std::pair<double, double> result{HUGE_VAL, -HUGE_VAL};
  for (int i = 0; i <= 4000; ++i) {
    const double value = function(in.lower + (in.upper - in.lower) * i / 4000);
    result = {std::min(result.first, value), std::max(result.second, value)};
  }
  return result;
}

TEST(Prover, NumbersAreQuotientsOfSumsAndExtremeValues) {
  const EigenvaluesDocument document = octagon();
  Prover prover = prover_of(document);
  for (const Interval in : {Interval{0, 1}, {2.5, 3.5}, {2.7, 2.9}, {4, 4.5}}) {
    const Trial trial = prover.best_at((in.lower + in.upper) / 2, in);
    const RealVector c = exactly(trial.coefficients);
    const auto value = [&](double x) { return static_cast<double>(square(prover.space(), c, x)); };
    const double most = static_cast<double>(trial.sums[0]) / sampled(in, value).first;
    EXPECT_EQ(prover.most_in(trial, in), std::floor(most)) << in.lower;
    for (const double sigma : {0.0, in.lower / 2}) {
      const Prover::Weighted weighted(prover, {sigma, in.upper + 0.5});
      const auto weight = [&](double x) { return (in.upper + 0.5 - x) * (sigma == 0 ? 1 : x - sigma); };
      EXPECT_NEAR(static_cast<double>(weighted.weight(Real(in.lower))), weight(in.lower), 1e-12);
      const auto best = weighted.best_at(in.upper);
      ASSERT_TRUE(best);
      const RealVector d = exactly(best->coefficients);
      // Σ P f̂² by P's coefficients.
      const double rho = in.upper + 0.5;
      const Real sum = sigma == 0 ? Real(rho * best->sums[0] - best->sums[1])
                                  : Real((rho + sigma) * best->sums[1] - best->sums[2] - rho * sigma * best->sums[0]);
      EXPECT_NEAR(static_cast<double>(Real(weighted.sum(*best) / sum)), 1, 1e-12);
      const double greatest =
          sampled(in, [&](double x) { return weight(x) * static_cast<double>(square(prover.space(), d, x)); }).second;
      const double least = sum <= 0 ? 0 : std::ceil(static_cast<double>(sum) / greatest);
      EXPECT_EQ(prover.least_in(weighted, *best, in), least) << in.lower << ' ' << sigma;
    }
  }
}

/// Statements are made so near to their bounds that the ball of `certify` must not contain less; around a zero of the
/// test function it contains numbers less than 0.
TEST(Prover, KnownEigenvaluesAddWhatTheCheckerComputes) {
  const EigenvaluesDocument document = octagon();
  std::vector<Interval> known{{0.006, 0.006 + 1e-9}};
  for (int i = 0; i < 200; ++i) known.push_back({0.5 + 0.02 * i, 0.5 + 0.02 * i + 1e-3});
  Prover prover(space_of(document), matrices_of(document), known);
  const certify::TestFunctions functions = certify::test_functions(document);
  const certify::Precision precision(256);
  int negative = 0;
  for (const double place : {0.01, 1.0, 2.7, 4.0}) {
    const Trial trial = prover.best_at(place, {place, place});
    const certify::SquaredTestFunction square(functions, trial.coefficients);
    ASSERT_EQ(trial.known.size(), known.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      const Interval ball = certify::outer_interval(square.on(known[i]));
      const auto expected = static_cast<double>(trial.known[i]);
      EXPECT_LE(expected, ball.lower) << place << ' ' << i;
      EXPECT_GE(expected, ball.lower - 1e-2 * (ball.upper - ball.lower) - 1e-4 * ball.upper) << place << ' ' << i;
      if (ball.lower < 0) ++negative;
    }
  }
  EXPECT_GT(negative, 0);
}

/// A statement about an interval leaves out the known eigenvalues that are not there, so its test function need not be
/// small at these, and at no others.
TEST(Prover, OnlyKnownEigenvaluesOutsideOfTheIntervalAreLeftOut) {
  const EigenvaluesDocument document = octagon();
  const std::vector<Interval> known{{2.775, 2.775 + 1e-9}, {3.706, 3.706 + 1e-9}, {4.09, 4.09 + 1e-9}};
  Prover prover(space_of(document), matrices_of(document), known);
  const auto bound = [&](const Trial& trial, Interval in, double lambda) {
    Real sum = trial.sums[0];
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (known[i].upper < in.lower || in.upper < known[i].lower) sum -= trial.known[i];
    }
    return static_cast<double>(Real(sum / square(prover.space(), exactly(trial.coefficients), lambda)));
  };
  const Interval in{3.6, 3.8};
  const std::vector<Interval> others{{3.8, 3.8}, {2.7, 3.8}, {3.6, 4.2}, {2.7, 4.2}};
  for (const double lambda : {3.62, 3.7, 3.78}) {
    const double least = bound(prover.best_at(lambda, in), in, lambda);
    for (const Interval other : others) EXPECT_LE(least, bound(prover.best_at(lambda, other), in, lambda) * (1 + 1e-3));
  }
}

TEST(Prover, ARitzValueIsAboveAnEigenvalueAndNear) {
  const Prover prover = prover_of(bolza());
  for (const auto& [sigma, eigenvalue] : {std::pair{0.0, kFirst}, {4.5, kFourth}}) {
    const auto found = prover.first_behind(sigma, eigenvalue + 0.01);
    ASSERT_TRUE(found);
    EXPECT_GT(found->second, eigenvalue);
    EXPECT_LT(found->second, eigenvalue + 0.05);
    const Prover::Weighted at(prover, {sigma, found->second * (1 + 1e-9)});
    const Prover::Weighted below(prover, {sigma, found->second * (1 - 1e-9)});
    EXPECT_GT(at.sum(found->first), 0);
    EXPECT_LT(below.sum(found->first), 0);
  }
}

// The search.

/// By the trace formula alone.
EigenvaluesOptions up_to(const char* length) { return {.up_to = Length(length), .eigenfunctions = false}; }

Surface with_cuff(const char* length) {
  FenchelNielsenRequest request;
  request.graph = "0-0 0-1 1-1";
  request.lengths = {"2", length, "2"};
  request.twists = {"0.3", "0", "0.7"};
  return fenchel_nielsen_surface(resolve(request));
}

Surface of_genus(std::uint32_t genus) {
  FenchelNielsenRequest request;
  request.genus = genus;
  request.seed = 1;
  return fenchel_nielsen_surface(resolve(request));
}

/// Where the eigenvalues of a window are that are counted.
Interval enclosure(const EigenvaluesDocument::Window& window) {
  return window.most == 1 ? Interval{window.greatest.lower, window.smallest.upper} : window.in;
}

TEST(Eigenvalues, OfManySurfacesAreVerified) {
  const Surface octagon = random_octagon(5);
  for (const Surface& surface : {octagon, Surface::regular(2), of_genus(3), of_genus(6), with_cuff("0.01"),
                                 cover(octagon, random_sheets(octagon, 3, 1))}) {
    const EigenvaluesDocument document = eigenvalues(surface, up_to("6"));
    EXPECT_TRUE(is_verified(document)) << surface.genus();
    ASSERT_FALSE(document.windows.empty());
    EXPECT_GT(document.windows.front().least, 0U);
    EXPECT_LE(document.windows.back().in.upper, document.eigenvalues_up_to);
  }
}

TEST(Eigenvalues, AreTheSameForAnyNumberOfThreads) {
  const Surface surface = random_octagon(2);
  EigenvaluesOptions one = up_to("7");
  one.threads = 1;
  EigenvaluesOptions three = up_to("7");
  three.threads = 3;
  EXPECT_EQ(eigenvalues(surface, one), eigenvalues(surface, three));
}

TEST(Eigenvalues, GreaterLengthsEncloseThemInLess) {
  const Surface surface = random_octagon(5);
  Interval last{0, HUGE_VAL};
  for (const char* length : {"7", "8", "9", "10"}) {
    const EigenvaluesDocument document = eigenvalues(surface, up_to(length));
    ASSERT_EQ(document.windows.front().most, 1U) << length;
    const Interval here = enclosure(document.windows.front());
    EXPECT_GT(here.lower, last.lower) << length;
    EXPECT_LT(here.upper, last.upper) << length;
    last = here;
  }
  EXPECT_LT(last.upper - last.lower, 0.03);
}

TEST(Eigenvalues, StopWhereSoManyAreFound) {
  EigenvaluesOptions options = up_to("9");
  options.count = 4;
  const EigenvaluesDocument document = eigenvalues(Surface::regular(2), options);
  ASSERT_EQ(document.windows.size(), 2U);
  EXPECT_EQ(document.windows[0].most, 3U);
  EXPECT_EQ(document.windows[1].most, 4U);
  EXPECT_LE(document.windows[0].in.lower, kFirst);
  EXPECT_GE(document.windows[0].in.upper, kFirst);
  EXPECT_LE(document.windows[1].in.lower, kFourth);
  EXPECT_GE(document.windows[1].in.upper, kFourth);
}

/// A pinched cuff that separates: one eigenvalue near 0, in a window from 0 on if L is too small to tell it from 0.
TEST(Eigenvalues, NearZeroAreInAWindowFromZeroOn) {
  const EigenvaluesDocument document = eigenvalues(with_cuff("0.03"), up_to("8"));
  EXPECT_TRUE(is_verified(document));
  const EigenvaluesDocument::Window& first = document.windows.front();
  EXPECT_EQ(first.in.lower, 0);
  EXPECT_EQ(first.least, 1U);
  EXPECT_LT(enclosure(first).upper, 0.25);
}

/// Rounding led out of the gap between the first two windows.
TEST(Eigenvalues, WeightsVanishInGaps) { EXPECT_TRUE(is_verified(eigenvalues(with_cuff("0.75"), up_to("10.5")))); }

TEST(Eigenvalues, FewGeodesicsStillBoundTheFirstOne) {
  const EigenvaluesDocument document = eigenvalues(random_octagon(5), up_to("1"));
  EXPECT_TRUE(document.geodesics.empty());
  EXPECT_TRUE(is_verified(document));
  ASSERT_EQ(document.windows.size(), 1U);
  EXPECT_EQ(document.windows[0].in.lower, 0);
  EXPECT_GT(document.windows[0].in.upper, 2.7);
  EXPECT_LT(document.windows[0].least, document.windows[0].most);
}

TEST(Eigenvalues, TheLengthThatIsNeededIsAboutWhatCountsThem) {
  for (const Surface& surface : {random_octagon(5), of_genus(4)}) {
    const EigenvaluesDocument few = eigenvalues(surface, up_to("5"));
    const auto needed = length_to_count_first(few);
    ASSERT_TRUE(needed);
    EXPECT_GE(*needed, 6);
    EXPECT_LE(*needed, 11);
    const EigenvaluesDocument enough = eigenvalues(surface, up_to(std::to_string(std::ceil(*needed)).c_str()));
    EXPECT_EQ(enough.windows.front().least, enough.windows.front().most);
    EXPECT_FALSE(length_to_count_first(enough));
  }
}

TEST(Eigenvalues, LengthsOutOfRangeAreRefused) {
  EXPECT_THAT([] { (void)eigenvalues(random_octagon(5), up_to("1e-3")); },
              testing::ThrowsMessage<NetError>(HasSubstr("at most 1e-3; a length of 1 or more is needed")));
  EXPECT_THAT([] { (void)eigenvalues(random_octagon(5), up_to("30.1")); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("more than 30")));
}

TEST(Eigenvalues, AWidthIsReachedOrAnError) {
  EigenvaluesOptions options{.width = 0.1, .eigenfunctions = false};
  const EigenvaluesDocument found = eigenvalues(random_octagon(5), options);
  EXPECT_EQ(found.up_to, "8") << "a width of 0.0999";
  const auto& first = found.windows.front();
  EXPECT_EQ(first.most, 1U);
  EXPECT_LT(first.smallest.upper - first.greatest.lower, 0.1);
  EXPECT_EQ(found, eigenvalues(random_octagon(5), up_to("8")));
  options.width = 0.03;
  EXPECT_EQ(eigenvalues(random_octagon(5), options).up_to, "10");
  options.up_to = Length("8.5");
  EXPECT_THAT([&] { (void)eigenvalues(random_octagon(5), options); },
              testing::ThrowsMessage<NetError>(HasSubstr("by closed geodesics of length at most 8.5, expected 0.03")));
  options.count = 3;
  EXPECT_THAT([&] { (void)eigenvalues(random_octagon(5), options); },
              testing::ThrowsMessage<NetError>(HasSubstr("the first 3 eigenvalues are not counted")));
  for (const double width : {0.0, -1.0, std::nan("")}) {
    options.width = width;
    EXPECT_THROW((void)eigenvalues(random_octagon(5), options), std::invalid_argument);
  }
}

TEST(Eigenvalues, ATimeOfNothingIsOneSearch) {
  EigenvaluesOptions options{.seconds = 1e-9, .eigenfunctions = false};
  EXPECT_EQ(eigenvalues(random_octagon(5), options), eigenvalues(random_octagon(5), up_to("8")));
  options.up_to = Length("6");
  options.seconds = 1e9;
  EXPECT_EQ(eigenvalues(random_octagon(5), options), eigenvalues(random_octagon(5), up_to("6")));
  options.seconds = 0;
  EXPECT_THROW((void)eigenvalues(random_octagon(5), options), std::invalid_argument);
}

TEST(Eigenvalues, VeryShortGeodesicsAreRefused) {
  EXPECT_THAT([] { (void)eigenvalues(with_cuff("1e-9"), up_to("6")); },
              testing::ThrowsMessage<LimitError>(HasSubstr("more than 1000000 multiples of length at most 6; the "
                                                           "shortest one has the length 1e-09")));
}

// Approximate eigenfunctions.

TEST(EigenfunctionSearch, LeavesLargeNetsOut) {
  const Surface surface = of_genus(30);
  EigenvaluesDocument document;
  static_cast<certify::GeodesicsDocument&>(document) = spectrum(surface, Length("1"));
  ASSERT_GT(document.net.vertices.size(), 150U);
  EXPECT_FALSE(EigenfunctionSearch(document, 2).near(0.2));
  EXPECT_TRUE(EigenfunctionSearch(document, 2).around(0.2).empty());
}

// The bound and its picture.

TEST(EigenvalueBounds, AreLessThanOneOutsideOfWindowsAndAtLeastTheNumberInThem) {
  const EigenvaluesDocument document = bolza();
  const std::vector<double> bounds =
      eigenvalue_bounds(from_document(document.net.surface), document, {0, 1, kFirst, 4.5, kFourth, 6.5});
  for (const std::size_t i : {0U, 1U, 3U, 5U}) EXPECT_LT(bounds[i], 0.98) << i;
  EXPECT_GE(bounds[2], 3);
  EXPECT_GE(bounds[4], 4);
}

TEST(EigenvaluesPicture, HasTheBoundAndTheWindows) {
  const EigenvaluesDocument document = bolza();
  const EigenvaluesPicture picture = picture_of(document);
  EXPECT_EQ(picture.windows, document.windows);
  EXPECT_EQ(picture.up_to, document.eigenvalues_up_to);
  ASSERT_GT(picture.samples.size(), 500U);
  EXPECT_EQ(picture.samples.front().lambda, 0);
  EXPECT_GT(picture.samples.back().lambda, picture.up_to);
  double greatest = 0;
  for (std::size_t i = 0; i < picture.samples.size(); ++i) {
    const auto& [lambda, bound] = picture.samples[i];
    if (i > 0) {
      EXPECT_LT(picture.samples[i - 1].lambda, lambda);
    }
    const bool inside =
        std::any_of(picture.windows.begin(), picture.windows.end(),
                    [&, x = lambda](const auto& window) { return window.in.lower <= x && x <= window.in.upper; });
    if (!inside && lambda <= picture.up_to) {
      EXPECT_LT(bound, 1) << lambda;
    }
    if (std::abs(lambda - kFirst) < 0.1) greatest = std::max(greatest, bound);
  }
  EXPECT_NEAR(greatest, 3, 0.1) << "the peak is not missed";
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t result = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++result;
  return result;
}

/// The text of a group of an SVG picture.
std::string group(const std::string& svg, const std::string& name) {
  const std::size_t begin = svg.find("<g class=\"" + name + '"');
  return begin == std::string::npos ? "" : svg.substr(begin, svg.find("</g>", begin) - begin);
}

TEST(EigenvaluesPicture, IsDrawnWithABandAndANumberForEachWindow) {
  EigenvaluesPicture picture = picture_of(bolza());
  const std::string svg = draw_svg(picture, 700);
  EXPECT_EQ(svg, draw_svg(picture, 700));
  EXPECT_THAT(svg, HasSubstr("width=\"700\" height=\"434\""));
  EXPECT_EQ(occurrences(group(svg, "windows"), "<rect"), picture.windows.size());
  EXPECT_EQ(occurrences(group(svg, "numbers"), "<text"), picture.windows.size());
  for (const char* number : {">3<", ">4<"}) EXPECT_THAT(group(svg, "numbers"), HasSubstr(number));
  EXPECT_THAT(svg, HasSubstr("class=\"quarter\""));
  // A window with a known number is marked on the axis as well.
  const std::size_t marks = occurrences(group(svg, "places"), "<rect");
  picture.windows[0].least = 1;
  const std::string unknown = draw_svg(picture, 700);
  EXPECT_THAT(group(unknown, "numbers"), HasSubstr(">1–3<"));
  EXPECT_EQ(occurrences(group(unknown, "places"), "<rect") + 1, marks);
}

/// At an eigenvalue that an eigenfunction shows the curve may be less than 1.
TEST(EigenvaluesPicture, SaysWhatItsCurveDoesNotCount) {
  const EigenvaluesDocument document = file("octagon-5-to-8-digits.json");
  const EigenvaluesPicture picture = picture_of(document);
  EXPECT_TRUE(picture.without_known);
  EXPECT_THAT(draw_svg(picture), HasSubstr("that no eigenfunction shows: where it is less than 1, there is no other"));
  EXPECT_FALSE(picture_of(bolza()).without_known);
  EXPECT_THAT(draw_svg(picture_of(bolza())), HasSubstr("where it is less than 1, there is none"));
}

/// A window of no width that can be seen, and numbers that would be at the same place.
TEST(EigenvaluesPicture, NarrowWindowsCanBeSeen) {
  EigenvaluesPicture picture{.title = "a & b", .up_to = 10, .samples = {{0, 0.5}, {5, 2}, {11, 0.5}}};
  for (const double x : {5.0, 5.001}) picture.windows.push_back({{x, x + 1e-9}, 1, 1, {x, x + 1e-9}, {x, x + 1e-9}});
  const std::string svg = draw_svg(picture);
  EXPECT_THAT(svg, HasSubstr("a &amp; b"));
  EXPECT_EQ(occurrences(group(svg, "windows"), "width=\"2.00\""), 2U);
  EXPECT_EQ(occurrences(group(svg, "places"), "width=\"3.00\""), 2U);
  const std::string numbers = group(svg, "numbers");
  EXPECT_EQ(occurrences(numbers, "y=\"144.00\""), 1U);
  EXPECT_EQ(occurrences(numbers, "y=\"127.00\""), 1U);
}

}  // namespace
}  // namespace epsnet::eigenvalues_test
