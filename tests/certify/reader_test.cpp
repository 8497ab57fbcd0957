#include <algorithm>
#include <array>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/file/document_reader.h"
#include "certify/file/file.h"

namespace epsnet::certify::reader_test {
namespace {

NetDocument sample() {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/octagon-9-vertices.json");
}

std::string to_text(const NetDocument& document) {
  std::ostringstream out;
  write_file(document, out);
  return out.str();
}

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(parse_file<NetDocument>(text, "test"));
  } catch (const MalformedError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Reader, ReadsWhatTheWriterWrites) {
  const NetDocument document = sample();
  const std::string text = to_text(document);
  EXPECT_EQ(parse_file<NetDocument>(text, "test"), document);
  EXPECT_EQ(to_text(parse_file<NetDocument>(text, "test")), text);
}

TEST(Reader, ReadsSurfacesThatTheWriterWrites) {
  std::ostringstream out;
  write_file(sample().surface, out);
  EXPECT_EQ(parse_file<SurfaceDocument>(out.str(), "test"), sample().surface);
  EXPECT_THROW(static_cast<void>(parse_file<NetDocument>(out.str(), "test")), MalformedError);
}

std::string surface_text(const std::string& object) {
  return R"({"format": "epsnet-surface", "version": 1, "surface": )" + object + "}";
}

std::string surface_file_complaint(const std::string& text) {
  try {
    static_cast<void>(parse_file<SurfaceDocument>(text, "test"));
  } catch (const MalformedError& error) {
    return error.what();
  }
  return "";
}

std::string surface_complaint(const std::string& object) { return surface_file_complaint(surface_text(object)); }

std::string to_text(const SurfaceDocument& surface) {
  std::ostringstream out;
  write_file(surface, out);
  return out.str();
}

TEST(Reader, RegularSurfacesComeBack) {
  for (const std::uint32_t genus : {2U, 3U, 1000U}) {
    SurfaceDocument surface;
    surface.regular_genus = genus;
    EXPECT_EQ(parse_file<SurfaceDocument>(to_text(surface), "test"), surface);
  }
  const SurfaceDocument last_member_says_it =
      parse_file<SurfaceDocument>(surface_text(R"({"genus": 7, "kind": "regular"})"), "test");
  EXPECT_EQ(last_member_says_it.regular_genus, 7U);
  NetDocument document;
  document.surface.regular_genus = 2;
  document.epsilon = "1";
  document.charts = {{0, {0, 0}}};
  document.labels = {{0, 0, {7, 0}}};
  EXPECT_EQ(parse_file<NetDocument>(to_text(document), "test"), document);
  document.charts[0].tile = 1;
  EXPECT_EQ(complaint(to_text(document)), "test: charts[0]: tile 1 does not exist, expected less than 1");
  document.charts[0].tile = 0;
  document.labels[0].word[1] = 8;
  EXPECT_EQ(complaint(to_text(document)), "test: labels[0]: side 8 does not exist, expected less than 8");
}

TEST(Reader, FreeTextComesBack) {
  std::string every_character = "\xcf\x80 \xe2\x89\xa5 3";
  for (char c = 0; c >= 0 && c < 127; ++c) every_character += c;
  SurfaceDocument regular;
  regular.regular_genus = 2;
  for (SurfaceDocument surface : {regular, sample().surface}) {
    surface.about = every_character;
    EXPECT_EQ(parse_file<SurfaceDocument>(to_text(surface), "test"), surface);
    surface.about.assign(std::size_t{1} << 20, 'a');
    EXPECT_EQ(parse_file<SurfaceDocument>(to_text(surface), "test"), surface);
    surface.about += 'a';
    EXPECT_THROW(static_cast<void>(parse_file<SurfaceDocument>(to_text(surface), "test")), MalformedError);
    surface.about.clear();
    EXPECT_EQ(to_text(surface).find("about"), std::string::npos);
  }
}

TEST(Reader, RegularSurfacesThatAreNoneAreMalformed) {
  for (const char* genus : {"0", "1", "-3", "1.5", "2.0", "2e0", "\"2\"", "null", "1001", "4294967298"}) {
    EXPECT_NE(surface_complaint(std::string(R"({"kind": "regular", "genus": )") + genus + "}"), "") << genus;
  }
  for (const char* object :
       {R"({"kind": "regular"})", R"({"genus": 2})", R"({"kind": "regular", "genus": 2, "tiles": []})",
        R"({"kind": "regular", "genus": 2, "gluing": []})", R"({"kind": "regular", "genus": 2, "genus": 2})",
        R"({"kind": "tiles", "genus": 2})", R"({"kind": "Regular", "genus": 2})",
        R"({"kind": "regular", "genus": 2, "about": 3})", R"({"kind": "regular", "genus": 2, "about": null})",
        R"({"kind": "regular", "genus": 2, "about": "\ud800"})"}) {
    EXPECT_NE(surface_complaint(object), "") << object;
  }
  EXPECT_EQ(surface_complaint(R"({"kind": "regular", "genus": 1001})"),
            "test: surface.genus: the genus 1001 is more than the limit of 1000");
  EXPECT_EQ(surface_complaint(R"({"kind": "regular", "genus": 1})"),
            "test: surface.genus: the genus is 1, expected at least 2");
  EXPECT_EQ(surface_complaint(R"({"kind": "regular"})"),
            "test: surface: missing member \"genus\" in a surface of the kind \"regular\"");
  EXPECT_EQ(surface_complaint(R"({"kind": "tiles", "tiles": [], "gluing": [], "genus": 2})"),
            "test: surface: unknown member \"genus\" in a surface of the kind \"tiles\"");
  EXPECT_EQ(surface_complaint(R"({"kind": "round"})"),
            "test: surface: \"kind\" is \"round\", expected \"tiles\", \"regular\", \"map\" or \"field\"");
}

TEST(Reader, VersionsAreOne) {
  for (const char* version : {"0", "2", "10", "4294967295"}) {
    const std::string text = replaced(surface_text(R"({"kind": "regular", "genus": 2})"), R"("version": 1)",
                                      std::string(R"("version": )") + version);
    EXPECT_EQ(surface_file_complaint(text), std::string("test: surface file: version ") + version +
                                                " is not a version this program reads, expected 1");
  }
}

TEST(Reader, SurfacesOfEveryKindAreThoseTheySay) {
  for (const char* p : {"0", "1", "2"}) {
    const std::string text = std::string(R"({"kind": "map", "p": )") + p + R"(, "q": 7, "gluing": [[0, 0, 0, 1]]})";
    EXPECT_TRUE(surface_complaint(text).starts_with("test: surface.p: ")) << surface_complaint(text);
  }
  const auto field = [](const std::string& polynomial) {
    return surface_complaint(R"({"kind": "field", "polynomial": )" + polynomial +
                             R"(, "root": ["1", "2"], "polygons": [], "gluing": [], "crossings": []})");
  };
  EXPECT_EQ(field("[]"), "test: surface.polynomial: 0 coefficients, expected 2 to 65");
  for (const char* integer : {"1/2", "2/1", "4/2", "+1", "1.0", "1e0", "", "-", " 1", "x", "--1"}) {
    EXPECT_EQ(field(std::string(R"(["-2", "0", ")") + integer + R"("])"),
              std::string("test: surface.polynomial: \"") + integer +
                  "\" is not an integer of at most 10^6 digits, such as \"-3\"");
  }
}

TEST(Reader, MembersComeInAnyOrderAndRationalsNeedNotBeReduced) {
  const std::string text = R"({"surface": {"gluing": [[0,0,0,1]], "kind": "tiles",
      "tiles": [[["0","0"],["-2/4","000"],["0","1/2"],["1/3","-0"]]]}, "version": 1, "format": "epsnet-surface"})";
  EXPECT_THROW(static_cast<void>(parse_file<SurfaceDocument>(text, "test")),
               MalformedError);  // Two sides are not glued.
  const SurfaceDocument surface =
      parse_file<SurfaceDocument>(replaced(text, "[[0,0,0,1]]", "[[0,0,0,1],[0,2,0,3]]"), "test");
  EXPECT_EQ(surface.tiles[0][1].x, mpq_class(-1, 2));
  EXPECT_EQ(surface.tiles[0][1].y, 0);
  EXPECT_EQ(surface.tiles[0][3].y, 0);
}

