#include <epsnet/certify/reader.h>
#include <epsnet/certify/text.h>
#include <epsnet/certify/writer.h>
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>

namespace epsnet::certify {
namespace {

Document sample() { return read_net(std::string(EPSNET_TEST_DATA) + "/certify/verified/octagon-9-vertices.json"); }

std::string to_text(const Document& document) {
  std::ostringstream out;
  write_net(document, out);
  return out.str();
}

std::string complaint(const std::string& text) {
  try {
    static_cast<void>(parse_net(text, "test"));
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
  const Document document = sample();
  const std::string text = to_text(document);
  EXPECT_EQ(parse_net(text, "test"), document);
  EXPECT_EQ(to_text(parse_net(text, "test")), text);
}

TEST(Reader, ReadsSurfacesThatTheWriterWrites) {
  std::ostringstream out;
  write_surface(sample().surface, out);
  EXPECT_EQ(parse_surface(out.str(), "test"), sample().surface);
  EXPECT_THROW(static_cast<void>(parse_net(out.str(), "test")), MalformedError);
}

std::string surface_text(const std::string& object) {
  return R"({"format": "epsnet-surface", "version": 1, "surface": )" + object + "}";
}

std::string surface_complaint(const std::string& object) {
  try {
    static_cast<void>(parse_surface(surface_text(object), "test"));
  } catch (const MalformedError& error) {
    return error.what();
  }
  return "";
}

std::string to_text(const Surface& surface) {
  std::ostringstream out;
  write_surface(surface, out);
  return out.str();
}

TEST(Reader, RegularSurfacesComeBack) {
  for (const std::uint32_t genus : {2U, 3U, 1000U}) {
    Surface surface;
    surface.regular_genus = genus;
    EXPECT_EQ(parse_surface(to_text(surface), "test"), surface);
  }
  const Surface last_member_says_it = parse_surface(surface_text(R"({"genus": 7, "kind": "regular"})"), "test");
  EXPECT_EQ(last_member_says_it.regular_genus, 7U);
  Document document;
  document.surface.regular_genus = 2;
  document.epsilon = "1";
  document.charts = {{0, {0, 0}}};
  document.labels = {{0, 0, {7, 0}}};
  EXPECT_EQ(parse_net(to_text(document), "test"), document);
  document.charts[0].tile = 1;
  EXPECT_EQ(complaint(to_text(document)), "test: charts[0]: tile 1 does not exist, expected less than 1");
  document.charts[0].tile = 0;
  document.labels[0].word[1] = 8;
  EXPECT_EQ(complaint(to_text(document)), "test: labels[0]: side 8 does not exist, expected less than 8");
}

TEST(Reader, FreeTextComesBack) {
  std::string every_character = "\xcf\x80 \xe2\x89\xa5 3";
  for (char c = 0; c >= 0 && c < 127; ++c) every_character += c;
  Surface regular;
  regular.regular_genus = 2;
  for (Surface surface : {regular, sample().surface}) {
    surface.about = every_character;
    EXPECT_EQ(parse_surface(to_text(surface), "test"), surface);
    surface.about.assign(std::size_t{1} << 20, 'a');
    EXPECT_EQ(parse_surface(to_text(surface), "test"), surface);
    surface.about += 'a';
    EXPECT_THROW(static_cast<void>(parse_surface(to_text(surface), "test")), MalformedError);
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
            "test: surface: \"kind\" is \"round\", expected \"tiles\" or \"regular\"");
}

TEST(Reader, MembersComeInAnyOrderAndRationalsNeedNotBeReduced) {
  const std::string text = R"({"surface": {"gluing": [[0,0,0,1]], "kind": "tiles",
      "tiles": [[["0","0"],["-2/4","000"],["0","1/2"],["1/3","-0"]]]}, "version": 1, "format": "epsnet-surface"})";
  EXPECT_THROW(static_cast<void>(parse_surface(text, "test")), MalformedError);  // Two sides are not glued.
  const Surface surface = parse_surface(replaced(text, "[[0,0,0,1]]", "[[0,0,0,1],[0,2,0,3]]"), "test");
  EXPECT_EQ(surface.tiles[0][1].x, mpq_class(-1, 2));
  EXPECT_EQ(surface.tiles[0][1].y, 0);
  EXPECT_EQ(surface.tiles[0][3].y, 0);
}

TEST(Reader, ComplaintsNameFilePlaceAndExpectation) {
  Document document = sample();
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
  Document document = sample();
  const Tile v = document.surface.tiles[0];
  document.surface.tiles = {Tile{v[0], v[1], v[2], v[3], v[4]}, Tile{v[4], v[5], v[6], v[7], v[0]}};
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
  Document document = sample();
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

TEST(Reader, RationalOfAMillionDigitsIsFast) {
  const std::string digits(999'990, '7');
  const auto begin = std::chrono::steady_clock::now();
  const auto value = parse_rational("1/" + digits);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
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

}  // namespace
}  // namespace epsnet::certify
