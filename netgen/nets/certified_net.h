#pragma once

#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "netgen/base/length.h"
#include "netgen/nets/net_options.h"
#include "triangulation/surface/surface.h"

namespace epsnet {

/// An ε-net whose certificate says VERIFIED.
struct CertifiedNet {
  certify::NetDocument net;
  certify::Certificate certificate;
  NetStatistics statistics;
};

/// A net that is not proved yet; certify::check can prove its document.
struct UncertifiedNet {
  certify::NetDocument net;
  NetStatistics statistics;
};

/// Computes an ε-net of the surface by Delaunay refinement (thesis Algorithm IV.4.1). There is no certificate.
///
/// The start consists of the vertices of the surface's tiles. Some vertices closer than ε to each other are removed.
/// For a pseudo net, vertices near closed geodesics no longer than ε are removed too. Deterministic. Throws NetError,
/// LimitError, std::bad_alloc. Throws std::invalid_argument for a pseudo net with ε > ln √2 or with `sparse`.
[[nodiscard]] UncertifiedNet compute_net(const Surface& surface, const Length& epsilon, const NetOptions& options = {});

/// Computes an ε-net of the surface and proves it: every point of the surface is within hyperbolic distance ε of a
/// vertex, and different vertices are at least ε apart. For a pseudo net see docs/proof.md, section 10.
///
/// Returns only a net whose certificate says VERIFIED. Otherwise throws NetError or LimitError. Deterministic. About
/// 0.54 · 16(g − 1)/ε² vertices on a surface of genus g without short curves (thesis Theorem III.1, IV.6.2); time and
/// memory are proportional.
[[nodiscard]] CertifiedNet certified_net(const Surface& surface, const Length& epsilon, const NetOptions& options = {});

/// Like the overload above; ε is the shortest decimal that reads back as `epsilon`.
[[nodiscard]] CertifiedNet certified_net(const Surface& surface, double epsilon, const NetOptions& options = {});

}  // namespace epsnet
