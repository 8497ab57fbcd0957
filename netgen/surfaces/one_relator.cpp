#include "netgen/surfaces/one_relator.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace epsnet {
namespace {

/// The cyclic word from just behind a place to just before it.
SidesOfPolygon rest(const SidesOfPolygon& word, std::size_t place) {
  SidesOfPolygon result(word.begin() + static_cast<std::ptrdiff_t>(place) + 1, word.end());
  result.insert(result.end(), word.begin(), word.begin() + static_cast<std::ptrdiff_t>(place));
  return result;
}

std::size_t place_of(const SidesOfPolygon& word, std::uint32_t letter) {
  return static_cast<std::size_t>(std::find(word.begin(), word.end(), letter) - word.begin());
}

}  // namespace

SidesOfPolygon inverse_of(const PolygonSides& polygon, SidesOfPolygon word) {
  std::reverse(word.begin(), word.end());
  for (std::uint32_t& k : word) k = polygon.partner[k];
  return word;
}

OneRelator::OneRelator(const PolygonSides& polygon) {
  std::vector<SidesOfPolygon> relations = polygon.relations;
  std::vector<std::size_t> relation_of(polygon.side.size());
  for (std::size_t r = 0; r < relations.size(); ++r) {
    for (const std::uint32_t k : relations[r]) relation_of[k] = r;
  }
  for (std::uint32_t k = 0; k < polygon.side.size(); ++k) {
    const std::size_t r = relation_of[k];
    const std::size_t other = relation_of[polygon.partner[k]];
    if (r == other) continue;
    // k P = 1 in one and k⁻¹ Q = 1 in the other: k = P⁻¹, and P Q = 1 is left.
    SidesOfPolygon merged = rest(relations[r], place_of(relations[r], k));
    expressed.push_back({k, inverse_of(polygon, merged)});
    const SidesOfPolygon q = rest(relations[other], place_of(relations[other], polygon.partner[k]));
    merged.insert(merged.end(), q.begin(), q.end());
    relations[other].clear();
    for (const std::uint32_t letter : merged) relation_of[letter] = r;
    relations[r] = std::move(merged);
    relation_of[k] = relation_of[polygon.partner[k]] = r;
  }
  relation = *std::find_if(relations.begin(), relations.end(), [](const auto& word) { return !word.empty(); });
}

}  // namespace epsnet
