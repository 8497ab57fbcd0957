#pragma once

#include <cstdint>

#include "certify/document/cover_document.h"
#include "netgen/base/progress.h"
#include "triangulation/base_point.h"
#include "triangulation/surface.h"

/// The diameter of a surface, its radius, and its largest embedded disk. docs/distances.md says how.
///
/// What these functions return is not proved yet; certify::check_cover proves it. All are deterministic and throw
/// NetError where the limit of cells does not suffice, LimitError where the surface is beyond the numbers of the
/// generator; both are an Error.
namespace epsnet {

/// The least width that may be asked for.
inline constexpr double kLeastCoverWidth = 1e-12;

/// How the maximum of a function over a surface is enclosed.
struct CoverOptions {
  double width = 1e-6;                 ///< Of the enclosure; at least kLeastCoverWidth.
  std::uint64_t most_cells = 200'000;  ///< More are not made.
  Progress progress = {};              ///< Called now and then, if given.
};

/// The Delaunay triangulation with one vertex as a net with an ε above its largest circumradius, which is the
/// eccentricity of the vertex: the greatest distance of a point from it (docs/proof.md, Lemma 5.2). The vertex is
/// strictly inside of its tile, or else SurfaceError.
[[nodiscard]] certify::NetDocument eccentricity_net(const Surface& surface, const BasePoint& vertex);

/// The diameter: the greatest distance of two points. Branch and bound over the places of one of them
/// (docs/distances.md says how many cells that takes). Throws std::invalid_argument for a width that is less than the
/// least.
[[nodiscard]] certify::CoverDocument diameter(const Surface& surface, const CoverOptions& options = {});

/// The radius: the least eccentricity, the least r such that a disk of radius r covers the surface.
[[nodiscard]] certify::CoverDocument radius(const Surface& surface, const CoverOptions& options = {});

/// The radius of the largest embedded disk: the greatest injectivity radius of a point.
[[nodiscard]] certify::CoverDocument largest_embedded_disk(const Surface& surface, const CoverOptions& options = {});

}  // namespace epsnet
