#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/isometries/document.h"
#include "certify/net/document.h"

/// The contents of a bound file as plain data, member by member as docs/format.md defines them.
///
/// A document only states what a file says; nothing here is proved. `check` (certify/check.h) decides whether it is
/// true. Lengths are hyperbolic.
namespace epsnet::certify {

/// Isometries of a surface, counterclockwise around a centre. The domain of the points that are not farther from the
/// centre than from its images has a point of every orbit; so a function that isometries keep is bounded there alone.
struct BoundSymmetry : IsometryRows {
  std::array<double, 2> centre{};  ///< In the chart of the net's vertex, inside of the disk.
  bool operator==(const BoundSymmetry&) const = default;
};

/// A bound file: bounds for a function on a surface, proved cell by cell.
struct BoundDocument {
  /// The quantity that is claimed to lie between the bounds.
  ///
  /// `diameter`: the diameter, which is the greatest eccentricity. `radius`: the radius, which is the least
  /// eccentricity. `embedded_disk`: the radius of the largest embedded disk, which is the greatest injectivity radius.
  enum class Claim { diameter, radius, embedded_disk };

  /// A one-vertex triangulation, obtained from its parent by flips.
  struct Triangulation {
    std::uint32_t parent = 0;          ///< Number 0 is that of the net, number k ≥ 1 is triangulations[k − 1].
    std::vector<std::uint32_t> flips;  ///< Darts, flipped one after the other.
    bool operator==(const Triangulation&) const = default;
  };

  Claim claim = Claim::diameter;
  NetDocument net;   ///< With one vertex, a point where the function is at least the lower bound; for a radius, at most
                     ///< the upper one.
  Interval value{};  ///< 0 < lower ≤ upper.
  std::vector<Triangulation> triangulations;
  /// How the triangulation that is cut into cells is made from that of the net, step by step: 2d flips dart d, 2d + 1
  /// splits it at its midpoint.
  std::vector<std::uint32_t> base;
  /// If there is one, cells are cut from the triangles around its centre, one for each isometry, and `base` is empty.
  std::optional<BoundSymmetry> symmetry;
  /// By triangle of the base, or of the domain: how it is cut into cells, in preorder. 0, 1 and 2 cut across an edge, 3
  /// + k is a cell where the bound is that of triangulation k; for a radius, that of triangulation k' at the midpoint
  /// of side i, if k is i + 3k'; for an embedded disk, that of dart d of triangulation k', if k is d + 3nk' with n
  /// triangles.
  std::vector<std::vector<std::uint32_t>> cells;
  bool operator==(const BoundDocument&) const = default;
};

}  // namespace epsnet::certify
