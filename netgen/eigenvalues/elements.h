#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/numbers/inertia.h"
#include "netgen/eigenvalues/elements.h"
#include "netgen/lifts/lifts.h"

/// Finite elements on the flat triangles with the corners of a net's triangles, which are halved: the matrices of
/// docs/proof.md, section 17.1, rounded, and their eigenvalues.
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

// Eigenvalues of large sparse matrices, rounded.

/// An order of elimination with little fill, for a matrix of which the lower half is given: nested dissection.
[[nodiscard]] std::vector<std::uint32_t> elimination_order(const Eigen::SparseMatrix<double>& lower_half);

/// The inertia of energy − σ mass, by this order of elimination: a bound for how many eigenvalues of energy·x = μ
/// mass·x, 0 included, are less than σ, and whether `certify` can prove it by this order. If a number is wanted, more
/// is done to prove that it is at most, or at least, so many.
[[nodiscard]] certify::Inertia inertia(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order,
                                       double sigma, certify::Bound bound, unsigned threads,
                                       std::optional<std::uint64_t> wanted = std::nullopt);

/// Eigenvalues in increasing order, and the vectors as columns.
struct DiscreteSpectrum {
  std::vector<double> values;
  Eigen::MatrixXd vectors;
};

/// The first `count` of them, 0 included, or all if there are fewer, by Lanczos's method with a shift below 0, with
/// this order of elimination. Throws NetError if it does not converge.
[[nodiscard]] DiscreteSpectrum first_eigenvalues(const ElementMatrices& matrices,
                                                 const std::vector<std::uint32_t>& order, std::uint32_t count);

}  // namespace epsnet
