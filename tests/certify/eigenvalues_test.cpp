#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#if __has_include(<flint/acb_hypgeom.h>)
#include <flint/acb_hypgeom.h>
#else
#include <acb_hypgeom.h>
#endif

#include "certify/check.h"
#include "certify/claims/eigenvalues/check.h"
#include "certify/claims/eigenvalues/counting.h"
#include "certify/claims/eigenvalues/eigenfunction.h"
#include "certify/claims/eigenvalues/near_vertices.h"
#include "certify/claims/eigenvalues/test_function.h"
#include "certify/claims/eigenvalues/trace_forms.h"
#include "certify/file/reader.h"
#include "certify/net/label_evaluator.h"
#include "certify/net/surface_check.h"
#include "tests/support/scale.h"

/// Eigenvalues files. Each rule is broken by a file in which nothing else is wrong.
namespace epsnet::certify::eigenvalues_test {
namespace {

using testing::HasSubstr;
using Document = EigenvaluesDocument;

/// λ_1 of a random octagon, simple.
Document octagon() { return read_file<Document>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/octagon-5-to-8.json"); }
/// The same with an approximate eigenfunction, which gives nine digits.
Document digits() {
  return read_file<Document>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/octagon-5-to-8-digits.json");
}
/// The same with its first two eigenvalues: the functions of three make the gaps between them provable.
Document two() { return read_file<Document>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/octagon-5-to-8-two.json"); }
/// The first three windows of the Bolza surface, of 3, 4 and 2 eigenvalues.
Document bolza() { return read_file<Document>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/bolza-to-9.json"); }

/// λ_1 of the Bolza surface, multiplicity 3, and the next one, multiplicity 4 (A. Strohmaier, V. Uski, An algorithm for
/// the computation of eigenvalues, spectral zeta functions and zeta-determinants on hyperbolic surfaces).
constexpr double kFirst = 3.8388872588421995;
constexpr double kSecond = 5.353601341189;

Certificate checked(const Document& document) { return check(document, {.threads = 2}); }

/// "VERDICT", or "VERDICT: rule".
std::string outcome(const Document& document, std::uint64_t max_work = 0) {
  const Certificate certificate = check(document, {.threads = 2, .max_work = max_work});
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

double above(double x) { return std::nextafter(x, HUGE_VAL); }
double below(double x) { return std::nextafter(x, 0.0); }

TEST(Eigenvalues, TrueFilesAreVerified) {
  EXPECT_EQ(outcome(octagon()), "VERIFIED");
  EXPECT_EQ(outcome(bolza()), "VERIFIED");
}

TEST(Eigenvalues, OfTheBolzaSurfaceAreThoseOfTheLiterature) {
  const Document document = bolza();
  ASSERT_GE(document.windows.size(), 2U);
  const auto& first = document.windows[0];
  EXPECT_EQ(first.least, 3U);
  EXPECT_EQ(first.most, 3U);
  EXPECT_LE(first.greatest.lower, kFirst);
  EXPECT_GE(first.smallest.upper, kFirst);
  EXPECT_EQ(document.windows[1].least, 4U);
  EXPECT_LE(document.windows[1].greatest.lower, kSecond);
  EXPECT_GE(document.windows[1].smallest.upper, kSecond);
}

// The spectrum.

TEST(Eigenvalues, AGeodesicLeftOutIsMissedByTheRuleOfTheSpectrum) {
  Document document = octagon();
  document.geodesics.pop_back();
  document.clusters.pop_back();
  EXPECT_EQ(outcome(document), "REFUTED: complete");
}

TEST(Eigenvalues, AWrongLengthIsFoundByTheRuleOfTheSpectrum) {
  Document document = octagon();
  Interval& length = document.geodesics.front().length;
  length = {below(below(length.lower)), below(length.lower)};
  EXPECT_EQ(outcome(document), "REFUTED: geodesics");
}

/// The forms of the octagon with these lengths, its genus being `genus`.
TraceForms forms_of(const Document& document, std::size_t without, std::uint32_t genus) {
  std::vector<Ball> lengths;
  for (std::size_t i = 0; i < document.geodesics.size(); ++i) {
    if (i == without) continue;
    const Interval length = document.geodesics[i].length;
    lengths.push_back(half(Ball::exactly(length.lower) + Ball::exactly(length.upper)));
  }
  return TraceForms::of(test_functions(document), genus, lengths, Budget()).value();
}

std::vector<std::array<Ball, 3>> sums_of(const Document& document, const TraceForms& forms) {
  std::vector<std::array<Ball, 3>> sums;
  for (const auto& row : document.at_most) sums.push_back(forms(row.coefficients));
  for (const auto& row : document.at_least) sums.push_back(forms(row.coefficients));
  return sums;
}

TEST(Traces, OfTheWholeListArePositive) {
  const Precision scope(192);
  const Document document = octagon();
  const RuleReport report = traces_report(sums_of(document, forms_of(document, document.geodesics.size(), 2)));
  EXPECT_EQ(report.verdict, Verdict::verified) << report.text;
}

TEST(Traces, WithoutOneGeodesicAreNegative) {
  const Precision scope(192);
  const Document document = octagon();
  for (const std::size_t without : {std::size_t{0}, std::size_t{5}, std::size_t{20}}) {
    const RuleReport report = traces_report(sums_of(document, forms_of(document, without, 2)));
    EXPECT_EQ(report.verdict, Verdict::refuted) << without;
    EXPECT_THAT(report.text, HasSubstr("cannot be complete"));
  }
}

TEST(Traces, OfAnotherGenusAreNegative) {
  const Precision scope(192);
  const Document document = octagon();
  // Fewer eigenvalues than the geodesics need.
  const auto report = traces_report(sums_of(document, forms_of(document, document.geodesics.size(), 1)));
  EXPECT_EQ(report.verdict, Verdict::refuted);
}

TEST(Traces, AreUndecidedWhereTheSignIs) {
  Ball wide;
  arb_set_d(wide.get(), 0);
  const Precision scope(64);
  arb_add_error(wide.get(), Ball::exactly(1).get());
  const std::vector<std::array<Ball, 3>> sums{{wide, wide, wide}};
  EXPECT_EQ(traces_report(sums).verdict, Verdict::undecided);
}

TEST(Traces, WhereALengthLiesMustBeCertain) {
  const Precision scope(64);
  Ball length = Ball::exactly(4);
  arb_add_error(length.get(), Ball::exactly(1).get());
  const TestFunctions functions{mpq_class(8), 8, 32};
  EXPECT_FALSE(TraceForms::of(functions, 2, std::vector{length}, Budget()));
  EXPECT_TRUE(TraceForms::of(functions, 2, std::vector{Ball::exactly(4.001)}, Budget()));
}

TEST(Traces, VeryShortGeodesicsSpendTheBudget) {
  const Precision scope(64);
  const TestFunctions functions{mpq_class(8), 8, 32};
  EXPECT_THROW((void)TraceForms::of(functions, 2, std::vector{Ball::exactly(1e-9)}, Budget(1'000'000'000)),
               BudgetSpent);
}

/// The identity part alone, without geodesics, is 2(g − 1) ∫₀^∞ r tanh(πr) f̂² dr: a sum over r in small steps.
TEST(Traces, TheIdentityPartIsItsIntegralOverR) {
  const Precision scope(128);
  const TestFunctions functions{mpq_class(1), 8, 3};
  const std::vector<double> c{1, -0.5, 0.25, 2};
  const auto sums = TraceForms::of(functions, 3, {}, Budget()).value()(c);
  const double step = functions.step().get_d();
  const auto value = [&](double r) {
    double result = 0;
    for (std::size_t k = 0; k < c.size(); ++k) result += c[k] * std::cos(static_cast<double>(k) * step * r);
    const double x = step * r / 2;
    return result * std::pow(x == 0 ? 1 : std::sin(x) / x, 4);
  };
  double at_zero = 0;
  for (std::size_t k = 0; k < c.size(); ++k) at_zero += c[k] * std::cosh(static_cast<double>(k) * step / 2);
  at_zero *= std::pow(std::sinh(step / 4) / (step / 4), 4);
  std::array<double, 3> expected{-at_zero * at_zero, 0, 0};
  constexpr double kStep = 0.01;
  for (double r = kStep / 2; r < 3000; r += kStep) {
    const double term = 4 * r * std::tanh(std::numbers::pi * r) * value(r) * value(r) * kStep;
    for (std::size_t p = 0; p < 3; ++p) expected[p] += term * std::pow(0.25 + r * r, static_cast<double>(p));
  }
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_NEAR(outer_interval(sums[p]).lower / expected[p], 1, 1e-4) << p;
    EXPECT_LT(outer_interval(sums[p]).upper - outer_interval(sums[p]).lower, 1e-12 * std::abs(expected[p]));
  }
}

// Values of test functions.

TEST(SquaredTestFunction, ContainsItsValues) {
  const Precision scope(128);
  const TestFunctions functions{mpq_class(8), 8, 5};
  const std::vector<double> c{1, -2, 0.5, 3, -1, 0.25};
  const double step = functions.step().get_d();
  const auto value = [&](double lambda) {
    const std::complex<double> r = std::sqrt(std::complex<double>(lambda - 0.25));
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < c.size(); ++k) sum += c[k] * std::cos(static_cast<double>(k) * step * r);
    const std::complex<double> x = step * r / 2.0;
    return std::pow((sum * std::pow(x == 0.0 ? 1.0 : std::sin(x) / x, 4)).real(), 2);
  };
  const SquaredTestFunction square(functions, c);
  for (const Interval in : {Interval{0, 0.5}, {0.2, 0.3}, {0.25, 0.25}, {0, 0}, {1, 1.5}, {7, 7.25}}) {
    const Interval found = outer_interval(square.on(in));
    for (int i = 0; i <= 8; ++i) {
      const double x = value(in.lower + (in.upper - in.lower) * i / 8);
      EXPECT_LE(found.lower, x * (1 + 1e-12)) << in.lower;
      EXPECT_GE(found.upper, x * (1 - 1e-12)) << in.lower;
    }
    if (in.lower == in.upper) {
      EXPECT_LT(found.upper - found.lower, 1e-15 * found.upper);
    }
  }
}

TEST(IsPositiveOn, AnswersWhatIsCertain) {
  const Precision scope(128);
  const auto less = [](double zero) {
    return [zero](Interval x) {
      const Ball all = ball_of(arb_union, Ball::exactly(x.lower), Ball::exactly(x.upper));
      return sqr(all - Ball::exactly(1)) - Ball::exactly(zero);
    };
  };
  EXPECT_EQ(is_positive_on({0, 3}, less(-1e-3)), Tri::yes);
  EXPECT_EQ(is_positive_on({0, 3}, less(1e-3)), Tri::no);
  EXPECT_EQ(is_positive_on({0, 1}, less(0)), Tri::no);
  // Never decided: a ball around 0, whatever the interval.
  EXPECT_EQ(is_positive_on({0, 1},
                           [](Interval) {
                             Ball result;
                             arb_add_error(result.get(), Ball::exactly(1).get());
                             return result;
                           }),
            Tri::unknown);
}

// The rules of statements: each row is changed alone.

/// The outcomes of the files that `change` makes of the octagon's.
std::string changed(const std::function<void(Document&)>& change) {
  Document document = octagon();
  change(document);
  return outcome(document);
}

TEST(Eigenvalues, AChangedCoefficientIsRefuted) {
  EXPECT_EQ(changed([](Document& d) { d.at_most.front().coefficients[3] += 0.25; }), "REFUTED: most");
  EXPECT_EQ(changed([](Document& d) { d.at_least.front().coefficients[3] += 0.25; }), "REFUTED: least");
}

TEST(Eigenvalues, AWiderIntervalOfNoneIsRefuted) {
  EXPECT_EQ(changed([](Document& d) {
              for (auto& row : d.at_most) {
                if (row.count == 0) row.in.upper = 2.8;
              }
            }),
            "REFUTED: most");
}

TEST(Eigenvalues, ASmallerCountIsRefuted) {
  EXPECT_EQ(changed([](Document& d) {
              for (auto& row : d.at_most) row.count = 0;
            }),
            "REFUTED: most");
}

TEST(Eigenvalues, AGreaterCountIsRefuted) {
  EXPECT_EQ(changed([](Document& d) { ++d.at_least.front().count; }), "REFUTED: least");
}

TEST(Eigenvalues, ANarrowerIntervalForTheEigenvalueIsRefuted) {
  EXPECT_EQ(changed([](Document& d) {
              auto& in = d.at_least.front().in;
              in.upper = d.at_least.front().within.upper = (d.windows[0].in.lower + in.upper) / 2;
            }),
            "REFUTED: least");
}

TEST(Eigenvalues, AnotherOrderIsRefuted) {
  EXPECT_EQ(changed([](Document& d) { d.order = 10; }), "REFUTED: least");
}

TEST(Eigenvalues, TooFewBitsAreUndecided) {
  const Document document = bolza();
  const Certificate certificate = check(document, {.threads = 2, .max_precision = 64});
  EXPECT_NE(certificate.verdict, Verdict::verified);
  EXPECT_NE(certificate.verdict, Verdict::refuted);
}

/// Changes one number of a file, by a unit in the last place, by a little, or by much.
void mutate(Document& document, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto change = [&](double& x) {
    const std::array<double, 4> values{above(x), below(2) == 0 ? -x : std::nextafter(x, 0.0), x * (1 + 1e-6), x * 1.02};
    x = values[below(values.size())];
  };
  const auto change_end = [&](Interval& in) { change(below(2) == 0 ? in.lower : in.upper); };
  const auto change_count = [&](std::uint32_t& count) { count += below(2) == 0 ? 1U : ~0U; };
  auto& most = document.at_most[below(document.at_most.size())];
  auto& least = document.at_least[below(document.at_least.size())];
  auto& window = document.windows[below(document.windows.size())];
  switch (below(9)) {
    case 0:
      return change(most.coefficients[below(most.coefficients.size())]);
    case 1:
      return change(least.coefficients[below(least.coefficients.size())]);
    case 2:
      return change_end(most.in);
    case 3:
      return change_end(below(2) == 0 ? least.in : least.within);
    case 4:
      return change_count(below(2) == 0 ? most.count : least.count);
    case 5:
      change_end(window.in);
      window.smallest = window.greatest = window.in;
      return;
    case 6:
      return change_count(below(2) == 0 ? window.most : window.least);
    case 7:
      return change_end(below(2) == 0 ? window.smallest : window.greatest);
    default:
      return change(document.eigenvalues_up_to);
  }
}

/// The only eigenvalue of the octagon below 3.69 is near 2.77507 (L = 14 proves 2.77505 < λ_1 < 2.77509, 3.69 < λ_2).
TEST(DeepEigenvalues, MutantsThatAreVerifiedAreTrue) {
  constexpr double kOnly = 2.77507;
  std::mt19937 random(27);
  int verified = 0;
  const int mutants = test::scaled(120);
  for (int i = 0; i < mutants; ++i) {
    Document document = octagon();
    mutate(document, random);
    if (checked(document).verdict != Verdict::verified) continue;
    ++verified;
    bool there = document.eigenvalues_up_to < kOnly;
    for (const auto& window : document.windows) {
      const bool contains = window.in.lower < kOnly && kOnly < window.in.upper;
      there |= contains;
      EXPECT_LE(window.least, contains ? 1U : 0U) << i;
      EXPECT_GE(window.most, contains ? 1U : 0U) << i;
      if (contains && window.least == window.most) {
        EXPECT_LT(window.greatest.lower, kOnly) << i;
        EXPECT_GT(window.smallest.upper, kOnly) << i;
      }
    }
    EXPECT_TRUE(there) << i;
  }
  EXPECT_GT(verified, mutants / 10);
  EXPECT_LT(verified, mutants / 2);
}

// Approximate eigenfunctions.

TEST(Eigenfunctions, GiveNineDigits) {
  const Document document = digits();
  EXPECT_EQ(outcome(document), "VERIFIED");
  ASSERT_EQ(document.windows.size(), 1U);
  const auto& window = document.windows[0];
  // What the trace formula alone proves from geodesics up to 14.
  EXPECT_GT(window.greatest.lower, 2.77505);
  EXPECT_LT(window.smallest.upper, 2.77509);
  EXPECT_LT(window.smallest.upper - window.greatest.lower, 3e-9);
}

/// What certify says of the file with its eigenfunction changed. Two precisions are enough to try.
std::string with_function(const std::function<void(Document::Eigenfunction&)>& change) {
  Document document = digits();
  change(document.eigenfunctions.at(0));
  const Certificate certificate = check(document, {.threads = 2, .max_precision = 192});
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

TEST(DeepEigenfunctions, ThatProveLessAreUndecided) {
  const std::string undecided = "UNDECIDED: eigenfunctions";
  EXPECT_EQ(with_function([](auto& f) { f.lambda += 5e-10; }), undecided);
  EXPECT_EQ(with_function([](auto& f) { f.in.lower = f.lambda - (f.lambda - f.in.lower) * 0.99; }), undecided);
  EXPECT_EQ(with_function([](auto& f) { f.in.upper = f.lambda; }), undecided);
  EXPECT_EQ(with_function([](auto& f) { f.coefficients[0] *= 1 + 1e-9; }), undecided);
  EXPECT_EQ(with_function([](auto& f) { f.coefficients.back() += 1; }), undecided);
  // The functions of two vertices exchanged; the function of one of them left out.
  EXPECT_EQ(with_function([](auto& f) {
              const auto second = f.coefficients.begin() + 153;
              std::swap_ranges(f.coefficients.begin(), second, second);
            }),
            undecided);
  EXPECT_EQ(with_function([](auto& f) { std::fill_n(f.coefficients.end() - 153, 153, 0.0); }), undecided);
  // Disks that overlap by less, or so much that the series is not used.
  EXPECT_EQ(with_function([](auto& f) { f.radius = 1.01; }), undecided);
  EXPECT_EQ(with_function([](auto& f) { f.radius = 1.9; }), undecided);
}

/// That a bound for the norm is not positive does not depend on the number of bits.
TEST(SlowEigenfunctions, ThatProveNothingAreNotAskedWithMoreBits) {
  Document document = digits();
  auto& coefficients = document.eigenfunctions.at(0).coefficients;
  std::swap_ranges(coefficients.begin(), coefficients.begin() + 153, coefficients.begin() + 153);
  const Certificate certificate = checked(document);
  EXPECT_EQ(certificate.verdict, Verdict::undecided);
  EXPECT_EQ(certificate.rule, "eigenfunctions");
  EXPECT_THAT(certificate.message, HasSubstr("function 0 proves no eigenvalue"));
  EXPECT_EQ(certificate.counts.max_precision_used, checked(digits()).counts.max_precision_used);
}

TEST(SlowEigenfunctions, WithTwiceTheCoefficientsProveTheSame) {
  EXPECT_EQ(with_function([](auto& f) {
              for (double& c : f.coefficients) c *= 2;
            }),
            "VERIFIED");
}

TEST(Eigenfunctions, ThatAreMissingAreMissed) {
  Document document = digits();
  document.eigenfunctions.clear();
  EXPECT_EQ(outcome(document), "REFUTED: windows");
}

TEST(Eigenfunctions, NotAllEigenvaluesOfAWindowAreWhereTheOneIsNot) {
  Document document = digits();
  ASSERT_FALSE(Counting(document).problem());
  const Interval in = document.eigenfunctions[0].in;
  document.windows[0].smallest.upper = in.upper;
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("smallest"));
  document = digits();
  document.windows[0].greatest.lower = in.lower;
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("greatest"));
  // One that may be in another window proves nothing.
  document = digits();
  document.eigenfunctions[0].in.lower = below(document.windows[0].in.lower);
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("smallest"));
  // That there is one is known from it as well.
  document = digits();
  document.at_least.clear();
  EXPECT_FALSE(Counting(document).problem());
  document.eigenfunctions[0].in.upper = above(document.windows[0].in.upper);
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("at least 1"));
}

TEST(DeepEigenfunctions, EigenvaluesThatAreKnownElsewhereAreLeftOutOfSums) {
  const Document document = two();
  EXPECT_EQ(outcome(document), "VERIFIED");
  ASSERT_EQ(document.eigenfunctions.size(), 3U);
  ASSERT_EQ(document.windows.size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    const auto& window = document.windows[i];
    EXPECT_EQ(window.least, 1U);
    EXPECT_EQ(window.most, 1U);
    EXPECT_LT(window.in.upper - window.in.lower, 1e-8);
  }
  // Of all rules but that of the functions, which takes too much work.
  const auto changed = [&](const std::function<void(Document&)>& change) {
    Document copy = document;
    change(copy);
    return outcome(copy, 500'000'000);
  };
  const std::string others_verified = "UNDECIDED: eigenfunctions";
  EXPECT_EQ(changed([](Document&) {}), others_verified);
  // Each of the three is needed.
  for (std::ptrdiff_t i = 0; i < 3; ++i)
    EXPECT_EQ(changed([&](Document& d) { d.eigenfunctions.erase(d.eigenfunctions.begin() + i); }), "REFUTED: most")
        << i;
  // One that is there twice counts once.
  EXPECT_EQ(changed([&](Document& d) { d.eigenfunctions[2] = d.eigenfunctions[1]; }), "REFUTED: most");
  EXPECT_EQ(changed([&](Document& d) { d.eigenfunctions.push_back(d.eigenfunctions[1]); }), others_verified);
  // One that may be in the interval of the statement.
  EXPECT_EQ(changed([&](Document& d) { d.eigenfunctions[0].in.upper = d.windows[0].in.upper; }), "REFUTED: most");
  // It is somewhere in its interval, where the test function may be small.
  Document wide = document;
  wide.eigenfunctions[2].in.upper = wide.eigenfunctions[2].in.lower + 1;
  const Certificate certificate = check(wide, {.threads = 2, .max_precision = 192, .max_work = 500'000'000});
  EXPECT_EQ(certificate.verdict, Verdict::undecided);
  EXPECT_EQ(certificate.rule, "most");
}

/// Functions beyond 1/4 + 9/step² are no reason to read a test function there.
TEST(SlowEigenfunctions, BeyondTheReachOfTestFunctionsAreNotLeftOutOfSums) {
  Document document = digits();
  document.eigenfunctions.push_back(document.eigenfunctions[0]);
  document.eigenfunctions[1].in.upper = 1e6;
  document.eigenfunctions[1].in.lower = document.eigenfunctions[1].lambda = 1e5;
  EXPECT_EQ(outcome(document, 500'000'000), "UNDECIDED: eigenfunctions");
}

TEST(Disjoint, AreAsManyAsThereAre) {
  const auto result = [](std::vector<Interval> intervals) { return disjoint(std::move(intervals)); };
  EXPECT_TRUE(result({}).empty());
  EXPECT_EQ(result({{3, 4}, {1, 2}}), (std::vector<Interval>{{1, 2}, {3, 4}}));
  EXPECT_EQ(result({{1, 2}, {2, 3}, {above(2), 3}}), (std::vector<Interval>{{1, 2}, {above(2), 3}}));
  EXPECT_EQ(result({{0, 10}, {1, 2}, {1.5, 4}, {5, 6}}), (std::vector<Interval>{{1, 2}, {5, 6}}));
  EXPECT_EQ(result({{1, 2}, {0, 2}, {2, 2}}), (std::vector<Interval>{{0, 2}}));
}

TEST(Eigenfunctions, OfWrongStructureAreMalformed) {
  const auto problem = [](const std::function<void(Document::Eigenfunction&)>& change) {
    Document document = digits();
    change(document.eigenfunctions.at(0));
    return structure_problem(document).value_or("");
  };
  EXPECT_EQ(problem([](auto&) {}), "");
  for (const double lambda : {0.0, -1.0, 2.7, 2.8, std::nan(""), HUGE_VAL})
    EXPECT_THAT(problem([&](auto& f) { f.lambda = lambda; }), HasSubstr("eigenfunctions[0]: lambda is not in in"));
  EXPECT_THAT(problem([](auto& f) { f.in.lower = 0; }), HasSubstr("0 < lo"));
  EXPECT_THAT(problem([](auto& f) { f.in.upper = HUGE_VAL; }), HasSubstr("lo <= hi"));
  for (const double radius : {0.5, 1.0, 2.0, std::nan("")})
    EXPECT_THAT(problem([&](auto& f) { f.radius = radius; }), HasSubstr("more than epsilon and less than 2"));
  EXPECT_THAT(problem([](auto& f) { f.coefficients.pop_back(); }), HasSubstr("1376 coefficients, expected 2M + 1"));
  for (const std::size_t each : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{152}, std::size_t{403}})
    EXPECT_THAT(problem([&](auto& f) { f.coefficients.assign(9 * each, 1); }), HasSubstr("expected 2M + 1")) << each;
  EXPECT_THAT(problem([](auto& f) { f.coefficients.assign(9 * 401, 0); }), HasSubstr("are 0"));
  EXPECT_THAT(problem([](auto& f) { f.coefficients[7] = std::nan(""); }), HasSubstr("not finite"));
}

/// ₂F₁(½ − ir, ½ + ir; m + 1; −s/(1 − s)) by Arb.
Ball reference_factor(double lambda, double s, std::uint32_t m) {
  acb_t r, a, b, c, z, value;
  for (acb_struct* x : {r, a, b, c, z, value}) acb_init(x);
  const slong bits = Precision::bits();
  acb_set_d(r, lambda - 0.25);
  acb_sqrt(r, r, bits);
  acb_mul_onei(r, r);
  acb_set_d(a, 0.5);
  acb_sub(b, a, r, bits);
  acb_add(a, a, r, bits);
  acb_set_ui(c, m + 1);
  acb_set_d(z, s);
  acb_sub_ui(value, z, 1, bits);
  acb_div(z, z, value, bits);
  acb_hypgeom_2f1(value, a, b, c, z, 0, bits);
  Ball result(acb_realref(value));
  for (acb_struct* x : {r, a, b, c, z, value}) acb_clear(x);
  return result;
}

TEST(RadialFactors, AreHypergeometricFunctions) {
  const Precision scope(160);
  for (const double lambda : {0.015625, 0.25, 2.75, 30.0}) {
    for (const double s : {0.0, 0.0625, 0.375, 0.5}) {
      const std::vector<Ball> found = RadialFactors(Ball::exactly(lambda), 40)(Ball::exactly(s));
      for (const std::uint32_t m : {0U, 1U, 2U, 17U, 40U}) {
        const Interval error = outer_interval(found[m] - reference_factor(lambda, s, m));
        EXPECT_LE(error.lower, 0) << lambda << ' ' << s << ' ' << m;
        EXPECT_GE(error.upper, 0) << lambda << ' ' << s << ' ' << m;
        EXPECT_LT(error.upper - error.lower, 1e-25) << lambda << ' ' << s << ' ' << m;
      }
    }
  }
}

TEST(RadialFactors, AreNotUsedBeyondOneHalf) {
  const Precision scope(128);
  EXPECT_FALSE(is_finite(RadialFactors(Ball::exactly(1), 8)(Ball::exactly(above(0.5)))[3]));
  // A series of order 1 that would take too long.
  EXPECT_FALSE(is_finite(RadialFactors(Ball::exactly(1), 1)(Ball::exactly(0.25))[0]));
}

/// The inequalities of docs/proof.md, Lemma 37.1, at many places; derivatives by differences.
TEST(RadialFactors, SatisfyTheirBounds) {
  const Precision scope(128);
  for (const double lambda : {0.1, 2.75, 12.0, 40.0}) {
    const RadialFactors factors(Ball::exactly(lambda), 30);
    const auto functions = [&](double rho) {
      const double t = std::tanh(rho / 2);
      std::vector<double> result;
      double power = 1;
      for (const Ball& factor : factors(Ball::exactly(t * t))) {
        result.push_back(power * arf_get_d(arb_midref(factor.get()), ARF_RND_NEAR));
        power *= t;
      }
      return result;
    };
    for (double rho = 0.05; rho < 1.7; rho += 0.11) {
      const double t = std::tanh(rho / 2);
      const double step = 1e-4;
      const auto here = functions(rho);
      const auto before = functions(rho - step);
      const auto behind = functions(rho + step);
      for (std::uint32_t m = 0; m < here.size(); ++m) {
        EXPECT_LE(std::abs(here[m]), std::pow(t, m) * (1 + 1e-12)) << lambda << ' ' << rho << ' ' << m;
        if (lambda * std::sinh(rho) * std::sinh(rho) <= (m + 1) * (m + 1)) {
          EXPECT_GE(here[m], std::pow(t, m) * std::exp(-lambda * (std::cosh(rho) - 1) / (m + 1)) * (1 - 1e-12));
        }
        const double slope = std::abs(behind[m] - before[m]) / (2 * step);
        const double bound = m * std::pow(t, m - 1.0) + lambda * std::pow(t, m + 1.0);
        EXPECT_LE(slope + m * std::abs(here[m]) / std::sinh(rho), bound * (1 + 1e-4))
            << lambda << ' ' << rho << ' ' << m;
      }
    }
  }
}

/// The lifts near each vertex of the octagon's net.
std::optional<std::vector<std::vector<NearVertex>>> near_in(const Document& document, double distance, slong bits) {
  const Precision scope(bits);
  const LabelParts parts = label_parts(check_surface(document.net.surface).crossings, document.net.charts, {});
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t k = 1; k <= document.net.labels.size(); ++k) numbers.push_back(k);
  const auto labels = LabelEvaluator(document.net, parts).evaluate(numbers, bits, 4 * bits, 1);
  return near_vertices(document, labels, Ball::exactly(distance), {});
}

/// Those nearer than 1.5 that a search for others finds, too; and each is seen from both of its ends.
TEST(NearVertices, AreAllThatAreNear) {
  const Document document = octagon();
  const auto near = near_in(document, 1.5, 128).value();
  const auto more = near_in(document, 3, 128).value();
  std::vector<std::vector<std::size_t>> counts(near.size(), std::vector<std::size_t>(near.size()));
  for (std::size_t k = 0; k < near.size(); ++k) {
    std::size_t others = 0;
    for (const NearVertex& vertex : more[k]) {
      const double sinh_squared = outer_interval(vertex.sinh_squared).lower;
      EXPECT_LT(sinh_squared, std::pow(std::sinh(1.5), 2) * (1 + 1e-9));
      others += sinh_squared < std::pow(std::sinh(0.75), 2) ? 1 : 0;
    }
    EXPECT_EQ(near[k].size(), others) << k;
    EXPECT_GT(near[k].size(), 3U) << k;
    for (const NearVertex& vertex : more[k]) ++counts[k][vertex.vertex];
  }
  for (std::size_t k = 0; k < near.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l) EXPECT_EQ(counts[k][l], counts[l][k]);
    // A lift of a vertex and its inverse.
    EXPECT_EQ(counts[k][k] % 2, 0U);
  }
}

