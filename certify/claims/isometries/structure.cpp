#include "certify/net/structure.h"

#include "certify/base/text.h"
#include "certify/claims/geodesics/fields.h"
#include "certify/claims/isometries/check.h"
#include "certify/claims/isometries/orbit.h"

namespace epsnet::certify {
namespace {

using Document = IsometriesDocument;

/// What is wrong with some words from tile 0 to itself, of which there should be so many.
Problem loops_problem(const SurfaceSides& sides, const std::vector<Document::Word>& words, std::size_t count) {
  if (words.size() != count) {
    return std::to_string(words.size()) + " words, expected " + std::to_string(count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto problem = word_problem(sides, words[i], 0, 0, "its start")) {
      return "word " + std::to_string(i) + ": " + *problem;
    }
  }
  return std::nullopt;
}

Problem cocycle_problem(const SurfaceSides& sides, const Document& document) {
  if (document.cocycle.size() != sides.partner.size() / 2) {
    return "cocycle: " + std::to_string(document.cocycle.size()) + " numbers, expected one for each pair of sides, " +
           std::to_string(sides.partner.size() / 2);
  }
  const std::vector<std::uint32_t> value = cocycle_by_side(sides, document.cocycle);
  for (const std::uint32_t first : sides.vertices()) {
    std::uint32_t sum = 0;
    std::uint32_t s = first;
    do {
      sum += value[s];
      s = sides.next_around(s);
    } while (s != first);
    if (sum != 0) {
      return "cocycle: the sum around the vertex where side " + std::to_string(first) + " starts is " +
             std::to_string(sum) + ", expected 0 modulo 2^32";
    }
  }
  return std::nullopt;
}

}  // namespace

Problem structure_problem(const Document& document) {
  if (document.claim != GeodesicsDocument::Claim::spectrum) return "claim: expected a spectrum";
  if (auto problem = structure_problem(static_cast<const GeodesicsDocument&>(document))) return problem;
  const SurfaceSides sides(document.net.surface);
  if (document.order == 0) return "order: 0, expected at least 1";
  if (document.paths.size() != sides.first.size()) {
    return "paths: " + std::to_string(document.paths.size()) + " words, expected one for each tile, " +
           std::to_string(sides.first.size());
  }
  for (std::uint32_t t = 0; t < document.paths.size(); ++t) {
    if (const auto problem = word_problem(sides, document.paths[t], 0, t, "this row")) return at("paths", t) + *problem;
  }
  if (const auto problem = loops_problem(sides, document.pair, 2)) return "pair: " + *problem;
  const std::size_t images = 2 + sides.partner.size() / 2;
  const auto problem = first_row_problem("isometries", document.isometries, [&](const Document::Isometry& isometry) {
    return loops_problem(sides, isometry.images, images);
  });
  return problem ? problem : cocycle_problem(sides, document);
}

std::uint64_t least_bytes(const Document& document) {
  std::uint64_t bytes = least_bytes(static_cast<const GeodesicsDocument&>(document)) + least_bytes(document.cocycle);
  for (const auto* words : {&document.paths, &document.pair}) {
    for (const Document::Word& word : *words) bytes += 3 + least_bytes(word);
  }
  for (const Document::Isometry& isometry : document.isometries) {
    for (const Document::Word& word : isometry.images) bytes += 3 + least_bytes(word);
  }
  return bytes;
}

}  // namespace epsnet::certify
