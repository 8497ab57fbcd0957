#include "tests/assurance/file_mutants/reference_document.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

namespace epsnet::attack {
namespace {

using nlohmann::json;

void expect(bool holds, const char* why) {
  if (!holds) throw Malformed{why};
}

/// Without a byte order mark, comments, repeated keys.
json parse(std::string_view text) {
  expect(!text.starts_with("\xef\xbb\xbf"), "byte order mark");
  std::vector<std::set<std::string>> keys;
  bool repeated = false;
  const auto look = [&](int, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key) repeated = !keys.back().insert(value.get<std::string>()).second || repeated;
    return true;
  };
  try {
    json root = json::parse(text, look);
    expect(!repeated, "a repeated member");
    return root;
  } catch (const json::exception&) {
    throw Malformed{"no JSON"};
  }
}

void members(const json& object, const std::set<std::string>& needed, const std::set<std::string>& optional = {}) {
  expect(object.is_object(), "no object");
  std::size_t found = 0;
  for (const auto& [key, value] : object.items()) {
    found += needed.count(key);
    expect(needed.contains(key) || optional.contains(key), "an unknown member");
  }
  expect(found == needed.size(), "a missing member");
}

const json& rows(const json& value) {
  expect(value.is_array(), "no array");
  return value;
}
const json& tuple(const json& value, std::size_t n) {
  expect(value.is_array() && value.size() == n, "no array of the right size");
  return value;
}
/// "-0" is an integer with a sign for the library.
Index index(const json& value) {
  expect(value.is_number_unsigned() && value.get<std::uint64_t>() <= ~Index{0}, "no index");
  return value.get<Index>();
}
mpq_class binary64(const json& value) {
  expect(value.is_number(), "no number");
  const double x = value.get<double>();
  expect(std::isfinite(x), "too large");
  return mpq_class(x);
}
bool boolean(const json& value) {
  expect(value.is_boolean(), "no boolean");
  return value.get<bool>();
}
std::string text(const json& value) {
  expect(value.is_string(), "no string");
  return value.get<std::string>();
}

/// Takes digits off the front, at least one.
std::string digits(std::string_view& rest) {
  const auto n = static_cast<std::size_t>(
      std::find_if(rest.begin(), rest.end(), [](char c) { return c < '0' || c > '9'; }) - rest.begin());
  expect(n > 0, "no digits");
  std::string result(rest.substr(0, n));
  rest.remove_prefix(n);
  return result;
}
bool take(std::string_view& rest, std::string_view any) {
  if (rest.empty() || any.find(rest.front()) == std::string_view::npos) return false;
  rest.remove_prefix(1);
  return true;
}
mpq_class rational(const json& value, bool decimal = false) {
  const std::string all = text(value);
  std::string_view rest = all;
  const bool negative = take(rest, "-");
  std::string whole = digits(rest);
  std::size_t count = whole.size();
  mpq_class x;
  if (decimal && !rest.empty() && rest.front() != '/') {
    long exponent = 0;
    if (take(rest, ".")) {
      const std::string fraction = digits(rest);
      count += fraction.size();
      exponent -= static_cast<long>(fraction.size());
      whole += fraction;
    }
    if (take(rest, "eE")) {
      const bool down = rest.starts_with("-");
      static_cast<void>(take(rest, "+-"));
      const std::string power = digits(rest);
      expect(power.size() <= 4, "a long exponent");
      exponent += (down ? -1 : 1) * std::stol(power);
    }
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::labs(exponent)));
    x = exponent < 0 ? mpq_class(mpz_class(whole, 10), power) : mpq_class(mpz_class(mpz_class(whole, 10) * power));
  } else {
    mpz_class denominator = 1;
    if (take(rest, "/")) {
      const std::string below = digits(rest);
      count += below.size();
      denominator = mpz_class(below, 10);
    }
    expect(denominator != 0, "a denominator 0");
    x = mpq_class(mpz_class(whole, 10), denominator);
  }
  expect(rest.empty() && count <= 1'000'000, "no rational or decimal");
  x.canonicalize();
  return negative ? mpq_class(-x) : x;
}
RationalPoint rational_point(const json& x, const json& y) { return {rational(x), rational(y)}; }
bool in_disk(const RationalPoint& z) { return z.x * z.x + z.y * z.y < 1; }
std::vector<Index> word(const json& value) {
  std::vector<Index> result;
  for (const json& side : rows(value)) result.push_back(index(side));
  expect(result.size() <= 1'000'000, "a long word");
  return result;
}

