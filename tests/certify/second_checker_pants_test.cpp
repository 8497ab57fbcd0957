#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/exact/checker.h"
#include "certify/exact/document.h"
#include "certify/exact/json.h"
#include "certify/exact/net_structure.h"

/// True pants files, in many words, and false ones, each with the rule by which the second checker refutes it.
namespace epsnet::exact::second_checker_pants_test {
namespace {

using Word = std::vector<Index>;
using Range = std::array<double, 2>;

double after(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double before(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

// Files.

struct Cuff {
  std::array<std::array<Index, 2>, 2> ends;
  Word across;
  Range length;
  Range twist;
  std::string exp_half_length;
};

struct Pants {
  std::string net;
  std::vector<std::array<Word, 2>> pants;
  std::vector<Cuff> cuffs;
  Word partner;  ///< By side.
  Word tile;     ///< By side.
};

/// The same value, as text.
std::string text_of(const Json& value) {
  const auto list = [](const auto& elements, const auto& text) {
    std::string result;
    for (const auto& element : elements) result += (result.empty() ? "" : ",") + text(element);
    return result;
  };
  switch (value.kind) {
    case Json::Kind::object:
      return "{" + list(value.members, [](const auto& m) { return '"' + m.name + "\":" + text_of(m.value); }) + "}";
    case Json::Kind::array:
      return "[" + list(value.elements, text_of) + "]";
    case Json::Kind::string:
      return '"' + value.text + '"';  // No text of the files here needs an escape.
    default:
      return value.text;
  }
}

std::string text_of(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", x);
  return text.data();
}

std::string text_of(const Range& range) { return "[" + text_of(range[0]) + "," + text_of(range[1]) + "]"; }

std::string text_of(const Word& word) {
  std::string text;
  for (const Index s : word) text += (text.empty() ? "" : ",") + std::to_string(s);
  return "[" + text + "]";
}

std::string text_of(const Cuff& cuff) {
  const auto end = [&](std::size_t i) { return text_of(Word(cuff.ends.at(i).begin(), cuff.ends.at(i).end())); };
  return "{\"ends\":[" + end(0) + "," + end(1) + "],\"across\":" + text_of(cuff.across) +
         ",\"length\":" + text_of(cuff.length) + ",\"twist\":" + text_of(cuff.twist) + ",\"exp_half_length\":\"" +
         cuff.exp_half_length + "\"}";
}

std::string text_of(const Pants& file) {
  std::string pants;
  for (const auto& [first, second] : file.pants)
    pants += (pants.empty() ? "" : ",") + ("[" + text_of(first) + "," + text_of(second) + "]");
  std::string cuffs;
  for (const Cuff& cuff : file.cuffs) cuffs += (cuffs.empty() ? "" : ",") + text_of(cuff);
  return "{\"format\":\"epsnet-pants\",\"version\":1,\"net\":" + file.net + ",\"pants\":[" + pants + "],\"cuffs\":[" +
         cuffs + "]}";
}

Range range_of(const Json& value) { return {std::stod(value.elements[0].text), std::stod(value.elements[1].text)}; }

Pants load(const std::string& name) {
  std::ifstream in(std::string(EPSNET_TEST_DATA) + "/pants/" + name + ".json");
  std::stringstream text;
  text << in.rdbuf();
  const Json root = parse_json(text.str());
  Pants file;
  file.net = text_of(member(root, "net"));
  const Net net = read_net(member(root, "net"));
  const NetStructure structure(net);
  for (Index s = 0; s < structure.sides(); ++s) {
    file.partner.push_back(structure.partner(s));
    file.tile.push_back(structure.tile_of(s));
  }
  for (const Json& row : member(root, "pants").elements)
    file.pants.push_back({read_indices(row.elements[0], "a path"), read_indices(row.elements[1], "a path")});
  for (const Json& row : member(root, "cuffs").elements) {
    const auto end = [&](std::size_t i) {
      const Word two = read_indices(member(row, "ends").elements[i], "an end");
      return std::array<Index, 2>{two[0], two[1]};
    };
    file.cuffs.push_back({{end(0), end(1)},
                          read_indices(member(row, "across"), "across"),
                          range_of(member(row, "length")),
                          range_of(member(row, "twist")),
                          member(row, "exp_half_length").text});
  }
  return file;
}

const std::vector<std::string>& names() {
  static const std::vector<std::string> names{"fenchel-nielsen-2", "octagon-5", "bolza", "cuff-1e-12"};
  return names;
}

// Verdicts.

/// "VERDICT", or "VERDICT: rule".
std::string outcome(const std::string& text) {
  constexpr std::array<const char*, 4> kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  const Result result = check(text);
  return kNames.at(static_cast<std::size_t>(result.verdict)) + (result.rule.empty() ? "" : ": " + result.rule);
}

std::string outcome(const Pants& file) { return outcome(text_of(file)); }

// Words.

Word joined(Word first, const Word& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Word backwards(const Pants& file, Word word) {
  std::reverse(word.begin(), word.end());
  for (Index& s : word) s = file.partner[s];
  return word;
}

/// The path of cuff k of p.
Word path_of(const Pants& file, const std::array<Index, 2>& end) {
  const auto& [first, second] = file.pants[end[0]];
  return end[1] == 0 ? first : end[1] == 1 ? second : backwards(file, joined(first, second));
}

/// Another path at both ends: `before` and `after` go before and behind it.
void lengthen(Cuff& cuff, const Word& before, const Word& after) {
  cuff.across = joined(before, joined(cuff.across, after));
}

/// The letters of one more letter there and back.
Word there_and_back(const Pants& file, Index side) { return {side, file.partner[side]}; }

// True files.

TEST(SecondCheckerOfPants, VerifiesTrueFiles) {
  for (const std::string& name : names()) {
    const Pants file = load(name);
    EXPECT_EQ(2 * file.cuffs.size(), 3 * file.pants.size());
    EXPECT_EQ(outcome(file), "VERIFIED") << name;
  }
}

TEST(SecondCheckerOfPants, TheThreeCuffsMayBeNumberedFromAnyOfThem) {
  for (const std::string& name : names()) {
    Pants file = load(name);
    for (int turn = 0; turn < 2; ++turn) {
      for (Index p = 0; p < file.pants.size(); ++p) file.pants[p] = {path_of(file, {p, 1}), path_of(file, {p, 2})};
      for (Cuff& cuff : file.cuffs) {
        for (auto& end : cuff.ends) end[1] = (end[1] + 2) % 3;
      }
      EXPECT_EQ(outcome(file), "VERIFIED") << name;
    }
  }
}

TEST(SecondCheckerOfPants, EitherEndMayBeTheFirst) {
  for (const std::string& name : names()) {
    Pants file = load(name);
    for (Cuff& cuff : file.cuffs) {
      std::swap(cuff.ends[0], cuff.ends[1]);
      cuff.across = backwards(file, cuff.across);
    }
    EXPECT_EQ(outcome(file), "VERIFIED") << name;
  }
}

TEST(SecondCheckerOfPants, PathsMayBeginAnywhere) {
  for (const std::string& name : names()) {
    Pants file = load(name);
    for (Index p = 0; p < file.pants.size(); ++p) {
      // A side of the tile, wherever it leads: the paths begin beyond it.
      const auto side = static_cast<Index>(
          std::find(file.tile.begin(), file.tile.end(), file.tile[file.pants[p][0][0]]) - file.tile.begin());
      const Word there{file.partner[side]};
      const Word back{side};
      for (Word& path : file.pants[p]) path = joined(there, joined(path, back));
      for (Cuff& cuff : file.cuffs) {
        if (cuff.ends[0][0] == p) lengthen(cuff, there, {});
        if (cuff.ends[1][0] == p) lengthen(cuff, {}, back);
      }
    }
    EXPECT_EQ(outcome(file), "VERIFIED") << name;
  }
}

TEST(SecondCheckerOfPants, LettersThatCancelChangeNothing) {
  for (const std::string& name : names()) {
    Pants file = load(name);
    for (auto& [first, second] : file.pants) {
      first = joined(there_and_back(file, first[0]), first);
      second = joined(second, there_and_back(file, first[0]));
    }
    EXPECT_EQ(outcome(file), "VERIFIED") << name;
  }
}

// Rule `pants`.

TEST(SecondCheckerOfPants, ThereAreAsManyPairsAsTheSurfaceHas) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    Pants file = good;
    file.pants.clear();
    file.cuffs.clear();
    EXPECT_EQ(outcome(file), "REFUTED: pants") << name;
    // All of them twice: two sheets.
    const auto pairs = static_cast<Index>(good.pants.size());
    file = good;
    for (const auto& paths : good.pants) file.pants.push_back(paths);
    for (Cuff cuff : good.cuffs) {
      for (auto& end : cuff.ends) end[0] += pairs;
      file.cuffs.push_back(cuff);
    }
    EXPECT_EQ(outcome(file), "REFUTED: pants") << name;
  }
}

TEST(SecondCheckerOfPants, PantsAreOnTheLeft) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (Index p = 0; p < good.pants.size(); ++p) {
      Pants file = good;
      for (Word& path : file.pants[p]) path = backwards(good, path);
      EXPECT_EQ(outcome(file), "REFUTED: pants") << name << ' ' << p;
    }
    Pants file = good;
    for (auto& paths : file.pants) {
      for (Word& path : paths) path = backwards(good, path);
    }
    EXPECT_EQ(outcome(file), "REFUTED: pants") << name;
  }
}

TEST(SecondCheckerOfPants, PathsInThePantsBeyondTheCuffsAreRefuted) {
  // All cuffs are between the same two pairs of pants. Each path alone is in the class of its cuff, rightly directed.
  Pants file = load("octagon-5");
  const auto [first, second] = file.pants[1];
  for (const Cuff& cuff : file.cuffs) {
    ASSERT_NE(cuff.ends[0][0], cuff.ends[1][0]);
    ASSERT_EQ(cuff.ends[0][1], cuff.ends[1][1]);
  }
  file.pants[0] = {backwards(file, first), backwards(file, second)};
  EXPECT_EQ(outcome(file), "REFUTED: pants");
}

TEST(SlowSecondCheckerOfPants, PathsThatGoAroundNoCuffsAreRefuted) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    const auto [first, second] = good.pants[0];
    const std::vector<std::array<Word, 2>> wrong{
        {first, {}},
        {first, there_and_back(good, first[0])},
        {there_and_back(good, first[0]), second},
        {first, first},
        {first, backwards(good, first)},
        {backwards(good, first), second},
        {first, backwards(good, second)},
        // A figure eight.
        {joined(first, backwards(good, second)), second},
    };
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      Pants file = good;
      file.pants[0] = wrong[i];
      EXPECT_EQ(outcome(file), "REFUTED: pants") << name << ' ' << i;
    }
  }
}

