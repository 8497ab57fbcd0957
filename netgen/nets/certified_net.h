#pragma once

#include "certify/document/document.h"
#include "certify/document/report.h"
#include "netgen/base/length.h"
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

/// A dart of a triangulation as net files number it.
[[nodiscard]] constexpr std::uint32_t document_dart(Dart d) { return 3 * triangle_of(d) + corner_of(d); }

/// A triangulation as the plain data of a net file. Charts and labels that nothing uses are left out. O(size).
[[nodiscard]] certify::NetDocument net_document(const Triangulation& triangulation, const Length& epsilon);

/// Computes an ε-net of the surface by Delaunay refinement (thesis Algorithm IV.4.1), as a triangulation that refers to
/// the surface.
///
/// The vertices of the surface's tiles are the start; of those closer than ε to each other some are removed, and so are
/// those near closed geodesics no longer than ε if a pseudo net is asked for. Deterministic.
/// Throws NetError, std::bad_alloc; std::invalid_argument for a pseudo net with ε > ln √2.
[[nodiscard]] Triangulation net_triangulation(const Surface& surface, const Length& epsilon, const NetOptions& options,
                                              NetStatistics& statistics);

/// The same as a document, without its certificate.
[[nodiscard]] UncertifiedNet compute_net(const Surface& surface, const Length& epsilon, const NetOptions& options = {});

/// Computes an ε-net of the surface and proves it: every point of the surface is within hyperbolic distance ε of a
/// vertex, and different vertices are at least ε apart. For a pseudo net see docs/proof.md, section 10.
///
/// Never returns a net whose certificate does not say VERIFIED: throws NetError instead. Deterministic.
/// About 0.54 · 16(g − 1)/ε² vertices on a surface of genus g without short curves (thesis Theorem III.1, IV.6.2); time
/// and memory are proportional.
[[nodiscard]] CertifiedNet certified_net(const Surface& surface, const Length& epsilon, const NetOptions& options = {});

/// The same with ε the shortest decimal that reads back as `epsilon`.
[[nodiscard]] CertifiedNet certified_net(const Surface& surface, double epsilon, const NetOptions& options = {});

}  // namespace epsnet
