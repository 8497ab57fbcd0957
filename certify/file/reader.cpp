#include "certify/file/reader.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <functional>
#include <limits>
#include <memory>
#include <simdjson.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "certify/base/binary64.h"
#include "certify/base/text.h"
#include "certify/claims/bound/structure.h"
#include "certify/claims/distance/structure.h"
#include "certify/claims/geodesics/structure.h"
#include "certify/file/compact.h"
#include "certify/file/plain_rows.h"
#include "certify/net/structure.h"

namespace epsnet::certify {
namespace {

using simdjson::ondemand::array;
using simdjson::ondemand::object;
using simdjson::ondemand::value;

constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30;
constexpr std::size_t kMaxWordLetters = 1'000'000;
constexpr std::size_t kMaxLettersInAll = 10'000'000;
// Indices of rows are stored in 32 bits: a row takes two bytes or more, and a comma.
static_assert(kMaxFileBytes / 3 < std::numeric_limits<std::uint32_t>::max());

/// Where we are in the file: member[row].part, kept as numbers so that the good case formats nothing.
struct Place {
  const char* member = "";
  std::size_t row = 0;
  bool in_row = false;

  [[nodiscard]] std::string text() const {
    return in_row ? std::string(member) + "[" + std::to_string(row) + "]" : std::string(member);
  }
};

[[noreturn]] void fail(const Place& place, const std::string& problem) {
  throw MalformedError(place.text() + ": " + problem);
}

/// What simdjson complains of. Its own words differ from version to version, and ours are to be the same everywhere.
const char* complaint(simdjson::error_code error) {
  switch (error) {
    case simdjson::EMPTY:
      return "the input is empty";
    case simdjson::INCORRECT_TYPE:
      return "it is of another type";
    case simdjson::INCOMPLETE_ARRAY_OR_OBJECT:
      return "the text ends in the middle of an array or object";
    case simdjson::UNCLOSED_STRING:
      return "a string does not end";
    case simdjson::UNESCAPED_CHARS:
      return "a string has a character that must be escaped";
    case simdjson::UTF8_ERROR:
      return "it is not valid UTF-8";
    default:
      return "it is not JSON";
  }
}

/// The value of a simdjson result, or a MalformedError that says what was expected at the place.
template <class T>
T expect(simdjson::simdjson_result<T> result, const Place& place, const char* expected) {
  T found;
  if (const auto error = std::move(result).get(found)) {
    fail(place, std::string("expected ") + expected + " (" + complaint(error) + ")");
  }
  return found;
}

/// The text of the token at which the value starts. Only that it starts there and reaches to the next token is
/// simdjson's word; what it says is for us to read. simdjson 3.0.1 misreads decimals of twenty digits and more.
std::string_view token_of(simdjson::simdjson_result<value> item, const Place& place, const char* expected) {
  const std::string_view token = expect(item.raw_json_token(), place, expected);
  return token.substr(0, token.find_last_not_of(" \t\n\r") + 1);
}

std::uint32_t read_index(simdjson::simdjson_result<value> item, const Place& place) {
  constexpr const char* kExpected = "an index: an integer >= 0 without sign, fraction or exponent";
  const std::string_view token = token_of(item, place, kExpected);
  const bool digits = std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits || (token.size() > 1 && token.front() == '0')) {
    fail(place, in_quotes(token) + " found, expected " + kExpected);
  }
  std::uint32_t index = 0;
  if (std::from_chars(token.data(), token.data() + token.size(), index).ec != std::errc()) {
    fail(place, "the index " + in_quotes(token) + " is too large");
  }
  return index;
}

double read_binary64(simdjson::simdjson_result<value> item, const Place& place) {
  constexpr const char* kExpected = "a finite binary64 number";
  const std::string_view token = token_of(item, place, kExpected);
  const auto number = parse_binary64(token);
  if (!number) fail(place, in_quotes(token) + " found, expected " + kExpected);
  return *number;
}

mpq_class read_rational(simdjson::simdjson_result<value> item, const Place& place) {
  const std::string_view text = expect(item.get_string(), place, "a rational in a string, such as \"-3/4\"");
  auto number = parse_rational(text);
  if (!number) fail(place, in_quotes(text) + " is not a rational of at most 10^6 digits, such as \"-3/4\"");
  return *std::move(number);
}

/// Reads an array whose elements `read_element` takes one by one, and the position with it.
template <class ReadElement>
void read_array(simdjson::simdjson_result<value> item, const Place& place, const char* expected,
                const ReadElement& read_element) {
  array elements = expect(item.get_array(), place, expected);
  std::size_t position = 0;
  for (auto element : elements) {
    if (const auto error = element.error()) {
      fail(place, std::string("broken array (") + complaint(error) + ")");
    }
    read_element(element, position++);
  }
}

/// Reads an array of rows, one `read_row` each, naming member and row on error.
template <class ReadRow>
void read_rows(simdjson::simdjson_result<value> item, const char* member, const ReadRow& read_row) {
  read_array(item, {.member = member}, "an array", [&](simdjson::simdjson_result<value> row, std::size_t position) {
    read_row(row, Place{.member = member, .row = position, .in_row = true});
  });
}

/// Reads an array of exactly `size` elements.
template <class ReadElement>
void read_tuple(simdjson::simdjson_result<value> item, const Place& place, std::size_t size, const char* expected,
                const ReadElement& read_element) {
  std::size_t found = 0;
  read_array(item, place, expected, [&](simdjson::simdjson_result<value> element, std::size_t position) {
    if (position >= size) fail(place, std::string("too many elements, expected ") + expected);
    read_element(element, position);
    found = position + 1;
  });
  if (found != size) fail(place, "has " + std::to_string(found) + " elements, expected " + expected);
}

/// One member of an object: its name, how to read it, and whether it may be absent.
struct Member {
  std::string_view name;
  std::function<void(simdjson::simdjson_result<value>)> read;
  bool optional = false;
};

/// Reads an object that has exactly these members, each once, in any order. Says which of them are there.
std::vector<bool> read_members(object members, const Place& place, const std::vector<Member>& expected) {
  std::vector<bool> seen(expected.size());
  for (auto field : members) {
    if (const auto error = field.error()) {
      fail(place, std::string("broken object (") + complaint(error) + ")");
    }
    std::string_view key;
    if (const auto error = field.unescaped_key().get(key)) {
      fail(place, std::string("broken member name (") + complaint(error) + ")");
    }
    std::size_t which = 0;
    while (which < expected.size() && expected[which].name != key) ++which;
    if (which == expected.size()) fail(place, "unknown member " + in_quotes(key));
    if (seen[which]) fail(place, "repeated member " + in_quotes(key));
    seen[which] = true;
    expected[which].read(field.value());
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!seen[i] && !expected[i].optional) fail(place, "missing member " + in_quotes(expected[i].name));
  }
  return seen;
}