// Rule `glued`.

TEST(SecondCheckerOfPants, PathsThatGoAroundACuffTwiceAreRefuted) {
  // With the other cuff they are those of a pair of pants, that is not embedded.
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (std::size_t k = 0; k < 2; ++k) {
      Pants file = good;
      file.pants[0].at(k) = joined(file.pants[0].at(k), file.pants[0].at(k));
      EXPECT_EQ(outcome(file), "REFUTED: glued") << name << ' ' << k;
    }
  }
}

TEST(SecondCheckerOfPants, TwoPathsInTheOtherOrderAreThoseOfExchangedCuffs) {
  const Pants good = load("octagon-5");
  for (Index p = 0; p < good.pants.size(); ++p) {
    Pants file = good;
    std::swap(file.pants[p][0], file.pants[p][1]);
    EXPECT_EQ(outcome(file), "REFUTED: glued") << p;
  }
}

TEST(SecondCheckerOfPants, ExchangedEndsAreRefuted) {
  for (const char* name : {"fenchel-nielsen-2", "octagon-5"}) {
    const Pants good = load(name);
    for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (const std::size_t side : {0U, 1U}) {
          for (const std::size_t other : {0U, 1U}) {
            auto& end = good.cuffs[i].ends.at(side);
            if (end[0] != good.cuffs[j].ends.at(other)[0]) continue;
            Pants file = good;
            std::swap(file.cuffs[i].ends.at(side), file.cuffs[j].ends.at(other));
            EXPECT_EQ(outcome(file), "REFUTED: glued") << name << ' ' << i << ' ' << j;
          }
        }
      }
    }
  }
}

