#pragma once

#include "certify/document/document.h"
#include "netgen/base/length.h"
#include "triangulation/error.h"
#include "triangulation/surface.h"

namespace epsnet {

/// The tiles of a surface cannot be the triangles of a net; what() says why.
class ImportedNetError : public Error {
 public:
  using Error::Error;
};

/// The tiles of a surface as the triangles of a net: exactly this triangulation, with nothing moved, added or flipped.
/// Whether it is an ε-net is for certify::check to say.
///
/// Triangle t is tile t, its dart i side i of the tile; vertices are the surface's vertex classes, in their order. Each
/// is the origin of a chart of its own, whose exact centre is the corner of a tile, so that nothing is rounded.
/// Throws ImportedNetError unless all tiles are triangles, and if words grow beyond what a net file may hold
/// (docs/format.md): about the sum of the squares of all degrees. Time and memory are proportional to that.
[[nodiscard]] certify::NetDocument net_of_tiles(const Surface& surface, const Length& epsilon);

}  // namespace epsnet