TEST(NearVertices, NeedBits) {
  const Document document = octagon();
  EXPECT_FALSE(near_in(document, 3, 4));
}

// Counting.

TEST(Windows, AreNarrowerOnlyWhereThatFollows) {
  EXPECT_EQ(changed([](Document& d) {
              auto& window = d.windows[0];
              window.in.lower = above(window.in.lower);
              window.smallest = window.greatest = window.in;
            }),
            "REFUTED: windows");
  EXPECT_EQ(changed([](Document& d) { d.eigenvalues_up_to = above(d.eigenvalues_up_to); }), "REFUTED: windows");
  EXPECT_EQ(changed([](Document& d) { d.windows.clear(); }), "REFUTED: windows");
}

TEST(Windows, MultiplicitiesAreThoseThatFollow) {
  for (const std::size_t i : {0U, 1U}) {
    Document document = bolza();
    const auto all = [&](std::uint32_t least, std::uint32_t most) {
      auto& window = document.windows[i];
      window.least = least;
      window.most = most;
      window.smallest = window.greatest = window.in;
      return Counting(document).problem().value_or("");
    };
    const std::uint32_t count = document.windows[i].most;
    EXPECT_EQ(all(count, count), "");
    EXPECT_EQ(all(count - 1, count + 1), "");
    EXPECT_THAT(all(count - 1, count - 1), HasSubstr("at most"));
    EXPECT_THAT(all(count + 1, count + 1), HasSubstr("at least"));
  }
}