TEST(SlowSecondCheckerOfPants, APathAcrossThatGoesAroundAnotherCuffIsRefuted) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
      for (const Index step : {1U, 2U}) {
        const auto& [p, k] = good.cuffs[i].ends[0];
        const auto& [q, l] = good.cuffs[i].ends[1];
        Pants file = good;
        lengthen(file.cuffs[i], path_of(good, {p, (k + step) % 3}), {});
        EXPECT_EQ(outcome(file), "REFUTED: glued") << name << ' ' << i;
        file = good;
        lengthen(file.cuffs[i], {}, path_of(good, {q, (l + step) % 3}));
        EXPECT_EQ(outcome(file), "REFUTED: glued") << name << ' ' << i;
      }
    }
  }
}

// Rule `lengths`.

TEST(SlowSecondCheckerOfPants, LengthsAreBetweenTheirEndsToTheLastPlace) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
      const auto [lo, hi] = good.cuffs[i].length;
      Pants file = good;
      for (const Range wrong : {Range{after(hi), 2 * hi}, Range{lo / 2, before(lo)}, Range{lo, lo}, Range{hi, hi}}) {
        file.cuffs[i].length = wrong;
        EXPECT_EQ(outcome(file), "REFUTED: lengths") << name << ' ' << i << ' ' << text_of(wrong);
      }
      file.cuffs[i].length = {1e-300, 1e300};
      EXPECT_EQ(outcome(file), "VERIFIED") << name << ' ' << i;
    }
  }
}

