#include "certify/net/structure.h"

#include <limits>

#include "certify/claims/bound/check.h"

namespace epsnet::certify {
namespace {

Problem triangulations_problem(const BoundDocument& document) {
  const std::size_t darts = 3 * document.net.triangles.size();
  for (std::size_t k = 0; k < document.triangulations.size(); ++k) {
    const BoundDocument::Triangulation& row = document.triangulations[k];
    if (row.parent > k) {
      return at("triangulations", k) + "is made from number " + std::to_string(row.parent) +
             ", expected one before its own, " + std::to_string(k + 1);
    }
    for (const std::uint32_t dart : row.flips) {
      if (dart >= darts) return at("triangulations", k) + "dart " + std::to_string(dart) + " does not exist";
    }
  }
  return std::nullopt;
}

/// Counts the triangles of the base.
Problem base_problem(const BoundDocument& document, std::uint64_t& triangles) {
  triangles = document.net.triangles.size();
  for (std::size_t k = 0; k < document.base.size(); ++k) {
    const std::uint32_t dart = document.base[k] / 2;
    if (dart >= 3 * triangles) return at("base", k) + "dart " + std::to_string(dart) + " does not exist";
    if (document.base[k] % 2 != 0) triangles += 2;
  }
  if (3 * triangles > std::numeric_limits<std::uint32_t>::max()) return "base: more than 2^32 darts";
  return std::nullopt;
}

Problem cells_problem(const BoundDocument& document) {
  std::uint64_t in_base = 0;
  if (auto problem = base_problem(document, in_base)) return problem;
  if (document.cells.size() != in_base) {
    return "cells: " + std::to_string(document.cells.size()) + " elements, expected one for each of the " +
           std::to_string(in_base) + " triangles";
  }
  const std::uint64_t triangles = document.net.triangles.size();
  const std::uint64_t of_each = document.claim == BoundDocument::Claim::diameter ? 1
                                : document.claim == BoundDocument::Claim::radius ? 3
                                                                                 : 3 * triangles;
  const std::uint64_t bounds = (document.triangulations.size() + 1) * of_each;
  return first_row_problem("cells", document.cells, [&](const std::vector<std::uint32_t>& row) -> Problem {
    std::size_t open = 1;
    for (const std::uint32_t entry : row) {
      if (open == 0) return "more numbers than the subdivision has";
      if (entry >= 3 && entry - 3 >= bounds) return std::to_string(entry) + " names nothing that bounds a cell";
      open = entry < 3 ? open + 1 : open - 1;
    }
    if (open == 0) return std::nullopt;
    return "the subdivision ends early, " + std::to_string(open) + " cells are missing";
  });
}

}  // namespace

Problem structure_problem(const BoundDocument& document) {
  if (auto problem = one_vertex_problem(document.net)) return problem;
  if (!is_length(document.value) || document.value.lower == 0) {
    return "value: " + to_string(document.value) + " is not 0 < lo <= hi";
  }
  if (auto problem = triangulations_problem(document)) return problem;
  return cells_problem(document);
}

std::uint64_t least_bytes(const BoundDocument& document) {
  std::uint64_t bytes = least_bytes(document.net) + least_bytes(document.base);
  for (const BoundDocument::Triangulation& row : document.triangulations) bytes += 4 + least_bytes(row.flips);
  for (const std::vector<std::uint32_t>& row : document.cells) bytes += 2 + least_bytes(row);
  return bytes;
}

}  // namespace epsnet::certify
