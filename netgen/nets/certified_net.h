#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "certify/check.h"
#include "certify/document/document.h"
#include "netgen/base/epsilon.h"
#include "triangulation/error.h"
#include "triangulation/surface.h"
#include "triangulation/triangulation.h"

namespace epsnet {

/// How a circumcentre enters the triangulation. Both give the same Delaunay triangulation for the same point, exact
/// ties aside.
enum class Insertion {
  cavity,  ///< Bowyer–Watson from the large triangle itself; the fast way.
  flips,   ///< The thesis' way (IV.4.3 to IV.4.5): walk, split, flip. Yields the statistics of the thesis.
};

/// How `Insertion::flips` finds the triangle that contains a circumcentre (thesis Chapter II, IV.4.3).
enum class Walk { visibility, straight };

/// Which triangles are listed to be looked at, and in which order (thesis IV.4.7; the variants of Table IV.2). Large:
/// the circumradius is more than ε. All give ε-nets, each other ones.
enum class TriangleList {
  large_back,     ///< Variant C: large triangles alone, first in, first out. The fastest here.
  all_back,       ///< Variant A, the thesis' choice: all new triangles, first in, first out; measured when taken.
  all_front,      ///< Variant B: all new triangles, last in, first out.
  largest_first,  ///< Variant D: large triangles alone, the largest first.
};

/// The progress of a computation: the vertices so far and the share done, 0 to 1.
using Progress = std::function<void(std::uint64_t vertices, double share)>;

struct NetOptions {
  /// The start is this point alone; without it, all vertices of the tiles that are not too close to others.
  std::optional<BasePoint> base = {};
  Insertion insertion = Insertion::cavity;
  Walk walk = Walk::visibility;
  TriangleList list = TriangleList::large_back;
  /// A pseudo ε-net (thesis Definition III.7): points of the ε-thick part that cover it; ε at most ln √2.
  bool pseudo = false;
  certify::CheckOptions check = {};  ///< For the certificate: threads, precision cap, progress.
  Progress progress = {};            ///< Called now and then while the net grows, if given.
};

/// What a run did, in the terms of the thesis (IV.6.2).
struct NetStatistics {
  std::uint64_t insertions = 0;
  std::uint64_t flips = 0;             ///< Of the insertions. A cavity of k triangles counts as k − 1 flips.
  std::uint64_t initial_flips = 0;     ///< To make the input's triangulation Delaunay.
  std::uint64_t removed = 0;           ///< Vertices of the input that were closer than ε to others, or not the base.
  std::uint64_t located = 0;           ///< Walks (`Insertion::flips` only).
  std::uint64_t located_at_start = 0;  ///< Circumcentres that lie in their own triangle.
  std::uint64_t walk_steps = 0;        ///< Triangles entered by all walks.
  std::uint64_t longest_walk = 0;
  std::uint64_t multiprecision = 0;  ///< Predicates that binary64 could not decide.
  std::uint64_t collars = 0;         ///< Of a pseudo net.
  std::uint64_t undone = 0;          ///< Insertions taken back because they led to a collar.
  std::uint64_t charts = 0;
  std::uint64_t labels = 0;
  double start_seconds = 0;   ///< Initial Delaunay triangulation.
  double refine_seconds = 0;  ///< Refinement.
};

/// No net was found that could be proved; what() says why. The surface and ε are valid.
class NetError : public Error {
 public:
  using Error::Error;
};

/// An ε-net whose certificate says VERIFIED.
struct CertifiedNet {
  certify::Document net;
  certify::Certificate certificate;
  NetStatistics statistics;
};

/// A net that is not proved yet: the document, to be handed to certify::check.
struct UncertifiedNet {
  certify::Document net;
  NetStatistics statistics;
};

/// A dart of a triangulation as net files number it.
[[nodiscard]] constexpr std::uint32_t document_dart(Dart d) { return 3 * triangle_of(d) + corner_of(d); }

/// A triangulation as the plain data of a net file. Charts and labels that nothing uses are left out. O(size).
[[nodiscard]] certify::Document net_document(const Triangulation& triangulation, const Epsilon& epsilon);

/// Computes an ε-net of the surface by Delaunay refinement (thesis Algorithm IV.4.1), as a triangulation that refers to
/// the surface.
///
/// The vertices of the surface's tiles are the start; of those closer than ε to each other some are removed, and so are
/// those near closed geodesics no longer than ε if a pseudo net is asked for. Deterministic.
/// Throws NetError, std::bad_alloc; std::invalid_argument for a pseudo net with ε > ln √2.
[[nodiscard]] Triangulation net_triangulation(const Surface& surface, const Epsilon& epsilon, const NetOptions& options,
                                              NetStatistics& statistics);

/// The same as a document, without its certificate.
[[nodiscard]] UncertifiedNet compute_net(const Surface& surface, const Epsilon& epsilon,
                                         const NetOptions& options = {});

/// Computes an ε-net of the surface and proves it: every point of the surface is within hyperbolic distance ε of a
/// vertex, and different vertices are at least ε apart. For a pseudo net see docs/proof.md, section 10.
///
/// Never returns a net whose certificate does not say VERIFIED: throws NetError instead. Deterministic.
/// About 0.54 · 16(g − 1)/ε² vertices on a surface of genus g without short curves (thesis Theorem III.1, IV.6.2); time
/// and memory are proportional.
[[nodiscard]] CertifiedNet certified_net(const Surface& surface, const Epsilon& epsilon,
                                         const NetOptions& options = {});

/// The same with ε the shortest decimal that reads back as `epsilon`.
[[nodiscard]] CertifiedNet certified_net(const Surface& surface, double epsilon, const NetOptions& options = {});

}  // namespace epsnet
