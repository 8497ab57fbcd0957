#include "certify/net/structure.h"

#include <algorithm>

#include "certify/base/text.h"
#include "certify/claims/geodesics/check.h"

namespace epsnet::certify {
namespace {

Problem geodesics_problem(const GeodesicsDocument& document) {
  const SurfaceSides sides(document.net.surface);
  const auto& rows = document.geodesics;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].vertex >= document.net.vertices.size()) {
      return at("geodesics", i) + "vertex " + std::to_string(rows[i].vertex) + " does not exist";
    }
    const auto& [vertex, word, length, simple] = rows[i];
    const std::uint32_t tile = document.net.charts[document.net.vertices[vertex].chart].tile;
    if (const auto problem = word_problem(sides, word, tile, tile, "vertex " + std::to_string(vertex))) {
      return at("geodesics", i) + *problem;
    }
    if (!is_length(length) || length.lower == 0) {
      return at("geodesics", i) + "the length " + to_string(length) + " is not 0 < lo <= hi";
    }
    if (i > 0 && rows[i].length.lower < rows[i - 1].length.lower) {
      return at("geodesics", i) + "lo is less than that of the element before";
    }
  }
  return std::nullopt;
}

Problem systole_problem(const GeodesicsDocument& document) {
  if (!document.clusters.empty() || !document.pieces.empty() || !document.up_to.empty()) {
    return "claim: a systole has neither up_to nor clusters nor pieces";
  }
  if (document.geodesics.size() != 1) {
    return "geodesics: " + std::to_string(document.geodesics.size()) + " elements, expected one, a systole";
  }
  const Interval length = document.geodesics[0].length;
  if (length.upper / 2 < length.lower) return std::nullopt;
  return "geodesics[0]: the length is not enclosed, expected hi < 2 lo";
}

Problem up_to_problem(const GeodesicsDocument& document) {
  if (document.claim != GeodesicsDocument::Claim::spectrum) {
    if (document.up_to.empty()) return std::nullopt;
    return "up_to: only a spectrum has it";
  }
  const auto up_to = parse_decimal(document.up_to);
  if (!up_to) return "up_to: " + in_quotes(document.up_to) + " is not a decimal, such as \"2.5\"";
  if (*up_to <= 0) return "up_to: " + in_quotes(document.up_to) + " is not positive";
  return std::nullopt;
}

/// The runs that the enclosures make, of which only `equal` is free.
std::vector<GeodesicsDocument::Cluster> runs(const std::vector<GeodesicsDocument::ClosedGeodesic>& geodesics) {
  std::vector<GeodesicsDocument::Cluster> result;
  double end = 0;
  for (std::uint32_t i = 0; i < geodesics.size(); ++i) {
    const Interval length = geodesics[i].length;
    if (result.empty() || length.lower > end) result.push_back({i, 0, false});
    ++result.back().count;
    end = std::max(end, length.upper);
  }
  return result;
}

Problem clusters_problem(const GeodesicsDocument& document) {
  const std::vector<GeodesicsDocument::Cluster> expected = runs(document.geodesics);
  const auto& rows = document.clusters;
  for (std::size_t i = 0; i < std::max(rows.size(), expected.size()); ++i) {
    if (i < rows.size() && i < expected.size() && rows[i].first == expected[i].first &&
        rows[i].count == expected[i].count) {
      continue;
    }
    return at("clusters", i) + "is not the run that the lengths make, expected " +
           (i < expected.size()
                ? "the " + std::to_string(expected[i].count) + " elements from " + std::to_string(expected[i].first)
                : "no more");
  }
  return std::nullopt;
}

Problem pieces_problem(const GeodesicsDocument& document) {
  if (document.claim != GeodesicsDocument::Claim::thick_thin) {
    if (document.pieces.empty()) return std::nullopt;
    return "pieces: only a thick-thin decomposition has them";
  }
  std::vector<bool> used(2 * document.geodesics.size());
  std::size_t sides = 0;
  for (std::size_t row = 0; row < document.pieces.size(); ++row) {
    for (const auto& [geodesic, side] : document.pieces[row].boundaries) {
      if (geodesic >= document.geodesics.size() || side > 1) {
        return at("pieces", row) + "side " + std::to_string(side) + " of geodesic " + std::to_string(geodesic) +
               " does not exist";
      }
      if (used[2 * std::size_t{geodesic} + side]) {
        return at("pieces", row) + "side " + std::to_string(side) + " of geodesic " + std::to_string(geodesic) +
               " occurs twice";
      }
      used[2 * std::size_t{geodesic} + side] = true;
      ++sides;
    }
  }
  if (sides == used.size()) return std::nullopt;
  return "pieces: " + std::to_string(sides) + " of " + std::to_string(used.size()) + " sides of geodesics occur";
}

}  // namespace

Problem structure_problem(const GeodesicsDocument& document) {
  // The search relies on vertices near every point of the surface.
  if (auto problem = whole_net_problem(document.net)) return problem;
  if (auto problem = geodesics_problem(document)) return problem;
  if (document.claim == GeodesicsDocument::Claim::systole) return systole_problem(document);
  if (auto problem = up_to_problem(document)) return problem;
  if (auto problem = clusters_problem(document)) return problem;
  return pieces_problem(document);
}

std::uint64_t least_bytes(const GeodesicsDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + document.up_to.size();
  for (const GeodesicsDocument::ClosedGeodesic& row : document.geodesics) bytes += 52 + least_bytes(row.word);
  bytes += 34 * document.clusters.size();
  for (const GeodesicsDocument::Piece& piece : document.pieces) bytes += 26 + 6 * piece.boundaries.size();
  return bytes;
}

}  // namespace epsnet::certify
