#pragma once

#include <cstdint>
#include <vector>

#include "certify/claims/geodesics/document.h"

/// The contents of an isometries file as plain data, member by member as docs/format.md defines them.
///
/// A document only states what a file says; nothing here is proved.
namespace epsnet::certify {

/// Isometries of a surface, by what they do with its group.
///
/// The generators of the surface's group are g_s = paths[t] · s · paths[t']⁻¹ for the sides s of tiles t, glued to
/// sides of tiles t'; those with s less than its partner are in the order of s.
struct IsometryRows {
  /// Numbers of sides that a path crosses.
  using Word = std::vector<std::uint32_t>;

  /// An isometry of the surface that lifts to an isometry f of the plane, in the coordinates of tile 0.
  struct Isometry {
    bool preserves_orientation = true;
    /// Words from tile 0 to itself of f ∘ g ∘ f⁻¹, for the two elements g of `pair` and then the generators g_s.
    std::vector<Word> images;
    bool operator==(const Isometry&) const = default;
  };

  std::vector<Isometry> isometries;
  std::vector<Word> paths;  ///< By tile: from tile 0 to it.
  std::vector<Word> pair;   ///< Two elements from tile 0 to itself, of which the axes cross.
  bool operator==(const IsometryRows&) const = default;
};

/// An isometries file: a spectrum, and generators of the isometry group with the order of the group.
struct IsometriesDocument : GeodesicsDocument, IsometryRows {
  /// Numbers of sides, as in the rows.
  using Word = IsometryRows::Word;

  /// Claims a complete spectrum.
  IsometriesDocument() { claim = Claim::spectrum; }

  std::uint32_t order = 1;  ///< Of the group of all isometries, which those listed generate.
  /// By generator g_s: the value of a function of words at the letter s; the letter of its partner has the opposite
  /// one, and the letters around a vertex have the sum 0, all modulo 2³².
  std::vector<std::uint32_t> cocycle;
  bool operator==(const IsometriesDocument&) const = default;
};

}  // namespace epsnet::certify