TEST(Reader, ComplaintsNameFilePlaceAndExpectation) {
  NetDocument document = sample();
  document.triangles[17].vertex[1] = 1000;
  const std::string text = complaint(to_text(document));
  EXPECT_EQ(text, "test: triangles[17]: vertex 1000 does not exist, expected less than 9");
  EXPECT_EQ(complaint(replaced(to_text(sample()), "\"epsilon\"", "\"epsilom\"")),
            "test: net: unknown member \"epsilom\"");
}

TEST(Reader, ComplaintsAreOneHarmlessLine) {
  const std::string text = complaint(replaced(to_text(sample()), "\"epsilon\"", "\"\\nVERIFIED\\u0007\""));
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_NE(text, "");
}

TEST(Reader, WordsMustCompose) {
  // Cut the octagon in two: side 0 leaves tile 0 for tile 1, so a word cannot go on with a side of tile 0.
  NetDocument document = sample();
  const SurfaceDocument::Tile v = document.surface.tiles[0];
  document.surface.tiles = {SurfaceDocument::Tile{v[0], v[1], v[2], v[3], v[4]},
                            SurfaceDocument::Tile{v[4], v[5], v[6], v[7], v[0]}};
  document.surface.gluing = {{0, 4, 1, 4}, {0, 0, 1, 0}, {0, 1, 1, 1}, {0, 2, 1, 2}, {0, 3, 1, 3}};
  document.labels = {{0, 0, {0, 5}}};
  document.triangles.clear();
  EXPECT_EQ(complaint(to_text(document)), "");
  document.labels = {{0, 0, {0, 1}}};
  EXPECT_EQ(complaint(to_text(document)), "test: labels[0]: letter 1 is side 1 of tile 0, expected a side of tile 1");
  document.labels = {{0, 0, {0}}};
  EXPECT_EQ(complaint(to_text(document)), "test: labels[0]: the word ends in tile 1, expected the tile 0 of chart 0");
}

TEST(Reader, WordsHaveALimit) {
  NetDocument document = sample();
  document.labels.push_back({0, 0, {}});
  for (int i = 0; i < 500'000; ++i) {
    document.labels.back().word.push_back(0);
    document.labels.back().word.push_back(4);
  }
  EXPECT_EQ(complaint(to_text(document)), "");
  document.labels.back().word.push_back(0);
  EXPECT_NE(complaint(to_text(document)).find("10^6 letters"), std::string::npos);
  document.labels.back().word.pop_back();
  document.labels.insert(document.labels.end(), 9, document.labels.back());
  EXPECT_NE(complaint(to_text(document)).find("10^7 letters"), std::string::npos);
}