Member text_member(std::string_view name, std::string_view wanted, const Place& place) {
  return {name, [=](simdjson::simdjson_result<value> item) {
            const std::string_view text = expect(item.get_string(), place, "a string");
            if (text != wanted)
              fail(place, in_quotes(name) + " is " + in_quotes(text) + ", expected " + in_quotes(wanted));
          }};
}

Member version_member(const Place& place) {
  return {"version", [=](simdjson::simdjson_result<value> item) {
            const std::uint32_t version = read_index(item, {.member = "version"});
            if (version != 1) {
              fail(place, "version " + std::to_string(version) + " is not a version this program reads, expected 1");
            }
          }};
}

RationalPoint read_point(simdjson::simdjson_result<value> item, const Place& place) {
  RationalPoint point;
  read_tuple(item, place, 2, "[x, y], two rationals", [&](simdjson::simdjson_result<value> element, std::size_t i) {
    (i == 0 ? point.x : point.y) = read_rational(element, place);
  });
  return point;
}

void read_tiles(simdjson::simdjson_result<value> rows, std::vector<SurfaceDocument::Tile>& tiles) {
  read_rows(rows, "surface.tiles", [&](simdjson::simdjson_result<value> row, const Place& at) {
    SurfaceDocument::Tile tile;
    read_array(row, at, "an array of vertices",
               [&](simdjson::simdjson_result<value> vertex, std::size_t) { tile.push_back(read_point(vertex, at)); });
    tiles.push_back(std::move(tile));
  });
}

void read_gluing(simdjson::simdjson_result<value> rows, std::vector<SurfaceDocument::Gluing>& gluing) {
  read_rows(rows, "surface.gluing", [&](simdjson::simdjson_result<value> row, const Place& at) {
    std::array<std::uint32_t, 4> numbers{};
    read_tuple(row, at, 4, "[t, k, t', k'], four indices",
               [&](simdjson::simdjson_result<value> element, std::size_t i) { numbers[i] = read_index(element, at); });
    gluing.push_back({numbers[0], numbers[1], numbers[2], numbers[3]});
  });
}

/// A genus of 0 would read as "not regular" in the document, so the range is checked here.
std::uint32_t read_regular_genus(simdjson::simdjson_result<value> item) {
  const Place place{.member = "surface.genus"};
  const std::uint32_t genus = read_index(item, place);
  if (const auto problem = regular_genus_problem(genus)) fail(place, *problem);
  return genus;
}

