#include "certify/exact/document.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace epsnet::exact {

const Json* find(const Json& object, const char* name) {
  for (const Json::Member& member : object.members) {
    if (member.name == name) return &member.value;
  }
  return nullptr;
}

const Json& member(const Json& object, const char* name) {
  const Json* found = find(object, name);
  if (found == nullptr) throw Malformed(std::string("no member \"") + name + '"');
  return *found;
}

bool is_text(const Json& value, std::string_view text) {
  return value.kind == Json::Kind::string && value.text == text;
}

void expect_text(const Json& value, std::string_view text, const char* what) {
  if (!is_text(value, text)) throw Malformed("unexpected value for " + std::string(what));
}

void expect_members(const Json& value, std::initializer_list<std::string_view> names) {
  if (value.kind != Json::Kind::object) throw Malformed("expected an object");
  for (const Json::Member& found : value.members) {
    if (std::find(names.begin(), names.end(), found.name) == names.end()) {
      throw Malformed("unknown member \"" + found.name.substr(0, 40) + '"');
    }
  }
}

const std::vector<Json>& array(const Json& value, const char* what) {
  if (value.kind != Json::Kind::array) throw Malformed(std::string(what) + ": expected an array");
  return value.elements;
}

const std::vector<Json>& tuple(const Json& value, std::size_t size, const char* what) {
  const std::vector<Json>& elements = array(value, what);
  if (elements.size() != size) throw Malformed(std::string(what) + ": expected " + std::to_string(size) + " elements");
  return elements;
}

RationalPoint read_rational_point(const Json& x, const Json& y) {
  const mpq_class re = to_rational(x);
  const mpq_class im = to_rational(y);
  const mpz_class m = lcm(re.get_den(), im.get_den());
  return {{re.get_num() * (m / re.get_den()), im.get_num() * (m / im.get_den())}, m};
}

void expect_version(const Json& root) {
  if (to_index(member(root, "version")) != 1) throw Malformed("the version is not 1");
}

mpq_class read_binary64(const Json& value) {
  const Binary64 read = to_binary64(value);
  const auto power = static_cast<mp_bitcnt_t>(std::abs(read.exponent));
  if (read.exponent >= 0) return read.mantissa << power;
  mpq_class number(read.mantissa, mpz_class(1) << power);
  number.canonicalize();
  return number;
}

std::array<mpq_class, 2> read_length(const Json& value, const char* what) {
  const auto& two = tuple(value, 2, what);
  std::array<mpq_class, 2> length{read_binary64(two[0]), read_binary64(two[1])};
  if (length[0] < 0 || length[1] < length[0]) throw Malformed(std::string(what) + ": expected 0 <= lo <= hi");
  return length;
}

std::vector<Index> read_indices(const Json& value, const char* what) {
  std::vector<Index> indices;
  for (const Json& element : array(value, what)) indices.push_back(to_index(element));
  return indices;
}

std::vector<Index> Words::read(const Json& value) {
  std::vector<Index> word = read_indices(value, "a word");
  letters_ += word.size();
  if (word.size() > 1'000'000 || letters_ > 10'000'000) throw Malformed("too many letters");
  return word;
}