TEST(Windows, HullsAreThoseThatFollow) {
  for (const std::size_t i : {0U, 1U}) {
    Document document = bolza();
    ASSERT_FALSE(Counting(document).problem());
    document.windows[i].smallest.upper = below(document.windows[i].smallest.upper);
    EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("smallest"));
    document = bolza();
    document.windows[i].greatest.lower = above(document.windows[i].greatest.lower);
    EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("greatest"));
  }
}

TEST(Windows, EveryStatementThatIsUsedIsNeeded) {
  Document document = octagon();
  const std::size_t rows = document.at_most.size();
  std::size_t needed = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    Document without = document;
    without.at_most.erase(without.at_most.begin() + static_cast<std::ptrdiff_t>(i));
    needed += Counting(without).problem() ? 1 : 0;
  }
  EXPECT_EQ(needed, rows);
  document.at_least.clear();
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("at least 1"));
}

/// A document of statements alone.
Document statements() {
  Document document;
  document.eigenvalues_up_to = 10;
  document.at_most = {{{0, 2}, 0, {}}, {{2, 3}, 1, {}}, {{3, 4}, 1, {}}, {{4, 10}, 0, {}}};
  document.at_least = {{{0, 5}, {2, 4}, 2, {}}};
  document.windows = {{{2, 4}, 2, 2, {2, 4}, {2, 4}}};
  return document;
}

