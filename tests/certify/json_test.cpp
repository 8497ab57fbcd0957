#include "certify/file/json.h"

#include <cstdio>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/file/document_reader.h"

/// Tokens of JSON texts, in memory and across the ends of what is in memory. What files mean is in reader_test.cpp and
/// reader_values_test.cpp.
namespace epsnet::certify::json_test {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 18U;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File file_of(const std::string& bytes) {
  File file(std::tmpfile(), &std::fclose);
  EXPECT_EQ(std::fwrite(bytes.data(), 1, bytes.size(), file.get()), bytes.size());
  std::rewind(file.get());
  return file;
}

/// What a text consists of, as a list of its tokens; then what is wrong.
std::vector<std::string> tokens_of(ByteStream& bytes) {
  std::vector<std::string> result;
  try {
    Json json(bytes);
    while (!json.at_end()) {
      const char next = json.next();
      if (next == '"') {
        result.push_back("string " + std::string(json.string()));
      } else if (std::string_view("[]{},:").find(next) != std::string_view::npos) {
        EXPECT_FALSE(json.take('x'));
        EXPECT_TRUE(json.take(next));
        result.emplace_back(1, next);
      } else {
        result.emplace_back(json.token());
      }
    }
  } catch (const JsonError& error) {
    result.push_back(std::string("error ") + error.what());
  }
  return result;
}
std::vector<std::string> tokens_of(const std::string& text) {
  ByteStream bytes(text);
  return tokens_of(bytes);
}

using Tokens = std::vector<std::string>;

TEST(Json, TokensAreWhatIsBetweenMarks) {
  EXPECT_EQ(tokens_of(" [1,-2.5e+3 ,\ttrue\r\n]{\"a\\n\":null}x\v0"),
            (Tokens{"[", "1", ",", "-2.5e+3", ",", "true", "]", "{", "string a\n", ":", "null", "}", "x\v0"}));
  EXPECT_EQ(tokens_of(std::string("\0 \x80\xff", 4)), (Tokens{std::string("\0", 1), "\x80\xff"}));
  EXPECT_EQ(tokens_of("12\"3\"4"), (Tokens{"12", "string 3", "4"}));
  EXPECT_EQ(tokens_of(""), Tokens());
  EXPECT_EQ(tokens_of(" \n"), Tokens());
}

TEST(Json, WhatIsWrongWithStringsIsSaid) {
  for (const char* text : {"\"", "\"a", "\"\\", "\"\\\"", "\"\\u12", "\"\\ud800\\udc0"}) {
    EXPECT_EQ(tokens_of(text), Tokens{"error a string does not end"}) << text;
  }
  for (const char* text : {"\"\n\"", "\"a\x1f\"", "\"\t"}) {
    EXPECT_EQ(tokens_of(text), Tokens{"error a string has a character that must be escaped"}) << text;
  }
  for (const char* text : {"\"\\x41\"", "\"\\'\"", "\"\\\n\"", "\"\\U0041\""}) {
    EXPECT_EQ(tokens_of(text), Tokens{"error a string has an escape that JSON does not have"}) << text;
  }
  for (const char* text : {"\"\\u\"\"\"\"\"", "\"\\u123g\"", "\"\\u+123\"", "\"\\u 123\""}) {
    EXPECT_EQ(tokens_of(text), Tokens{"error a string has \"\\u\" without four hexadecimal digits"}) << text;
  }
  for (const char* text :
       {"\"\\ud800\"", "\"\\udc00\\ud800\"", "\"\\ud800\\n\"", "\"\\ud800\\ud800\"", "\"\\udfff\""}) {
    EXPECT_EQ(tokens_of(text), Tokens{"error a string has a lone surrogate"}) << text;
  }
  for (const char* text : {"\"\x80\"", "\"\xc3\\u00a9\"", "\"\xed\xa0\x80\"", "\"\\u00c3\xa9\""}) {
    EXPECT_EQ(tokens_of(text), Tokens{"error a string is not valid UTF-8"}) << text;
  }
}

/// Wherever a piece of a file ends, the tokens are the same.
TEST(Json, TokensCrossTheEndsOfPieces) {
  const std::string text = R"({"name" : [12, 345678901,-0.25e-1 ,true], "\u0061\\\"b\ud83d\ude00":"c" , "d":[[]]} )";
  const Tokens tokens = tokens_of(text);
  ASSERT_EQ(tokens.size(), 24U);
  for (std::size_t before = 0; before <= text.size() + 1; ++before) {
    const std::string bytes = std::string(kPiece - before, ' ') + text;
    const File file = file_of(bytes);
    ByteStream pieces(file.get(), bytes.size(), {});
    ASSERT_EQ(tokens_of(pieces), tokens) << before;
  }
}

