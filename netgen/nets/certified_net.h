#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/net/document.h"
#include "certify/verdict/report.h"
#include "netgen/base/options.h"
#include "netgen/prove/certified.h"
#include "triangulation/surface/surface.h"

/// ε-nets: how they are computed and proved, their options, and what is counted meanwhile.
namespace epsnet {

/// Which net is computed, and how.
struct NetOptions {
  /// If set, the start is this point alone. Otherwise it consists of the vertices of the tiles that are not too close
  /// to others.
  std::optional<BasePoint> base = {};
  /// Points that become vertices, exactly where they are. The start consists of the base, if there is one, and these
  /// points alone. Requires: each is strictly inside its tile (SurfaceError), and any two are farther than ε from each
  /// other (ClosePointsError). Cannot be combined with `pseudo`, which removes vertices from collars.
  std::vector<BasePoint> points = {};
  /// A pseudo ε-net (thesis Definition III.7): points of the ε-thick part that cover it; ε at most ln √2.
  bool pseudo = false;
  /// A net with few points: 1.4 to 1.5 times the lower bound of Theorem III.2 (thick surfaces, ε at most 0.1) instead
  /// of the 2.15 times of the refinement alone, at about eight times the cost. If it has more than 1.5 times the bound,
  /// the ordinary net is taken if that has no more points. Cannot be combined with `pseudo`.
  bool sparse = false;
  /// Threads with which the net is made, if it has 100,000 vertices or more; 0: as many as the machine has cores. The
  /// net is the same for any number.
  unsigned threads = 0;
  certify::CheckOptions check = {};  ///< For the certificate: threads, precision cap, progress.
  Progress progress = {};            ///< While the net grows: "net: N vertices".
};

/// Whether ε ≤ ln √2, decided exactly: the limit for pseudo ε-nets (thesis Lemma III.9).
[[nodiscard]] bool allows_pseudo_nets(const Length& epsilon);

/// What was counted while a net was made.
struct NetStatistics {
  std::uint64_t insertions = 0;
  std::uint64_t removed = 0;         ///< Input vertices removed: closer than ε to others, or not the base.
  std::uint64_t multiprecision = 0;  ///< Predicates that binary64 could not decide.
  std::uint64_t collars = 0;         ///< Of a pseudo net.
  std::uint64_t undone = 0;          ///< Insertions taken back because they led to a collar.
  std::uint64_t charts = 0;
  std::uint64_t labels = 0;
  double start_seconds = 0;   ///< Initial Delaunay triangulation.
  double refine_seconds = 0;  ///< Refinement.
};

/// Two given points are not farther than ε from each other.
class ClosePointsError : public NetError {
 public:
  /// By their vertices, `first` < `second`: the base, if there is one, then the points in their order.
  ClosePointsError(std::uint32_t first, std::uint32_t second)
      : NetError("points " + std::to_string(first) + " and " + std::to_string(second) +
                 " are not farther than epsilon from each other"),
        first_(first),
        second_(second) {}
  /// The vertex of the first one.
  [[nodiscard]] std::uint32_t first() const { return first_; }
  /// The vertex of the second one.
  [[nodiscard]] std::uint32_t second() const { return second_; }

 private:
  std::uint32_t first_;
  std::uint32_t second_;
};

/// An ε-net with its proof.
struct CertifiedNet : Certified<certify::NetDocument> {
  NetStatistics statistics;
};

/// A net that is not proved yet; certify::check can prove its document.
struct UncertifiedNet {
  certify::NetDocument document;
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