TEST(Windows, SumsOfCoveringStatements) {
  Document document = statements();
  EXPECT_EQ(Counting(document).problem(), std::nullopt);
  document.at_most[2].in.lower = above(3.0);
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("no bound follows"));
  document.at_most[2].in.lower = 2.5;
  EXPECT_EQ(Counting(document).problem(), std::nullopt);
}

TEST(Windows, AtLeastNeedsNoneElsewhereInItsInterval) {
  Document document = statements();
  document.at_least[0].in.upper = above(10.0);
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("at least 2"));
  document = statements();
  document.at_least[0].within.upper = 3.5;
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("at least 2"));
}

TEST(Windows, DisjointFunctionsShowAsManyEigenvalues) {
  Document document = statements();
  document.at_least.clear();
  document.eigenfunctions = {{{2.5, 2.6}, 2.5, 0, {}}, {{3.1, 3.2}, 3.1, 0, {}}};
  EXPECT_EQ(Counting(document).problem(), std::nullopt);
  document.eigenfunctions[1].in.lower = 2.6;
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("at least 2"));
  document.eigenfunctions[1].in = {3.1, above(4)};
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("at least 2"));
  document.eigenfunctions.pop_back();
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("at least 2"));
}

TEST(Windows, OnesThatAreNotAllInAPart) {
  Document document = statements();
  // At most one in [3, 4]: the smallest is less than 3.
  document.windows[0].smallest.upper = 3;
  document.windows[0].greatest.lower = 3;
  EXPECT_EQ(Counting(document).problem(), std::nullopt);
  document.windows[0].smallest.upper = below(3.0);
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("smallest"));
  // If all were in [2.75, 4], there would be three.
  document.at_least.push_back({{0, 5}, {2.75, 4}, 3, {}});
  document.windows[0].smallest.upper = 2.75;
  EXPECT_EQ(Counting(document).problem(), std::nullopt);
  document.at_least.back().count = 2;
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("smallest"));
  document.at_least.back() = {{0, 20}, {2.75, 4}, 3, {}};
  EXPECT_THAT(Counting(document).problem().value_or(""), HasSubstr("smallest"));
}

