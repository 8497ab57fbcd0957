#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "certify/numbers/budget.h"

/// How many negative eigenvalues a large sparse symmetric matrix has (docs/proof.md, Lemmas 36 and 36.1).
namespace epsnet::certify {

/// An entry of a matrix, known up to an error. On and below the diagonal: column ≤ row.
struct MatrixEntry {
  std::uint32_t row;
  std::uint32_t column;
  double value;
  double error;  ///< The entry is at most that far from the value.
};

/// A bound for the number of negative eigenvalues of a matrix.
enum class Bound { upper, lower };

/// What a factorization proves.
struct Inertia {
  std::uint32_t negative = 0;
  bool proved = false;  ///< Whether rounding errors are smaller than what was set aside for them.
};

/// A symmetric matrix of which rows and columns are in the order in which they are eliminated.
class SparseMatrix {
 public:
  /// Entries of the same place are added. O(number of entries). Requires: rows and columns are less than `size` < 2³⁰.
  SparseMatrix(std::uint32_t size, std::vector<MatrixEntry> entries);

  /// A number that is at least, or at most, that of the negative eigenvalues. Factors the matrix in binary64, without
  /// pivoting, by the multifrontal method. The same for any number of threads. If this number is not what is wanted, at
  /// most so many or at least so many, less is set aside for rounding errors, and the matrix is factored again.
  ///
  /// Work and memory are taken off the budget before they are used; BudgetSpent. Requires: rounding to nearest.
  [[nodiscard]] Inertia negative_eigenvalues(Bound bound, const Budget& budget, unsigned threads,
                                             std::optional<std::uint64_t> wanted = std::nullopt) const;

 private:
  std::uint32_t size_;
  std::vector<MatrixEntry> entries_;  ///< By column, then by row; each place once; every place of the diagonal.
};

}  // namespace epsnet::certify
