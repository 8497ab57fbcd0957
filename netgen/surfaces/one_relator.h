#pragma once

#include <cstdint>
#include <vector>

#include "netgen/surfaces/group.h"

namespace epsnet {

/// Sides of the polygon to be crossed one after the other; a word of the group.
using SidesOfPolygon = std::vector<std::uint32_t>;

[[nodiscard]] SidesOfPolygon inverse_of(const PolygonSides& polygon, SidesOfPolygon word);

/// The group of a surface with the generators that one relation leaves: one relation after the other is used up to
/// express a generator, until one is left, in which each generator occurs once in each direction.
struct OneRelator {
  explicit OneRelator(const PolygonSides& polygon);

  struct Expressed {
    std::uint32_t side;
    SidesOfPolygon word;
  };
  SidesOfPolygon relation;           ///< The product of their isometries is 1.
  std::vector<Expressed> expressed;  ///< Each by generators that are free or come later.
};

}  // namespace epsnet