SurfaceDocument read_surface_object(simdjson::simdjson_result<value> item) {
  const Place place{.member = "surface"};
  SurfaceDocument surface;
  std::string kind;
  const std::vector<Member> members{
      {"kind", [&](auto text) { kind = std::string(expect(text.get_string(), place, "a string")); }},
      {"tiles", [&](auto rows) { read_tiles(rows, surface.tiles); }, true},
      {"gluing", [&](auto rows) { read_gluing(rows, surface.gluing); }, true},
      {"genus", [&](auto number) { surface.regular_genus = read_regular_genus(number); }, true},
      {"about", [&](auto text) { surface.about = std::string(expect(text.get_string(), place, "a string")); }, true}};
  const std::vector<bool> seen = read_members(expect(item.get_object(), place, "an object"), place, members);
  // Which members there must be is known only now: the kind may be the last of them.
  const bool regular = kind == "regular";
  if (!regular && kind != "tiles") {
    fail(place, "\"kind\" is " + in_quotes(kind) + ", expected \"tiles\" or \"regular\"");
  }
  for (std::size_t i = 1; i < 4; ++i) {
    const bool wanted = regular == (members[i].name == "genus");
    if (wanted == seen[i]) continue;
    fail(place, (wanted ? "missing member " : "unknown member ") + in_quotes(members[i].name) +
                    " in a surface of the kind " + in_quotes(kind));
  }
  return surface;
}

NetDocument::Chart read_chart(simdjson::simdjson_result<value> row, const Place& at) {
  NetDocument::Chart chart{};
  read_tuple(row, at, 3, "[t, x, y], a tile and two rationals",
             [&](simdjson::simdjson_result<value> element, std::size_t i) {
               if (i == 0) {
                 chart.tile = read_index(element, at);
               } else {
                 (i == 1 ? chart.centre.x : chart.centre.y) = read_rational(element, at);
               }
             });
  return chart;
}

std::vector<std::uint32_t> read_word(simdjson::simdjson_result<value> item, const Place& at,
                                     std::size_t& letters_in_all) {
  std::vector<std::uint32_t> word;
  read_array(item, at, "a word, an array of side numbers",
             [&](simdjson::simdjson_result<value> letter, std::size_t position) {
               if (position >= kMaxWordLetters) fail(at, "the word has more than the limit of 10^6 letters");
               if (++letters_in_all > kMaxLettersInAll) fail(at, "more than the limit of 10^7 letters in all");
               word.push_back(read_index(letter, at));
             });
  return word;
}

NetDocument::Label read_label(simdjson::simdjson_result<value> row, const Place& at, std::size_t& letters_in_all) {
  NetDocument::Label label{};
  read_tuple(row, at, 3, "[from, to, word], two charts and an array of sides",
             [&](simdjson::simdjson_result<value> element, std::size_t i) {
               if (i == 2) {
                 label.word = read_word(element, at, letters_in_all);
               } else {
                 (i == 0 ? label.from : label.to) = read_index(element, at);
               }
             });
  return label;
}

NetDocument::Vertex read_vertex(simdjson::simdjson_result<value> row, const Place& at) {
  NetDocument::Vertex vertex{};
  read_tuple(row, at, 3, "[c, x, y], a chart and two numbers",
             [&](simdjson::simdjson_result<value> element, std::size_t i) {
               if (i == 0) {
                 vertex.chart = read_index(element, at);
               } else {
                 (i == 1 ? vertex.x : vertex.y) = read_binary64(element, at);
               }
             });
  return vertex;
}

NetDocument::Triangle read_triangle(simdjson::simdjson_result<value> row, const Place& at) {
  std::array<std::uint32_t, 8> n{};
  read_tuple(row, at, 8, "[v0, v1, v2, o0, o1, o2, l1, l2], eight indices",
             [&](simdjson::simdjson_result<value> element, std::size_t i) { n[i] = read_index(element, at); });
  return {.vertex = {n[0], n[1], n[2]}, .opposite = {n[3], n[4], n[5]}, .label = {n[6], n[7]}};
}

NetDocument::Collar read_collar(simdjson::simdjson_result<value> row, const Place& at, std::size_t& letters_in_all) {
  NetDocument::Collar collar{};
  const auto read_pair = [&](simdjson::simdjson_result<value> item, const char* expected, auto& pair,
                             const auto& read_element) {
    read_tuple(item, at, 2, expected,
               [&](simdjson::simdjson_result<value> element, std::size_t i) { pair[i] = read_element(element, at); });
  };
  read_members(expect(row.get_object(), at, "an object"), at,
               {{"core", [&](auto item) { collar.core = read_word(item, at, letters_in_all); }},
                {"length", [&](auto item) { read_pair(item, "[lo, hi], two numbers", collar.length, read_binary64); }},
                {"vertices", [&](auto item) { read_pair(item, "two vertices", collar.vertices, read_index); }},
                {"triangles", [&](auto item) { read_pair(item, "two triangles", collar.triangles, read_index); }}});
  return collar;
}

