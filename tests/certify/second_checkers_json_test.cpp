#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "certify/base/text.h"
#include "certify/exact/json.h"

/// The second checker's JSON, against the grammar, the table of well-formed UTF-8, and what each number may be.
namespace epsnet::exact::second_checkers_json_test {
namespace {

bool accepts(std::string_view text) {
  try {
    static_cast<void>(parse_json(text));
    return true;
  } catch (const Malformed&) {
    return false;
  }
}

/// All documents of at most so many tokens, of two keys, which are strings too, and the number 1.
class Documents {
 public:
  static constexpr std::size_t kTokens = 6;

  Documents() {
    for (std::size_t n = 1; n <= kTokens; ++n) {
      if (n == 1) values_[1] = {"\"a\"", "\"b\"", "1"};
      if (n == 2) values_[2] = {"[]", "{}"};
      if (n >= 3) {
        for (const std::string& list : lists(n - 2)) values_[n].insert("[" + list + "]");
        for (const char* key : {"\"a\"", "\"b\""}) {
          if (n < 5) continue;
          for (const std::string& value : values_[n - 4]) values_[n].insert("{" + (key + (":" + value)) + "}");
        }
      }
    }
  }

  [[nodiscard]] const std::set<std::string>& of(std::size_t tokens) const { return values_[tokens]; }
  [[nodiscard]] bool contain(const std::string& text) const {
    for (const std::set<std::string>& some : values_) {
      if (some.contains(text)) return true;
    }
    return false;
  }

 private:
  /// Values with commas between them.
  [[nodiscard]] std::set<std::string> lists(std::size_t tokens) const {
    std::set<std::string> result = values_[tokens];
    for (std::size_t first = 1; first + 2 <= tokens; ++first) {
      for (const std::string& value : values_[first]) {
        for (const std::string& rest : lists(tokens - first - 1)) result.insert(value + "," + rest);
      }
    }
    return result;
  }

  std::array<std::set<std::string>, kTokens + 1> values_;
};

TEST(SecondCheckersJson, IsThatOfTheGrammar) {
  const Documents documents;
  const std::vector<std::string> tokens{"[", "]", "{", "}", ",", ":", "\"a\"", "\"b\"", "1"};
  // All sequences of up to five tokens.
  std::vector<std::string> texts{""};
  std::size_t accepted = 0;
  for (std::size_t length = 1; length <= 5; ++length) {
    std::vector<std::string> longer;
    for (const std::string& text : texts) {
      for (const std::string& token : tokens) {
        if (text.ends_with('1') && token == "1") continue;  // That would be another number.
        longer.push_back(text + token);
        const bool expected = documents.contain(longer.back());
        accepted += expected;
        ASSERT_EQ(accepts(longer.back()), expected) << longer.back();
      }
    }
    texts = std::move(longer);
  }
  EXPECT_EQ(accepted, documents.of(1).size() + documents.of(2).size() + documents.of(3).size() +
                          documents.of(4).size() + documents.of(5).size());
}

TEST(SecondCheckersJson, EndsWhereTheTextEnds) {
  // What is behind the end of the text in memory would make it a document.
  const Documents documents;
  for (std::size_t tokens = 1; tokens <= Documents::kTokens; ++tokens) {
    for (const std::string& text : documents.of(tokens)) {
      for (const std::string& more : {text, text + "]", "[" + text + "] ", "{\"c\":" + text + " }", text + "1"}) {
        for (std::size_t end = 0; end < more.size(); ++end) {
          const std::string_view part = std::string_view(more).substr(0, end);
          EXPECT_EQ(accepts(part), accepts(std::string(part))) << part;
        }
      }
    }
  }
  const std::string text = R"(["\u00e9\ud83d\ude00)"
                           "\xe2\x82\xac"
                           R"(\n", true, null, -1.5e+7])";
  ASSERT_TRUE(accepts(text));
  for (std::size_t end = 0; end < text.size(); ++end) {
    EXPECT_FALSE(accepts(std::string_view(text).substr(0, end))) << end;
  }
}

