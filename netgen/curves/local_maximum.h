#pragma once

#include "certify/claims/geodesics/document.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// Surfaces at which the systole has a local maximum, exactly. docs/curves.md says how.
namespace epsnet {

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

}  // namespace epsnet
