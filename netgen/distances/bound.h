#pragma once

#include <cstdint>

#include "certify/claims/bound/document.h"
#include "netgen/base/progress.h"
#include "triangulation/surface/surface.h"

/// The diameter of a surface, its radius, and its largest embedded disk. docs/distances.md says how.
///
/// The results are not proved yet; certify::check proves them. All functions are deterministic. They throw
/// NetError if the limit of cells is too low, and LimitError if the surface is beyond the numbers of the generator;
/// both are an Error.
namespace epsnet {

/// The least allowed width.
inline constexpr double kLeastBoundWidth = 1e-12;

/// Options of an enclosure of a function's extremum over a surface.
struct BoundOptions {
  double width = 1e-6;                 ///< The largest width of the enclosure; at least kLeastBoundWidth.
  std::uint64_t most_cells = 200'000;  ///< The most cells made.
  Progress progress = {};              ///< Called occasionally, if given.
};

/// Returns the one-vertex Delaunay triangulation as a net; its ε is larger than its largest circumradius. The largest
/// circumradius is the eccentricity of the vertex: the greatest distance of a point from it (docs/proof.md, Lemma 5.2).
/// The vertex may be anywhere in the disk of its tile. Throws SurfaceError if it is no point of the surface.
[[nodiscard]] certify::NetDocument eccentricity_net(const Surface& surface, const BasePoint& vertex);

/// Encloses the diameter: the greatest distance of two points. Branch and bound over the positions of one of them
/// (docs/distances.md gives the number of cells). Throws std::invalid_argument for a width below kLeastBoundWidth.
[[nodiscard]] certify::BoundDocument diameter(const Surface& surface, const BoundOptions& options = {});

/// Encloses the radius: the least eccentricity, which is the least r such that a disk of radius r covers the surface.
/// Throws std::invalid_argument for a width below kLeastBoundWidth.
[[nodiscard]] certify::BoundDocument radius(const Surface& surface, const BoundOptions& options = {});

/// Encloses the radius of the largest embedded disk: the greatest injectivity radius of a point. Throws
/// std::invalid_argument for a width below kLeastBoundWidth.
[[nodiscard]] certify::BoundDocument largest_embedded_disk(const Surface& surface, const BoundOptions& options = {});

}  // namespace epsnet
