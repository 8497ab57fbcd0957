#pragma once

#include <cstdint>
#include <vector>

#include "certify/claims/eigenvalues/document.h"
#include "kernel/numbers.h"
#include "netgen/lifts/lifts.h"
#include "triangulation/surface/surface.h"

/// Characters near one of a surface, and how far eigenvalues with phases may be from those at it (docs/proof.md,
/// Lemma 37.10), rounded.
namespace epsnet {

/// The directions of the torus of all characters, those of character_sides (netgen/surfaces/group.h), each with a
/// function h of least energy that is linear on the flat triangles of a net.
class CharacterDirections {
 public:
  /// Of the net of the geometry, which is of the surface. Solves 2g systems of linear equations with a row for each
  /// vertex.
  CharacterDirections(const Surface& surface, const NetGeometry& geometry);

  /// All directions.
  [[nodiscard]] certify::EigenvaluesDocument::Box box(const Rational& radius) const;
  /// In it the roots of eigenvalues are at most that far from those in its centre: a little more than what is proved.
  [[nodiscard]] double distance(const Rational& radius) const;

 private:
  std::vector<certify::EigenvaluesDocument::Direction> directions_;
  double slope_ = 0;  ///< Of the sums of all ±h, the greatest.
};

/// Makes intervals so wide that they hold in the whole box.
void widen(certify::EigenvaluesDocument& document, const CharacterDirections& directions, const Rational& radius);

}  // namespace epsnet
