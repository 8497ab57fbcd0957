#include <sstream>
#include <vector>

#include "netgen/surfaces/coset_enumeration.h"
#include "netgen/surfaces/regular_map_table.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet {

std::span<const RegularMap> regular_maps() { return kRegularMaps; }

std::uint32_t rotations(const RegularMap& map) {
  // n/p faces, n/2 edges, n/q vertices.
  const auto [p, q] = map.type;
  return (4 * map.genus - 4) * p * q / (p * q - 2 * p - 2 * q);
}

bool is_reflexible(const RegularMap& map) { return map.name.starts_with('R'); }

std::string description(const RegularMap& map) {
  std::ostringstream out;
  out << (is_reflexible(map) ? "A regular map {" : "A chiral map {") << map.type.p << ", " << map.type.q
      << "} of genus " << map.genus << " with " << rotations(map) << " rotations"
      << (is_reflexible(map) ? " and as many reflections." : " and no reflection.");
  return out.str();
}

DartMap darts(const RegularMap& map) {
  std::vector<RotationWord> relators = triangle_relators(map.type);
  std::istringstream words{std::string(map.relators)};
  for (std::string word; words >> word;) relators.push_back(parse_rotations(word));
  return CosetTable(relators, 100UL * rotations(map)).map();
}

DartMap standard_form(const DartMap& map) {
  const auto count = static_cast<std::uint32_t>(map.rotation.size());
  const Permutation* const steps[] = {&map.rotation, &map.edges};
  Permutation number(count, count);
  Permutation order{0};
  number[0] = 0;
  DartMap result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const Permutation* step : steps) {
      const std::uint32_t image = (*step)[order[i]];
      if (number[image] == count) {
        number[image] = static_cast<std::uint32_t>(order.size());
        order.push_back(image);
      }
      (step == &map.rotation ? result.rotation : result.edges).push_back(number[image]);
    }
  }
  return result;
}

DartMap mirror_image(const DartMap& map) {
  DartMap result{Permutation(map.rotation.size()), map.edges};
  for (std::uint32_t dart = 0; dart < map.rotation.size(); ++dart) result.rotation[map.rotation[dart]] = dart;
  return result;
}

DartMap dual(const DartMap& map) { return {composed(map.edges, mirror_image(map).rotation), map.edges}; }

DartMap map_of_surface(const Surface& surface) {
  DartMap result;
  for (std::uint32_t s = 0; s < surface.side_count(); ++s) {
    result.rotation.push_back(surface.next_side(SideId(s)).number());
    result.edges.push_back(surface.partner(SideId(s)).number());
  }
  return result;
}

}  // namespace epsnet
