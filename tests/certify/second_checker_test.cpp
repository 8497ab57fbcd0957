#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <rapidcheck/gtest.h>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/exact/json.h"
#include "certify/file/file.h"
#include "certify/net/numbering.h"
#include "tests/certify/claim_files.h"

/// The second checker: the files of tests/data/certify, and its numbers beside those of the first checker.
/// Mutants of nets are in tests/netgen/mutation_test.cpp.
namespace epsnet::exact::second_checker_test {
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

TEST(SecondChecker, VerifiedFilesAreVerified) { expect_verdicts("verified", Verdict::verified, 15); }
TEST(SecondChecker, RefutedFilesAreRefutedByTheRuleInTheirName) { expect_verdicts("refuted", Verdict::refuted, 26); }
TEST(SecondChecker, NearTiesOfThousandsOfDigitsAreUndecided) { expect_verdicts("undecided", Verdict::undecided, 2); }
TEST(SecondChecker, MalformedFilesAreMalformed) { expect_verdicts("malformed", Verdict::malformed, 60); }

TEST(SecondChecker, VerifiesClaimsOfEveryKindThatItKnows) {
  for (const std::string name : {"bounds/octagon-diameter",
                                 "bounds/octagon-radius",
                                 "bounds/octagon-embedded-disk",
                                 "bounds/regular-diameter",
                                 "bounds/octagon-diameter-base",
                                 "bounds/octagon-radius-base",
                                 "bounds/octagon-embedded-disk-base",
                                 "bounds/octagon-diameter-domain",
                                 "bounds/octagon-radius-domain",
                                 "bounds/octagon-embedded-disk-domain",
                                 "bounds/bolza-radius-domain",
                                 "bounds/two-tiles-embedded-disk-domain",
                                 "distances/four-equal",
                                 "distances/zero",
                                 "distances/across-a-cuff-of-1e-8",
                                 "distances/bolza",
                                 "forgeries/collars",
                                 "forgeries/narrow-collar",
                                 "forgeries/systole",
                                 "geodesics/systole-long-conjugate",
                                 "geodesics/systole-far-from-the-only-vertex",
                                 "geodesics/bolza-to-6.2",
                                 "geodesics/octagon-5-to-6",
                                 "geodesics/three-cuffs",
                                 "geodesics/three-cuffs-and-one-vertex",
                                 "geodesics/two-cuffs-that-differ-by-1e-14",
                                 "geodesics/two-short-cuffs-that-differ-by-1e-17",
                                 "geodesics/no-curve-of-2-arsinh-1-and-1e-20-more",
                                 "geodesics/one-curve-of-2-arsinh-1",
                                 "geodesics/one-curve-of-2-arsinh-1-less-1e-20",
                                 "geodesics/hexagons-with-a-curve-of-2-arsinh-1",
                                 "forgeries/small-curves",
                                 "forgeries/spectrum-with-a-figure-eight",
                                 "isometries/bolza",
                                 "isometries/octagon-5",
                                 "isometries/fenchel-nielsen-3-1",
                                 "isometries/bolza-of-one-vertex",
                                 "pants/octagon-5",
                                 "pants/bolza",
                                 "pants/fenchel-nielsen-2",
                                 "pants/cuff-1e-12",
                                 "curves/klein",
                                 "eigenvalues/octagon-5",
                                 "eigenvalues/octagon-5-of-one-vertex",
                                 "eigenvalues/octagon-5-from-a-quarter",
                                 "eigenvalues/bolza"}) {
    SCOPED_TRACE(name);
    const Result result = check(contents(std::string(EPSNET_TEST_DATA) + "/" + name + ".json"));
    EXPECT_EQ(result.verdict, Verdict::verified) << result.rule << ": " << result.message;
  }
}

TEST(SecondChecker, LeavesListsOutThatAreTooLargeForIt) {
  const std::string text = contents(std::string(EPSNET_TEST_DATA) + "/geodesics/one-cuff-of-1e-8-to-6.5.json");
  EXPECT_EQ(check(text).message, "not for this checker: so many loops of such lengths");
  const std::string spectrum = contents(std::string(EPSNET_TEST_DATA) + "/forgeries/spectrum.json");
  EXPECT_EQ(check(spectrum).verdict, Verdict::verified);
  EXPECT_TRUE(is_left_out(check(spectrum, {100, 100, 100, 100})));
}

TEST(SecondChecker, LeavesBoundsOutThatTakeTooMuchWork) {
  const std::string text = contents(std::string(EPSNET_TEST_DATA) + "/bounds/octagon-diameter-base.json");
  EXPECT_EQ(check(text).verdict, Verdict::verified);
  Limits few = kUsualLimits;
  few.bounds = 10'000;
  EXPECT_EQ(check(text, few).verdict, Verdict::undecided);
  EXPECT_EQ(check(text, few).message, "there are too many cells and triangles for this checker");
}

certify::EigenvaluesDocument eigenvalues(const std::string& name) {
  return certify::read_file<certify::EigenvaluesDocument>(std::string(EPSNET_TEST_DATA) + "/eigenvalues/" + name +
                                                          ".json");
}
Result result_of(const certify::EigenvaluesDocument& document, const Limits& limits = kUsualLimits) {
  std::ostringstream out;
  certify::write_file(document, out);
  return check(out.str(), limits);
}

TEST(SecondChecker, VerifiesEigenfunctionsThatAreNotTooMany) {
  const auto document = eigenvalues("octagon-5-with-a-function");
  const Result result = result_of(document);
  EXPECT_EQ(result.verdict, Verdict::verified) << result.rule << ": " << result.message;
  EXPECT_EQ(result_of(document, {1000, 1000, 1000, 1000}).message, "not for this checker: so many eigenfunctions");
  auto many = document;
  many.eigenfunctions[0].functions.resize(100, many.eigenfunctions[0].functions[0]);
  EXPECT_EQ(result_of(many).message, "not for this checker: so many eigenfunctions");
  // Rows are counted together.
  many = document;
  for (int i = 0; i < 30; ++i) {
    many.eigenfunctions.push_back(document.eigenfunctions[0]);
    many.eigenfunctions.back().in = {5.0 + i, 5.5 + i};
    many.eigenfunctions.back().lambda = 5.25 + i;
  }
  EXPECT_EQ(result_of(many).message, "not for this checker: so many eigenfunctions");
}

TEST(SecondChecker, LeavesMatricesOutThatTakeTooMuchWork) {
  const auto document = eigenvalues("octagon-5");
  EXPECT_EQ(result_of(document, {10, 10, 10, 10}).message, "not for this checker: matrices that take so much work");
  // An order that fills the whole matrix takes less than the limit on one of so few rows, but not a hundred times.
  auto many = document;
  std::sort(many.side_order.begin(), many.side_order.end());
  many.at_most.resize(2000, many.at_most[0]);
  EXPECT_EQ(result_of(many).message, "not for this checker: matrices that take so much work");
  many = document;
  many.at_least.resize(20'000, many.at_least[0]);
  EXPECT_EQ(result_of(many).message, "not for this checker: matrices that take so much work");
  // Six triangles, eight times divided into four.
  auto fine = eigenvalues("octagon-5-of-one-vertex");
  fine.halvings = 8;
  fine.at_least.clear();
  fine.vertex_order.clear();
  fine.side_order.resize(std::size_t{9} << 16);
  std::iota(fine.side_order.begin(), fine.side_order.end(), 0U);
  EXPECT_EQ(result_of(fine).message, "not for this checker: so many halved triangles");
}

/// "VERDICT", or "VERDICT: rule", of the octagon's file with a change.
std::string forged(const std::string& name, const std::function<void(certify::EigenvaluesDocument&)>& change) {
  auto document = eigenvalues(name);
  change(document);
  const Result result = result_of(document);
  static constexpr std::array<const char*, 4> kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  return kNames.at(static_cast<std::size_t>(result.verdict)) + (result.rule.empty() ? "" : ": " + result.rule);
}

TEST(SlowSecondChecker, VerifiesNoForgedEigenvalues) {
  using Document = certify::EigenvaluesDocument;
  const auto octagon = [](const auto& change) { return forged("octagon-5", change); };
  EXPECT_EQ(octagon([](Document&) {}), "VERIFIED");
  EXPECT_EQ(octagon([](Document& d) { --d.at_most[1].count; }), "UNDECIDED: most");
  EXPECT_EQ(octagon([](Document& d) { d.at_most[0].below = d.at_most[0].sigma; }), "UNDECIDED: most");
  EXPECT_EQ(octagon([](Document& d) { d.at_most[0].sigma *= 1.01; }), "UNDECIDED: most");
  EXPECT_EQ(octagon([](Document& d) { d.at_most[0].sigma = 1e308; }), "UNDECIDED: most");
  EXPECT_EQ(octagon([](Document& d) { ++d.at_least[2].count; }), "UNDECIDED: least");
  EXPECT_EQ(octagon([](Document& d) { d.at_least[0].below *= 0.99; }), "UNDECIDED: least");
  EXPECT_EQ(octagon([](Document& d) { d.next = std::nextafter(d.next, 99); }), "REFUTED: enclosures");
  EXPECT_EQ(octagon([](Document& d) { ++d.eigenvalues[0].count; }), "REFUTED: enclosures");
  EXPECT_EQ(octagon([](Document& d) { d.eigenvalues[1].in.lower = std::nextafter(d.eigenvalues[1].in.lower, 99); }),
            "REFUTED: enclosures");
  EXPECT_EQ(octagon([](Document& d) { d.eigenvalues[1].in.upper = std::nextafter(d.eigenvalues[1].in.upper, 0); }),
            "REFUTED: enclosures");
  EXPECT_EQ(octagon([](Document& d) { std::reverse(d.side_order.begin(), d.side_order.end()); }), "VERIFIED");
  const auto one = [](const auto& change) {
    return forged("octagon-5-with-a-function", [&](Document& d) {
      change(d.eigenfunctions[0]);
      d.eigenvalues[0].in = d.eigenfunctions[0].in;
    });
  };
  EXPECT_EQ(one([](auto& f) { f.in.upper = f.lambda + 1e-5; }), "UNDECIDED: eigenfunctions");
  EXPECT_EQ(one([](auto& f) { f.in.lower = f.lambda - 1e-5; }), "UNDECIDED: eigenfunctions");
  EXPECT_EQ(one([](auto& f) { f.radius = 1.9; }), "UNDECIDED: eigenfunctions");
}

TEST(SecondChecker, FindsEigenvaluesOfWrongStructureMalformed) {
  using Document = certify::EigenvaluesDocument;
  using Change = std::function<void(Document&)>;
  const std::vector<Change> of_counts{
      [](Document& d) { d.side_order.pop_back(); },
      [](Document& d) { d.side_order.push_back(static_cast<std::uint32_t>(d.side_order.size())); },
      [](Document& d) { d.side_order[0] = d.side_order[1]; },
      [](Document& d) { d.vertex_order[0] = static_cast<std::uint32_t>(d.vertex_order.size()); },
      [](Document& d) { d.vertex_order[0] = d.vertex_order[1]; },
      [](Document& d) { d.at_most.clear(); },
      [](Document& d) { d.at_least.clear(); },
      [](Document& d) { d.halvings = 2; },
      [](Document& d) { d.halvings = 13; },
      [](Document& d) { d.halvings = ~0U; },
      [](Document& d) { d.next = -1; },
      [](Document& d) { d.eigenvalues[0].count = 0; },
      [](Document& d) { std::swap(d.eigenvalues[0].in.lower, d.eigenvalues[0].in.upper); },
      [](Document& d) { d.eigenvalues[0].in.lower = -1; },
      [](Document& d) { d.at_most[0].below = 0; },
      [](Document& d) { d.at_most[0].below = std::nextafter(d.at_most[0].sigma, 99); },
      [](Document& d) { d.at_least[0].below = 0; },
      [](Document& d) { d.at_least[0].below = -1; },
      [](Document& d) { d.at_least[0].count = 0; },
      [](Document& d) { d.net.collars.emplace(); },
  };
  for (std::size_t i = 0; i < of_counts.size(); ++i) EXPECT_EQ(forged("octagon-5", of_counts[i]), "MALFORMED") << i;
  using Functions = Document::Eigenfunctions;
  const std::vector<std::function<void(Functions&)>> of_functions{
      [](Functions& f) { f.in.lower = 0; },
      [](Functions& f) { f.in.lower = std::nextafter(f.lambda, 99); },
      [](Functions& f) { f.in.upper = std::nextafter(f.lambda, 0); },
      [](Functions& f) { f.radius = std::nextafter(0.9, 0); },
      [](Functions& f) { f.radius = 2; },
      [](Functions& f) { f.functions.clear(); },
      [](Functions& f) { f.functions[0].pop_back(); },
      [](Functions& f) { f.functions[0].resize(std::size_t{9} * 60); },
      [](Functions& f) { f.functions[0].resize(9); },
      [](Functions& f) { f.functions[0].resize(std::size_t{9} * 403, 1); },
      [](Functions& f) { f.functions.push_back({1}); },
      [](Functions& f) { f.functions.emplace_back(f.functions[0].size()); },
      [](Functions& f) { f.functions.resize(1001, std::vector<double>(27, 1)); },
  };
  for (std::size_t i = 0; i < of_functions.size(); ++i) {
    EXPECT_EQ(forged("octagon-5-with-a-function", [&](Document& d) { of_functions[i](d.eigenfunctions[0]); }),
              "MALFORMED")
        << i;
  }
  const auto second_row = [](double from) {
    return forged("octagon-5-with-a-function", [&](Document& d) {
      d.eigenfunctions[0].functions = {std::vector<double>(27, 1)};
      d.eigenfunctions.push_back(d.eigenfunctions[0]);
      d.eigenfunctions[1].in = {from, 3};
      d.eigenfunctions[1].lambda = 2.9;
    });
  };
  EXPECT_EQ(second_row(2.795), "MALFORMED");
  EXPECT_EQ(second_row(std::nextafter(2.795, 3)), "UNDECIDED: eigenfunctions");
  // The third row and the second one have points in common; the first one is elsewhere.
  const auto third_row = [](double from) {
    return forged("octagon-5-with-a-function", [&](Document& d) {
      d.eigenfunctions[0].functions = {std::vector<double>(27, 1)};
      d.eigenfunctions.resize(3, d.eigenfunctions[0]);
      d.eigenfunctions[1].in = {2.8, 2.9};
      d.eigenfunctions[1].lambda = 2.85;
      d.eigenfunctions[2].in = {from, 3};
      d.eigenfunctions[2].lambda = 2.95;
    });
  };
  EXPECT_EQ(third_row(2.85), "MALFORMED");
  EXPECT_EQ(third_row(2.9), "MALFORMED");
  EXPECT_EQ(third_row(std::nextafter(2.9, 3)), "UNDECIDED: eigenfunctions");
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

// Documents that are wrong in one place, as both checkers see them.

using certify::NetDocument;
using certify::RationalPoint;
using certify::SurfaceDocument;

template <class Document>
std::string text_of(const Document& document) {
  std::ostringstream out;
  certify::write_file(document, out);
  return out.str();
}

/// The verdict, and the rule of a net that is refuted.
std::string outcome(const Result& result) {
  constexpr std::array<const char*, 4> kNames{"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
  return kNames[static_cast<std::size_t>(result.verdict)] + (result.rule.empty() ? "" : ": " + result.rule);
}

/// The triangle, edge or dart that a message names first, of rules whose messages begin with it.
std::string place(const std::string& message) {
  std::smatch found;
  return std::regex_search(message, found, std::regex("^(triangle|the edge of dart|dart) [0-9]+")) ? found.str() : "";
}

/// That both checkers say so, and name the same triangle or edge, the first one in the file. For the first checker a
/// document, whatever it says, has been read already.
template <class Document>
void expect_of_both(const Document& document, const std::string& expected) {
  const Result second = check(text_of(document));
  EXPECT_EQ(outcome(second), expected) << second.message;
  const certify::Certificate first = certify::check(document, {.threads = 1});
  EXPECT_EQ(std::string(name(first.verdict)) + (first.verdict == certify::Verdict::refuted ? ": " + first.rule : ""),
            expected)
      << first.message;
  if (second.verdict == Verdict::refuted) {
    EXPECT_EQ(place(second.message), place(first.message));
  }
}

template <class Document = NetDocument>
Document load(const std::string& name) {
  return certify::read_file<Document>(std::string(EPSNET_TEST_DATA) + "/" + name);
}

/// A net on two tiles in six charts.
NetDocument two_tiles() {
  NetDocument document = load("forgeries/collars.json");
  document.collars.reset();
  return document;
}

constexpr std::uint32_t kHuge = std::numeric_limits<std::uint32_t>::max();

/// Any index of the first, the middle and the last row of a table, one too large and as large as can be.
template <class Row, class Indices>
void expect_no_index_beyond(std::vector<Row> NetDocument::*table, const Indices& indices) {
  const NetDocument good = two_tiles();
  const std::size_t rows = (good.*table).size();
  for (const std::size_t i : {std::size_t{0}, rows / 2, rows - 1}) {
    Row row = (good.*table)[i];
    const auto places = indices(good, row);
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (const std::uint32_t wrong : {static_cast<std::uint32_t>(places[k].second), kHuge}) {
        SCOPED_TRACE(std::to_string(i) + ", index " + std::to_string(k) + ": " + std::to_string(wrong));
        NetDocument document = good;
        *indices(document, (document.*table)[i])[k].first = wrong;
        expect_of_both(document, "MALFORMED");
      }
    }
  }
}

using Places = std::vector<std::pair<std::uint32_t*, std::size_t>>;  ///< Indices, and how many there are of the kind.

TEST(BothCheckers, NoIndexNamesWhatIsNotThere) {
  expect_no_index_beyond(&NetDocument::charts, [](const NetDocument& d, NetDocument::Chart& chart) -> Places {
    return {{&chart.tile, d.surface.tiles.size()}};
  });
  expect_no_index_beyond(&NetDocument::labels, [](const NetDocument& d, NetDocument::Label& label) {
    Places places{{&label.from, d.charts.size()}, {&label.to, d.charts.size()}};
    for (std::uint32_t& letter : label.word) places.emplace_back(&letter, 14);
    return places;
  });
  expect_no_index_beyond(&NetDocument::vertices, [](const NetDocument& d, NetDocument::Vertex& vertex) -> Places {
    return {{&vertex.chart, d.charts.size()}};
  });
  expect_no_index_beyond(&NetDocument::triangles, [](const NetDocument& d, NetDocument::Triangle& triangle) {
    Places places;
    for (std::uint32_t& vertex : triangle.vertex) places.emplace_back(&vertex, d.vertices.size());
    for (std::uint32_t& dart : triangle.opposite) places.emplace_back(&dart, 3 * d.triangles.size());
    for (std::uint32_t& label : triangle.label) places.emplace_back(&label, d.labels.size() + 1);
    return places;
  });
}

TEST(BothCheckers, NoIndexOfWhatNothingUsesNamesWhatIsNotThere) {
  NetDocument document = two_tiles();
  document.charts.push_back({2, {0, 0}});
  expect_of_both(document, "MALFORMED");
  document.charts.back().tile = kHuge;
  expect_of_both(document, "MALFORMED");
  document = two_tiles();
  const std::uint32_t charts = static_cast<std::uint32_t>(document.charts.size());
  for (const std::uint32_t wrong : {charts, kHuge}) {
    document.labels = two_tiles().labels;
    document.labels.push_back({wrong, 0, {}});
    expect_of_both(document, "MALFORMED");
    document.labels.back() = {0, wrong, {}};
    expect_of_both(document, "MALFORMED");
  }
  document = two_tiles();
  document.vertices.push_back({0, 0, kHuge});
  expect_of_both(document, "MALFORMED");
  document.vertices.back() = {1, 0, 0};
  expect_of_both(document, "MALFORMED");
}

TEST(BothCheckers, WordsThatNothingUsesArePathsToo) {
  const NetDocument good = two_tiles();
  std::array<std::optional<std::uint32_t>, 2> chart;  // One in each tile.
  for (std::uint32_t c = 0; c < good.charts.size(); ++c) chart[good.charts[c].tile] = c;
  const auto tile_behind = [&](std::uint32_t tile, std::uint32_t side) {
    for (const SurfaceDocument::Gluing& g : good.surface.gluing) {
      if (g.tile == tile && g.side == side) return g.other_tile;
      if (g.other_tile == tile && g.other_side == side) return g.tile;
    }
    return kHuge;
  };
  for (std::uint32_t tile = 0; tile < 2; ++tile) {
    const std::uint32_t here = *chart.at(tile);
    const std::uint32_t there = *chart.at(1 - tile);
    NetDocument document = good;
    document.labels.push_back({here, there, {}});
    expect_of_both(document, "MALFORMED");
    for (std::uint32_t k = 0; k < 7; ++k) {
      // Crossing side k of the other tile, from here.
      const std::uint32_t behind = *chart.at(tile_behind(1 - tile, k));
      document = good;
      document.labels.push_back({here, behind, {7 * (1 - tile) + k}});
      expect_of_both(document, "MALFORMED");
    }
  }
}

TEST(BothCheckers, LabelsLeadFromTheCornersChartToThatOfTheTriangle) {
  const NetDocument good = two_tiles();
  int tried = 0;
  for (std::size_t t = 0; t < good.triangles.size(); ++t) {
    const std::uint32_t chart = good.vertices[good.triangles[t].vertex[0]].chart;
    for (std::size_t i = 1; i < 3 && tried < 12; ++i) {
      const std::uint32_t number = good.triangles[t].label[i - 1];
      if (number == 0) continue;
      ++tried;
      if (good.vertices[good.triangles[t].vertex[i]].chart != chart) {
        NetDocument document = good;
        document.triangles[t].label[i - 1] = 0;
        expect_of_both(document, "MALFORMED");
      }
      // The same word between other charts of the same tiles.
      for (std::uint32_t other = 0; other < good.charts.size(); ++other) {
        NetDocument::Label label = good.labels[number - 1];
        NetDocument document = good;
        document.triangles[t].label[i - 1] = static_cast<std::uint32_t>(good.labels.size() + 1);
        for (std::uint32_t NetDocument::Label::*end : {&NetDocument::Label::from, &NetDocument::Label::to}) {
          if (other == label.*end || good.charts[other].tile != good.charts[label.*end].tile) continue;
          document.labels = good.labels;
          document.labels.push_back(label);
          document.labels.back().*end = other;
          expect_of_both(document, "MALFORMED");
        }
      }
    }
  }
  EXPECT_EQ(tried, 12);
}

TEST(BothCheckers, EverySideIsGluedOnce) {
  const NetDocument good = load("certify/verified/octagon-9-vertices.json");
  const auto expect = [&](const std::vector<std::array<std::uint32_t, 2>>& pairs, const std::string& expected) {
    NetDocument document = good;
    document.surface.gluing.clear();
    for (const auto& [k, j] : pairs) document.surface.gluing.push_back({0, k, 0, j});
    expect_of_both(document, expected);
  };
  expect({{0, 4}, {1, 5}, {2, 6}, {3, 7}}, "VERIFIED");
  // Side 0 again and again, first and second in its pair: every other side is glued once.
  expect({{0, 4}, {2, 6}, {3, 7}, {0, 5}, {0, 1}}, "MALFORMED");
  expect({{4, 0}, {6, 2}, {7, 3}, {5, 0}, {1, 0}}, "MALFORMED");
  expect({{0, 4}, {1, 5}, {2, 6}, {3, 7}, {3, 7}}, "MALFORMED");
  expect({{0, 4}, {1, 5}, {2, 6}, {3, 3}, {7, 7}}, "MALFORMED");
  expect({{0, 4}, {1, 5}, {2, 6}}, "MALFORMED");
  expect({{1, 5}, {2, 6}, {3, 7}}, "MALFORMED");
  for (const std::uint32_t wrong : {8U, kHuge}) {
    expect({{0, 4}, {1, 5}, {2, 6}, {3, wrong}}, "MALFORMED");
    expect({{0, 4}, {1, 5}, {2, 6}, {wrong, 7}}, "MALFORMED");
  }
  for (const std::uint32_t wrong : {1U, kHuge}) {
    NetDocument document = good;
    document.surface.gluing.back() = {wrong, 3, 0, 7};
    expect_of_both(document, "MALFORMED");
    document.surface.gluing.back() = {0, 3, wrong, 7};
    expect_of_both(document, "MALFORMED");
  }
}

TEST(BothCheckers, ATileHasThreeVerticesAndThereIsOne) {
  NetDocument document = load("certify/verified/octagon-9-vertices.json");
  const SurfaceDocument::Tile tile = document.surface.tiles[0];
  for (std::uint32_t size = 0; size < 3; ++size) {
    document.surface.tiles = {tile, {tile.begin(), tile.begin() + size}};
    document.surface.gluing.resize(4);
    if (size == 2) document.surface.gluing.push_back({1, 0, 1, 1});
    expect_of_both(document, "MALFORMED");
  }
  document = {};
  document.epsilon = "1";
  expect_of_both(document, "MALFORMED");
}

// Thick-thin decompositions that are wrong in one place.

using certify::GeodesicsDocument;

/// Two pairs of pants with three cuffs in common, on which vertices of the net lie.
GeodesicsDocument three_cuffs() { return load<GeodesicsDocument>("geodesics/three-cuffs.json"); }
/// The same on another surface, on a net of one vertex: geodesics cross an edge several times.
GeodesicsDocument one_vertex() { return load<GeodesicsDocument>("geodesics/three-cuffs-and-one-vertex.json"); }
/// Regular hexagons; the only small curve has the length 2 arsinh 1.
GeodesicsDocument hexagons() { return load<GeodesicsDocument>("geodesics/hexagons-with-a-curve-of-2-arsinh-1.json"); }

/// The runs that the lengths make if none meet.
void make_runs(GeodesicsDocument& document) {
  document.clusters.clear();
  for (std::uint32_t i = 0; i < document.geodesics.size(); ++i) document.clusters.push_back({i, 1, false});
}

TEST(BothCheckers, ThickThinLengthsAreEnclosedAndAtMost2Arsinh1) {
  GeodesicsDocument document = three_cuffs();
  document.geodesics[2].length = {1.3, 1.4};
  expect_of_both(document, "REFUTED: geodesics");
  // A curve longer by 10⁻²⁰ is not to be listed, and one shorter by that is.
  document = load<GeodesicsDocument>("geodesics/no-curve-of-2-arsinh-1-and-1e-20-more.json");
  const GeodesicsDocument shorter = load<GeodesicsDocument>("geodesics/one-curve-of-2-arsinh-1-less-1e-20.json");
  document.geodesics = shorter.geodesics;
  document.clusters = shorter.clusters;
  document.pieces = shorter.pieces;
  expect_of_both(document, "REFUTED: geodesics");
  document.net = shorter.net;
  expect_of_both(document, "VERIFIED");
}

TEST(BothCheckers, ThickThinListsHaveEachCurveOnceAndNoneIsMissing) {
  for (const GeodesicsDocument& good :
       {three_cuffs(), hexagons(), load<GeodesicsDocument>("geodesics/one-curve-of-2-arsinh-1-less-1e-20.json")}) {
    for (std::uint32_t i = 0; i < good.geodesics.size(); ++i) {
      GeodesicsDocument document = good;
      document.geodesics.erase(document.geodesics.begin() + i);
      make_runs(document);
      for (GeodesicsDocument::Piece& piece : document.pieces) {
        std::erase_if(piece.boundaries, [&](const auto& side) { return side.first == i; });
        for (auto& [geodesic, side] : piece.boundaries) geodesic -= geodesic > i ? 1 : 0;
      }
      expect_of_both(document, "REFUTED: complete");
    }
    GeodesicsDocument document = good;
    const auto last = static_cast<std::uint32_t>(good.geodesics.size());
    document.geodesics.push_back(good.geodesics.back());
    document.clusters.back().count = 2;
    document.pieces.push_back({0, {{last, 0}, {last, 1}}});
    expect_of_both(document, "REFUTED: distinct");
  }
}

TEST(BothCheckers, ThickThinCurvesAreSimpleAndAsLongAsOthersOnlyIfTheyAre) {
  GeodesicsDocument document = three_cuffs();
  document.geodesics[1].simple = false;
  expect_of_both(document, "REFUTED: simple");
  document = load<GeodesicsDocument>("geodesics/two-cuffs-that-differ-by-1e-14.json");
  for (auto& geodesic : document.geodesics) geodesic.length = {0.4, 1.3};
  document.clusters = {{0, 3, true}};
  expect_of_both(document, "REFUTED: equal");
}

TEST(BothCheckers, PiecesAreThoseOfTheCutSurface) {
  for (const GeodesicsDocument& good : {three_cuffs(), one_vertex(), hexagons()}) {
    GeodesicsDocument document = good;
    std::reverse(document.pieces.begin(), document.pieces.end());
    for (auto& piece : document.pieces) std::reverse(piece.boundaries.begin(), piece.boundaries.end());
    expect_of_both(document, "VERIFIED");
    ++document.pieces[0].genus;
    expect_of_both(document, "REFUTED: pieces");
    document = good;
    document.pieces.push_back({0, {}});
    expect_of_both(document, "REFUTED: pieces");
    // A side in a piece of its own.
    document.pieces.back().boundaries.push_back(document.pieces[0].boundaries.back());
    document.pieces[0].boundaries.pop_back();
    expect_of_both(document, "REFUTED: pieces");
  }
  GeodesicsDocument document = three_cuffs();
  auto& boundaries = document.pieces[0].boundaries;
  // A side moved, and two pieces made one.
  boundaries.push_back(document.pieces[1].boundaries.back());
  document.pieces[1].boundaries.pop_back();
  expect_of_both(document, "REFUTED: pieces");
  boundaries.insert(boundaries.end(), document.pieces[1].boundaries.begin(), document.pieces[1].boundaries.end());
  document.pieces.pop_back();
  expect_of_both(document, "REFUTED: pieces");
}

/// By side, numbered through all tiles: the other one of its pair.
std::map<std::uint32_t, std::uint32_t> partners(const SurfaceDocument& surface) {
  const auto number = [&](std::uint32_t tile, std::uint32_t side) {
    for (std::uint32_t t = 0; t < tile; ++t) side += static_cast<std::uint32_t>(surface.tiles[t].size());
    return side;
  };
  std::map<std::uint32_t, std::uint32_t> result;
  for (const SurfaceDocument::Gluing& g : surface.gluing) {
    const std::uint32_t one = number(g.tile, g.side);
    const std::uint32_t other = number(g.other_tile, g.other_side);
    result[one] = other;
    result[other] = one;
  }
  return result;
}

TEST(BothCheckers, SidesOfPiecesAreThoseOfDirectedGeodesics) {
  for (const GeodesicsDocument& good : {three_cuffs(), one_vertex()}) {
    const auto partner = partners(good.net.surface);
    for (std::uint32_t i = 0; i < 3; ++i) {
      GeodesicsDocument document = good;
      for (auto& piece : document.pieces) {
        for (auto& boundary : piece.boundaries) {
          if (boundary.first == i) boundary.second = 1 - boundary.second;
        }
      }
      expect_of_both(document, "REFUTED: pieces");
      auto& word = document.geodesics[i].word;
      std::reverse(word.begin(), word.end());
      for (std::uint32_t& letter : word) letter = partner.at(letter);
      expect_of_both(document, "VERIFIED");
    }
  }
}

TEST(BothCheckers, EverySideOfAGeodesicIsInOnePiece) {
  const GeodesicsDocument good = three_cuffs();
  const auto expect_malformed = [&](const std::pair<std::uint32_t, std::uint32_t>& boundary) {
    GeodesicsDocument document = good;
    document.pieces[0].boundaries[0] = boundary;
    expect_of_both(document, "MALFORMED");
  };
  expect_malformed(good.pieces[0].boundaries[1]);
  expect_malformed(good.pieces[1].boundaries[0]);
  expect_malformed({good.pieces[0].boundaries[0].first, 2});
  expect_malformed({3, 0});
  expect_malformed({kHuge, kHuge});
  GeodesicsDocument document = good;
  document.pieces[0].boundaries.pop_back();
  expect_of_both(document, "MALFORMED");
  document.pieces.clear();
  expect_of_both(document, "MALFORMED");
}

/// A surface with opposite sides glued.
SurfaceDocument with_opposite_sides_glued(const SurfaceDocument::Tile& corners) {
  SurfaceDocument surface;
  surface.tiles = {corners};
  const auto half = static_cast<std::uint32_t>(corners.size() / 2);
  for (std::uint32_t k = 0; k < half; ++k) surface.gluing.push_back({0, k, 0, k + half});
  return surface;
}

/// An octagon of two kinds of sides whose angles add up to 2π, symmetric to both axes, which meet sides 0 and 4, and 2
/// and 6, in their midpoints: opposite sides have crossings along the axes.
SurfaceDocument::Tile octagon_on_axes() {
  const mpq_class x(5, 7);
  const mpq_class y(4, 7);
  return {{x, -y}, {x, y}, {y, x}, {-y, x}, {-x, y}, {-x, -y}, {-y, -x}, {y, -x}};
}

NetDocument without_net(const SurfaceDocument& surface) {
  NetDocument document;
  document.surface = surface;
  document.epsilon = "1";
  return document;
}

/// What is said of a surface that has no net: rule `map` refutes it, if rule `surface` does not.
Result surface_alone(const SurfaceDocument& surface) {
  const NetDocument document = without_net(surface);
  Result second = check(text_of(document));
  expect_of_both(document, outcome(second));
  return second;
}

TEST(BothCheckers, ATranslationAlongAnAxisIsNotTheIdentity) {
  // A corner with the label 0 between two others with the label 0 gets a label of one letter, a translation along the
  // real or the imaginary axis: of the numbers a and b of the quotient in (∗) one is not that of the identity.
  NetDocument good = load("certify/verified/octagon-33-vertices.json");
  good.surface = with_opposite_sides_glued(octagon_on_axes());
  int tried = 0;
  for (std::uint32_t dart = 0; dart < 3 * good.triangles.size(); ++dart) {
    const std::uint32_t after = certify::next_dart(certify::opposite(good, dart));
    const std::uint32_t before = certify::opposite(good, certify::previous_dart(dart));
    const bool free = dart % 3 != 0 && corner_label(good, dart) == 0 && corner_label(good, after) == 0 &&
                      corner_label(good, before) == 0;
    if (!free) continue;
    ++tried;
    for (const std::uint32_t side : {0U, 2U, 4U, 6U}) {
      NetDocument document = good;
      document.labels.push_back({0, 0, {side}});
      document.triangles[dart / 3].label[dart % 3 - 1] = static_cast<std::uint32_t>(document.labels.size());
      expect_of_both(document, "REFUTED: gluing");
    }
  }
  EXPECT_GT(tried, 20);
  EXPECT_NE(outcome(check(text_of(good))), "REFUTED: gluing");
}

/// (z + c)/(1 + cz) with a real c.
RationalPoint translated(const RationalPoint& z, const mpq_class& c) {
  const mpq_class re = 1 + c * z.x;
  const mpq_class im = c * z.y;
  const mpq_class size = re * re + im * im;
  const mpq_class x = z.x + c;
  return {(x * re + z.y * im) / size, (z.y * re - x * im) / size};
}

TEST(BothCheckers, ARotationAboutTheOriginIsNotTheIdentity) {
  // The octagon with the corners a, (1 + i)b and so on: its angles add up to 2π if and only if ab = 1/2. With a corner
  // at the origin the crossings around it multiply to a rotation about the origin.
  for (const auto& [a, b] : {std::pair{mpq_class(5, 6), mpq_class(3, 5)},
                             {mpq_class(5, 6), mpq_class(16, 25)},
                             {mpq_class(5, 6), mpq_class(14, 25)},
                             {mpq_class(9, 10), mpq_class(1, 2)}}) {
    SurfaceDocument::Tile corners{{a, 0}, {b, b}, {0, a}, {-b, b}, {-a, 0}, {-b, -b}, {0, -a}, {b, -b}};
    for (RationalPoint& z : corners) z = translated(z, -a);
    ASSERT_EQ(corners[0], (RationalPoint{0, 0}));
    const Result result = surface_alone(with_opposite_sides_glued(corners));
    if (a * b * 2 == 1) {
      EXPECT_EQ(outcome(result), "REFUTED: map");
    } else {
      EXPECT_EQ(outcome(result), "REFUTED: surface");
      EXPECT_NE(result.message.find("do not close up"), std::string::npos) << result.message;
    }
  }
}

TEST(BothCheckers, TilesMayBeConnectedByOneSideAlone) {
  // Two tori with a boundary, one behind the only side that they share: the octagon cut through its centre, with the
  // shared side as number `shared` of both.
  const SurfaceDocument::Tile corners = octagon_on_axes();
  for (std::uint32_t shared = 0; shared < 5; ++shared) {
    SurfaceDocument surface;
    surface.tiles.resize(2);
    const auto side = [&](std::uint32_t k) { return (k + shared + 1) % 5; };  // Side 4 is the shared one.
    for (std::uint32_t t = 0; t < 2; ++t) {
      surface.tiles[t].resize(5);
      for (std::uint32_t k = 0; k < 5; ++k) surface.tiles[t][side(k)] = corners[(4 * t + k) % 8];
      surface.gluing.push_back({t, side(0), t, side(2)});
      surface.gluing.push_back({t, side(1), t, side(3)});
    }
    surface.gluing.push_back({0, shared, 1, shared});
    EXPECT_EQ(outcome(surface_alone(surface)), "REFUTED: map") << shared;
  }
}

/// What the first checker says of a surface that has no net.
std::string message_of_first(const SurfaceDocument& surface) {
  return certify::check(without_net(surface), {.threads = 1}).message;
}

/// That both checkers say so of a tile with opposite sides glued, which are not of equal length: it is asked before.
void expect_messages(const SurfaceDocument::Tile& tile, const std::string& first, const std::string& second) {
  const SurfaceDocument surface = with_opposite_sides_glued(tile);
  const Result result = surface_alone(surface);
  EXPECT_EQ(result.rule, "surface");
  EXPECT_NE(result.message.find(second), std::string::npos) << result.message;
  EXPECT_NE(message_of_first(surface).find(first), std::string::npos) << message_of_first(surface);
}

TEST(BothCheckers, EveryVertexOfATileIsInTheDisk) {
  for (std::size_t k = 0; k < 8; ++k) {
    for (const mpq_class& size : {mpq_class(1), mpq_class(3, 2)}) {
      SurfaceDocument::Tile tile = octagon_on_axes();
      const bool upright = abs(tile[k].y) > abs(tile[k].x);
      tile[k] = {sgn(tile[k].x) * size * (upright ? 3 : 4) / 5, sgn(tile[k].y) * size * (upright ? 4 : 3) / 5};
      expect_messages(tile, "vertex " + std::to_string(k) + " of tile 0 is not inside the unit disk",
                      "outside of the disk");
    }
  }
}

/// A point near r e^{iφ}, φ in degrees.
RationalPoint polar(double r, double degrees) {
  return {mpq_class(r * std::cos(degrees * M_PI / 180)), mpq_class(r * std::sin(degrees * M_PI / 180))};
}

SurfaceDocument::Tile rotated(const SurfaceDocument::Tile& tile, std::size_t first) {
  SurfaceDocument::Tile result(tile.begin() + static_cast<std::ptrdiff_t>(first), tile.end());
  result.insert(result.end(), tile.begin(), tile.begin() + static_cast<std::ptrdiff_t>(first));
  return result;
}

TEST(BothCheckers, TilesAreStrictlyConvexAtEveryCorner) {
  // A flat corner, on the real axis, as any corner of the tile; and one that turns to the right.
  const SurfaceDocument::Tile flat{{0, 0},         {mpq_class(1, 2), 0}, polar(0.5, 40),
                                   polar(0.5, 80), polar(0.5, 130),      {mpq_class(-1, 2), 0}};
  SurfaceDocument::Tile dented = flat;
  dented[0].y = mpq_class(1, 100);
  for (std::size_t k = 0; k < flat.size(); ++k) {
    expect_messages(rotated(flat, k), "strictly convex", "strictly convex");
    expect_messages(rotated(dented, k), "strictly convex", "strictly convex");
  }
}

TEST(BothCheckers, EveryCornerClosesUp) {
  // The octagon with the corners a, (1 + i)b and so on, cut from its centre into eight tiles: around the centre the
  // angles add up to 2π, around the other corner if and only if ab = 1/2. Either is the corner that comes first.
  for (const auto& [a, b] : {std::pair{mpq_class(5, 6), mpq_class(3, 5)},
                             {mpq_class(5, 6), mpq_class(16, 25)},
                             {mpq_class(5, 6), mpq_class(14, 25)}}) {
    const SurfaceDocument::Tile corners{{a, 0}, {b, b}, {0, a}, {-b, b}, {-a, 0}, {-b, -b}, {0, -a}, {b, -b}};
    for (const std::uint32_t first : {0U, 1U, 2U}) {
      SurfaceDocument surface;
      const auto side = [&](std::uint32_t k) { return (k + 3 - first) % 3; };
      for (std::uint32_t t = 0; t < 8; ++t) {
        surface.tiles.push_back(rotated({{0, 0}, corners[t], corners[(t + 1) % 8]}, first));
        surface.gluing.push_back({t, side(2), (t + 1) % 8, side(0)});
        if (t < 4) surface.gluing.push_back({t, side(1), t + 4, side(1)});
      }
      const Result result = surface_alone(surface);
      if (a * b * 2 == 1) {
        EXPECT_EQ(outcome(result), "REFUTED: map") << first;
      } else {
        EXPECT_EQ(outcome(result), "REFUTED: surface") << first;
        EXPECT_NE(result.message.find("do not close up"), std::string::npos) << result.message;
      }
    }
  }
}

TEST(BothCheckers, TilesThatWindTwiceAreNotConvex) {
  // Left turns everywhere. Around vertex 0 in order, but through more than a full turn:
  SurfaceDocument::Tile tile{{0, 0}};
  for (int k = 0; k < 5; ++k) tile.push_back(polar(0.5, 100.0 * k));
  expect_messages(tile, "strictly convex", "strictly convex");
  // On the left of its first side, with a loop inside: not in order around vertex 0.
  tile.clear();
  for (int k = 0; k < 16; ++k) {
    const double angle = 22.5 * k + 11.25 - 22.5;
    tile.push_back(polar(0.1 * (1 + 2 * std::cos(angle * M_PI / 180)), angle));
  }
  expect_messages(tile, "strictly convex", "strictly convex");
}

TEST(BothCheckers, GluedSidesHaveEqualLengths) {
  // Sides of even numbers have one length, those of odd numbers another one. In each of the two ways to glue them to
  // a surface of genus 2 the sides that are glued to one of the other kind come before it.
  using Pairs = std::array<std::array<std::uint32_t, 2>, 4>;
  for (const Pairs& pairs : {Pairs{{{0, 3}, {1, 5}, {2, 7}, {4, 6}}}, Pairs{{{0, 2}, {1, 4}, {3, 6}, {5, 7}}}}) {
    SurfaceDocument surface;
    surface.tiles = {octagon_on_axes()};
    for (const auto& [k, j] : pairs) surface.gluing.push_back({0, k, 0, j});
    const Result result = surface_alone(surface);
    EXPECT_EQ(outcome(result), "REFUTED: surface");
    EXPECT_NE(result.message.find("not of equal length"), std::string::npos) << result.message;
    EXPECT_NE(message_of_first(surface).find("not of equal length"), std::string::npos);
  }
}

TEST(BothCheckers, NameTheFirstWrongTriangleOrEdge) {
  // Vertices moved a little or far, and ε anything near the radii and lengths that there are.
  std::mt19937 random(20251109);
  const auto between = [&](double least, double most) {
    return least + (most - least) * static_cast<double>(random()) / 4294967296.0;
  };
  std::map<std::string, int> met;
  for (const char* name : {"octagon-9-vertices", "octagon-33-vertices", "square-of-cocircular-vertices"}) {
    const NetDocument good = load(std::string("certify/verified/") + name + ".json");
    for (int k = 0; k < 24; ++k) {
      NetDocument document = good;
      NetDocument::Vertex& vertex = document.vertices[random() % document.vertices.size()];
      const double size = std::pow(10, between(-3, -0.3));
      if (k % 3 != 0) vertex.x += between(-size, size);
      if (k % 3 != 0) vertex.y += between(-size, size);
      if (vertex.x * vertex.x + vertex.y * vertex.y >= 1) continue;
      if (k % 3 != 1) document.epsilon = std::to_string(between(0.3, 1.2));
      const certify::Certificate first = certify::check(document, {.threads = 1});
      if (first.verdict == certify::Verdict::undecided) continue;
      ++met[first.rule];
      expect_of_both(document,
                     std::string(certify::name(first.verdict)) + (first.rule.empty() ? "" : ": " + first.rule));
    }
  }
  for (const char* rule : {"", "orientation", "delaunay", "covering", "packing"}) EXPECT_GT(met[rule], 0) << rule;
}

TEST(BothCheckers, AskEveryTriangleWhereverItIs) {
  // What is wrong in one triangle alone, in each place: a radius above ε; an edge, and there another one each time that
  // no triangle before it has.
  const NetDocument good = load("certify/verified/octagon-9-vertices.json");
  const std::size_t n = good.triangles.size();
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t k = 0; k < n; ++k) order[k] = k;
  for (std::size_t turn = 0; turn < n; ++turn) {
    std::rotate(order.begin(), order.begin() + 1, order.end());
    NetDocument document = certify::with_triangles_in_order(good, order);
    expect_of_both(document, "VERIFIED");
    document.epsilon = "0.954362312811241";  // Just less than the largest radius.
    expect_of_both(document, "REFUTED: covering");
    document.epsilon = "1.041236299642141";  // Just more than the shortest edge.
    expect_of_both(document, "REFUTED: packing");
  }
}

TEST(BothCheckers, NameTheFirstEdgeThatALabelDoesNotFit) {
  const NetDocument good = load("certify/verified/octagon-9-vertices.json");
  for (std::size_t corner = 0; corner < 2 * good.triangles.size(); ++corner) {
    for (const std::uint32_t wrong : {0U, 14U}) {
      NetDocument document = good;
      document.triangles[corner / 2].label[corner % 2] = wrong;
      const certify::Certificate first = certify::check(document, {.threads = 1});
      expect_of_both(document,
                     std::string(certify::name(first.verdict)) + (first.rule.empty() ? "" : ": " + first.rule));
    }
  }
}

TEST(BothCheckers, NameTheFirstDartThatIsNotTheOppositeOfItsOpposite) {
  const NetDocument good = load("certify/verified/octagon-9-vertices.json");
  const auto message = [](const NetDocument& document) {
    expect_of_both(document, "REFUTED: map");
    return check(text_of(document)).message;
  };
  const auto named = [](std::uint32_t dart, std::uint32_t other) {
    return "dart " + std::to_string(dart) + " and dart " + std::to_string(other) + " are not opposite to each other";
  };
  for (std::uint32_t dart = 0; dart < 66; ++dart) {
    const std::uint32_t partner = certify::opposite(good, dart);
    for (const std::uint32_t wrong : {0U, 17U, 65U, dart}) {
      if (wrong == partner) continue;
      NetDocument document = good;
      document.triangles[dart / 3].opposite[dart % 3] = wrong;
      // The first dart whose opposite does not lead back, and what that is.
      const auto [first, leads_to] = partner < dart ? std::pair(partner, dart) : std::pair(dart, wrong);
      EXPECT_EQ(message(document), named(first, leads_to));
    }
    for (const std::uint32_t wrong : {0U, 4U, 8U}) {
      if (wrong == good.triangles[dart / 3].vertex[dart % 3]) continue;
      NetDocument document = good;
      document.triangles[dart / 3].vertex[dart % 3] = wrong;
      // The corner is where this dart starts, and where the opposite of the one before it does.
      const std::uint32_t first = std::min(dart, certify::opposite(good, certify::previous_dart(dart)));
      EXPECT_EQ(message(document), named(first, certify::opposite(good, first)));
    }
  }
  // Of a net of one vertex, so that a dart that is its own opposite is a loop.
  const NetDocument loops = load("certify/verified/octagon-1-vertex.json");
  for (std::uint32_t dart = 0; dart < 18; ++dart) {
    NetDocument document = loops;
    const std::uint32_t partner = certify::opposite(loops, dart);
    document.triangles[dart / 3].opposite[dart % 3] = dart;
    document.triangles[partner / 3].opposite[partner % 3] = partner;
    EXPECT_EQ(message(document), named(std::min(dart, partner), std::min(dart, partner)));
  }
  NetDocument none = good;
  none.triangles.clear();
  EXPECT_EQ(message(none), "there is no vertex or no triangle");
  none.vertices.clear();
  EXPECT_EQ(message(none), "there is no vertex or no triangle");
  // Of the 21 darts of seven triangles all but the first, or all but the last, are paired.
  for (const bool first : {true, false}) {
    NetDocument document = good;
    document.vertices.resize(1);
    document.triangles.assign(7, {{0, 0, 0}, {0, 0, 0}, {0, 0}});
    const std::uint32_t shift = first ? 1 : 0;
    for (std::uint32_t k = 0; k < 20; ++k) {
      const std::uint32_t dart = k + shift;
      document.triangles[dart / 3].opposite[dart % 3] = (k + 10) % 20 + shift;
    }
    document.triangles[first ? 0 : 6].opposite[first ? 0 : 2] = 9;
    EXPECT_EQ(message(document), first ? named(0, 9) : named(20, 9));
  }
}

TEST(SecondCheckersJson, EveryValueIsOfTheKindThatTheFormatSays) {
  NetDocument document = load("certify/verified/octagon-9-vertices.json");
  document.surface.about = "free text";
  document.labels.push_back({0, 0, {}});
  const std::string good = text_of(document);
  ASSERT_EQ(outcome(check(good)), "VERIFIED");
  const auto with = [&](const std::string& what, const std::string& instead) {
    std::string text = good;
    const std::size_t at = text.rfind(what);
    if (at == std::string::npos) throw std::logic_error("not in the text: " + what);
    return outcome(check(text.replace(at, what.size(), instead)));
  };
  for (const char* none : {"{}", "\"\"", "0", "null", "true"}) {
    EXPECT_EQ(with("[]", none), "MALFORMED") << "an empty word as " << none;
    if (none != std::string("\"\"")) {
      EXPECT_EQ(with("\"free text\"", none), "MALFORMED") << none;
    }
  }
  EXPECT_EQ(with("\"free text\"", "[]"), "MALFORMED");
  for (const char* version : {"0", "2", "\"1\"", "[1]", "1.0"}) {
    std::string text = good;
    const std::size_t at = text.find("\"version\"");
    text.replace(text.find('1', at), 1, version);
    EXPECT_EQ(outcome(check(text)), "MALFORMED") << version;
  }
  // A member that is not of the format, before and behind all others.
  for (const char* last : {"\"format\"", "\"kind\""}) {
    EXPECT_EQ(with(last, std::string("\"more\": 0, ") + last), "MALFORMED");
  }
  EXPECT_EQ(with("}", ", \"more\": 0}"), "MALFORMED");
}

}  // namespace
}  // namespace epsnet::exact::second_checker_test
