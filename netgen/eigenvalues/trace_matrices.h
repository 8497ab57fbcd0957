#pragma once

#include <cstdint>
#include <vector>

#include "certify/claims/geodesics/document.h"
#include "kernel/numbers.h"
#include "triangulation/surface/surface.h"

/// What the trace formula says of the eigenvalues of a surface, as matrices; docs/eigenvalues.md says how they are
/// used.
namespace epsnet {

/// The numbers of the search. The matrices have eigenvalues as small as 10⁻²⁵ times the largest one.
using Real = Mp256;
using RealVector = std::vector<Real>;
using RealMatrix = std::vector<RealVector>;

/// Even functions of r, λ = ¼ + r²: f̂(λ) = sinc(δr/2)^{n/2} Σ c_k cos(kδr), k = 0, …, K, where δ = L/(2K + n/2).
struct TestSpace {
  Real support;          ///< L
  std::uint32_t order;   ///< n
  std::uint32_t degree;  ///< K

  [[nodiscard]] Real step() const { return support / (2 * degree + order / 2); }
  /// f̂(λ) is the scalar product of the coefficients and this vector.
  [[nodiscard]] RealVector values(const Real& lambda) const;
};

/// The lengths of the geodesics of a list, from their words. Rounded.
[[nodiscard]] RealVector lengths_of(const Surface& surface, const certify::GeodesicsDocument& spectrum);

/// By p = 0, 1, 2 the matrix of the quadratic form Σ λ^p f̂(λ)² of c, over the eigenvalues λ ≠ 0. `lengths` are those of
/// the primitive closed geodesics of length at most L, up to orientation. Rounded.
[[nodiscard]] std::vector<RealMatrix> trace_matrices(const TestSpace& space, std::uint32_t genus,
                                                     const RealVector& lengths);

}  // namespace epsnet
