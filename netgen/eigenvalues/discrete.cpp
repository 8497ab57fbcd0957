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

/// As Eigen's orderings: by place, what is eliminated there. Nested dissection by METIS, which takes a third or less of
/// the operations that minimum degree takes.
class Ordering {
 public:
  using PermutationType = Permutation;

  void operator()(const Matrix& symmetric, Permutation& order) const {
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
  }
  template <class View>
  void operator()(const View& view, Permutation& order) const {
    (*this)(Matrix(view), order);
  }
};

using Factors = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Ordering>;

/// x ↦ (A − σM)⁻¹ x
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
  [[nodiscard]] Eigen::Index count_below(double sigma) const { return epsnet::count_below(matrices_, sigma, 1); }
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
  Permutation order;
  Ordering()(lower_half.selfadjointView<Eigen::Lower>(), order);
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

std::uint32_t count_below(const ElementMatrices& matrices, double sigma, unsigned threads) {
  return inertia(matrices, elimination_order(matrices.energy), sigma, certify::Bound::upper, threads).negative;
}

DiscreteSpectrum first_eigenvalues(const ElementMatrices& matrices, std::uint32_t count) {
  constexpr double kShift = -0.1;
  constexpr double kTolerance = 1e-8;
  constexpr double kGap = 1e-5;
  constexpr int kMostRestarts = 300;
  const Eigen::Index size = matrices.energy.rows();
  Inverse inverse(matrices);
  Mass mass(matrices.mass);
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
    if (gap < found && inverse.count_below((values[gap - 1] + values[gap]) / 2) == gap) {
      DiscreteSpectrum result;
      result.values.assign(values.data(), values.data() + enough);
      result.vectors = solver.eigenvectors().leftCols(enough);
      return result;
    }
    if (wanted == size - 2 || more > 4 * enough + 64)
      throw NetError("Lanczos's method finds too few eigenvalues of a net");
  }
}

}  // namespace epsnet