TEST(SlowSecondCheckerOfPants, AnExactLengthIsExact) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
      Pants file = good;
      const bool is_known = good.cuffs[i].exp_half_length != "0";
      mpq_class r(is_known ? mpq_class(good.cuffs[i].exp_half_length)
                           : mpq_class(std::exp(good.cuffs[i].length[0] / 2)));
      r += mpq_class(1, mpz_class(1) << 300);
      file.cuffs[i].exp_half_length = r.get_str();
      EXPECT_EQ(outcome(file), "REFUTED: lengths") << name << ' ' << i;
      file.cuffs[i].exp_half_length = "0";
      EXPECT_EQ(outcome(file), "VERIFIED") << name << ' ' << i;
    }
  }
  const auto& cuffs = load("fenchel-nielsen-2").cuffs;
  EXPECT_TRUE(std::none_of(cuffs.begin(), cuffs.end(), [](const Cuff& c) { return c.exp_half_length == "0"; }));
}

// Rule `twists`.

/// Of a twist that is neither 0 nor half of a length.
bool is_chiral(const Cuff& cuff) {
  const double turns = std::remainder(2 * cuff.twist[0] / cuff.length[0], 1);
  return std::abs(turns) > 1e-6;
}

TEST(SlowSecondCheckerOfPants, TwistsAreBetweenTheirEndsToTheLastPlace) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
      const auto [lo, hi] = good.cuffs[i].twist;
      const double length = good.cuffs[i].length[0];
      Pants file = good;
      for (const Range wrong : {Range{after(hi), hi + length / 3}, Range{lo - length / 3, before(lo)},
                                Range{after(hi), lo + 0.999 * length}}) {
        file.cuffs[i].twist = wrong;
        EXPECT_EQ(outcome(file), "REFUTED: twists") << name << ' ' << i << ' ' << text_of(wrong);
      }
    }
  }
}

TEST(SecondCheckerOfPants, TwistsOfTheOtherSignAreRefuted) {
  std::size_t count = 0;
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
      if (!is_chiral(good.cuffs[i])) continue;
      Pants file = good;
      file.cuffs[i].twist = {-good.cuffs[i].twist[1], -good.cuffs[i].twist[0]};
      EXPECT_EQ(outcome(file), "REFUTED: twists") << name << ' ' << i;
      ++count;
    }
  }
  EXPECT_GE(count, 6U);
}

TEST(SlowSecondCheckerOfPants, AnyOfTheTwistsThatDifferByLengthsIsTrue) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
      const auto [lo, hi] = good.cuffs[i].twist;
      const double length = good.cuffs[i].length[0];
      for (const double m : {-1000.0, -1.0, 2.0}) {
        const double shift = m * length;
        const double error = 1e-9 * length;
        Pants file = good;
        file.cuffs[i].twist = {lo + shift - error, hi + shift + error};
        EXPECT_EQ(outcome(file), "VERIFIED") << name << ' ' << i << ' ' << m;
        file.cuffs[i].twist = {lo + shift - length / 2, lo + shift - error};
        EXPECT_EQ(outcome(file), "REFUTED: twists") << name << ' ' << i << ' ' << m;
        file.cuffs[i].twist = {hi + shift + error, hi + shift + length / 2};
        EXPECT_EQ(outcome(file), "REFUTED: twists") << name << ' ' << i << ' ' << m;
      }
      // All of them.
      Pants file = good;
      for (const Range whole : {Range{0, after(good.cuffs[i].length[1])}, Range{-1e308, 1e308}}) {
        file.cuffs[i].twist = whole;
        EXPECT_EQ(outcome(file), "VERIFIED") << name << ' ' << i;
      }
    }
  }
}

