#pragma once

#include <string>
#include <vector>

#include "netgen/isometries/isometries.h"
#include "triangulation/surface/surface.h"

/// Which surface is this? docs/isometries.md says how that is decided.
namespace epsnet {

/// A surface that has names, and whether it is isometric to a given one.
struct NamedAnswer {
  std::vector<std::string> names;  ///< For named_surface; the first one is the one to say.
  std::string compared;            ///< The one of them with which the surface was compared at last.
  IsometricAnswer answer;          ///< From the given surface to named_surface(compared).
};

/// Returns the names of the known surfaces of a genus, those of each surface together: names_of_genus, then those of
/// its regular maps, the map with the most rotations first.
[[nodiscard]] std::vector<std::vector<std::string>> known_surfaces(std::uint32_t genus);

/// Compares a surface with the known ones of its genus, up to the one to which it is isometric, which is then the last
/// of the list: first with those that have as many closed geodesics of the length of its systole, and as many
/// isometries. Throws as `isometric`; the time is about that of one comparison with a surface to which it is isometric,
/// and a verified list of systoles for each known surface if there is none.
[[nodiscard]] std::vector<NamedAnswer> identify(const Surface& surface, const IsometryOptions& options = {});

}  // namespace epsnet
