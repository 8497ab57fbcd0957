#include "netgen/eigenvalues/discrete.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Spectra/SymGEigsShiftSolver.h>
#include <algorithm>
#include <new>
#ifndef __EMSCRIPTEN__
#include <metis.h>
#endif

#include "certify/numbers/parallel.h"
#include "netgen/nets/certified_net.h"

namespace epsnet {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

using Factors = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>>;

/// By place, what is eliminated there. Nested dissection by METIS, which takes a third or less of the operations that
/// minimum degree takes.
Permutation ordering(const Matrix& symmetric) {
  Permutation order;
#ifdef __EMSCRIPTEN__
  Eigen::AMDOrdering<int>()(symmetric, order);
#else
  auto size = static_cast<idx_t>(symmetric.rows());
  std::vector<idx_t> first{0};
  std::vector<idx_t> neighbours;
  for (Eigen::Index column = 0; column < size; ++column) {
    for (Matrix::InnerIterator entry(symmetric, column); entry; ++entry) {
      if (entry.row() != column) neighbours.push_back(static_cast<idx_t>(entry.row()));
    }
    first.push_back(static_cast<idx_t>(neighbours.size()));
  }
  std::vector<idx_t> by_place(static_cast<std::size_t>(size));
  std::vector<idx_t> places(by_place.size());
  if (METIS_NodeND(&size, first.data(), neighbours.data(), nullptr, nullptr, by_place.data(), places.data()) !=
      METIS_OK) {
    throw std::bad_alloc();
  }
  order.resize(size);
  std::copy(by_place.begin(), by_place.end(), order.indices().data());
#endif
  return order;
}

/// By number its place in an order.
Permutation places_of(const std::vector<std::uint32_t>& order) {
  Permutation result(static_cast<Eigen::Index>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) result.indices()[order[i]] = static_cast<int>(i);
  return result;
}

/// With rows and columns in another order.
Matrix ordered(const Matrix& lower_half, const Permutation& places) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(lower_half.nonZeros()));
  for (Eigen::Index column = 0; column < lower_half.cols(); ++column) {
    for (Matrix::InnerIterator entry(lower_half, column); entry; ++entry) {
      const auto [first, second] = std::minmax(places.indices()[entry.row()], places.indices()[column]);
      entries.emplace_back(second, first, entry.value());
    }
  }
  Matrix result(lower_half.rows(), lower_half.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// x ↦ (A − σM)⁻¹ x, by elimination in the order of the rows.
class Inverse {
 public:
  using Scalar = double;
  explicit Inverse(const ElementMatrices& matrices) : matrices_(matrices) {}
  [[nodiscard]] Eigen::Index rows() const { return matrices_.energy.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return matrices_.energy.cols(); }
  void set_shift(double sigma) {
    factors_.compute(Matrix(matrices_.energy - sigma * matrices_.mass));
    if (factors_.info() != Eigen::Success) throw NetError("a matrix of finite elements is singular");
  }
  void perform_op(const double* x, double* y) const {
    Eigen::Map<Eigen::VectorXd>(y, rows()) = factors_.solve(Eigen::Map<const Eigen::VectorXd>(x, rows()));
  }

 private:
  const ElementMatrices& matrices_;
  Factors factors_;
};

/// x ↦ M x
class Mass {
 public:
  using Scalar = double;
  explicit Mass(const Matrix& mass) : mass_(mass) {}
  [[nodiscard]] Eigen::Index rows() const { return mass_.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return mass_.cols(); }
  void perform_op(const double* x, double* y) const {
    Eigen::Map<Eigen::VectorXd>(y, rows()) =
        mass_.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(x, rows());
  }

 private:
  const Matrix& mass_;
};

}  // namespace

std::vector<std::uint32_t> elimination_order(const Matrix& lower_half) {
  const Permutation order = ordering(lower_half.selfadjointView<Eigen::Lower>());
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

certify::Inertia inertia(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order, double sigma,
                         certify::Bound bound, unsigned threads) {
  const Matrix shifted = matrices.energy - sigma * matrices.mass;
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<certify::MatrixEntry> entries;
  for (Eigen::Index column = 0; column < shifted.cols(); ++column) {
    for (Matrix::InnerIterator entry(shifted, column); entry; ++entry) {
      const auto [first, second] =
          std::minmax(place[static_cast<std::size_t>(entry.row())], place[static_cast<std::size_t>(column)]);
      entries.push_back({second, first, entry.value(), 0});
    }
  }
  const certify::SparseMatrix matrix(static_cast<std::uint32_t>(order.size()), std::move(entries));
  return matrix.negative_eigenvalues(bound, {}, certify::thread_count(threads));
}

DiscreteSpectrum first_eigenvalues(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order,
                                   std::uint32_t count) {
  constexpr double kShift = -0.1;
  constexpr double kTolerance = 1e-8;
  constexpr double kGap = 1e-5;
  constexpr int kMostRestarts = 300;
  const Permutation places = places_of(order);
  const ElementMatrices in_order{ordered(matrices.energy, places), ordered(matrices.mass, places)};
  const Eigen::Index size = matrices.energy.rows();
  Inverse inverse(in_order);
  Mass mass(in_order.mass);
  // Of eigenvalues that are near each other the method may miss one, mostly among the last; counting says so.
  for (Eigen::Index more = 8;; more *= 2) {
    const auto wanted = std::min<Eigen::Index>(count + more, size - 2);
    const auto kept = std::min<Eigen::Index>(2 * wanted + 20, size);
    Spectra::SymGEigsShiftSolver<Inverse, Mass, Spectra::GEigsMode::ShiftInvert> solver(inverse, mass, wanted, kept,
                                                                                        kShift);
    solver.init();
    const Eigen::Index found =
        solver.compute(Spectra::SortRule::LargestMagn, kMostRestarts, kTolerance, Spectra::SortRule::SmallestAlge);
    const Eigen::VectorXd values = solver.eigenvalues();
    const auto enough = static_cast<Eigen::Index>(count);
    // Counted where there is a gap: those that are equal, but for rounding, are not told apart by counting.
    Eigen::Index gap = enough;
    while (gap < found && values[gap] - values[gap - 1] <= kGap * values[gap]) ++gap;
    if (gap < found) {
      const double between = (values[gap - 1] + values[gap]) / 2;
      if (inertia(matrices, order, between, certify::Bound::upper, 1).negative == gap) {
        DiscreteSpectrum result;
        result.values.assign(values.data(), values.data() + enough);
        result.vectors = places.transpose() * solver.eigenvectors().leftCols(enough);
        return result;
      }
    }
    if (wanted == size - 2 || more > 4 * enough + 64)
      throw NetError("Lanczos's method finds too few eigenvalues of a net");
  }
}

}  // namespace epsnet
