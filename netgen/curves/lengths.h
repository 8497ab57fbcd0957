#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/base/interval.h"
#include "netgen/base/options.h"
#include "netgen/pants/pants.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "triangulation/surface/surface.h"

/// Lengths of closed geodesics as functions of Fenchel–Nielsen coordinates: their derivatives, and surfaces of which
/// the systole is greatest among those near them. docs/curves.md says how, and why the proof is one.
namespace epsnet {

// Derivatives.

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

// The greatest systoles.

/// Options of the search for a local maximum.
struct MaximizeOptions {
  std::uint32_t steps = 200;  ///< At most so many surfaces.
  unsigned threads = 0;       ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};     ///< Called occasionally, if given.
};

/// That there is a local maximum of the systole near a surface. Distances are the greatest differences of its
/// coordinates, lengths and twists; twists are real numbers here.
struct NearMaximum {
  double distance = 0;  ///< There is one that is nearer than that.
  double slope = 0;     ///< Near the surface the systole is less by at least so much for each unit of distance, but for
                        ///< terms of second order.
};

/// A surface at which the systole seems to be greatest among those near it.
struct SystoleMaximum {
  Surface surface;                  ///< In heptagons, one for each pair of pants.
  EnclosedCoordinates coordinates;  ///< Of the surface.
  certify::Interval systole{};      ///< Proved by both checkers.
  std::vector<Word> systoles;       ///< The closed geodesics that are longer by at most 10⁻⁹.
  /// What balls prove; nothing if they do not.
  std::optional<NearMaximum> proof;
  std::uint32_t steps = 0;  ///< How many surfaces were looked at.
};

/// Climbs from a surface in its Fenchel–Nielsen coordinates: each time a linear programme says how all short closed
/// geodesics get longer together. Deterministic.
///
/// Throws as pants_decomposition and fenchel_nielsen_surface, and NetError if a step fails. Time is that of a spectrum
/// a little beyond the systole, for each of some 20 to 100 steps.
[[nodiscard]] SystoleMaximum maximize_systole(const Surface& start, const MaximizeOptions& options = {});

/// A number m > 0 such that for every u some gradient g has g·u ≤ −m·max |u_j|: to first order the least of functions
/// with these gradients falls so fast in all directions. Nothing if none is found, as where 0 is not inside of the hull
/// of the gradients. Each gradient is one of an interval for each coordinate. O(n d² + d³) but for linear programmes.
[[nodiscard]] std::optional<double> slope_of_least(std::span<const std::vector<certify::Interval>> gradients);

/// Proves that a local maximum is near a surface, by closed geodesics that are about as long as its systole, of which
/// the lower end of `systole` is a bound. Nothing if it does not follow.
[[nodiscard]] std::optional<NearMaximum> near_maximum(const EnclosedCoordinates& coordinates,
                                                      const certify::Interval& systole, std::span<const Word> systoles);

}  // namespace epsnet