TEST(SlowSecondCheckerOfPants, PathsAcrossMayGoAroundTheirCuff) {
  for (const std::string& name : names()) {
    const Pants good = load(name);
    for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
      const Word here = path_of(good, good.cuffs[i].ends[0]);
      const Word there = path_of(good, good.cuffs[i].ends[1]);
      for (const Word& turn : {here, backwards(good, here)}) {
        Pants file = good;
        lengthen(file.cuffs[i], turn, {});
        EXPECT_EQ(outcome(file), "VERIFIED") << name << ' ' << i;
        lengthen(file.cuffs[i], joined(turn, turn), there);
        EXPECT_EQ(outcome(file), "VERIFIED") << name << ' ' << i;
      }
    }
  }
}

TEST(SecondCheckerOfPants, ATwistOfExactlyZeroMayBeAnEnd) {
  const Pants good = load("bolza");
  std::size_t count = 0;
  for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
    if (std::abs(good.cuffs[i].twist[0]) > 1e-9) continue;
    ++count;
    const Word turn = path_of(good, good.cuffs[i].ends[0]);
    for (const Range range : {Range{0, 0}, Range{0, 1}, Range{-1, 0}}) {
      Pants file = good;
      file.cuffs[i].twist = range;
      EXPECT_EQ(outcome(file), "VERIFIED") << i << ' ' << text_of(range);
      lengthen(file.cuffs[i], joined(turn, turn), {});
      EXPECT_EQ(outcome(file), "VERIFIED") << i << ' ' << text_of(range);
    }
    Pants file = good;
    file.cuffs[i].twist = {1e-300, 1};
    EXPECT_EQ(outcome(file), "REFUTED: twists") << i;
    lengthen(file.cuffs[i], backwards(good, turn), {});
    EXPECT_EQ(outcome(file), "REFUTED: twists") << i;
  }
  EXPECT_EQ(count, 2U);
}

TEST(SecondCheckerOfPants, ATwistThatIsNotToldFromAnEndIsUndecided) {
  // A twist of exactly 0, along a path that goes around the cuff so often that no exact number is computed for it.
  Pants file = load("bolza");
  ASSERT_LT(std::abs(file.cuffs[0].twist[0]), 1e-9);
  const Word turn = path_of(file, file.cuffs[0].ends[0]);
  for (int k = 0; k < 1100; ++k) lengthen(file.cuffs[0], turn, {});
  ASSERT_EQ(outcome(file), "VERIFIED");
  // True and false.
  for (const Range range : {Range{0, 1}, Range{-1, 0}, Range{1e-300, 1}, Range{-1, -1e-300}}) {
    file.cuffs[0].twist = range;
    EXPECT_EQ(outcome(file), "UNDECIDED: twists") << text_of(range);
  }
}

