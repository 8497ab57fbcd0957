#pragma once

#include <optional>
#include <vector>

#include "certify/document/document.h"
#include "certify/document/report.h"
#include "netgen/base/length.h"
#include "netgen/nets/net_document.h"
#include "netgen/nets/net_options.h"
#include "triangulation/surface.h"
#include "triangulation/triangulation.h"

namespace epsnet {

/// An ε-net whose certificate says VERIFIED.
struct CertifiedNet {
  certify::NetDocument net;
  certify::Certificate certificate;
  NetStatistics statistics;
};

/// A net that is not proved yet: the document, to be handed to certify::check.
struct UncertifiedNet {
  certify::NetDocument net;
  NetStatistics statistics;
};

/// A net as a triangulation, not proved.
struct TriangulatedNet {
  Triangulation triangulation;
  NetStatistics statistics;
  std::optional<std::vector<certify::NetDocument::Collar>> collars;  ///< Of a pseudo net.
};

/// Computes an ε-net of the surface by Delaunay refinement (thesis Algorithm IV.4.1).
///
/// The vertices of the surface's tiles are the start; of those closer than ε to each other some are removed, and so are
/// those near closed geodesics no longer than ε if a pseudo net is asked for. Deterministic.
/// Throws NetError, LimitError, std::bad_alloc; std::invalid_argument for a pseudo net with ε > ln √2, or one that
/// shall be sparse.
[[nodiscard]] TriangulatedNet triangulated_net(const Surface& surface, const Length& epsilon,
                                               const NetOptions& options = {});

/// The same as a document, without its certificate.
[[nodiscard]] UncertifiedNet compute_net(const Surface& surface, const Length& epsilon, const NetOptions& options = {});

/// Computes an ε-net of the surface and proves it: every point of the surface is within hyperbolic distance ε of a
/// vertex, and different vertices are at least ε apart. For a pseudo net see docs/proof.md, section 10.
///
/// Never returns a net whose certificate does not say VERIFIED: throws NetError, or LimitError, instead. Deterministic.
/// About 0.54 · 16(g − 1)/ε² vertices on a surface of genus g without short curves (thesis Theorem III.1, IV.6.2); time
/// and memory are proportional.
[[nodiscard]] CertifiedNet certified_net(const Surface& surface, const Length& epsilon, const NetOptions& options = {});

/// The same with ε the shortest decimal that reads back as `epsilon`.
[[nodiscard]] CertifiedNet certified_net(const Surface& surface, double epsilon, const NetOptions& options = {});

}  // namespace epsnet
