#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "netgen/geodesics/geodesics.h"
#include "netgen/isometries/invariants.h"
#include "netgen/isometries/isometries.h"
#include "netgen/surfaces/surfaces.h"

namespace epsnet {
namespace {

/// A known surface and its closed geodesics that are not longer than the systole of the given surface.
struct KnownSurface {
  std::vector<std::string> names;
  Surface surface;
  certify::GeodesicsDocument systoles;
};

/// The name of the surface of a regular map: that of its map with the most rotations.
std::optional<std::string_view> surface_of_regular_map(const Surface& surface) {
  const DartMap map = standard_form(map_of_surface(surface));
  for (const RegularMap& known : regular_maps()) {
    if (known.genus != surface.genus() || rotations(known) != map.edges.size()) continue;
    const DartMap known_map = darts(known);
    for (const DartMap& form : {known_map, dual(known_map)}) {
      if (standard_form(form) == map || standard_form(mirror_image(form)) == map) return known.surface;
    }
  }
  return std::nullopt;
}

/// As `isometric`, with any of the maps of a surface: with some the numbers may be too large to be compared. They are
/// small if the tiles are the same.
NamedAnswer isometric_to_any(const Surface& surface, const std::vector<std::string>& names,
                             const IsometryOptions& options) {
  std::vector<std::pair<std::string, Surface>> maps;
  for (const std::string& name : names) maps.emplace_back(name, named_surface(name));
  std::stable_partition(maps.begin(), maps.end(),
                        [&](const auto& map) { return map.second.regular_tile() == surface.regular_tile(); });
  NamedAnswer result;
  result.names = names;
  for (const auto& [name, map] : maps) {
    result.compared = name;
    result.answer = isometric(surface, map, options);
    if (result.answer.kind != IsometricAnswer::Kind::undecided || !result.answer.isometry) break;
  }
  return result;
}

}  // namespace

std::vector<std::vector<std::string>> known_surfaces(std::uint32_t genus) {
  std::vector<std::vector<std::string>> result;
  std::map<std::string_view, std::size_t> place;
  const auto add = [&](std::optional<std::string_view> surface, std::string name) {
    if (!surface) {
      result.push_back({std::move(name)});
      return;
    }
    const auto [known, is_new] = place.emplace(*surface, result.size());
    if (is_new) result.emplace_back();
    result[known->second].push_back(std::move(name));
  };
  std::vector<const RegularMap*> maps;
  for (const RegularMap& map : regular_maps()) {
    if (map.genus == genus) maps.push_back(&map);
  }
  for (std::string& name : names_of_genus(genus)) {
    const auto surface = maps.empty() ? std::nullopt : surface_of_regular_map(named_surface(name));
    add(surface, std::move(name));
  }
  std::stable_sort(maps.begin(), maps.end(),
                   [](const RegularMap* a, const RegularMap* b) { return rotations(*a) > rotations(*b); });
  for (const RegularMap* map : maps) add(map->surface, std::string(map->name));
  return result;
}

std::vector<NamedAnswer> identify(const Surface& surface, const IsometryOptions& options) {
  GeodesicsOptions of_geodesics;
  of_geodesics.threads = options.threads;
  of_geodesics.progress = options.progress;
  // A little more than the systole, up to which lists show it and how many closed geodesics are as short.
  const Length length(unproved::systole(surface, of_geodesics).geodesics.front().length.upper * (1 + 1e-9));
  const certify::GeodesicsDocument systoles = unproved::spectrum(surface, length, of_geodesics);
  of_geodesics.progress = {};
  std::vector<KnownSurface> similar;
  std::vector<KnownSurface> others;
  const std::vector<std::vector<std::string>> known = known_surfaces(surface.genus());
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (options.progress) {
      options.progress("comparing systoles", static_cast<double>(i) / static_cast<double>(known.size()));
    }
    Surface named = named_surface(known[i].front());
    certify::GeodesicsDocument list = unproved::spectrum(named, length, of_geodesics);
    const bool differs = certain_difference(systoles, list).has_value();
    (differs ? others : similar).push_back({known[i], std::move(named), std::move(list)});
  }
  if (similar.size() > 1) {
    const std::size_t order = isometries(surface, options).size();
    std::stable_partition(similar.begin(), similar.end(), [&](const KnownSurface& other) {
      return isometries(other.surface, options).size() == order;
    });
  }

  std::vector<NamedAnswer> result;
  for (const KnownSurface& other : similar) {
    result.push_back(isometric_to_any(surface, other.names, options));
    if (result.back().answer.kind == IsometricAnswer::Kind::yes) return result;
  }
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (options.progress) {
      options.progress("proving that systoles differ", static_cast<double>(i) / static_cast<double>(others.size()));
    }
    IsometricAnswer answer;
    answer.reason = certain_difference(systoles, others[i].systoles).value();
    answer.proof = proved_difference(systoles, others[i].systoles, options.threads);
    if (answer.proof) {
      answer.kind = IsometricAnswer::Kind::no;
    } else {
      answer.reason += "; but certify does not verify these lists";
    }
    std::string compared = others[i].names.front();
    result.push_back({std::move(others[i].names), std::move(compared), std::move(answer)});
  }
  return result;
}

}  // namespace epsnet