std::vector<Member> net_members(NetDocument& document, std::size_t& letters_in_all) {
  const Place place{.member = "net"};
  return {text_member("format", "epsnet-net", place),
          version_member(place),
          {"surface", [&](simdjson::simdjson_result<value> item) { document.surface = read_surface_object(item); }},
          {"epsilon",
           [&](simdjson::simdjson_result<value> item) {
             const Place at{.member = "epsilon"};
             document.epsilon = std::string(expect(item.get_string(), at, "a decimal in a string, such as \"0.01\""));
           }},
          {"charts",
           [&](simdjson::simdjson_result<value> rows) {
             read_rows(rows, "charts", [&](simdjson::simdjson_result<value> row, const Place& at) {
               document.charts.push_back(read_chart(row, at));
             });
           }},
          {"labels",
           [&](simdjson::simdjson_result<value> rows) {
             read_rows(rows, "labels", [&](simdjson::simdjson_result<value> row, const Place& at) {
               document.labels.push_back(read_label(row, at, letters_in_all));
             });
           }},
          {"vertices",
           [&](simdjson::simdjson_result<value> rows) {
             read_rows(rows, "vertices", [&](simdjson::simdjson_result<value> row, const Place& at) {
               document.vertices.push_back(read_vertex(row, at));
             });
           }},
          {"triangles",
           [&](simdjson::simdjson_result<value> rows) {
             read_rows(rows, "triangles", [&](simdjson::simdjson_result<value> row, const Place& at) {
               document.triangles.push_back(read_triangle(row, at));
             });
           }},
          {"collars",
           [&](simdjson::simdjson_result<value> rows) {
             document.collars.emplace();
             read_rows(rows, "collars", [&](simdjson::simdjson_result<value> row, const Place& at) {
               document.collars->push_back(read_collar(row, at, letters_in_all));
             });
           },
           true}};
}

bool read_truth(simdjson::simdjson_result<value> item, const Place& at) {
  return expect(item.get_bool(), at, "true or false");
}

GeodesicsDocument::Claim read_claim_name(simdjson::simdjson_result<value> item) {
  const Place place{.member = "claim"};
  const std::string_view text = expect(item.get_string(), place, "a string");
  if (text == "systole") return GeodesicsDocument::Claim::systole;
  if (text == "spectrum") return GeodesicsDocument::Claim::spectrum;
  if (text == "thick-thin") return GeodesicsDocument::Claim::thick_thin;
  fail(place, in_quotes(text) + " is not \"systole\", \"spectrum\" or \"thick-thin\"");
}

Interval read_interval(simdjson::simdjson_result<value> item, const Place& at) {
  Interval interval{};
  read_tuple(item, at, 2, "[lo, hi], two numbers", [&](simdjson::simdjson_result<value> element, std::size_t i) {
    (i == 0 ? interval.lower : interval.upper) = read_binary64(element, at);
  });
  return interval;
}

GeodesicsDocument::ClosedGeodesic read_geodesic(simdjson::simdjson_result<value> row, const Place& at,
                                                std::size_t& letters_in_all) {
  GeodesicsDocument::ClosedGeodesic geodesic;
  read_members(expect(row.get_object(), at, "an object"), at,
               {{"vertex", [&](auto item) { geodesic.vertex = read_index(item, at); }},
                {"word", [&](auto item) { geodesic.word = read_word(item, at, letters_in_all); }},
                {"length", [&](auto item) { geodesic.length = read_interval(item, at); }},
                {"simple", [&](auto item) { geodesic.simple = read_truth(item, at); }}});
  return geodesic;
}

GeodesicsDocument::Cluster read_cluster(simdjson::simdjson_result<value> row, const Place& at) {
  GeodesicsDocument::Cluster cluster;
  read_members(expect(row.get_object(), at, "an object"), at,
               {{"first", [&](auto item) { cluster.first = read_index(item, at); }},
                {"count", [&](auto item) { cluster.count = read_index(item, at); }},
                {"equal", [&](auto item) { cluster.equal = read_truth(item, at); }}});
  return cluster;
}