TEST(Reader, RationalsHaveALimit) {
  const std::string digits(999'990, '7');
  const auto value = parse_rational("1/" + digits);
  ASSERT_TRUE(value.has_value());
  EXPECT_EQ(value->get_num(), 1);
  EXPECT_FALSE(parse_rational(std::string(1'000'001, '7')).has_value());
  EXPECT_TRUE(parse_rational("-" + std::string(1'000'000, '7')).has_value());
}

TEST(Reader, EveryPrefixOfANetIsMalformed) {
  const std::string text = to_text(sample());
  for (std::size_t length = 0; length + 2 < text.size(); ++length) {
    ASSERT_NE(complaint(text.substr(0, length)), "") << length;
  }
}

/// Whether a text is JSON as RFC 8259 has it, in UTF-8, without lone surrogates: a reader that shares nothing with the
/// one under test.
class JsonGrammar {
 public:
  [[nodiscard]] static bool accepts(std::string_view text) {
    JsonGrammar grammar{text};
    return grammar.value() && grammar.text_.empty();
  }

 private:
  explicit JsonGrammar(std::string_view text) : text_(text) { space(); }

  void space() { text_.remove_prefix(std::min(text_.find_first_not_of(" \t\n\r"), text_.size())); }

  bool take(std::string_view prefix) {
    if (!text_.starts_with(prefix)) return false;
    text_.remove_prefix(prefix.size());
    return true;
  }

  bool token(std::string_view token) {
    if (!take(token)) return false;
    space();
    return true;
  }

  bool value() {
    if (token("{")) return token("}") || rest("}", [&] { return string() && token(":") && value(); });
    if (token("[")) return token("]") || rest("]", [&] { return value(); });
    if (text_.starts_with('"')) return string();
    return token("true") || token("false") || token("null") || number();
  }

  template <class Element>
  bool rest(std::string_view end, const Element& element) {
    do {
      if (!element()) return false;
    } while (token(","));
    return token(end);
  }

  bool digits() {
    const std::size_t length = std::min(text_.find_first_not_of("0123456789"), text_.size());
    text_.remove_prefix(length);
    return length != 0;
  }

  bool number() {
    take("-");
    if (!take("0") && !digits()) return false;
    if (take(".") && !digits()) return false;
    if (take("e") || take("E")) {
      if (!take("+")) take("-");
      if (!digits()) return false;
    }
    space();
    return true;
  }

  int hexadecimal() {
    const std::string_view digits = text_.substr(0, 4);
    if (digits.size() < 4 || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string_view::npos) return -1;
    text_.remove_prefix(4);
    return std::stoi(std::string(digits), nullptr, 16);
  }

  bool escape() {
    if (take("u")) {
      const int code = hexadecimal();
      if (code < 0 || (code >= 0xdc00 && code < 0xe000)) return false;
      if (code < 0xd800 || code >= 0xe000) return true;
      if (!take("\\u")) return false;
      const int low = hexadecimal();
      return low >= 0xdc00 && low < 0xe000;
    }
    const bool known = !text_.empty() && std::string_view("\"\\/bfnrt").find(text_.front()) != std::string_view::npos;
    if (known) text_.remove_prefix(1);
    return known;
  }

  bool in_range(std::size_t i, int least, int most) {
    const int byte = i < text_.size() ? static_cast<unsigned char>(text_[i]) : -1;
    return least <= byte && byte <= most;
  }

  /// The table of RFC 3629, section 4.
  bool character() {
    std::size_t length = 0;
    if (in_range(0, 0x20, 0x7f)) length = 1;
    if (in_range(0, 0xc2, 0xdf)) length = 2;
    if (in_range(0, 0xe0, 0xef)) length = 3;
    if (in_range(0, 0xf0, 0xf4)) length = 4;
    if (length == 0) return false;
    if (in_range(0, 0xe0, 0xe0) && !in_range(1, 0xa0, 0xbf)) return false;
    if (in_range(0, 0xed, 0xed) && !in_range(1, 0x80, 0x9f)) return false;
    if (in_range(0, 0xf0, 0xf0) && !in_range(1, 0x90, 0xbf)) return false;
    if (in_range(0, 0xf4, 0xf4) && !in_range(1, 0x80, 0x8f)) return false;
    for (std::size_t i = 1; i < length; ++i) {
      if (!in_range(i, 0x80, 0xbf)) return false;
    }
    text_.remove_prefix(length);
    return true;
  }

  bool string() {
    if (!take("\"")) return false;
    while (!text_.starts_with('"')) {
      if (!(take("\\") ? escape() : character())) return false;
    }
    return token("\"");
  }

  std::string_view text_;
};

/// Every kind of value that a file can have, and white space of every kind between them.
const std::string kSmallNet = R"( {"format":"epsnet-net" ,"version": 1,
"surface":{"kind":"regular","genus":2,"about":"a\u00e9\n\ud83d\ude00)"
                              "\xcf\x80\xf0\x9f\x98\x80"
                              R"("},"epsilon":"1\/2","charts":[[0,"0","-1/3"]],
"labels":[[0,0,[0,1]],[0,0,[]]],"vertices":[[0 ,-0.25e-1,0.5	]],"triangles":[[0,0,0,0,1,2,0,1]]
,"collars":[{"core":[3],"length":[0,1.5E+0],"vertices":[0,0],"triangles":[0,0]}]} )";
const std::string kSmallGeodesics = R"({"claim":"thick-thin","net":{"format":"epsnet-net","version":1,
"surface":{"kind":"tiles","tiles":[[["0","0"],["1/2","0"],["0","1/2"],["1/3","0"]]],"gluing":[[0,0,0,1],[0,3,0,2]]},
"epsilon":"0.1","charts":[[0,"0","0"]],"labels":[],"vertices":[[0,0.0,0]],"triangles":[]},
"geodesics":[{"vertex":0,"word":[0],"length":[0.5,0.75],"simple":true}],
"clusters":[{"first":0,"count":1,"equal":false}],"pieces":[{"genus":1,"boundaries":[[0,0],[0,1]]}],
"version":1,"format":"epsnet-geodesics"})";

std::string claim_complaint(const std::string& text) {
  try {
    static_cast<void>(parse_file<ClaimDocument>(text, "test"));
  } catch (const MalformedError& error) {
    return error.what();
  }
  return "";
}

TEST(Reader, WhatItAcceptsIsJson) {
  using namespace std::string_literals;
  const std::string bytes =
      "\0\x01\b\t\n\v\f\r\x1a\x1f "
      "!\"#%&'()*+,-./0123456789:;<=?@AEINTU[\\]_`abefnrtu{|}~\x7f\x80\xa0\xbf\xc0\xc3\xe2\xed\xef"
      "\xf0\xf4\xff"s;
  for (const std::string& text : {kSmallNet, kSmallGeodesics}) {
    ASSERT_EQ(claim_complaint(text), "");
    ASSERT_TRUE(JsonGrammar::accepts(text));
    int accepted = 0;
    const auto try_out = [&](const std::string& changed) {
      if (claim_complaint(changed) != "") return;
      ++accepted;
      EXPECT_TRUE(JsonGrammar::accepts(changed)) << changed;
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
      try_out(std::string(text).erase(i, 1));
      for (const char byte : bytes) {
        try_out(std::string(text).insert(i, 1, byte));
        try_out(std::string(text).replace(i, 1, 1, byte));
      }
    }
    EXPECT_GT(accepted, 1000);
  }
}

