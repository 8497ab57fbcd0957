#include "certify/net/structure.h"

#include <cmath>

#include "certify/claims/pants/check.h"

namespace epsnet::certify {
namespace {

/// What is wrong with the paths of a pair of pants.
Problem paths_problem(const SurfaceSides& sides, const PantsDocument::Paths& paths) {
  if (paths[0].empty()) return "the first path has no letters";
  if (paths[0][0] >= sides.tile.size()) return "side " + std::to_string(paths[0][0]) + " does not exist";
  const std::uint32_t tile = sides.tile[paths[0][0]];
  for (const PantsDocument::Word& path : paths) {
    if (auto problem = word_problem(sides, path, tile, tile, "its start")) return problem;
  }
  return std::nullopt;
}

Problem cuff_problem(const PantsDocument& document, const SurfaceSides& sides, const PantsDocument::Cuff& cuff,
                     std::vector<bool>& seen) {
  for (const auto& [p, k] : cuff.ends) {
    const std::string name = "cuff " + std::to_string(k) + " of pair of pants " + std::to_string(p);
    if (p >= document.pants.size() || k > 2) return name + " does not exist";
    if (seen[3 * p + k]) return name + " occurs twice";
    seen[3 * p + k] = true;
  }
  const auto tile = [&](const PantsDocument::End& end) { return sides.tile[document.pants[end[0]][0][0]]; };
  if (auto problem = word_problem(sides, cuff.across, tile(cuff.ends[0]), tile(cuff.ends[1]), "the second end")) {
    return "across: " + *problem;
  }
  if (!is_length(cuff.length) || cuff.length.lower == 0) {
    return "length: " + to_string(cuff.length) + " is not 0 < lo <= hi";
  }
  const bool finite = std::isfinite(cuff.twist.lower) && std::isfinite(cuff.twist.upper);
  if (!finite || cuff.twist.lower > cuff.twist.upper) return "twist: " + to_string(cuff.twist) + " is not lo <= hi";
  if (cuff.exp_half_length != 0 && cuff.exp_half_length <= 1) {
    return "exp_half_length: " + cuff.exp_half_length.get_str() + ", expected 0 or more than 1";
  }
  return std::nullopt;
}

}  // namespace

Problem structure_problem(const PantsDocument& document) {
  if (auto problem = whole_net_problem(document.net)) return problem;
  const SurfaceSides sides(document.net.surface);
  if (auto problem = first_row_problem(
          "pants", document.pants, [&](const PantsDocument::Paths& paths) { return paths_problem(sides, paths); })) {
    return problem;
  }
  if (2 * document.cuffs.size() != 3 * document.pants.size()) {
    return "cuffs: " + std::to_string(document.cuffs.size()) + " rows for " + std::to_string(document.pants.size()) +
           " pairs of pants, expected three for two";
  }
  std::vector<bool> seen(3 * document.pants.size());
  return first_row_problem("cuffs", document.cuffs,
                           [&](const PantsDocument::Cuff& cuff) { return cuff_problem(document, sides, cuff, seen); });
}

std::uint64_t least_bytes(const PantsDocument& document) {
  std::uint64_t bytes = least_bytes(document.net);
  for (const auto& [first, second] : document.pants) bytes += 6 + least_bytes(first) + least_bytes(second);
  for (const PantsDocument::Cuff& cuff : document.cuffs) {
    bytes += 90 + least_bytes(cuff.across) + least_bytes(RationalPoint{cuff.exp_half_length, 0});
  }
  return bytes;
}

}  // namespace epsnet::certify