TEST(SecondCheckersJson, SpaceIsFourCharactersBetweenTokens) {
  const std::vector<std::string> tokens{"{",    "\"a\"", ":", "[",     "true", ",", "\"b\"", ",",
                                        "null", "]",     ",", "\"b\"", ":",    "{", "}",     "}"};
  for (int byte = 0; byte < 256; ++byte) {
    const std::string space(2, static_cast<char>(byte));
    const bool expected = byte == ' ' || byte == '\t' || byte == '\n' || byte == '\r';
    for (std::size_t place = 0; place <= tokens.size(); ++place) {
      std::string text;
      for (std::size_t k = 0; k <= tokens.size(); ++k) {
        if (k == place) text += space;
        if (k < tokens.size()) text += tokens[k];
      }
      EXPECT_EQ(accepts(text), expected) << byte << " at " << place;
    }
  }
}

TEST(SecondCheckersJson, NestsEightDeep) {
  for (const std::string inner : {"1", "-1", "\"a\"", "true", "null"}) {
    for (const bool objects : {false, true}) {
      std::string text = inner;
      for (int depth = 1; depth <= 9; ++depth) {
        text = objects ? "{\"a\":" + text + "}" : "[" + text + "]";
        EXPECT_EQ(accepts(text), depth <= 8) << text;
      }
    }
  }
  EXPECT_FALSE(accepts("[[[[[[[[[]]]]]]]]]"));
  EXPECT_FALSE(accepts("[[[[[[[[{}]]]]]]]]"));
}

TEST(SecondCheckersJson, AnObjectHasSixteenDifferentMembers) {
  std::string members;
  for (char name = 'a'; name <= 'z'; ++name) {
    members += std::string(members.empty() ? "" : ",") + '"' + name + "\":1";
    EXPECT_EQ(accepts("{" + members + "}"), name <= 'p');
    if (name > 'o') continue;
    for (char other = 'a'; other <= name; ++other) EXPECT_FALSE(accepts("{" + members + ",\"" + other + "\":1}"));
  }
}

TEST(SecondCheckersJson, NumbersAreThoseOfJson) {
  // All words of up to five of these letters; what begins like a value and is not one is none.
  const std::string letters = "01-+.eE";
  const std::regex number("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][+-]?[0-9]+)?");
  std::vector<std::string> words{""};
  for (int length = 1; length <= 5; ++length) {
    std::vector<std::string> longer;
    for (const std::string& word : words) {
      for (const char letter : letters) longer.push_back(word + letter);
    }
    for (const std::string& word : longer) {
      const bool expected = std::regex_match(word, number);
      ASSERT_EQ(accepts(word), expected) << word;
      if (!expected) continue;
      const Json value = parse_json(word);
      EXPECT_EQ(value.kind, Json::Kind::number);
      EXPECT_EQ(value.text, word);
      const Binary64 read = to_binary64(value);
      mpq_class exact(read.mantissa);
      if (read.exponent < 0)
        mpq_div_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(-read.exponent));
      if (read.exponent > 0)
        mpq_mul_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(read.exponent));
      ASSERT_EQ(exact, mpq_class(*certify::parse_binary64(word))) << word;
    }
    words = std::move(longer);
  }
  for (const char* literal : {"true", "false", "null"}) {
    EXPECT_EQ(parse_json(literal).kind, Json::Kind::literal);
    EXPECT_FALSE(accepts(std::string(literal) + "x"));
  }
  for (const char* none : {"nul", "True", "NaN", "Infinity", "-Infinity", "0x1", "1_0", "+1", "--1"})
    EXPECT_FALSE(accepts(none));
}