TEST(SlowReader, LettersInAllHaveALimit) {
  std::string word = "0";
  for (int i = 1; i < 1'000'000; ++i) word += ",0";
  const auto net = [](const std::string& labels) {
    return R"({"format":"epsnet-net","version":1,"surface":{"kind":"regular","genus":2},"epsilon":"1",
        "charts":[[0,"0","0"]],"labels":[)" +
           labels + R"(],"vertices":[[0,0,0]],"triangles":[]})";
  };
  std::string labels = "[0,0,[" + word + "]]";
  EXPECT_EQ(claim_complaint(net("[0,0,[" + word + ",0]]")),
            "test: labels[0]: the word has more than the limit of 10^6 letters");
  for (int i = 1; i < 10; ++i) labels += ",[0,0,[" + word + "]]";
  for (const std::string rest :
       {"", R"({"format":"epsnet-geodesics","version":1,"claim":"spectrum","up_to":"1","geodesics":[],"clusters":[])",
        R"({"format":"epsnet-distance","version":1,"point":[0,"0","0"],"distance":[0,1],"paths":[[]],"equal":true)",
        R"({"format":"epsnet-cover","version":1,"claim":"radius","value":[1,1],"triangulations":[],"cells":[])"}) {
    const auto file = [&](const std::string& text) { return rest.empty() ? text : rest + ",\"net\":" + text + "}"; };
    EXPECT_EQ(claim_complaint(file(net(labels))), "") << rest;
    EXPECT_EQ(claim_complaint(file(net(labels + ",[0,0,[0]]"))),
              "test: labels[10]: more than the limit of 10^7 letters in all")
        << rest;
  }
}

TEST(Reader, NamesMayHaveEscapes) {
  for (const auto& [from, to] : {std::pair{"\"vertices\":[[", "\"\\u0076ertices\":[["},
                                 std::pair{"\"triangles\":[[", "\"\\u0074riangles\":[["}}) {
    EXPECT_EQ(claim_complaint(replaced(kSmallNet, from, to)), "");
  }
}

TEST(Reader, BrokenRowsAndMembersAreNamed) {
  const auto said = [](const std::string& from, const std::string& to) {
    return claim_complaint(replaced(kSmallNet, from, to));
  };
  EXPECT_EQ(said(R"([[0,"0","-1/3"]])", R"([[0,"0","-1/3"]:])"), "test: charts: \":\" found, expected \",\" or \"]\"");
  EXPECT_EQ(said(R"([[0,"0","-1/3"]])", R"([[0,"0","-1/3" "0"]])"),
            "test: charts[0]: the string \"0\" found, expected \",\" or \"]\"");
  EXPECT_EQ(said(R"("epsilon":)", R"("epsilon")"),
            "test: net: the string \"1/2\" found, expected \":\" behind the name of a member");
  EXPECT_EQ(said(R"("epsilon":)", R"("epsilo\x":)"), "test: net: a string has an escape that JSON does not have");
  EXPECT_EQ(said(R"([[0,"0","-1/3"]])", "[[]]"),
            "test: charts[0]: has 0 elements, expected [t, x, y], a tile and two rationals");
  EXPECT_EQ(said(R"([[0,"0","-1/3"]])", "[[0]]"),
            "test: charts[0]: has 1 elements, expected [t, x, y], a tile and two rationals");
  EXPECT_EQ(said(R"([[0,"0","-1/3"]])", R"([[0,"0","0","0"]])"),
            "test: charts[0]: too many elements, expected [t, x, y], a tile and two rationals");
  EXPECT_EQ(said(R"("genus":2)", R"("genus":0)"), "test: surface.genus: the genus is 0, expected at least 2");
  EXPECT_EQ(surface_complaint(R"({"kind": "tiles", "tiles": [[["0", "0"], ["0", "0"]]], "gluing": [[0, 0, 0, 1]]})"),
            "test: surface.tiles[0]: has 2 vertices, expected at least 3");
}

/// What `read` gives of a file with these bytes, of which a part is in memory at a time.
NetDocument from_file(const std::string& bytes) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  EXPECT_EQ(std::fwrite(bytes.data(), 1, bytes.size(), file.get()), bytes.size());
  std::rewind(file.get());
  ByteStream pieces(file.get(), bytes.size(), {});
  NetDocument document;
  read_document(pieces, &document);
  return document;
}

TEST(Reader, StructureMayBeLeftToTheCheck) {
  const std::string text = replaced(kSmallNet, "[[0 ,-0.25e-1,0.5\t]]", "[[7 ,-0.25e-1,0.5\t]]");
  ByteStream pieces(text);
  NetDocument document;
  read_document(pieces, &document, Structure::unchecked);
  EXPECT_EQ(document.vertices.at(0).chart, 7U);
  const Certificate certificate = check(document);
  EXPECT_EQ(certificate.verdict, Verdict::malformed);
  EXPECT_EQ("test: " + certificate.message, complaint(text));
}

TEST(Reader, ValuesCrossTheEndsOfPieces) {
  constexpr std::size_t kPiece = std::size_t{1} << 18U;
  const NetDocument net = parse_file<NetDocument>(kSmallNet, "test");
  for (std::size_t before = 0; before <= kSmallNet.size() + 1; ++before) {
    ASSERT_EQ(from_file(std::string(kPiece - before, ' ') + kSmallNet), net) << before;
  }
  EXPECT_EQ(from_file(replaced(kSmallNet, "0.5\t", "0.5" + std::string(2 * kPiece, '0') + "\t")), net);
}

/// A number is all of its characters: the last one may say the most, as a digit, or as one of the exponent.
TEST(Reader, NumbersAreReadToTheirLastCharacter) {
  const auto vertex = [](const std::string& row) {
    const std::string text = replaced(kSmallNet, "[[0 ,-0.25e-1,0.5\t]]", "[[0,0,0]," + row + "\n, [ 0,0.5,\r-0.25 ]]");
    const auto vertices = parse_file<NetDocument>(text, "test").vertices;
    EXPECT_EQ(vertices.size(), 3U);
    EXPECT_EQ(vertices[2], (NetDocument::Vertex{0.5, -0.25, 0}));
    return vertices[1];
  };
  using Vertex = NetDocument::Vertex;
  EXPECT_EQ(vertex("[0,0.09,-9e-09]"), (Vertex{0.09, -9e-9, 0}));
  EXPECT_EQ(vertex(" \t\r\n[ \t\r\n0 ,\r0.125\t, \n-1e-400 \n\r] \n"), (Vertex{0.125, -0.0, 0}));
  const std::string half = "0.500000000000000055511151231257827021181583404541015625";
  for (std::size_t zeros = 1; zeros < 300; ++zeros) {
    const std::string padded = "0.25" + std::string(zeros, '0');
    EXPECT_EQ(vertex("[0," + padded + "e-2,0.5]"), (Vertex{0.0025, 0.5, 0}));
    EXPECT_EQ(vertex("[0,0.5," + padded + "e-2]"), (Vertex{0.5, 0.0025, 0}));
    EXPECT_EQ(vertex("[0,0." + std::string(zeros, '0') + "125e" + std::to_string(zeros) + ",0]"),
              (Vertex{0.125, 0, 0}));
    // Half of the way from 1/2 to the next number, which is rounded to 1/2, and a little more.
    EXPECT_EQ(vertex("[0," + half + ",-" + half + std::string(zeros, '0') + "1]"), (Vertex{0.5, -(0.5 + 0x1p-53), 0}));
  }
}