namespace {

RationalPoint read_binary_point(const Json& x, const Json& y) {
  const Binary64 re = to_binary64(x);
  const Binary64 im = to_binary64(y);
  const long shift = std::max({0L, -re.exponent, -im.exponent});
  const auto scaled = [&](const Binary64& n) {
    return mpz_class(n.mantissa << static_cast<mp_bitcnt_t>(n.exponent + shift));
  };
  return lowest_terms({scaled(re), scaled(im)}, mpz_class(mpz_class(1) << static_cast<mp_bitcnt_t>(shift)));
}

std::vector<Collar> read_collars(const Json& value, Words& words) {
  std::vector<Collar> collars;
  for (const Json& row : array(value, "collars")) {
    expect_members(row, {"core", "length", "vertices", "triangles"});
    const auto& vertices = tuple(member(row, "vertices"), 2, "vertices of a collar");
    const auto& triangles = tuple(member(row, "triangles"), 2, "triangles of a collar");
    collars.push_back({words.read(member(row, "core")),
                       read_length(member(row, "length"), "length of a collar"),
                       {to_index(vertices[0]), to_index(vertices[1])},
                       {to_index(triangles[0]), to_index(triangles[1])}});
  }
  return collars;
}

Index read_between(const Json& value, Index least, Index most, const char* what) {
  const Index n = to_index(value);
  if (n < least || n > most) {
    throw Malformed(std::string(what) + ": not from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return n;
}

void read_gluing(const Json& surface, Net& net) {
  for (const Json& row : array(member(surface, "gluing"), "gluing")) {
    const auto& four = tuple(row, 4, "gluing");
    net.gluing.push_back({to_index(four[0]), to_index(four[1]), to_index(four[2]), to_index(four[3])});
  }
}

Polynomial read_polynomial(const Json& value, std::size_t most, const char* what) {
  Polynomial coefficients;
  for (const Json& element : array(value, what)) coefficients.push_back(to_integer(element));
  if (coefficients.empty() || coefficients.size() > most) {
    throw Malformed(std::string(what) + ": not 1 to " + std::to_string(most) + " integers");
  }
  return coefficients;
}

template <std::size_t size>
std::array<Polynomial, size> read_field_numbers(const Json& value, std::size_t degree, const char* what) {
  std::array<Polynomial, size> numbers;
  for (std::size_t i = 0; i < size; ++i) {
    numbers.at(i) = read_polynomial(tuple(value, size, what)[i], degree, "a number of the field");
  }
  return numbers;
}

void read_field(const Json& surface, Net& net) {
  constexpr std::size_t kMaxDegree = 64;
  FieldTiles& field = net.field.emplace();
  field.polynomial = read_polynomial(member(surface, "polynomial"), kMaxDegree + 1, "polynomial");
  const std::size_t degree = field.polynomial.size() - 1;
  if (degree == 0 || field.polynomial.back() != 1) throw Malformed("polynomial: not monic, or of degree 0");
  const auto& ends = tuple(member(surface, "root"), 2, "root");
  field.root = {to_rational(ends[0]), to_rational(ends[1])};
  if (field.root[0] >= field.root[1]) throw Malformed("root: expected L < U");
  for (const Json& row : array(member(surface, "polygons"), "polygons")) {
    field.tiles.emplace_back();
    for (const Json& vertex : array(row, "a tile")) {
      field.tiles.back().push_back(read_field_numbers<3>(vertex, degree, "a vertex of a tile"));
    }
  }
  read_gluing(surface, net);
  for (const Json& row : array(member(surface, "crossings"), "crossings")) {
    field.crossings.push_back(read_field_numbers<4>(row, degree, "a crossing"));
  }
  if (field.crossings.size() != net.gluing.size()) throw Malformed("crossings: not one for each row of gluing");
}

void read_surface(const Json& surface, Net& net) {
  const Json& kind = member(surface, "kind");
  if (is_text(kind, "regular")) {
    expect_members(surface, {"kind", "genus", "about"});
    const Index genus = read_between(member(surface, "genus"), 2, 1000, "genus");
    net.regular = {4 * genus, 4 * genus};
    for (Index k = 0; k < 2 * genus; ++k) net.gluing.push_back({0, k, 0, k + 2 * genus});
  } else if (is_text(kind, "map")) {
    expect_members(surface, {"kind", "p", "q", "gluing", "about"});
    net.regular = {read_between(member(surface, "p"), 3, 10'000, "p"),
                   read_between(member(surface, "q"), 3, 10'000, "q")};
    read_gluing(surface, net);
    if (2 * net.gluing.size() % net.regular->p != 0) throw Malformed("the sides are not those of whole tiles");
  } else if (is_text(kind, "field")) {
    expect_members(surface, {"kind", "polynomial", "root", "polygons", "gluing", "crossings", "about"});
    read_field(surface, net);
  } else {
    expect_members(surface, {"kind", "tiles", "gluing", "about"});
    expect_text(kind, "tiles", "the kind of the surface");
    for (const Json& row : array(member(surface, "tiles"), "tiles")) {
      net.tiles.emplace_back();
      for (const Json& vertex : array(row, "a tile")) {
        const auto& pair = tuple(vertex, 2, "a vertex of a tile");
        net.tiles.back().push_back(read_rational_point(pair[0], pair[1]));
      }
    }
    read_gluing(surface, net);
  }
  if (const Json* about = find(surface, "about");
      about != nullptr && (about->kind != Json::Kind::string || about->text.size() > (std::size_t{1} << 20))) {
    throw Malformed("about: expected a string of at most 1 MiB");
  }
}

}  // namespace

Net read_net(const Json& root, Words& words) {
  expect_members(root,
                 {"format", "version", "surface", "epsilon", "charts", "labels", "vertices", "triangles", "collars"});
  expect_text(member(root, "format"), "epsnet-net", "the format");
  expect_version(root);
  Net net;
  read_surface(member(root, "surface"), net);
  net.epsilon = to_decimal(member(root, "epsilon"));
  for (const Json& row : array(member(root, "charts"), "charts")) {
    const auto& three = tuple(row, 3, "a chart");
    net.charts.emplace_back(to_index(three[0]), read_rational_point(three[1], three[2]));
  }
  for (const Json& row : array(member(root, "labels"), "labels")) {
    const auto& three = tuple(row, 3, "a label");
    net.labels.push_back({to_index(three[0]), to_index(three[1]), words.read(three[2])});
  }
  for (const Json& row : array(member(root, "vertices"), "vertices")) {
    const auto& three = tuple(row, 3, "a vertex");
    net.vertices.push_back({to_index(three[0]), read_binary_point(three[1], three[2])});
  }
  for (const Json& row : array(member(root, "triangles"), "triangles")) {
    const auto& n = tuple(row, 8, "a triangle");
    const auto at = [&](std::size_t i) { return to_index(n[i]); };
    net.triangles.push_back({{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {0, at(6), at(7)}});
  }
  if (const Json* collars = find(root, "collars")) net.collars = read_collars(*collars, words);
  return net;
}

void read_surface_file(const Json& root) {
  expect_members(root, {"format", "version", "surface"});
  expect_text(member(root, "format"), "epsnet-surface", "the format");
  expect_version(root);
  Net net;
  read_surface(member(root, "surface"), net);
}

Net read_net(const Json& root) {
  Words words;
  return read_net(root, words);
}

namespace {

/// The net of a claim: without collars.
Net read_whole_net(const Json& root, Words& words, const char* name = "net") {
  const Json& net = member(root, name);
  if (net.kind == Json::Kind::object && find(net, "collars") != nullptr) throw Malformed("a pseudo net");
  return read_net(net, words);
}

Net read_one_vertex_net(const Json& root, Words& words) {
  Net result = read_whole_net(root, words);
  if (result.vertices.size() != 1) throw Malformed("a net of another number of vertices than one");
  return result;
}

bool read_bool(const Json& value) {
  const bool is_true = value.kind == Json::Kind::literal && value.text == "true";
  if (!is_true && (value.kind != Json::Kind::literal || value.text != "false")) {
    throw Malformed("expected true or false");
  }
  return is_true;
}

/// What a list of geodesics has, whatever else is in the file.
GeodesicsDocument read_list(const Json& root, GeodesicsDocument::Claim claim, Words& words) {
  GeodesicsDocument document{.claim = claim, .net = read_whole_net(root, words)};
  for (const Json& row : array(member(root, "geodesics"), "geodesics")) {
    expect_members(row, {"vertex", "word", "length", "simple"});
    document.geodesics.push_back({to_index(member(row, "vertex")), words.read(member(row, "word")),
                                  read_length(member(row, "length"), "a length"), read_bool(member(row, "simple"))});
  }
  if (claim == GeodesicsDocument::Claim::systole) return document;
  if (document.has_up_to()) document.up_to = to_decimal(member(root, "up_to"));
  for (const Json& row : array(member(root, "clusters"), "clusters")) {
    expect_members(row, {"first", "count", "equal"});
    document.clusters.push_back(
        {to_index(member(row, "first")), to_index(member(row, "count")), read_bool(member(row, "equal"))});
  }
  return document;
}

std::vector<Piece> read_pieces(const Json& value) {
  std::vector<Piece> pieces;
  for (const Json& row : array(value, "pieces")) {
    expect_members(row, {"genus", "boundaries"});
    Piece piece{.genus = to_index(member(row, "genus")), .boundaries = {}};
    for (const Json& boundary : array(member(row, "boundaries"), "boundaries")) {
      const auto& pair = tuple(boundary, 2, "a boundary");
      piece.boundaries.push_back({to_index(pair[0]), to_index(pair[1])});
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

Coefficients read_coefficients(const Json& function) {
  Coefficients coefficients;
  for (const Json& value : array(function, "a function")) coefficients.push_back(read_binary64(value));
  return coefficients;
}

std::vector<std::vector<Index>> read_words(const Json& root, const char* name, Words& words) {
  std::vector<std::vector<Index>> result;
  for (const Json& word : array(member(root, name), name)) result.push_back(words.read(word));
  return result;
}

/// A few digits, so that all together are not much work.
mpq_class read_phase(const Json& value) {
  if (value.text.size() > 40 || value.text.find_first_of("eE") != std::string::npos)
    throw Malformed("phases: expected at most 40 characters without an exponent");
  return to_decimal(value);
}

/// lower <= upper, of any sign.
Range read_range(const Json& value, const char* what) {
  const auto& two = tuple(value, 2, what);
  Range range{read_binary64(two[0]), read_binary64(two[1])};
  if (range[1] < range[0]) throw Malformed(std::string(what) + ": expected lo <= hi");
  return range;
}

EigenvaluesDocument::Box read_box(const Json& value) {
  expect_members(value, {"radius", "directions"});
  EigenvaluesDocument::Box box{to_decimal(member(value, "radius")), {}};
  for (const Json& row : array(member(value, "directions"), "directions")) {
    expect_members(row, {"steps", "heights"});
    EigenvaluesDocument::Direction& direction = box.directions.emplace_back();
    for (const Json& step : array(member(row, "steps"), "steps")) direction.steps.push_back(to_small_integer(step));
    for (const Json& height : array(member(row, "heights"), "heights"))
      direction.heights.push_back(read_binary64(height));
  }
  return box;
}

PantsDocument::End read_end(const Json& value) {
  const auto& two = tuple(value, 2, "an end");
  return {to_index(two[0]), to_index(two[1])};
}

PantsDocument::Cuff read_cuff(const Json& row, Words& words) {
  expect_members(row, {"ends", "across", "length", "twist", "exp_half_length"});
  const auto& ends = tuple(member(row, "ends"), 2, "ends");
  return {.ends = {read_end(ends[0]), read_end(ends[1])},
          .across = words.read(member(row, "across")),
          .length = read_length(member(row, "length"), "a length"),
          .twist = read_range(member(row, "twist"), "a twist"),
          .exp_half_length = to_rational(member(row, "exp_half_length"))};
}

mpz_class read_number(const Json& value) {
  mpz_class result = to_small_integer(value);
  if (result < 0) throw Malformed("expected an integer that is not negative");
  return result;
}

CurvesDocument::Curve read_curve(const Json& row, Words& words) {
  expect_members(row, {"vertex", "word", "length", "power", "self_intersections", "homology"});
  CurvesDocument::Curve curve{.vertex = to_index(member(row, "vertex")),
                              .word = words.read(member(row, "word")),
                              .length = read_length(member(row, "length"), "a length"),
                              .power = to_index(member(row, "power")),
                              .self_intersections = read_number(member(row, "self_intersections")),
                              .homology = {}};
  for (const Json& coefficient : array(member(row, "homology"), "homology"))
    curve.homology.push_back(to_small_integer(coefficient));
  return curve;
}

}  // namespace

DistanceDocument read_distance(const Json& root) {
  expect_members(root, {"format", "version", "net", "point", "distance", "paths", "equal"});
  expect_version(root);
  Words words;
  Net net = read_one_vertex_net(root, words);
  const auto& point = tuple(member(root, "point"), 3, "the point");
  DistanceDocument document{.net = std::move(net),
                            .tile = to_index(point[0]),
                            .point = read_rational_point(point[1], point[2]),
                            .distance = read_length(member(root, "distance"), "the distance"),
                            .paths = {},
                            .equal = false};
  for (const Json& word : array(member(root, "paths"), "paths")) document.paths.push_back(words.read(word));
  document.equal = read_bool(member(root, "equal"));
  return document;
}

namespace {

IsometryRows read_isometry_rows(const Json& value, Words& words) {
  IsometryRows rows{
      .isometries = {}, .paths = read_words(value, "paths", words), .pair = read_words(value, "pair", words)};
  for (const Json& row : array(member(value, "isometries"), "isometries")) {
    expect_members(row, {"preserves_orientation", "images"});
    rows.isometries.push_back({read_bool(member(row, "preserves_orientation")), read_words(row, "images", words)});
  }
  return rows;
}

}  // namespace

BoundDocument read_bound(const Json& root) {
  expect_members(root, {"format", "version", "claim", "net", "value", "triangulations", "base", "symmetry", "cells"});
  expect_version(root);
  Words words;
  BoundDocument document{.net = read_one_vertex_net(root, words),
                         .claim = BoundDocument::Claim::diameter,
                         .value = read_length(member(root, "value"), "the value"),
                         .triangulations = {},
                         .base = {},
                         .symmetry = {},
                         .cells = {}};
  const Json& claim = member(root, "claim");
  if (is_text(claim, "radius")) {
    document.claim = BoundDocument::Claim::radius;
  } else if (is_text(claim, "embedded-disk")) {
    document.claim = BoundDocument::Claim::embedded_disk;
  } else {
    expect_text(claim, "diameter", "the claim");
  }
  for (const Json& row : array(member(root, "triangulations"), "triangulations")) {
    std::vector<Index> flips = read_indices(row, "a triangulation");
    if (flips.empty()) throw Malformed("a triangulation: expected the number of another one");
    const Index parent = flips.front();
    flips.erase(flips.begin());
    document.triangulations.push_back({parent, std::move(flips)});
  }
  if (const Json* base = find(root, "base")) document.base = read_indices(*base, "base");
  if (const Json* symmetry = find(root, "symmetry")) {
    expect_members(*symmetry, {"centre", "isometries", "paths", "pair"});
    const auto& centre = tuple(member(*symmetry, "centre"), 2, "the centre");
    document.symmetry = {read_binary_point(centre[0], centre[1]), read_isometry_rows(*symmetry, words)};
  }
  for (const Json& row : array(member(root, "cells"), "cells")) document.cells.push_back(read_indices(row, "cells"));
  return document;
}

namespace {

GeodesicsDocument read_geodesics(const Json& root, Words& words) {
  using enum GeodesicsDocument::Claim;
  expect_version(root);
  const Json& claim = member(root, "claim");
  if (is_text(claim, "spectrum")) {
    expect_members(root, {"format", "version", "claim", "net", "up_to", "geodesics", "clusters"});
    return read_list(root, spectrum, words);
  }
  if (is_text(claim, "local-maximum")) {
    expect_members(root, {"format", "version", "claim", "net", "up_to", "geodesics", "clusters", "basis", "weights"});
    GeodesicsDocument document = read_list(root, local_maximum, words);
    document.basis = read_indices(member(root, "basis"), "basis");
    document.weights = read_indices(member(root, "weights"), "weights");
    return document;
  }
  if (is_text(claim, "thick-thin")) {
    expect_members(root, {"format", "version", "claim", "net", "geodesics", "clusters", "pieces"});
    GeodesicsDocument document = read_list(root, thick_thin, words);
    document.pieces = read_pieces(member(root, "pieces"));
    return document;
  }
  expect_text(claim, "systole", "the claim");
  expect_members(root, {"format", "version", "claim", "net", "geodesics"});
  return read_list(root, systole, words);
}

}  // namespace

GeodesicsDocument read_geodesics(const Json& root) {
  Words words;
  return read_geodesics(root, words);
}

EigenvaluesDocument read_eigenvalues(const Json& root) {
  expect_members(root, {"format", "version", "net", "phases", "box", "eigenvalues", "next", "halvings", "side_order",
                        "vertex_order", "at_most", "at_least", "eigenfunctions"});
  expect_version(root);
  Words words;
  EigenvaluesDocument document{.net = read_whole_net(root, words),
                               .phases = {},
                               .box = {},
                               .eigenvalues = {},
                               .next = read_binary64(member(root, "next")),
                               .halvings = to_index(member(root, "halvings")),
                               .side_order = read_indices(member(root, "side_order"), "side_order"),
                               .vertex_order = read_indices(member(root, "vertex_order"), "vertex_order"),
                               .at_most = {},
                               .at_least = {},
                               .eigenfunctions = {}};
  if (const Json* phases = find(root, "phases")) {
    for (const Json& phase : array(*phases, "phases")) document.phases.push_back(read_phase(phase));
  }
  if (const Json* box = find(root, "box")) document.box = read_box(*box);
  for (const Json& row : array(member(root, "eigenvalues"), "eigenvalues")) {
    expect_members(row, {"in", "count"});
    document.eigenvalues.push_back({read_length(member(row, "in"), "in"), to_index(member(row, "count"))});
  }
  for (const Json& row : array(member(root, "at_most"), "at_most")) {
    expect_members(row, {"below", "count", "sigma"});
    document.at_most.push_back(
        {read_binary64(member(row, "below")), to_index(member(row, "count")), read_binary64(member(row, "sigma"))});
  }
  for (const Json& row : array(member(root, "at_least"), "at_least")) {
    expect_members(row, {"below", "count"});
    document.at_least.push_back({read_binary64(member(row, "below")), to_index(member(row, "count"))});
  }
  for (const Json& row : array(member(root, "eigenfunctions"), "eigenfunctions")) {
    expect_members(row, {"in", "lambda", "radius", "functions"});
    document.eigenfunctions.push_back({read_length(member(row, "in"), "in"),
                                       read_binary64(member(row, "lambda")),
                                       read_binary64(member(row, "radius")),
                                       {}});
    for (const Json& function : array(member(row, "functions"), "functions"))
      document.eigenfunctions.back().functions.push_back(read_coefficients(function));
  }
  return document;
}

IsometriesDocument read_isometries(const Json& root) {
  expect_members(root, {"format", "version", "net", "up_to", "geodesics", "clusters", "order", "isometries", "paths",
                        "pair", "cocycle"});
  expect_version(root);
  Words words;
  IsometriesDocument document{.spectrum = read_list(root, GeodesicsDocument::Claim::spectrum, words),
                              .order = to_index(member(root, "order")),
                              .rows = read_isometry_rows(root, words),
                              .cocycle = read_indices(member(root, "cocycle"), "the cocycle")};
  return document;
}

ComparisonDocument read_comparison(const Json& root) {
  using enum ComparisonDocument::Claim;
  expect_version(root);
  Words words;
  const Json& claim = member(root, "claim");
  const auto net_alone = [&](const char* name) {
    return GeodesicsDocument{.claim = GeodesicsDocument::Claim::spectrum, .net = read_whole_net(root, words, name)};
  };
  if (is_text(claim, "isometric")) {
    expect_members(
        root, {"format", "version", "claim", "net", "other_net", "preserves_orientation", "paths", "pair", "images"});
    return {.claim = isometric,
            .first = net_alone("net"),
            .other = net_alone("other_net"),
            .preserves_orientation = read_bool(member(root, "preserves_orientation")),
            .paths = read_words(root, "paths", words),
            .pair = read_words(root, "pair", words),
            .images = read_words(root, "images", words)};
  }
  expect_text(claim, "different", "the claim");
  expect_members(root, {"format", "version", "claim", "net", "up_to", "geodesics", "clusters", "other_spectrum"});
  const Json& other = member(root, "other_spectrum");
  if (other.kind != Json::Kind::object) throw Malformed("expected an object");
  expect_text(member(other, "format"), "epsnet-geodesics", "the format of the other spectrum");
  expect_text(member(other, "claim"), "spectrum", "the claim of the other spectrum");
  return {.claim = different,
          .first = read_list(root, GeodesicsDocument::Claim::spectrum, words),
          .other = read_geodesics(other, words),
          .paths = {},
          .pair = {},
          .images = {}};
}

PantsDocument read_pants(const Json& root) {
  expect_members(root, {"format", "version", "net", "pants", "cuffs"});
  expect_version(root);
  Words words;
  PantsDocument document{.net = read_whole_net(root, words), .pants = {}, .cuffs = {}};
  for (const Json& row : array(member(root, "pants"), "pants")) {
    const auto& two = tuple(row, 2, "a pair of pants");
    document.pants.push_back({words.read(two[0]), words.read(two[1])});
  }
  for (const Json& row : array(member(root, "cuffs"), "cuffs")) document.cuffs.push_back(read_cuff(row, words));
  return document;
}

CurvesDocument read_curves(const Json& root) {
  expect_members(root, {"format", "version", "net", "curves", "pairs", "basis", "filling"});
  expect_version(root);
  Words words;
  CurvesDocument document{.net = read_whole_net(root, words),
                          .curves = {},
                          .pairs = {},
                          .basis = read_indices(member(root, "basis"), "the basis"),
                          .filling = {}};
  for (const Json& row : array(member(root, "curves"), "curves")) document.curves.push_back(read_curve(row, words));
  for (const Json& row : array(member(root, "pairs"), "pairs")) {
    expect_members(row, {"first", "second", "intersections", "algebraic"});
    document.pairs.push_back({to_index(member(row, "first")), to_index(member(row, "second")),
                              read_number(member(row, "intersections")), to_small_integer(member(row, "algebraic"))});
  }
  for (const Json& set : array(member(root, "filling"), "filling"))
    document.filling.push_back(read_indices(set, "a set of curves"));
  return document;
}

}  // namespace epsnet::exact
