#include "netgen/isometries/map_automorphisms.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace epsnet {
namespace {

/// Side 0, or another one to which an automorphism takes it, and whether it preserves the orientation.
struct Flag {
  SideId side;
  bool preserves;
};

/// The automorphism that takes side 0 to a flag, if there is one.
std::optional<MapAutomorphism> automorphism_to(const Surface& surface, const Flag& flag) {
  const SideId unknown(surface.side_count());
  MapAutomorphism result{flag.preserves, ById<SideId, SideId>(surface.side_count(), unknown)};
  std::vector<SideId> known{SideId(0)};
  result.image[SideId(0)] = flag.side;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const SideId s = known[i];
    const SideId to = result.image[s];
    for (const auto& [next, image] :
         {std::pair(surface.next_side(s), flag.preserves ? surface.next_side(to) : surface.previous_side(to)),
          std::pair(surface.partner(s), surface.partner(to))}) {
      if (result.image[next] == unknown) {
        result.image[next] = image;
        known.push_back(next);
      } else if (result.image[next] != image) {
        return std::nullopt;
      }
    }
  }
  return result;
}

/// The flags that are reached from side 0, or from one of those, by products of automorphisms.
class ReachedFlags {
 public:
  explicit ReachedFlags(std::uint32_t sides) : sides_(sides), reached_(2 * std::size_t{sides}) {}

  [[nodiscard]] bool contains(const Flag& flag) const { return reached_[number(flag)]; }

  void add_orbit(const Flag& flag, const std::vector<MapAutomorphism>& automorphisms) {
    std::vector<Flag> found{flag};
    reached_[number(flag)] = true;
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const MapAutomorphism& f : automorphisms) {
        const Flag image{f.image[found[i].side], found[i].preserves == f.preserves_orientation};
        if (contains(image)) continue;
        reached_[number(image)] = true;
        found.push_back(image);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t number(const Flag& flag) const {
    return flag.side.number() + (flag.preserves ? 0 : std::size_t{sides_});
  }

  std::uint32_t sides_;
  std::vector<bool> reached_;
};

}  // namespace

std::vector<MapAutomorphism> map_automorphisms(const Surface& surface) {
  std::vector<MapAutomorphism> result;
  if (!surface.is_regular()) return result;
  const Flag first{SideId(0), true};
  ReachedFlags done(surface.side_count());
  done.add_orbit(first, result);
  for (const bool preserves : {true, false}) {
    for (const SideId s : surface.side_ids()) {
      const Flag flag{s, preserves};
      if (done.contains(flag)) continue;
      if (std::optional<MapAutomorphism> f = automorphism_to(surface, flag)) {
        // Flags to which none leads before are forgotten, as their orbits are larger now; those that count come later.
        result.push_back(*std::move(f));
        done = ReachedFlags(surface.side_count());
        done.add_orbit(first, result);
      } else {
        done.add_orbit(flag, result);
      }
    }
  }
  return result;
}

Word image_of(const MapAutomorphism& automorphism, const Word& word) {
  Word result;
  for (const SideId s : word) result.push_back(automorphism.image[s]);
  return result;
}

TileId image_of(const Surface& surface, const MapAutomorphism& automorphism, TileId tile) {
  return surface.tile_of_side(automorphism.image[surface.side_number(tile, 0)]);
}

}  // namespace epsnet