TEST(Reader, RowsAreNumbersAndNothingElse) {
  const auto expect_refused = [](const std::string& rows, const std::string& by, const std::string& row) {
    const std::string text = claim_complaint(replaced(kSmallNet, rows, by));
    EXPECT_TRUE(text.starts_with("test: ")) << row << ": " << text;
    EXPECT_TRUE(text.find("vertices") != std::string::npos || text.find("triangles") != std::string::npos) << text;
  };
  for (const std::string row : {"[]",
                                "[0]",
                                "[0,0]",
                                "[0,0,0,0]",
                                "[0,0,0",
                                "0,0,0]",
                                "[0,0,0],",
                                "[0 0,0]",
                                "[0,0 0]",
                                "[0,,0]",
                                "[,0,0]",
                                "[0,0,]",
                                "[0,0,0,]",
                                "[00,0,0]",
                                "[01,0,0]",
                                "[-0,0,0]",
                                "[-1,0,0]",
                                "[+0,0,0]",
                                "[0.0,0,0]",
                                "[0e0,0,0]",
                                "[0,02,0]",
                                "[0,+0,0]",
                                "[0,0.,0]",
                                "[0,.2,0]",
                                "[0,0,1e400]",
                                "[0,0,nan]",
                                "[0,0,0x1]",
                                "[0,0,0a]",
                                "[0,\"0\",0]",
                                "[0,[0],0]",
                                "[0,0,0}",
                                "{0,0,0]",
                                "[0,\v0,0]",
                                "[0,0,\xa0"
                                "0]",
                                "x[0,0,0]",
                                "[0,0,0]x",
                                "null",
                                "[4294967296,0,0]",
                                "[18446744073709551616,0,0]"}) {
    expect_refused("[[0 ,-0.25e-1,0.5\t]]", "[[0,0,0]," + row + ",[0,0,0]]", row);
  }
  for (const std::string row :
       {"[0,0,0,0,1,2,0]", "[0,0,0,0,1,2,0,1,0]", "[0,0,0,0,1,2,0,1.0]", "[0,0,0,0,1,2,0,01]", "[0,0,0,0,1,2,0 1]",
        "[0,0,0,0,1 2,0,1]", "[0 0,0,0,1,2,0,1]", "[0,0,0,0,1,-2,0,1]", "[0,0,0,0,4294967296,2,0,1]",
        "[0,0,0,0,1,2,0,\"1\"]", "[,0,0,0,1,2,0,1]", "[0,0,0,,1,2,0,1]", "[0,0,0,0,1,2,0,]"}) {
    expect_refused("[[0,0,0,0,1,2,0,1]]", "[[0,0,0,0,1,2,0,1]," + row + "]", row);
  }
}

TEST(Reader, RowsInOtherPlacesAreNotTakenForThoseOfTheNet) {
  const auto expect_refused = [](const std::string& from, const std::string& to) {
    const std::string text = replaced(kSmallNet, from, to);
    EXPECT_NE(claim_complaint(text), "") << text;
  };
  expect_refused(R"("genus":2,)", R"("genus":2,"vertices":[[0,0,0]],)");
  expect_refused(R"("genus":2,)", R"("genus":2,"triangles":[[0,0,0,0,0,0,0,0]],)");
  expect_refused(R"("core":[3],)", R"("core":[3],"vertices":[[0,0,0]],)");
  expect_refused(R"("vertices":[0,0])", R"("vertices":[[0,0,0]])");
  expect_refused(R"("triangles":[0,0])", R"("triangles":[[0,0,0,0,0,0,0,0]])");
  expect_refused(R"("labels")", R"("vertices":[[0,0,0]],"labels")");
  expect_refused(R"("labels")", R"("vertices":[],"labels")");
  expect_refused(R"("labels")", R"("triangles":[[0,0,0,0,1,2,0,1]],"labels")");
  expect_refused(R"("epsilon":"1\/2")", R"("epsilon":"vertices":[[0,0,0]])");
  // A string that holds what would be rows.
  const std::string about = replaced(kSmallNet, R"("about":")", R"("about":"\"vertices\":[[0,1,1]],\\)");
  EXPECT_EQ(claim_complaint(about), "");
  EXPECT_EQ(std::get<NetDocument>(parse_file<ClaimDocument>(about, "test")).vertices,
            std::get<NetDocument>(parse_file<ClaimDocument>(kSmallNet, "test")).vertices);
}

