#pragma once

#include "triangulation/surface/error.h"

/// How the triangles of a net are laid out in the Poincaré disk.
namespace epsnet {

/// The document is not a net, or its numbers are too large for pictures and summaries. what() is one line.
class NetGeometryError : public Error {
 public:
  using Error::Error;
};

/// The order in which triangles are lifted (thesis IV.5).
enum class DrawOrder {
  weight,  ///< Next the triangle across the edge uv of least |u|² + |v|²: looks like the Dirichlet domain (figure
           ///< IV.9).
  breadth_first,  ///< By the number of edges crossed: the combinatorial Dirichlet domain (figure IV.10, bottom).
};

}  // namespace epsnet
