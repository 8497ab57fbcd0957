#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "certify/claims/eigenvalues/document.h"

namespace epsnet {

/// An eigenfunction of a file, to be drawn. All numbers are rounded.
class EigenfunctionValues {
 public:
  /// Function `function` of row `row` of `document.eigenfunctions`; the document must outlive it. Throws
  /// std::out_of_range if there is none.
  EigenfunctionValues(const certify::EigenvaluesDocument& document, std::size_t row, std::size_t function);

  /// The value at a point of the disk with the net's vertex in its centre: the disk of the vertex's chart, moved by z ↦
  /// (z − v)/(1 − v̄z). Good within the row's `radius` of the vertex. O(number of coefficients of the vertex).
  [[nodiscard]] double at(std::size_t vertex, std::complex<double> z) const;

 private:
  double lambda_;
  const std::vector<double>& coefficients_;
  std::size_t each_;  ///< Coefficients of each vertex.
};

}  // namespace epsnet
