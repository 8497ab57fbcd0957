#pragma once

#include "certify/claims/geodesics/document.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// Closed geodesics of a surface: the systole, the length spectrum, the small curves. docs/geodesics.md says how and
/// why.
///
/// All functions are deterministic. They throw NetError if no net or no closed geodesic is found, or if a search would
/// be too long; NotCertifiedError, which is one, if the proof fails; and LimitError if the surface is beyond the
/// numbers of the generator.
namespace epsnet {

/// Options of the search for closed geodesics.
struct GeodesicsOptions {
  /// The ε of the net that the search starts from. Small values make many searches, large values long searches. The
  /// optimum is near 1, and flat (docs/geodesics.md).
  Length epsilon{"1"};
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};  ///< Called occasionally, if given.
};

/// Returns a shortest closed geodesic; its length is the systole. For the systole σ and genus g the search takes some
/// sinh²(σ/2)·(g − 1) steps.
[[nodiscard]] Certified<certify::GeodesicsDocument> systole(const Surface& surface,
                                                            const GeodesicsOptions& options = {});

/// Returns all primitive closed geodesics of length at most L = `up_to`, up to orientation, ordered by length. There
/// are about e^L/(2L); the time is about proportional to e^L.
[[nodiscard]] Certified<certify::GeodesicsDocument> spectrum(const Surface& surface, const Length& up_to,
                                                             const GeodesicsOptions& options = {});

/// Returns the small curves and the pieces into which they cut the surface. Small curves are the closed geodesics of
/// length at most 2 arsinh 1. There are at most 3g − 3; they are simple and pairwise disjoint (Buser, Geometry and
/// Spectra of Compact Riemann Surfaces, Theorem 4.1.6).
[[nodiscard]] Certified<certify::GeodesicsDocument> thick_thin(const Surface& surface,
                                                               const GeodesicsOptions& options = {});

namespace unproved {

/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::GeodesicsDocument systole(const Surface& surface, const GeodesicsOptions& options = {});
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::GeodesicsDocument spectrum(const Surface& surface, const Length& up_to,
                                                  const GeodesicsOptions& options = {});
/// The same document without its proof: nothing in it is proved.
[[nodiscard]] certify::GeodesicsDocument thick_thin(const Surface& surface, const GeodesicsOptions& options = {});

}  // namespace unproved

/// Returns an enclosure of the half-width w of the collar of a small curve, sinh w = 1/sinh(ℓ/2) (thesis Definition
/// I.21). `length` encloses ℓ.
[[nodiscard]] certify::Interval collar_half_width(certify::Interval length);

}  // namespace epsnet