// Structure.

std::string problem(const std::function<void(Document&)>& change) {
  Document document = octagon();
  change(document);
  return structure_problem(document).value_or("");
}

TEST(EigenvaluesStructure, NumbersAreInRange) {
  EXPECT_EQ(problem([](Document&) {}), "");
  for (const std::uint32_t order : {0U, 6U, 9U, 18U}) {
    EXPECT_THAT(problem([&](Document& d) { d.order = order; }), HasSubstr("order: "));
  }
  for (const std::uint32_t degree : {0U, 65U}) {
    EXPECT_THAT(problem([&](Document& d) { d.degree = degree; }), HasSubstr("degree: "));
  }
  EXPECT_THAT(problem([](Document& d) { d.up_to = "68.5"; }), HasSubstr("degree: 32 is too small"));
  EXPECT_EQ(problem([](Document& d) { d.up_to = "9"; }), "");
  EXPECT_THAT(problem([](Document& d) { d.claim = GeodesicsDocument::Claim::systole; }), HasSubstr("spectrum"));
  for (const double end : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THAT(problem([&](Document& d) {
                  d.windows.clear();
                  d.eigenvalues_up_to = end;
                }),
                HasSubstr("eigenvalues_up_to"));
  }
}

TEST(EigenvaluesStructure, StatementsAreWhole) {
  EXPECT_THAT(problem([](Document& d) { d.at_most[0].coefficients.pop_back(); }), HasSubstr("32 coefficients"));
  EXPECT_THAT(problem([](Document& d) { d.at_least[0].coefficients.push_back(1); }), HasSubstr("34 coefficients"));
  EXPECT_THAT(problem([](Document& d) { d.at_most[0].coefficients.assign(33, 0); }), HasSubstr("are 0"));
  EXPECT_THAT(problem([](Document& d) { d.at_most[0].coefficients[0] = std::nan(""); }), HasSubstr("not finite"));
  EXPECT_THAT(problem([](Document& d) { std::swap(d.at_most[0].in.lower, d.at_most[0].in.upper); }),
              HasSubstr("in is"));
  EXPECT_THAT(problem([](Document& d) { d.at_most[0].in.lower = -1; }), HasSubstr("in is not 0 <="));
  // 1/4 + 9/δ² for δ = 8/68.
  EXPECT_THAT(problem([](Document& d) { d.at_most[0].in.upper = above(650.5); }), HasSubstr("beyond"));
  EXPECT_EQ(problem([](Document& d) { d.at_most[0].in.upper = 650.5; }), "");
  EXPECT_THAT(problem([](Document& d) { d.at_least[0].count = 0; }), HasSubstr("the count is 0"));
  EXPECT_THAT(problem([](Document& d) { d.at_least[0].within.upper = above(d.at_least[0].in.upper); }),
              HasSubstr("not a part"));
  EXPECT_THAT(problem([](Document& d) {
                d.at_least[0].in = d.at_least[0].within = {1, 1};
              }),
              HasSubstr("single point"));
}

