#pragma once

#include <complex>
#include <cstdint>
#include <iosfwd>
#include <vector>

#include "certify/base/interval.h"
#include "netgen/surfaces/characters.h"
#include "triangulation/surface/surface.h"

/// Hyperbolic lattices: the graph of the tiles of a surface, with phases, as a Hermitian matrix, and its eigenvalues.
namespace epsnet {

/// A Hermitian matrix, sparse.
struct HermitianMatrix {
  /// On and below the diagonal: column ≤ row.
  struct Entry {
    std::uint32_t row;
    std::uint32_t column;
    std::complex<double> value;
  };
  std::uint32_t size = 0;
  std::vector<Entry> entries{};  ///< By column, then by row; each place once.
  double error = 0;  ///< The matrix that is meant differs from this one by one with no eigenvalue of greater modulus.
};

/// Returns the matrix H with (Hf)(v) = Σ f(w) over the neighbours w of v, for functions at the nodes with
/// f(γz) = χ(γ) f(z), χ the character of 2g numbers of turns (character_sides); the adjacency matrix if `turns` is
/// empty. Parts of entries are rounded to binary64, those of multiples of ¼ turn are exact. Throws CharacterError.
/// O(sides log sides).
[[nodiscard]] HermitianMatrix lattice_matrix(const Surface& surface, GraphNodes nodes,
                                             const std::vector<Rational>& turns = {});

/// A lattice of more nodes has its matrix only.
inline constexpr std::uint32_t kMostLatticeNodes = 1500;

/// Returns for all eigenvalues, in increasing order, with multiplicity, an interval that contains it. They are computed
/// by Eigen, and proved by what the product of the matrix with the computed eigenvectors is, and by how far these are
/// from orthonormal (docs/eigenvalues.md). Ends are multiples of a power of 2, at most 2⁻²⁰. Throws LimitError for more
/// than kMostLatticeNodes, and if no proof is found. O(n³).
[[nodiscard]] std::vector<certify::Interval> eigenvalues(const HermitianMatrix& matrix);

/// Writes a MatrixMarket file: coordinate complex hermitian; integer symmetric if all entries are integers.
void write_matrix_market(const HermitianMatrix& matrix, std::ostream& out);

}  // namespace epsnet
