#include "certify/numbers/budget.h"

#include <gtest/gtest.h>
#include <random>

#include "certify/check.h"
#include "certify/file/file.h"
#include "certify/net/structure.h"

/// The work that a file may take: counted, the same for any number of threads, and never exceeded.
namespace epsnet::certify::budget_test {
namespace {

std::string path(const std::string& name) { return std::string(EPSNET_TEST_DATA) + "/" + name; }
NetDocument load(const std::string& name) { return read_file<NetDocument>(path("certify/verified/" + name)); }

/// All that a certificate says in words.
std::string text(const Certificate& certificate) {
  std::string result(name(certificate.verdict));
  result += ": " + certificate.rule + ": " + certificate.message + "\n";
  for (const RuleReport& report : certificate.rules) {
    result += to_string(report) + "\n";
  }
  return result;
}

TEST(Budget, CopiesShareOneAccount) {
  const Budget budget(100);
  Budget copy(1);
  copy = budget;
  budget.spend(30);
  copy.spend(10, 2);
  EXPECT_EQ(budget.left(), 50U);
  budget.spend(50);
  EXPECT_EQ(copy.left(), 0U);
  EXPECT_THROW(copy.spend(1), BudgetSpent);
}

TEST(Budget, NothingIsLeftWhenItIsExceeded) {
  const Budget budget(100);
  EXPECT_THROW(budget.spend(101), BudgetSpent);
  EXPECT_THROW(budget.spend(1), BudgetSpent);
  const Budget other(100);
  EXPECT_THROW(other.spend(std::uint64_t{1} << 40, std::uint64_t{1} << 40), BudgetSpent);
}

TEST(Budget, WhatIsGivenBackHasToBeThereAndIsNotTaken) {
  const Budget budget(100);
  budget.require(50, 2);
  EXPECT_EQ(budget.left(), 100U);
  EXPECT_THROW(budget.require(50, 3), BudgetSpent);
  EXPECT_EQ(budget.left(), 0U);
}

TEST(Budget, WithoutLimitNothingIsExceeded) {
  const Budget budget;
  budget.require(std::uint64_t{1} << 62, std::uint64_t{1} << 62);
  budget.spend(std::uint64_t{1} << 62, std::uint64_t{1} << 62);
  EXPECT_GT(budget.left(), 0U);
}

TEST(Budget, AFileMayTakeMoreTheLongerItIs) {
  EXPECT_LT(work_allowed(least_bytes(load("octagon-1-vertex.json"))),
            work_allowed(least_bytes(load("octagon-33-vertices.json"))));
  // Thirty seconds at a nanosecond each, for a file of a megabyte.
  EXPECT_LE(work_allowed(1'000'000), 30'000'000'000U);
}

TEST(Budget, WorkDoesNotDependOnThreads) {
  for (const char* name :
       {"octagon-33-vertices.json", "regular-2-10-vertices.json", "square-of-cocircular-vertices.json"}) {
    const Certificate one = check(load(name), {.threads = 1});
    const Certificate three = check(load(name), {.threads = 3});
    EXPECT_EQ(one.verdict, Verdict::verified);
    EXPECT_GT(one.counts.work, 0U);
    EXPECT_EQ(one.counts.work, three.counts.work) << name;
  }
}

TEST(Budget, NothingIsVerifiedWithLessWorkThanItTakes) {
  for (const char* name : {"octagon-9-vertices.json", "regular-3-centre.json", "square-of-cocircular-vertices.json"}) {
    const NetDocument document = load(name);
    const std::uint64_t work = check(document, {.threads = 1}).counts.work;
    EXPECT_EQ(check(document, {.threads = 2, .max_work = work}).verdict, Verdict::verified);
    for (const std::uint64_t less : {std::uint64_t{1}, work / 16, work / 4, work / 2, work - work / 8, work - 1}) {
      const Certificate one = check(document, {.threads = 1, .max_work = less});
      const Certificate four = check(document, {.threads = 4, .max_work = less});
      EXPECT_EQ(one.verdict, Verdict::undecided) << name << " " << less;
      EXPECT_NE(one.message.find("more work"), std::string::npos) << one.message;
      EXPECT_EQ(text(one), text(four));
      EXPECT_LE(one.counts.work, less);
    }
  }
}

TEST(Budget, NoGeodesicsAreVerifiedWithLessWorkThanTheyTake) {
  const GeodesicsDocument document = read_file<GeodesicsDocument>(path("geodesics/three-cuffs.json"));
  const Certificate all = check(document, {.threads = 1});
  ASSERT_EQ(all.verdict, Verdict::verified);
  const std::uint64_t work = all.counts.work;
  EXPECT_EQ(check(document, {.threads = 3}).counts.work, work);
  EXPECT_EQ(check(document, {.threads = 2, .max_work = work}).verdict, Verdict::verified);
  for (std::uint64_t k = 1; k < 16; ++k) {
    const std::uint64_t less = k == 15 ? work - 1 : work / 16 * k;
    const Certificate one = check(document, {.threads = 1, .max_work = less});
    const Certificate four = check(document, {.threads = 4, .max_work = less});
    EXPECT_EQ(one.verdict, Verdict::undecided) << k;
    EXPECT_EQ(text(one), text(four)) << k;
    ASSERT_EQ(one.geodesics.has_value(), four.geodesics.has_value());
    if (!one.geodesics) continue;
    EXPECT_EQ(one.geodesics->lifted_triangles, four.geodesics->lifted_triangles) << k;
  }
}

/// A rational of so many digits near x.
mpq_class near(const mpq_class& x, unsigned long count) {
  gmp_randclass random(gmp_randinit_default);
  mpz_class denominator;
  mpz_ui_pow_ui(denominator.get_mpz_t(), 10, count);
  denominator += random.get_z_range(denominator);
  mpq_class result;
  result.get_num() = x.get_num() * denominator / x.get_den();
  result.get_den() = denominator;
  result.canonicalize();
  return result;
}

TEST(Budget, TheFirstTriangleThatIsWrongEndsTheSearch) {
  // Exact arithmetic on numbers of 50,000 digits would have to tell for nearly all triangles and edges.
  NetDocument document = load("octagon-9-vertices.json");
  for (NetDocument::Chart& chart : document.charts)
    chart.centre = {near(mpq_class(1, 10), 50'000), near(mpq_class(1, 5), 50'000)};
  for (std::size_t v = 0; v < document.vertices.size(); ++v) document.vertices[v] = {static_cast<double>(v) / 16, 0, 0};
  const Certificate certificate = check(document, {.threads = 2});
  EXPECT_EQ(certificate.verdict, Verdict::refuted);
  EXPECT_EQ(certificate.rule, "orientation");
  EXPECT_LT(certificate.counts.work, work_allowed(least_bytes(document)) / 20);
}

TEST(Budget, WithoutChartsNothingIsAskedOfTriangles) {
  // Enough for rule `surface`, not for the frames of charts: what comes after has nothing to stand on.
  const NetDocument document = load("octagon-9-vertices.json");
  std::size_t met = 0;
  std::size_t undecided = 0;  // With charts, but without enough for the equations.
  for (std::uint64_t work = 100; work < 10'000'000; work += work / 50) {
    const Certificate certificate = check(document, {.threads = 1, .max_work = work});
    undecided += certificate.rules.size() > 3 && certificate.rules[2].verdict == Verdict::undecided;
    if (certificate.rules.empty() || certificate.rules.back().rule != "gluing") continue;
    EXPECT_EQ(certificate.rules.back().verdict, Verdict::undecided);
    EXPECT_EQ(certificate.rules.size(), 3U);
    ++met;
  }
  EXPECT_GT(met, 0U);
  EXPECT_GT(undecided, 0U);
}

TEST(Budget, ARefutedRuleStaysRefutedWhateverComesLater) {
  // With 64 bits the second vertex is found to be in a wrong place; there is no work left for more.
  NetDocument document = load("octagon-9-vertices.json");
  std::swap(document.vertices[1], document.vertices[2]);
  const Certificate certificate = check(document, {.threads = 1});
  ASSERT_EQ(certificate.verdict, Verdict::refuted);
  const Certificate less = check(document, {.threads = 3, .max_work = certificate.counts.work});
  EXPECT_EQ(less.verdict, Verdict::refuted);
  EXPECT_EQ(less.message, certificate.message);
}

TEST(Budget, EnclosuresOfWhatWasNotMeasuredAreWide) {
  const NetDocument document = load("octagon-33-vertices.json");
  const std::uint64_t work = check(document, {.threads = 1}).counts.work;
  const Certificate certificate = check(document, {.threads = 1, .max_work = work - 1});
  ASSERT_EQ(certificate.verdict, Verdict::undecided);
  ASSERT_TRUE(certificate.enclosures);
  const Enclosures all = *check(document, {.threads = 1}).enclosures;
  EXPECT_LE(certificate.enclosures->largest_circumradius.lower, all.largest_circumradius.lower);
  EXPECT_GE(certificate.enclosures->largest_circumradius.upper, all.largest_circumradius.upper);
  EXPECT_LE(certificate.enclosures->shortest_edge->lower, all.shortest_edge->lower);
  EXPECT_GE(certificate.enclosures->longest_edge.upper, all.longest_edge.upper);
}

}  // namespace
}  // namespace epsnet::certify::budget_test