/// A file of more bytes than are read at once, which exists as long as this.
class LargeFile {
 public:
  explicit LargeFile(std::string_view bytes) {
    EXPECT_GT(bytes.size(), kMaxBytesAtOnce);
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~LargeFile() { std::remove(path_.c_str()); }
  LargeFile(const LargeFile&) = delete;
  LargeFile& operator=(const LargeFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

  /// What is wrong with the file, without its name. The witness sees all of it nevertheless.
  [[nodiscard]] std::string complaint() const {
    std::uint64_t seen = 0;
    try {
      static_cast<void>(read_file<ClaimDocument>(path_, [&](std::string_view piece) { seen += piece.size(); }));
    } catch (const MalformedError& error) {
      EXPECT_EQ(seen, std::filesystem::file_size(path_));
      return std::string(error.what()).substr(display_name(path_).size());
    }
    return "";
  }

 private:
  std::string path_ = testing::TempDir() + "epsnet-reader-" + std::to_string(getpid());
};

/// A file with these bytes, which exists as long as this.
class File {
 public:
  explicit File(std::string_view bytes) { std::ofstream(path_, std::ios::binary) << bytes; }
  ~File() { std::remove(path_.c_str()); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_ = testing::TempDir() + "epsnet-reader-file-" + std::to_string(getpid());
};

TEST(Reader, LoadGivesTheBytesOfAFile) {
  std::string bytes;
  for (int i = 0; bytes.size() < 3'200'000; ++i) bytes += std::to_string(i) + ' ';
  constexpr std::size_t kChunk = 1U << 20U;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kChunk - 1, kChunk, kChunk + 1, 2 * kChunk,
                                 2 * kChunk + 1, 3 * kChunk + 12345}) {
    const File file(bytes.substr(0, size));
    EXPECT_EQ(load(file.path()), bytes.substr(0, size)) << size;
  }
}

TEST(Reader, LoadGivesTheBytesOfStandardInput) {
  const File file("what is there");
  const int kept = dup(STDIN_FILENO);
  ASSERT_NE(kept, -1);
  const int opened = open(file.path().c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_NE(opened, -1);
  dup2(opened, STDIN_FILENO);
  const std::string bytes = load("-");
  dup2(kept, STDIN_FILENO);
  std::clearerr(stdin);
  close(kept);
  close(opened);
  EXPECT_EQ(bytes, "what is there");
}

TEST(Reader, FilesFromASizeOnAreReadInPieces) {
  const auto document = parse_file<ClaimDocument>(kSmallNet, "test");
  for (const std::size_t size : {kMaxBytesAtOnce - 1, kMaxBytesAtOnce, kMaxBytesAtOnce + 1, kMaxBytesAtOnce + 2}) {
    const File file(kSmallNet + std::string(size - kSmallNet.size(), ' '));
    std::size_t pieces = 0;
    EXPECT_EQ(read_file<ClaimDocument>(file.path(), [&](std::string_view) { ++pieces; }), document);
    EXPECT_EQ(pieces > 1, size > kMaxBytesAtOnce) << size;
    EXPECT_EQ(read_file<NetDocument>(file.path()), std::get<NetDocument>(document));
  }
}

/// A net with so many vertices that its file is large.
NetDocument large_net() {
  NetDocument net = sample();
  const std::size_t vertices = net.vertices.size();
  for (std::size_t i = 0; i < 240'000; ++i) {
    net.vertices.push_back(net.vertices[1 + i % (vertices - 1)]);
    net.vertices.back().x /= 3 + static_cast<double>(i);
  }
  return net;
}

TEST(Reader, LargeFilesAreReadInPieces) {
  const NetDocument net = large_net();
  std::ostringstream compact;
  write_compact_net(net, compact);
  // The white space moves all that follows, and with it where pieces end.
  for (const std::string& bytes :
       {to_text(net), std::string(1, ' ') + to_text(net), std::string(17, '\n') + to_text(net), compact.str()}) {
    const LargeFile file(bytes);
    std::string seen;
    const auto document = read_file<ClaimDocument>(file.path(), [&](std::string_view piece) { seen += piece; });
    EXPECT_EQ(std::get<NetDocument>(document), net);
    EXPECT_EQ(seen, bytes);
    EXPECT_EQ(read_file<NetDocument>(file.path()), net);
  }
}

TEST(SlowReader, WhatIsWrongWithLargeFilesIsSaidAsOfSmallOnes) {
  const auto to_compact = [](const NetDocument& document) {
    std::ostringstream out;
    write_compact_net(document, out);
    return out.str();
  };
  const NetDocument net = large_net();
  const std::string text = to_text(net);
  const std::string compact = to_compact(net);
  const std::size_t row = text.find("\n[", text.size() / 2);
  NetDocument outside = net;
  outside.vertices[100'000].x = 1;
  NetDocument nowhere = net;
  nowhere.triangles[0].vertex[0] = 1'000'000;
  for (const std::string& bytes :
       {text.substr(0, text.size() - 4), text + "x", text.substr(0, row) + text.substr(row + 2),
        text.substr(0, row) + "\n[0,1e400,0]," + text.substr(row),
        text.substr(0, row) + "\n[0,0,0,0]," + text.substr(row), text.substr(0, row) + "\xff" + text.substr(row),
        replaced(text, "\"charts\"", "\"cherts\""), to_text(outside), to_text(nowhere), to_compact(outside),
        to_compact(nowhere), compact.substr(0, compact.size() - 1), compact + '\0',
        std::string(compact).replace(compact.size() / 2, 1, "?"), std::string(compact).replace(8, 1, "?")}) {
    const LargeFile file(bytes);
    EXPECT_NE(file.complaint(), "");
    EXPECT_EQ("test" + file.complaint(), claim_complaint(bytes));
  }
}

/// What is left of a file in memory behind its end is never read as part of it.
TEST(Reader, NothingBehindTheEndIsRead) {
  const std::string text = kSmallGeodesics;
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_THROW(static_cast<void>(parse_file<ClaimDocument>(std::string_view(text).substr(0, length), "test")),
                 MalformedError)
        << length;
  }
}

TEST(Reader, IndicesAreDigitsOfANumberThatFitsIn32Bits) {
  const auto complaint_about = [](const std::string& index) {
    return surface_complaint(R"({"kind": "regular", "genus": )" + index + "}");
  };
  for (const char* index : {"2", " 2 ", "\t2\r\n", "1000"}) EXPECT_EQ(complaint_about(index), "") << index;
  for (const char* index : {"",
                            "+2",
                            "-2",
                            "-0",
                            "02",
                            "00",
                            "2.0",
                            "2.",
                            "2e0",
                            "2E0",
                            "20e-1",
                            "0x2",
                            "2 2",
                            "2,",
                            ",2",
                            "2x",
                            "x2",
                            "2]",
                            "[2]",
                            "{}",
                            "\"2\"",
                            "null",
                            "true",
                            "2\v",
                            "\f2",
                            "2\f",
                            "2\x1a",
                            "\xc2\xa0"
                            "2",
                            "2_0",
                            "\xd9\xa2"}) {
    EXPECT_NE(complaint_about(index), "") << index;
  }
  EXPECT_EQ(complaint_about("4294967295"), "test: surface.genus: the genus 4294967295 is more than the limit of 1000");
  // 2 modulo 2^32, 2^63, 2^64, 2^128 among them.
  for (const char* index : {"4294967296", "4294967298", "9223372036854775808", "9223372036854775810",
                            "18446744073709551615", "18446744073709551616", "18446744073709551618",
                            "99999999999999999999", "340282366920938463463374607431768211458"}) {
    EXPECT_EQ(complaint_about(index), "test: surface.genus: the index \"" + std::string(index) + "\" is too large");
  }
  EXPECT_EQ(
      complaint_about("2.0"),
      "test: surface.genus: \"2.0\" found, expected an index: an integer >= 0 without sign, fraction or exponent");
}

TEST(Reader, NumbersAreReadExactlyWhereverTheyStand) {
  const auto net = [](const std::string& number) { return replaced(kSmallNet, "-0.25e-1", number); };
  for (const char* number : {"0.50000000000000000000", " 5e-1\n", "0.5", "\t0.500"}) {
    EXPECT_EQ(parse_file<NetDocument>(net(number), "test").vertices[0].x, 0.5) << number;
  }
  for (const char* number : {"+0.5", ".5", "0.", "00.5", "0.5f", "0.5 0.5", "0x1p-1", "NaN", "-Infinity", "1e999",
                             "\"0.5\"", "null", "[0.5]", "0.5\v", "\f0.5", "0.5\x1a", "0,5", ""}) {
    EXPECT_NE(complaint(net(number)), "") << number;
  }
  EXPECT_EQ(complaint(net("1e999")), "test: vertices[0]: \"1e999\" found, expected a finite binary64 number");
  const auto document = parse_file<ClaimDocument>(replaced(kSmallGeodesics, "0.5", "0.36893488147419103232"), "test");
  EXPECT_EQ(std::get<GeodesicsDocument>(document).geodesics[0].length.lower, 0.36893488147419103232);
}

std::string utf8(std::uint32_t code) {
  const auto byte = [](std::uint32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xc0 | code >> 6U), byte(0x80 | (code & 0x3fU))};
  if (code < 0x10000) return {byte(0xe0 | code >> 12U), byte(0x80 | (code >> 6U & 0x3fU)), byte(0x80 | (code & 0x3fU))};
  return {byte(0xf0 | code >> 18U), byte(0x80 | (code >> 12U & 0x3fU)), byte(0x80 | (code >> 6U & 0x3fU)),
          byte(0x80 | (code & 0x3fU))};
}

/// `written` as the text of `about`: what it is read as, nothing if it is malformed.
std::optional<std::string> string_read(const std::string& written) {
  try {
    return parse_file<SurfaceDocument>(surface_text(R"({"kind": "regular", "genus": 2, "about": ")" + written + "\"}"),
                                       "test")
        .about;
  } catch (const MalformedError&) {
    return std::nullopt;
  }
}