/// By its definition: the code point's digits in base 64 behind a first byte that tells how many there are.
std::string utf8(std::uint32_t code) {
  std::string digits;
  const std::size_t more = code < 128 ? 0 : code < 2048 ? 1 : code < 65536 ? 2 : 3;
  for (std::size_t i = 0; i < more; ++i, code /= 64) digits.insert(digits.begin(), static_cast<char>(128 + code % 64));
  constexpr std::array<std::uint32_t, 4> kFirst{0, 192, 224, 240};
  return static_cast<char>(kFirst[more] + code) + digits;
}

std::string escaped(std::uint32_t unit) {
  constexpr const char* kDigits = "0123456789abcdefABCDEF";
  std::string text = "\\u";
  for (int shift = 12; shift >= 0; shift -= 4)
    text += kDigits[(unit >> shift) % 16 + ((unit >> shift) % 16 > 9 && shift == 4 ? 6 : 0)];
  return text;
}

TEST(SecondCheckersJson, EveryEscapeIsTheCharacterThatItNames) {
  for (std::uint32_t unit = 0; unit < 65536; ++unit) {
    const std::string text = '"' + escaped(unit) + '"';
    if (unit >= 0xD800 && unit <= 0xDFFF) {
      EXPECT_FALSE(accepts(text)) << unit;
    } else {
      ASSERT_EQ(parse_json(text).text, utf8(unit)) << unit;
    }
  }
  const std::vector<std::uint32_t> units{0x0041, 0xD7FF, 0xD800, 0xD801, 0xD834, 0xDBFE, 0xDBFF,
                                         0xDC00, 0xDC01, 0xDD1E, 0xDFFE, 0xDFFF, 0xE000, 0xFFFF};
  for (const std::uint32_t high : units) {
    for (const std::uint32_t low : units) {
      const std::string text = '"' + escaped(high) + escaped(low) + '"';
      const auto is_high = [](std::uint32_t unit) { return unit >= 0xD800 && unit < 0xDC00; };
      const auto is_low = [](std::uint32_t unit) { return unit >= 0xDC00 && unit < 0xE000; };
      const bool pair = is_high(high) && is_low(low);
      const bool none = is_high(high) || is_low(high) || is_high(low) || is_low(low);
      ASSERT_EQ(accepts(text), pair || !none) << text;
      if (pair) {
        EXPECT_EQ(parse_json(text).text, utf8(0x10000 + (high - 0xD800) * 1024 + low - 0xDC00));
      }
      if (is_high(high)) {
        EXPECT_FALSE(accepts('"' + escaped(high) + "xx" + escaped(low).substr(2) + '"'));
      }
    }
  }
  for (int byte = 0; byte < 256; ++byte) {
    const char c = static_cast<char>(byte);
    const std::string_view names = "\"\\/bfnrt";
    const std::size_t name = byte == 0 ? std::string_view::npos : names.find(c);
    const std::string text = std::string("\"\\") + c + "0041\"";
    if (name != std::string_view::npos) {
      EXPECT_EQ(parse_json(text).text, std::string(1, "\"\\/\b\f\n\r\t"[name]) + "0041");
    } else {
      EXPECT_EQ(accepts(text), c == 'u') << byte;
    }
    for (std::size_t place = 3; place < 7; ++place) {
      std::string hexadecimal = "\"\\u0041\"";
      hexadecimal[place] = c;
      EXPECT_EQ(accepts(hexadecimal), std::string_view("0123456789abcdefABCDEF").find(c) != std::string_view::npos)
          << byte;
    }
  }
}

