#include "netgen/eigenvalues/discrete.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Spectra/SymGEigsShiftSolver.h>
#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <utility>
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

/// x ↦ (A − σM)⁻¹ x, by elimination in the order of the rows; 0 on eigenvectors that are known.
class Inverse {
 public:
  using Scalar = double;
  explicit Inverse(const ElementMatrices& matrices) : matrices_(matrices), known_(rows(), 0) {}
  [[nodiscard]] Eigen::Index rows() const { return matrices_.energy.rows(); }
  [[nodiscard]] Eigen::Index cols() const { return matrices_.energy.cols(); }
  void set_shift(double sigma) {
    if (sigma == sigma_) return;
    sigma_ = sigma;
    factors_.compute(Matrix(matrices_.energy - sigma * matrices_.mass));
    if (factors_.info() != Eigen::Success) throw NetError("a matrix of finite elements is singular");
  }
  void perform_op(const double* x, double* y) const {
    const Eigen::Map<const Eigen::VectorXd> from(x, rows());
    Eigen::Map<Eigen::VectorXd> to(y, rows());
    to = factors_.solve(from);
    if (known_.cols() > 0) to -= known_ * weights_.cwiseProduct(known_.transpose() * from);
  }
  /// Eigenvectors of these values, whose M-norm is 1.
  void set_known(const std::vector<double>& values, const Eigen::MatrixXd& vectors) {
    known_ = vectors;
    weights_ = (Eigen::Map<const Eigen::VectorXd>(values.data(), known_.cols()).array() - sigma_).inverse();
  }

 private:
  const ElementMatrices& matrices_;
  double sigma_ = HUGE_VAL;
  Factors factors_;
  Eigen::MatrixXd known_;
  Eigen::VectorXd weights_;
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

/// In increasing order.
DiscreteSpectrum merged(const DiscreteSpectrum& one, const DiscreteSpectrum& other) {
  DiscreteSpectrum all{one.values, Eigen::MatrixXd(other.vectors.rows(), one.vectors.cols() + other.vectors.cols())};
  all.values.insert(all.values.end(), other.values.begin(), other.values.end());
  all.vectors << one.vectors, other.vectors;
  std::vector<std::size_t> order(all.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return all.values[i] < all.values[j]; });
  DiscreteSpectrum result{{}, Eigen::MatrixXd(all.vectors.rows(), all.vectors.cols())};
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.values.push_back(all.values[order[i]]);
    result.vectors.col(static_cast<Eigen::Index>(i)) = all.vectors.col(static_cast<Eigen::Index>(order[i]));
  }
  return result;
}

/// By Lanczos's method, so many of the first eigenvalues of those that are not known.
DiscreteSpectrum more_eigenvalues(Inverse& inverse, Mass& mass, Eigen::Index wanted) {
  constexpr double kShift = -0.1;
  constexpr double kTolerance = 1e-8;
  constexpr int kMostRestarts = 300;
  Spectra::SymGEigsShiftSolver<Inverse, Mass, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, mass, wanted, std::min(2 * wanted + 20, mass.rows()), kShift);
  solver.init();
  const Eigen::Index found =
      solver.compute(Spectra::SortRule::LargestMagn, kMostRestarts, kTolerance, Spectra::SortRule::SmallestAlge);
  const Eigen::VectorXd values = solver.eigenvalues();
  DiscreteSpectrum result{{values.data(), values.data() + found}, solver.eigenvectors()};
  for (Eigen::Index k = 0; k < found; ++k) {
    Eigen::VectorXd image(mass.rows());
    mass.perform_op(result.vectors.col(k).data(), image.data());
    result.vectors.col(k) /= std::sqrt(result.vectors.col(k).dot(image));
  }
  return result;
}

}  // namespace

std::vector<std::uint32_t> elimination_order(const Matrix& lower_half) {
  const Permutation order = ordering(lower_half.selfadjointView<Eigen::Lower>());
  return {order.indices().data(), order.indices().data() + order.indices().size()};
}

certify::Inertia inertia(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order, double sigma,
                         certify::Bound bound, unsigned threads, std::optional<std::uint64_t> wanted) {
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
  return matrix.negative_eigenvalues(bound, {}, certify::thread_count(threads), wanted);
}

DiscreteSpectrum first_eigenvalues(const ElementMatrices& matrices, const std::vector<std::uint32_t>& order,
                                   std::uint32_t count) {
  constexpr double kGap = 1e-5;
  constexpr Eigen::Index kMore = 8;
  constexpr int kMostInVain = 3;
  const Permutation places = places_of(order);
  const ElementMatrices in_order{ordered(matrices.energy, places), ordered(matrices.mass, places)};
  const Eigen::Index size = matrices.energy.rows();
  Inverse inverse(in_order);
  Mass mass(in_order.mass);
  // Of several eigenvalues that are equal, or nearly, the method finds some; counting says whether there are others.
  DiscreteSpectrum known{{}, Eigen::MatrixXd(size, 0)};
  Eigen::Index missing = count;
  for (int in_vain = 0; in_vain < kMostInVain;) {
    const Eigen::Index wanted = std::min(missing + kMore, size - 2 - known.vectors.cols());
    if (wanted < 1) break;
    known = merged(known, more_eigenvalues(inverse, mass, wanted));
    inverse.set_known(known.values, known.vectors);
    // Counted where there is a gap: those that are equal, but for rounding, are not told apart by counting.
    std::size_t gap = count;
    while (gap < known.values.size() && known.values[gap] - known.values[gap - 1] <= kGap * known.values[gap]) ++gap;
    if (gap >= known.values.size()) continue;
    const double between = (known.values[gap - 1] + known.values[gap]) / 2;
    const std::uint32_t below = inertia(matrices, order, between, certify::Bound::upper, 1, gap).negative;
    if (below == gap) {
      const auto enough = static_cast<Eigen::Index>(count);
      return {{known.values.begin(), known.values.begin() + enough},
              places.transpose() * known.vectors.leftCols(enough)};
    }
    const Eigen::Index before = std::exchange(
        missing, std::max<Eigen::Index>(1, static_cast<Eigen::Index>(below) - static_cast<Eigen::Index>(gap)));
    if (missing >= before) ++in_vain;
  }
  throw NetError(
      "Lanczos's method finds too few eigenvalues of a net, as around a closed geodesic that is too short for numbers "
      "of "
      "binary64");
}

}  // namespace epsnet
