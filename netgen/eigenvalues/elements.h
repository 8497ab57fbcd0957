#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <cstdint>
#include <vector>

#include "netgen/lifts/lifts.h"

/// Finite elements on the flat triangles with the corners of a net's triangles, which are halved: the matrices of
/// docs/proof.md, section 17.1, rounded.
namespace epsnet {

/// The energy and the mass of functions as quadratic forms of their values.
struct ElementMatrices {
  Eigen::SparseMatrix<double> energy;  ///< The lower half.
  Eigen::SparseMatrix<double> mass;
};

/// The halved triangles, numbered as in docs/format.md.
class Elements {
 public:
  /// O(triangles · 4^halvings).
  Elements(const NetGeometry& geometry, std::uint32_t halvings);

  [[nodiscard]] std::uint32_t sides() const { return side_count_; }
  [[nodiscard]] std::uint32_t vertices() const { return vertex_count_; }

  /// For values in the midpoints of the sides, functions that need not be continuous: K and N, of which the eigenvalues
  /// μ are such that μ/(1 + Hμ) is at most the eigenvalue of the surface.
  [[nodiscard]] ElementMatrices lower() const;
  /// For values in the corners, continuous functions: the eigenvalues are at least those of the surface.
  [[nodiscard]] ElementMatrices upper() const;
  /// H.
  [[nodiscard]] double interpolation() const;

 private:
  using Numbers = std::vector<std::array<std::uint32_t, 3>>;

  template <class Local>
  [[nodiscard]] ElementMatrices assembled(const Numbers& numbers, std::uint32_t size, const Local& local) const;

  std::vector<std::array<double, 3>> squares_;  ///< By triangle: of the flat sides, the one opposite to corner i at i.
  Numbers opposite_sides_;                      ///< By triangle and corner.
  Numbers corners_;                             ///< By triangle: the vertices.
  std::uint32_t side_count_ = 0;
  std::uint32_t vertex_count_ = 0;
};

}  // namespace epsnet
