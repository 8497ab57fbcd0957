#pragma once

#include "netgen/surfaces/group.h"

namespace epsnet {

/// surface_of_matrices for matrices in the ring of a triangle group: `matrices.tile` is there. Throws likewise.
[[nodiscard]] MatrixSurface surface_of_field_matrices(const MatrixGenerators& matrices);

}  // namespace epsnet