TEST(EigenvaluesStructure, WindowsAreInOrder) {
  using Window = Document::Window;
  const auto with = [](std::vector<Window> windows) {
    return problem([&](Document& d) {
      d.windows = std::move(windows);
      d.eigenvalues_up_to = 5;
    });
  };
  const Window good{{1, 2}, 1, 1, {1, 1.5}, {1.25, 2}};
  EXPECT_EQ(with({good}), "");
  EXPECT_THAT(with({good, good}), HasSubstr("windows[1]: in does not begin after"));
  EXPECT_THAT(with({{{4, 6}, 1, 1, {4, 6}, {4, 6}}}), HasSubstr("beyond"));
  EXPECT_THAT(with({{{1, 2}, 0, 0, {1, 2}, {1, 2}}}), HasSubstr("least <= most"));
  EXPECT_THAT(with({{{1, 2}, 2, 1, {1, 2}, {1, 2}}}), HasSubstr("least <= most"));
  EXPECT_THAT(with({{{1, 2}, 1, 2, {1, 1.5}, {1, 2}}}), HasSubstr("although"));
  EXPECT_THAT(with({{{1, 2}, 1, 1, {1.25, 2}, {1, 2}}}), HasSubstr("smallest"));
  EXPECT_THAT(with({{{1, 2}, 1, 1, {1, 2.5}, {1, 2}}}), HasSubstr("smallest"));
  EXPECT_THAT(with({{{1, 2}, 1, 1, {1, 2}, {1, 1.5}}}), HasSubstr("greatest"));
  EXPECT_THAT(with({{{1, 2}, 1, 1, {1, 2}, {0.5, 2}}}), HasSubstr("greatest"));
  EXPECT_THAT(with({{{2, 1}, 1, 1, {2, 1}, {2, 1}}}), HasSubstr("lo <= hi"));
}

}  // namespace
}  // namespace epsnet::certify::eigenvalues_test