GeodesicsDocument::Piece read_piece(simdjson::simdjson_result<value> row, const Place& at) {
  GeodesicsDocument::Piece piece;
  const auto read_boundary = [&](simdjson::simdjson_result<value> item, std::size_t) {
    std::array<std::uint32_t, 2> n{};
    read_tuple(item, at, 2, "[geodesic, side], two indices",
               [&](simdjson::simdjson_result<value> element, std::size_t i) { n[i] = read_index(element, at); });
    piece.boundaries.emplace_back(n[0], n[1]);
  };
  read_members(
      expect(row.get_object(), at, "an object"), at,
      {{"genus", [&](auto item) { piece.genus = read_index(item, at); }},
       {"boundaries", [&](auto item) { read_array(item, at, "an array of [geodesic, side]", read_boundary); }}});
  return piece;
}

std::vector<Member> geodesics_members(GeodesicsDocument& document, std::size_t& letters_in_all) {
  const Place place{.member = "geodesics file"};
  const auto rows = [](const char* member, auto read_row) {
    return [=](simdjson::simdjson_result<value> item) { read_rows(item, member, read_row); };
  };
  using Row = simdjson::simdjson_result<value>;
  return {
      text_member("format", "epsnet-geodesics", place),
      version_member(place),
      {"claim", [&](Row item) { document.claim = read_claim_name(item); }},
      {"net",
       [&](Row item) {
         const Place at{.member = "net"};
         read_members(expect(item.get_object(), at, "an object"), at, net_members(document.net, letters_in_all));
       }},
      {"geodesics",
       rows("geodesics",
            [&](Row row, const Place& at) { document.geodesics.push_back(read_geodesic(row, at, letters_in_all)); })},
      {"up_to",
       [&](Row item) {
         document.up_to = std::string(expect(item.get_string(), {.member = "up_to"}, "a decimal in a string"));
       },
       true},
      {"clusters",
       rows("clusters", [&](Row row, const Place& at) { document.clusters.push_back(read_cluster(row, at)); }), true},
      {"pieces", rows("pieces", [&](Row row, const Place& at) { document.pieces.push_back(read_piece(row, at)); }),
       true}};
}

/// Which of the last three members of geodesics_members there must be is known only when all have been read.
void check_members_of_claim(GeodesicsDocument::Claim claim, const std::vector<bool>& seen) {
  const Place place{.member = "geodesics file"};
  const auto expect_member = [&](std::size_t index, const char* name, bool wanted) {
    if (seen[index] == wanted) return;
    fail(place, (wanted ? "missing member " : "unknown member ") + in_quotes(name) + " for this claim");
  };
  expect_member(5, "up_to", claim == GeodesicsDocument::Claim::spectrum);
  expect_member(6, "clusters", claim != GeodesicsDocument::Claim::systole);
  expect_member(7, "pieces", claim == GeodesicsDocument::Claim::thick_thin);
}

DistanceDocument::Point read_place(simdjson::simdjson_result<value> item) {
  const NetDocument::Chart read = read_chart(item, {.member = "point"});
  return {.tile = read.tile, .z = read.centre};
}

/// A list of indices.
std::vector<std::uint32_t> read_indices(simdjson::simdjson_result<value> item, const Place& place) {
  std::vector<std::uint32_t> result;
  read_array(item, place, "an array of indices", [&](simdjson::simdjson_result<value> element, std::size_t) {
    result.push_back(read_index(element, place));
  });
  return result;
}

BoundDocument::Claim read_bound_claim(simdjson::simdjson_result<value> item) {
  const Place place{.member = "claim"};
  const std::string_view name = expect(item.get_string(), place, "a string");
  if (name == "diameter") return BoundDocument::Claim::diameter;
  if (name == "radius") return BoundDocument::Claim::radius;
  if (name == "embedded-disk") return BoundDocument::Claim::embedded_disk;
  fail(place, in_quotes(name) + " is no claim, expected \"diameter\", \"radius\" or \"embedded-disk\"");
}

BoundDocument::Triangulation read_flips(simdjson::simdjson_result<value> row, const Place& at) {
  std::vector<std::uint32_t> numbers = read_indices(row, at);
  if (numbers.empty()) fail(at, "no element, expected the number of a triangulation, and darts");
  return {numbers[0], {numbers.begin() + 1, numbers.end()}};
}

std::vector<Member> bound_members(BoundDocument& document, std::size_t& letters_in_all) {
  using Row = simdjson::simdjson_result<value>;
  return {text_member("format", "epsnet-cover", {.member = "bound file"}),
          version_member({.member = "bound file"}),
          {"claim", [&](Row item) { document.claim = read_bound_claim(item); }},
          {"net",
           [&](Row item) {
             const Place at{.member = "net"};
             read_members(expect(item.get_object(), at, "an object"), at, net_members(document.net, letters_in_all));
           }},
          {"value", [&](Row item) { document.value = read_interval(item, {.member = "value"}); }},
          {"triangulations",
           [&](Row item) {
             read_rows(item, "triangulations",
                       [&](Row row, const Place& at) { document.triangulations.push_back(read_flips(row, at)); });
           }},
          {"cells", [&](Row item) {
             read_rows(item, "cells",
                       [&](Row row, const Place& at) { document.cells.push_back(read_indices(row, at)); });
           }}};
}

