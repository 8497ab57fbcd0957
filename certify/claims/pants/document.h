#pragma once

#include <array>
#include <cstdint>
#include <gmpxx.h>
#include <vector>

#include "certify/base/interval.h"
#include "certify/net/document.h"

/// The contents of a pants file as plain data, member by member as docs/format.md defines them.
///
/// A document only states what a file says; nothing here is proved. `check` (certify/check.h) decides whether
/// it is true. Lengths are hyperbolic.
namespace epsnet::certify {

/// A pants file: a pants decomposition of a surface along closed geodesics, and its Fenchel–Nielsen coordinates.
struct PantsDocument {
  /// Numbers of sides that a path crosses.
  using Word = std::vector<std::uint32_t>;
  /// A pair of pants: closed paths from one tile that are freely homotopic to its cuffs 0 and 1, with the pants on
  /// their left. Cuff 2 is both of them, one after the other, backwards.
  using Paths = std::array<Word, 2>;
  /// A pair of pants, and one of its cuffs: 0, 1 or 2.
  using End = std::array<std::uint32_t, 2>;

  /// A closed geodesic along which the surface is cut.
  struct Cuff {
    std::array<End, 2> ends{};  ///< What is on its two sides.
    Word across;                ///< A path from the tile of the first end's pants to that of the second end's.
    Interval length{};          ///< Contains the length; 0 < lower ≤ upper.
    Interval twist{};           ///< Contains the twist, for one of its values, which differ by the length.
    mpq_class exp_half_length;  ///< e^{length/2}, exactly; 0 claims nothing.
    bool operator==(const Cuff&) const = default;
  };

  NetDocument net;
  std::vector<Paths> pants;
  std::vector<Cuff> cuffs;
  bool operator==(const PantsDocument&) const = default;
};

}  // namespace epsnet::certify
