#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "certify/net/numbering.h"
#include "tests/certify/claim_files.h"
#include "tests/certify/far_words.h"

/// Distance files. Each rule is broken by a file in which nothing else is wrong; nets are those of the rest of the
/// tests.
namespace epsnet::certify::distance_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

DistanceDocument load(const std::string& name) {
  return read_file<DistanceDocument>(std::string(EPSNET_TEST_DATA) + "/distances/" + name + ".json");
}

/// From the centre of a symmetric octagon with rational corners to its vertex: four shortest paths of equal length.
DistanceDocument four_equal() { return load("four-equal"); }
/// Seven lengths that differ by less than binary64 tells, none of them equal to another.
DistanceDocument across_a_cuff() { return load("across-a-cuff-of-1e-8"); }
DistanceDocument bolza() { return load("bolza"); }
/// From a point to itself.
DistanceDocument zero() { return load("zero"); }

std::vector<std::string> all_files() { return {"four-equal", "across-a-cuff-of-1e-8", "bolza", "zero"}; }

std::uint32_t partner(std::uint32_t side) { return (side + 4) % 8; }

TEST(Distance, FilesAreVerifiedByTheRulesOfTheNetAndThreeMore) {
  for (const std::string& file : all_files()) {
    const Certificate certificate = checked(load(file));
    EXPECT_EQ(certificate.verdict, Verdict::verified) << file << ": " << certificate.message;
    ASSERT_EQ(certificate.rules.size(), 10U) << file;
    EXPECT_EQ(certificate.rules[7].rule, "paths");
    EXPECT_EQ(certificate.rules[8].rule, "equal");
    EXPECT_EQ(certificate.rules[9].rule, "nearest");
    EXPECT_THAT(certificate.claim, HasSubstr("lies in " + to_string(load(file).distance)));
  }
}

TEST(Distance, TheClaimSaysWhatThePathsAre) {
  EXPECT_THAT(checked(four_equal()).claim, HasSubstr("the 4 paths listed are all the shortest ones"));
  EXPECT_THAT(checked(across_a_cuff()).claim, HasSubstr("the 7 paths listed are all of length at most "));
  EXPECT_THAT(checked(bolza()).claim, HasSubstr("the path listed is the only shortest one"));
  EXPECT_THAT(checked(bolza()).claim,
              HasSubstr("the distance of (\"1/3\", \"1/5\") of tile 0 from (\"-3/5\", \"1/7\") of tile 0 lies in"));
  DistanceDocument moved = bolza();
  moved.net.vertices[0].x = 1e-3;
  EXPECT_THAT(checked(moved).claim, HasSubstr("the distance of the net's vertex from"));
}

TEST(Distance, ANetThatIsNotValidIsRefutedByItsOwnRule) {
  DistanceDocument document = bolza();
  document.net.epsilon = "0.1";
  EXPECT_EQ(outcome(document), "REFUTED: covering");
  EXPECT_EQ(checked(document).rules.size(), 7U);
}

TEST(Distance, ALengthOutsideOfTheEnclosureIsRefuted) {
  for (const auto& make : {four_equal, across_a_cuff, bolza}) {
    for (const double shift : {-1e-12, 1e-12}) {
      DistanceDocument document = make();
      document.distance.lower += shift;
      document.distance.upper += shift;
      EXPECT_EQ(outcome(document), "REFUTED: paths");
    }
    DistanceDocument longer = make();
    longer.distance.upper = std::nextafter(longer.distance.lower, 0.0);
    longer.distance.lower = 0;
    EXPECT_EQ(outcome(longer), "REFUTED: paths");
  }
}

TEST(Distance, AWiderEnclosureHoldsAsLongAsNoOtherPathIsInIt) {
  DistanceDocument document = bolza();
  document.distance.lower = 0;
  EXPECT_EQ(outcome(document), "VERIFIED");
  document.distance.upper += 1e-6;
  EXPECT_EQ(outcome(document), "VERIFIED");
  document.distance.upper += 10;
  EXPECT_EQ(outcome(document), "REFUTED: nearest");
}

