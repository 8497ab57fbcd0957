#include "certify/file/plain_rows.h"

#include <cstdio>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which rows are taken out of a text, what they say, and what is left. Where nothing is taken, the strict reader reads
/// the text as a whole, so that a fault in this would not show in what is read.
namespace epsnet::certify {
namespace {

using Vertex = NetDocument::Vertex;
using Triangle = NetDocument::Triangle;

std::optional<PlainRows> taken(const std::string& text) {
  Pieces pieces(text);
  return take_plain_rows(pieces);
}

/// `row` between two others.
std::string vertices(const std::string& row) { return R"({"vertices":[[0,0,0],)" + row + ",[5,0.5,-1]]}"; }
std::string triangles(const std::string& row) {
  return R"({"triangles":[[0,0,0,0,0,0,0,0],)" + row + ",[8,7,6,5,4,3,2,1]]}";
}

void expect_vertex(const std::string& row, const Vertex& vertex) {
  const auto rows = taken(vertices(row));
  ASSERT_TRUE(rows.has_value()) << row;
  EXPECT_EQ(rows->vertices, (std::vector<Vertex>{{0, 0, 0}, vertex, {0.5, -1, 5}})) << row;
  EXPECT_TRUE(rows->triangles.empty());
  EXPECT_EQ(rows->rest, R"({"vertices":[]})");
}

void expect_triangle(const std::string& row, const Triangle& triangle) {
  const auto rows = taken(triangles(row));
  ASSERT_TRUE(rows.has_value()) << row;
  EXPECT_EQ(rows->triangles,
            (std::vector<Triangle>{{{0, 0, 0}, {0, 0, 0}, {0, 0}}, triangle, {{8, 7, 6}, {5, 4, 3}, {2, 1}}}))
      << row;
  EXPECT_TRUE(rows->vertices.empty());
  EXPECT_EQ(rows->rest, R"({"triangles":[]})");
}

TEST(PlainRows, VerticesAreTakenAsTheyAre) {
  expect_vertex("[1,2,3]", {2, 3, 1});
  expect_vertex("[9,0.09,-9e-09]", {0.09, -9e-9, 9});
  expect_vertex("[0,0,-0.0]", {0, 0, 0});
  expect_vertex("[4294967295,-0.25e-1,0.5E+1]", {-0.025, 5, std::numeric_limits<std::uint32_t>::max()});
  expect_vertex(" \t\r\n[ \t\r\n10 ,\r0.125\t, \n-1e-400 \n\r] \n", {0.125, 0, 10});
  expect_vertex("[7,1e308,0.1000000000000000055511151231257827021181583404541015625]", {1e308, 0.1, 7});
}

/// A number is all of its characters: the last one may say the most, as a digit, or as one of the exponent.
TEST(PlainRows, NumbersAreReadToTheirLastCharacter) {
  for (std::size_t zeros = 1; zeros < 300; ++zeros) {
    const std::string padded = "0.25" + std::string(zeros, '0');
    expect_vertex("[1," + padded + "e-2,0.5]", {0.0025, 0.5, 1});
    expect_vertex("[1,0.5," + padded + "e-2]", {0.5, 0.0025, 1});
    expect_vertex("[1,0." + std::string(zeros, '0') + "125e" + std::to_string(zeros) + ",0]", {0.125, 0, 1});
    // Half of the way from 1 to the next number, which is rounded to 1, and a little more.
    const std::string half = "1.00000000000000011102230246251565404236316680908203125";
    expect_vertex("[1," + half + ",-" + half + std::string(zeros, '0') + "1]", {1, -(1 + 0x1p-52), 1});
  }
}

TEST(PlainRows, TrianglesAreTakenAsTheyAre) {
  expect_triangle("[1,2,3,4,5,6,7,8]", {{1, 2, 3}, {4, 5, 6}, {7, 8}});
  expect_triangle("[9,9,99,90,0,19,10,9]", {{9, 9, 99}, {90, 0, 19}, {10, 9}});
  expect_triangle(" [ 10\n,\t20 ,30,40,50,60,4294967295\r, 0 ]\n", {{10, 20, 30}, {40, 50, 60}, {4294967295, 0}});
}

TEST(PlainRows, WhatIsNotPlainIsLeftToOthers) {
  for (const char* row : {"[]",
                          "[1]",
                          "[1,2]",
                          "[1,2,3,4]",
                          "[1,2,3",
                          "1,2,3]",
                          "[1,2,3],",
                          "[1 2,3]",
                          "[1,2 3]",
                          "[1,,3]",
                          "[,2,3]",
                          "[1,2,]",
                          "[1,2,3,]",
                          "[01,2,3]",
                          "[00,2,3]",
                          "[-1,2,3]",
                          "[-0,2,3]",
                          "[+1,2,3]",
                          "[1.0,2,3]",
                          "[1e0,2,3]",
                          "[4294967296,2,3]",
                          "[18446744073709551617,2,3]",
                          "[1,02,3]",
                          "[1,+2,3]",
                          "[1,2.,3]",
                          "[1,.2,3]",
                          "[1,2,1e400]",
                          "[1,2,nan]",
                          "[1,2,0x1]",
                          "[1,2,3a]",
                          "[1,\"2\",3]",
                          "[1,[2],3]",
                          "[1,2,3}",
                          "{1,2,3]",
                          "[1,\v2,3]",
                          "[1,2,\xa0"
                          "3]",
                          "x[1,2,3]",
                          "[1,2,3]x",
                          "null"}) {
    EXPECT_FALSE(taken(vertices(row)).has_value()) << row;
  }
  for (const std::string row : {"[1,2,3,4,5,6,7]", "[1,2,3,4,5,6,7,8,9]", "[1,2,3,4,5,6,7,8.0]", "[1,2,3,4,5,6,7,08]",
                                "[1,2,3,4,5,6,7 8]", "[1,2,3,4,5 6,7,8]", "[1,2,3 4,5,6,7,8]", "[1,2,3,4,5,6 7,8]",
                                "[1 2,3,4,5,6,7,8]", "[1,2,3,4,5,-6,7,8]", "[1,2,3,4,4294967296,6,7,8]"}) {
    EXPECT_FALSE(taken(triangles(row)).has_value()) << row;
  }
  for (const char* text : {R"({"vertices":[[0,0,0])", R"({"vertices":[[0,0,0],)", R"({"vertices":[[0,0,0)",
                           R"({"vertices":[[0,0,0]}])", R"({"triangles":[[1,2,3,4,5,6,7,8)"}) {
    EXPECT_FALSE(taken(text).has_value()) << text;
  }
}

/// Where no rows are, there is nothing to take.
TEST(PlainRows, NamesThatHaveNoRowsAreLeftAsTheyAre) {
  const std::string row = "[1,2,3]";
  for (const std::string name :
       {R"("vertices")", R"("vertices":)", R"("vertices":[)", R"("vertices":[])", R"("vertices":[1,2])",
        R"("vertices":{})", R"("vertices",[[1,2,3]])", R"("vertice":[[1,2,3]])", R"("verticess":[[1,2,3]])",
        R"("Vertices":[[1,2,3]])", R"("\u0076ertices":[[1,2,3]])", R"(vertices:[[1,2,3]])", R"("charts":[[1,2,3]])",
        R"("a\"vertices":[[1,2,3]])"}) {
    EXPECT_FALSE(taken("{" + name + "}").has_value()) << name;
    // Beside rows, they are part of the rest.
    const auto rows = taken("{" + name + R"(,"triangles" : [ [1,2,3,4,5,6,7,8] ] })");
    ASSERT_TRUE(rows.has_value()) << name;
    EXPECT_TRUE(rows->vertices.empty());
    EXPECT_EQ(rows->triangles, (std::vector<Triangle>{{{1, 2, 3}, {4, 5, 6}, {7, 8}}}));
    EXPECT_EQ(rows->rest, "{" + name + R"(,"triangles" : [] })");
  }
  for (const char* text : {"", " ", "{}", "\"", "\"\\", "[]"}) EXPECT_FALSE(taken(text).has_value()) << text;
}

TEST(PlainRows, OfEachNameTheFirstRowsAreTaken) {
  const std::string of_vertices = R"("vertices":[[1,2,3]])";
  const std::string of_triangles = R"("triangles":[[1,2,3,4,5,6,7,8]])";
  const std::string text = "{" + of_triangles + "," + of_vertices + "," + of_vertices + "," + of_triangles + "}";
  const auto rows = taken(text);
  ASSERT_TRUE(rows.has_value());
  EXPECT_EQ(rows->vertices, (std::vector<Vertex>{{2, 3, 1}}));
  EXPECT_EQ(rows->triangles, (std::vector<Triangle>{{{1, 2, 3}, {4, 5, 6}, {7, 8}}}));
  EXPECT_EQ(rows->rest, R"({"triangles":[],"vertices":[],)" + of_vertices + "," + of_triangles + "}");
}

/// What looks like rows inside a string is none, however the string ends.
TEST(PlainRows, StringsAreLeftAsTheyAre) {
  for (const std::string inside : {R"()", R"(a)", R"(\")", R"(\\)", R"(\\\")", R"(\"vertices\":[[1,2,3]])", R"(\\\\)",
                                   R"([[]{}:,)", R"(\u0022)", R"(\"vertices\":[[)"}) {
    for (const std::string& member : {"\"" + inside + "\":1", "\"a\":\"" + inside + "\""}) {
      const auto rows = taken("{" + member + R"(,"vertices":[[4,5,6]],)" + member + "}");
      ASSERT_TRUE(rows.has_value()) << member;
      EXPECT_EQ(rows->vertices, (std::vector<Vertex>{{5, 6, 4}}));
      EXPECT_EQ(rows->rest, "{" + member + R"(,"vertices":[],)" + member + "}");
    }
  }
  // A string that does not end takes all with it.
  for (const char* text :
       {R"({"a":"b,"vertices\":[[1,2,3]]})", R"({"a\",vertices":[[1,2,3]])", R"({"a"vertices":[[1,2,3]]})"}) {
    EXPECT_FALSE(taken(text).has_value()) << text;
  }
  EXPECT_TRUE(taken(R"({"a""vertices":[[1,2,3]]})").has_value());
}

/// Of a text that is cut off anywhere nothing is taken that stands behind its end.
TEST(PlainRows, NothingBehindTheEndIsTaken) {
  const std::string text = R"({ "vertices" : [ [ 1 , 0.25 , -0.5e1 ] , [ 12 , 1 , 2 ] ] ,
"triangles" : [ [ 1 , 2 , 3 , 4 , 5 , 6 , 7 , 8 ] ] , "vertices":[[1,0.25,0]],"triangles":[[1,2,3,4,5,6,7,80]]})";
  for (std::size_t begin : {std::size_t{0}, text.rfind("\"vertices"), text.rfind("\"triangles")}) {
    for (std::size_t end = begin; end <= text.size(); ++end) {
      const std::string copy = text.substr(begin, end - begin);
      Pieces pieces(std::string_view(text).substr(begin, end - begin));
      const auto rows = take_plain_rows(pieces);
      const auto wanted = taken(copy);
      ASSERT_EQ(rows.has_value(), wanted.has_value()) << copy;
      if (!rows) continue;
      EXPECT_EQ(rows->rest, wanted->rest);
      EXPECT_EQ(rows->vertices, wanted->vertices) << copy;
      EXPECT_EQ(rows->triangles, wanted->triangles) << copy;
    }
  }
}

/// Texts of several windows: rows, strings and white space cross their ends wherever these are.
TEST(PlainRows, LongTextsAreTakenApartAsShortOnes) {
  const std::string row = "[12,0.375,-0.625]";
  for (std::size_t length = 3900; length < 4200; ++length) {
    for (const char* end : {R"(\\\"",)", R"(",)"}) {
      const std::string filler = R"("a":")" + std::string(length, 'a') + end;
      const auto rows = taken("{" + filler + R"("vertices":[)" + row + "," + row + "]," + filler + "}");
      ASSERT_TRUE(rows.has_value()) << length;
      EXPECT_EQ(rows->vertices, (std::vector<Vertex>(2, {0.375, -0.625, 12})));
      EXPECT_EQ(rows->rest, "{" + filler + R"("vertices":[],)" + filler + "}");
    }
  }
  // Strings and blanks of many windows, from a file.
  const std::string row_name = R"(\"vertices\":[[1,2,3]])";
  for (const std::string& filler :
       {R"("a":")" + std::string(600'000, 'b') + R"(",)", R"("a":")" + std::string(600'000, 'b') + row_name + R"(",)",
        std::string(600'000, ' ')}) {
    const std::string text = "{" + filler + R"("vertices":[)" + row + "]," + filler + "}";
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
    ASSERT_EQ(std::fwrite(text.data(), 1, text.size(), file.get()), text.size());
    std::rewind(file.get());
    Pieces pieces(file.get(), text.size(), {});
    for (const auto& rows : {take_plain_rows(pieces), taken(text)}) {
      ASSERT_TRUE(rows.has_value());
      EXPECT_EQ(rows->vertices, (std::vector<Vertex>(1, {0.375, -0.625, 12})));
      EXPECT_EQ(rows->rest, "{" + filler + R"("vertices":[],)" + filler + "}");
    }
  }
  // A row that takes more bytes than a window may have.
  for (const std::size_t blanks : {1000U, 4000U}) {
    EXPECT_TRUE(taken(vertices("[1," + std::string(blanks, ' ') + "2,3]")).has_value()) << blanks;
  }
}

/// Where the rest is too long, what is behind it has not been looked at, were it a single byte.
TEST(PlainRows, ALongRestIsLeftToOthersToItsLastByte) {
  for (const char* end : {"x", "}", " "}) {
    EXPECT_FALSE(taken(R"({"vertices":[[1,2,3]]})" + std::string((std::size_t{1} << 26U) - 1, ' ') + end).has_value())
        << end;
  }
}

}  // namespace
}  // namespace epsnet::certify