void read_surface(const json& value, NetFile& net) {
  expect(value.is_object() && value.contains("kind"), "no kind");
  const bool regular = text(value.at("kind")) == "regular";
  if (regular) {
    members(value, {"kind", "genus"}, {"about"});
    net.genus = index(value.at("genus"));
    expect(net.genus >= 2 && net.genus <= 1000, "genus");
    const Index n = 4 * net.genus;
    for (Index k = 0; k < n; ++k) {
      net.tile.push_back(0);
      net.next.push_back((k + 1) % n);
      net.partner.push_back((k + 2 * net.genus) % n);
    }
  } else {
    members(value, {"kind", "tiles", "gluing"}, {"about"});
    expect(value.at("kind") == "tiles", "kind");
    std::vector<Index> first;
    for (const json& row : rows(value.at("tiles"))) {
      std::vector<RationalPoint> polygon;
      for (const json& z : rows(row)) polygon.push_back(rational_point(tuple(z, 2)[0], z[1]));
      expect(polygon.size() >= 3, "a tile without sides");
      first.push_back(static_cast<Index>(net.tile.size()));
      for (Index k = 0; k < polygon.size(); ++k) {
        net.tile.push_back(static_cast<Index>(net.tiles.size()));
        net.next.push_back(first.back() + (k + 1) % static_cast<Index>(polygon.size()));
      }
      net.tiles.push_back(std::move(polygon));
    }
    expect(!net.tiles.empty(), "no tile");
    net.partner.assign(net.tile.size(), ~Index{0});
    for (const json& row : rows(value.at("gluing"))) {
      std::array<Index, 2> s{};
      for (std::size_t i = 0; i < 2; ++i) {
        const Index t = index(tuple(row, 4)[2 * i]);
        const Index k = index(row[2 * i + 1]);
        expect(t < net.tiles.size() && k < net.tiles[t].size(), "a side that does not exist");
        s[i] = first[t] + k;
      }
      for (std::size_t i = 0; i < 2; ++i) {
        expect(net.partner[s[i]] == ~Index{0}, "a side glued twice");
        net.partner[s[i]] = s[1 - i];
      }
      expect(s[0] != s[1], "a side glued to itself");
    }
    expect(std::find(net.partner.begin(), net.partner.end(), ~Index{0}) == net.partner.end(), "a side not glued");
  }
  if (value.contains("about")) expect(text(value.at("about")).size() <= (1U << 20), "about");
}

void expect_path(const NetFile& net, const std::vector<Index>& path, Index from, Index to) {
  for (const Index s : path) {
    expect(s < net.tile.size() && net.tile[s] == from, "a word that is no path");
    from = net.tile[net.partner[s]];
  }
  expect(from == to, "a word to another tile");
}

NetFile read_net(const json& root) {
  members(root, {"format", "version", "surface", "epsilon", "charts", "labels", "vertices", "triangles"}, {"collars"});
  expect(root.at("format") == "epsnet-net", "format");
  expect(index(root.at("version")) == 1, "version");
  NetFile net;
  read_surface(root.at("surface"), net);
  net.epsilon = rational(root.at("epsilon"), true);
  expect(net.epsilon > 0, "epsilon");
  for (const json& row : rows(root.at("charts"))) {
    net.charts.push_back({index(tuple(row, 3)[0]), rational_point(row[1], row[2])});
    expect(net.charts.back().tile <= net.tile.back() && in_disk(net.charts.back().centre), "a chart");
  }
  for (const json& row : rows(root.at("labels"))) {
    net.labels.push_back({index(tuple(row, 3)[0]), index(row[1]), word(row[2])});
    const NetFile::Label& l = net.labels.back();
    expect(l.from < net.charts.size() && l.to < net.charts.size(), "a chart that does not exist");
    expect_path(net, l.word, net.charts[l.from].tile, net.charts[l.to].tile);
  }
  for (const json& row : rows(root.at("vertices"))) {
    net.vertices.push_back({index(tuple(row, 3)[0]), {binary64(row[1]), binary64(row[2])}});
    expect(net.vertices.back().chart < net.charts.size() && in_disk(net.vertices.back().z), "a vertex");
  }
  const json& triangles = rows(root.at("triangles"));
  for (const json& row : triangles) {
    std::array<Index, 8> n{};
    for (std::size_t i = 0; i < 8; ++i) n[i] = index(tuple(row, 8)[i]);
    const NetFile::Triangle t{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {0, n[6], n[7]}};
    for (std::size_t i = 0; i < 3; ++i) {
      expect(t.vertex[i] < net.vertices.size() && t.opposite[i] < 3 * triangles.size(), "a corner or a dart");
    }
    const Index to = net.vertices[t.vertex[0]].chart;
    for (std::size_t i = 1; i < 3; ++i) {
      const Index from = net.vertices[t.vertex[i]].chart;
      expect(t.label[i] <= net.labels.size(), "a label that does not exist");
      expect(
          t.label[i] == 0 ? from == to : net.labels[t.label[i] - 1].from == from && net.labels[t.label[i] - 1].to == to,
          "a label of other charts");
    }
    net.triangles.push_back(t);
  }
  if (!root.contains("collars")) return net;
  net.collars.emplace();
  for (const json& row : rows(root.at("collars"))) {
    members(row, {"core", "length", "vertices", "triangles"});
    NetFile::Collar c{word(row.at("core")), {}, {}, {}};
    for (std::size_t i = 0; i < 2; ++i) {
      c.length[i] = binary64(tuple(row.at("length"), 2)[i]);
      c.vertices[i] = index(tuple(row.at("vertices"), 2)[i]);
      c.triangles[i] = index(tuple(row.at("triangles"), 2)[i]);
      expect(c.vertices[i] < net.vertices.size() && c.triangles[i] < net.triangles.size(), "a collar of nothing");
    }
    expect(0 <= c.length[0] && c.length[0] <= c.length[1], "an interval");
    const Index tile = net.charts[net.vertices[c.vertices[0]].chart].tile;
    expect_path(net, c.core, tile, tile);
    net.collars->push_back(std::move(c));
  }
  return net;
}

