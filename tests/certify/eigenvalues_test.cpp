#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

#if __has_include(<flint/acb_hypgeom.h>)
#include <flint/acb_hypgeom.h>
#else
#include <acb_hypgeom.h>
#endif

#include "certify/check.h"
#include "certify/claims/eigenvalues/eigenfunction.h"
#include "certify/claims/eigenvalues/fields.h"
#include "certify/claims/eigenvalues/forms.h"
#include "certify/claims/eigenvalues/local_functions.h"
#include "certify/file/file.h"
#include "certify/net/labels.h"
#include "certify/net/numbering.h"
#include "certify/net/rules.h"
#include "certify/numbers/inertia.h"
#include "tests/certify/claim_files.h"
#include "tests/certify/reference.h"
#include "tests/support/scale.h"

/// Eigenvalues files. Each rule is broken by a file in which nothing else is wrong. That the numbers are those of the
/// lemmas is in second_checker_eigenvalues_test.cpp, for both checkers.
namespace epsnet::certify::eigenvalues_test {
namespace {

using testing::HasSubstr;
using Document = EigenvaluesDocument;

Document file(const std::string& name) {
  return read_file<Document>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/" + name + ".json");
}
/// The first five eigenvalues of a random octagon, in three intervals, by counts alone.
Document octagon() { return file("octagon-5"); }
/// Its λ_1 by an approximate eigenfunction, and that there is no other below 3.5, by a count.
Document function() { return file("octagon-5-with-a-function"); }
/// Three and four equal eigenvalues of the Bolza surface, by counts alone.
Document bolza() { return file("bolza"); }
/// The first three, by three functions.
Document three_functions() { return file("bolza-with-three-functions"); }

/// λ_1 of the Bolza surface, multiplicity 3, and the next one, multiplicity 4 (A. Strohmaier, V. Uski, An algorithm for
/// the computation of eigenvalues, spectral zeta functions and zeta-determinants on hyperbolic surfaces).
constexpr double kFirst = 3.8388872588421995;
constexpr double kSecond = 5.353601341189;
/// Of the octagon (the trace formula with geodesics up to 14 proves 2.77505 < λ_1 < 2.77509, 3.69 < λ_2).
constexpr double kFirstOfOctagon = 2.77507;

Certificate checked(const Document& document, std::uint64_t max_work = 0) {
  return check(document, {.threads = 2, .max_work = max_work});
}

/// "VERDICT", or "VERDICT: rule".
std::string outcome(const Document& document, std::uint64_t max_work = 0) {
  const Certificate certificate = checked(document, max_work);
  return std::string(name(certificate.verdict)) + (certificate.rule.empty() ? "" : ": " + certificate.rule);
}

/// Of the file that `change` makes of the octagon's.
std::string changed(const std::function<void(Document&)>& change) {
  Document document = octagon();
  change(document);
  return outcome(document);
}

/// What one rule says of it.
std::string verdict_of(const char* rule, const std::function<void(Document&)>& change) {
  Document document = octagon();
  change(document);
  for (const RuleReport& report : checked(document).rules) {
    if (std::string(rule) == report.rule) return std::string(name(report.verdict));
  }
  return "not asked";
}

double above(double x) { return std::nextafter(x, HUGE_VAL); }
double below(double x) { return std::nextafter(x, 0.0); }

TEST(Eigenvalues, TrueFilesAreVerified) {
  for (const char* name : {"octagon-5", "bolza", "octagon-5-of-one-vertex", "octagon-5-from-a-quarter"})
    EXPECT_EQ(outcome(file(name)), "VERIFIED") << name;
}

TEST(Eigenvalues, OfTheBolzaSurfaceAreThoseOfTheLiterature) {
  const Document document = bolza();
  ASSERT_EQ(document.eigenvalues.size(), 2U);
  EXPECT_EQ(document.eigenvalues[0].count, 3U);
  EXPECT_LT(document.eigenvalues[0].in.lower, kFirst);
  EXPECT_GT(document.eigenvalues[0].in.upper, kFirst);
  EXPECT_EQ(document.eigenvalues[1].count, 4U);
  EXPECT_LT(document.eigenvalues[1].in.lower, kSecond);
  EXPECT_GT(document.eigenvalues[1].in.upper, kSecond);
}

TEST(Eigenvalues, ClaimsSayHowManyThereAre) {
  EXPECT_THAT(checked(bolza()).claim, HasSubstr("the first 7 eigenvalues of the Laplacian after 0, with multiplicity, "
                                                "lie in 2 intervals, all others are at least 7.36"));
  EXPECT_THAT(checked(file("octagon-5-from-a-quarter")).claim,
              HasSubstr("eigenvalues of the Laplacian, but 0, are at least 0.25"));
}

// Counts.

TEST(Most, CountsThatAreOneLessAreUndecided) {
  for (const std::size_t i : {1U, 2U, 3U}) {
    EXPECT_EQ(changed([&](Document& d) { --d.at_most[i].count; }), "UNDECIDED: most") << i;
    // One more is no lie. The rows do not follow from it.
    EXPECT_EQ(changed([&](Document& d) { ++d.at_most[i].count; }), "REFUTED: enclosures") << i;
  }
  Document document = octagon();
  --document.at_most[2].count;
  EXPECT_EQ(checked(document).message, "at_most[2]: at most 3 follows");
}

TEST(Most, EigenvaluesAreLessThanBelowAndNotThanSigma) {
  Document document = octagon();
  document.at_most[0].below = document.at_most[0].sigma;
  EXPECT_EQ(outcome(document), "UNDECIDED: most");
  EXPECT_THAT(checked(document).message,
              HasSubstr("at_most[0]: the eigenvalues that are counted are those less than 2.6"));
  // σ beyond the next eigenvalue of the matrix.
  EXPECT_EQ(changed([](Document& d) { d.at_most[0].sigma *= 1.01; }), "UNDECIDED: most");
  EXPECT_EQ(changed([](Document& d) { d.at_most[0].sigma = 1e308; }), "UNDECIDED: most");
  EXPECT_EQ(verdict_of("most", [](Document& d) { d.at_most[0].below = d.at_most[0].sigma = 5e-324; }), "UNDECIDED");
  // So many rows may be negative as there are; but the numbers are too large to tell of any.
  document = octagon();
  document.eigenvalues.clear();
  document.next = 0;
  document.at_most[0] = {1, 431, 1e308};
  EXPECT_EQ(outcome(document), "UNDECIDED: most");
  EXPECT_THAT(checked(document).message, HasSubstr("at_most[0]: not decided: a pivot is too near to 0"));
}

TEST(Least, CountsThatAreOneMoreAreUndecided) {
  for (const std::size_t i : {0U, 1U, 2U}) {
    EXPECT_EQ(changed([&](Document& d) { ++d.at_least[i].count; }), "UNDECIDED: least") << i;
    EXPECT_EQ(changed([&](Document& d) { d.at_least[i].below *= 0.99; }), "UNDECIDED: least") << i;
  }
  EXPECT_EQ(changed([](Document& d) { d.at_least[0].below = 5e-324; }), "UNDECIDED: least");
  EXPECT_EQ(verdict_of("least", [](Document& d) { d.at_least[0].below = 1e308; }), "UNDECIDED");
  Document document = octagon();
  ++document.at_least[2].count;
  EXPECT_EQ(checked(document).message, "at_least[2]: at least 5 follows");
  // λ_0 = 0 is not one of them.
  document = octagon();
  document.at_least[0].below = 1;
  EXPECT_EQ(checked(document).message, "at_least[0]: nothing follows");
}

TEST(Most, RowsAreElsewhereInAnotherOrder) {
  for (const bool reversed : {false, true}) {
    Document document = octagon();
    for (auto* order : {&document.side_order, &document.vertex_order}) {
      if (reversed) std::reverse(order->begin(), order->end());
      if (!reversed) std::shuffle(order->begin(), order->end(), std::mt19937(3));  // NOLINT: the same in every run.
    }
    EXPECT_EQ(outcome(document), "VERIFIED") << reversed;
  }
}

/// Row `order[0]` is the first one: read the other way around, the octagon's order fills more.
TEST(Most, OrdersSayWhichRowIsNext) {
  Document document = octagon();
  const std::uint64_t work = checked(document).counts.work;
  const Document::Order order = document.side_order;
  for (std::uint32_t i = 0; i < order.size(); ++i) document.side_order[order[i]] = i;
  EXPECT_LT(work, checked(document).counts.work);
}

TEST(Most, TheSameForAnyNumberOfThreads) {
  const Document document = octagon();
  EXPECT_EQ(check(document, {.threads = 1}).counts.work, check(document, {.threads = 3}).counts.work);
}

TEST(Most, RulesThatHaveNothingToCountHold) {
  Document document = octagon();
  document.eigenvalues.clear();
  document.next = 0;
  document.at_most.clear();
  document.at_least.clear();
  document.side_order.clear();
  document.vertex_order.clear();
  document.halvings = 12;
  EXPECT_EQ(outcome(document), "VERIFIED");
}

/// What is verified of changed files is true of the octagon.
void mutate(Document& document, std::mt19937& random) {
  const auto below_size = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto change = [&](double& x) {
    const std::array<double, 6> values{above(x), below(x), x * (1 + 1e-6), x * 1.02, x * 0.97, x * 1.2};
    x = values[below_size(values.size())];
  };
  const auto change_count = [&](std::uint32_t& count) { count += below_size(2) == 0 ? 1U : ~0U; };
  auto& most = document.at_most[below_size(document.at_most.size())];
  auto& least = document.at_least[below_size(document.at_least.size())];
  auto& row = document.eigenvalues[below_size(document.eigenvalues.size())];
  switch (below_size(8)) {
    case 0:
      return change(most.below);
    case 1:
      return change(most.sigma);
    case 2:
      return change_count(most.count);
    case 3:
      return change(least.below);
    case 4:
      return change_count(least.count);
    case 5:
      return change(below_size(2) == 0 ? row.in.lower : row.in.upper);
    case 6:
      return change_count(row.count);
    default:
      return change(document.next);
  }
}

TEST(SlowEigenvalues, MutantsThatAreVerifiedAreTrue) {
  // To four digits, by functions.
  constexpr std::array<double, 7> kAll{kFirstOfOctagon, 3.70649, 4.0797, 4.7003, 5.0506, 6.2267, 8.2};
  std::mt19937 random(27);  // NOLINT: the same in every run.
  int verified = 0;
  const int mutants = test::scaled(150);
  for (int i = 0; i < mutants; ++i) {
    Document document = octagon();
    mutate(document, random);
    if (i % 2 == 0) mutate(document, random);
    if (checked(document).verdict != Verdict::verified) continue;
    ++verified;
    std::size_t next = 0;
    for (const auto& row : document.eigenvalues) {
      for (std::uint32_t k = 0; k < row.count; ++k, ++next) {
        ASSERT_LT(next, kAll.size());
        EXPECT_LE(row.in.lower, kAll[next] + 0.005) << i;
        EXPECT_GE(row.in.upper, kAll[next] - 0.005) << i;
      }
    }
    EXPECT_LE(document.next, kAll[next] + 0.005) << i;
  }
  EXPECT_GT(verified, mutants / 20);
  EXPECT_LT(verified, mutants / 2);
}

// Approximate eigenfunctions.

TEST(Eigenfunctions, AreVerified) {
  EXPECT_EQ(outcome(function()), "VERIFIED");
  const Document document = function();
  EXPECT_LT(document.eigenfunctions[0].in.lower, kFirstOfOctagon);
  EXPECT_GT(document.eigenfunctions[0].in.upper, kFirstOfOctagon);
}

TEST(SlowEigenfunctions, OfThreeEqualEigenvaluesAreVerified) {
  EXPECT_EQ(outcome(three_functions()), "VERIFIED");
  // There is no fourth one.
  Document document = three_functions();
  ++document.eigenvalues[0].count;
  EXPECT_EQ(outcome(document), "REFUTED: enclosures");
}

TEST(SlowEigenfunctions, OneFunctionTwiceProvesNothing) {
  Document document = three_functions();
  document.eigenfunctions[0].functions[2] = document.eigenfunctions[0].functions[0];
  EXPECT_EQ(outcome(document), "UNDECIDED: eigenfunctions");
  // A sum of the others.
  document = three_functions();
  auto& functions = document.eigenfunctions[0].functions;
  for (std::size_t i = 0; i < functions[2].size(); ++i) functions[2][i] = functions[0][i] + functions[1][i];
  EXPECT_EQ(outcome(document), "UNDECIDED: eigenfunctions");
}

/// What the functions of a row prove: δ.
double error_of(const Document& document, std::size_t of_row = 0, std::uint64_t genus = 2) {
  constexpr slong kBits = 128;
  const Precision scope(kBits);
  const NetDocument& net = document.net;
  const LabelParts parts = label_parts(check_surface(net.surface).crossings, net.charts, {});
  std::vector<std::uint32_t> numbers(net.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  const auto labels = LabelEvaluator(net, parts).evaluate(numbers, kBits, 4 * kBits, 1);
  const Document::Eigenfunctions& row = document.eigenfunctions.at(of_row);
  const auto order = static_cast<std::uint32_t>(row.functions[0].size() / net.vertices.size() / 2);
  const auto overlaps = Overlaps::make(net, labels, row.radius, order, row.lambda, {}, 2);
  return eigenvalue_error(overlaps.value(), row, genus, {}, 2).value();
}

/// The bounds around the vertices are integrated over at most 4π(g − 1): of nine disks, which are more than twice 4π,
/// nearly all count on a surface of genus 3, and half of them on one of genus 2.
TEST(Eigenfunctions, AreAsWrongAsTheAreaIsLarge) {
  const Document document = function();
  const double of_two = error_of(document);
  const double of_three = error_of(document, 0, 3);
  EXPECT_GT(of_three, 1.1 * of_two);
  EXPECT_LT(of_three, 1.5 * of_two);
  EXPECT_GE(error_of(document, 0, 4), of_three);
  EXPECT_LT(error_of(document, 0, 4), 1.01 * of_three);
}

/// Functions with fewer coefficients, up to this m.
void leave_out_after(Document::Eigenfunctions& row, std::size_t order, std::size_t vertices) {
  for (Document::Coefficients& function : row.functions) {
    const std::size_t each = function.size() / vertices;
    Document::Coefficients fewer;
    for (std::size_t i = 0; i < function.size(); ++i) {
      if (i % each <= 2 * order) fewer.push_back(function[i]);
    }
    function = std::move(fewer);
  }
}

/// Of two rows, one of which proves nothing of its interval, with disks of the same size or others.
TEST(SlowEigenfunctions, EachRowIsAskedWithItsOwnDisks) {
  const Document good = function();
  const std::size_t vertices = good.net.vertices.size();
  for (const double radius : {1.0, 0.97, 1.03}) {
    for (const std::size_t order : {std::size_t{30}, std::size_t{28}}) {
      Document document = good;
      auto& rows = document.eigenfunctions;
      auto other = rows[0];
      other.radius = radius;
      leave_out_after(other, order, vertices);
      for (const bool first : {false, true}) {
        // λ is that of another function, and so narrow an interval does not follow.
        other.lambda = first ? rows[0].in.lower - 0.01 : rows[0].in.upper + 0.01;
        other.in = {other.lambda - 1e-9, other.lambda + 1e-9};
        rows = {first ? other : good.eigenfunctions[0], first ? good.eigenfunctions[0] : other};
        const Certificate certificate = checked(document);
        EXPECT_EQ(certificate.rule, "eigenfunctions");
        const std::string begin =
            "eigenfunctions[" + std::to_string(first ? 0 : 1) + "]: eigenvalues are proved only within ";
        ASSERT_EQ(certificate.message.substr(0, begin.size()), begin) << certificate.message;
        const double found = std::stod(certificate.message.substr(begin.size()));
        EXPECT_NEAR(found / error_of(document, first ? 0 : 1), 1, 1e-9) << radius << ' ' << order << ' ' << first;
      }
    }
  }
}

/// What certify says of the file with its eigenfunction changed.
std::string with_function(const std::function<void(Document::Eigenfunctions&)>& change) {
  Document document = function();
  change(document.eigenfunctions.at(0));
  document.eigenvalues[0].in = document.eigenfunctions[0].in;
  return outcome(document);
}

TEST(SlowEigenfunctions, ThatProveLessAreUndecided) {
  const std::string undecided = "UNDECIDED: eigenfunctions";
  const double more = error_of(function()) * (1 + 1e-9);
  const double less = error_of(function()) * (1 - 1e-9);
  EXPECT_LT(more, 0.01);
  EXPECT_EQ(with_function([&](auto& f) { f.in = {f.lambda - more, f.lambda + more}; }), "VERIFIED");
  EXPECT_EQ(with_function([&](auto& f) { f.in.lower = f.lambda - less; }), undecided);
  EXPECT_EQ(with_function([&](auto& f) { f.in.upper = f.lambda + less; }), undecided);
  EXPECT_EQ(with_function([](auto& f) {
              f.lambda += 0.01;
              f.in = {f.lambda - 0.02, f.lambda + 0.02};
            }),
            undecided);
  const std::size_t each = function().eigenfunctions[0].functions[0].size() / 9;
  EXPECT_EQ(with_function([&](auto& f) { f.functions[0][4 * each] += 0.1; }), undecided);
  // The functions of two vertices exchanged; the function of one of them left out; the constants.
  EXPECT_EQ(with_function([&](auto& f) {
              const auto first = f.functions[0].begin();
              std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(each),
                               first + static_cast<std::ptrdiff_t>(each));
            }),
            undecided);
  EXPECT_EQ(
      with_function([&](auto& f) { std::fill_n(f.functions[0].end() - static_cast<std::ptrdiff_t>(each), each, 0.0); }),
      undecided);
}

TEST(DeepEigenfunctions, OnDisksOfAnotherSizeProveLess) {
  // Disks that hardly overlap, and so large ones that the series is not used.
  EXPECT_EQ(with_function([](auto& f) { f.radius = 0.91; }), "UNDECIDED: eigenfunctions");
  EXPECT_EQ(with_function([](auto& f) { f.radius = 1.99; }), "UNDECIDED: eigenfunctions");
}

/// δ depends neither on a factor nor on the numbers of vertices.
TEST(SlowEigenfunctions, ProveTheSameInOtherWords) {
  const double more = error_of(function()) * (1 + 1e-9);
  EXPECT_EQ(with_function([&](auto& f) {
              for (double& c : f.functions[0]) c *= -1024;
              f.in = {f.lambda - more, f.lambda + more};
            }),
            "VERIFIED");
  Document document = function();
  const std::size_t count = document.net.vertices.size();
  const std::size_t each = document.eigenfunctions[0].functions[0].size() / count;
  const auto renumbered = [&](std::size_t k) { return (k + 4) % count; };
  const auto vertices = document.net.vertices;
  const auto coefficients = document.eigenfunctions[0].functions[0];
  for (std::size_t k = 0; k < count; ++k) {
    document.net.vertices[renumbered(k)] = vertices[k];
    std::copy_n(coefficients.begin() + static_cast<std::ptrdiff_t>(k * each), each,
                document.eigenfunctions[0].functions[0].begin() + static_cast<std::ptrdiff_t>(renumbered(k) * each));
  }
  for (auto& triangle : document.net.triangles) {
    for (std::uint32_t& vertex : triangle.vertex) vertex = static_cast<std::uint32_t>(renumbered(vertex));
  }
  auto& row = document.eigenfunctions[0];
  row.in = document.eigenvalues[0].in = {row.lambda - more, row.lambda + more};
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Eigenfunctions, ThatAreMissingAreMissed) {
  Document document = function();
  document.eigenfunctions.clear();
  EXPECT_EQ(outcome(document), "REFUTED: enclosures");
}

TEST(Eigenfunctions, ThatProveNothingAreNotAskedWithMoreBits) {
  // Disks that hardly overlap, and a function of one vertex.
  Document document = function();
  auto& row = document.eigenfunctions[0];
  row.functions = {Document::Coefficients(std::size_t{9} * 9)};
  row.functions[0][4] = 1;
  const Certificate certificate = checked(document);
  EXPECT_EQ(certificate.verdict, Verdict::undecided);
  EXPECT_EQ(certificate.message, "eigenfunctions[0]: no eigenvalue follows");
}

/// ₂F₁(½ − ir, ½ + ir; m + 1; −s/(1 − s)) by Arb.
Ball reference_factor(double lambda, const Ball& s, std::uint32_t m) {
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
  acb_set_arb(z, s.get());
  acb_sub_ui(value, z, 1, bits);
  acb_div(z, z, value, bits);
  acb_hypgeom_2f1(value, a, b, c, z, 0, bits);
  Ball result(acb_realref(value));
  for (acb_struct* x : {r, a, b, c, z, value}) acb_clear(x);
  return result;
}

Ball from_units(std::int64_t x, int bits) { return scaled(Ball::exactly(x), -bits); }

/// The factors of a point at this |z|², for points up to `greatest`.
std::optional<std::vector<std::int64_t>> factors_at(const RadialFactors& factors, double s, double greatest) {
  const auto point = LocalPoint::of(ComplexBall(sqrt(Ball::exactly(s)), Ball()), Ball::exactly(greatest));
  if (!point) return std::nullopt;
  std::vector<std::int64_t> result;
  factors.set(*point, result);
  return result;
}

TEST(LocalPoints, AreTheNumbersThatTheyStandFor) {
  const Precision scope(160);
  const Ball greatest = Ball::rounded(mpq_class(3, 10));
  const ComplexBall z(Ball::rounded(mpq_class(2, 7)), Ball::rounded(mpq_class(-3, 8)));
  const LocalPoint point = LocalPoint::of(z, greatest).value();
  const Ball s = norm(z);
  const auto near = [](std::int64_t units, int bits, const Ball& x) {
    return certainly_less(abs(Ball::exactly(units) - scaled(x, bits)), Ball::exactly(1)) == Tri::yes;
  };
  EXPECT_TRUE(near(point.x, 62, real(z) / sqrt(greatest)));
  EXPECT_TRUE(near(point.y, 62, imaginary(z) / sqrt(greatest)));
  EXPECT_TRUE(near(point.s, 61, s));
  EXPECT_TRUE(near(point.ratio, 61, s / (1 - s) / (2 * greatest / (1 - greatest))));
  // Not beyond s₀, and not of what is not known.
  EXPECT_FALSE(LocalPoint::of(z, Ball::rounded(mpq_class(2, 10))));
  EXPECT_FALSE(
      LocalPoint::of(ComplexBall(scaled(Ball::exactly(1), -2) + Ball::rounded(mpq_class(1, 3)), Ball()), greatest));
  ComplexBall wide = z;
  arb_add_error_2exp_si(wide.re(), -70);
  EXPECT_TRUE(LocalPoint::of(wide, greatest));
  arb_add_error_2exp_si(wide.re(), -62);
  EXPECT_FALSE(LocalPoint::of(wide, greatest));
  // Each part less than a unit away: known to a quarter of one, and rounded by half of one at most.
  for (const bool is_real : {false, true}) {
    const auto known = [&](double radius) {
      ComplexBall x;
      arb_add_error(is_real ? x.re() : x.im(), Ball::exactly(radius).get());
      return LocalPoint::of(x, Ball::exactly(0.25)).has_value();
    };
    EXPECT_TRUE(known(0x1p-66)) << is_real;
    EXPECT_FALSE(known(1.5 * 0x1p-65)) << is_real;
  }
  // Near the edge of large disks, where x/X changes fastest.
  const auto ratio_known = [](double radius) {
    ComplexBall x(Ball::exactly(0.7071), Ball());
    arb_add_error(x.re(), Ball::exactly(radius).get());
    return LocalPoint::of(x, Ball::exactly(0.5)).has_value();
  };
  EXPECT_TRUE(ratio_known(0x1p-66));
  EXPECT_FALSE(ratio_known(1.3 * 0x1p-65));
  // Perhaps beyond s₀.
  ComplexBall half_known(Ball::exactly(0.5), Ball());
  EXPECT_TRUE(LocalPoint::of(half_known, Ball::exactly(0.25)));
  arb_add_error_2exp_si(half_known.re(), -70);
  EXPECT_FALSE(LocalPoint::of(half_known, Ball::exactly(0.25)));
}

TEST(RadialFactors, AreHypergeometricFunctions) {
  const Precision scope(160);
  constexpr std::uint32_t kOrder = 40;
  for (const double lambda : {0.015625, 0.25, 2.75, 12.0}) {
    for (const double greatest : {0.0625, 0.375, 0.5}) {
      const RadialFactors factors = RadialFactors::make(Ball::exactly(lambda), kOrder, Ball::exactly(greatest)).value();
      ASSERT_EQ(factors.order(), kOrder);
      for (const double share : {0.0, 0.25, 0.99, 1 - 1e-15}) {
        const std::vector<std::int64_t> found = factors_at(factors, share * greatest, greatest).value();
        for (const std::uint32_t m : {0U, 1U, 2U, 17U, 40U}) {
          const Ball error = abs(found[m] - scaled(reference_factor(lambda, Ball::exactly(share * greatest), m), 61));
          EXPECT_LE(outer_interval(error).upper, factors.errors()[m]) << lambda << ' ' << greatest << ' ' << m;
          EXPECT_LT(factors.errors()[m], 1000 * std::exp(lambda * greatest)) << lambda << ' ' << greatest << ' ' << m;
        }
      }
    }
  }
}

/// "But for a factor" in Lemma 37.7.
constexpr double kFactor = 1 + 0x1p-15;

/// Lemma 37.7 (a), e for the series of F_m: terms end where one is less than 2⁻⁶¹ for x₀, and the following decrease.
double series_error(double lambda, double m, double greatest) {
  const double x = greatest / (1 - greatest);
  const double ratio = x / std::min(1.0, 2 * x);
  double term = 1;
  double error = 0;
  for (int i = 0; i * (m + 1) <= lambda || term >= 0x1p-61; ++i) {
    error = error * ratio + 4.5;  // e_n = 0 to e_0: as many steps as terms.
    term *= x * (lambda + i * (i + 1)) / ((i + 1) * (m + 1 + i));
  }
  return error + 1;
}

/// Lemma 37.7 (b), by m.
std::vector<double> factor_errors(double lambda, std::size_t order, double greatest) {
  int bits = 61;
  while (std::ldexp(lambda, bits) >= 0x1p62) --bits;
  std::vector<double> f(order + 2);
  std::vector<double> d(order + 2);
  f[order] = series_error(lambda, static_cast<double>(order), greatest);
  f[order + 1] = series_error(lambda, static_cast<double>(order) + 1, greatest);
  d[order + 1] = f[order] + f[order + 1];
  for (std::size_t m = order; m > 0; --m) {
    const double mu = lambda / static_cast<double>(m * (m + 1));
    d[m] = greatest * d[m + 1] + 2 + greatest * mu * f[m + 1] + (mu + greatest * std::ldexp(1, 61 - bits) + 0.5) + 0.5;
    d[m] *= kFactor;
    f[m - 1] = (f[m] + d[m]) * kFactor;
  }
  f.pop_back();
  return f;
}

TEST(RadialFactors, HaveTheErrorsOfTheLemma) {
  const Precision scope(160);
  for (const double lambda : {0.015625, 2.75, 13.5, 300.0}) {
    for (const double greatest : {0.0078125, 0.375, 0.5}) {
      const auto factors = RadialFactors::make(Ball::exactly(lambda), 60, Ball::exactly(greatest));
      EXPECT_EQ(factors.has_value(), lambda * greatest < 7);
      if (!factors) continue;
      const std::vector<double> wanted = factor_errors(lambda, 60, greatest);
      ASSERT_EQ(factors->errors().size(), wanted.size());
      for (std::size_t m = 0; m < wanted.size(); ++m)
        EXPECT_NEAR(factors->errors()[m] / wanted[m], 1, 1e-9) << lambda << ' ' << greatest << ' ' << m;
    }
  }
}

/// A function of each vertex alone, at m and of the given size, and one that is not 0 at any.
Document::Eigenfunctions functions_of_one_vertex(double lambda, std::size_t vertices, std::size_t order, double size) {
  const std::size_t each = 2 * order + 1;
  Document::Eigenfunctions row{{2, 3}, lambda, 1, {}};
  for (std::size_t j = 0; j < 3; ++j) {
    Document::Coefficients function(vertices * each);
    function[j * each] = size;
    function[j * each + 2 * (j + 3)] = -size;  // β
    function[j * each + 2 * (j + 5) - 1] = size;
    row.functions.push_back(function);
    size *= 0x1p20;
  }
  return row;
}

TEST(LocalValues, HaveTheErrorsOfTheLemma) {
  const Precision scope(160);
  constexpr std::size_t kVertices = 4;
  constexpr std::size_t kOrder = 30;
  constexpr double kGreatest = 0.25;
  const Document::Eigenfunctions row = functions_of_one_vertex(20, kVertices, kOrder, 1.75);
  const LocalValues values = LocalValues::make(row, kVertices, Ball::exactly(kGreatest)).value();
  const std::vector<double> of_factors = factor_errors(row.lambda, kOrder, kGreatest);
  for (std::size_t j = 0; j < row.functions.size(); ++j) {
    for (std::size_t vertex = 0; vertex < kVertices; ++vertex) {
      const double* own = row.functions[j].data() + vertex * (2 * kOrder + 1);
      double sum = 0;
      double error = 3 * (kOrder + 1);
      for (std::size_t m = 0; m <= kOrder; ++m) {
        const double size = (m == 0 ? std::abs(own[0]) : std::abs(own[2 * m - 1]) + std::abs(own[2 * m])) *
                            std::pow(kGreatest, static_cast<double>(m) / 2) / std::ldexp(values.unit(j), 62);
        sum += size;
        error += size * (1.5 * static_cast<double>(m) + 2 * of_factors[m]);
      }
      EXPECT_LT(sum, 1) << j << ' ' << vertex;
      EXPECT_NEAR(values.error(j, vertex) / (values.unit(j) * error * kFactor), 1, 1e-9) << j << ' ' << vertex;
    }
  }
}

/// The multiples that are nearest: an error of ½ for each product.
TEST(LocalValues, AreRoundedToTheNearest) {
  const Precision scope(160);
  Document::Eigenfunctions row{{2, 3}, 2.75, 1, {Document::Coefficients(2 * 40 + 1)}};
  row.functions[0][0] = 0.6875;
  const LocalValues values = LocalValues::make(row, 1, Ball::exactly(0.25)).value();
  double sum = 0;
  for (int i = 0; i < 100; ++i) {
    const LocalPoint point =
        LocalPoint::of(ComplexBall(Ball::exactly(0.0049 * i), Ball()), Ball::exactly(0.25)).value();
    std::vector<std::int64_t> factors;
    values.factors().set(point, factors);
    std::vector<std::int64_t> found;
    values.set(0, point, factors, found);
    const Ball exact = from_units(factors[0], 61) * Ball::exactly(0.6875) / Ball::exactly(values.unit(0));
    const double error = outer_interval(Ball::exactly(found[0]) - exact).upper;
    EXPECT_LE(std::abs(error), 0.5 + 1e-6);
    sum += error;
  }
  EXPECT_LT(std::abs(sum), 20);
}

/// Lemma 37.4 (b) and (c), for values with any error, which functions of a file have not.
TEST(DiskWaves, AreThoseOfTheLemma) {
  const Precision scope(128);
  for (const double lambda : {0.5, 4.0, 30.0}) {
    for (const int waves : {1, 5, 12}) {
      const double t = 0.25;
      const double sinh_wider = (waves + 1) / std::sqrt(lambda);
      const double cosh_wider = std::hypot(1, sinh_wider);
      const double z = t / (sinh_wider / (1 + cosh_wider));
      std::vector<double> roots;
      std::vector<double> factors;
      const int n = 2 * waves;
      for (int k = 0; k < n; ++k) {
        roots.push_back(std::cos(2 * M_PI * k / n));
        roots.push_back(std::sin(2 * M_PI * k / n));
      }
      for (int m = 0; m < waves; ++m) factors.push_back(1 - 0.7 / (m + 1));
      const DiskWaves made(Ball::exactly(lambda), Ball::exactly(t * t), factors, roots);
      std::vector<double> values(static_cast<std::size_t>(n));
      if (z >= 1) {
        EXPECT_EQ(made.bounds(values, 0, 1).value, HUGE_VAL);
        EXPECT_EQ(made.bounds(values, 0, 1).gradient, HUGE_VAL);
        continue;
      }
      const auto expect = [&](double error, double total) {
        const double tail =
            2 * total * std::exp(lambda * (cosh_wider - 1) / (waves + 1)) * std::pow(z, waves) / (1 - z);
        FunctionBounds wanted{tail, tail * ((waves + z / (1 - z)) / t + lambda * t)};
        double squares = 0;
        double slopes = 0;
        for (int m = 1 - waves; m < waves; ++m) {
          std::complex<double> sum = 0;
          for (int k = 0; k < n; ++k)
            sum += values[static_cast<std::size_t>(k)] * std::polar(1.0, -2 * M_PI * m * k / n);
          const double size = std::abs(m);
          const double factor = factors[static_cast<std::size_t>(std::abs(m))];
          const double e = (std::abs(sum) / n + tail) / factor;
          wanted.value += e;
          wanted.gradient += e * (size / t + lambda * t);
          squares += 1 / (factor * factor);
          slopes += std::pow((size / t + lambda * t) / factor, 2);
        }
        wanted.value += error * std::sqrt(squares);
        wanted.gradient += error * std::sqrt(slopes);
        const FunctionBounds found = made.bounds(values, error, total);
        EXPECT_NEAR(found.value, wanted.value, 1e-8 * wanted.value) << lambda << ' ' << waves;
        EXPECT_NEAR(found.gradient, wanted.gradient, 1e-8 * wanted.gradient) << lambda << ' ' << waves;
        EXPECT_GE(found.value, wanted.value) << lambda << ' ' << waves;
        EXPECT_GE(found.gradient, wanted.gradient) << lambda << ' ' << waves;
      };
      expect(1, 0);
      expect(0, 1);
      for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::sin(static_cast<double>(k * k) + 0.3);
      expect(0, 0);
      expect(0.01, 0.25);
      // Values that have no wave but the one of order J: what is left is rounding.
      for (std::size_t k = 0; k < values.size(); ++k) values[k] = k % 2 == 0 ? 3 : -3;
      double all = 0;
      for (int m = 1 - waves; m < waves; ++m) all += 1 / factors[static_cast<std::size_t>(std::abs(m))];
      EXPECT_GE(made.bounds(values, 0, 0).value, all * 3 * (n + 8) * 0x1p-52);
      values.front() += 1;
      factors.back() = -factors.back();
      const DiskWaves unknown(Ball::exactly(lambda), Ball::exactly(t * t), factors, roots);
      EXPECT_EQ(unknown.bounds(values, 1, 1).value, HUGE_VAL);
    }
  }
}

/// Where functions are 0 around both vertices, their difference is what their errors are.
TEST(Mismatches, AreAtLeastWhatTheValuesMayBeWrong) {
  const Precision scope(128);
  const NetDocument net = function().net;
  const LabelParts parts = label_parts(check_surface(net.surface).crossings, net.charts, {});
  std::vector<std::uint32_t> numbers(net.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  const auto labels = LabelEvaluator(net, parts).evaluate(numbers, 128, 512, 1);
  constexpr std::uint32_t kOrder = 20;
  const Document::Eigenfunctions row = functions_of_one_vertex(7, net.vertices.size(), kOrder, 1);
  const Overlaps overlaps = Overlaps::make(net, labels, row.radius, kOrder, row.lambda, {}, 1).value();
  const LocalValues values = LocalValues::make(row, net.vertices.size(), overlaps.greatest()).value();
  const Ball lambda = Ball::exactly(row.lambda);
  const Mismatch mismatch(overlaps, values, lambda);
  int asked = 0;
  for (const Overlaps::Pair& pair : overlaps.pairs()) {
    double squares = 0;
    for (std::uint32_t m = 0; m < pair.waves; ++m)
      squares += (m == 0 ? 1 : 2) / std::pow(outer_interval(reference_factor(row.lambda, pair.s, m)).lower, 2);
    const auto bounds = mismatch(pair, {0, 0, 0});
    for (std::size_t j = 0; j < 3; ++j) {
      const double error = (values.error(j, pair.vertex) + values.error(j, pair.other)) * std::sqrt(squares);
      if (pair.vertex == j || pair.other == j) {
        EXPECT_GT(bounds[j].value, 1e6 * error);
      } else {
        EXPECT_NEAR(bounds[j].value / error, 1, 1e-6) << j;
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 20);
}

TEST(RadialFactors, AreNotMadeForWhatTheyAreNotFor) {
  const Precision scope(128);
  const auto made = [](double lambda, std::uint32_t order, double greatest) {
    return RadialFactors::make(Ball::exactly(lambda), order, Ball::exactly(greatest)).has_value();
  };
  EXPECT_TRUE(made(2, 30, 0.5));
  EXPECT_FALSE(made(2, 30, above(0.5)));
  // Too few bits for the units.
  const auto rough = [](slong bits) {
    const Precision few(bits);
    return RadialFactors::make(Ball::exactly(2.75), 30, Ball::exactly(0.375)).has_value();
  };
  EXPECT_TRUE(rough(100));
  EXPECT_FALSE(rough(48));
  // A series of order 1 that would take too long.
  EXPECT_FALSE(made(1, 1, 0.5));
  // Products of λ and s that are too large.
  EXPECT_TRUE(made(13.9, 60, 0.5));
  EXPECT_FALSE(made(14, 60, 0.5));
  // Errors that are too large, and a series of too many terms.
  EXPECT_TRUE(made(65'535, 3000, 0.0001));
  EXPECT_FALSE(made(65'536, 3000, 0.0001));
  EXPECT_TRUE(made(100'000, 3000, 0.00005));
  EXPECT_TRUE(made(100'000, 200, 0.00005));
  EXPECT_FALSE(made(100'500, 200, 0.00005));
  // Coefficients that are too large.
  EXPECT_FALSE(made(50, 2, 0.12));
  // Those of F_m for x = 1 add up to less than 2.9, or to less than 4, and none is greater than 1.5.
  for (std::uint32_t order = 4; order < 60; ++order) {
    double sum = 0;
    double term = 1;
    for (int i = 0; i < 500; ++i) {
      sum += term;
      term *= (13.5 + i * (i + 1)) / ((i + 1) * (order + 1.0 + i));
    }
    EXPECT_EQ(made(13.5, order, 0.5), sum < 2.9) << order << ' ' << sum;
  }
}

TEST(LocalValues, AreSumsOfTheirWavesWithTheErrorsThatTheySay) {
  const Precision scope(160);
  constexpr std::size_t kVertices = 3;
  constexpr std::size_t kOrder = 12;
  constexpr std::size_t kEach = 2 * kOrder + 1;
  const Ball greatest = Ball::exactly(0.25);
  std::mt19937 random(7);  // NOLINT: the same in every run.
  const auto number = [&] { return (static_cast<double>(random()) / 0x1p31 - 1) / 3; };
  for (const double size : {1.0, 1e-30, 1e40}) {
    Document::Eigenfunctions row{{2, 3}, 2.75, 0.8, {}};
    for (int j = 0; j < 2; ++j) {
      Document::Coefficients function(kVertices * kEach);
      for (std::size_t i = 0; i < function.size(); ++i) {
        const auto m = static_cast<double>((i % kEach + 1) / 2);
        function[i] = size * number() * std::pow(1.5, m);
      }
      row.functions.push_back(function);
    }
    const LocalValues values = LocalValues::make(row, kVertices, greatest).value();
    ASSERT_EQ(values.count(), 2U);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
      const std::size_t vertex = random() % kVertices;
      const double angle = 20 * number();
      const double radius = i % 2 == 0 ? 0.5 : 0.5 * std::abs(number());
      const ComplexBall z(Ball::exactly(radius * 0.9999 * std::cos(angle)),
                          Ball::exactly(radius * 0.9999 * std::sin(angle)));
      const LocalPoint point = LocalPoint::of(z, greatest).value();
      std::vector<std::int64_t> factors;
      values.factors().set(point, factors);
      std::vector<std::int64_t> found;
      values.set(vertex, point, factors, found);
      for (std::size_t j = 0; j < 2; ++j) {
        Ball sum;
        ComplexBall power(Ball::exactly(1), Ball());
        for (std::size_t m = 0; m <= kOrder; ++m) {
          const double* own = row.functions[j].data() + vertex * kEach;
          const Ball factor = reference_factor(row.lambda, norm(z), static_cast<std::uint32_t>(m));
          const Ball alpha = Ball::exactly(own[m == 0 ? 0 : 2 * m - 1]);
          const Ball beta = Ball::exactly(m == 0 ? 0 : own[2 * m]);
          sum += factor * (alpha * real(power) + beta * imaginary(power));
          power = power * z;
        }
        const double error = outer_interval(abs(found[j] - sum / Ball::exactly(values.unit(j)))).upper;
        const double allowed = values.error(j, vertex) / values.unit(j);
        EXPECT_LE(error, allowed) << size << ' ' << i;
        worst = std::max(worst, allowed);
      }
    }
    EXPECT_LT(worst, 400);
  }
  // Numbers that are too large, and one that is not.
  Document::Eigenfunctions row{{2, 3}, 2.75, 0.8, {Document::Coefficients(kVertices * kEach)}};
  EXPECT_TRUE(LocalValues::make(row, kVertices, greatest));
  row.functions[0].back() = 0x1p20;
  ASSERT_TRUE(LocalValues::make(row, kVertices, greatest));
  EXPECT_GT(LocalValues::make(row, kVertices, greatest)->unit(0), 0x1p20 * std::pow(0.5, kOrder) * 0x1p-62);
  row.functions[0].back() = 0;
  row.functions[0][3] = 0x1p499;
  EXPECT_TRUE(LocalValues::make(row, kVertices, greatest));
  row.functions[0][3] = 0x1p503;
  EXPECT_FALSE(LocalValues::make(row, kVertices, greatest));
  row.functions[0][3] = std::numeric_limits<double>::max();
  row.functions[0][4] = std::numeric_limits<double>::max();
  EXPECT_FALSE(LocalValues::make(row, kVertices, greatest));
}

/// The octagon's, for functions of this order.
std::optional<Overlaps> overlaps_of_octagon(double radius, std::uint32_t order, slong bits) {
  const Precision scope(bits);
  const NetDocument net = function().net;
  const LabelParts parts = label_parts(check_surface(net.surface).crossings, net.charts, {});
  std::vector<std::uint32_t> numbers(net.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  const auto labels = LabelEvaluator(net, parts).evaluate(numbers, bits, 4 * bits, 1);
  return Overlaps::make(net, labels, radius, order, 2.75, {}, 1);
}

/// The lifts near each vertex of a net.
std::optional<std::vector<std::vector<NearVertex>>> near_in(const NetDocument& net, double distance, slong bits);

/// Each pair once, also those of a vertex and its own lifts, and equally many points around each, in order.
TEST(Overlaps, AreCirclesAroundMidpoints) {
  constexpr std::uint32_t kOrder = 40;
  for (const double radius : {1.0, 1.99}) {
    const Overlaps overlaps = overlaps_of_octagon(radius, kOrder, 160).value();
    const auto near = near_in(function().net, 0.9 + radius, 160).value();
    const Precision scope(160);
    const double scale = std::ldexp(std::sqrt(outer_interval(overlaps.greatest()).upper), -62);
    const double reach = std::cosh(0.9) + std::cosh(radius);
    std::size_t next = 0;
    std::size_t same = 0;
    std::set<std::uint32_t> waves;
    for (std::uint32_t vertex = 0; vertex < near.size(); ++vertex) {
      for (const NearVertex& lift : near[vertex]) {
        if (lift.vertex < vertex) continue;
        same += lift.vertex == vertex ? 1 : 0;
        ASSERT_LT(next, overlaps.pairs().size());
        const Overlaps::Pair& pair = overlaps.pairs()[next++];
        ASSERT_EQ(pair.vertex, vertex);
        ASSERT_EQ(pair.other, lift.vertex);
        const auto number = [](const ComplexBall& z) {
          return std::complex(outer_interval(real(z)).upper, outer_interval(imaginary(z)).upper);
        };
        const std::complex<double> a = number(lift.isometry.a);
        const std::complex<double> b = number(lift.isometry.b);
        const double half = std::asinh(std::abs(b));  // Of the distance.
        const std::complex<double> middle = std::polar(std::tanh(half / 2), std::arg(b / std::conj(a)));
        const double t = std::tanh(std::acosh(reach / (2 * std::cosh(half))) / 2);
        EXPECT_NEAR(outer_interval(pair.s).upper, t * t, 1e-12);
        EXPECT_NEAR(std::ldexp(static_cast<double>(pair.edge.s), -61), t * t, 1e-12);
        waves.insert(pair.waves);
        const std::size_t n = std::size_t{2} * pair.waves;
        ASSERT_EQ(overlaps.points(pair).size(), n);
        const std::vector<double>& roots = overlaps.roots_of_unity(pair.waves);
        ASSERT_EQ(roots.size(), 2 * n);
        for (std::size_t k = 0; k < n; ++k) {
          const auto root = std::polar(1.0, 2 * M_PI * static_cast<double>(k) / static_cast<double>(n));
          EXPECT_LT(std::abs(std::complex(roots[2 * k], roots[2 * k + 1]) - root), 1e-14);
          const std::complex<double> own = (t * root + middle) / (1.0 + std::conj(middle) * t * root);
          const std::complex<double> other = (std::conj(a) * own - b) / (a - std::conj(b) * own);
          const auto place = [&](const LocalPoint& point) {
            return scale * std::complex(static_cast<double>(point.x), static_cast<double>(point.y));
          };
          EXPECT_LT(std::abs(place(overlaps.points(pair)[k].own) - own), 1e-11);
          EXPECT_LT(std::abs(place(overlaps.points(pair)[k].other) - other), 1e-11);
        }
      }
    }
    EXPECT_EQ(next, overlaps.pairs().size());
    EXPECT_EQ(same > 0, radius > 1);
    EXPECT_GT(waves.size(), 1U);
  }
}

/// With few bits no points, or the same: a unit beside them at most on both sides.
TEST(Overlaps, AreNotMadeOfPointsThatAreNotKnown) {
  const Overlaps wanted = overlaps_of_octagon(1, 3, 160).value();
  int made = 0;
  for (slong bits = 64; bits <= 88; bits += 3) {
    const auto found = overlaps_of_octagon(1, 3, bits);
    if (!found) continue;
    ++made;
    ASSERT_EQ(found->pairs().size(), wanted.pairs().size());
    for (std::size_t i = 0; i < wanted.pairs().size(); ++i) {
      const auto points = found->points(found->pairs()[i]);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Overlaps::Point& other = wanted.points(wanted.pairs()[i])[k];
        EXPECT_LE(std::abs(points[k].own.x - other.own.x), 2) << bits;
        EXPECT_LE(std::abs(points[k].other.y - other.other.y), 2) << bits;
      }
    }
  }
  EXPECT_GT(made, 0);
  EXPECT_LT(made, 9);
}

/// Balls of few bits place lifts with errors that Lemma 37.2 does not allow.
TEST(Overlaps, AreNotMadeOfLiftsThatAreNotKnown) {
  const Document document = function();
  const NetDocument& net = document.net;
  const auto made = [&](slong bits) {
    const Precision scope(bits);
    const LabelParts parts = label_parts(check_surface(net.surface).crossings, net.charts, {});
    std::vector<std::uint32_t> numbers(net.labels.size());
    std::iota(numbers.begin(), numbers.end(), 1U);
    const auto labels = LabelEvaluator(net, parts).evaluate(numbers, bits, 4 * bits, 1);
    return Overlaps::make(net, labels, document.eigenfunctions.at(0).radius, 8, 2.75, {}, 1).has_value();
  };
  EXPECT_TRUE(made(128));
  EXPECT_FALSE(made(48));
}

/// The inequalities of docs/proof.md, Lemma 37.1, at many places; derivatives by differences.
TEST(RadialFactors, SatisfyTheirBounds) {
  const Precision scope(128);
  for (const double lambda : {0.1, 2.75, 12.0}) {
    const RadialFactors made = RadialFactors::make(Ball::exactly(lambda), 30, Ball::exactly(0.5)).value();
    const auto functions = [&](double rho) {
      const double t = std::tanh(rho / 2);
      std::vector<double> result;
      double power = 1;
      const std::vector<std::int64_t> factors = factors_at(made, t * t, 0.5).value();
      for (const std::int64_t factor : factors) {
        result.push_back(power * std::ldexp(static_cast<double>(factor), -61));
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

/// The lifts near each vertex of a net.
std::optional<std::vector<std::vector<NearVertex>>> near_in(const NetDocument& net, double distance, slong bits) {
  const Precision scope(bits);
  const LabelParts parts = label_parts(check_surface(net.surface).crossings, net.charts, {});
  std::vector<std::uint32_t> numbers(net.labels.size());
  std::iota(numbers.begin(), numbers.end(), 1U);
  const auto labels = LabelEvaluator(net, parts).evaluate(numbers, bits, 4 * bits, 1);
  return near_vertices(net, labels, Ball::exactly(distance), {}, 2);
}

/// Those nearer than 1.5 that a search for others finds, too; and each is seen from both of its ends.
TEST(NearVertices, AreAllThatAreNear) {
  const NetDocument net = function().net;
  const auto near = near_in(net, 1.5, 128).value();
  const auto more = near_in(net, 3, 128).value();
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

TEST(NearVertices, AreTheEndsOfEdgesHoweverShortOthersAre) {
  // Loops around a cuff of length 0.5; whichever vertex and whichever triangle are the first ones, or the last.
  NetDocument net = read_file<GeodesicsDocument>(std::string(EPSNET_TEST_DATA) + "/geodesics/three-cuffs.json").net;
  constexpr double kDistance = 1.3;
  const auto count = static_cast<std::uint32_t>(net.vertices.size());
  std::vector<std::uint32_t> order(net.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::rotate(order.begin(), order.begin() + 5, order.end());
  for (std::uint32_t other = 0; other < count; ++other) {
    std::rotate(net.vertices.begin(), net.vertices.begin() + 1, net.vertices.end());
    for (auto& triangle : net.triangles) {
      for (std::uint32_t& v : triangle.vertex) v = (v + count - 1) % count;
    }
    net = with_triangles_in_order(net, order);
    const auto near = near_in(net, kDistance, 128).value();
    const Reference reference(net);
    double shortest = kDistance;
    for (std::uint32_t dart = 0; dart < 3 * net.triangles.size(); ++dart) {
      const auto z = reference.corners(dart / 3);
      const auto square = static_cast<double>(squared_half_sinh(z[dart % 3], z[(dart + 1) % 3]));
      const double length = 2 * std::asinh(std::sqrt(square));
      shortest = std::min(shortest, length);
      if (length > kDistance) continue;
      const auto& lifts = near[start(net, dart)];
      EXPECT_TRUE(std::any_of(lifts.begin(), lifts.end(),
                              [&](const NearVertex& lift) {
                                return lift.vertex == start(net, next_dart(dart)) &&
                                       std::abs(outer_interval(lift.sinh_squared).lower / square - 1) < 1e-9;
                              }))
          << other << ", dart " << dart;
    }
    EXPECT_LT(shortest, 0.6);
  }
}

TEST(NearVertices, NeedBits) {
  const NetDocument net = function().net;
  EXPECT_FALSE(near_in(net, 3, 4));
}

// Inertia.

/// A symmetric matrix, by its entries on and below the diagonal.
using Entries = std::vector<MatrixEntry>;

std::vector<std::vector<double>> dense(std::uint32_t size, const Entries& entries) {
  std::vector<std::vector<double>> m(size, std::vector<double>(size));
  for (const auto& [row, column, value, error] : entries) {
    m[row][column] += value;
    if (row != column) m[column][row] += value;
  }
  return m;
}

/// Eigenvalues by Jacobi's rotations.
std::vector<double> eigenvalues(std::vector<std::vector<double>> m) {
  const std::size_t n = m.size();
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        if (m[p][q] == 0) continue;
        const double angle = std::atan2(2 * m[p][q], m[q][q] - m[p][p]) / 2;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        for (std::size_t k = 0; k < n; ++k) {
          const double x = m[k][p];
          const double y = m[k][q];
          m[k][p] = c * x - s * y;
          m[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double x = m[p][k];
          const double y = m[q][k];
          m[p][k] = c * x - s * y;
          m[q][k] = s * x + c * y;
        }
      }
    }
  }
  std::vector<double> result;
  for (std::size_t i = 0; i < n; ++i) result.push_back(m[i][i]);
  return result;
}

std::uint32_t less_than(const std::vector<double>& values, double x) {
  return static_cast<std::uint32_t>(std::count_if(values.begin(), values.end(), [&](double y) { return y < x; }));
}

double unit(std::mt19937& random) { return static_cast<double>(static_cast<int>(random() % 2001) - 1000) / 1000; }

/// Entries at random places, some twice, and some on the diagonal.
Entries random_entries(std::uint32_t size, std::uint32_t count, double error, std::mt19937& random) {
  Entries entries;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto x = static_cast<std::uint32_t>(random() % size);
    const auto y = static_cast<std::uint32_t>(random() % size);
    entries.push_back({std::max(x, y), std::min(x, y), unit(random), error});
  }
  for (std::uint32_t i = 0; i < size; ++i) entries.push_back({i, i, 2 * unit(random), error});
  return entries;
}

Entries permuted(Entries entries, const std::vector<std::uint32_t>& order) {
  for (auto& [row, column, value, error] : entries) {
    const auto [x, y] = std::minmax(order[row], order[column]);
    row = y;
    column = x;
  }
  return entries;
}

RC_GTEST_PROP(SparseMatrices, HaveAsManyNegativeEigenvaluesAsDenseOnes, ()) {
  const auto size = static_cast<std::uint32_t>(*rc::gen::inRange(1, 45));
  const auto count = static_cast<std::uint32_t>(*rc::gen::inRange(0, 150));
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const double error = *rc::gen::element(0.0, 1e-9, 1e-3);
  const Entries entries = random_entries(size, count, error, random);
  const auto values = eigenvalues(dense(size, entries));
  // By how much eigenvalues may be wrong: the sums of errors in rows.
  std::vector<double> errors(size);
  for (const auto& entry : entries) {
    errors[entry.row] += entry.error;
    if (entry.row != entry.column) errors[entry.column] += entry.error;
  }
  const double wrong = *std::max_element(errors.begin(), errors.end()) + 1e-6;
  std::vector<std::uint32_t> order(size);
  std::iota(order.begin(), order.end(), 0U);
  std::size_t proved = 0;
  for (int i = 0; i < 3; ++i) {
    const SparseMatrix matrix(size, permuted(entries, order));
    const Inertia upper = matrix.negative_eigenvalues(Bound::upper, {}, 1);
    const Inertia lower = matrix.negative_eigenvalues(Bound::lower, {}, 1);
    // Impossible ones are wanted, so that all is done that can be done: it is still true.
    const Inertia finer_upper = matrix.negative_eigenvalues(Bound::upper, {}, 1, 0);
    const Inertia finer_lower = matrix.negative_eigenvalues(Bound::lower, {}, 1, size);
    EXPECT_EQ(finer_upper.proved, upper.proved);
    EXPECT_EQ(finer_lower.proved, lower.proved);
    if (error == 0 && upper.proved) RC_ASSERT(finer_upper.negative >= less_than(values, -1e-9));
    if (error == 0 && lower.proved) RC_ASSERT(finer_lower.negative <= less_than(values, 1e-9));
    // The true matrix may have any eigenvalue within the error, and less need not be proved.
    if (upper.proved) {
      RC_ASSERT(upper.negative >= less_than(values, error == 0 ? -1e-9 : 0));
      RC_ASSERT(upper.negative <= less_than(values, 2 * wrong));
    }
    if (lower.proved) {
      RC_ASSERT(lower.negative <= less_than(values, 1e-9));
      RC_ASSERT(lower.negative >= less_than(values, -2 * wrong));
    }
    proved += (upper.proved ? 1 : 0) + (lower.proved ? 1 : 0);
    std::shuffle(order.begin(), order.end(), random);
  }
  RC_TAG(proved);
}

TEST(SparseMatrices, ErrorsMoveEigenvaluesOutward) {
  const auto count = [](double value, double error, Bound bound) {
    return SparseMatrix(1, {{0, 0, value, error}}).negative_eigenvalues(bound, {}, 1).negative;
  };
  EXPECT_EQ(count(1, 0.99, Bound::upper), 0U);
  EXPECT_EQ(count(1, 1.01, Bound::upper), 1U);
  EXPECT_EQ(count(-1, 0.99, Bound::lower), 1U);
  EXPECT_EQ(count(-1, 1.01, Bound::lower), 0U);
  EXPECT_EQ(count(-1, 5, Bound::upper), 1U);
  EXPECT_EQ(count(1, 5, Bound::lower), 0U);
  // The errors of a row are those of both of its sides, and of all entries of one place.
  const auto of_two = [](double error, Bound bound) {
    const double diagonal = bound == Bound::upper ? 1 : -1;
    return SparseMatrix(2, {{0, 0, diagonal, 0}, {1, 1, diagonal, 0}, {1, 0, 0.25, error}, {1, 0, -0.25, error}})
        .negative_eigenvalues(bound, {}, 1)
        .negative;
  };
  EXPECT_EQ(of_two(0.49, Bound::upper), 0U);
  EXPECT_EQ(of_two(0.51, Bound::upper), 2U);
  EXPECT_EQ(of_two(0.49, Bound::lower), 2U);
  EXPECT_EQ(of_two(0.51, Bound::lower), 0U);
}

/// The error of the diagonal is the sum of all errors of a row, wherever the row is and whichever of them are of its
/// column.
TEST(SparseMatrices, ErrorsOfARowAddUp) {
  for (std::uint32_t centre = 0; centre < 4; ++centre) {
    for (const auto& [value, negative] : {std::pair{0.89, 1U}, std::pair{0.91, 0U}}) {
      Entries upper{{centre, centre, value, 0}};
      Entries lower{{centre, centre, -value, 0}};
      for (std::uint32_t leaf = 0; leaf < 4; ++leaf) {
        if (leaf == centre) continue;
        for (Entries* entries : {&upper, &lower})
          entries->push_back({std::max(leaf, centre), std::min(leaf, centre), 0, 0.3});
        upper.push_back({leaf, leaf, 10, 0});
        lower.push_back({leaf, leaf, -10, 0});
      }
      EXPECT_EQ(SparseMatrix(4, upper).negative_eigenvalues(Bound::upper, {}, 1).negative, negative) << centre;
      EXPECT_EQ(SparseMatrix(4, lower).negative_eigenvalues(Bound::lower, {}, 1).negative, 4 - negative) << centre;
    }
  }
}

/// A hub and leaves, each of which takes less than half a unit of the last place off the hub: 65,535 of these are more
/// than it has. Every leaf is an addition, and the roundings of all of them count.
TEST(SparseMatrices, RoundingsOfEachChildCount) {
  constexpr std::uint32_t kHub = 1 << 16;
  const double hub = std::ldexp(1 + 0x1p-20, 80);
  const double leaf = 0.499 * 0x1p28;
  const double lost = (kHub - 1) * leaf;
  Entries entries{{kHub, kHub, hub, 0},
                  {kHub - 1, kHub - 1, hub, 0},
                  {kHub, kHub - 1, std::sqrt(hub) * std::sqrt(hub - 0.85 * lost), 0}};
  for (std::uint32_t i = 0; i + 1 < kHub; ++i) {
    entries.push_back({i, i, leaf, 0});
    entries.push_back({kHub, i, leaf, 0});
  }
  // hub − Σ leaf²/leaf − (hub − 0.85 lost) = −0.15 lost
  const Inertia found = SparseMatrix(kHub + 1, entries).negative_eigenvalues(Bound::upper, {}, 1, 0);
  EXPECT_TRUE(!found.proved || found.negative >= 1);
}

/// (−1, 0, p; 0, 1, q; p, q, 0) has two negative eigenvalues for p = 0.79 and q = 0.81.
TEST(SparseMatrices, APlaceOfTheDiagonalWithoutEntriesIsZero) {
  const Entries entries{{0, 0, -1, 0}, {1, 1, 1, 0}, {2, 0, 1, 0.21}, {2, 1, 0.6, 0.21}};
  const Inertia found = SparseMatrix(3, entries).negative_eigenvalues(Bound::upper, {}, 1);
  EXPECT_TRUE(found.proved);
  EXPECT_EQ(found.negative, 2U);
}

/// By how much more than what is set aside in some row, 2⁻²⁶ of the sum of its absolute values, Lemma 36.1 lets entries
/// of LDLᵀ be wrong: the lemma itself, column by column. Each entry stands once, and none has an error.
double rounding_of_lemma(std::uint32_t size, const Entries& entries, double additions) {
  std::vector<std::vector<std::pair<std::uint32_t, double>>> columns(size);
  std::vector<double> pivots(size), aside(size), errors(size);
  for (const auto& [row, column, value, error] : entries) {
    aside[row] += std::abs(value) * 0x1p-26;
    if (row == column) {
      pivots[row] = value;
    } else {
      aside[column] += std::abs(value) * 0x1p-26;
      columns[column].emplace_back(row, value);
    }
  }
  for (std::uint32_t k = 0; k < size; ++k) {
    pivots[k] -= aside[k];
    std::sort(columns[k].begin(), columns[k].end());
  }
  for (std::uint32_t k = 0; k < size; ++k) {
    const double d = pivots[k];
    double sum = 1;
    for (const auto& [i, value] : columns[k]) sum += std::abs(value / d);
    errors[k] += std::abs(d) * sum;
    for (auto entry = columns[k].begin(); entry != columns[k].end(); ++entry) {
      const auto& [j, value] = *entry;
      errors[j] += std::abs(value) * sum;
      pivots[j] -= value / d * value;
      auto to = columns[j].begin();
      for (auto other = entry + 1; other != columns[k].end(); ++other, ++to) {
        while (to != columns[j].end() && to->first < other->first) ++to;
        if (to == columns[j].end() || to->first != other->first) to = columns[j].insert(to, {other->first, 0});
        to->second -= value / d * other->second;
      }
    }
  }
  double most = 0;
  for (std::uint32_t i = 0; i < size; ++i)
    most = std::max(most, (additions + 3) * 1.01 * 0x1p-53 * errors[i] / aside[i]);
  return most;
}

/// What the lemma does not prove is not proved, and what it proves with a little to spare is.
class RoundingOfMatrices : public testing::Test {
 protected:
  void compare(std::uint32_t size, const Entries& entries, double additions) {
    const double rounding = rounding_of_lemma(size, entries, additions);
    const bool proved = SparseMatrix(size, entries).negative_eigenvalues(Bound::upper, {}, 1).proved;
    if (rounding >= 1) {
      EXPECT_FALSE(proved) << rounding;
    } else if (rounding < 0.92) {
      EXPECT_TRUE(proved) << rounding;
    }
    ++(rounding >= 1 ? not_proved_ : proved_);
  }
  void TearDown() override {
    EXPECT_GT(proved_, 4);
    EXPECT_GT(not_proved_, 4);
  }
  int proved_ = 0;
  int not_proved_ = 0;
};

/// (x, 1; 1, 1): 2·2 additions in a block of two columns, and one more for it.
TEST_F(RoundingOfMatrices, OfOnePanel) {
  for (double x = 0x1.2p-24; x < 0x1.8p-24; x *= 1.005) compare(2, {{0, 0, x, 0}, {1, 0, 1, 0}, {1, 1, 1, 0}}, 5);
}

/// Columns `first` to `last` of a path, of which each leaves something in the last row and is a panel of its own.
Entries chain_of_panels(std::uint32_t first, std::uint32_t last) {
  Entries entries{{last, first, 0.5, 0}};
  for (std::uint32_t k = first; k < last; ++k) {
    entries.push_back({k, k, k == first ? 1.0 : 2.0, 0});
    if (k + 1 < last) entries.push_back({k + 1, k, -1, 0});
  }
  return entries;
}

/// A term of the last entry passes through two additions in each panel.
TEST_F(RoundingOfMatrices, OfAChainOfPanels) {
  for (std::uint32_t size = 3700; size < 4300; size += 25) compare(size, chain_of_panels(0, size - 1), 2.0 * size);
}

/// The panel of the last row has more children than the chain, before it; what the chain leaves is added first, and so
/// passes through an addition for each of them as well.
TEST_F(RoundingOfMatrices, OfAChainThatIsTheLastOfManyChildren) {
  for (std::uint32_t children = 2400; children < 5200; children += 200) {
    const std::uint32_t last = children + 3500;
    Entries entries = chain_of_panels(children, last);
    for (std::uint32_t k = 0; k < children; ++k) {
      entries.push_back({k, k, 1, 0});
      entries.push_back({last, k, 0, 0});
    }
    compare(last + 1, entries, children + 2.0 * 3501);
  }
}

/// Groups of 49 columns, which are two blocks, with all rows of the group, the first of the next one, and the last.
TEST_F(RoundingOfMatrices, OfPanelsOfTwoBlocks) {
  constexpr std::uint32_t kWidth = 49;
  constexpr std::uint32_t kGroups = 12;
  constexpr std::uint32_t kLast = kWidth * kGroups;
  for (double x = 0x1p-20; x < 0x1.4p-20; x *= 1.015) {
    Entries entries{{kLast, 0, 1, 0}, {kLast, kLast, 1, 0}};
    for (std::uint32_t k = 0; k < kLast; ++k) {
      entries.push_back({k, k, k == 0 ? x : 1, 0});
      if (k > 0) entries.push_back({kLast, k, 0, 0});
      const std::uint32_t next = (k / kWidth + 1) * kWidth;
      for (std::uint32_t row = k + 1; row <= next && row < kLast; ++row) entries.push_back({row, k, 0x1p-16, 0});
    }
    compare(kLast + 1, entries, 96 + 3 * kGroups);
  }
}

/// In a row of n entries, 2⁻⁴⁹⁹n(n + 3) is set aside for what underflows.
TEST(SparseMatrices, NumbersThatMayUnderflowAreNotProved) {
  const auto proved = [](std::uint32_t size, double x) {
    Entries entries;
    for (std::uint32_t i = 0; i < size; ++i) entries.push_back({i, i, x, 0});
    return SparseMatrix(size, entries).negative_eigenvalues(Bound::upper, {}, 1).proved;
  };
  for (const std::uint32_t size : {1U, 10U, 1000U}) {
    const double underflow = 0x1p-499 * size * (size + 3);
    EXPECT_TRUE(proved(size, 0x1.01p26 * underflow)) << size;
    EXPECT_FALSE(proved(size, 0x1.ffp25 * underflow)) << size;
    EXPECT_FALSE(proved(size, 0x1p-1000)) << size;
  }
}

TEST(SparseMatrices, SingularOnesAreNotProvedBetter) {
  // 0, and (1, 1; 1, 1): the eigenvalue 0 may be negative for an upper bound, and is not for a lower one.
  for (const Entries& entries : {Entries{}, Entries{{0, 0, 1, 0}, {1, 0, 1, 0}, {1, 1, 1, 0}}}) {
    const std::uint32_t size = entries.empty() ? 1 : 2;
    const SparseMatrix matrix(size, entries);
    const Inertia upper = matrix.negative_eigenvalues(Bound::upper, {}, 1);
    const Inertia lower = matrix.negative_eigenvalues(Bound::lower, {}, 1);
    EXPECT_TRUE(!upper.proved || upper.negative == 1);
    EXPECT_TRUE(!lower.proved || lower.negative == 0);
  }
}

/// (1, 1; 1, 1 + x) has the eigenvalue x/2, nearly: more than 2⁻⁴⁰ of the rows' sums, and less than 2⁻³².
TEST(SparseMatrices, EigenvaluesNearZeroAreProvedIfWanted) {
  for (const double x : {0x1p-34, -0x1p-34}) {
    const SparseMatrix matrix(2, {{0, 0, 1, 0}, {1, 0, 1, 0}, {1, 1, 1 + x, 0}});
    const std::uint32_t negative = x < 0 ? 1 : 0;
    for (const Bound bound : {Bound::upper, Bound::lower}) {
      const Inertia found = matrix.negative_eigenvalues(bound, {}, 1, negative);
      EXPECT_TRUE(found.proved);
      EXPECT_EQ(found.negative, negative);
      const std::uint32_t safe = bound == Bound::upper ? 1 : 0;
      EXPECT_EQ(matrix.negative_eigenvalues(bound, {}, 1).negative, safe);
      // Nothing more is done for what is known.
      EXPECT_EQ(matrix.negative_eigenvalues(bound, {}, 1, safe).negative, safe);
    }
  }
  // A pivot so small that less is not enough: what was proved stays.
  const SparseMatrix matrix(2, {{0, 0, 1e-5, 0}, {1, 0, 1, 0}, {1, 1, 1, 0}});
  const Inertia found = matrix.negative_eigenvalues(Bound::upper, {}, 1, 0);
  EXPECT_TRUE(found.proved);
  EXPECT_EQ(found.negative, 1U);
}

TEST(SparseMatrices, PivotsNearZeroAreNotProved) {
  // (0, 1; 1, 0) needs an exchange of rows; so does (x, 1; 1, 1) for a small x.
  for (const double x : {0.0, 1e-9, 1e-12, 1e-300}) {
    const SparseMatrix matrix(2, {{0, 0, x, 0}, {1, 0, 1, 0}, {1, 1, 1, 0}});
    for (const Bound bound : {Bound::upper, Bound::lower}) {
      const Inertia inertia = matrix.negative_eigenvalues(bound, {}, 1);
      EXPECT_TRUE(!inertia.proved || inertia.negative == 1) << x;
    }
  }
  // Rounding errors are 1/x times as large as the entries.
  const auto proved = [](double x) {
    return SparseMatrix(2, {{0, 0, x, 0}, {1, 0, 1, 0}, {1, 1, 1, 0}}).negative_eigenvalues(Bound::upper, {}, 1).proved;
  };
  EXPECT_TRUE(proved(1e-5));
  EXPECT_TRUE(proved(-1e-5));
  for (const double x : {0.0, 3e-9, 1e-12, 1e-300}) EXPECT_FALSE(proved(x)) << x;
  // The shift is 2⁻³² of the row: what is as large exactly cannot be told.
  const SparseMatrix matrix(2, {{0, 0, 0x1p-31, 0}, {1, 0, 1, 0}, {1, 1, 0, 0}});
  EXPECT_TRUE(matrix.negative_eigenvalues(Bound::upper, {}, 1).negative >= 1);
}

TEST(SparseMatrices, NumbersOutOfRangeAreNotProved) {
  for (const double x : {1e46, 1e100, 1e300, HUGE_VAL, std::nan("")}) {
    EXPECT_FALSE(SparseMatrix(1, {{0, 0, x, 0}}).negative_eigenvalues(Bound::upper, {}, 1).proved) << x;
    EXPECT_FALSE(
        SparseMatrix(2, {{0, 0, 1, 0}, {1, 0, x, 0}, {1, 1, 1, 0}}).negative_eigenvalues(Bound::lower, {}, 1).proved)
        << x;
  }
  EXPECT_FALSE(SparseMatrix(1, {{0, 0, 1, HUGE_VAL}}).negative_eigenvalues(Bound::upper, {}, 1).proved);
  EXPECT_TRUE(SparseMatrix(1, {{0, 0, 1e40, 0}}).negative_eigenvalues(Bound::upper, {}, 1).proved);
}

/// Full blocks of columns, and so many rows behind them that threads share them: x xᵀ − 2 y yᵀ + a diagonal, whose
/// number of negative eigenvalues is known.
TEST(SparseMatrices, OfManyColumnsAreTheSameForAnyNumberOfThreads) {
  for (const std::uint32_t size : {47U, 48U, 49U, 95U, 98U, 470U}) {
    std::mt19937 random(size);
    std::vector<double> x(size);
    for (double& value : x) value = unit(random);
    Entries entries;
    for (std::uint32_t i = 0; i < size; ++i) {
      for (std::uint32_t j = 0; j <= i; ++j) entries.push_back({i, j, x[i] * x[j], 0});
      // Negative at five places, by Weyl at least four eigenvalues are, and at most five.
      entries.push_back({i, i, i % (size / 5) == 3 && i < size / 5 * 5 ? -3.0 : 0.5, 0});
    }
    const SparseMatrix matrix(size, entries);
    const Inertia upper = matrix.negative_eigenvalues(Bound::upper, {}, 1);
    const Inertia lower = matrix.negative_eigenvalues(Bound::lower, {}, 1);
    ASSERT_TRUE(upper.proved && lower.proved) << size;
    EXPECT_EQ(upper.negative, lower.negative) << size;
    EXPECT_GE(upper.negative, 4U);
    EXPECT_LE(upper.negative, 5U);
    for (const unsigned threads : {2U, 5U}) {
      const Inertia again = matrix.negative_eigenvalues(Bound::upper, {}, threads);
      EXPECT_TRUE(again.proved);
      EXPECT_EQ(again.negative, upper.negative);
    }
    if (size > 60) continue;
    EXPECT_EQ(upper.negative, less_than(eigenvalues(dense(size, entries)), 0)) << size;
  }
}

/// The Laplacian of a grid, k × k, less σ: a tree of panels. Its eigenvalues are sums of 2 − 2 cos.
TEST(SparseMatrices, OfGridsHaveKnownEigenvalues) {
  constexpr std::uint32_t kWide = 17;
  std::vector<double> values;
  for (std::uint32_t i = 1; i <= kWide; ++i) {
    for (std::uint32_t j = 1; j <= kWide; ++j)
      values.push_back(4 - 2 * std::cos(i * 3.14159265358979 / (kWide + 1)) -
                       2 * std::cos(j * 3.14159265358979 / (kWide + 1)));
  }
  std::vector<std::uint32_t> order(kWide * kWide);
  std::iota(order.begin(), order.end(), 0U);
  std::mt19937 random(9);  // NOLINT: the same in every run.
  for (int i = 0; i < 3; ++i) {
    for (const double sigma : {0.5, 1.77, 3.9}) {
      Entries entries;
      for (std::uint32_t p = 0; p < kWide * kWide; ++p) {
        entries.push_back({p, p, 4 - sigma, 1e-9});
        if (p % kWide != 0) entries.push_back({p, p - 1, -1, 1e-9});
        if (p >= kWide) entries.push_back({p, p - kWide, -1, 1e-9});
      }
      const SparseMatrix matrix(kWide * kWide, permuted(entries, order));
      for (const Bound bound : {Bound::upper, Bound::lower}) {
        const Inertia inertia = matrix.negative_eigenvalues(bound, {}, 1);
        EXPECT_TRUE(inertia.proved);
        EXPECT_EQ(inertia.negative, less_than(values, sigma)) << i << ' ' << sigma;
      }
    }
    std::shuffle(order.begin(), order.end(), random);
  }
}

/// An arrow whose first column fills everything: known before anything is computed, or memory taken.
TEST(SparseMatrices, WorkIsSpentBeforeItIsDone) {
  constexpr std::uint32_t kSize = 20'000;
  Entries entries;
  for (std::uint32_t i = 0; i < kSize; ++i) {
    entries.push_back({i, i, 4, 0});
    entries.push_back({i, 0, i == 0 ? 0 : 0.001, 0});
  }
  const SparseMatrix matrix(kSize, entries);
  EXPECT_THROW((void)matrix.negative_eigenvalues(Bound::upper, Budget(100'000'000), 1), BudgetSpent);
  // The other way around there is nothing to fill.
  for (auto& [row, column, value, error] : entries) {
    row = kSize - 1 - row;
    column = kSize - 1 - column;
    std::swap(row, column);
  }
  const Inertia inertia = SparseMatrix(kSize, entries).negative_eigenvalues(Bound::upper, Budget(100'000'000), 1);
  EXPECT_TRUE(inertia.proved);
  EXPECT_EQ(inertia.negative, 0U);
  // A third of n³/6 operations, and 20 units for each byte of n² numbers, which are given back.
  Entries full;
  for (std::uint32_t i = 0; i < 200; ++i) {
    for (std::uint32_t j = 0; j <= i; ++j) full.push_back({i, j, i == j ? 300.0 : 1.0, 0});
  }
  const Budget budget(1'000'000'000);
  EXPECT_EQ(SparseMatrix(200, full).negative_eigenvalues(Bound::upper, budget, 1).negative, 0U);
  const std::uint64_t spent = 1'000'000'000 - budget.left();
  EXPECT_GT(spent, 200U * 200 * 200 / 18);
  EXPECT_LT(spent, 5'000'000U);
  constexpr std::uint64_t kMemory = std::uint64_t{200} * 200 * 8 * 20;
  EXPECT_THROW((void)SparseMatrix(200, full).negative_eigenvalues(Bound::upper, Budget(kMemory), 1), BudgetSpent);
  EXPECT_TRUE(SparseMatrix(200, full).negative_eigenvalues(Bound::upper, Budget(kMemory + spent), 1).proved);
}

// Limits.

/// What is not linear in the size of the file is paid for before it is done.
TEST(Limits, ManyRowsAndFunctionsSpendTheBudget) {
  constexpr std::uint64_t kSomeWork = 2'000'000'000;
  const auto expect_spent = [](const Document& document, const char* rule) {
    EXPECT_EQ(structure_problem(document).value_or(""), "");
    const Certificate certificate = checked(document, kSomeWork);
    EXPECT_EQ(certificate.verdict, Verdict::undecided);
    EXPECT_EQ(certificate.rule, rule);
    EXPECT_EQ(certificate.message, BudgetSpent().what());
  };
  Document document = octagon();
  document.at_most.resize(20'000, document.at_most[0]);
  expect_spent(document, "most");
  document = octagon();
  document.at_least.resize(40'000, document.at_least[0]);
  expect_spent(document, "least");
  document = function();
  document.eigenfunctions[0].functions.assign(1000, Document::Coefficients(std::size_t{9} * 3, 1));
  expect_spent(document, "eigenfunctions");
  document.eigenfunctions[0].functions.assign(200, Document::Coefficients(std::size_t{9} * 401, 1));
  expect_spent(document, "eigenfunctions");
}

TEST(Limits, HalvingsNeedAsManySidesInTheFile) {
  Document document = octagon();
  for (std::uint32_t halvings = 2; halvings <= 12; ++halvings) {
    document.halvings = halvings;
    EXPECT_THAT(structure_problem(document).value_or(""), HasSubstr("side_order: 432 elements, expected"));
  }
}

// Structure.

std::string problem(const std::function<void(Document&)>& change) {
  Document document = octagon();
  change(document);
  return structure_problem(document).value_or("");
}

TEST(EigenvaluesStructure, OrdersArePermutations) {
  EXPECT_EQ(problem([](Document&) {}), "");
  EXPECT_THAT(problem([](Document& d) { d.side_order.pop_back(); }),
              HasSubstr("side_order: 431 elements, expected 432"));
  EXPECT_THAT(problem([](Document& d) { d.vertex_order.push_back(142); }),
              HasSubstr("vertex_order: 143 elements, expected 142"));
  EXPECT_THAT(problem([](Document& d) { d.side_order[7] = d.side_order[9]; }), HasSubstr("occurs twice"));
  EXPECT_THAT(problem([](Document& d) { d.side_order[7] = 432; }), HasSubstr("side_order[7]: 432 does not exist"));
  EXPECT_THAT(problem([](Document& d) { d.vertex_order[0] = d.vertex_order[1]; }), HasSubstr("occurs twice"));
  EXPECT_THAT(problem([](Document& d) { d.vertex_order[3] = ~0U; }), HasSubstr("does not exist"));
  EXPECT_THAT(problem([](Document& d) { d.side_order.back() = d.side_order.front(); }), HasSubstr("occurs twice"));
  EXPECT_THAT(problem([](Document& d) { d.vertex_order.back() = 142; }), HasSubstr("142 does not exist"));
  // Where nothing is counted, there is none.
  EXPECT_THAT(problem([](Document& d) { d.at_most.clear(); }), HasSubstr("side_order: 432 elements, expected 0"));
  EXPECT_THAT(problem([](Document& d) { d.at_least.clear(); }), HasSubstr("vertex_order: 142 elements, expected 0"));
  EXPECT_THAT(problem([](Document& d) { d.halvings = 13; }), HasSubstr("halvings: 13"));
  EXPECT_THAT(problem([](Document& d) { d.halvings = ~0U; }), HasSubstr("halvings: "));
  EXPECT_THAT(problem([](Document& d) { d.halvings = 0; }), HasSubstr("side_order: "));
}

TEST(EigenvaluesStructure, NetsAreWhole) {
  EXPECT_THAT(problem([](Document& d) { d.net.collars.emplace(); }), HasSubstr("collars"));
  EXPECT_NE(problem([](Document& d) { d.net.triangles[0].opposite[0] = 9999; }), "");
}

TEST(EigenvaluesStructure, NumbersAreInRange) {
  for (const double x : {-1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THAT(problem([&](Document& d) { d.next = x; }), HasSubstr("next: "));
    EXPECT_THAT(problem([&](Document& d) { d.eigenvalues[1].in.lower = x; }), HasSubstr("eigenvalues[1]: in is not"));
    EXPECT_THAT(problem([&](Document& d) { d.eigenvalues[1].in.upper = x; }), HasSubstr("eigenvalues[1]: in is not"));
    EXPECT_THAT(problem([&](Document& d) { d.at_most[1].below = x; }), HasSubstr("at_most[1]: below and sigma"));
    EXPECT_THAT(problem([&](Document& d) { d.at_most[1].sigma = x; }), HasSubstr("at_most[1]: below and sigma"));
    EXPECT_THAT(problem([&](Document& d) { d.at_least[1].below = x; }), HasSubstr("at_least[1]: below is not"));
  }
  EXPECT_EQ(problem([](Document& d) { d.next = 0; }), "");
  EXPECT_EQ(problem([](Document& d) { d.eigenvalues[0].in = {0, 0}; }), "");
  EXPECT_THAT(problem([](Document& d) { d.eigenvalues[0].in = {2, below(2.0)}; }), HasSubstr("lo <= hi"));
  EXPECT_THAT(problem([](Document& d) { d.eigenvalues[2].count = 0; }), HasSubstr("eigenvalues[2]: the count is 0"));
  EXPECT_THAT(problem([](Document& d) { d.at_least[0].count = 0; }), HasSubstr("at_least[0]: the count is 0"));
  EXPECT_EQ(problem([](Document& d) { d.at_most[0].count = 0; }), "");
  EXPECT_THAT(problem([](Document& d) { d.at_most[0].below = 0; }), HasSubstr("0 < below <= sigma"));
  EXPECT_THAT(problem([](Document& d) { d.at_least[0].below = 0; }), HasSubstr("below is not positive"));
  EXPECT_EQ(problem([](Document& d) { d.at_most[0].below = d.at_most[0].sigma; }), "");
  EXPECT_THAT(problem([](Document& d) { d.at_most[0].below = above(d.at_most[0].sigma); }),
              HasSubstr("below <= sigma"));
}

TEST(EigenvaluesStructure, FunctionsAreWhole) {
  const auto problem = [](const std::function<void(Document::Eigenfunctions&)>& change) {
    Document document = function();
    change(document.eigenfunctions.at(0));
    return structure_problem(document).value_or("");
  };
  EXPECT_EQ(problem([](auto&) {}), "");
  for (const double lambda : {0.0, -1.0, 2.7, 2.8, std::nan(""), HUGE_VAL})
    EXPECT_THAT(problem([&](auto& f) { f.lambda = lambda; }), HasSubstr("eigenfunctions[0]: lambda is not in in"));
  EXPECT_EQ(problem([](auto& f) { f.in = {f.lambda, f.lambda}; }), "");
  EXPECT_THAT(problem([](auto& f) { f.in.lower = 0; }), HasSubstr("0 < lo"));
  EXPECT_THAT(problem([](auto& f) { f.in.upper = HUGE_VAL; }), HasSubstr("lo <= hi"));
  // ε is 0.9, the nearest number of binary64 is more.
  for (const double radius : {0.5, below(0.9), 2.0, std::nan("")})
    EXPECT_THAT(problem([&](auto& f) { f.radius = radius; }), HasSubstr("more than epsilon and less than 2"));
  EXPECT_EQ(problem([](auto& f) { f.radius = 0.9; }), "");
  EXPECT_EQ(problem([](auto& f) { f.radius = below(2.0); }), "");
  EXPECT_THAT(problem([](auto& f) { f.functions[0].pop_back(); }), HasSubstr("548 coefficients, expected 2M + 1"));
  EXPECT_THAT(problem([](auto& f) { f.functions[0].push_back(1); }), HasSubstr("550 coefficients, expected 2M + 1"));
  for (const std::size_t each : {0U, 1U, 2U, 60U, 403U})
    EXPECT_THAT(problem([&](auto& f) { f.functions[0].assign(9 * each, 1); }), HasSubstr("expected 2M + 1")) << each;
  for (const std::size_t each : {3U, 401U})
    EXPECT_EQ(problem([&](auto& f) { f.functions[0].assign(9 * each, 1); }), "") << each;
  EXPECT_THAT(problem([](auto& f) { f.functions[0].assign(9 * 401, 0); }),
              HasSubstr("functions[0]: all coefficients are 0"));
  EXPECT_THAT(problem([](auto& f) { f.functions[0][7] = std::nan(""); }), HasSubstr("not finite"));
  EXPECT_THAT(problem([](auto& f) { f.functions.clear(); }), HasSubstr("0 functions, expected 1 to 1000"));
  EXPECT_THAT(problem([](auto& f) { f.functions.resize(1001, f.functions[0]); }), HasSubstr("1001 functions"));
  EXPECT_EQ(problem([](auto& f) { f.functions.resize(1000, f.functions[0]); }), "");
  EXPECT_THAT(problem([](auto& f) { f.functions.push_back({1}); }), HasSubstr("another number of coefficients"));
  EXPECT_THAT(problem([](auto& f) { f.functions.emplace_back(f.functions[0].size() + 9, 1); }),
              HasSubstr("another number of coefficients"));
  EXPECT_EQ(problem([](auto& f) { f.functions[0].assign(f.functions[0].size(), -1); }), "");
  EXPECT_THAT(problem([](auto& f) { f.functions.emplace_back(f.functions[0].size()); }), HasSubstr("are 0"));
}

/// ε is a decimal: R is compared with it exactly.
TEST(EigenvaluesStructure, DisksOfFunctionsAreLargerThanEpsilon) {
  Document document = function();
  document.net.epsilon = "0.875";
  document.eigenfunctions[0].radius = 0.875;
  EXPECT_THAT(structure_problem(document).value_or(""), HasSubstr("more than epsilon and less than 2"));
  document.eigenfunctions[0].radius = above(0.875);
  EXPECT_EQ(structure_problem(document).value_or(""), "");
}

TEST(EigenvaluesStructure, FunctionsOfOneVertexHaveAsManyCoefficients) {
  Document document = file("octagon-5-of-one-vertex");
  document.net.epsilon = "1.9";
  document.eigenfunctions = {{{2, 3}, 2.5, 1.95, {Document::Coefficients(5, 1)}}};
  EXPECT_EQ(structure_problem(document).value_or(""), "");
  document.eigenfunctions[0].functions[0].push_back(1);
  EXPECT_THAT(structure_problem(document).value_or(""), HasSubstr("6 coefficients, expected 2M + 1"));
}

TEST(EigenvaluesStructure, IntervalsOfFunctionsAreInOrder) {
  Document document = function();
  document.eigenfunctions.push_back(document.eigenfunctions[0]);
  const Interval first = document.eigenfunctions[0].in;
  auto& second = document.eigenfunctions[1];
  EXPECT_THAT(structure_problem(document).value_or(""), HasSubstr("eigenfunctions[1]: in does not begin after"));
  second.in = {first.upper, 3};
  second.lambda = 2.9;
  EXPECT_THAT(structure_problem(document).value_or(""), HasSubstr("eigenfunctions[1]: in does not begin after"));
  second.in.lower = above(first.upper);
  EXPECT_EQ(structure_problem(document).value_or(""), "");
  std::swap(document.eigenfunctions[0], document.eigenfunctions[1]);
  EXPECT_THAT(structure_problem(document).value_or(""), HasSubstr("eigenfunctions[1]: in does not begin after"));
}

// What follows.

TEST(Enclosures, AreNoNarrowerThanWhatFollows) {
  for (const std::size_t i : {0U, 1U, 2U}) {
    EXPECT_EQ(changed([&](Document& d) { d.eigenvalues[i].in.lower = above(d.eigenvalues[i].in.lower); }),
              "REFUTED: enclosures");
    EXPECT_EQ(changed([&](Document& d) { d.eigenvalues[i].in.upper = below(d.eigenvalues[i].in.upper); }),
              "REFUTED: enclosures");
    EXPECT_EQ(changed([&](Document& d) { ++d.eigenvalues[i].count; }), "REFUTED: enclosures");
    EXPECT_EQ(changed([&](Document& d) { --d.eigenvalues[i].count; }).substr(0, 4), i == 0 ? "MALF" : "REFU");
    EXPECT_EQ(
        changed([&](Document& d) { d.eigenvalues.erase(d.eigenvalues.begin() + static_cast<std::ptrdiff_t>(i)); }),
        "REFUTED: enclosures");
  }
  EXPECT_EQ(changed([](Document& d) { d.next = above(d.next); }), "REFUTED: enclosures");
  EXPECT_EQ(changed([](Document& d) { d.eigenvalues[0].in = {0, 5}; }), "VERIFIED");
}

TEST(Enclosures, EveryRowIsNeeded) {
  for (std::ptrdiff_t i = 0; i < 4; ++i)
    EXPECT_EQ(changed([&](Document& d) { d.at_most.erase(d.at_most.begin() + i); }), "REFUTED: enclosures") << i;
  for (std::ptrdiff_t i = 0; i < 3; ++i)
    EXPECT_EQ(changed([&](Document& d) { d.at_least.erase(d.at_least.begin() + i); }), "REFUTED: enclosures") << i;
}

}  // namespace
}  // namespace epsnet::certify::eigenvalues_test
