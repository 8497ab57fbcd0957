#include "certify/base/text.h"

#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace epsnet::certify::text_test {
namespace {

TEST(Text, DecimalsAreExact) {
  EXPECT_EQ(parse_decimal("0.1"), mpq_class(1, 10));
  EXPECT_EQ(parse_decimal("1.25e-1"), mpq_class(1, 8));
  EXPECT_EQ(parse_decimal("25E+2"), mpq_class(2500));
  EXPECT_EQ(parse_decimal("-3/6"), mpq_class(-1, 2));
  for (const char* text :
       {"", ".1", "1.", "1e", "1e+", "1e12345", "1 ", "+1", "1/0", "1/", "/2", "0x1", "1_0", "--1"}) {
    EXPECT_FALSE(parse_decimal(text).has_value()) << text;
  }
}

TEST(Text, DigitsAreCountedWithLeadingZeros) {
  const std::string half(500'000, '0');
  EXPECT_EQ(parse_rational("-" + half + "/" + half.substr(1) + "1"), 0);
  EXPECT_FALSE(parse_rational(half + "/" + half + "1").has_value());
  EXPECT_EQ(parse_decimal("-" + half + "." + half + "e-9999"), 0);
  EXPECT_FALSE(parse_decimal(half + "." + half + "0").has_value());
}

TEST(Text, PathsAreShownAsGivenOnOneLine) {
  EXPECT_EQ(path_in_quotes("a b/n\xc3\xa4he-\xce\xb5.json"), "\"a b/n\xc3\xa4he-\xce\xb5.json\"");
  EXPECT_EQ(path_in_quotes(std::string(300, 'a')), "\"" + std::string(300, 'a') + "\"");
  EXPECT_EQ(path_in_quotes("a\nVERIFIED\n\x1b[2J\x7f\xc2\x9b\"\\"), "\"a?VERIFIED??[2J?????\"");
  EXPECT_EQ(path_in_quotes("\xff\xc3/\xed\xa0\x80\xc0\xaf"),
            "\"?"
            "?/?????\"");
}

mpq_class power(unsigned base, long exponent) {
  mpz_class value;
  mpz_ui_pow_ui(value.get_mpz_t(), base, static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? mpq_class(1) / value : mpq_class(value);
}

/// The value of a JSON number.
mpq_class exact(std::string text) {
  const bool negative = text.starts_with('-');
  if (negative) text.erase(0, 1);
  long exponent = 0;
  if (const auto e = text.find_first_of("eE"); e != std::string::npos) {
    exponent = std::stol(text.substr(e + 1));
    text.erase(e);
  }
  if (const auto point = text.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(text.size() - point - 1);
    text.erase(point, 1);
  }
  const mpq_class value = mpz_class(text, 10) * power(10, exponent);
  return negative ? mpq_class(-value) : value;
}

/// The nearest binary64, ties to even, straight from the definition: infinity stands for overflow.
double nearest(const mpq_class& value) {
  if (value == 0) return 0;
  const mpq_class magnitude = abs(value);
  // 2^e ≤ magnitude < 2^(e + 1), and the last place of a binary64 there.
  long e = static_cast<long>(mpz_sizeinbase(magnitude.get_num_mpz_t(), 2)) -
           static_cast<long>(mpz_sizeinbase(magnitude.get_den_mpz_t(), 2));
  if (magnitude < power(2, e)) --e;
  const long last_place = std::max(e, -1022L) - 52;
  const mpq_class places = magnitude * power(2, -last_place);
  mpz_class below = places.get_num() / places.get_den();
  const int half = cmp(mpq_class(2 * (places - below)), 1);
  if (half > 0 || (half == 0 && mpz_odd_p(below.get_mpz_t()) != 0)) ++below;
  const double rounded = std::ldexp(below.get_d(), static_cast<int>(last_place));
  return value < 0 ? -rounded : rounded;
}

void expect_exact(const std::string& text) {
  SCOPED_TRACE(text.substr(0, 200));
  double wanted = nearest(exact(text));
  if (wanted == 0 && text.starts_with('-')) wanted = -0.0;
  const auto found = parse_binary64(text);
  if (std::isinf(wanted)) {
    EXPECT_FALSE(found.has_value());
    return;
  }
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(std::bit_cast<std::uint64_t>(*found), std::bit_cast<std::uint64_t>(wanted)) << *found << " for " << wanted;
}

/// A rational whose denominator is a power of two, in full.
std::string decimal(mpq_class value) {
  std::string text = value < 0 ? "-" : "";
  value = abs(value);
  mpz_class whole = value.get_num() / value.get_den();
  text += whole.get_str();
  value -= whole;
  if (value == 0) return text;
  text += '.';
  const std::size_t places = mpz_sizeinbase(value.get_den_mpz_t(), 2) - 1;  // 1/2^k has k places.
  const mpq_class scaled = value * power(10, static_cast<long>(places));
  const std::string digits = scaled.get_num().get_str();
  return text + std::string(places - digits.size(), '0') + digits;
}

/// As docs/format.md has them; a denominator is not 0.
const std::regex kDecimal(R"(-?[0-9]+(\.[0-9]+)?([eE][+-]?[0-9]{1,4})?)");
const std::regex kRational("-?[0-9]+(/0*[1-9][0-9]*)?");

/// All texts made of one part of each list, in this order.
std::vector<std::string> joined(const std::vector<std::vector<std::string>>& parts) {
  std::vector<std::string> texts{""};
  for (const auto& part : parts) {
    std::vector<std::string> longer;
    for (const std::string& text : texts) {
      for (const std::string& next : part) longer.push_back(text + next);
    }
    texts = std::move(longer);
  }
  return texts;
}

const std::vector<std::string> kSigns{"", "-", "+", "--", " "};
const std::vector<std::string> kWholes{"", "0", "7", "0012", "90"};
const std::vector<std::string> kTails{"", " ", "x", "-", ".", "e", "/", "\n"};

TEST(Text, DecimalsOfEveryFormAreExactOrRefused) {
  for (const std::string& text :
       joined({kSigns,
               kWholes,
               {"", ".", ".0", ".25", ".0070", "..5", ".x", ".-5"},
               {"",      "e",      "E",      "e3",     "E4",   "e-2", "E-12", "e+10", "e0007", "e-0000",
                "e9999", "e-9999", "e12345", "e00001", "e+-1", "e-",  "e1.5", "e 1",  "e1e1",  "/3"},
               kTails})) {
    const auto found = parse_decimal(text);
    if (text.find('/') != std::string::npos) {
      ASSERT_EQ(found, parse_rational(text)) << text;
      continue;
    }
    ASSERT_EQ(found.has_value(), std::regex_match(text, kDecimal)) << text;
    if (found) {
      ASSERT_EQ(*found, exact(text)) << text;
    }
  }
}

TEST(Text, RationalsOfEveryFormAreExactOrRefused) {
  const std::vector<std::string> denominators{"",    "/",   "/0",   "/000", "/1",  "/4",  "/010", "/36",
                                              "/-4", "/+4", "/4/2", "//4",  "/ 4", "\\4", ":4",   ".4"};
  for (const std::string& text : joined({kSigns, kWholes, denominators, kTails})) {
    const auto found = parse_rational(text);
    ASSERT_EQ(found.has_value(), std::regex_match(text, kRational)) << text;
    if (!found) continue;
    mpq_class value(text, 10);
    value.canonicalize();
    ASSERT_EQ(*found, value) << text;
    ASSERT_EQ(found->get_den(), value.get_den()) << text;
  }
}

/// The length of the well-formed sequence that the text begins with, by the table of the Unicode standard (3-7); 0 if
/// there is none.
std::size_t well_formed(std::string_view text) {
  struct Row {
    int first, last, second_first, second_last;
    std::size_t length;
  };
  constexpr std::array<Row, 9> kRows{{{0x00, 0x7f, 0, 0, 1},
                                      {0xc2, 0xdf, 0x80, 0xbf, 2},
                                      {0xe0, 0xe0, 0xa0, 0xbf, 3},
                                      {0xe1, 0xec, 0x80, 0xbf, 3},
                                      {0xed, 0xed, 0x80, 0x9f, 3},
                                      {0xee, 0xef, 0x80, 0xbf, 3},
                                      {0xf0, 0xf0, 0x90, 0xbf, 4},
                                      {0xf1, 0xf3, 0x80, 0xbf, 4},
                                      {0xf4, 0xf4, 0x80, 0x8f, 4}}};
  const auto is_in = [&](std::size_t i, int first, int last) {
    const int byte = i < text.size() ? static_cast<unsigned char>(text[i]) : -1;
    return first <= byte && byte <= last;
  };
  for (const Row& row : kRows) {
    bool good = is_in(0, row.first, row.last) && (row.length < 2 || is_in(1, row.second_first, row.second_last));
    for (std::size_t i = 2; i < row.length; ++i) good = good && is_in(i, 0x80, 0xbf);
    if (good) return row.length;
  }
  return 0;
}

TEST(Text, IsUtf8IfAllItsCharactersAre) {
  // All texts of at most four bytes where ranges of the table begin or end, or next to it.
  constexpr std::string_view kBytes = "A\x7f\x80\x8f\x90\x9f\xa0\xbf\xc0\xc1\xc2\xdf\xe0\xed\xef\xf0\xf4\xf5\xf8\xff";
  std::vector<std::string> texts{""};
  for (int length = 0; length <= 4; ++length) {
    std::size_t good = 0;
    for (const std::string& text : texts) {
      std::size_t at = 0;
      for (std::size_t size = 1; at < text.size() && size > 0; at += size)
        size = well_formed(std::string_view(text).substr(at));
      ASSERT_EQ(is_utf8(text), at == text.size()) << testing::PrintToString(text);
      good += at == text.size() ? 1 : 0;
    }
    EXPECT_GT(good, length == 0 ? 0U : 1U);
    std::vector<std::string> longer;
    for (const std::string& text : length < 4 ? texts : std::vector<std::string>{}) {
      for (const char byte : kBytes) longer.push_back(text + byte);
    }
    texts = std::move(longer);
  }
}

TEST(ParseBinary64, IsReadToNearestEven) {
  EXPECT_EQ(parse_binary64("0.50000000000000000000"), 0.5);
  EXPECT_EQ(parse_binary64("0.18446744073709551616"), 0.18446744073709551616);
  EXPECT_EQ(parse_binary64("0.1000000000000000055511151231257827021181583404541015625"), 0.1);
  EXPECT_EQ(parse_binary64("9007199254740993"), 9007199254740992.0);  // 2^53 + 1, a tie
  EXPECT_EQ(parse_binary64("9007199254740995"), 9007199254740996.0);
  EXPECT_EQ(parse_binary64("9223372036854776832"), 0x1p63);  // 2^63 + 2^10, a tie, and more.
  EXPECT_EQ(parse_binary64("9223372036854776833"), 0x1p63 + 0x1p11);
  EXPECT_EQ(parse_binary64("9007199254740993.00000000000000000000000000000001"), 9007199254740994.0);
  for (const char* text :
       {"0",
        "-0",
        "0.0",
        "-0.0e5",
        "0e999",
        "-0e-999",
        "1",
        "-1",
        "123456789",
        "0.50000000000000000000",
        "0.18446744073709551616",
        "0.18446744073709551615",
        "0.18446744073709551617",
        "0.36893488147419103232",
        "0.99999999999999999999",
        "0.99999999999999999",
        "1.8446744073709551616",
        "18446744073709551616",
        "184467440737095516160",
        "0.018446744073709551616",
        "1e23",
        "18446744073709551609",
        "18446744073709551615.5",
        "1844674407370955160.9",
        "1844674407370955161.0",
        "9999999999999999999",
        "0.000000009999999999999999999",
        "0.0000000099999999999999999990",
        "0.000000000000000000000000001",
        "0.0000000000000000000000000001",
        "9007199254740993e-27",
        "9007199254740993e-28",
        "9007199254740993e0",
        "4503599627370496.5",
        "4503599627370497.5",
        "4503599627370497.4999",
        "8.5e22",
        "9.5367431640625e-7",
        "1e00000000000000000000000022",
        "1e-00000000000000000000000022",
        "1E+5",
        "1E5",
        "7.2057594037927933e16",
        "2.2250738585072011e-308",
        "2.2250738585072012e-308",
        "2.2250738585072014e-308",
        "4.9406564584124654e-324",
        "5e-324",
        "-5e-324",
        "2.47e-324",
        "2.4703282292062327e-324",
        "2.4703282292062328e-324",
        "2.5e-324",
        "-2.4e-324",
        "1e-323",
        "1e-324",
        "9e-325",
        "1e-400",
        "-1e-400",
        "1.7976931348623157e308",
        "1.7976931348623158e308",
        "1.7976931348623159e308",
        "-1.8e308",
        "1e309",
        "1e400",
        "6.9294956446009195e15",
        "3.2378839133029012895883524125015321748630094231892e-324",
        "17976931348623157e292",
        "0.000000000000000000000000000000000000000000000000000000000000000000000000000000000001e84"}) {
    expect_exact(text);
  }
}

TEST(ParseBinary64, ExponentsOfAnySizeAreRead) {
  EXPECT_EQ(parse_binary64("1e-99999999999999999999999999"), 0.0);
  EXPECT_TRUE(std::signbit(parse_binary64("-1e-99999999999999999999999999").value()));
  EXPECT_EQ(parse_binary64("0e99999999999999999999999999"), 0.0);
  EXPECT_FALSE(parse_binary64("1e99999999999999999999999999").has_value());
  EXPECT_FALSE(parse_binary64("1e9223372036854775807").has_value());
  EXPECT_EQ(parse_binary64("1e-9223372036854775808"), 0.0);
  // Zeros and an exponent that outweigh each other.
  EXPECT_EQ(parse_binary64("0." + std::string(5000, '0') + "5e5000"), 0.5);
  EXPECT_EQ(parse_binary64("5" + std::string(5000, '0') + "e-5001"), 0.5);
  EXPECT_EQ(parse_binary64("0." + std::string(5000, '0') + "5e4677"), 5e-324);
  EXPECT_EQ(parse_binary64("5" + std::string(5000, '0') + "e-5324"), 5e-324);
  EXPECT_EQ(parse_binary64("5" + std::string(5000, '0') + "e-5325"), 0.0);
}

TEST(ParseBinary64, TextThatIsNoJsonNumberIsNone) {
  for (const char* text :
       {"",      "-",    "+1",    ".5",    "5.",    "5.e3",     "-.5",  "00",  "01",    "-01",  "1e",  "1e+",
        "e5",    "0x10", "1p3",   "inf",   "nan",   "Infinity", "-inf", "NaN", "1 ",    " 1",   "1\n", "1,",
        "1_000", "1..2", "1.2.3", "1e2e3", "1e2.5", "--1",      "1-",   "1/2", "\"1\"", "true", "١"}) {
    EXPECT_FALSE(parse_binary64(text).has_value()) << text;
  }
  using namespace std::string_view_literals;
  EXPECT_FALSE(parse_binary64("1\0"sv).has_value());
  // What stands behind the text is no part of it.
  for (const std::string_view more : {"12", "1.5", "1e5", "1E5", "1x"}) EXPECT_EQ(parse_binary64(more.substr(0, 1)), 1);
}

/// Around the tie between a number and the next one up: the tie itself, and as little below and above it as `digits`
/// more digits can say.
void expect_exact_around_tie(double value, std::size_t digits) {
  const double next = std::nextafter(value, std::numeric_limits<double>::infinity());
  const mpq_class upper = std::isinf(next) ? power(2, 1024) : mpq_class(next);
  std::string tie = decimal((mpq_class(value) + upper) / 2);
  if (tie.find('.') == std::string::npos) tie += ".0";
  expect_exact(tie);
  expect_exact(tie + std::string(digits, '0'));
  expect_exact(tie + std::string(digits, '0') + '1');
  expect_exact(tie + std::string(digits, '0') + "10");
  std::string below = tie;
  std::size_t last = below.find_last_not_of(".0");
  --below[last];
  for (++last; last < below.size(); ++last) {
    if (below[last] != '.') below[last] = '9';
  }
  if (below.starts_with('0') && !below.starts_with("0.")) below.erase(0, 1);
  expect_exact(below + std::string(digits, '9'));
}

TEST(ParseBinary64, TiesGoToEven) {
  for (const double value : {0.0,
                             5e-324,
                             1e-323,
                             2.225073858507201e-308,
                             2.2250738585072014e-308,
                             1e-300,
                             1e-30,
                             0.1,
                             0.3,
                             0.5,
                             1.0 - 0x1p-53,
                             1.0,
                             3.0,
                             1e15,
                             1e16,
                             1e22,
                             1e23,
                             1e100,
                             1e300,
                             std::numeric_limits<double>::max()}) {
    for (const std::size_t digits : {0U, 1U, 20U, 400U, 800U, 3000U}) expect_exact_around_tie(value, digits);
  }
}

/// The digits that decide stand as far behind a tie as they may: a reader that cuts numbers off somewhere sees none.
TEST(ParseBinary64, DigitsFarBehindATieCount) {
  for (const double value : {0.0, 5e-324, 2.225073858507201e-308}) {
    for (std::size_t digits = 300; digits < 400; ++digits) expect_exact_around_tie(value, digits);
  }
}

/// A binary64 of any exponent.
rc::Gen<double> any_finite() {
  return rc::gen::map(rc::gen::pair(rc::gen::arbitrary<std::uint64_t>(), rc::gen::inRange<std::uint64_t>(0, 2047)),
                      [](const auto& parts) {
                        constexpr std::uint64_t kExponent = std::uint64_t{0x7ff} << 52U;
                        return std::bit_cast<double>((parts.first & ~kExponent) | (parts.second << 52U));
                      });
}

RC_GTEST_PROP(ParseBinary64Property, ShortestDecimalsComeBack, ()) {
  const double value = *any_finite();
  RC_ASSERT(std::bit_cast<std::uint64_t>(parse_binary64(shortest(value)).value()) ==
            std::bit_cast<std::uint64_t>(value));
}

RC_GTEST_PROP(ParseBinary64Property, DecimalsInFullComeBack, ()) {
  const double value = *any_finite();
  if (value != 0) RC_ASSERT(parse_binary64(decimal(mpq_class(value))) == value);
}

RC_GTEST_PROP(ParseBinary64Property, TiesAreExact, ()) {
  expect_exact_around_tie(std::abs(*any_finite()), *rc::gen::inRange<std::size_t>(0, 800));
  RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(ParseBinary64Property, AnyNumberIsExact, ()) {
  const auto digits = [](int least, int most) {
    const auto size = static_cast<std::size_t>(*rc::gen::inRange(least, most));
    return *rc::gen::container<std::string>(size, rc::gen::elementOf(std::string("0123456789")));
  };
  std::string whole = digits(0, 30);
  whole.erase(0, whole.find_first_not_of('0'));
  std::string text = (*rc::gen::arbitrary<bool>() ? "-" : "") + (whole.empty() ? "0" : whole);
  if (*rc::gen::arbitrary<bool>())
    text += "." + std::string(*rc::gen::inRange<std::size_t>(0, 30), '0') + digits(1, 800);
  if (*rc::gen::arbitrary<bool>()) text += "e" + std::to_string(*rc::gen::inRange(-400, 330));
  expect_exact(text);
  RC_ASSERT(!testing::Test::HasFailure());
}

/// Decimals of up to 19 digits as near to a tie as such decimals are: the last place of an integer of 64 bits decides.
RC_GTEST_PROP(ParseBinary64Property, DecimalsNextToTiesAreExact, ()) {
  const auto places = *rc::gen::inRange<std::size_t>(0, 30);
  const std::uint64_t mantissa =
      (*rc::gen::arbitrary<std::uint64_t>() & ((std::uint64_t{1} << 52U) - 1)) | std::uint64_t{1} << 52U;
  const mpz_class tie = 2 * mpz_class(std::to_string(mantissa)) + 1;
  const mpq_class scaled = tie * power(10, static_cast<long>(places));
  // Times 2^e, so that there are 58 to 64 bits before the point.
  const auto bits = *rc::gen::inRange<long>(58, 65);
  const mpq_class digits = scaled * power(2, bits - static_cast<long>(mpz_sizeinbase(scaled.get_num().get_mpz_t(), 2)));
  const mpz_class floor = digits.get_num() / digits.get_den();
  for (const int more : {-1, 0, 1, 2}) {
    std::string text = mpz_class(floor + more).get_str();
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    if (places > 0) text.insert(text.size() - places, ".");
    expect_exact(text);
  }
  RC_ASSERT(!testing::Test::HasFailure());
}

/// Twenty digits and a little more after "0.", the numbers that simdjson 3.0.1 read modulo 2^64.
RC_GTEST_PROP(ParseBinary64Property, FractionsOfTwentyDigitsAreExact, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(18, 26);
  expect_exact("0." + *rc::gen::container<std::string>(size, rc::gen::elementOf(std::string("0123456789"))));
  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(NearestName, IsTheOneWithTheFewestTypingErrors) {
  const std::vector<std::string> names{"--threads", "--json", "--max-precision", "--max-work"};
  EXPECT_EQ(nearest_name("--thraeds", names), "--threads");
  EXPECT_EQ(nearest_name("--jsn", names), "--json");
  EXPECT_EQ(nearest_name("-json", names), "--json");
  EXPECT_EQ(nearest_name("--max-precison", names), "--max-precision");
  EXPECT_EQ(nearest_name("--max-wrk", names), "--max-work");
}

TEST(NearestName, IsAlsoOneThatBeginsAlike) {
  EXPECT_EQ(nearest_name("--thr", {"--json", "--threads"}), "--threads");
  EXPECT_EQ(nearest_name("eigen", {"epsilon", "eigenvalues"}), "eigenvalues");
}

TEST(NearestName, IsEmptyIfNoneIsNear) {
  EXPECT_EQ(nearest_name("--frobnicate", {"--threads", "--json"}), "");
  EXPECT_EQ(nearest_name("", {"--json"}), "");
  EXPECT_EQ(nearest_name("--json", {}), "");
  EXPECT_EQ(nearest_name(std::string(41, 'a'), {std::string(41, 'a')}), "");
}

}  // namespace
}  // namespace epsnet::certify::text_test
