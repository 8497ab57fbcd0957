#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "certify/check.h"
#include "certify/file/file.h"
#include "tests/certify/claim_files.h"

/// Pants files. Each rule is broken by a file in which nothing else is wrong.
namespace epsnet::certify::pants_test {
namespace {

using testing::HasSubstr;
using Word = PantsDocument::Word;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PantsDocument pants(const std::string& name) {
  return read_file<PantsDocument>(std::string(EPSNET_TEST_DATA) + "/pants/" + name + ".json");
}

/// Heptagons of known lengths.
PantsDocument fenchel_nielsen() { return pants("fenchel-nielsen-2"); }
PantsDocument octagon() { return pants("octagon-5"); }

std::string structure(const PantsDocument& document) {
  const Certificate certificate = checked(document);
  EXPECT_EQ(certificate.verdict, Verdict::malformed);
  return certificate.message;
}

Word path(const PantsDocument& document, const PantsDocument::End& end) {
  const auto& [first, second] = document.pants[end[0]];
  if (end[1] < 2) return document.pants[end[0]][end[1]];
  return reversed(document, joined(first, second));
}

Interval moved(Interval x, double by) { return {x.lower + by, x.upper + by}; }

/// A little wider than rounding of its ends can move it.
Interval widened(Interval x) {
  for (int i = 0; i < 10; ++i) x = {std::nextafter(x.lower, -kInfinity), std::nextafter(x.upper, kInfinity)};
  return x;
}

TEST(PantsFiles, True) {
  for (const char* name : {"fenchel-nielsen-2", "octagon-5", "bolza", "cuff-1e-12"}) {
    EXPECT_EQ(outcome(pants(name)), "VERIFIED") << name;
  }
}

TEST(PantsFiles, Structure) {
  const PantsDocument good = octagon();
  const auto problem = [&](const auto& change) {
    PantsDocument document = good;
    change(document);
    return structure(document);
  };
  using D = PantsDocument;
  EXPECT_THAT(problem([](D& d) { d.net.collars.emplace(); }), HasSubstr("expected a net of the whole surface"));
  EXPECT_THAT(problem([](D& d) { d.pants[1][0].clear(); }), HasSubstr("pants[1]: the first path has no letters"));
  EXPECT_THAT(problem([](D& d) { d.pants[1][0][0] = 8; }), HasSubstr("pants[1]: side 8 does not exist"));
  EXPECT_THAT(problem([](D& d) { d.pants[0][1].push_back(8); }), HasSubstr("pants[0]: "));
  EXPECT_THAT(problem([](D& d) { d.cuffs.pop_back(); }), HasSubstr("2 rows for 2 pairs of pants"));
  EXPECT_THAT(problem([](D& d) { d.cuffs[2].ends[1] = d.cuffs[0].ends[0]; }), HasSubstr("cuffs[2]: cuff 0 of pair"));
  EXPECT_THAT(problem([](D& d) {
                d.cuffs[2].ends[1] = {0, 3};
              }),
              HasSubstr("cuff 3 of pair of pants 0 does not exist"));
  EXPECT_THAT(problem([](D& d) {
                d.cuffs[2].ends[1] = {2, 0};
              }),
              HasSubstr("cuff 0 of pair of pants 2 does not exist"));
  EXPECT_THAT(problem([](D& d) { d.cuffs[1].across.push_back(9); }), HasSubstr("cuffs[1]: across: "));
  EXPECT_THAT(problem([](D& d) { d.cuffs[1].length.lower = 0; }), HasSubstr("cuffs[1]: length: "));
  EXPECT_THAT(problem([](D& d) { std::swap(d.cuffs[1].length.lower, d.cuffs[1].length.upper); }),
              HasSubstr("is not 0 < lo <= hi"));
  EXPECT_THAT(problem([](D& d) { std::swap(d.cuffs[1].twist.lower, d.cuffs[1].twist.upper); }),
              HasSubstr("is not lo <= hi"));
  EXPECT_THAT(problem([](D& d) { d.cuffs[1].twist.upper = kInfinity; }), HasSubstr("is not lo <= hi"));
  for (const mpq_class& root : {mpq_class(1), mpq_class(1, 2), mpq_class(-2)}) {
    EXPECT_THAT(problem([&](D& d) { d.cuffs[1].exp_half_length = root; }), HasSubstr("expected 0 or more than 1"));
  }
  // In a surface of several tiles a path has an end elsewhere.
  PantsDocument elsewhere = fenchel_nielsen();
  const auto between = std::find_if(elsewhere.cuffs.begin(), elsewhere.cuffs.end(),
                                    [](const auto& cuff) { return cuff.ends[0][0] != cuff.ends[1][0]; });
  between->across.clear();
  EXPECT_THAT(structure(elsewhere), HasSubstr("across: the word ends in tile"));
}

// Rule pants.

TEST(PantsFiles, AsManyPairsAsTheSurfaceHas) {
  PantsDocument twice = octagon();
  const PantsDocument good = twice;
  twice.pants.insert(twice.pants.end(), good.pants.begin(), good.pants.end());
  for (PantsDocument::Cuff cuff : good.cuffs) {
    for (PantsDocument::End& end : cuff.ends) end[0] += 2;
    twice.cuffs.push_back(cuff);
  }
  EXPECT_EQ(outcome(twice), "REFUTED: pants");
  EXPECT_THAT(checked(twice).message, HasSubstr("4 pairs of pants, expected 2"));
}

TEST(PantsFiles, PathsOfNoPants) {
  for (const PantsDocument& good : {octagon(), fenchel_nielsen()}) {
    for (std::size_t p = 0; p < 2; ++p) {
      const auto outcome_with = [&](const Word& first, const Word& second) {
        PantsDocument document = good;
        document.pants[p] = {first, second};
        return outcome(document);
      };
      const auto& [first, second] = good.pants[p];
      EXPECT_EQ(outcome_with(first, second), "VERIFIED");
      const std::string wrong = "REFUTED: pants";
      // One of them with the pants on its right, or both.
      EXPECT_EQ(outcome_with(reversed(good, first), second), wrong);
      EXPECT_EQ(outcome_with(first, reversed(good, second)), wrong);
      EXPECT_EQ(outcome_with(reversed(good, second), reversed(good, first)), wrong);
      // One curve twice; a null-homotopic one.
      EXPECT_EQ(outcome_with(first, first), wrong);
      EXPECT_EQ(outcome_with(first, joined(first, reversed(good, first))), wrong);
      EXPECT_EQ(outcome_with(joined(second, reversed(good, second)), second), wrong);
      EXPECT_EQ(outcome_with(first, reversed(good, first)), wrong);
    }
  }
}

// Rule glued.

TEST(PantsFiles, CuffsThatAreNotTheSame) {
  const PantsDocument good = fenchel_nielsen();
  for (std::size_t e = 0; e < good.cuffs.size(); ++e) {
    PantsDocument document = good;
    // Through the other cuffs.
    Word& across = document.cuffs[e].across;
    const auto& [p, k] = good.cuffs[e].ends[0];
    across = joined(path(good, {p, (k + 1) % 3}), across);
    EXPECT_EQ(outcome(document), "REFUTED: glued") << e;
  }
  // Pants all the same, with other numbers of cuffs.
  PantsDocument exchanged = good;
  std::swap(exchanged.pants[0][0], exchanged.pants[0][1]);
  EXPECT_EQ(outcome(exchanged), "REFUTED: glued");
  // Once more around a curve: the paths are those of a pair of pants that is not in the surface.
  PantsDocument square = good;
  square.pants[1][1] = joined(square.pants[1][1], square.pants[1][1]);
  EXPECT_EQ(outcome(square), "REFUTED: glued");
}

/// An element that moves the centre of its tile along its axis has a real a, and is not 1.
TEST(PantsFiles, ATranslationOfTheCentreIsNotTrivial) {
  PantsDocument document = pants("bolza");
  const auto cuff = std::find_if(document.cuffs.begin(), document.cuffs.end(), [](const PantsDocument::Cuff& one) {
    return one.ends[0][0] != one.ends[1][0] && one.ends[0][1] < 2 && one.ends[1][1] < 2;
  });
  ASSERT_NE(cuff, document.cuffs.end());
  std::swap(*cuff, document.cuffs[0]);
  const auto& [here, there] = document.cuffs[0].ends;
  // Around it is side 0, which is opposite to its partner.
  document.cuffs[0].across.clear();
  document.pants[there[0]][there[1]] = joined(reversed(document, path(document, here)), {0});
  const auto rules = checked(document).rules;
  const auto glued = std::find_if(rules.begin(), rules.end(), [](const auto& rule) { return rule.rule == "glued"; });
  ASSERT_NE(glued, rules.end());
  EXPECT_EQ(glued->verdict, Verdict::refuted);
  EXPECT_THAT(glued->text, HasSubstr("cuff 0 is not the same closed geodesic"));
}

// Rule lengths.

TEST(PantsFiles, LengthsAreInTheirIntervals) {
  for (const PantsDocument& good : {octagon(), fenchel_nielsen(), pants("cuff-1e-12")}) {
    for (std::size_t e = 0; e < good.cuffs.size(); ++e) {
      const auto [lower, upper] = good.cuffs[e].length;
      PantsDocument document = good;
      for (const Interval wrong : {Interval{upper, std::nextafter(upper, kInfinity)},
                                   Interval{std::nextafter(lower, 0), lower}, Interval{2 * lower, 2 * upper}}) {
        document.cuffs[e].length = wrong;
        EXPECT_EQ(outcome(document), "REFUTED: lengths") << e;
      }
      document.cuffs[e].length = {lower / 2, 2 * upper};
      EXPECT_EQ(outcome(document), "VERIFIED") << e;
    }
  }
}

TEST(PantsFiles, ExactLengths) {
  const PantsDocument good = fenchel_nielsen();
  for (std::size_t e = 0; e < good.cuffs.size(); ++e) {
    ASSERT_GT(good.cuffs[e].exp_half_length, 1);
    PantsDocument document = good;
    mpq_class& root = document.cuffs[e].exp_half_length;
    const mpq_class right = root;
    for (const mpq_class& wrong : {mpq_class(right + mpq_class(mpz_class(1), mpz_class(1) << 200)),
                                   mpq_class(right * right), mpq_class((right + 1) / 2)}) {
      root = wrong;
      EXPECT_EQ(outcome(document), "REFUTED: lengths") << e << ' ' << wrong;
    }
    root = 0;  // Claims nothing.
    EXPECT_EQ(outcome(document), "VERIFIED") << e;
  }
  PantsDocument irrational = octagon();
  irrational.cuffs[0].exp_half_length = mpq_class(std::exp(irrational.cuffs[0].length.lower / 2));
  EXPECT_EQ(outcome(irrational), "REFUTED: lengths");
}

// Rule twists.

TEST(PantsFiles, TwistsAreInTheirIntervals) {
  for (const PantsDocument& good : {octagon(), fenchel_nielsen(), pants("bolza")}) {
    for (std::size_t e = 0; e < good.cuffs.size(); ++e) {
      const auto [lower, upper] = good.cuffs[e].twist;
      const double length = good.cuffs[e].length.lower;
      PantsDocument document = good;
      Interval& twist = document.cuffs[e].twist;
      for (const Interval wrong :
           {Interval{upper, std::nextafter(upper, kInfinity)}, Interval{std::nextafter(lower, -kInfinity), lower},
            moved(good.cuffs[e].twist, length / 2), moved(good.cuffs[e].twist, -length / 3)}) {
        twist = wrong;
        EXPECT_EQ(outcome(document), "REFUTED: twists") << e << ' ' << wrong.lower;
      }
      // Modulo the length.
      for (const int times : {-3, 1, 1000}) {
        twist = widened(moved(good.cuffs[e].twist, times * length));
        twist = {twist.lower - 1e-10, twist.upper + 1e-10};
        EXPECT_EQ(outcome(document), "VERIFIED") << e << ' ' << times;
      }
      for (const Interval wide : {Interval{1e6, 1e6 + 1.001 * length}, Interval{-7e300, 3}, Interval{2, 7e300}}) {
        twist = wide;
        EXPECT_EQ(outcome(document), "VERIFIED") << e;
      }
      // All that is at least a little away from a twist.
      twist = {upper + length / 1000, upper + length - length / 1000};
      EXPECT_EQ(outcome(document), "REFUTED: twists") << e;
    }
  }
}

TEST(PantsFiles, TwistsHaveASign) {
  for (const PantsDocument& good : {octagon(), fenchel_nielsen()}) {
    for (std::size_t e = 0; e < good.cuffs.size(); ++e) {
      PantsDocument document = good;
      const Interval twist = good.cuffs[e].twist;
      document.cuffs[e].twist = {-twist.upper, -twist.lower};
      EXPECT_EQ(outcome(document), "REFUTED: twists") << e;
      // It is the same from the other side.
      document = good;
      PantsDocument::Cuff& cuff = document.cuffs[e];
      std::swap(cuff.ends[0], cuff.ends[1]);
      cuff.across = reversed(good, cuff.across);
      EXPECT_EQ(outcome(document), "VERIFIED") << e;
    }
  }
}

TEST(PantsFiles, AWayAroundTheCuffIsAsGood) {
  for (const PantsDocument& good : {octagon(), fenchel_nielsen()}) {
    for (std::size_t e = 0; e < good.cuffs.size(); ++e) {
      PantsDocument document = good;
      const Word around = path(good, good.cuffs[e].ends[0]);
      Word& across = document.cuffs[e].across;
      for (int times = 0; times < 3; ++times) across = joined(around, across);
      EXPECT_EQ(outcome(document), "VERIFIED") << e;
    }
  }
}

/// The same pants with paths that go along a loop first, again and again, and come back on it.
PantsDocument led_along(PantsDocument document, std::size_t p, const Word& loop, int times) {
  Word there;
  for (int i = 0; i < times; ++i) there = joined(there, loop);
  const Word back = reversed(document, there);
  for (Word& word : document.pants[p]) word = joined(joined(there, word), back);
  for (PantsDocument::Cuff& cuff : document.cuffs) {
    if (cuff.ends[0][0] == p) cuff.across = joined(there, cuff.across);
    if (cuff.ends[1][0] == p) cuff.across = joined(cuff.across, back);
  }
  return document;
}

/// The same pants with cuff 1 as the first one, and cuff 0 as the last.
PantsDocument turned(PantsDocument document, std::uint32_t p) {
  auto& [first, second] = document.pants[p];
  Word third = reversed(document, joined(first, second));
  first = std::move(second);
  second = std::move(third);
  for (PantsDocument::Cuff& cuff : document.cuffs) {
    for (PantsDocument::End& end : cuff.ends) {
      if (end[0] == p) end[1] = (end[1] + 2) % 3;
    }
  }
  return document;
}

/// On which side the axes are does not depend on where the centre of the tile is: beyond one cuff or another, also
/// where they are much longer than each other.
TEST(PantsFiles, WhereverTheirTileIs) {
  const PantsDocument good = pants("cuff-1e-12");
  for (std::uint32_t p = 0; p < 2; ++p) {
    for (const PantsDocument::Cuff& there : good.cuffs) {
      for (const PantsDocument::Cuff& back : good.cuffs) {
        Word loop = joined(there.across, reversed(good, back.across));
        if (p == 1) loop = joined(reversed(good, there.across), back.across);
        PantsDocument document = led_along(good, p, loop, 1);
        for (int first = 0; first < 3; ++first) {
          document = turned(std::move(document), p);
          EXPECT_EQ(outcome(document), "VERIFIED");
          PantsDocument other = document;
          PantsDocument::Paths& paths = other.pants[p];
          paths = {reversed(document, paths[1]), reversed(document, paths[0])};
          EXPECT_EQ(outcome(other), "REFUTED: pants");
        }
      }
    }
  }
}

TEST(PantsFiles, WideBallsRefuteNothing) {
  const PantsDocument good = octagon();
  bool undecided = false;
  for (int times = 1; times < 40; ++times) {
    const PantsDocument document = led_along(good, 0, {0, 2}, times);
    const Verdict verdict = check(document, {.threads = 1, .max_precision = 64}).verdict;
    EXPECT_NE(verdict, Verdict::refuted) << times;
    undecided = undecided || verdict == Verdict::undecided;
    if (times % 10 == 0) {
      EXPECT_EQ(outcome(document), "VERIFIED") << times;
    }
  }
  EXPECT_TRUE(undecided);
}

TEST(PantsFiles, WideBallsVerifyNothing) {
  const PantsDocument good = octagon();
  std::array<int, 3> undecided{};
  for (int times = 0; times < 40; ++times) {
    const PantsDocument led = led_along(good, 0, {0, 2}, times);
    for (std::size_t e = 0; e < good.cuffs.size(); ++e) {
      // Another length; another twist; all twists but one, modulo the length.
      const auto& [ends, across, length, twist, root] = good.cuffs[e];
      std::array<PantsDocument, 3> wrong{led, led, led};
      wrong[0].cuffs[e].length = {length.upper + 1e-12, length.upper + 1};
      wrong[0].cuffs[e].exp_half_length = 0;
      wrong[1].cuffs[e].twist = {twist.upper + 1e-12, twist.upper + 0.1};
      wrong[2].cuffs[e].twist = {twist.upper + 1e-12, twist.lower + length.lower - 1e-12};
      for (std::size_t k = 0; k < wrong.size(); ++k) {
        const Verdict verdict = check(wrong[k], {.threads = 1, .max_precision = 64}).verdict;
        EXPECT_NE(verdict, Verdict::verified) << times << ", cuff " << e << ", " << k;
        if (verdict == Verdict::undecided) ++undecided[k];
      }
    }
  }
  for (const int count : undecided) EXPECT_GT(count, 10);
}

TEST(PantsFiles, AWayAroundTheCuffThatIsTooLongIsNotComparedExactly) {
  PantsDocument document = octagon();
  const Word around = path(document, document.cuffs[0].ends[0]);
  Word& across = document.cuffs[0].across;
  Word turns;
  while (turns.size() < 2'000'000) turns.insert(turns.end(), around.begin(), around.end());
  across = joined(turns, across);
  EXPECT_EQ(outcome(document), "UNDECIDED: glued");
}

}  // namespace
}  // namespace epsnet::certify::pants_test
