#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/base/interval.h"
#include "certify/claims/geodesics/document.h"
#include "netgen/base/options.h"
#include "netgen/curves/lengths.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// Surfaces of which the systole is greatest among those near them: the climb to one, that one is near, and that the
/// systole of an exact surface has a local maximum there. docs/curves.md says how, and why the proofs are ones.
namespace epsnet {

// The climb.

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

/// Proves that a local maximum is near a surface, by closed geodesics that are about as long as its systole, of which
/// the lower end of `systole` is a bound. Nothing if it does not follow.
[[nodiscard]] std::optional<NearMaximum> near_maximum(const EnclosedCoordinates& coordinates,
                                                      const certify::Interval& systole, std::span<const Word> systoles);

// Exact surfaces.

/// It is not proved that the systole has a local maximum; what() says what fails. It may have one all the same.
class NotMaximalError : public NetError {
 public:
  using NetError::NetError;
};

/// Returns all closed geodesics that are hardly longer than the systole, those first that are as long as it, and what
/// proves that the systole is greater than that of any other surface near this one: the gradients of the lengths of the
/// shortest ones span, and with some positive weights their sum is 0.
///
/// Throws as `systole`, and NotMaximalError if this is not so, or the shortest ones are not known to be of exactly
/// equal length: coordinates that are rounded do not do. Time: a spectrum up to the systole, and the pairs of shortest
/// geodesics.
[[nodiscard]] Certified<certify::GeodesicsDocument> local_maximum(const Surface& surface,
                                                                  const GeodesicsOptions& options = {});

namespace unproved {
[[nodiscard]] certify::GeodesicsDocument local_maximum(const Surface& surface, const GeodesicsOptions& options = {});
}  // namespace unproved

// Gradients of lengths: whether 0 is inside of their hull. The first two are computed in binary64, and prove nothing.

/// Numbers λ > 0 with the sum 1 and Σ λ_i g_i = 0, about, of which the least one is as great as possible. Nothing if
/// that is not positive or hardly so. A linear programme.
[[nodiscard]] std::optional<std::vector<double>> balance(std::span<const std::vector<certify::Interval>> gradients);

/// Those gradients that are a basis of what all span, as far as binary64 tells. O(n d²).
[[nodiscard]] std::vector<std::size_t> independent(std::span<const std::vector<certify::Interval>> gradients);

/// A number m > 0 such that for every u some gradient g has g·u ≤ −m·max |u_j|: to first order the least of functions
/// with these gradients falls so fast in all directions. Nothing if none is found, as where 0 is not inside of the hull
/// of the gradients. Each gradient is one of an interval for each coordinate. O(n d² + d³) but for linear programmes.
[[nodiscard]] std::optional<double> slope_of_least(std::span<const std::vector<certify::Interval>> gradients);

}  // namespace epsnet