std::string unicode_escape(std::uint32_t code, const char* format = "\\u%04x") {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), format, code);
  return text.data();
}

TEST(Reader, EveryEscapeIsReadOrRefused) {
  for (std::uint32_t code = 0; code < 0x10000; ++code) {
    const bool surrogate = code >= 0xd800 && code < 0xe000;
    const auto wanted = surrogate ? std::nullopt : std::optional(utf8(code));
    ASSERT_EQ(string_read(unicode_escape(code)), wanted) << code;
    ASSERT_EQ(string_read(unicode_escape(code, "\\u%04X")), wanted) << code;
  }
  for (const std::uint32_t high : {0xd800U, 0xd83dU, 0xdbffU}) {
    for (std::uint32_t low = 0; low < 0x10000; low += low < 0xdbf0 || low > 0xe010 ? 13 : 1) {
      const bool pair = low >= 0xdc00 && low < 0xe000;
      const auto wanted =
          pair ? std::optional(utf8(0x10000 + ((high - 0xd800) << 10U) + (low - 0xdc00))) : std::nullopt;
      ASSERT_EQ(string_read(unicode_escape(high) + unicode_escape(low)), wanted) << high << ' ' << low;
    }
  }
  EXPECT_EQ(string_read(R"(\"\\\/\b\f\n\r\t)"), "\"\\/\b\f\n\r\t");
  for (const char* escape : {R"(\)",
                             R"(\x41)",
                             R"(\')",
                             R"(\0)",
                             R"(\a)",
                             R"(\v)",
                             R"(\U0041)",
                             R"(\u)",
                             R"(\u12)",
                             R"(\u123)",
                             R"(\u123g)",
                             R"(\u 123)",
                             R"(\u+123)",
                             R"(\u-123)",
                             R"(\ud800\)",
                             R"(\ud800x)",
                             R"(\ud800\n)",
                             R"(\ud800\u)",
                             R"(\ud800\udc0)",
                             R"(\ud800 \udc00)",
                             R"(\udc00\ud800)",
                             R"(\udc00\udc00)",
                             R"(\ud800]udc00)",
                             R"(\ud800\vdc00)",
                             "\\\n",
                             "\\\xcf\x80"}) {
    EXPECT_EQ(string_read(escape), std::nullopt) << escape;
  }
  for (std::size_t before = 0; before < 70; ++before) {
    for (std::size_t pairs = 0; pairs < 70; ++pairs) {
      const std::string text = std::string(before, 'a') + std::string(2 * pairs, '\\');
      ASSERT_EQ(string_read(text), text.substr(0, before + pairs));
      ASSERT_EQ(string_read(text + '\\'), std::nullopt);
      ASSERT_EQ(string_read(text + "\\\""), text.substr(0, before + pairs) + '"');
    }
  }
  // Every string and every key may be written so.
  const std::string escaped =
      replaced(replaced(kSmallNet, "-1/3", R"(\u002d\u0031\/3)"), "\"charts\"", R"("\u0063harts")");
  EXPECT_EQ(parse_file<NetDocument>(escaped, "test"), parse_file<NetDocument>(kSmallNet, "test"));
}

