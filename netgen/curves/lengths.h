#pragma once

#include <vector>

#include "certify/base/interval.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"

/// Lengths of closed geodesics as functions of Fenchel–Nielsen coordinates, and their derivatives. docs/curves.md says
/// how they are found.
namespace epsnet {

/// Fenchel–Nielsen coordinates of which intervals are known: first the lengths of all cuffs, then the twists.
struct EnclosedCoordinates {
  PantsGraph graph;
  std::vector<certify::Interval> values;
};

/// The coordinates of pants of which fenchel_nielsen_surface made the surface. Throws SurfaceError for other ones.
[[nodiscard]] EnclosedCoordinates enclosed_coordinates(const PantsDecomposition& pants);

/// The length of a closed geodesic, and its derivatives.
struct LengthDerivatives {
  certify::Interval length{};
  std::vector<certify::Interval> gradient;             ///< By coordinate.
  std::vector<std::vector<certify::Interval>> second;  ///< By two coordinates; empty unless asked for.
};

/// Encloses the derivatives of the length of a closed path's geodesic, at all coordinates in these intervals. The word
/// is one of a surface that fenchel_nielsen_surface made of such coordinates: numbers of the sides of its heptagons.
///
/// Throws LimitError if intervals are too wide, or the geodesic too long. O(letters · n) for n coordinates that are
/// known exactly, and O(letters · n²) for intervals or with second derivatives.
[[nodiscard]] LengthDerivatives length_derivatives(const EnclosedCoordinates& coordinates, const Word& word,
                                                   bool second = false);

}  // namespace epsnet