void expect_clusters(const GeodesicsFile& file) {
  std::vector<std::pair<Index, Index>> runs;
  mpq_class end = 0;
  for (Index i = 0; i < file.geodesics.size(); ++i) {
    const auto& [lo, hi] = file.geodesics[i].length;
    if (i == 0 || lo > end) runs.emplace_back(i, 0);
    ++runs.back().second;
    end = std::max(end, hi);
  }
  expect(std::equal(runs.begin(), runs.end(), file.clusters.begin(), file.clusters.end(),
                    [](const auto& run, const auto& c) { return run.first == c.first && run.second == c.count; }),
         "other clusters");
}

GeodesicsFile read_geodesics(const json& root) {
  GeodesicsFile file;
  expect(root.contains("claim"), "no claim");
  file.claim = text(root.at("claim"));
  std::set<std::string> needed{"format", "version", "claim", "net", "geodesics"};
  if (file.claim != "systole") needed.insert("clusters");
  if (file.claim == "spectrum") needed.insert("up_to");
  if (file.claim == "thick-thin") needed.insert("pieces");
  members(root, needed);
  expect(file.claim == "systole" || file.claim == "spectrum" || file.claim == "thick-thin", "claim");
  expect(index(root.at("version")) == 1, "version");
  file.net = read_net(root.at("net"));
  expect(!file.net.collars, "a pseudo net");
  if (file.claim == "spectrum") {
    file.up_to = rational(root.at("up_to"), true);
    expect(file.up_to > 0, "up_to");
  }
  for (const json& row : rows(root.at("geodesics"))) {
    members(row, {"vertex", "word", "length", "simple"});
    GeodesicsFile::Geodesic g{index(row.at("vertex")), word(row.at("word")), {}, boolean(row.at("simple"))};
    for (std::size_t i = 0; i < 2; ++i) g.length[i] = binary64(tuple(row.at("length"), 2)[i]);
    expect(0 < g.length[0] && g.length[0] <= g.length[1], "an interval");
    expect(file.geodesics.empty() || file.geodesics.back().length[0] <= g.length[0], "not sorted");
    expect(g.vertex < file.net.vertices.size(), "a vertex that does not exist");
    const Index tile = file.net.charts[file.net.vertices[g.vertex].chart].tile;
    expect_path(file.net, g.word, tile, tile);
    file.geodesics.push_back(std::move(g));
  }
  if (file.claim == "systole") {
    expect(file.geodesics.size() == 1 && file.geodesics[0].length[1] < 2 * file.geodesics[0].length[0], "no systole");
    return file;
  }
  for (const json& row : rows(root.at("clusters"))) {
    members(row, {"first", "count", "equal"});
    file.clusters.push_back({index(row.at("first")), index(row.at("count")), boolean(row.at("equal"))});
  }
  expect_clusters(file);
  if (file.claim == "spectrum") return file;
  std::set<std::pair<Index, Index>> sides;
  for (const json& row : rows(root.at("pieces"))) {
    members(row, {"genus", "boundaries"});
    GeodesicsFile::Piece piece{index(row.at("genus")), {}};
    for (const json& side : rows(row.at("boundaries"))) {
      piece.boundaries.emplace_back(index(tuple(side, 2)[0]), index(side[1]));
      expect(piece.boundaries.back().first < file.geodesics.size() && piece.boundaries.back().second < 2,
             "a side of nothing");
      expect(sides.insert(piece.boundaries.back()).second, "a side twice");
    }
    file.pieces.push_back(std::move(piece));
  }
  expect(sides.size() == 2 * file.geodesics.size(), "a missing side");
  return file;
}

}  // namespace

File read_file(std::string_view text) {
  const json root = parse(text);
  expect(root.is_object() && root.contains("format"), "no format");
  File file;
  if (root.at("format") == "epsnet-geodesics") {
    file.geodesics = read_geodesics(root);
    file.net = file.geodesics->net;
  } else {
    file.net = read_net(root);
  }
  return file;
}

}  // namespace epsnet::attack
