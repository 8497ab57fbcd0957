#include "certify/claims/isometries/orbit.h"

#include <numeric>
#include <set>

namespace epsnet::certify {
namespace {

/// Of a function of words, by generator; modulo 2³².
using Values = std::vector<std::uint32_t>;

}  // namespace

std::vector<std::uint32_t> cocycle_by_side(const SurfaceSides& sides, const std::vector<std::uint32_t>& values) {
  std::vector<std::uint32_t> result(sides.partner.size());
  auto value = values.begin();
  for (std::uint32_t s = 0; s < result.size(); ++s) {
    const std::uint32_t partner = sides.partner[s];
    result[s] = s < partner ? *value++ : 0 - result[partner];
  }
  return result;
}

std::uint64_t orbit_size(const SurfaceSides& sides, const IsometriesDocument& document, const Budget& budget) {
  std::uint64_t letters = document.cocycle.size();
  for (const auto& isometry : document.isometries) {
    for (const auto& word : isometry.images) letters += word.size() + 1;
  }
  const auto sum = [](const Values& by_side, const IsometriesDocument::Word& word) {
    return std::accumulate(word.begin(), word.end(), std::uint32_t{0},
                           [&](std::uint32_t value, std::uint32_t s) { return value + by_side[s]; });
  };
  // Of g_s, of which the path is closed.
  Values first;
  const Values by_side = cocycle_by_side(sides, document.cocycle);
  for (std::uint32_t s = 0; s < by_side.size(); ++s) {
    if (s > sides.partner[s]) continue;
    first.push_back(sum(by_side, document.paths[sides.tile[s]]) + by_side[s] -
                    sum(by_side, document.paths[sides.tile[sides.partner[s]]]));
  }
  std::set<Values> known{first};
  std::vector<const Values*> reached{&*known.begin()};
  for (std::size_t i = 0; i < reached.size() && known.size() <= document.order; ++i) {
    budget.spend(5, letters);
    const Values here = cocycle_by_side(sides, *reached[i]);
    for (const auto& isometry : document.isometries) {
      Values moved;
      for (auto word = isometry.images.begin() + 2; word != isometry.images.end(); ++word) {
        moved.push_back(sum(here, *word));
      }
      budget.spend(memory_work(4 * moved.size() + 64));
      const auto [place, is_new] = known.insert(std::move(moved));
      if (is_new) reached.push_back(&*place);
    }
  }
  return known.size();
}

}  // namespace epsnet::certify