TEST(SecondCheckersJson, BytesAreWellFormedUtf8) {
  // The Unicode standard, table 3-7: ranges of the first byte, and of those that follow.
  struct Row {
    int first, last;
    std::vector<std::pair<int, int>> more;
  };
  const std::vector<Row> table{{0x20, 0x7F, {}},
                               {0xC2, 0xDF, {{0x80, 0xBF}}},
                               {0xE0, 0xE0, {{0xA0, 0xBF}, {0x80, 0xBF}}},
                               {0xE1, 0xEC, {{0x80, 0xBF}, {0x80, 0xBF}}},
                               {0xED, 0xED, {{0x80, 0x9F}, {0x80, 0xBF}}},
                               {0xEE, 0xEF, {{0x80, 0xBF}, {0x80, 0xBF}}},
                               {0xF0, 0xF0, {{0x90, 0xBF}, {0x80, 0xBF}, {0x80, 0xBF}}},
                               {0xF1, 0xF3, {{0x80, 0xBF}, {0x80, 0xBF}, {0x80, 0xBF}}},
                               {0xF4, 0xF4, {{0x80, 0x8F}, {0x80, 0xBF}, {0x80, 0xBF}}}};
  const std::vector<int> bytes{0x41, 0x7F, 0x80, 0x81, 0x8F, 0x90, 0x9F, 0xA0, 0xBE, 0xBF, 0xC0, 0xC2, 0xFF};
  const auto expect = [&](const std::vector<int>& sequence) {
    // Characters one after the other, as long as there are any.
    std::size_t at = 0;
    bool good = true;
    while (good && at < sequence.size()) {
      good = false;
      for (const Row& row : table) {
        if (sequence[at] < row.first || sequence[at] > row.last || at + row.more.size() >= sequence.size()) continue;
        good = true;
        for (std::size_t i = 0; i < row.more.size(); ++i) {
          const int next = sequence[at + 1 + i];
          good = good && row.more[i].first <= next && next <= row.more[i].second;
        }
        at += 1 + row.more.size();
        break;
      }
    }
    std::string text;
    for (const int byte : sequence) text += static_cast<char>(byte);
    const std::string quoted = '"' + text + '"';
    ASSERT_EQ(accepts(quoted), good) << quoted;
    if (good) {
      ASSERT_EQ(parse_json(quoted).text, text);
    }
  };
  for (int first = 0; first < 256; ++first) {
    if (first == '"' || first == '\\') continue;
    expect({first});
    for (const int second : bytes) {
      expect({first, second});
      if (first < 0xC0) continue;
      for (const int third : bytes) {
        expect({first, second, third});
        if (first < 0xEE) continue;
        for (const int fourth : bytes) expect({first, second, third, fourth});
      }
    }
  }
}

Json number(const std::string& text) {
  return {.kind = Json::Kind::number, .text = text, .elements = {}, .members = {}};
}
Json quoted(const std::string& text) {
  return {.kind = Json::Kind::string, .text = text, .elements = {}, .members = {}};
}

TEST(SecondCheckersNumbers, IndicesFitIn32Bits) {
  for (const std::uint32_t index : {0U, 7U, 99999U, 100000U, 999999999U, 2147483647U, 4294967294U, 4294967295U}) {
    EXPECT_EQ(to_index(number(std::to_string(index))), index);
  }
  for (const char* none :
       {"4294967296", "9999999999", "00000000001", "10000000000", "18446744073709551617", "-1", "1.0", "1e0"}) {
    EXPECT_THROW(static_cast<void>(to_index(number(none))), Malformed) << none;
  }
  EXPECT_THROW(static_cast<void>(to_index(quoted("1"))), Malformed);
}