std::vector<Member> distance_members(DistanceDocument& document, std::size_t& letters_in_all) {
  using Row = simdjson::simdjson_result<value>;
  return {text_member("format", "epsnet-distance", {.member = "distance file"}),
          version_member({.member = "distance file"}),
          {"net",
           [&](Row item) {
             const Place at{.member = "net"};
             read_members(expect(item.get_object(), at, "an object"), at, net_members(document.net, letters_in_all));
           }},
          {"point", [&](Row item) { document.point = read_place(item); }},
          {"distance", [&](Row item) { document.distance = read_interval(item, {.member = "distance"}); }},
          {"paths",
           [&](Row item) {
             read_rows(item, "paths",
                       [&](Row row, const Place& at) { document.paths.push_back(read_word(row, at, letters_in_all)); });
           }},
          {"equal", [&](Row item) { document.equal = read_truth(item, {.member = "equal"}); }}};
}

/// Runs `read_document` on the parsed text and puts the file's name in front of every complaint.
template <class ReadDocument>
void parse(simdjson::padded_string_view text, std::string_view name, const ReadDocument& read_document) {
  const Place place{.member = "document"};
  const RoundingToNearest rounding;
  try {
    if (text.size() > kMaxFileBytes) fail(place, "the file is larger than the limit of 4 GiB");
    // Some versions of simdjson skip it, others do not.
    if (std::string_view(text.data(), text.size()).starts_with("\xef\xbb\xbf"))
      fail(place, "begins with a byte order mark, expected an object");
    simdjson::ondemand::parser parser;
    simdjson::ondemand::document json;
    if (const auto error = parser.iterate(text).get(json)) {
      if (error == simdjson::MEMALLOC) throw std::bad_alloc();
      fail(place, std::string("not a JSON document (") + complaint(error) + ")");
    }
    object members;
    if (const auto error = json.get_object().get(members)) {
      fail(place, std::string("expected an object (") + complaint(error) + ")");
    }
    read_document(members);
    if (json.current_location().error() != simdjson::OUT_OF_BOUNDS) fail(place, "text after the end of the document");
  } catch (const MalformedError& error) {
    throw MalformedError(std::string(name) + ": " + error.what());
  }
}

/// The document of a net with the rows that were taken out of its text. What is read is added to them.
NetDocument net_with(PlainRows&& rows) {
  NetDocument net;
  net.vertices = std::move(rows.vertices);
  net.triangles = std::move(rows.triangles);
  return net;
}

/// Without a look at what the members say together.
NetDocument parse_net_members(simdjson::padded_string_view text, std::string_view name, PlainRows&& rows = {}) {
  NetDocument document = net_with(std::move(rows));
  parse(text, name, [&](object members) {
    std::size_t letters_in_all = 0;
    read_members(members, {.member = "net"}, net_members(document, letters_in_all));
  });
  return document;
}

bool is_compact(simdjson::padded_string_view text) { return certify::is_compact({text.data(), text.size()}); }

/// simdjson reads up to SIMDJSON_PADDING bytes past the end; a reserve of that size makes it legal without a copy.
simdjson::padded_string_view padded(std::string& bytes) {
  bytes.reserve(bytes.size() + simdjson::SIMDJSON_PADDING);
  return simdjson::padded_string_view(bytes, bytes.capacity());
}

NetDocument parse_compact_head(std::string_view head) {
  return parse_net_members(simdjson::padded_string(head), "head");
}

NetDocument parse_padded_net(simdjson::padded_string_view text, std::string_view name, PlainRows&& rows = {}) {
  NetDocument document;
  if (is_compact(text)) {
    try {
      document = parse_compact(std::string_view(text.data(), text.size()), parse_compact_head);
    } catch (const MalformedError& error) {
      throw MalformedError(std::string(name) + ": " + error.what());
    }
  } else {
    document = parse_net_members(text, name, std::move(rows));
  }
  if (const auto problem = structure_problem(document)) throw MalformedError(std::string(name) + ": " + *problem);
  return document;
}

SurfaceDocument parse_padded_surface(simdjson::padded_string_view text, std::string_view name) {
  SurfaceDocument surface;
  parse(text, name, [&](object members) {
    const Place place{.member = "surface file"};
    read_members(members, place,
                 {text_member("format", "epsnet-surface", place),
                  version_member(place),
                  {"surface", [&](auto item) { surface = read_surface_object(item); }}});
    if (const auto problem = structure_problem(surface)) throw MalformedError(*problem);
  });
  return surface;
}

