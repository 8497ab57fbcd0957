#pragma once

#include "certify/document/geodesics_document.h"
#include "netgen/base/length.h"
#include "netgen/base/progress.h"
#include "triangulation/surface.h"

/// Closed geodesics of a surface: the systole, the length spectrum, the small curves. docs/geodesics.md says how and
/// why.
///
/// What these functions return is not proved yet; certify::check_geodesics proves it. All are deterministic and throw
/// NetError where no net or no closed geodesic is found or a search would be too long, LimitError where the surface is
/// beyond the numbers of the generator; both are an Error.
namespace epsnet {

/// How closed geodesics are searched for.
struct GeodesicsOptions {
  /// The covering that the search starts from. Small values make many searches, large ones long searches; the optimum
  /// is flat, near 1 (docs/geodesics.md).
  Length epsilon{"1"};
  unsigned threads = 0;    ///< 0: as many as the machine has cores. The result is the same for any number.
  Progress progress = {};  ///< Called now and then, if given.
};

/// A shortest closed geodesic; its length is the systole. A search up to the systole σ of genus g, some
/// sinh²(σ/2)·(g − 1) steps.
[[nodiscard]] certify::GeodesicsDocument systole(const Surface& surface, const GeodesicsOptions& options = {});

/// All primitive closed geodesics of length at most `up_to`, up to orientation, by length. About e^L/(2L) of them, in
/// time about proportional to e^L, L = up_to.
[[nodiscard]] certify::GeodesicsDocument spectrum(const Surface& surface, const Length& up_to,
                                                  const GeodesicsOptions& options = {});

/// The small curves, which are the closed geodesics of length at most 2 arsinh 1: at most 3g − 3, simple and pairwise
/// disjoint (Buser, Geometry and Spectra of Compact Riemann Surfaces, Theorem 4.1.6); and the pieces into which they
/// cut the surface.
[[nodiscard]] certify::GeodesicsDocument thick_thin(const Surface& surface, const GeodesicsOptions& options = {});

/// The half-width w of the collar of a small curve, sinh w = 1/sinh(ℓ/2) (thesis Definition I.21), enclosed for a
/// length that is enclosed.
[[nodiscard]] certify::Interval collar_half_width(certify::Interval length);

}  // namespace epsnet
