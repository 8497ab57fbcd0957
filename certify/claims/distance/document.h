#pragma once

#include <cstdint>
#include <vector>

#include "certify/base/interval.h"
#include "certify/net/document.h"

/// The contents of a distance file as plain data, member by member as docs/format.md defines them.
///
/// A document only states what a file says; nothing here is proved. `check` (certify/check.h) decides whether
/// it is true.
namespace epsnet::certify {

/// A distance file: the distance between two points p and q of a surface, and geodesics from p to q.
struct DistanceDocument {
  /// The point of the surface with these coordinates in the disk of a tile. The tile need not contain it.
  struct Point {
    std::uint32_t tile = 0;
    RationalPoint z;
    bool operator==(const Point&) const = default;
  };

  NetDocument net;      ///< Its one vertex is p.
  Point point;          ///< q.
  Interval distance{};  ///< Contains the distance; hyperbolic, 0 ≤ lower ≤ upper.
  /// All geodesics from p to q of length at most `distance.upper`, as words from the tile of p's chart to q's: the path
  /// leaves the tile through the first side and ends at the lift of q that the inverse of the word's value takes into
  /// the disk of p's tile.
  std::vector<std::vector<std::uint32_t>> paths;
  bool equal = false;  ///< All of them are claimed to be of exactly equal length; false claims nothing.
  bool operator==(const DistanceDocument&) const = default;
};

}  // namespace epsnet::certify