GeodesicsDocument parse_padded_geodesics(simdjson::padded_string_view text, std::string_view name,
                                         PlainRows&& rows = {}) {
  GeodesicsDocument document;
  document.net = net_with(std::move(rows));
  parse(text, name, [&](object members) {
    std::size_t letters_in_all = 0;
    const std::vector<bool> seen =
        read_members(members, {.member = "geodesics file"}, geodesics_members(document, letters_in_all));
    check_members_of_claim(document.claim, seen);
    if (const auto problem = structure_problem(document)) throw MalformedError(*problem);
  });
  return document;
}

DistanceDocument parse_padded_distance(simdjson::padded_string_view text, std::string_view name,
                                       PlainRows&& rows = {}) {
  DistanceDocument document;
  document.net = net_with(std::move(rows));
  parse(text, name, [&](object members) {
    std::size_t letters_in_all = 0;
    read_members(members, {.member = "distance file"}, distance_members(document, letters_in_all));
    if (const auto problem = structure_problem(document)) throw MalformedError(*problem);
  });
  return document;
}

BoundDocument parse_padded_bound(simdjson::padded_string_view text, std::string_view name, PlainRows&& rows = {}) {
  BoundDocument document;
  document.net = net_with(std::move(rows));
  parse(text, name, [&](object members) {
    std::size_t letters_in_all = 0;
    read_members(members, {.member = "bound file"}, bound_members(document, letters_in_all));
    if (const auto problem = structure_problem(document)) throw MalformedError(*problem);
  });
  return document;
}

/// What the text, if it begins to be an object, says in its member `format`. Errors are for the reader proper.
std::string format_of(simdjson::padded_string_view text) {
  if (text.size() > kMaxFileBytes) return "";
  simdjson::ondemand::parser parser;
  simdjson::ondemand::document json;
  object members;
  if (parser.iterate(text).get(json)) return "";
  if (json.get_object().get(members)) return "";
  for (auto field : members) {
    std::string_view key;
    std::string_view format;
    if (field.unescaped_key().get(key)) return "";
    if (key == "format") return field.value().get_string().get(format) ? "" : std::string(format);
  }
  return "";
}

ClaimDocument parse_padded_claim(simdjson::padded_string_view text, std::string_view name, PlainRows&& rows = {}) {
  if (is_compact(text)) return parse_padded_net(text, name);
  const std::string format = format_of(text);
  if (format == "epsnet-geodesics") return parse_padded_geodesics(text, name, std::move(rows));
  if (format == "epsnet-distance") return parse_padded_distance(text, name, std::move(rows));
  if (format == "epsnet-cover") return parse_padded_bound(text, name, std::move(rows));
  return parse_padded_net(text, name, std::move(rows));
}

/// What the functions above read, in less time and memory: rows of numbers are taken as they come along. Nothing if
/// that does not work or anything is wrong, which is for them to say.
std::optional<ClaimDocument> parse_in_pieces(Pieces& bytes) {
  const RoundingToNearest rounding;
  try {
    if (certify::is_compact(bytes.ahead(kCompactMagic.size()))) {
      NetDocument net = parse_compact(bytes, parse_compact_head);
      return structure_problem(net) ? std::nullopt : std::optional<ClaimDocument>(std::move(net));
    }
    std::optional<PlainRows> rows = take_plain_rows(bytes);
    if (!rows) return std::nullopt;
    std::string rest = std::move(rows->rest);
    return parse_padded_claim(padded(rest), "", std::move(*rows));
  } catch (const MalformedError&) {
    return std::nullopt;
  }
}

std::optional<ClaimDocument> parse_in_pieces(simdjson::padded_string_view text) {
  if (is_compact(text) || text.size() > kMaxFileBytes) return std::nullopt;
  Pieces pieces(std::string_view(text.data(), text.size()));
  return parse_in_pieces(pieces);
}

ClaimDocument parse_any_claim(simdjson::padded_string_view text, std::string_view name) {
  std::optional<ClaimDocument> document = parse_in_pieces(text);
  return document ? *std::move(document) : parse_padded_claim(text, name);
}

/// The net of a document that was read, if it is a net and nothing else.
std::optional<NetDocument> only_net(std::optional<ClaimDocument>&& document) {
  auto* net = document ? std::get_if<NetDocument>(&*document) : nullptr;
  return net != nullptr ? std::optional(std::move(*net)) : std::nullopt;
}

NetDocument parse_any_net(simdjson::padded_string_view text, std::string_view name) {
  std::optional<NetDocument> net = only_net(parse_in_pieces(text));
  return net ? *std::move(net) : parse_padded_net(text, name);
}

}  // namespace