TEST(Distance, ALongerPathIsRefuted) {
  // Once around any side, then along the path.
  for (std::uint32_t side = 0; side < 8; ++side) {
    for (const auto& make : {four_equal, bolza}) {
      DistanceDocument document = make();
      document.paths[0].insert(document.paths[0].begin(), side);
      const std::string found = outcome(document);
      // One of four equal paths may become another one of them.
      EXPECT_THAT(found, StartsWith("REFUTED: paths")) << side;
      if (document.paths.size() > 1) continue;
      // It is found to be longer, and a shorter one to be missing, in an enclosure of its own.
      document.distance = {0, 40};
      EXPECT_EQ(outcome(document), "REFUTED: nearest") << side;
    }
  }
}

TEST(Distance, AMissingPathIsRefuted) {
  for (const auto& make : {four_equal, across_a_cuff}) {
    const DistanceDocument document = make();
    for (std::size_t i = 0; i < document.paths.size(); ++i) {
      DistanceDocument without = document;
      without.paths.erase(without.paths.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_EQ(outcome(without), "REFUTED: nearest") << i;
      EXPECT_THAT(checked(without).message, HasSubstr("is missing"));
    }
    DistanceDocument first_alone = document;
    first_alone.paths.resize(1);
    EXPECT_EQ(outcome(first_alone), "REFUTED: nearest");
  }
}

TEST(Distance, APathThatOccursTwiceIsRefutedHoweverItIsSpelled) {
  for (const auto& make : {four_equal, bolza, zero}) {
    const DistanceDocument document = make();
    DistanceDocument twice = document;
    twice.paths.push_back(document.paths[0]);
    EXPECT_EQ(outcome(twice), "REFUTED: paths");
    // Out and back again; and once around the vertex, which is a trivial loop.
    twice.paths.back().insert(twice.paths.back().begin(), {5, partner(5)});
    EXPECT_EQ(outcome(twice), "REFUTED: paths");
    twice.paths.back() = document.paths[0];
    std::vector<std::uint32_t> around;
    for (std::uint32_t side = 0; around.size() < 8; side = (partner(side) + 1) % 8) around.push_back(side);
    twice.paths.back().insert(twice.paths.back().begin(), around.begin(), around.end());
    EXPECT_EQ(outcome(twice), "REFUTED: paths");
    EXPECT_THAT(checked(twice).message, HasSubstr("again"));
  }
}

/// The same paths, spelled with a detour to somewhere so many sides away.
DistanceDocument with_detours(DistanceDocument document, std::size_t length) {
  if (length == 0) return document;
  for (auto& path : document.paths) path = with_far_relator(document.net.surface, 0, path, length);
  return document;
}

CheckOptions with_64_bits() { return {.threads = 1, .max_precision = 64, .max_work = std::uint64_t{1} << 50}; }

/// What is true is not refuted and what is false not verified, however wide the balls are.
TEST(SlowDistance, WideBallsDecideNothing) {
  for (const auto& make : {four_equal, bolza, zero}) {
    const DistanceDocument good = make();
    std::vector<DistanceDocument> wrong(3, good);
    wrong[0].distance.upper += 1e-6;
    wrong[0].distance.lower = wrong[0].distance.upper;
    wrong[1].paths.push_back(good.paths.back());
    wrong[2].distance.upper += 5;
    int decided = 0;
    int open = 0;
    for (std::size_t length = 0; length < 200; length += 1 + length / 4) {
      const Verdict verdict = check(with_detours(good, length), with_64_bits()).verdict;
      EXPECT_TRUE(verdict == Verdict::verified || verdict == Verdict::undecided) << length;
      ++(verdict == Verdict::undecided ? open : decided);
      for (const DistanceDocument& document : wrong) {
        const Verdict of_wrong = check(with_detours(document, length), with_64_bits()).verdict;
        EXPECT_TRUE(of_wrong == Verdict::refuted || of_wrong == Verdict::undecided) << length;
      }
    }
    EXPECT_GT(decided, 1);
    EXPECT_GT(open, 3);
    EXPECT_EQ(outcome(with_detours(good, 120)), "VERIFIED");
  }
}

/// cosh of a distance is algebraic, so that its bounds are met only by 0.
TEST(Distance, TheEnclosureMayBeAsTightAsBinary64) {
  for (const auto& make : {four_equal, bolza}) {
    const auto [lower, upper] = make().distance;
    const auto outcome_of = [&](double lo, double hi) {
      DistanceDocument document = make();
      document.distance = {lo, hi};
      return outcome(document);
    };
    double least = lower;
    while (outcome_of(std::nextafter(least, 10.0), upper) == "VERIFIED") least = std::nextafter(least, 10.0);
    EXPECT_LT(least - lower, 1e-12);
    EXPECT_EQ(outcome_of(least, std::nextafter(least, 10.0)), "VERIFIED");
    EXPECT_EQ(outcome_of(std::nextafter(least, 10.0), upper + 1e-9), "REFUTED: paths");
    EXPECT_EQ(outcome_of(0, least), "REFUTED: paths");
    EXPECT_EQ(outcome_of(least, least), "REFUTED: paths");
  }
}

/// How often rule `rule` is open, while words get longer, and balls wider. It must never say this.
int times_open(std::size_t rule, const DistanceDocument& document, Verdict never) {
  int open = 0;
  for (std::size_t length = 0; length < 60; ++length) {
    const Certificate certificate = check(with_detours(document, length), with_64_bits());
    if (certificate.rules.size() <= rule) continue;  // The paths are refuted.
    EXPECT_NE(certificate.rules[rule].verdict, never) << length;
    open += certificate.rules[rule].verdict == Verdict::undecided ? 1 : 0;
  }
  return open;
}

TEST(Distance, WhatIsWrongIsNeverVerified) {
  DistanceDocument twice = bolza();
  twice.paths.push_back(twice.paths[0]);
  twice.distance = {0, 40};
  EXPECT_GT(times_open(7, twice, Verdict::verified), 10);
  DistanceDocument too_short = bolza();
  too_short.distance = {too_short.distance.upper + 1e-3, 40};
  EXPECT_GT(times_open(7, too_short, Verdict::verified), 10);
  DistanceDocument alone = bolza();
  alone.distance = {0, 40};
  EXPECT_GT(times_open(9, alone, Verdict::verified), 10);
}

TEST(Distance, WhatIsRightIsNeverRefuted) {
  DistanceDocument document = bolza();
  const auto holds = [&](double upper) {
    document.distance = {0, upper};
    return outcome(document) == "VERIFIED";
  };
  // Up to the next path.
  double good = document.distance.upper;
  double bad = good + 10;
  while (bad - good > 1e-3) {
    const double middle = (good + bad) / 2;
    (holds(middle) ? good : bad) = middle;
  }
  EXPECT_TRUE(holds(good));
  for (const std::size_t rule : {7U, 8U, 9U}) EXPECT_LT(times_open(rule, document, Verdict::refuted), 50);
}

TEST(Distance, ARefutedRuleCountsMoreThanOneThatIsOpen) {
  DistanceDocument document = bolza();
  document.distance = {0, 20};
  document.equal = true;
  document.paths = {{0, 1}, {2, 0}};
  const Certificate certificate = check(with_detours(document, 150), with_64_bits());
  EXPECT_EQ(certificate.rules[7].verdict, Verdict::undecided);
  EXPECT_EQ(certificate.rules[8].verdict, Verdict::refuted);
  EXPECT_EQ(certificate.verdict, Verdict::refuted);
  EXPECT_EQ(certificate.rule, "equal");
}

TEST(Distance, TheFirstPathThatIsWrongIsNamedAmongThoseThatAreOpen) {
  DistanceDocument document = with_detours(bolza(), 150);
  document.distance = {0, 3};
  document.paths.push_back(document.paths[0]);
  const auto message = [&] { return check(document, with_64_bits()).message; };
  EXPECT_THAT(message(), StartsWith("path 0 has a length in"));
  EXPECT_THAT(message(), HasSubstr("not decided whether in"));
  document.paths.push_back({0, 1, 2, 3, 0, 1, 2, 3});
  document.paths.push_back({0, 1, 2, 3, 0, 1, 2});
  EXPECT_THAT(message(), StartsWith("path 2 has a length in"));
  EXPECT_THAT(message(), HasSubstr("not in [0, 3]"));
}

TEST(SlowDistance, WordsThatAreTooLongForExactNumbersLeaveThingsOpen) {
  const auto verdict = [](const char* rule, const DistanceDocument& document) {
    for (const RuleReport& report : check(document, with_64_bits()).rules) {
      if (report.rule == rule) return report.verdict;
    }
    return Verdict::malformed;
  };
  constexpr std::size_t kFar = 100'000;
  DistanceDocument document = bolza();
  document.point.z = document.net.charts[0].centre;
  document.distance = {0, 0};
  document.paths = {{}};
  EXPECT_EQ(verdict("paths", document), Verdict::verified);
  EXPECT_EQ(verdict("paths", with_detours(document, kFar)), Verdict::undecided);
  for (const std::size_t i : {0U, 1U}) {
    document.paths = {{0, 1}, {1, 0}};
    document.paths[i] = with_far_relator(document.net.surface, 0, document.paths[i], kFar);
    document.distance = {0, 20};
    EXPECT_EQ(verdict("equal", document), Verdict::undecided);
  }
}

/// Of the identity and all edges at the vertex, as paths, one is left out.
TEST(Distance, EveryDartLeadsToANeighbour) {
  DistanceDocument good = bolza();
  good.equal = false;
  const auto word = [&](std::uint32_t dart) {
    const std::uint32_t label = corner_label(good.net, dart);
    return label == 0 ? std::vector<std::uint32_t>{} : good.net.labels[label - 1].word;
  };
  const auto darts = static_cast<std::uint32_t>(3 * good.net.triangles.size());
  for (std::uint32_t missing = 0; missing < darts; ++missing) {
    DistanceDocument document = good;
    document.distance = {0, 40};
    document.paths = {{}};
    for (std::uint32_t dart = 0; dart < darts; ++dart) {
      if (dart == missing) continue;
      std::vector<std::uint32_t> path = word(next_dart(dart));
      const std::vector<std::uint32_t> back = word(dart);
      for (auto side = back.rbegin(); side != back.rend(); ++side) path.push_back(partner(*side));
      document.paths.push_back(path);
    }
    EXPECT_EQ(outcome(document), "REFUTED: nearest");
    EXPECT_THAT(checked(document).message,
                HasSubstr("the loop at the vertex along dart " + std::to_string(missing) + ", then path 0"));
  }
}

TEST(Distance, NothingIsSaidOfAListWhosePathsAreWrong) {
  for (const auto& make : {four_equal, bolza}) {
    DistanceDocument document = make();
    document.distance = {0, document.distance.lower / 2};
    EXPECT_EQ(checked(document).rules.size(), 8U);
    document = make();
    document.paths.push_back(document.paths[0]);
    EXPECT_EQ(checked(document).rules.size(), 8U);
  }
}

/// The vertex need not be the centre of its chart: what is said is the same as in a chart of which it is.
TEST(Distance, TheVertexMayBeAnywhereInItsChart) {
  DistanceDocument moved = bolza();
  const mpq_class x(1, 64), y(1, 256);
  ASSERT_EQ(moved.net.charts.size(), 1U);
  const RationalPoint c = moved.net.charts[0].centre;
  // (z + c)/(1 + c̄z).
  const mpq_class re = 1 + c.x * x + c.y * y, im = c.x * y - c.y * x;
  const mpq_class square = re * re + im * im;
  DistanceDocument centred = moved;
  centred.net.charts[0].centre = {((x + c.x) * re + (y + c.y) * im) / square,
                                  ((y + c.y) * re - (x + c.x) * im) / square};
  moved.net.vertices[0] = {x.get_d(), y.get_d(), 0};
  const auto holds = [&](DistanceDocument& document, double upper) {
    document.distance = {0, upper};
    return verdict_of("paths", document) == "VERIFIED";
  };
  double good = 10;
  double bad = 0;
  while (good - bad > 1e-12) {
    const double middle = (good + bad) / 2;
    (holds(centred, middle) ? good : bad) = middle;
  }
  EXPECT_TRUE(holds(moved, good));
  EXPECT_FALSE(holds(moved, bad));
  moved.distance = centred.distance = {bad, good};
  EXPECT_EQ(outcome(centred), "VERIFIED");
  EXPECT_EQ(outcome(moved), "VERIFIED");
  // From the vertex to itself, which is decided exactly.
  moved.point.z = centred.net.charts[0].centre;
  moved.distance = {0, 0};
  moved.paths = {{}};
  EXPECT_EQ(outcome(moved), "VERIFIED");
}

TEST(Distance, LengthsThatAreNearlyEqualAreNotEqual) {
  DistanceDocument document = across_a_cuff();
  document.equal = true;
  EXPECT_EQ(outcome(document), "REFUTED: equal");
  // That they are is no duty to be said.
  document = four_equal();
  document.equal = false;
  EXPECT_EQ(outcome(document), "VERIFIED");
}

/// On the Bolza surface the rotation by π takes the path from p to −p that leaves through k, then l, to the reverse of
/// the one through l, then k.
TEST(Distance, LengthsOnARegularSurfaceAreComparedOverItsRing) {
  DistanceDocument document = bolza();
  const RationalPoint centre = document.net.charts[document.net.vertices[0].chart].centre;
  document.point.z = {-centre.x, -centre.y};
  document.distance = {0, 20};
  document.equal = true;
  document.paths = {{0, 1}, {1, 0}};
  EXPECT_EQ(verdict_of("paths", document), "VERIFIED");
  EXPECT_EQ(verdict_of("equal", document), "VERIFIED");
  EXPECT_EQ(verdict_of("nearest", document), "REFUTED");
  document.paths = {{0, 1}, {2, 0}};
  EXPECT_EQ(verdict_of("equal", document), "REFUTED");
  // A point that is off by 10^-30.
  document.paths = {{0, 1}, {1, 0}};
  document.point.z.x += mpq_class("1/1000000000000000000000000000000");
  EXPECT_EQ(verdict_of("paths", document), "VERIFIED");
  EXPECT_EQ(verdict_of("equal", document), "REFUTED");
}

TEST(Distance, AnotherPointIsRefuted) {
  for (const auto& make : {four_equal, across_a_cuff, bolza, zero}) {
    DistanceDocument document = make();
    document.point.z.x += mpq_class("1/1000000000");
    EXPECT_EQ(outcome(document), "REFUTED: paths");
  }
}

TEST(Distance, ZeroIsDecidedExactly) {
  DistanceDocument document = zero();
  EXPECT_EQ(document.distance, (Interval{0, 0}));
  mpq_class tiny(1);
  mpz_mul_2exp(tiny.get_den_mpz_t(), tiny.get_den_mpz_t(), 3000);
  document.point.z.x += tiny;
  EXPECT_EQ(outcome(document), "REFUTED: paths");
  document.distance.upper = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(outcome(document), "VERIFIED");
  // 4·10^-324 is less than the least binary64; so is the distance.
  document.distance.lower = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(outcome(document), "REFUTED: paths");
}

TEST(Distance, ZeroIsDecidedBeyondAllBitsOfBallsAndWhereBallsAreExact) {
  DistanceDocument document = zero();
  mpq_class tiny(1);
  mpz_mul_2exp(tiny.get_den_mpz_t(), tiny.get_den_mpz_t(), 20'000);
  document.point.z.x += tiny;
  EXPECT_EQ(outcome(document), "REFUTED: paths");
  // In the centre of a tile of which nothing is rounded.
  document = four_equal();
  document.point = {0, {0, 0}};
  document.distance = {0, 0};
  document.paths = {{}};
  EXPECT_EQ(outcome(document), "VERIFIED");
}

TEST(Distance, ThreadsDoNotMatter) {
  for (const std::string& file : all_files()) {
    const Certificate one = check(load(file), {.threads = 1});
    const Certificate three = check(load(file), {.threads = 3});
    ASSERT_EQ(one.rules.size(), three.rules.size());
    for (std::size_t i = 0; i < one.rules.size(); ++i) EXPECT_EQ(to_string(one.rules[i]), to_string(three.rules[i]));
    EXPECT_EQ(one.counts.work, three.counts.work);
  }
}

TEST(Distance, TooManyTrianglesAreUndecided) {
  const std::size_t triangles = bolza().net.triangles.size();
  EXPECT_EQ(check(bolza(), {.threads = 1, .max_triangles = triangles}).verdict, Verdict::verified);
  const Certificate certificate = check(bolza(), {.threads = 1, .max_triangles = triangles - 1});
  EXPECT_EQ(certificate.verdict, Verdict::undecided);
  EXPECT_EQ(certificate.rule, "paths");
  EXPECT_THAT(certificate.message, HasSubstr("more triangles than the limit, " + std::to_string(triangles - 1)));
}

TEST(Distance, TooLittleWorkOrPrecisionIsUndecided) {
  const std::uint64_t all = checked(across_a_cuff()).counts.work;
  EXPECT_EQ(check(across_a_cuff(), {.threads = 2, .max_work = all}).verdict, Verdict::verified);
  for (const std::uint64_t work : {all - 1, all / 2, all / 10, std::uint64_t{1000}}) {
    EXPECT_EQ(check(across_a_cuff(), {.threads = 2, .max_work = work}).verdict, Verdict::undecided) << work;
  }
  // What the net takes alone.
  const std::uint64_t net = check(across_a_cuff().net, {.threads = 2}).counts.work;
  for (const std::uint64_t work : {net, net + 1}) {
    EXPECT_EQ(check(across_a_cuff(), {.threads = 2, .max_work = work}).verdict, Verdict::undecided);
  }
  // 21 is the distance: 64 bits do not tell the ends of the paths apart, nor lengths that differ by 10^-15.
  EXPECT_EQ(check(across_a_cuff(), {.threads = 2, .max_precision = 64}).verdict, Verdict::undecided);
}

TEST(Distance, EveryDefectOfADocumentIsMalformed) {
  const auto complaint = [](const std::function<void(DistanceDocument&)>& change) {
    DistanceDocument document = four_equal();
    change(document);
    return structure_complaint(document);
  };
  using Document = DistanceDocument;
  EXPECT_THAT(complaint([](Document& d) { d.net.vertices.push_back(d.net.vertices[0]); }),
              HasSubstr("2 vertices, expected one"));
  EXPECT_THAT(complaint([](Document& d) { d.net.collars.emplace(); }), HasSubstr("a pseudo net"));
  EXPECT_THAT(complaint([](Document& d) { d.net.vertices[0].x = 2; }), HasSubstr("vertices[0]"));
  EXPECT_THAT(complaint([](Document& d) { d.point.tile = 1; }), HasSubstr("point: tile 1 does not exist"));
  for (const RationalPoint& z :
       {RationalPoint{mpq_class(3, 5), mpq_class(4, 5)}, RationalPoint{1, 0}, RationalPoint{0, 1}}) {
    EXPECT_THAT(complaint([&](Document& d) { d.point.z = z; }), HasSubstr("point: outside of the open unit disk"));
  }
  EXPECT_THAT(complaint([](Document& d) { d.distance = {2, 1}; }), HasSubstr("is not 0 <= lo <= hi"));
  EXPECT_THAT(complaint([](Document& d) { d.distance = {-1, 1}; }), HasSubstr("is not 0 <= lo <= hi"));
  EXPECT_THAT(complaint([](Document& d) { d.paths.clear(); }), HasSubstr("paths: no element"));
  EXPECT_THAT(complaint([](Document& d) { d.paths[2] = {8}; }), HasSubstr("paths[2]: side 8 does not exist"));
  EXPECT_THAT(complaint([](Document& d) { d.paths[3] = {0, 1, 8}; }), HasSubstr("paths[3]: side 8 does not exist"));
  EXPECT_THAT(complaint([](Document& d) {
                d.net.vertices.clear();
                d.net.triangles.clear();
              }),
              HasSubstr("vertices"));
}

TEST(Distance, AWordThatCrossesASideOfAnotherTileIsMalformed) {
  const DistanceDocument good = across_a_cuff();
  const SurfaceSides sides(good.net.surface);
  const std::uint32_t here = good.net.charts[good.net.vertices[0].chart].tile;
  const auto message = [&](std::uint32_t side) {
    DistanceDocument document = good;
    document.paths[3].insert(document.paths[3].begin(), side);
    return checked(document).message;
  };
  for (std::uint32_t side = 0; side < sides.partner.size(); ++side) {
    if (sides.tile[side] == here) continue;
    EXPECT_THAT(message(side), HasSubstr("paths[3]: letter 0 is side " + std::to_string(side) + " of tile"));
  }
  // From the other tile, a side of this one.
  DistanceDocument document = good;
  const auto leaves = [&](std::uint32_t side) { return sides.tile[sides.partner[side]] != here; };
  std::uint32_t side = sides.first[here];
  while (!leaves(side)) side = sides.next[side];
  document.paths[3] = {side, side};
  EXPECT_THAT(checked(document).message, HasSubstr("paths[3]: letter 1 is side " + std::to_string(side) + " of tile"));
}

TEST(Distance, AWordThatLeadsToAnotherTileIsMalformed) {
  DistanceDocument document = across_a_cuff();
  document.paths[3].pop_back();
  const std::string message = checked(document).message;
  EXPECT_THAT(message, HasSubstr("paths[3]: the word ends in tile"));
  EXPECT_THAT(message, HasSubstr("of the point"));
  // Whichever tile it is.
  for (const std::uint32_t tile : {0U, 1U}) {
    document = across_a_cuff();
    if (document.point.tile == tile) continue;
    document.point.tile = tile;
    EXPECT_THAT(checked(document).message, HasSubstr("paths[0]: the word ends in tile"));
  }
}

TEST(Distance, InfiniteOrUnorderedEnclosuresAreMalformed) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Interval wrong : {Interval{0, kInfinity}, {std::nan(""), 1}, {0, std::nan("")}}) {
    DistanceDocument document = bolza();
    document.distance = wrong;
    EXPECT_EQ(outcome(document), "MALFORMED: structure");
  }
}

