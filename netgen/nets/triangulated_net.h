#pragma once

#include <optional>
#include <vector>

#include "certify/net/document.h"
#include "netgen/base/options.h"
#include "netgen/nets/certified_net.h"
#include "triangulation/mesh/triangulation.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// A net as a triangulation, not proved.
struct TriangulatedNet {
  Triangulation triangulation;
  NetStatistics statistics;
  std::optional<std::vector<certify::NetDocument::Collar>> collars;  ///< Of a pseudo net.
};

/// Like compute_net (certified_net.h), as a triangulation.
[[nodiscard]] TriangulatedNet triangulated_net(const Surface& surface, const Length& epsilon,
                                               const NetOptions& options = {});

}  // namespace epsnet