std::string display_name(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path_in_quotes(path.string());
}

std::string load(const std::filesystem::path& path) {
  const std::string name = display_name(path);
  const auto fail_to_read = [&](const std::string& why) { throw FileError(name + ": " + why); };
  std::FILE* file = stdin;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> opened(nullptr, &std::fclose);
  if (path != "-") {
    opened.reset(std::fopen(path.c_str(), "rb"));
    if (!opened)
      fail_to_read(errno == ENOENT ? "no such file" : "cannot be opened: " + std::string(std::strerror(errno)));
    file = opened.get();
  }
  struct stat status {};
  if (fstat(fileno(file), &status) != 0) fail_to_read("cannot be read: " + std::string(std::strerror(errno)));
  if (S_ISDIR(status.st_mode)) fail_to_read("is a directory, expected a file");
  // Of the devices only a terminal ends: /dev/zero never would.
  if ((S_ISCHR(status.st_mode) && isatty(fileno(file)) == 0) || S_ISBLK(status.st_mode)) {
    fail_to_read("is a device, expected a file");
  }
  std::string bytes;
  constexpr std::size_t kChunk = 1 << 20;
  if (S_ISREG(status.st_mode) && static_cast<std::uint64_t>(status.st_size) <= kMaxFileBytes) {
    // The last chunk, which is not filled, has to fit in as well.
    bytes.reserve(static_cast<std::size_t>(status.st_size) + kChunk + simdjson::SIMDJSON_PADDING);
  }
  for (std::size_t read = kChunk; read == kChunk;) {
    const std::size_t old_size = bytes.size();
    bytes.resize(old_size + kChunk);
    read = std::fread(bytes.data() + old_size, 1, kChunk, file);
    bytes.resize(old_size + read);
    if (bytes.size() > kMaxFileBytes) {
      throw MalformedError(name + ": document: the file is larger than the limit of 4 GiB");
    }
  }
  if (std::ferror(file) != 0) fail_to_read("cannot be read: " + std::string(std::strerror(errno)));
  return bytes;
}

std::optional<ClaimDocument> read_claim_in_pieces(const std::filesystem::path& path,
                                                  const std::function<void(std::string_view)>& witness) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size <= kMaxBytesAtOnce || size > kMaxFileBytes) return std::nullopt;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return std::nullopt;
  Pieces pieces(file.get(), size, witness);
  return parse_in_pieces(pieces);
}

NetDocument read_net(const std::filesystem::path& path) {
  if (std::optional<NetDocument> net = only_net(read_claim_in_pieces(path))) return *std::move(net);
  std::string bytes = load(path);
  return parse_any_net(padded(bytes), display_name(path));
}

NetDocument parse_net(std::string_view text, std::string_view name) {
  return parse_any_net(simdjson::padded_string(text), name);
}

SurfaceDocument read_surface(const std::filesystem::path& path) {
  std::string bytes = load(path);
  return parse_padded_surface(padded(bytes), display_name(path));
}

SurfaceDocument parse_surface(std::string_view text, std::string_view name) {
  return parse_padded_surface(simdjson::padded_string(text), name);
}

GeodesicsDocument read_geodesics(const std::filesystem::path& path) {
  std::string bytes = load(path);
  return parse_padded_geodesics(padded(bytes), display_name(path));
}

GeodesicsDocument parse_geodesics(std::string_view text, std::string_view name) {
  return parse_padded_geodesics(simdjson::padded_string(text), name);
}

DistanceDocument read_distance(const std::filesystem::path& path) {
  std::string bytes = load(path);
  return parse_padded_distance(padded(bytes), display_name(path));
}

DistanceDocument parse_distance(std::string_view text, std::string_view name) {
  return parse_padded_distance(simdjson::padded_string(text), name);
}

BoundDocument read_bound(const std::filesystem::path& path) {
  std::string bytes = load(path);
  return parse_padded_bound(padded(bytes), display_name(path));
}

BoundDocument parse_bound(std::string_view text, std::string_view name) {
  return parse_padded_bound(simdjson::padded_string(text), name);
}

ClaimDocument read_claim(const std::filesystem::path& path) {
  if (std::optional<ClaimDocument> document = read_claim_in_pieces(path)) return *std::move(document);
  std::string bytes = load(path);
  return parse_claim_in_place(bytes, display_name(path));
}

ClaimDocument parse_claim(std::string_view text, std::string_view name) {
  return parse_any_claim(simdjson::padded_string(text), name);
}

ClaimDocument parse_claim_in_place(std::string& bytes, std::string_view name) {
  return parse_any_claim(padded(bytes), name);
}

}  // namespace epsnet::certify