TEST(Reader, BytesThatAreNoUtf8AreRefusedWhereverTheyStand) {
  for (std::size_t before = 0; before < 70; ++before) {
    const std::string text(before, 'a');
    for (const char* bytes :
         {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xc3", "\xe0\x80\x80", "\xe0\x9f\xbf", "\xe2\x82", "\xed\xa0\x80",
          "\xed\xbf\xbf", "\xf0\x80\x80\x80", "\xf0\x8f\xbf\xbf", "\xf0\x9f\x98", "\xf4\x90\x80\x80",
          "\xf5\x80\x80\x80", "\xf8\x88\x80\x80\x80", "\xfe", "\xff"}) {
      EXPECT_EQ(string_read(text + bytes), std::nullopt) << before;
    }
    for (const char* bytes : {"\x7f", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80",
                              "\xef\xbf\xbf", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) {
      EXPECT_EQ(string_read(text + bytes), text + bytes) << before;
    }
    for (char control = 0; control < ' '; ++control) {
      EXPECT_EQ(string_read(text + control), std::nullopt) << before << ' ' << static_cast<int>(control);
    }
  }
}

TEST(Reader, KeysAreComparedAfterUnescaping) {
  const std::string escaped = replaced(kSmallGeodesics, "\"epsnet-geodesics\"", "\"epsnet-\\u0067eodesics\"");
  const std::string in_both = replaced(escaped, "\"version\":1,\"format\"", "\"version\":1,\"\\u0066ormat\"");
  for (const std::string& text : {escaped, in_both}) {
    EXPECT_EQ(std::get<GeodesicsDocument>(parse_file<ClaimDocument>(text, "test")),
              std::get<GeodesicsDocument>(parse_file<ClaimDocument>(kSmallGeodesics, "test")));
  }
  EXPECT_EQ(claim_complaint(replaced(kSmallNet, "\"format\"", "\"\\u0066ormat\"")), "");
  const std::string twice = replaced(kSmallNet, "\"format\"", "\"\\u0066ormat\":\"epsnet-net\",\"format\"");
  EXPECT_EQ(claim_complaint(twice), "test: net: repeated member \"format\"");
  EXPECT_EQ(surface_complaint(R"({"kind": "regular", "genus": 2, "g\u0065nus": 3})"),
            "test: surface: repeated member \"genus\"");
  EXPECT_EQ(surface_complaint(R"({"kind": "regular", "genus\u0000": 2, "genus": 2})"),
            "test: surface: unknown member \"genus?\"");
}

TEST(Reader, DepthIsNoDanger) {
  for (const std::size_t depth : {2U, 1000U, 1025U, 1'000'000U}) {
    for (const std::string& deep : {std::string(depth, '['), std::string(depth, '['), std::string(depth, '{')}) {
      EXPECT_NE(claim_complaint(deep), "");
      for (const char* at : {"\"epsnet-net\"", "2", "\"1\\/2\"", "[[0,\"0\",\"-1/3\"]]", "-0.25e-1", "[3]"}) {
        EXPECT_NE(claim_complaint(replaced(kSmallNet, at, deep)), "") << at;
        EXPECT_NE(claim_complaint(replaced(kSmallNet, at, deep + std::string(depth, ']'))), "") << at;
      }
    }
    std::string objects;
    for (std::size_t i = 0; i < depth; ++i) objects += "{\"surface\":";
    EXPECT_NE(claim_complaint(objects), "");
    EXPECT_NE(claim_complaint(objects + "1" + std::string(depth, '}')), "");
  }
}

TEST(Reader, NothingButWhiteSpaceMayFollow) {
  using namespace std::string_literals;
  const std::string text = kSmallNet.substr(0, kSmallNet.size() - 1);
  EXPECT_EQ(claim_complaint(text + " \t\n\r"), "");
  EXPECT_EQ(claim_complaint(" \t\n\r" + text), "");
  for (const std::string& more : {"x"s,    "{}"s,   "{"s, "}"s,    "]"s,  ","s,  "\0"s, "\f"s,           "\v"s,
                                  "\x1a"s, "null"s, "1"s, "\"\""s, "\""s, "//"s, "#"s,  "\xef\xbb\xbf"s, "\xc2\xa0"s,
                                  "\\"s,   ":"s,    text}) {
    EXPECT_NE(claim_complaint(text + more), "") << more;
    EXPECT_NE(claim_complaint(text + "\n" + more), "") << more;
    EXPECT_NE(claim_complaint(more + text), "") << more;
  }
  for (const char* nothing : {"", " ", "\n\n", "\xef\xbb\xbf"}) EXPECT_NE(claim_complaint(nothing), "");
}

TEST(Reader, AByteOrderMarkIsRefused) {
  EXPECT_EQ(claim_complaint("\xef\xbb\xbf" + kSmallNet),
            "test: document: begins with a byte order mark, expected an object");
  EXPECT_EQ(claim_complaint("\xef\xbb\xbf" + kSmallGeodesics),
            "test: document: begins with a byte order mark, expected an object");
}

TEST(Reader, FilesThatCannotBeReadAreNoFiles) {
  const auto why = [](const std::string& path) -> std::string {
    try {
      static_cast<void>(load(path));
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(why("no/such/file.json"), "\"no/such/file.json\": no such file");
  EXPECT_EQ(why(EPSNET_TEST_DATA), "\"" EPSNET_TEST_DATA "\": is a directory, expected a file");
  EXPECT_EQ(why("/dev/zero"), "\"/dev/zero\": is a device, expected a file");
}

TEST(Reader, ErrorsHaveParts) {
  const auto expect = [](const auto& parse, const ErrorParts& parts) {
    try {
      static_cast<void>(parse());
      FAIL();
    } catch (const LocatedError& error) {
      EXPECT_EQ(error.file(), "test");
      EXPECT_EQ(error.place(), parts.place);
      EXPECT_EQ(error.problem(), parts.problem);
      EXPECT_EQ(error.expected(), parts.expected);
      EXPECT_EQ(error.what(), "test: " + parts.place + ": " + parts.reason());
    }
  };
  expect([] { return parse_file<NetDocument>("{}", "test"); },
         {.place = "net", .problem = "missing member \"format\""});
  expect([] { return parse_file<NetDocument>(R"({"format" 1})", "test"); },
         {.place = "net", .problem = "\"1\" found", .expected = "\":\" behind the name of a member"});
  expect([] { return parse_file<SurfaceDocument>(surface_text(R"({"kind": "tiles", "gluing": [[0, "x"]]})"), "test"); },
         {.place = "surface.gluing[0]",
          .problem = "the string \"x\" found",
          .expected = "an index: an integer >= 0 without sign, fraction or exponent"});
  // Of the structure, which is examined when all is read.
  expect([] { return parse_file<ClaimDocument>(replaced(kSmallGeodesics, "[0,3,0,2]", "[0,3,9,2]"), "test"); },
         {.place = "surface.gluing[1]", .problem = "tile 9 does not exist", .expected = "less than 1"});
}

TEST(Reader, ComplaintsNameThePathAsGiven) {
  const std::string path = std::string(EPSNET_TEST_DATA) + "/certify/malformed/empty.json";
  try {
    static_cast<void>(read_file<NetDocument>(path));
    FAIL();
  } catch (const MalformedError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("\"" + path + "\": ")) << error.what();
  }
}

}  // namespace
}  // namespace epsnet::certify::reader_test
