#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <string>

#include "certify/document/text.h"
#include "certify/exact/checker.h"
#include "certify/exact/json.h"

/// The checker of integers alone: the files of tests/data/certify, and its numbers beside those of the first checker.
/// Mutants of nets are in tests/netgen/mutation_test.cpp.
namespace epsnet::exact {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

bool is_left_out(const Result& result) {
  return result.verdict == Verdict::undecided && result.message.starts_with("not for this checker");
}

void expect_verdicts(const std::string& folder, Verdict verdict, int at_least) {
  int decided = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(EPSNET_TEST_DATA) + "/certify/" + folder)) {
    SCOPED_TRACE(entry.path().string());
    const Result result = check(contents(entry.path()));
    if (is_left_out(result)) continue;
    ++decided;
    EXPECT_EQ(result.verdict, verdict) << result.rule << ": " << result.message;
    if (verdict == Verdict::refuted) {
      EXPECT_TRUE(entry.path().filename().string().starts_with(result.rule + "-")) << result.rule;
    }
  }
  EXPECT_GE(decided, at_least);
}

TEST(SecondChecker, CompactFilesAreNotForIt) {
  EXPECT_TRUE(
      is_left_out(check("\x89"
                        "EPSNET\n...")));
  EXPECT_EQ(check("\x89"
                  "EPSNETS")
                .verdict,
            Verdict::malformed);
}

TEST(SecondChecker, VerifiedFilesAreVerified) { expect_verdicts("verified", Verdict::verified, 9); }
TEST(SecondChecker, RefutedFilesAreRefutedByTheRuleInTheirName) { expect_verdicts("refuted", Verdict::refuted, 26); }
TEST(SecondChecker, NearTiesOfThousandsOfDigitsAreUndecided) { expect_verdicts("undecided", Verdict::undecided, 2); }
TEST(SecondChecker, MalformedFilesAreMalformed) { expect_verdicts("malformed", Verdict::malformed, 60); }

TEST(SecondChecker, LeavesOthersFilesOut) {
  const std::string data = EPSNET_TEST_DATA;
  EXPECT_TRUE(is_left_out(check(contents(data + "/certify/verified/regular-2-10-vertices.json"))));
  EXPECT_TRUE(is_left_out(check(contents(data + "/geodesics/three-cuffs.json"))));
  EXPECT_TRUE(is_left_out(check(R"({"format": "epsnet-net", "collars": []})")));
}

TEST(SecondChecker, EverySingleByteRemovedIsNoticedOrHarmless) {
  // A net is read from a text that lost one byte only if the lost byte was white space or one digit of a number; then
  // it is another net, or the same.
  const std::string good = contents(std::string(EPSNET_TEST_DATA) + "/certify/verified/octagon-1-vertex.json");
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string text = good;
    text.erase(i, 1);
    const Result result = check(text);
    const bool harmless = good[i] == ' ' || good[i] == '\n';
    const bool number = good[i] == '-' || good[i] == '.' || good[i] == '/' || (good[i] >= '0' && good[i] <= '9');
    if (harmless) {
      EXPECT_EQ(result.verdict, Verdict::verified) << i << ": " << result.message;
    } else if (!number) {
      EXPECT_EQ(result.verdict, Verdict::malformed) << i;
    }
  }
}

/// A JSON number as people and programs write them, and as they do not.
rc::Gen<std::string> json_number() {
  return rc::gen::apply(
      [](bool negative, std::uint64_t whole, const std::vector<std::uint8_t>& fraction, int exponent) {
        std::string text = (negative ? "-" : "") + std::to_string(whole);
        if (!fraction.empty()) text += '.';
        for (const std::uint8_t digit : fraction) text += static_cast<char>('0' + digit % 10);
        return text + "e" + std::to_string(exponent);
      },
      rc::gen::arbitrary<bool>(), rc::gen::arbitrary<std::uint64_t>(),
      rc::gen::resize(60, rc::gen::arbitrary<std::vector<std::uint8_t>>()), rc::gen::inRange(-360, 320));
}

RC_GTEST_PROP(SecondCheckerProperty, Binary64IsWhatTheFirstCheckerReads, ()) {
  const std::string text = *json_number();
  const std::optional<double> first = certify::parse_binary64(text);
  Json value;
  value.kind = Json::Kind::number;
  value.text = text;
  if (!first) {
    RC_ASSERT_THROWS_AS(static_cast<void>(to_binary64(value)), Malformed);
    return;
  }
  const Binary64 second = to_binary64(value);
  mpq_class exact(second.mantissa);
  if (second.exponent < 0)
    mpq_div_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(-second.exponent));
  if (second.exponent > 0)
    mpq_mul_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(second.exponent));
  RC_ASSERT(exact == mpq_class(*first));
}

TEST(SecondChecker, HalfwayCasesGoToTheEvenNumber) {
  const auto read = [](const std::string& text) {
    Json value;
    value.kind = Json::Kind::number;
    value.text = text;
    const Binary64 number = to_binary64(value);
    mpq_class exact(number.mantissa);
    mpq_div_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(std::max(-number.exponent, 0L)));
    mpq_mul_2exp(exact.get_mpq_t(), exact.get_mpq_t(), static_cast<mp_bitcnt_t>(std::max(number.exponent, 0L)));
    return exact;
  };
  EXPECT_EQ(read("9007199254740993"), mpq_class("9007199254740992"));
  EXPECT_EQ(read("9007199254740993.0000000000000000000000001"), mpq_class("9007199254740994"));
  EXPECT_EQ(read("9007199254740995"), mpq_class("9007199254740996"));
  EXPECT_EQ(read("0.50000000000000000000"), mpq_class(1, 2));
  EXPECT_EQ(read("2.4703282292062327e-324"), 0);
  EXPECT_EQ(read("2.4703282292062328e-324"), mpq_class(0x1p-1074));
  EXPECT_EQ(read("1.7976931348623158e308"), mpq_class(0x1.fffffffffffffp1023));
  EXPECT_THROW(read("1.7976931348623159e308"), Malformed);
}

TEST(SecondCheckersJson, JoinsSurrogatePairsAndRefusesHalves) {
  EXPECT_EQ(parse_json(R"({"a": "\ud83d\ude00"})").members.at(0).value.text, "\xf0\x9f\x98\x80");
  EXPECT_EQ(parse_json(R"({"a": "\ud800\udc00\udbff\udfff"})").members.at(0).value.text,
            "\xf0\x90\x80\x80\xf4\x8f\xbf\xbf");
  for (const char* half : {R"({"a": "\ud83d"})", R"({"a": "\ud83dx"})", R"({"a": "\ud83d\n"})",
                           R"({"a": "\ud83d\ud83d"})", R"({"a": "\ud83d\ue000"})", R"({"a": "\ude00"})"}) {
    EXPECT_THROW(static_cast<void>(parse_json(half)), Malformed) << half;
  }
}

TEST(SecondCheckersJson, RefusesAStringWithoutEnd) {
  for (const char* text : {R"({"a": "b)", R"({"a": "b\)", R"({"a": "\u00)", R"({"a)", "{\""}) {
    EXPECT_THROW(static_cast<void>(parse_json(text)), Malformed) << text;
  }
}

}  // namespace
}  // namespace epsnet::exact
