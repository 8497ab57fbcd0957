#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/base/interval.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// A pair of pants, by the elements of its cuffs 0 and 1: paths from a tile to itself. That of cuff 2 is the inverse of
/// the path of cuff 0 and then that of cuff 1.
struct PantsPaths {
  std::array<Word, 2> cuffs;
};

/// The length of a cuff and the twist there, in intervals.
struct CuffCoordinates {
  certify::Interval length{};
  certify::Interval twist{};  ///< Between −½ and ½ of the length, but for the width of the interval.
  /// e^{length/2}, if that is rational.
  std::optional<Rational> root;
};

/// Returns by edge the Fenchel–Nielsen coordinates of a surface that is glued of these pairs of pants, by paths across
/// the edges, each from the tile of the pants of its first end to that of its second end. That the surface is glued of
/// them is taken for granted: certify::check decides it (docs/proof.md, section 19). Throws LimitError if the
/// coordinates are not known with many bits, as for paths that are no cuffs.
///
/// Time: that of some products of all letters of each path.
[[nodiscard]] std::vector<CuffCoordinates> cuff_coordinates(const Surface& surface, const PantsGraph& graph,
                                                            const std::vector<PantsPaths>& pants,
                                                            const std::vector<Word>& across);

}  // namespace epsnet
