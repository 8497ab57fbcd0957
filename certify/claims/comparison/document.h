#pragma once

#include <cstdint>
#include <vector>

#include "certify/claims/geodesics/document.h"

/// The contents of a comparison file as plain data, member by member as docs/format.md defines them.
///
/// A document only states what a file says; nothing here is proved.
namespace epsnet::certify {

/// A comparison file: two surfaces, that of `net` and that of `other.net`, and that they are isometric or that they are
/// not.
///
/// The generators of the first surface's group are g_s = paths[t] · s · paths[t']⁻¹ for the sides s of its tiles t,
/// glued to sides of tiles t'; those with s less than its partner are in the order of s.
struct ComparisonDocument : GeodesicsDocument {
  /// What the second surface is said to be.
  enum class Relation { isometric, different };

  /// Numbers of sides that a path crosses.
  using Word = std::vector<std::uint32_t>;

  /// An isometry that lifts to an isometry f of the plane, from the coordinates of tile 0 of the first surface to those
  /// of tile 0 of the other one.
  struct Isometry {
    bool preserves_orientation = true;
    std::vector<Word> paths;  ///< By tile of the first surface: from tile 0 to it.
    std::vector<Word> pair;   ///< Two elements of its group, from tile 0 to itself, of which the axes cross.
    /// Words of the other surface, from tile 0 to itself, of f ∘ g ∘ f⁻¹: for the two elements g of `pair` and then the
    /// generators g_s.
    std::vector<Word> images;
    bool operator==(const Isometry&) const = default;
  };

  /// Lists are complete spectra.
  ComparisonDocument() {
    GeodesicsDocument::claim = Claim::spectrum;
    other.claim = Claim::spectrum;
  }

  Relation relation = Relation::isometric;
  GeodesicsDocument other;  ///< Only its net, and only the net of the first surface, if they are isometric.
  Isometry isometry;        ///< Only if they are.
  bool operator==(const ComparisonDocument&) const = default;
};

}  // namespace epsnet::certify