TEST(Json, TokensMayBeLongerThanPieces) {
  const std::string digits(3 * kPiece + 17, '7');
  for (const std::string& text : {"[" + digits + "]", "[\"" + digits + "\"]"}) {
    const Tokens tokens = tokens_of(text);
    ASSERT_EQ(tokens.size(), 3U);
    EXPECT_TRUE(tokens[1].ends_with(digits));
    const File file = file_of(text);
    ByteStream pieces(file.get(), text.size(), {});
    EXPECT_EQ(tokens_of(pieces), tokens);
  }
}

/// The integer at the beginning of a text of which so many bytes are in memory, if it is taken.
std::optional<std::uint32_t> small_integer(std::string_view text) {
  ByteStream bytes(text);
  Json json(bytes);
  std::uint32_t value = 77;
  const bool taken = json.take_small_integer(value);
  // What is not taken is all there.
  if (!taken) {
    EXPECT_EQ(value, 77U);
    EXPECT_EQ(std::string(json.token()), std::string(text.substr(0, text.find_first_of(" ,]}"))));
  }
  return taken ? std::optional(value) : std::nullopt;
}

TEST(Json, SmallIntegersAreTakenAsAWhole) {
  EXPECT_EQ(small_integer("0,          "), 0U);
  EXPECT_EQ(small_integer("7]          "), 7U);
  EXPECT_EQ(small_integer("1234,       "), 1234U);
  EXPECT_EQ(small_integer("999999999,  "), 999'999'999U);
  for (const char* text : {"1000000000,  ", "4294967295,  ", "4294967296,  ", "00,          ", "01,          ",
                           "-1,          ", "+1,          ", "1.0,         ", "1e0,         ", "1 ,          ",
                           "1}           ", "x,           ", "1x,          ", "1/2,         "}) {
    EXPECT_EQ(small_integer(text), std::nullopt) << text;
  }
  // Near the end of what is in memory nothing is taken.
  for (const char* text : {"1", "1,", "12345678,", "123456789"}) EXPECT_EQ(small_integer(text), std::nullopt) << text;
  // Any byte behind a digit, or in its place.
  for (int byte = 0; byte < 256; ++byte) {
    const char c = static_cast<char>(byte);
    const bool is_digit = c >= '0' && c <= '9';
    const bool is_mark = c == ',' || c == ']';
    const bool is_space = std::string_view(" \t\n\r").find(c) != std::string_view::npos;
    for (const std::string before : {"1", ""}) {
      if (before.empty() && is_space) continue;
      const std::string text = before + c + ",            ";
      ByteStream bytes(text);
      Json json(bytes);
      std::uint32_t value = 0;
      EXPECT_EQ(json.take_small_integer(value), is_digit || (is_mark && !before.empty())) << text;
      EXPECT_EQ(value, is_digit ? std::stoul(before + c) : is_mark && !before.empty() ? 1U : 0U) << text;
    }
  }
}

TEST(Json, WhatIsFoundIsSaid) {
  const auto found = [](const std::string& text) {
    ByteStream bytes(text);
    return Json(bytes).found();
  };
  EXPECT_EQ(found(" "), "the end of the text");
  EXPECT_EQ(found(" [1]"), "an array");
  EXPECT_EQ(found("{"), "an object");
  EXPECT_EQ(found("\"a\\u0062\" 1"), "the string \"ab\"");
  EXPECT_EQ(found(" ,1"), "\",\"");
  EXPECT_EQ(found("-1.5,"), "\"-1.5\"");
  EXPECT_EQ(found(std::string("\0,", 2)), "\"?\"");
}

std::optional<std::string> format(const std::string& text) {
  ByteStream bytes(text);
  return format_of(bytes);
}

TEST(Json, TheFormatIsThatOfTheOutermostObject) {
  EXPECT_EQ(format(R"({"format":"a"})"), "a");
  EXPECT_EQ(format(R"( { "\u0066ormat" : "\u0061" , )"), "a");
  EXPECT_EQ(format(R"({"b":{"format":"c","d":[{},"format",1.5,[]]},"e":"\"}","f":null,"format":"a"})"), "a");
  EXPECT_EQ(format(R"({"format":"","format":"b"})"), "");
  for (const char* text :
       {"", " ", "{", "{}", "[]", R"(["format","a"])", R"({"format")", R"({"format":)", R"({"format":1})",
        R"({"format":["a"]})", R"({"format":{"format":"a"}})", R"({"b":})", R"({"b":]"format":"a"})",
        R"({"b":,"format":"a"})", R"({"b":[[,"format":"a"})", R"({"b":1 2,"format":"a"})", R"({"b":"\x","format":"a"})",
        R"({"b" "c","format":"a"})", R"("format":"a")"}) {
    EXPECT_EQ(format(text), std::nullopt) << text;
  }
  EXPECT_EQ(format(R"({"b":)" + std::string(1'000'000, '[') + std::string(1'000'000, ']') + R"(,"format":"a"})"), "a");
}

}  // namespace
}  // namespace epsnet::certify::json_test