TEST(SlowSecondCheckerOfPants, LongPathsAcrossAreVerifiedOrUndecided) {
  const Pants good = load("fenchel-nielsen-2");
  for (const auto& [turns, expected] : {std::pair{100, "VERIFIED"}, std::pair{100'000, "UNDECIDED: glued"}}) {
    Pants file = good;
    const Word turn = path_of(good, good.cuffs[0].ends[0]);
    Word all;
    for (int i = 0; i < turns; ++i) all.insert(all.end(), turn.begin(), turn.end());
    lengthen(file.cuffs[0], all, {});
    EXPECT_EQ(outcome(file), expected) << turns;
  }
}

// Structure.

TEST(SecondCheckerOfPants, EveryEndIsThereOnce) {
  const Pants good = load("octagon-5");
  const auto pairs = static_cast<Index>(good.pants.size());
  for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
    Pants file = good;
    file.cuffs.push_back(file.cuffs[i]);
    EXPECT_EQ(outcome(file), "MALFORMED") << "a row twice";
    file = good;
    file.cuffs.erase(file.cuffs.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(outcome(file), "MALFORMED") << "no row";
    for (const std::size_t side : {0U, 1U}) {
      file = good;
      file.cuffs[i].ends.at(side) = good.cuffs[i].ends.at(1 - side);
      EXPECT_EQ(outcome(file), "MALFORMED") << "an end twice";
      file = good;
      file.cuffs[i].ends.at(side)[1] = 3;
      EXPECT_EQ(outcome(file), "MALFORMED") << "no cuff";
      file = good;
      file.cuffs[i].ends.at(side)[0] = pairs;
      EXPECT_EQ(outcome(file), "MALFORMED") << "no pair of pants";
    }
  }
  Pants file = good;
  file.pants.pop_back();
  EXPECT_EQ(outcome(file), "MALFORMED") << "ends of no pair of pants";
  file = good;
  file.pants.push_back(file.pants.back());
  EXPECT_EQ(outcome(file), "MALFORMED") << "a pair of pants without ends";
}

TEST(SecondCheckerOfPants, WordsLeadToTheRightTiles) {
  const Pants good = load("fenchel-nielsen-2");
  const auto sides = static_cast<Index>(good.tile.size());
  for (std::size_t p = 0; p < good.pants.size(); ++p) {
    const auto spoil = [&](std::size_t path, const Word& word) {
      Pants file = good;
      file.pants[p].at(path) = word;
      return outcome(file);
    };
    const Word& first = good.pants[p][0];
    EXPECT_EQ(spoil(0, {}), "MALFORMED");
    EXPECT_EQ(spoil(0, {sides}), "MALFORMED");
    EXPECT_EQ(spoil(1, {sides}), "MALFORMED");
    for (Index s = 0; s < sides; ++s) {
      const bool is_closed = good.tile[s] == good.tile[first[0]] && good.tile[good.partner[s]] == good.tile[first[0]];
      if (is_closed) continue;
      EXPECT_EQ(spoil(0, joined(first, {s})), "MALFORMED") << s;
      EXPECT_EQ(spoil(1, {s}), "MALFORMED") << s;
    }
  }
  for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
    Pants file = good;
    file.cuffs[i].across.push_back(sides);
    EXPECT_EQ(outcome(file), "MALFORMED") << i;
    file = good;
    if (good.cuffs[i].ends[0][0] == good.cuffs[i].ends[1][0]) continue;
    file.cuffs[i].across.clear();
    EXPECT_EQ(outcome(file), "MALFORMED") << i;
  }
}

TEST(SecondCheckerOfPants, NumbersOutOfOrderAreMalformed) {
  const Pants good = load("octagon-5");
  for (std::size_t i = 0; i < good.cuffs.size(); ++i) {
    const auto [lo, hi] = good.cuffs[i].length;
    for (const Range wrong : {Range{0, hi}, Range{-1, hi}, Range{hi, lo}, Range{0, 0}}) {
      Pants file = good;
      file.cuffs[i].length = wrong;
      EXPECT_EQ(outcome(file), "MALFORMED") << text_of(wrong);
    }
    Pants file = good;
    file.cuffs[i].twist = {after(good.cuffs[i].twist[0]), good.cuffs[i].twist[0]};
    EXPECT_EQ(outcome(file), "MALFORMED") << i;
    for (const char* wrong : {"1", "2/2", "1/2", "-2", "-1/3", "1.5", "", "2/0"}) {
      file = good;
      file.cuffs[i].exp_half_length = wrong;
      EXPECT_EQ(outcome(file), "MALFORMED") << wrong;
    }
  }
}

TEST(SecondCheckerOfPants, MembersAreThoseOfTheFormat) {
  const std::string good = text_of(load("octagon-5"));
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
  };
  ASSERT_EQ(outcome(good), "VERIFIED");
  for (const char* name :
       {"version", "net", "pants", "cuffs", "ends", "across", "length", "twist", "exp_half_length"}) {
    const std::string quoted = std::string("\"") + name + "\":";
    EXPECT_EQ(outcome(replaced(quoted, std::string("\"other\":"))), "MALFORMED") << name;
    EXPECT_EQ(outcome(replaced(quoted, "\"other\":0," + quoted)), "MALFORMED") << name;
    EXPECT_EQ(outcome(replaced(quoted, quoted + "0," + quoted)), "MALFORMED") << name;
  }
  EXPECT_EQ(outcome(replaced("\"pants\":[[", "\"pants\":[[[],")), "MALFORMED");
  EXPECT_EQ(outcome(replaced("\"ends\":[", "\"ends\":[[0,0],")), "MALFORMED");
  EXPECT_EQ(outcome(replaced("\"ends\":[[", "\"ends\":[[0,")), "MALFORMED");
  EXPECT_EQ(outcome(replaced("\"length\":[", "\"length\":[0,")), "MALFORMED");
  EXPECT_EQ(outcome(replaced("\"twist\":[", "\"twist\":[0,")), "MALFORMED");
  EXPECT_EQ(outcome(replaced("\"triangles\":", "\"collars\":[],\"triangles\":")), "MALFORMED");
}

}  // namespace
}  // namespace epsnet::exact::second_checker_pants_test
