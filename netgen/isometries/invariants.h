#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/claims/geodesics/document.h"
#include "triangulation/surface/surface.h"

/// What isometries preserve: the homology of a surface, and the lengths of its closed geodesics.
namespace epsnet {

/// The first homology of a surface, over a field of prime order, as the quotient of the side pairings of its
/// fundamental polygon by its relations.
class Homology {
 public:
  /// O(n³) for n side pairings.
  explicit Homology(const Surface& surface);

  /// The trace of the map that takes the classes of some words to those of their images, words from tile 0 to itself.
  /// Requires: `words` are those of the sides k of fundamental_polygon with k < partner, in order; the trace is less
  /// than 10⁹.
  [[nodiscard]] std::int64_t trace(const std::vector<Word>& words, const std::vector<Word>& images) const;

 private:
  using Row = std::vector<std::int64_t>;
  [[nodiscard]] Row class_of(const Word& word) const;

  std::size_t pairs_ = 0;
  ById<SideId, std::int64_t> sign_;  ///< 1 or −1 if a side of the surface is a side of the polygon, else 0,
  ById<SideId, std::size_t> pair_;   ///< and of which pair.
  std::vector<Row> relations_;       ///< Reduced: row i has a 1 at pivots_[i], where all others have 0.
  std::vector<std::size_t> pivots_;
};

/// What tells two surfaces apart, in words: a length ℓ such that one of them certainly has more primitive closed
/// geodesics that are at most as long than the other one. Nothing, if there is none.
///
/// Requires: spectra. The statement follows from them (docs/isometries.md); they are not checked here. O(n log n).
[[nodiscard]] std::optional<std::string> certain_difference(const certify::GeodesicsDocument& first,
                                                            const certify::GeodesicsDocument& second);

}  // namespace epsnet
