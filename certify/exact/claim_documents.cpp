#include "certify/exact/claim_documents.h"

#include <string>
#include <utility>

namespace epsnet::exact {
namespace {

/// The net of a claim: without collars.
Net read_whole_net(const Json& root, Words& words) {
  const Json& net = member(root, "net");
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
  GeodesicsDocument document{
      .claim = claim, .net = read_whole_net(root, words), .up_to = {}, .geodesics = {}, .clusters = {}, .pieces = {}};
  for (const Json& row : array(member(root, "geodesics"), "geodesics")) {
    expect_members(row, {"vertex", "word", "length", "simple"});
    document.geodesics.push_back({to_index(member(row, "vertex")), words.read(member(row, "word")),
                                  read_length(member(row, "length"), "a length"), read_bool(member(row, "simple"))});
  }
  if (claim == GeodesicsDocument::Claim::systole) return document;
  if (claim == GeodesicsDocument::Claim::spectrum) document.up_to = to_decimal(member(root, "up_to"));
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

/// lower <= upper, of any sign.
Range read_range(const Json& value, const char* what) {
  const auto& two = tuple(value, 2, what);
  Range range{read_binary64(two[0]), read_binary64(two[1])};
  if (range[1] < range[0]) throw Malformed(std::string(what) + ": expected lo <= hi");
  return range;
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

BoundDocument read_bound(const Json& root) {
  expect_members(root, {"format", "version", "claim", "net", "value", "triangulations", "base", "cells"});
  expect_version(root);
  Words words;
  BoundDocument document{.net = read_one_vertex_net(root, words),
                         .claim = BoundDocument::Claim::diameter,
                         .value = read_length(member(root, "value"), "the value"),
                         .triangulations = {},
                         .base = {},
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
  for (const Json& row : array(member(root, "cells"), "cells")) document.cells.push_back(read_indices(row, "cells"));
  return document;
}

GeodesicsDocument read_geodesics(const Json& root) {
  using enum GeodesicsDocument::Claim;
  expect_version(root);
  Words words;
  const Json& claim = member(root, "claim");
  if (is_text(claim, "spectrum")) {
    expect_members(root, {"format", "version", "claim", "net", "up_to", "geodesics", "clusters"});
    return read_list(root, spectrum, words);
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

EigenvaluesDocument read_eigenvalues(const Json& root) {
  expect_members(root, {"format", "version", "net", "eigenvalues", "next", "halvings", "side_order", "vertex_order",
                        "at_most", "at_least", "eigenfunctions"});
  expect_version(root);
  Words words;
  EigenvaluesDocument document{.net = read_whole_net(root, words),
                               .eigenvalues = {},
                               .next = read_binary64(member(root, "next")),
                               .halvings = to_index(member(root, "halvings")),
                               .side_order = read_indices(member(root, "side_order"), "side_order"),
                               .vertex_order = read_indices(member(root, "vertex_order"), "vertex_order"),
                               .at_most = {},
                               .at_least = {},
                               .eigenfunctions = {}};
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
                              .isometries = {},
                              .paths = read_words(root, "paths", words),
                              .pair = read_words(root, "pair", words),
                              .cocycle = read_indices(member(root, "cocycle"), "the cocycle")};
  for (const Json& row : array(member(root, "isometries"), "isometries")) {
    expect_members(row, {"preserves_orientation", "images"});
    document.isometries.push_back({read_bool(member(row, "preserves_orientation")), read_words(row, "images", words)});
  }
  return document;
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

}  // namespace epsnet::exact