TEST(SecondCheckersNumbers, RationalsAndDecimalsAreThoseOfTheFormat) {
  // All words of up to five of these letters, as the first checker reads them.
  const std::string letters = "01-/.e+";
  std::vector<std::string> words{""};
  for (int length = 0; length <= 5; ++length) {
    for (const std::string& word : words) {
      const auto compare = [&](const std::optional<mpq_class>& expected, mpq_class (*read)(const Json&)) {
        if (expected) {
          ASSERT_EQ(read(quoted(word)), *expected) << word;
        } else {
          ASSERT_THROW(static_cast<void>(read(quoted(word))), Malformed) << word;
        }
      };
      compare(certify::parse_rational(word), to_rational);
      const bool is_integer = word.find('/') == std::string::npos;
      compare(is_integer ? certify::parse_rational(word) : std::nullopt,
              [](const Json& value) { return mpq_class(to_integer(value)); });
      compare(certify::parse_decimal(word), to_decimal);
    }
    std::vector<std::string> longer;
    for (const std::string& word : words) {
      for (const char letter : letters) longer.push_back(word + letter);
    }
    words = std::move(longer);
  }
  EXPECT_EQ(to_decimal(quoted("0.50E+1")), 5);
  EXPECT_EQ(to_decimal(quoted("-1e-3")), mpq_class(-1, 1000));
  EXPECT_EQ(to_decimal(quoted("1e9999")), 1 / to_decimal(quoted("1e-9999")));
  EXPECT_THROW(static_cast<void>(to_decimal(quoted("1e10000"))), Malformed);
  EXPECT_THROW(static_cast<void>(to_decimal(quoted("1e00000"))), Malformed);
  EXPECT_THROW(static_cast<void>(to_decimal(number("1"))), Malformed);
  EXPECT_THROW(static_cast<void>(to_rational(number("1"))), Malformed);
  EXPECT_THROW(static_cast<void>(to_integer(number("1"))), Malformed);
  EXPECT_THROW(static_cast<void>(to_binary64(quoted("1"))), Malformed);
}

TEST(SecondCheckersNumbers, HaveAMillionDigits) {
  const std::string half(500'000, '7');
  const auto expect_full = [](const std::string& text, auto read) {
    EXPECT_NO_THROW(static_cast<void>(read(quoted(text))));
    EXPECT_NO_THROW(static_cast<void>(read(quoted("-" + text))));
    EXPECT_THROW(static_cast<void>(read(quoted(text + "0"))), Malformed);
    EXPECT_THROW(static_cast<void>(read(quoted("0" + text))), Malformed);
  };
  expect_full(half + half, to_rational);
  expect_full(half + "/" + half, to_rational);
  expect_full(half + half, to_decimal);
  expect_full(half + "." + half, to_decimal);
  expect_full(half + half, to_integer);
}

TEST(SecondCheckersNumbers, DigitsAndExponentsMakeUpForEachOther) {
  const auto compare = [](const std::string& text) {
    const std::optional<double> expected = certify::parse_binary64(text);
    if (!expected) {
      EXPECT_THROW(static_cast<void>(to_binary64(number(text))), Malformed) << text.substr(0, 50);
      return;
    }
    const Binary64 read = to_binary64(number(text));
    mpq_class exact(read.mantissa);
    if (read.exponent < 0) mpq_div_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(-read.exponent));
    if (read.exponent > 0) mpq_mul_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(read.exponent));
    EXPECT_EQ(exact, mpq_class(*expected)) << text.substr(0, 50);
  };
  for (const int zeros : {0, 1, 10, 400, 2000}) {
    for (int exponent = -340; exponent <= 320; exponent += 3) {
      compare("17" + std::string(static_cast<std::size_t>(zeros), '0') + "e" + std::to_string(exponent - zeros));
      compare("-0." + std::string(static_cast<std::size_t>(zeros), '0') + "93e" + std::to_string(exponent + zeros));
    }
  }
  // Ten million zeros behind the point.
  std::string zeros;
  zeros.resize(10'000'000, '0');
  compare("0." + zeros + "1e10000001");
  for (const char* text :
       {"1e-999999999999999999999", "1e999999999999999999999", "-0e999999999999999999999", "0.0e-99999999999999999999",
        "5e-0000000000000000000000001", "5e+0000000000000000000000001", "1e-1000000", "1e1000000"}) {
    compare(text);
  }
}

}  // namespace
}  // namespace epsnet::exact::second_checkers_json_test