TEST(DistanceFile, WhatIsWrittenIsRead) {
  for (const std::string& file : all_files()) {
    const DistanceDocument document = load(file);
    EXPECT_EQ(parse_file<DistanceDocument>(written(document), "test"), document);
    EXPECT_EQ(std::get<DistanceDocument>(parse_file<ClaimDocument>(written(document), "test")), document);
  }
}

TEST(DistanceFile, HasExactlyItsMembers) {
  const std::string text = written(four_equal());
  const auto complaint = [&](const std::string& old, const std::string& by) -> std::string {
    std::string changed = text;
    const std::size_t place = changed.rfind(old);
    EXPECT_NE(place, std::string::npos) << old;
    changed.replace(place, old.size(), by);
    return reading_complaint<DistanceDocument>(changed);
  };
  EXPECT_EQ(complaint("\"equal\":true", "\"equal\":false"), "");
  EXPECT_THAT(complaint(",\n\"equal\":true", ""), HasSubstr("missing member \"equal\""));
  EXPECT_THAT(complaint("\"equal\":true", "\"equal\":1"), HasSubstr("equal: \"1\" found, expected true or false"));
  EXPECT_THAT(complaint("\"equal\":true", "\"equal\":true,\"equal\":true"), HasSubstr("repeated member"));
  EXPECT_THAT(complaint("\"equal\":true", "\"equal\":true,\"p\":0"), HasSubstr("unknown member \"p\""));
  EXPECT_THAT(complaint("\"5/6\",\"0\"]", "\"5/6\"]"), HasSubstr("point"));
  EXPECT_THAT(complaint("\"5/6\",\"0\"]", "0.5,\"0\"]"),
              HasSubstr("point: \"0.5\" found, expected a rational in a string"));
  EXPECT_THAT(complaint("\"distance\":[", "\"distance\":[0,"), HasSubstr("distance: too many elements"));
  EXPECT_THAT(complaint("\"paths\":[\n[]", "\"paths\":[\n[-1]"), HasSubstr("paths[0]: \"-1\" found"));
  EXPECT_THAT(complaint("\"format\":\"epsnet-distance\"", "\"format\":\"epsnet-geodesics\""), HasSubstr("format"));
  EXPECT_THAT(complaint("\"epsnet-distance\",\"version\":1", "\"epsnet-distance\",\"version\":2"),
              HasSubstr("version 2 is not a version"));
}

}  // namespace
}  // namespace epsnet::certify::distance_test
