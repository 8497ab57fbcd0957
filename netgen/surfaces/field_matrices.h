#pragma once

#include <array>

#include "kernel/isometry.h"
#include "netgen/surfaces/group.h"

namespace epsnet {

/// The isometry of the disk of a matrix with these numbers, as its text has them, up to scale. w = (z − i)/(z + i)
/// takes the half-plane to the disk.
template <class T>
[[nodiscard]] Isometry<T> isometry_of_entries(const std::array<T, 4>& e, MatrixModel model) {
  if (model == MatrixModel::su11) return {{e[0], e[1]}, {e[2], e[3]}};
  return {{T(e[0] + e[3]), T(e[1] - e[2])}, {T(e[0] - e[3]), T(-e[1] - e[2])}};
}

/// surface_of_matrices for matrices in the ring of a triangle group: `matrices.tile` is there. Throws likewise.
[[nodiscard]] MatrixSurface surface_of_field_matrices(const MatrixGenerators& matrices);

}  // namespace epsnet
